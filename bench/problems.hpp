// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The problems that the integrals are timed on, with their true values, and how far a method is from them.
#include <fstiff/core/numbers.hpp>

#include "support/accuracy.hpp"
#include "support/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace bench {

/// One (r, theta, eta) with the true J[0,0], J[3/2,-1/2], J[1/2,-1/2], J[1,-1]: contacts, load, stiffness, area.
struct Problem {
    double r, theta, eta;
    std::array<double, 4> truth;
};

/// The powers (a, b) of Problem::truth, in its order.
inline constexpr std::array<std::array<double, 2>, 4> powers{{{0, 0}, {1.5, -0.5}, {0.5, -0.5}, {1, -1}}};

/// The indices into Problem::truth that a method computes.
using Which = std::vector<std::size_t>;

inline constexpr const char* plain = "plain";
inline constexpr const char* hard = "hard";

/// The problems of tests/data/integrals_<grid>.csv.
inline const std::vector<Problem>& problems(const std::string& grid) {
    static std::map<std::string, std::vector<Problem>> loaded;
    std::vector<Problem>& out = loaded[grid];
    if (!out.empty()) return out;
    const test::Table table("integrals_" + grid + ".csv");
    std::map<std::tuple<double, double, double>, std::array<double, 4>> truths;
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double a = table.input(row, "a");
        const std::size_t which = a == 0 ? 0 : a == 1.5 ? 1 : a == 0.5 ? 2 : 3;
        truths[{table.input(row, "r"), table.input(row, "theta"), table.input(row, "eta")}][which] =
            static_cast<double>(table.number(row, "value"));
    }
    for (const auto& [at, truth] : truths) out.push_back({std::get<0>(at), std::get<1>(at), std::get<2>(at), truth});
    return out;
}

/// What a method returns for a problem: values and error estimates in the order of Problem::truth, and its cost.
struct Values {
    std::array<double, 4> value{};
    std::array<double, 4> error{};  ///< infinity: the method gives none
    long evaluations = 0;           ///< of the integrand
};
inline constexpr std::array<double, 4> no_estimate{
    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

/// Error and cost of a method over a set of problems.
struct Accuracy {
    double largest = 0, median = 0;  ///< relative error; infinity where the method gave NaN
    double evaluations = 0;          ///< mean per problem
    long values = 0;
    long wrong = 0;            ///< values off by more than 1e-6
    long beyond_estimate = 0;  ///< values further from the truth than the estimate of the method, and than 4 ulp
};

class AccuracyCollector {
public:
    void add(double value, double truth, double estimate = std::numeric_limits<double>::infinity()) {
        const double error = test::relative_error(value, truth);
        errors_.push_back(error);
        if (!(error <= 1e-6)) ++found_.wrong;
        if (!(std::abs(value - truth) <=
              std::max(estimate, 4 * std::numeric_limits<double>::epsilon() * std::abs(truth))))
            ++found_.beyond_estimate;
    }
    void add_cost(double evaluations) {
        evaluations_ += evaluations;
        ++calls_;
    }
    [[nodiscard]] Accuracy accuracy() {
        std::sort(errors_.begin(), errors_.end());
        found_.values = static_cast<long>(errors_.size());
        found_.largest = errors_.back();
        found_.median = errors_[errors_.size() / 2];
        found_.evaluations = evaluations_ / static_cast<double>(std::max(calls_, 1L));
        return found_;
    }

private:
    std::vector<double> errors_;
    double evaluations_ = 0;
    long calls_ = 0;
    Accuracy found_;
};

/// \p method takes a Problem and returns Values.
template <class Method>
Accuracy accuracy(const std::vector<Problem>& set, const Which& which, const Method& method) {
    AccuracyCollector collector;
    for (const Problem& problem : set) {
        const Values values = method(problem);
        for (const std::size_t i : which) collector.add(values.value[i], problem.truth[i], values.error[i]);
        collector.add_cost(static_cast<double>(values.evaluations));
    }
    return collector.accuracy();
}

}  // namespace bench
