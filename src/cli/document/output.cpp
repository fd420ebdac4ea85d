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
bool written(const std::string& text, std::FILE* stream) {
    errno = 0;
    return std::fwrite(text.data(), 1, text.size(), stream) == text.size() && std::fflush(stream) == 0;
}

void write_bytes(const fs::path& path, const std::string& text, const std::string& shown) {
    std::FILE* const stream = os::open_stream(path);
    if (!stream) cannot_write(shown, errno);
    int reason = written(text, stream) ? 0 : errno;
    if (std::fclose(stream) != 0 && reason == 0) reason = errno;
    if (reason != 0) cannot_write(shown, reason);
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

/// Files that are not complete yet: removed when this ends before keep(), by an exception or by Ctrl-C and the like.
class Partials {
public:
    explicit Partials(std::vector<fs::path> files) {
        partial_files = std::move(files);
        has_partials = 1;
        for (const int signal : os::ending_signals())  // what the caller ignores (nohup) stays ignored
            if (std::signal(signal, remove_partials_and_end) == SIG_IGN) std::signal(signal, SIG_IGN);
    }
    Partials(const Partials&) = delete;
    Partials& operator=(const Partials&) = delete;
    ~Partials() {
        if (has_partials)
            for (const fs::path& file : partial_files) os::remove_file(file.c_str());
        has_partials = 0;
    }
    void keep() { has_partials = 0; }
};

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

void refuse_standard_output(const std::string& output, std::string_view wanted) {
    if (output == "-") throw Usage("--output = \"-\": is standard output; must be " + std::string(wanted));
}

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

void deliver(const std::vector<OutputFile>& files) {
    std::error_code error;
    std::vector<fs::path> targets, partials;
    for (const OutputFile& file : files) {
        targets.push_back(document::output_target(file.name));
        const bool replaces = fs::exists(targets.back(), error);
        if (replaces && !fs::is_regular_file(targets.back(), error) && !fs::is_directory(targets.back(), error))
            partials.emplace_back();  // /dev/stdout, a pipe: written as it is
        else
            partials.emplace_back(targets.back()) += ".partial-" + std::to_string(std::random_device{}());
    }
    Partials until_renamed(partials);
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (fs::is_directory(targets[i], error))
            throw file_error(files[i].name, "is a folder; the output must be a file");
        write_bytes(partials[i].empty() ? targets[i] : partials[i], files[i].text, files[i].name);
        if (const auto old = fs::status(targets[i], error); !partials[i].empty() && fs::exists(old))
            fs::permissions(partials[i], old.permissions(), error);
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (partials[i].empty()) continue;
        fs::rename(partials[i], targets[i], error);
        if (error) cannot_write(files[i].name, error.default_error_condition().value());
    }
    until_renamed.keep();
}

}  // namespace fstiff::cli
