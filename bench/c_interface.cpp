// SPDX-License-Identifier: BSD-3-Clause
// What a call through fstiff.h costs over the same call in C++, in nanoseconds: each pair is compared first (largest
// relative difference of K), then timed, the two in turn, the least of 200 rounds over 512 points.
//
//     fstiff_c_bench        what,cpp_ns,c_ns,c_over_cpp_ns,largest_difference
#include <fstiff.h>

#include <fstiff/contact/contact_curve.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/tangential_law.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

namespace {

constexpr std::size_t count = 512;
using Numbers = std::array<double, count>;

/// Keeps the compiler from leaving out what nobody reads.
void keep(const Numbers& numbers) { asm volatile("" : : "r"(numbers.data()) : "memory"); }

double nanoseconds(const auto& call, Numbers& results) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    call(results);
    keep(results);
    return std::chrono::duration<double, std::nano>(Clock::now() - begin).count() / count;
}

bool compare(const char* what, const auto& in_cpp, const auto& in_c) {
    Numbers cpp{}, c{};
    in_cpp(cpp), in_c(c);
    double largest = 0;
    for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, std::abs(c[i] / cpp[i] - 1));
    double best_cpp = std::numeric_limits<double>::infinity(), best_c = best_cpp;
    for (int round = 0; round < 200; ++round) {
        best_cpp = std::min(best_cpp, nanoseconds(in_cpp, cpp));
        best_c = std::min(best_c, nanoseconds(in_c, c));
    }
    std::printf("%s,%.2f,%.2f,%.2f,%.1e\n", what, best_cpp, best_c, best_c - best_cpp, largest);
    return largest < 1e-13;
}

}  // namespace

int main() {
    const fstiff::RoughContact hertz(fstiff::Roughness<double>{0.832e-6, 40e-6, 500e6},
                                     fstiff::PeakDistribution<double>(0.5, 1), fstiff::HertzLaw<double>{}, 112.6e9);
    const auto law = fstiff::ContactLaw<double>::tabulate(hertz, {1e5, 1e8});
    Numbers pressures, separations;
    for (std::size_t i = 0; i < count; ++i) {
        pressures[i] = 1.1e5 * std::pow(900, std::fmod(0.6180339887498949 * static_cast<double>(i), 1));
        separations[i] = law.separation(pressures[i]);
    }
    const std::string text = law.to_text();
    fstiff_face face{};
    face.size = sizeof face;
    face.rms_height = 0.832e-6, face.peak_radius = 40e-6, face.peak_density = 500e6, face.r = 0.5, face.theta = 1;
    fstiff_joint joint{};
    joint.size = sizeof joint, joint.face = &face, joint.effective_modulus = 112.6e9;
    fstiff_contact* contact = nullptr;
    fstiff_law* c_law = nullptr;
    if (fstiff_contact_make("hertz", &joint, &contact) || fstiff_law_of_text(text.data(), text.size(), &c_law))
        return 1;

    std::puts("what,cpp_ns,c_ns,c_over_cpp_ns,largest_difference");
    bool good = compare(
        "law at separation",
        [&](Numbers& k) {
            for (std::size_t i = 0; i < count; ++i) k[i] = law.at_separation(separations[i]).stiffness;
        },
        [&](Numbers& k) {
            double p;
            for (std::size_t i = 0; i < count; ++i) fstiff_law_at_separation(c_law, separations[i], &p, &k[i], nullptr);
        });
    good &= compare(
        "law at pressure",
        [&](Numbers& k) {
            for (std::size_t i = 0; i < count; ++i) k[i] = law.stiffness(pressures[i]);
        },
        [&](Numbers& k) {
            for (std::size_t i = 0; i < count; ++i)
                fstiff_law_at_pressure(c_law, pressures[i], nullptr, &k[i], nullptr);
        });
    good &= compare(
        "law at 512 separations",
        [&](Numbers& k) {
            static Numbers p;
            law.at_separation(Eigen::Map<const Eigen::ArrayXd>(separations.data(), count),
                              Eigen::Map<Eigen::ArrayXd>(p.data(), count), Eigen::Map<Eigen::ArrayXd>(k.data(), count));
        },
        [&](Numbers& k) {
            static Numbers p;
            fstiff_law_at_separations(c_law, separations.data(), count, p.data(), k.data(), nullptr);
        });
    const fstiff::Quantity wanted =
        fstiff::Quantity::stiffness | fstiff::Quantity::pressure | fstiff::Quantity::separation;
    good &= compare(
        "contact at 512 pressures",
        [&](Numbers& k) {
            const auto points = fstiff::curve_at_pressures(hertz, pressures, wanted);
            for (std::size_t i = 0; i < count; ++i) k[i] = points[i].state.stiffness.value;
        },
        [&](Numbers& k) {
            const fstiff_points points{sizeof points, nullptr, nullptr, k.data(), nullptr,
                                       nullptr,       nullptr, nullptr, nullptr};
            fstiff_contact_at_pressures(contact, pressures.data(), count, &points);
        });
    const fstiff::TangentialLaw<double> friction(law, 0.3, 0.8);
    fstiff_friction* c_friction = nullptr;
    if (fstiff_friction_make(c_law, 0.3, 0.8, &c_friction)) return 1;
    good &= compare(
        "first slip",
        [&](Numbers& k) {
            for (std::size_t i = 0; i < count; ++i) k[i] = friction.first_slip(separations[i], 1e-7).stiffness;
        },
        [&](Numbers& k) {
            for (std::size_t i = 0; i < count; ++i)
                fstiff_friction_first_slip(c_friction, separations[i], 1e-7, nullptr, &k[i]);
        });
    good &= compare(
        "step in friction",
        [&](Numbers& k) {
            fstiff::SlipState<double, 2> after;
            for (std::size_t i = 0; i < count; ++i)
                k[i] = friction.step({.separation = separations[i]}, separations[i], {1e-7, 0}, after).tangent(1, 1);
        },
        [&](Numbers& k) {
            double tangent[9];
            const double slip[2]{1e-7, 0};
            fstiff_slip before{}, after{};
            before.size = after.size = sizeof before;
            for (std::size_t i = 0; i < count; ++i) {
                before.separation = separations[i];
                fstiff_friction_step(c_friction, &before, separations[i], slip, &after, nullptr, nullptr, tangent);
                k[i] = tangent[4];
            }
        });
    fstiff_friction_free(c_friction);
    fstiff_law_free(c_law);
    fstiff_contact_free(contact);
    return good ? 0 : 1;
}
