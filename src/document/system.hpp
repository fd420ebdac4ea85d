// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Functions that POSIX and Windows have by different calls. Failures leave their reason in errno.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace fstiff::document::os {

using Path = std::filesystem::path;

enum class Opening {
    read,
    replace,  ///< for writing, empty
    extend    ///< for reading and writing, made where it is missing
};

/// \returns a descriptor, or -1.
[[nodiscard]] int open_file(const Path& path, Opening opening);
void close_file(int file);
/// \returns how many bytes were written, at least one; or -1.
[[nodiscard]] std::ptrdiff_t write_some(int file, const char* bytes, std::size_t size);
/// Where the next byte is read or written, or -1.
[[nodiscard]] std::int64_t position(int file);
[[nodiscard]] bool go_to(int file, std::uint64_t position);
[[nodiscard]] bool cut(int file, std::uint64_t size);
/// Waits until what was written outlasts a loss of power; so of a new name in \p folder, where the system can.
[[nodiscard]] bool sync_data(int file);
[[nodiscard]] bool sync_all(int file);
void sync_folder(const Path& folder);
/// Locks the file for this process until it is closed. \returns false with EWOULDBLOCK where another process has it.
[[nodiscard]] bool lock(int file);

/// To write bytes, or nullptr.
[[nodiscard]] std::FILE* open_stream(const Path& path);
[[nodiscard]] bool is_writable(const Path& path);
/// May be called by a handler of signals.
void remove_file(const Path::value_type* name);

[[nodiscard]] bool is_terminal(std::FILE* stream);
/// The signals by which a user or a system ends a program.
[[nodiscard]] std::span<const int> ending_signals();

/// Arguments of main() without the name of the program, in UTF-8.
[[nodiscard]] std::vector<std::string> arguments(int argc, char** argv);

/// Settings of the process of a command, while this lives: the same bytes in and out everywhere, terminals of UTF-8,
/// and a reason where a file grows beyond its limit: an error of writing, no signal.
class Surroundings {
public:
    Surroundings();
    Surroundings(const Surroundings&) = delete;
    Surroundings& operator=(const Surroundings&) = delete;
    ~Surroundings();

private:
    [[maybe_unused]] unsigned code_page_ = 0;  ///< of the terminal before, on Windows
};

}  // namespace fstiff::document::os
