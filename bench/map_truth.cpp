// SPDX-License-Identifier: BSD-3-Clause
// Prints as CSV what boundary elements give for maps of many kinds, for docs/validation.md.
//
//     fstiff_map_truth FIRST LAST > bench/map_truth.csv     seeds FIRST to LAST of every kind of tests/support/map_kinds.hpp
#include "support/map_kinds.hpp"

#include <fstiff/halfspace/boundary_elements.hpp>
#include <fstiff/halfspace/truth.hpp>

#include <cstdio>
#include <cstdlib>

int main(int arguments, char** argument) {
    const auto first = static_cast<std::uint64_t>(arguments > 2 ? std::atoi(argument[1]) : 1);
    const auto last = static_cast<std::uint64_t>(arguments > 2 ? std::atoi(argument[2]) : 1);
    std::printf("kind,seed,p_star,K,area\n");
    for (const test::MapKind& kind : test::map_kinds())
        for (std::uint64_t seed = first; seed <= last; ++seed) {
            const fstiff::HeightMap<double> map = kind.map(seed);
            fstiff::BoundaryElementOptions<double> options;
            options.edges = fstiff::Edges::periodic;
            fstiff::BoundaryElements<double> solver(map, 1.0, options);
            for (const double p_star : {0.001, 0.003, 0.01, 0.03, 0.1, 0.25}) {
                const auto found = solver.at_pressure(0.1 * p_star);
                std::printf("\"%s\",%d,%g,%.5g,%.4g\n", kind.name.c_str(), static_cast<int>(seed), p_star, found.stiffness,
                            found.contact_fraction);
                std::fflush(stdout);
            }
        }
}
