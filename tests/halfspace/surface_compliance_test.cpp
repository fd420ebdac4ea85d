// SPDX-License-Identifier: BSD-3-Clause
// Truth: single waves, which the half space answers by 2/(E |q|); the mirrored map written out.
#include <fstiff/halfspace/surface_compliance.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>

namespace surface_compliance_test {

using namespace fstiff;

/// Wave number of the shortest wave that \p points hold, over that of a zigzag.
double highest(int points, Edges edges) {
    if (edges == Edges::mirrored) return static_cast<double>(points - 1) / points;
    return static_cast<double>(points / 2 * 2) / points;
}

TEST_CASE("a wave of pressure deflects by 2/(E |q|) of it") {
    for (const auto edges : {Edges::periodic, Edges::mirrored})
        for (const auto& [rows, columns] :
             {std::pair(16, 24), std::pair(15, 21), std::pair(53, 8), std::pair(7, 101)}) {
            const double dx = 2e-7, dy = 3e-7, fold = edges == Edges::mirrored ? 1 : 2;
            detail::SurfaceCompliance<double> compliance(rows, columns, dx, dy, edges);
            const double qx = fold * std::numbers::pi * 3 / (columns * dx),
                         qy = fold * std::numbers::pi * 2 / (rows * dy);
            detail::GridField<double> field(rows, columns), truth(rows, columns);
            for (int j = 0; j < rows; ++j)
                for (int i = 0; i < columns; ++i) {
                    const double shift = edges == Edges::mirrored ? 0 : 0.7;
                    field(j, i) = std::cos(qx * (i + 0.5) * dx + shift) * std::cos(qy * (j + 0.5) * dy + 2 * shift);
                    truth(j, i) = 2 / std::hypot(qx, qy) * field(j, i);
                    field(j, i) += 0.3;  // the mean deflects nothing
                }
            const detail::GridField<double> pressure = field - 0.3;
            compliance.deflect(field);
            CAPTURE(rows, columns);
            CHECK((field - truth).abs().maxCoeff() < 2e-14 * truth.abs().maxCoeff());
            const double stiffest =  // 2/|q| of the shortest wave: of zigzags along both sides
                2 / std::numbers::pi / std::hypot(highest(columns, edges) / dx, highest(rows, edges) / dy);
            detail::GridField<float> pull = (field / stiffest).cast<float>();
            compliance.inverse().apply(pull);
            CHECK((pull.cast<double>() - pressure).abs().maxCoeff() < 3e-6 * (field / stiffest).abs().maxCoeff());
        }
}

}  // namespace surface_compliance_test
