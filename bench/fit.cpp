// SPDX-License-Identifier: BSD-3-Clause
// Whole fits of K(p): with the exact derivatives of the contact, and with differences of its curve.
#include "row.hpp"

#include "support/normal.hpp"
#include "support/paper.hpp"

#include <fstiff/identify/differences.hpp>
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
        std::vector<double> pressures;
        for (int i = 0; i < 30; ++i) pressures.push_back(0.5e6 * std::pow(100.0, i / 29.0));
        std::vector<double> loads = pressures;
        for (double& p : loads) p += truth.offset;
        const std::vector<double> stiffness = curve(law)(truth, loads);
        test::Normal normal(1);
        for (std::size_t i = 0; i < loads.size(); ++i)
            data.push_back({pressures[i], stiffness[i] * (1 + noise * normal()), 0.01 * stiffness[i]});
    }

    template <class Law>
    static auto curve(const Law& law) {
        return [law](const ContactParameters<double>& x, std::span<const double> loads) {
            const fstiff::RoughContact contact(
                fstiff::Roughness<double>{x.rms_height, x.peak_radius, x.peak_density, 0},
                fstiff::PeakDistribution<double>(x.r, x.theta), law(x.fractal_dimension), x.effective_modulus);
            std::vector<double> stiffness;
            for (const double p : loads)
                stiffness.push_back(contact.at_pressure(p, fstiff::Quantity::stiffness).stiffness.value);
            return stiffness;
        };
    }
};

/// \p fit(case) of data without noise, whose error is that of the parameters; its time is that with 1 % of noise.
template <class Law, class Fit>
void fit_row(const std::string& name, const std::vector<Parameter>& wanted, const Law& law, const Fit& fit) {
    verified_row(
        name, 1e-8,
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

template <class Law>
void fit_rows(const std::string& name, const std::vector<Parameter>& wanted, const Law& law) {
    fit_row("fit/exact/" + name, wanted, law,
            [=](const Case& of) { return identify(of.data, of.wanted, of.start, law); });
    fit_row("fit/differences/" + name, wanted, law, [=](const Case& of) {
        return fstiff::detail::identify_by_differences<double>(of.data, of.wanted, of.start, Case::curve(law));
    });
}

const Rows rows_of_fit([] {
    using enum Parameter;
    const auto hertz = [](double) { return fstiff::HertzLaw<double>{}; };
    const auto fractal = [](double dimension) { return fstiff::FractalLaw<double>(dimension); };
    fit_rows("hertz/sigma,R", {rms_height, peak_radius}, hertz);
    fit_rows("hertz/Dp,offset", {peak_density, offset}, hertz);
    fit_rows("fractal/sigma,Dp", {rms_height, peak_density}, fractal);
    fit_rows("fractal/sigma,D,offset", {rms_height, fractal_dimension, offset}, fractal);
    fit_rows("fractal/sigma,R,theta", {rms_height, peak_radius, theta}, fractal);
});

}  // namespace
