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
#include <sys/stat.h>

#include <direct.h>
#include <climits>
#else
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

namespace fstiff::document::os {

using document::os::Opening, document::os::Path;

#ifdef _WIN32

namespace {
unsigned at_once(std::size_t size) { return static_cast<unsigned>((std::min)(size, std::size_t(INT_MAX))); }
}  // namespace

int open_file(const Path& path, Opening opening) {
    const int flags = opening == Opening::read      ? _O_RDONLY
                      : opening == Opening::replace ? _O_WRONLY | _O_CREAT | _O_TRUNC
                                                    : _O_RDWR | _O_CREAT;
    return _wopen(path.c_str(), flags | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
}
void close_file(int file) { _close(file); }
std::ptrdiff_t write_some(int file, const char* bytes, std::size_t size) { return _write(file, bytes, at_once(size)); }
std::int64_t position(int file) { return _lseeki64(file, 0, SEEK_CUR); }
bool go_to(int file, std::uint64_t position) {
    return _lseeki64(file, static_cast<std::int64_t>(position), SEEK_SET) >= 0;
}
bool cut(int file, std::uint64_t size) {
    const errno_t reason = _chsize_s(file, static_cast<std::int64_t>(size));
    if (reason != 0) errno = reason;
    return reason == 0;
}
bool sync_data(int file) { return sync_all(file); }
bool sync_all(int file) { return _commit(file) == 0; }
void sync_folder(const Path&) {}  // folders cannot be opened for it
bool lock(int file) {
    // Others may not even read what is locked: one byte, after all that a file can hold.
    OVERLAPPED place{};
    place.OffsetHigh = LONG_MAX;
    const auto handle = reinterpret_cast<HANDLE>(_get_osfhandle(file));
    if (LockFileEx(handle, LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &place)) return true;
    errno = GetLastError() == ERROR_LOCK_VIOLATION ? EWOULDBLOCK : EIO;
    return false;
}

void remove_file(const wchar_t* name) { _wunlink(name); }
std::FILE* open_stream(const Path& path) { return _wfopen(path.c_str(), L"wb"); }
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

namespace {
/// Calls again what a signal has interrupted.
template <class Call>
auto uninterrupted(const Call& call) {
    while (true)
        if (const auto result = call(); result >= 0 || errno != EINTR) return result;
}
}  // namespace

int open_file(const Path& path, Opening opening) {
    const int flags = opening == Opening::read      ? O_RDONLY
                      : opening == Opening::replace ? O_WRONLY | O_CREAT | O_TRUNC
                                                    : O_RDWR | O_CREAT;
    return open(path.c_str(), flags | O_CLOEXEC, 0666);
}
void close_file(int file) { close(file); }
std::ptrdiff_t write_some(int file, const char* bytes, std::size_t size) {
    return uninterrupted([&] { return write(file, bytes, size); });
}
std::int64_t position(int file) { return lseek(file, 0, SEEK_CUR); }
bool go_to(int file, std::uint64_t position) { return lseek(file, static_cast<off_t>(position), SEEK_SET) >= 0; }
bool cut(int file, std::uint64_t size) { return ftruncate(file, static_cast<off_t>(size)) == 0; }
bool sync_data(int file) {
#ifdef __APPLE__
    return fsync(file) == 0;
#else
    return fdatasync(file) == 0;
#endif
}
bool sync_all(int file) { return fsync(file) == 0; }
void sync_folder(const Path& folder) {
    const int descriptor = open_file(folder.empty() ? "." : folder, Opening::read);
    if (descriptor < 0) return;  // no more can be done
    fsync(descriptor);
    close(descriptor);
}
bool lock(int file) { return flock(file, LOCK_EX | LOCK_NB) == 0; }

void remove_file(const char* name) { unlink(name); }
std::FILE* open_stream(const Path& path) { return std::fopen(path.c_str(), "wb"); }
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
