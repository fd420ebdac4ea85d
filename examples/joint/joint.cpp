// SPDX-License-Identifier: BSD-3-Clause
// A bolted joint: a mass on two rough faces that a bolt presses together.
//
//     m x'' + p(d0 - x) A + k_b x = F_0 + F          d0, x: separation under the preload, approach from there
//     at rest:   p(d0) A = F_0                       f = sqrt((s(d0) A + k_b) / m) / (2 pi),  s = -dp/dd
//
// The faces are those of the fine sand-blasted steel of Buczkowski, Kleiber and Starzynski, Arch. Mech. 66 (2014),
// under the law of Hertz, whose K is the slope s. The program prints the frequency against the preload; then it presses
// the joint with a static force and prints the steps of Newton's method, which squares its error each time because the
// tangent of the tabulated law is the exact derivative of the pressure that it returns.
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace {

constexpr double mass = 0.5;            // [kg]
constexpr double area = 195e-6;         // nominal, of the faces [m^2]
constexpr double bolt_stiffness = 5e7;  // [N/m]

using Law = fstiff::ContactLaw<double>;

Law tabulated_law() {
    const fstiff::Roughness<double> surface{.rms_height = 0.832e-6, .peak_radius = 40e-6, .peak_density = 500e6};
    const auto peaks = fstiff::PeakDistribution<double>::exponential(std::numbers::pi / 3);
    const fstiff::RoughContact contact(surface, peaks, fstiff::HertzLaw<double>{}, 112.6e9);
    // a contact that opens or is pressed harder than the range goes on smoothly: a loop never meets a refusal
    return Law::tabulate(contact,
                         {.min_pressure = 1e4, .max_pressure = 1e9, .outside = fstiff::OutsideRange::extrapolate});
}

/// Frequency of small oscillations about the preload [Hz].
double frequency(const Law& law, double preload) {
    const double stiffness = law.slope_at_separation(law.separation(preload / area)) * area + bolt_stiffness;
    return std::sqrt(stiffness / mass) / (2 * std::numbers::pi);
}

/// The approaches [m] that Newton's method passes, from 0 to the equilibrium under preload and force [N].
std::vector<double> newton(const Law& law, double preload, double force) {
    const double begin = law.separation(preload / area);
    std::vector<double> steps{0};
    for (double correction = 1; std::abs(correction) > 1e-15 && steps.size() < 20;) {
        const double x = steps.back();
        const auto [pressure, slope] = law.tangent_at_separation(begin - x);
        correction = (preload + force - pressure * area - bolt_stiffness * x) / (slope * area + bolt_stiffness);
        steps.push_back(x + correction);
    }
    return steps;
}

}  // namespace

int main() {
    const Law law = tabulated_law();
    std::printf("preload [N]  pressure [MPa]  frequency [Hz]\n");
    for (const double preload : {20.0, 200.0, 2000.0, 20000.0})
        std::printf("%11.0f  %14.3f  %14.1f\n", preload, preload / area * 1e-6, frequency(law, preload));

    const double preload = 2000, force = 500;
    const std::vector<double> steps = newton(law, preload, force);
    const double solution = steps.back();
    std::printf("\n%.0f N more on a preload of %.0f N: approach %.6f um\n", force, preload, 1e6 * solution);
    std::printf("step  error [m]  error/(error before)^2 [1/m]\n");
    double before = 0;
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        const double error = std::abs(steps[i] - solution);
        if (error < 1e-17) break;  // rounding is left
        if (i == 0)
            std::printf("%4zu    %7.0e\n", i, error);
        else
            std::printf("%4zu    %7.0e  %.1e\n", i, error, error / (before * before));
        before = error;
    }
    return 0;
}
