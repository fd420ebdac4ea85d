// SPDX-License-Identifier: BSD-3-Clause
// Prints K of each law over K of boundary elements as CSV, for tools/make_validation.py.
#include "support/half_space.hpp"

#include <cstdio>

int main() {
    std::printf("law,family,p_star,ratio,least,largest\n");
    for (const auto& row : test::half_space_ratios())
        std::printf("%s,%s,%.3g,%.4f,%.4f,%.4f\n", row.law.c_str(), row.family.c_str(), row.dimensionless_pressure,
                    row.ratio, row.least, row.largest);
}
