// SPDX-License-Identifier: BSD-3-Clause
// The contact integrals by fstiff: one dimension, two dimensions, and the paper's 50 x 50 points.
#include "methods.hpp"
#include "row.hpp"

namespace {

using namespace bench;

const Rows rows_of_integrals([] {
    for (const char* grid : {plain, hard})
        for (const double tolerance : tolerances) {
            const auto add = [&](const char* what, const Which& which, auto method) {
                row("fstiff", what, grid, text_of(tolerance), which, tolerance,
                    [=](const Problem& p) { return method(p, tolerance); });
            };
            add("four", four, reduced<Quantity::all>);
            add("stiffness_load", two, reduced<Quantity::stiffness | Quantity::pressure>);
            add("stiffness", one, reduced<Quantity::stiffness>);
        }
    for (const double tolerance : tolerances) {
        row("fstiff-tensor", "four", plain, text_of(tolerance), four, tolerance,
            [=](const Problem& p) { return tensor(p, four, tolerance); });
        row("fstiff-tensor", "stiffness", plain, text_of(tolerance), one, tolerance,
            [=](const Problem& p) { return tensor(p, one, tolerance); });
    }
    row("fstiff-paper", "stiffness", plain, "50x50", one, 1e-3, [](const Problem& p) { return paper(p, one); });
});

}  // namespace
