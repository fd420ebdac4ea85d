// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The problems that the benchmarks are timed on, with their true values, and the verification that comes before any timing.
#include <fstiff/core/estimate.hpp>
#include <fstiff/peaks/peak_density.hpp>

#include "support/accuracy.hpp"
#include "support/table.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

namespace bench {

/// One (r, theta, eta) with the true J[0,0], J[3/2,-1/2], J[1/2,-1/2], J[1,-1].
struct Problem {
    fstiff::PeakDensity<double> peaks;
    double eta;
    std::array<double, 4> truth;
};

/// The powers (a, b) of Problem::truth, in its order.
inline constexpr std::array<std::array<double, 2>, 4> powers{{{0, 0}, {1.5, -0.5}, {0.5, -0.5}, {1, -1}}};

inline const std::vector<Problem>& problems(const char* table_name) {
    static std::map<std::string, std::vector<Problem>> loaded;
    std::vector<Problem>& out = loaded[table_name];
    if (!out.empty()) return out;
    const test::Table table(table_name);
    std::map<std::tuple<double, double, double>, std::array<double, 4>> truths;
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double a = table.input(row, "a");
        const std::size_t which = a == 0 ? 0 : a == 1.5 ? 1 : a == 0.5 ? 2 : 3;
        truths[{table.input(row, "r"), table.input(row, "theta"), table.input(row, "eta")}][which] =
            static_cast<double>(table.number(row, "value"));
    }
    for (const auto& [at, truth] : truths)
        out.push_back({fstiff::PeakDensity<double>(std::get<0>(at), std::get<1>(at)), std::get<2>(at), truth});
    return out;
}

using Values = std::array<fstiff::Estimate<double>, 4>;

/// Error and cost of \p method, which takes a Problem and returns Values (error < 0 marks a value that it does not compute).
struct Accuracy {
    double largest = 0, median = 0, evaluations = 0;
};

template <class Method>
Accuracy accuracy(const std::vector<Problem>& set, const Method& method) {
    std::vector<double> errors;
    double evaluations = 0;
    for (const Problem& problem : set) {
        const Values values = method(problem);
        int most = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (values[i].error < 0) continue;
            errors.push_back(test::relative_error(values[i].value, problem.truth[i]));
            most = std::max(most, values[i].evaluations);
        }
        evaluations += most;
    }
    std::sort(errors.begin(), errors.end());
    return {errors.back(), errors[errors.size() / 2], evaluations / static_cast<double>(set.size())};
}

/// Verifies \p method on every problem of the table, then times one call per problem in turn.
/// The row is marked as an error, and not timed, when an error exceeds \p bound.
template <class Method>
void run(benchmark::State& state, const char* table_name, double bound, const Method& method) {
    const std::vector<Problem>& set = problems(table_name);
    const Accuracy found = accuracy(set, method);
    state.counters["rel_err_max"] = found.largest;
    state.counters["rel_err_median"] = found.median;
    state.counters["evaluations"] = found.evaluations;
    if (!(found.largest <= bound)) {
        state.SkipWithError(("relative error " + std::to_string(found.largest) + " is beyond the bound of this row").c_str());
        return;
    }
    std::size_t next = 0;
    for (auto _ : state) {
        Values values = method(set[next]);
        benchmark::DoNotOptimize(values);
        if (++next == set.size()) next = 0;
    }
}

}  // namespace bench
