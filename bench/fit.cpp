// SPDX-License-Identifier: BSD-3-Clause
// Whole fits of K(p).
#include "row.hpp"

#include "support/normal.hpp"
#include "support/paper.hpp"

#include <fstiff/identify/identify.hpp>

#include <cmath>

namespace {

using namespace bench;
using fstiff::ContactParameters, fstiff::Identification, fstiff::Observation, fstiff::Parameter;

const ContactParameters<double> sand_blasted{.rms_height = test::sand_blasted_fine.rms_height,
                                             .peak_radius = test::sand_blasted_fine.peak_radius,
                                             .peak_density = test::sand_blasted_fine.peak_density,
                                             .fractal_dimension = test::sand_blasted_fine.fractal_dimension,
                                             .effective_modulus = 112.6e9,
                                             .r = 0.6,
                                             .theta = 1.1,
                                             .offset = 1e5};

/// 30 points from 0.5 to 50 MPa.
struct Case {
    std::vector<Parameter> wanted;
    ContactParameters<double> truth = sand_blasted, start = sand_blasted;
    std::vector<Observation<double>> data;

    template <class Law>
    Case(std::vector<Parameter> parameters, const Law& law, double noise) : wanted(std::move(parameters)) {
        for (const Parameter each : wanted) start[each] *= each == Parameter::offset ? 0 : 0.9;
        const fstiff::RoughContact contact(
            fstiff::Roughness<double>{truth.rms_height, truth.peak_radius, truth.peak_density, 0},
            fstiff::PeakDistribution<double>(truth.r, truth.theta), law(truth.fractal_dimension),
            truth.effective_modulus);
        test::Normal normal(1);
        for (int i = 0; i < 30; ++i) {
            const double p = 0.5e6 * std::pow(100.0, i / 29.0),
                         stiffness = contact.at_pressure(p + truth.offset, fstiff::Quantity::stiffness).stiffness.value;
            data.push_back({p, stiffness * (1 + noise * normal()), 0.01 * stiffness});
        }
    }
};

/// A fit of data without noise, whose error is that of the parameters; its time is that with 1 % of noise.
template <class Law>
void fit_row(const std::string& name, const std::vector<Parameter>& wanted, const Law& law) {
    const auto fit = [=](const Case& of) { return identify(of.data, of.wanted, of.start, law); };
    verified_row(
        "fit/" + name, 1e-8,
        [=] {
            const Case exact(wanted, law, 0);
            const Identification<double> found = fit(exact);
            AccuracyCollector collector;
            for (const Parameter each : wanted) collector.add(found.optimum[each], exact.truth[each]);
            collector.add_cost(found.evaluations);
            return collector.accuracy();
        },
        [=](benchmark::State& state) {
            const Case noisy(wanted, law, 0.01);
            for (auto _ : state) benchmark::DoNotOptimize(fit(noisy).chi_squared);
        });
}

const Rows rows_of_fit([] {
    using enum Parameter;
    const auto hertz = [](double) { return fstiff::HertzLaw<double>{}; };
    const auto fractal = [](double dimension) { return fstiff::FractalLaw<double>(dimension); };
    fit_row("hertz/sigma,R", {rms_height, peak_radius}, hertz);
    fit_row("hertz/Dp,offset", {peak_density, offset}, hertz);
    fit_row("fractal/sigma,Dp", {rms_height, peak_density}, fractal);
    fit_row("fractal/sigma,D,offset", {rms_height, fractal_dimension, offset}, fractal);
    fit_row("fractal/sigma,R,theta", {rms_height, peak_radius, theta}, fractal);
});

}  // namespace
