// SPDX-License-Identifier: BSD-3-Clause
// A harmonic balance in C++: a mass on 200 bolted contacts, shaken sideways by F cos(w t).
//
//     m x'' + sum A q(x, n) = F cos(w t),   sum A p = preload,   x = c cos(w t) + s sin(w t), n: approach
//
// Each contact has carried 1.2 times its own pressure. slip_responses() returns p and q of all of them in all steps of
// two cycles, and their derivatives by (n, c, s), which make the Jacobian; the second cycle is periodic.
#include <fstiff/answer.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>
#include <fstiff/tabulated/law_after.hpp>
#include <fstiff/tabulated/slip_motion.hpp>

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace {

constexpr std::size_t contacts = 200, cycle = 64, steps = 2 * cycle + 1;  // the first step is at rest
constexpr double area = 5e-6, mass = 2, omega = 2 * std::numbers::pi * 1000, friction = 0.2;

struct Joint {
    std::vector<fstiff::TangentialLaw<double>> laws;
    std::vector<double> at_rest;  // separations [m]
    double preload = 0;           // [N]
};

Joint tightened() {
    const fstiff::Body steel = body_of(*fstiff::find_material("304"));
    const fstiff::Joint faces{.face = {.rms_height = 2e-6, .rms_gradient = 0.08}, .upper = steel, .lower = steel};
    const Eigen::VectorXd pressures = Eigen::VectorXd::LinSpaced(41, std::log(1e4), std::log(1e9)).array().exp();
    const fstiff::Answer answer = fstiff::answer(faces, pressures);
    const auto loading = answer.loading_law(0.5, {1e4, 1e9, fstiff::OutsideRange::extrapolate});  // for all elements
    Joint joint;
    for (std::size_t i = 0; i < contacts; ++i) {
        const double p = 1e6 + 2e5 * static_cast<double>(i);  // of a prestress: 1 to 41 MPa
        const auto law = law_after(loading, 1.2 * p, answer.relative_hardness.value());
        joint.laws.emplace_back(law, friction, tangential_ratio(steel.elastic, steel.elastic));
        joint.at_rest.push_back(law.separation(p));
        joint.preload += area * p;
    }
    return joint;
}

struct Balance {
    Eigen::Vector3d residual;
    Eigen::Matrix3d jacobian;
};

/// Forces on the mass that \p motion = (n, c, s) leaves: their mean normal to the faces, cosine and sine along them.
Balance balance(const Joint& joint, const Eigen::Vector3d& motion, double force) {
    Eigen::Matrix<double, steps, 3> basis = Eigen::Matrix<double, steps, 3>::Zero();  // of (n, c, s) in each step
    std::vector<double> separations, slips, by(9 * steps);
    for (std::size_t i = 1; i < steps; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double angle = 2 * std::numbers::pi * static_cast<double>(i - 1) / cycle;
        basis.row(row) << 1, std::cos(angle), std::sin(angle);
        by[9 * i] = 1;  // of -separation; then of the slip along x in this step
        for (Eigen::Index k : {1, 2}) by[9 * i + 3 + static_cast<std::size_t>(k)] = basis(row, k) - basis(row - 1, k);
    }
    for (std::size_t c = 0; c < contacts; ++c)
        for (std::size_t i = 0; i < steps; ++i) {
            separations.push_back(joint.at_rest[c] - by[9 * i] * motion[0]);
            slips.insert(slips.end(), {by[9 * i + 4] * motion[1] + by[9 * i + 5] * motion[2], 0});
        }
    std::vector<const fstiff::TangentialLaw<double>*> laws;
    for (const auto& law : joint.laws) laws.push_back(&law);
    fstiff::SlipResponses<double> found;
    fstiff::slip_responses<double>(laws, {contacts, steps, separations, slips, by, 3}, found);

    Balance sum{{-joint.preload, -mass * omega * omega * motion[1] - force, -mass * omega * omega * motion[2]},
                Eigen::Vector3d(0, -mass * omega * omega, -mass * omega * omega).asDiagonal()};
    for (std::size_t c = 0; c < contacts; ++c)
        for (std::size_t i = steps - cycle; i < steps; ++i) {
            const std::size_t at = c * steps + i;
            const Eigen::Vector3d weight =
                area / cycle *
                basis.row(static_cast<Eigen::Index>(i)).transpose().cwiseProduct(Eigen::Vector3d(1, 2, 2));
            const double p = found.pressures[at], q = found.tractions[2 * at];
            sum.residual += weight.cwiseProduct(Eigen::Vector3d(p, q, q));
            const Eigen::Map<const Eigen::RowVector3d> p_by(&found.responses_by[9 * at]), q_by(p_by.data() + 3);
            sum.jacobian.row(0) += weight[0] * p_by;
            sum.jacobian.bottomRows<2>() += weight.tail<2>() * q_by;
        }
    return sum;
}

}  // namespace

int main() {
    const Joint joint = tightened();
    Eigen::Vector3d motion = Eigen::Vector3d::Zero();
    std::printf("force [N]  amplitude [um]  lag [deg]  Newton  Jacobian is that of differences within 1e-6\n");
    for (const double force : {100.0, 1000.0, 2000.0, 3000.0, 4000.0}) {
        int count = 0;
        Balance now = balance(joint, motion, force);
        for (; now.residual.norm() > 1e-9 * force && count < 20; ++count) {
            motion -= now.jacobian.partialPivLu().solve(now.residual);
            now = balance(joint, motion, force);
        }
        const Eigen::Vector3d change = 1e-6 * Eigen::Vector3d(0.1 * motion.norm(), motion[1], -motion[2]);
        const Eigen::Vector3d by = now.jacobian * change,
                              difference = (balance(joint, motion + change, force).residual -
                                            balance(joint, motion - change, force).residual) /
                                           2;
        std::printf("%9.0f  %14.4f  %9.3f  %6d  %s\n", force, 1e6 * std::hypot(motion[1], motion[2]),
                    180 / std::numbers::pi * std::atan2(motion[2], motion[1]), count,
                    (difference - by).norm() < 1e-6 * by.norm() ? "yes" : "no");
    }
    return 0;
}
