// SPDX-License-Identifier: BSD-3-Clause
#include "output.hpp"

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

std::string number(double value, int digits) {
    if (!std::isfinite(value)) throw std::logic_error("a result is not a finite number; this is a defect of fstiff");
    return rounded_text(value, digits);
}

/// Number of characters of UTF-8 text: all bytes but the continuation bytes.
std::size_t width(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

[[noreturn]] void cannot_write(const std::string& file) {
    throw domain_error(file + ": cannot be written; the folder must exist and be writable");
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

/// False when the stream breaks or never ends.
bool read_stream(std::istream& stream, std::string& bytes) {
    constexpr std::size_t most = std::size_t(1) << 30;
    char chunk[65536];
    while (stream.read(chunk, sizeof chunk) || stream.gcount() > 0) {
        bytes.append(chunk, static_cast<std::size_t>(stream.gcount()));
        if (bytes.size() > most) throw domain_error("the input is longer than 1 GiB, which is the most that is read");
    }
    return !stream.bad();
}

}  // namespace

void add_format_option(Arguments& arguments, OutputOptions& options, Format initial) {
    options.format = initial;
    arguments.option("--format", options.format, "table, csv or json; default " + std::string(name_of(initial)))
        .type_name("FORMAT");
}

void add_output_options(Arguments& arguments, OutputOptions& options, Format initial) {
    add_format_option(arguments, options, initial);
    arguments.option("-o,--output", options.file, "write to FILE instead of standard output").type_name("FILE");
}

std::string exact(double value) { return number(value, 17); }
std::string rounded(double value, int digits) { return number(value, digits); }

std::string shortest(double value) { return shortest_text(value); }

Json json_number(double value) {
    exact(value);
    return value;
}

Json json_numbers(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double value : values) list.push_back(json_number(value));
    return list;
}

std::string list_of(std::span<const std::string_view> items) {
    std::string text;
    for (const auto item : items) text += (text.empty() ? "\"" : ", \"") + std::string(item) + "\"";
    return text;
}

std::string TextTable::str(std::string_view indent) const {
    std::vector<std::size_t> widths(rows_.front().size());
    for (const auto& row : rows_)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
    std::string text;
    for (const auto& row : rows_) {
        text += indent;
        for (std::size_t i = 0; i < row.size(); ++i)
            text += std::string((i ? 2 : 0) + widths[i] - width(row[i]), ' ') + row[i];
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
    if (fs::is_directory(target, error)) throw domain_error(file + ": is a folder; the output must be a file");
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
    if (!std::filesystem::is_directory(folder, error))
        throw domain_error(folder + ": is no folder and cannot be made one");
}

std::string read_all(const std::string& file) {
    std::string bytes;
    if (file == "-") {
        if (!read_stream(std::cin, bytes)) throw domain_error("standard input: cannot be read");
    } else {
        std::error_code error;
        if (!std::filesystem::exists(file, error))
            throw domain_error(file + ": no such file; the input must be an existing file");
        if (std::filesystem::is_directory(file, error))
            throw domain_error(file + ": is a folder; the input must be a file");
        std::ifstream stream(file, std::ios::binary);
        if (!stream || !read_stream(stream, bytes))
            throw domain_error(file + ": cannot be read; the input must be a readable file");
    }
    if (bytes.find_first_not_of(" \t\r\n") == std::string::npos)
        throw domain_error(display_name(file) + ": is empty; the input must hold text");
    return bytes;
}

std::string display_name(const std::string& file) { return file == "-" ? "standard input" : file; }

}  // namespace fstiff::cli
