// SPDX-License-Identifier: BSD-3-Clause
#include "document/output.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/core/version.hpp>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <system_error>

namespace fstiff::cli {
namespace {

[[noreturn]] void cannot_write(const std::string& file) {
    throw file_error(file, "cannot be written; the folder must exist and be writable");
}

void write_bytes(const std::filesystem::path& path, const std::string& document, const std::string& shown) {
    std::ofstream stream(path, std::ios::binary);
    stream << document << std::flush;
    if (!stream) cannot_write(shown);
}

/// Name of the file that is being written, for the signal handler; empty: none.
std::array<char, 4096> partial_name{};
volatile std::sig_atomic_t is_partial = 0;

extern "C" void remove_partial_and_end(int signal) {
    if (is_partial) unlink(partial_name.data());
    std::signal(signal, SIG_DFL);
    raise(signal);
}

/// While it lives, Ctrl-C and the like remove \p path before they end the program.
class Interruptible {
public:
    explicit Interruptible(const std::filesystem::path& path) {
        const std::string& name = path.native();
        if (name.size() >= partial_name.size()) return;
        std::memcpy(partial_name.data(), name.c_str(), name.size() + 1);
        is_partial = 1;
        for (const int signal : signals)  // what the caller ignores (nohup) stays ignored
            if (std::signal(signal, remove_partial_and_end) == SIG_IGN) std::signal(signal, SIG_IGN);
    }
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;
    ~Interruptible() { is_partial = 0; }

private:
    static constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
};

}  // namespace

std::size_t shown_width(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

void add_format_option(Arguments& arguments, OutputOptions& options, Format initial) {
    options.format = initial;
    arguments.option("--format", options.format, "table, csv or json; default " + std::string(name_of(initial)))
        .type_name("FORMAT");
}

void add_output_options(Arguments& arguments, OutputOptions& options, Format initial) {
    add_format_option(arguments, options, initial);
    arguments.option("-o,--output", options.file, "write to FILE instead of standard output").type_name("FILE");
}

void say_written(Report& report, const std::vector<std::string>& files) {
    std::vector<std::string> lines;
    for (const std::string& file : files) lines.push_back("wrote " + file);
    report.diagnostics.insert(report.diagnostics.begin(), lines.begin(), lines.end());
}

std::string TextTable::str(std::string_view indent) const {
    std::vector<std::size_t> widths(rows_.front().size());
    for (const auto& row : rows_)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], shown_width(row[i]));
    std::string text;
    for (const auto& row : rows_) {
        text += indent;
        for (std::size_t i = 0; i < row.size(); ++i)
            text += std::string((i ? 2 : 0) + widths[i] - shown_width(row[i]), ' ') + row[i];
        text += '\n';
    }
    return text;
}

std::string csv_line(const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i ? "," : "") + cells[i];
    return text + '\n';
}

Json json_document(std::string_view command) {
    Json document;
    document["schema_version"] = 1;
    document["fstiff_version"] = FSTIFF_VERSION;
    document["command"] = command;
    return document;
}

void deliver(const std::string& document, const std::string& file) {
    namespace fs = std::filesystem;
    if (file.empty()) {
        std::cout << document << std::flush;
        if (!std::cout) throw domain_error("standard output cannot be written");
        return;
    }
    std::error_code error;
    fs::path target = fs::weakly_canonical(file, error);  // the file behind a symbolic link, which stays a link
    if (error) target = file;
    if (fs::is_directory(target, error)) throw file_error(file, "is a folder; the output must be a file");
    const bool exists = fs::exists(target, error);
    if (exists && !fs::is_regular_file(target, error))
        return write_bytes(target, document, file);  // /dev/stdout, a pipe

    fs::path partial = target;
    partial += ".partial-" + std::to_string(std::random_device{}());
    const Interruptible until_renamed(partial);
    try {
        write_bytes(partial, document, file);
        if (exists) fs::permissions(partial, fs::status(target).permissions());
        fs::rename(partial, target);
    } catch (...) {
        fs::remove(partial, error);
        cannot_write(file);
    }
}

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder, error)) throw file_error(folder, "is no folder and cannot be made one");
}

}  // namespace fstiff::cli
