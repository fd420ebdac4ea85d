// SPDX-License-Identifier: BSD-3-Clause
// Files and pipes to their end, where they have one.
#include "io/lines.hpp"

#ifdef _WIN32
#include <fstream>
#else
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#endif

namespace fstiff::inline v0_1::io::detail {

#ifndef _WIN32
namespace {

/// An open file that is read without waiting for what may never come.
class OpenFile {
public:
    explicit OpenFile(const std::filesystem::path& path)
        : file_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {
        struct stat found {};
        is_pipe_ = file_ >= 0 && ::fstat(file_, &found) == 0 && S_ISFIFO(found.st_mode);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        if (file_ >= 0) ::close(file_);
    }
    [[nodiscard]] bool is_open() const { return file_ >= 0; }

    /// The next bytes; none at the end. \throws file_error where nothing writes what is waited for
    std::string_view read_some(std::vector<char>& chunk, const std::string& name) {
        for (bool waited = false;;) {
            const ssize_t count = ::read(file_, chunk.data(), chunk.size());
            if (count > 0 || (count == 0 && (!is_pipe_ || had_writer_)))
                return {chunk.data(), static_cast<std::size_t>(count)};
            if (count < 0 && errno == EINTR) continue;
            if (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK)
                throw file_error(name, "cannot be read to its end; must be a readable file");
            if (!is_pipe_) throw file_error(name, "has no end, as a device or a log of the system; must be a file");
            if (count == 0 && waited)
                throw file_error(name, "is a pipe that no program writes; must be a file, or a pipe that one writes");
            constexpr int patience = 2000;  // [ms] for a program that was started at the same time
            pollfd wait{file_, POLLIN, 0};
            had_writer_ = count < 0;  // a pipe that nobody writes is at its end
            waited = ::poll(&wait, 1, had_writer_ ? -1 : patience) == 0;
            had_writer_ = had_writer_ || !waited;
        }
    }

private:
    int file_;
    bool is_pipe_ = false, had_writer_ = false;
};

}  // namespace
#endif

bool append_file(const std::filesystem::path& path, const std::string& name, std::string& bytes, std::uint64_t enough) {
#ifdef _WIN32
    std::ifstream input(path, std::ios::binary);
    if (!input) return false;
    append_bytes(input, name, bytes, enough);
#else
    OpenFile input(path);
    if (!input.is_open()) return false;
    std::vector<char> chunk(std::size_t(1) << 16);
    while (true) {
        const std::string_view block = input.read_some(chunk, name);
        if (block.empty() || !takes_more(block, name, bytes, enough)) break;
    }
#endif
    return true;
}

}  // namespace fstiff::inline v0_1::io::detail
