// SPDX-License-Identifier: BSD-3-Clause
// Hands maps and small arrays to fstiff::double and takes them from it, to be freed here; prints K.
#include <fstiff/contact/hybrid_of_map.hpp>
#include <fstiff/double/contacts.hpp>

#include <cstdio>
#include <vector>

int main() {
    std::vector<fstiff::HeightMap<double>> maps;
    for (int i = 0; i < 4; ++i)
        maps.push_back(fstiff::self_affine_map<double>({.hurst = 0.8, .rms = 0.4e-6, .longest_wavelength = 32e-6}, 64,
                                                       std::size_t(61 + i), 0.5e-6, 0.5e-6));
    maps.erase(maps.begin(), maps.begin() + 3);
    const fstiff::Surface<double> measured = fstiff::measure(maps.front());
    const auto contact = fstiff::hybrid_of_map(fstiff::prepare(maps.front()).map, 112.6e9, fstiff::Edges::mirrored);
    const auto law = fstiff::ContactLaw<double>::tabulate(contact, {.min_pressure = 1e6, .max_pressure = 1e8});

    Eigen::ArrayXd pressures = Eigen::ArrayXd::LinSpaced(7, 1e6, 1e8), stiffnesses(7);
    law.stiffness(pressures, stiffnesses);
    const fstiff::TangentialLaw<double> friction(law, 0.2, 0.8);
    fstiff::SlipState<double, 1> slip{.separation = law.separation(10e6)};
    const auto moved =
        friction.step(slip, slip.separation, fstiff::TangentialLaw<double>::Vector<1>(1e-9), slip).tangent;
    std::printf("%.5g %.5g %.5g %.5g\n", measured.map->map.heights.square().mean(), law.stiffness(10e6),
                stiffnesses.sum(), moved(1, 1));
}
