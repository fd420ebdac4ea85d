// SPDX-License-Identifier: BSD-3-Clause
// Heat through the contact set of boundary elements, by finite volumes of the body itself: K is its conductance.
#include <fstiff/asperity/conductance.hpp>
#include <fstiff/halfspace/boundary_elements.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <cmath>
#include <numbers>
#include <vector>

namespace conduction_test {

using namespace fstiff;

namespace {

/// h of a body of conductivity 1 and of the side 1, repeated in x and y, whose spots \p on are at 1 while the rest of
/// the face is insulated, less the resistance of the body without constriction: cells of one size, as deep as the side.
double conductance_of_body(const Eigen::ArrayXX<bool>& on) {
    const auto n = static_cast<int>(on.rows());
    const auto cell = [n](int x, int y, int z) { return (z * n + (y + n) % n) * n + (x + n) % n; };
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd sources = Eigen::VectorXd::Zero(n * n * n);
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const int here = cell(x, y, z);
                double sum = 4;
                for (const int other : {cell(x - 1, y, z), cell(x + 1, y, z), cell(x, y - 1, z), cell(x, y + 1, z)})
                    entries.emplace_back(here, other, -1);
                for (const int up : {z - 1, z + 1})
                    if (up >= 0 && up < n) entries.emplace_back(here, cell(x, y, up), -1), sum += 1;
                if (z == n - 1) sum += 2;  // the far end, at 0, half a cell away
                if (z == 0 && on(y, x)) sum += 2, sources[here] += 2;
                entries.emplace_back(here, here, sum);
            }
    Eigen::SparseMatrix<double> matrix(n * n * n, n * n * n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(matrix);
    solver.setTolerance(1e-10);
    const Eigen::VectorXd temperature = solver.solve(sources);
    double heat = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) heat += 2 * temperature[cell(x, y, n - 1)] / n;
    return 1 / (1 / heat - 1);
}

}  // namespace

TEST_CASE("K of boundary elements is the conductance of their contact set by finite volumes of both bodies") {
    const auto ratio = [](int n, double pressure) {
        HeightMap<double> map;
        map.dx = map.dy = 1.0 / n;
        map.heights.resize(n, n);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const double x = 2 * std::numbers::pi * i / n, y = 2 * std::numbers::pi * j / n;
                map.heights(j, i) =
                    0.01 * (std::cos(x) * std::cos(y) + 0.4 * std::cos(x + 0.7) + 0.2 * std::sin(2 * y));
            }
        BoundaryElements<double> solver(map, 1.0, {.edges = Edges::periodic});
        const auto state = solver.at_pressure(pressure);
        const double body = conductance_of_body((solver.pressures() > 0).eval());
        return body / 2 / spot_conductance(state.stiffness, joint_conductivity(1.0, 1.0), 1.0);
    };
    for (const double pressure : {0.004, 0.01, 0.02}) {
        const double coarse = ratio(24, pressure), fine = ratio(48, pressure);
        CAPTURE(pressure, coarse, fine);
        CHECK(std::abs(fine - 1) < 0.06);                // the edges of a spot are those of its cells
        CHECK(std::abs(2 * fine - coarse - 1) < 0.005);  // of cells without size
    }
}

}  // namespace conduction_test
