// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/results_file.hpp"

#include "document/file.hpp"
#include "document/json.hpp"
#include "document/system.hpp"
#include "sweep/rows.hpp"

#include <fstiff/core/error.hpp>

#include <nlohmann/json.hpp>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace fstiff::sweep {
namespace {

namespace os = scene::os;

[[noreturn]] void fail(const std::string& file, const std::string& what) {
    throw file_error(file, what + ": " + std::generic_category().message(errno));
}

/// Looks at the lines of a file one after the other.
class Scanner {
public:
    Scanner(std::uint64_t first, bool finished) : finished_(finished), current_(first) { scan_.next = first; }

    /// \returns whether the line follows those before.
    bool take(std::string_view line) {
        const std::optional<std::uint64_t> index = index_of_line(line);
        if (!index) return false;
        if (any_ && *index == current_ + 1) {
            complete();
            failing_ = false;
        } else if (*index != current_) {
            return false;
        }
        any_ = true;
        failing_ = failing_ || line.find("\"error\":\"") != std::string_view::npos;
        current_ = *index;
        offset_ += line.size() + 1;
        return true;
    }
    Scan end(std::uint64_t bytes) {
        if (any_ && finished_) complete();
        scan_.bytes = bytes;
        return scan_;
    }

private:
    void complete() {
        scan_.next = current_ + 1;
        scan_.kept = offset_;
        scan_.failed += failing_ ? 1 : 0;
    }

    bool finished_, any_ = false, failing_ = false;
    std::uint64_t current_, offset_ = 0;
    Scan scan_{};
};

}  // namespace

OpenFile::OpenFile(std::string name, os::Opening how, const char* what)
    : name_(std::move(name)), descriptor_(os::open_file(scene::path_of(name_), how)) {
    if (descriptor_ < 0) fail(name_, what);
}

OpenFile::~OpenFile() { os::close_file(descriptor_); }

void OpenFile::write(std::string_view bytes) const {
    while (!bytes.empty()) {
        const std::ptrdiff_t written = os::write_some(descriptor_, bytes.data(), bytes.size());
        if (written < 0) fail(name_, "cannot be written");
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void replace_file(const std::string& target, const std::function<bool(const OpenFile&)>& write) {
    const std::string partial = target + ".partial";
    try {
        bool is_wanted = false;
        {  // closed before it is renamed or removed, as Windows requires
            const OpenFile file(partial, os::Opening::replace);
            is_wanted = write(file);
            if (is_wanted && !os::sync_all(file.descriptor())) fail(target, "cannot be written");
        }
        if (!is_wanted) return os::remove_file(scene::path_of(partial).c_str());
        std::error_code error;
        std::filesystem::rename(scene::path_of(partial), scene::path_of(target), error);
        if (error) throw file_error(target, "cannot be written: " + error.message());
    } catch (...) {
        os::remove_file(scene::path_of(partial).c_str());
        throw;
    }
    os::sync_folder(scene::path_of(target).parent_path());
}

void require_lines(const std::string& results) {
    for (const char* other : {".parquet", ".h5", ".hdf5", ".csv", ".tsv", ".txt", ".nc", ".npy", ".xlsx"})
        if (results.ends_with(other))
            throw scene::option_error(results +
                                      ": results are lines of JSON, file.jsonl; pandas and pyarrow read them");
}

std::string description_file(const std::string& results) { return results + ".sweep"; }

Description read_description(const std::string& results) {
    const std::string file = description_file(results);
    std::ifstream stream(scene::path_of(file), std::ios::binary);
    if (!stream)
        throw file_error(results, "the file " + file +
                                      " that names its grid and shard is missing; put it back next to the results, or "
                                      "move them away and run the sweep again");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    Description made;
    try {
        const auto json = nlohmann::json::parse(text);
        if (json.at("schema_version") != 1) throw file_error(file, "is of another version of fstiff");
        json.at("grid").get_to(made.grid);
        json.at("hash").get_to(made.hash);
        json.at("scenes").get_to(made.scenes);
        json.at("shard").get_to(made.shard.number);
        json.at("shards").get_to(made.shard.of);
        json.at("finished").get_to(made.finished);
        json.at("failed").get_to(made.failed);
        json.at("bytes").get_to(made.bytes);
    } catch (const nlohmann::json::exception&) {
        throw file_error(file, "is not a description of results; must be what fstiff sweep wrote next to " + results);
    }
    return made;
}

void write_description(const std::string& results, const Description& description) {
    const scene::Json json{{"schema_version", 1},
                           {"command", "sweep"},
                           {"grid", description.grid},
                           {"hash", description.hash},
                           {"scenes", description.scenes},
                           {"shard", description.shard.number},
                           {"shards", description.shard.of},
                           {"finished", description.finished},
                           {"failed", description.failed},
                           {"bytes", description.bytes}};
    replace_file(description_file(results), [&](const OpenFile& file) {
        file.write(json.str());
        return true;
    });
}

Scan scan_results(const OpenFile& file, std::uint64_t first, bool finished,
                  const std::function<void(std::string_view)>& piece) {
    Scanner scanner(first, finished);
    std::vector<char> buffer(std::size_t(1) << 20);
    std::string rest;  // of a line that goes on in the next piece
    bool whole = true;
    std::uint64_t bytes = 0;
    if (!os::go_to(file.descriptor(), 0)) fail(file.name(), "cannot be read");
    while (true) {
        const std::ptrdiff_t got = os::read_some(file.descriptor(), buffer.data(), buffer.size());
        if (got < 0) fail(file.name(), "cannot be read");
        if (got == 0) break;
        bytes += static_cast<std::uint64_t>(got);
        std::string_view bytes_read(buffer.data(), static_cast<std::size_t>(got));
        if (piece) piece(bytes_read);
        while (whole) {
            const std::size_t end = bytes_read.find('\n');
            if (end == std::string_view::npos) break;
            if (rest.empty()) {
                whole = scanner.take(bytes_read.substr(0, end));
            } else {
                rest += bytes_read.substr(0, end);
                whole = scanner.take(rest);
                rest.clear();
            }
            bytes_read.remove_prefix(end + 1);
        }
        if (whole) rest += bytes_read;
    }
    return scanner.end(bytes);
}

ResultsFile::ResultsFile(std::string file, Description description)
    : file_(std::move(file), os::Opening::extend), description_(std::move(description)) {
    lock();
    take_up();
}

void ResultsFile::lock() {
    const std::string& name = file_.name();
    if (!std::filesystem::is_regular_file(scene::path_of(name)))
        throw file_error(name, "is not a regular file; results of a sweep must be one, to go on after an interruption");
    if (os::lock(file_.descriptor())) return;
    if (errno == EWOULDBLOCK)
        throw file_error(name, "is being written by another process; give every shard a file of its own");
    fail(name, "cannot be locked");
}

void ResultsFile::take_up() {
    const std::string& name = file_.name();
    const std::uint64_t bytes = std::filesystem::file_size(scene::path_of(name));
    const std::uint64_t first = description_.shard.first(description_.scenes);
    next_ = first;
    if (!std::filesystem::exists(scene::path_of(description_file(name)))) {
        if (bytes > 0) static_cast<void>(read_description(name));  // refuses
        write_description(name, description_);
        return;
    }
    const Description there = read_description(name);
    if (there.hash != description_.hash)
        throw file_error(name, "holds results of another grid (" + there.grid +
                                   "), or of this one before it, a file it names or fstiff was changed; move it and " +
                                   description_file(name) + " away, or give another -o");
    if (there.shard.number != description_.shard.number || there.shard.of != description_.shard.of)
        throw file_error(name, "holds the results of shard " + there.shard.text() + ", not " +
                                   description_.shard.text() + "; give every shard a file of its own");
    if (there.finished) {
        if (there.bytes != bytes)
            throw file_error(name, "was changed since it was finished: " + std::to_string(bytes) + " bytes, not " +
                                       std::to_string(there.bytes) + "; move it and " + description_file(name) +
                                       " away and run the sweep again");
        description_ = there;
        next_ = there.shard.end(there.scenes);
        return;
    }
    const Scan scan = scan_results(file_, first, false);
    next_ = scan.next;
    size_ = scan.kept;
    description_.failed = scan.failed;
    dropped_ = bytes - scan.kept;
    if (dropped_ > 0 && !os::cut(file_.descriptor(), size_)) fail(name, "cannot be cut");
    if (!os::go_to(file_.descriptor(), size_)) fail(name, "cannot be written");
}

void ResultsFile::append(std::string_view lines, std::uint64_t next, std::uint64_t failed) {
    const auto keep = [&](std::size_t bytes) { static_cast<void>(os::cut(file_.descriptor(), size_ + bytes)); };
    try {
        file_.write(lines);
    } catch (...) {  // no room: the lines that found some stay
        const std::int64_t at = os::position(file_.descriptor());
        const std::size_t written = at > static_cast<std::int64_t>(size_) ? static_cast<std::size_t>(at) - size_ : 0;
        keep(lines.substr(0, written).rfind('\n') + 1);  // of none, npos + 1 is 0
        throw;
    }
    if (!os::sync_data(file_.descriptor())) {
        const int reason = errno;
        keep(0);
        errno = reason;
        fail(file_.name(), "cannot be written");
    }
    size_ += lines.size();
    next_ = next;
    description_.failed += failed;
}

void ResultsFile::finish() {
    description_.finished = true;
    description_.bytes = size_;
    write_description(file_.name(), description_);
}

}  // namespace fstiff::sweep
