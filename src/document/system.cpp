// SPDX-License-Identifier: BSD-3-Clause
#include "document/system.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <shellapi.h>

#include <fcntl.h>
#include <io.h>
#else
#include <unistd.h>
#endif

namespace fstiff::document::os {

#ifdef _WIN32

void remove_file(const wchar_t* name) { _wunlink(name); }
std::FILE* open_stream(const Path& path) { return _wfopen(path.c_str(), L"wb"); }
bool sync(std::FILE* stream) { return _commit(_fileno(stream)) == 0; }
bool is_writable(const Path& path) { return _waccess(path.c_str(), 2) == 0; }

bool is_terminal(std::FILE* stream) {
    DWORD mode = 0;  // _isatty takes NUL for one too
    return GetConsoleMode(reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(stream))), &mode) != 0;
}
std::span<const int> ending_signals() {
    static constexpr int signals[] = {SIGINT, SIGTERM, SIGBREAK};
    return signals;
}

std::vector<std::string> arguments(int, char**) {  // which have lost what is not in the code page
    int count = 0;
    wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
    std::vector<std::string> texts;
    for (int i = 1; i < count; ++i) {
        const std::u8string word = Path(words[i]).u8string();
        texts.emplace_back(word.begin(), word.end());
    }
    LocalFree(words);
    return texts;
}

document::os::Surroundings::Surroundings() : code_page_(GetConsoleOutputCP()) {
    for (std::FILE* stream : {stdin, stdout, stderr}) _setmode(_fileno(stream), _O_BINARY);
    SetConsoleOutputCP(CP_UTF8);
    DWORD mode = 0;
    const HANDLE errors = GetStdHandle(STD_ERROR_HANDLE);  // of the progress bar, which clears lines
    if (GetConsoleMode(errors, &mode)) SetConsoleMode(errors, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}
document::os::Surroundings::~Surroundings() {
    if (code_page_ != 0) SetConsoleOutputCP(code_page_);
}

#else

void remove_file(const char* name) { unlink(name); }
std::FILE* open_stream(const Path& path) { return std::fopen(path.c_str(), "wb"); }
bool sync(std::FILE* stream) { return fsync(fileno(stream)) == 0; }
bool is_writable(const Path& path) { return access(path.c_str(), W_OK) == 0; }

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) != 0; }
std::span<const int> ending_signals() {
    static constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
    return signals;
}

std::vector<std::string> arguments(int argc, char** argv) { return {argv + std::min(argc, 1), argv + argc}; }

document::os::Surroundings::Surroundings() { std::signal(SIGXFSZ, SIG_IGN); }
document::os::Surroundings::~Surroundings() = default;

#endif

}  // namespace fstiff::document::os
