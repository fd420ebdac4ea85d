// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A shard: one of n parts of a grid, of adjacent scenes.

#include <cstdint>
#include <string>

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

}  // namespace fstiff::sweep
