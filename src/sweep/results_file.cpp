// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/results_file.hpp"

#include "document/file.hpp"
#include "document/json.hpp"
#include "document/system.hpp"

#include <fstiff/core/error.hpp>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace fstiff::sweep {

namespace {

std::optional<std::uint64_t> number_in(std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
    return number;
}

/// A variable of the environment; none where it is not set. \throws domain_error where it is not a whole number.
std::optional<std::uint64_t> variable(const char* name) {
    const char* text = std::getenv(name);
    if (!text) return std::nullopt;
    const auto number = number_in(text);
    if (!number)
        throw document::option_error(std::string(name) + " = \"" + text +
                                     "\": must be a whole number for --shard auto");
    return number;
}

Shard checked(std::uint64_t number, std::uint64_t count, const std::string& from) {
    constexpr std::uint64_t most = 1000000000;
    if (count < 1 || count > most || number < 1 || number > count)
        throw document::option_error("shard " + std::to_string(number) + "/" + std::to_string(count) + " of " + from +
                                     ": must be i/n with 1 <= i <= n");
    return {number, count};
}

Shard of_environment() {
    if (const auto task = variable("SLURM_ARRAY_TASK_ID")) {
        const auto count = variable("SLURM_ARRAY_TASK_COUNT"), least = variable("SLURM_ARRAY_TASK_MIN");
        if (!count)
            throw document::option_error(
                "SLURM_ARRAY_TASK_COUNT is not set; --shard auto needs it with SLURM_ARRAY_TASK_ID");
        const std::uint64_t step = variable("SLURM_ARRAY_TASK_STEP").value_or(1), begin = least.value_or(1);
        const std::string name = "SLURM_ARRAY_TASK_ID " + std::to_string(*task);
        if (*task < begin || step == 0 || (*task - begin) % step != 0) return checked(0, *count, name);
        return checked((*task - begin) / step + 1, *count, name);
    }
    const char* const pairs[][2]{{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"}, {"PMI_RANK", "PMI_SIZE"}};
    for (const auto& [rank, size] : pairs)
        if (const auto number = variable(rank)) {
            const auto of = variable(size);
            if (!of)
                throw document::option_error(std::string(size) + " is not set; --shard auto needs it with " + rank);
            return checked(*number + 1, *of, rank);
        }
    throw document::option_error(
        "--shard auto: neither SLURM_ARRAY_TASK_ID nor OMPI_COMM_WORLD_RANK nor PMI_RANK is set; must run in a Slurm "
        "job array or under mpirun, or be given as i/n");
}

}  // namespace

std::uint64_t Shard::first(std::uint64_t size) const {
    // floor(size (number - 1)/of) without a product beyond 64 bits
    return size / of * (number - 1) + size % of * (number - 1) / of;
}

std::uint64_t Shard::end(std::uint64_t size) const { return Shard{number + 1, of}.first(size); }

std::string Shard::text() const { return std::to_string(number) + "/" + std::to_string(of); }

Shard parse_shard(const std::string& text) {
    if (text == "auto") return of_environment();
    const std::size_t slash = text.find('/');
    const auto number = number_in(std::string_view(text).substr(0, slash));
    const auto of = slash == std::string::npos ? std::nullopt : number_in(std::string_view(text).substr(slash + 1));
    if (!number || !of) throw document::option_error("--shard \"" + text + "\": must be i/n such as 3/8, or auto");
    return checked(*number, *of, "--shard");
}

namespace {

namespace os = document::os;

[[noreturn]] void fail(const std::string& file, const std::string& what) {
    throw file_error(file, what + ": " + std::generic_category().message(errno));
}

/// More than is written between two syncs: only there can a loss of power have left something else than lines.
constexpr std::uint64_t most_unsynced = std::uint64_t(1) << 26;

/// The index at the beginning of \p line, which ends as an object of JSON does; none of another line.
std::optional<std::uint64_t> leading_index(std::string_view line) {
    constexpr std::string_view begin = "{\"index\":";
    if (!line.starts_with(begin) || !line.ends_with('}')) return {};
    std::uint64_t index = 0;
    const auto [end, error] = std::from_chars(line.data() + begin.size(), line.data() + line.size(), index);
    if (error != std::errc() || (*end != ',' && *end != '}')) return {};
    return index;
}

/// Content of a file of results: whole lines of scenes that follow one another. The last scene is not whole, for lines
/// of it may be missing.
struct Scan {
    std::uint64_t next;        ///< scene after the last whole one
    std::uint64_t kept = 0;    ///< bytes of the whole scenes
    std::uint64_t failed = 0;  ///< scenes without result among the whole ones
};

/// Reads \p file, whose first scene is \p first, up to the first line that does not follow those before.
Scan scan_of(const std::string& file, std::uint64_t first) {
    Scan scan{.next = first};
    std::ifstream stream(document::path_of(file), std::ios::binary);
    const std::uint64_t size = std::filesystem::file_size(document::path_of(file));
    std::uint64_t current = first, bytes = 0;
    bool failing = false;
    for (std::string line; std::getline(stream, line) && !stream.eof(); bytes += line.size() + 1) {
        const auto index = bytes + most_unsynced < size ? leading_index(line) : index_of_line(line);
        if (bytes > 0 && index == current + 1) {
            scan = {.next = *index, .kept = bytes, .failed = scan.failed + (failing ? 1 : 0)};
            failing = false;
        } else if (index != current) {
            break;
        }
        current = *index;
        failing = failing || line.find("\"error\":\"") != std::string::npos;
    }
    return scan;
}

/// \p text becomes the content of \p target once it is complete and synced. \throws file_error.
void replace_file(const std::string& target, std::string_view text) {
    const std::string partial = target + ".partial";
    try {
        {  // closed before it is renamed, as Windows requires
            const OpenFile file(partial, os::Opening::replace);
            file.write(text);
            if (!os::sync_all(file.descriptor())) fail(target, "cannot be written");
        }
        std::error_code error;
        std::filesystem::rename(document::path_of(partial), document::path_of(target), error);
        if (error) throw file_error(target, "cannot be written: " + error.message());
    } catch (...) {
        os::remove_file(document::path_of(partial).c_str());
        throw;
    }
    os::sync_folder(document::path_of(target).parent_path());
}

/// The description of \p results. \throws file_error where it is missing or is none, in a sentence with the remedy.
Description read_description(const std::string& results) {
    const std::string file = description_file(results);
    std::ifstream stream(document::path_of(file), std::ios::binary);
    if (!stream)
        throw file_error(results, "the file " + file +
                                      " that names its grid and shard is missing; put it back next to the results, or "
                                      "move them away and run the sweep again");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::optional<document::Json> json = document::parsed_json(text);
    const auto take = [&]<class Value>(const char* key, Value& to) {
        const document::Json* entry = json ? json->at(key) : nullptr;
        const Value* value = entry ? entry->value<Value>() : nullptr;
        if (!value)
            throw file_error(file,
                             "is not a description of results; must be what fstiff sweep wrote next to " + results);
        to = *value;
    };
    std::uint64_t version = 0;
    take("schema_version", version);
    if (version != 1) throw file_error(file, "is of another version of fstiff");
    Description description;
    Description::each_field(description, take);
    return description;
}

void write_description(const std::string& results, const Description& description) {
    document::Json json{{"schema_version", 1}, {"command", "sweep"}};
    Description::each_field(description, [&](const char* key, const auto& value) { json[key] = value; });
    replace_file(description_file(results), json.str());
}

}  // namespace

OpenFile::OpenFile(std::string name, os::Opening opening)
    : name_(std::move(name)), descriptor_(os::open_file(document::path_of(name_), opening)) {
    if (descriptor_ < 0) fail(name_, "cannot be written");
}

OpenFile::~OpenFile() { os::close_file(descriptor_); }

void OpenFile::write(std::string_view bytes) const {
    while (!bytes.empty()) {
        const std::ptrdiff_t written = os::write_some(descriptor_, bytes.data(), bytes.size());
        if (written < 0) fail(name_, "cannot be written");
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

std::optional<std::uint64_t> index_of_line(std::string_view line) {
    const auto index = leading_index(line);
    return index && document::is_json(line) ? index : std::nullopt;
}

void require_lines(const std::string& results) {
    for (const char* other : {".parquet", ".h5", ".hdf5", ".csv", ".tsv", ".txt", ".nc", ".npy", ".xlsx"})
        if (results.ends_with(other))
            throw document::option_error(results +
                                         ": results are lines of JSON, file.jsonl; pandas and pyarrow read them");
}

std::string description_file(const std::string& results) { return results + ".sweep"; }

ResultsFile::ResultsFile(std::string file, Description description)
    : file_(std::move(file), os::Opening::extend), description_(std::move(description)) {
    lock();
    take_up();
}

void ResultsFile::lock() {
    const std::string& name = file_.name();
    if (!std::filesystem::is_regular_file(document::path_of(name)))
        throw file_error(name, "is not a regular file; results of a sweep must be one, to go on after an interruption");
    if (os::lock(file_.descriptor())) return;
    if (errno == EWOULDBLOCK)
        throw file_error(name, "is being written by another process; give every shard a file of its own");
    fail(name, "cannot be locked");
}

void ResultsFile::take_up() {
    const std::string& name = file_.name();
    const std::uint64_t bytes = std::filesystem::file_size(document::path_of(name));
    const std::uint64_t first = description_.shard.first(description_.scenes);
    next_ = first;
    if (!std::filesystem::exists(document::path_of(description_file(name)))) {
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
    const Scan scan = scan_of(name, first);
    next_ = scan.next;
    size_ = scan.kept;
    description_.failed = scan.failed;
    dropped_ = bytes - scan.kept;
    if (dropped_ > 0 && !os::cut(file_.descriptor(), size_)) fail(name, "cannot be cut");
    if (!os::go_to(file_.descriptor(), size_)) fail(name, "cannot be written");
}

void ResultsFile::append(std::string_view lines, std::uint64_t next, std::uint64_t failed) {
    waiting_ += lines;
    next_ = next;
    description_.failed += failed;
    const std::chrono::duration<double> unsynced = std::chrono::steady_clock::now() - synced_;
    if (waiting_.size() >= std::size_t(1) << 20 || unsynced.count() >= 1) write();
}

void ResultsFile::write() {
    const auto keep = [&](std::size_t bytes) { static_cast<void>(os::cut(file_.descriptor(), size_ + bytes)); };
    try {
        file_.write(waiting_);
    } catch (...) {  // no room: the lines that found some stay
        const std::int64_t position = os::position(file_.descriptor());
        const std::size_t written =
            position > static_cast<std::int64_t>(size_) ? static_cast<std::size_t>(position) - size_ : 0;
        keep(std::string_view(waiting_).substr(0, written).rfind('\n') + 1);  // of none, npos + 1 is 0
        throw;
    }
    if (!os::sync_data(file_.descriptor())) {
        const int reason = errno;
        keep(0);
        errno = reason;
        fail(file_.name(), "cannot be written");
    }
    size_ += waiting_.size();
    waiting_.clear();
    synced_ = std::chrono::steady_clock::now();
}

void ResultsFile::finish() {
    write();
    description_.finished = true;
    description_.bytes = size_;
    write_description(file_.name(), description_);
}

}  // namespace fstiff::sweep
