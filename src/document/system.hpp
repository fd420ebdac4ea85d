// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Functions that POSIX and Windows have by different calls. Failures leave their reason in errno.

#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace fstiff::document::os {

using Path = std::filesystem::path;

/// To write bytes, or nullptr.
[[nodiscard]] std::FILE* open_stream(const Path& path);
/// Waits until what was written outlasts a loss of power.
[[nodiscard]] bool sync(std::FILE* stream);
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
