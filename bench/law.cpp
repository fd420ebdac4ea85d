// SPDX-License-Identifier: BSD-3-Clause
// A whole contact: the separation for a pressure, and the tabulated law.
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/hybrid_of_map.hpp>
#include "methods.hpp"
#include "row.hpp"

#include "support/half_space_maps.hpp"

namespace {

using namespace bench;

/// Largest error of \p value_at(point) against \p truth(point) over the points of the law.
template <class ValueAt, class Truth>
Accuracy law_accuracy(double evaluations, const ValueAt& value_at, const Truth& truth) {
    AccuracyCollector collector;
    for (const LawPoint& point : law_points()) {
        collector.add(value_at(point), truth(point));
        collector.add_cost(evaluations);
    }
    return collector.accuracy();
}

constexpr auto true_pressure = [](const LawPoint& at) { return at.pressure; };
constexpr auto true_stiffness = [](const LawPoint& at) { return at.stiffness; };

Accuracy worse(const Accuracy& a, const Accuracy& b) { return a.largest >= b.largest ? a : b; }

struct Gaps {
    Eigen::ArrayXd pressure, separation, stiffness, pressure_out;
    Gaps() {
        const auto size = static_cast<Eigen::Index>(law_points().size());
        for (auto* array : {&pressure, &separation, &stiffness, &pressure_out}) array->resize(size);
        for (Eigen::Index i = 0; i < size; ++i) {
            pressure[i] = law_points()[static_cast<std::size_t>(i)].pressure;
            separation[i] = law_points()[static_cast<std::size_t>(i)].separation;
        }
    }
};

/// The table of hybrid of a map, whose K has a kink where each summit touches, and that law under 200 pressures from
/// 1.1e-4 to 0.0187 E.
struct LawOfMap {
    fstiff::ContactLaw<double> table;
    std::vector<LawPoint> points;
};
const LawOfMap& law_of_map() {
    static const LawOfMap kept = [] {
        const auto hybrid = hybrid_of_map(test::half_space_map("gaussian"), 1.0, fstiff::Edges::periodic);
        LawOfMap out{fstiff::ContactLaw<double>::tabulate(hybrid, {.min_pressure = 1e-4, .max_pressure = 0.02}), {}};
        for (int i = 0; i < 200; ++i) {
            const double p = 1.1e-4 * std::pow(170.0, i / 199.0);
            const auto at = hybrid.at_pressure(p, Quantity::stiffness | Quantity::separation);
            out.points.push_back({p, at.separation.value, at.stiffness.value});
        }
        return out;
    }();
    return kept;
}

const Rows rows_of_law_of_map([] {
    const auto accuracy = [](const auto& value_at) {
        AccuracyCollector collector;
        for (const LawPoint& at : law_of_map().points) collector.add(value_at(at), at.stiffness);
        return collector.accuracy();
    };
    const auto row = [=](const char* name, const auto& value_at, const auto& look_up) {
        verified_row(
            name, 1e-3, [=] { return accuracy(value_at); },
            [=](benchmark::State& state) {
                time_elements(state, law_of_map().points.size(),
                              [&, &law = law_of_map()](std::size_t i) { return look_up(law.table, law.points[i]); });
            });
    };
    const auto stiffness = [](const auto& law, const LawPoint& at) { return law.stiffness(at.pressure); };
    row(
        "law_of_map/stiffness_of_pressure/scalar",
        [=](const LawPoint& at) { return stiffness(law_of_map().table, at); }, stiffness);
    const auto of_gap = [](const auto& law, const LawPoint& at) { return law.at_separation(at.separation); };
    row(
        "law_of_map/pressure_and_stiffness_of_gap/scalar",
        [=](const LawPoint& at) { return of_gap(law_of_map().table, at).stiffness; }, of_gap);
});

const Rows rows_of_law([] {
    constexpr double law_bound = 1e-10;
    const auto law = []() -> const fstiff::ContactLaw<double>& {
        static const auto compiled = tabulated_law();
        return compiled;
    };
    const auto size = [] { return law_points().size(); };

    verified_row(
        "law/stiffness_of_pressure/scalar", law_bound,
        [=] {
            return law_accuracy(
                0, [&](const LawPoint& at) { return law().stiffness(at.pressure); }, true_stiffness);
        },
        [=](benchmark::State& state) {
            time_elements(state, size(), [&l = law(), &points = law_points()](std::size_t i) {
                return l.stiffness(points[i].pressure);
            });
        });
    // the next pressure waits for this stiffness: latency, as in a Newton iteration
    verified_row(
        "law/stiffness_of_pressure/chained", law_bound,
        [=] {
            return law_accuracy(
                0, [&](const LawPoint& at) { return law().stiffness(at.pressure); }, true_stiffness);
        },
        [=](benchmark::State& state) {
            const double tiny = 1e-300;
            double last = 0;
            time_elements(state, size(), [&, &l = law(), &points = law_points()](std::size_t i) {
                return last = l.stiffness(points[i].pressure + tiny * last);
            });
        });
    const auto separation_accuracy = [=] {
        return worse(
            law_accuracy(
                0, [&](const LawPoint& at) { return law().at_separation(at.separation).pressure; }, true_pressure),
            law_accuracy(
                0, [&](const LawPoint& at) { return law().at_separation(at.separation).stiffness; }, true_stiffness));
    };
    verified_row("law/pressure_and_stiffness_of_gap/scalar", law_bound, separation_accuracy,
                 [=](benchmark::State& state) {
                     time_elements(state, size(), [&l = law(), &points = law_points()](std::size_t i) {
                         return l.at_separation(points[i].separation);
                     });
                 });
    verified_row(
        "law/stiffness_of_pressure/batch", law_bound,
        [=] {
            Gaps g;
            law().stiffness(g.pressure, g.stiffness);
            return law_accuracy(
                0, [&](const LawPoint& at) { return g.stiffness[&at - law_points().data()]; }, true_stiffness);
        },
        [=](benchmark::State& state) {
            Gaps g;
            while (state.KeepRunningBatch(g.pressure.size())) {
                law().stiffness(g.pressure, g.stiffness);
                benchmark::DoNotOptimize(g.stiffness.data());
                benchmark::ClobberMemory();
            }
        });
    verified_row(
        "law/pressure_and_stiffness_of_gap/batch", law_bound,
        [=] {
            Gaps g;
            law().at_separation(g.separation, g.pressure_out, g.stiffness);
            const auto index = [](const LawPoint& at) { return &at - law_points().data(); };
            return worse(law_accuracy(
                             0, [&](const LawPoint& at) { return g.pressure_out[index(at)]; }, true_pressure),
                         law_accuracy(
                             0, [&](const LawPoint& at) { return g.stiffness[index(at)]; }, true_stiffness));
        },
        [=](benchmark::State& state) {
            Gaps g;
            while (state.KeepRunningBatch(g.separation.size())) {
                law().at_separation(g.separation, g.pressure_out, g.stiffness);
                benchmark::DoNotOptimize(g.stiffness.data());
                benchmark::DoNotOptimize(g.pressure_out.data());
                benchmark::ClobberMemory();
            }
        });
    verified_row(
        "law/compile", law_bound,
        [=] {
            return law_accuracy(
                law().evaluations(), [&](const LawPoint& at) { return law().stiffness(at.pressure); }, true_stiffness);
        },
        [=](benchmark::State& state) {
            const auto contact = sand_blasted_contact();
            for (auto _ : state) {
                const auto compiled = fstiff::ContactLaw<double>::tabulate(
                    contact, {.min_pressure = min_pressure, .max_pressure = max_pressure});
                benchmark::DoNotOptimize(&compiled);
            }
        });

    const auto contact = sand_blasted_contact();
    const auto contact_row = [=](const char* name, Quantity wanted, auto at) {
        verified_row(
            name, 1e-12,
            [=] {
                AccuracyCollector collector;
                for (const LawPoint& point : law_points()) {
                    const auto state = at(contact, point, wanted);
                    collector.add(state.stiffness.value, point.stiffness, state.stiffness.error);
                    collector.add_cost(state.stiffness.evaluations);
                }
                return collector.accuracy();
            },
            [=](benchmark::State& state) {
                time_elements(state, law_points().size(),
                              [&](std::size_t i) { return at(contact, law_points()[i], wanted); });
            });
    };
    const auto at_pressure = [](const auto& c, const LawPoint& p, Quantity wanted) {
        return c.at_pressure(p.pressure, wanted);
    };
    const auto at_separation = [](const auto& c, const LawPoint& p, Quantity wanted) {
        return c.at_separation(p.separation, wanted);
    };
    contact_row("contact/at_pressure/stiffness", Quantity::stiffness, at_pressure);
    contact_row("contact/at_pressure/all", Quantity::all, at_pressure);
    contact_row("contact/at_separation/stiffness", Quantity::stiffness, at_separation);
    contact_row("contact/at_separation/all", Quantity::all, at_separation);
    // the integrals alone, at separation after separation: at_separation less what r and theta fix
    const auto integrator = [] { return fstiff::detail::ContactIntegrator<double>(sand_blasted_contact().peaks()); };
    const auto stiffness_at = [](auto& integrate, const LawPoint& point) {
        const auto j = integrate(point.separation / sand_blasted_contact().rms_height());
        return j.stiffness.value * std::exp(j.log_scale);
    };
    verified_row(
        "contact/integrals_at_separations/all", 1e-13,
        [=] {
            auto integrate = integrator();
            const LawPoint& first = law_points().front();
            const double scale = first.stiffness / stiffness_at(integrate, first);
            return law_accuracy(
                40, [&](const LawPoint& at) { return scale * stiffness_at(integrate, at); }, true_stiffness);
        },
        [=](benchmark::State& state) {
            auto integrate = integrator();
            const double over_rms = 1 / sand_blasted_contact().rms_height();
            time_elements(state, size(), [&, &points = law_points()](std::size_t i) {
                return integrate(points[i].separation * over_rms);
            });
        });
});

}  // namespace
