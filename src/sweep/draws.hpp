// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Random numbers that depend on (seed, scene, input) alone, so that every part and thread draws the same.
//
//     x = philox4x32_10(counter = {scene, input}, key = seed),  u = (52 bits of x + 1/2)/2^52
//
// Reference   Salmon, Moraes, Dror, Shaw, SC11 (2011), Philox-4x32-10
// Accuracy    the generator is exact: known answers of Random123 (tests/sweep/draws_test.cpp)

#include <array>
#include <cstdint>

namespace fstiff::sweep {

/// Ten rounds of Philox with four words of 32 bits.
[[nodiscard]] std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                                  std::array<std::uint32_t, 2> key);

/// A number of (0, 1), never 0 or 1, for the input \p input of the scene \p index.
[[nodiscard]] double uniform_draw(std::uint64_t seed, std::uint64_t index, std::uint32_t input);

/// How an input is distributed.
struct Distribution {
    enum class Kind {
        normal,     ///< mean \p a, standard deviation \p b
        lognormal,  ///< median \p a, standard deviation \p b of the natural logarithm
        uniform     ///< between \p a and \p b
    };
    Kind kind = Kind::normal;
    double a = 0, b = 0;

    /// The value below which the share \p probability lies, between 0 and 1, both excluded.
    [[nodiscard]] double quantile(double probability) const;
};

}  // namespace fstiff::sweep
