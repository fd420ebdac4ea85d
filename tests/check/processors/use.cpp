// SPDX-License-Identifier: BSD-3-Clause
// Copies, compares, evaluates and frees what make.cpp made, compiled with other flags for the processor.
#include "made.hpp"

#include <array>
#include <cmath>

int main() {
    const auto law = make_law();
    const auto copy = law;
    fstiff::ContactLaw<double> assigned = make_law();
    assigned = fstiff::ContactLaw<double>::from_text(law.to_text());
    Eigen::ArrayXd pressures = Eigen::ArrayXd::LinSpaced(7, 1e5, 1e8), stiffnesses(7);
    copy.stiffness(pressures, stiffnesses);
    bool right = copy == law && assigned == law;
    for (Eigen::Index i = 0; i < 7; ++i) right &= std::abs(stiffnesses[i] / law.stiffness(pressures[i]) - 1) < 1e-13;

    const auto contact = make_summits();
    const auto copied = contact;
    const double separation = copied.at_pressure(1e6).separation.value;
    return right && std::abs(contact.at_separation(separation).pressure.value / 1e6 - 1) < 1e-9 ? 0 : 1;
}
