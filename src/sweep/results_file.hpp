// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The file of results of one shard: whole lines are appended and synced, so that a run that was killed goes on where it
// stopped. Next to out.jsonl is out.jsonl.sweep, a small JSON that names the grid and shard of these; it is
// written before the first result and again when the last one is there.
//
//     ResultsFile file("out.jsonl", description);
//     while (file.next() < end) file.append(lines of the scenes from file.next() on, ...);
//     file.finish();
//
// The files of all shards, one after the other, are the very bytes that a sweep without shards writes.

#include "document/system.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fstiff::sweep {

struct Shard {
    std::uint64_t number = 1, of = 1;  ///< number from 1 to of

    /// The first scene of this shard, of \p size scenes in all, and the one after its last.
    [[nodiscard]] std::uint64_t first(std::uint64_t size) const;
    [[nodiscard]] std::uint64_t end(std::uint64_t size) const;
    /// "3/8"
    [[nodiscard]] std::string text() const;
};

/// "3/8", or "auto": of a Slurm job array, else of OpenMPI, else of PMI, by the environment.
/// \throws option_error for another text, and for "auto" where none of these is there.
[[nodiscard]] Shard parse_shard(const std::string& text);

/// Content of the file next to the results.
struct Description {
    std::string grid;          ///< file of the grid, as it was given
    std::string hash;          ///< of the grid
    std::uint64_t scenes = 0;  ///< of the whole grid
    Shard shard{};
    bool finished = false;
    std::uint64_t failed = 0, bytes = 0;  ///< where it is finished: scenes without result, size of the results

    /// Hands over the fields of \p of with their keys in the file.
    template <class Of, class Take>
    static void each_field(Of& of, const Take& take) {
        take("grid", of.grid);
        take("hash", of.hash);
        take("scenes", of.scenes);
        take("shard", of.shard.number);
        take("shards", of.shard.of);
        take("finished", of.finished);
        take("failed", of.failed);
        take("bytes", of.bytes);
    }
};

/// \throws option_error for the ending of a table or of another binary form: results are lines of JSON.
void require_lines(const std::string& results);

/// The name of the file next to \p results.
[[nodiscard]] std::string description_file(const std::string& results);

/// A file, which is closed at the end.
class OpenFile {
public:
    /// \throws file_error with the reason that the system gives.
    OpenFile(std::string name, document::os::Opening opening);
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile();
    /// Writes all of \p bytes. \throws file_error.
    void write(std::string_view bytes) const;
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] int descriptor() const { return descriptor_; }

private:
    std::string name_;
    int descriptor_;
};

/// The index of the scene of \p line; none unless it is a whole line of results: one object of JSON that begins with
/// its index.
[[nodiscard]] std::optional<std::uint64_t> index_of_line(std::string_view line);

/// The results of one shard, open and locked for this process alone.
class ResultsFile {
public:
    /// Opens \p file, or makes it. What is torn at its end is cut off.
    /// \throws file_error where another process writes it, where it holds results of another grid or shard, or
    /// something else, and where it cannot be written.
    ResultsFile(std::string file, Description description);

    /// The scene to go on with; that after the last one of the shard when it is finished.
    [[nodiscard]] std::uint64_t next() const { return next_; }
    /// Bytes of a torn end that was cut off.
    [[nodiscard]] std::uint64_t dropped() const { return dropped_; }
    [[nodiscard]] const Description& description() const { return description_; }

    /// Takes whole lines of the scenes up to \p next, which are written and synced a mebibyte or a second of work at a
    /// time. \throws file_error with the reason that the system gives.
    void append(std::string_view lines, std::uint64_t next, std::uint64_t failed);
    /// All scenes are there.
    void finish();

private:
    void lock();
    void take_up();
    /// Writes the lines that wait. Where the disk is full, those that found room stay.
    void write();

    OpenFile file_;
    Description description_;
    std::uint64_t next_ = 0, size_ = 0, dropped_ = 0;
    std::string waiting_;
    std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
};

}  // namespace fstiff::sweep
