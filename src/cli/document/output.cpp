// SPDX-License-Identifier: BSD-3-Clause
#include "document/output.hpp"

#include "document/system.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/core/version.hpp>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <system_error>
#include <utility>

namespace fstiff::cli {
namespace {

namespace fs = std::filesystem;
namespace os = document::os;

[[noreturn]] void cannot_write(const std::string& file, int reason) {
    const char* wanted = reason == ENOENT || reason == ENOTDIR ? "; the folder must exist"
                         : reason == EACCES || reason == EROFS ? "; the file and its folder must be writable"
                                                               : "";
    throw file_error(file, "cannot be written: " + std::generic_category().message(reason) + wanted);
}

/// Whether \p text is in \p stream whole; if not, errno has the reason.
bool written(std::string_view text, std::FILE* stream) {
    errno = 0;
    return std::fwrite(text.data(), 1, text.size(), stream) == text.size() && std::fflush(stream) == 0;
}

/// Files that are being written, for the signal handler, which reads them while `has_partials` is 1.
std::vector<fs::path> partial_files;
volatile std::sig_atomic_t has_partials = 0;

extern "C" void remove_partials_and_end(int signal) {
    if (has_partials)
        for (const fs::path& file : partial_files) os::remove_file(file.c_str());
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// Files that are going to be written, and what may be read.
struct NamedFiles {
    std::vector<fs::path> outputs;
    std::vector<std::string> inputs;
};
NamedFiles& named_files() {
    static NamedFiles files;
    return files;
}

void require_apart(const fs::path& output, const std::string& input) {
    std::error_code none;
    const fs::path file = document::path_of(input == "-" ? "/dev/stdin" : input);
    if (fs::is_regular_file(output, none) &&
        fs::equivalent(fs::is_directory(file, none) ? output.parent_path() : output, file, none))
        throw file_error(document::name_of_path(output),
                         "is an input of this command and would be written over; give the output another name");
}

}  // namespace

document::Format OutputOptions::chosen() const {
    return for_people && target().empty() && os::is_terminal(stdout) ? document::Format::table : format;
}

std::string OutputOptions::target() const { return file == "-" ? std::string() : file; }

Report report(const document::Document& document, document::Format format) {
    Report report{
        .document = document.str(format), .diagnostics = {}, .status = document.doubtful ? doubtful_result : success};
    if (format == document::Format::table) return report;
    if (format == document::Format::csv) report.diagnostics = document.notes;
    for (const std::string& warning : document.warnings) report.diagnostics.push_back("warning: " + warning);
    return report;
}

void say_written(Report& report, const std::vector<std::string>& files) {
    std::vector<std::string> lines;
    for (const std::string& file : files) lines.push_back("wrote " + file);
    report.diagnostics.insert(report.diagnostics.begin(), lines.begin(), lines.end());
}

void name_inputs(std::vector<std::string> texts) {
    named_files().inputs = std::move(texts);
    named_files().inputs.emplace_back("-");
}

void keep_for_output(const std::string& file) {
    std::error_code error;
    const fs::path path = document::output_target(file);
    auto& [outputs, inputs] = named_files();
    for (const auto& other : outputs)
        if (path == other && (!fs::exists(path, error) || fs::is_regular_file(path, error)))
            throw file_error(file, "would be written twice; give every output a name of its own");
    for (const std::string& input : inputs) require_apart(path, input);
    outputs.push_back(path);
}

void require_no_output(const std::string& input) {
    for (const fs::path& output : named_files().outputs) require_apart(output, input);
}

void require_writable(const std::string& file) {
    std::error_code error;
    const fs::path target = document::output_target(file);
    if (fs::is_directory(target, error)) throw file_error(file, "is a folder; the output must be a file");
    if (!fs::is_directory(target.parent_path(), error)) cannot_write(file, ENOENT);
    if (fs::exists(target, error) && !os::is_writable(target)) cannot_write(file, errno);
}

void deliver(const std::string& document, const std::string& file) {
    if (!file.empty()) return deliver({{file, document}});
    std::cout << std::flush;
    if (!written(document, stdout) || !std::cout)
        throw domain_error("standard output cannot be written" +
                           (errno != 0 ? ": " + std::generic_category().message(errno) : std::string()));
}

struct OutputFiles::Open {
    std::string name;
    fs::path target, partial;  ///< partial is empty where the target is written as it is
    std::FILE* stream = nullptr;

    void close() {
        if (stream && std::fclose(std::exchange(stream, nullptr)) != 0) cannot_write(name, errno);
    }
};

OutputFiles::OutputFiles() = default;

OutputFiles::OutputFiles(const std::vector<std::string>& names) : OutputFiles() {  // so that what throws here is undone
    std::error_code error;
    for (const std::string& name : names) {
        Open& file = files_.emplace_back(Open{.name = name, .target = document::output_target(name), .partial = {}});
        if (fs::is_directory(file.target, error)) throw file_error(name, "is a folder; the output must be a file");
        if (!fs::exists(file.target, error) || fs::is_regular_file(file.target, error))
            (file.partial = file.target) += ".partial-" + std::to_string(std::random_device{}());
    }
    partial_files.clear();
    for (const Open& file : files_) partial_files.push_back(file.partial);
    has_partials = 1;
    for (const int signal : os::ending_signals())  // what the caller ignores (nohup) stays ignored
        if (std::signal(signal, remove_partials_and_end) == SIG_IGN) std::signal(signal, SIG_IGN);
    for (Open& file : files_) {
        file.stream = os::open_stream(file.partial.empty() ? file.target : file.partial);
        if (!file.stream) cannot_write(file.name, errno);
    }
}

OutputFiles::~OutputFiles() {
    for (Open& file : files_)
        if (file.stream) std::fclose(file.stream);
    if (has_partials)
        for (const fs::path& file : partial_files) os::remove_file(file.c_str());
    has_partials = 0;
}

void OutputFiles::write(std::size_t number, std::string_view text) {
    if (!written(text, files_[number].stream)) cannot_write(files_[number].name, errno);
}

void OutputFiles::finish() {
    std::error_code error;
    for (Open& file : files_) {
        if (!file.partial.empty() && !os::sync(file.stream)) cannot_write(file.name, errno);
        file.close();
        if (const auto old = fs::status(file.target, error); !file.partial.empty() && fs::exists(old))
            fs::permissions(file.partial, old.permissions(), error);
    }
    for (const Open& file : files_) {
        if (file.partial.empty()) continue;
        fs::rename(file.partial, file.target, error);
        if (error) cannot_write(file.name, error.default_error_condition().value());
    }
    has_partials = 0;
}

void deliver(const std::vector<OutputFile>& files) {
    std::vector<std::string> names;
    for (const OutputFile& file : files) names.push_back(file.name);
    OutputFiles outputs(names);
    for (std::size_t i = 0; i < files.size(); ++i) outputs.write(i, files[i].text);
    outputs.finish();
}

}  // namespace fstiff::cli
