// SPDX-License-Identifier: BSD-3-Clause
// Numbers of every layer, to the last bit: compiled with the headers, and with the one header that
// tools/make_single_header.py makes of them, which is all that FSTIFF_SINGLE_HEADER leaves to be found.
#ifdef FSTIFF_SINGLE_HEADER
#include "fstiff.hpp"
#else
#include <fstiff/fstiff.hpp>
#include <fstiff/io.hpp>
#include <fstiff/io/quantities.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>
#endif

#include <cstdio>
#include <numbers>
#include <sstream>

double elsewhere(double omega, double radius);  // other.cpp

namespace {

void print(const char* name, double value) { std::printf("%s %a\n", name, value); }

void print_contact() {
    const fstiff::Roughness<double> fine{.rms_height = 0.832e-6, .peak_radius = 40e-6, .peak_density = 500e6};
    const auto peaks = fstiff::PeakDistribution<double>::exponential(std::numbers::pi / 3);
    const fstiff::RoughContact contact(fine, peaks, fstiff::FractalLaw<double>(1.62), 112.6e9);
    print("K of the contact", contact.at_pressure(10e6).stiffness.value);
    const auto law = fstiff::ContactLaw<double>::tabulate(contact, {.min_pressure = 1e5, .max_pressure = 1e8});
    print("K of the law", law.stiffness(10e6));
    std::printf("the law\n%s", law.to_text().c_str());
}

void print_surfaces() {
    const auto trace =
        fstiff::self_affine_profile<double>({.hurst = 0.4, .rms = 0.3e-6, .longest_wavelength = 500e-6}, 4096, 0.5e-6);
    const auto level = fstiff::detail::level(trace, fstiff::Form::line);
    print("kurtosis", fstiff::height_statistics(level.profile).kurtosis.value);
    print("rms curvature", fstiff::peak_statistics(level.profile).rms_curvature);
    print("S of the fourth lag", fstiff::structure_function(level.profile).value[3]);
    const auto map = fstiff::self_affine_map<double>(
        {.hurst = 0.8, .rms = 1e-6, .longest_wavelength = 32e-6, .shortest_wavelength = 8e-6}, 128, 128, 0.5e-6,
        0.5e-6);
    const auto islands = fstiff::island_curve(map);
    print("D_p of islands", islands.density[islands.representative()]);
}

void print_text() {
    std::stringstream file("x [um], z [nm]\n");
    file.seekp(0, std::ios::end);
    for (int i = 0; i < 32; ++i) file << i << ", " << i * i % 7 << '\n';
    const auto read = fstiff::io::read_surface(file, "a profile");
    print("spacing", read.profile().spacing);
    std::ostringstream written;
    fstiff::io::write_csv(written, read.profile());
    std::printf("%zu bytes written\n", written.str().size());
    print("stiffness", fstiff::io::parse_quantity("3 GPa/um", fstiff::io::Dimension::stiffness_per_area, "K"));
    print("reflection", fstiff::reflection(1e14, 46e6, 2 * std::numbers::pi * 1e6));
}

}  // namespace

int main() {
    print_contact();
    print_surfaces();
    print_text();
    print("another file", elsewhere(1e-8, 40e-6));
}
