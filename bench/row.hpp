// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A row of the benchmark program: it verifies, then it times. One source file a subject adds its rows when the program
// starts, so that a peer that was not found at configure time is simply not linked.
#include "problems.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

namespace bench {

/// `const Rows rows_of_kernel([] { row(...); });`, named after its file: files are compiled together
struct Rows {
    template <class Add>
    explicit Rows(const Add& add) {
        add();
    }
};

/// How many rows were refused that should have been right: the program's exit code.
inline int& refused_rows() {
    static int count = 0;
    return count;
}

enum class Expect {
    right,
    wrong  ///< known to fail on these problems: shown with its errors and without a time, and no failure of the program
};

/// A row whose \p verify() returns an Accuracy, computed once, and whose \p body(state) is the timed loop. It is not
/// timed when the largest error exceeds \p bound.
template <class Verify, class Body>
void verified_row(const std::string& name, double bound, const Verify& verify, const Body& body,
                  Expect expect = Expect::right) {
    const auto kept = std::make_shared<std::optional<Accuracy>>();
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        const bool first = !*kept;
        if (first) *kept = verify();
        const Accuracy& found = **kept;
        if (!(found.largest <= bound)) {
            if (first && expect == Expect::right) ++refused_rows();
            std::ostringstream
                why;  // the counters of a row with an error are not written: tools/make_benchmarks.py reads this
            why << "not timed: rel_err_max=" << found.largest << " rel_err_median=" << found.median
                << " evaluations=" << found.evaluations << " values=" << found.values << " wrong=" << found.wrong
                << " bound=" << bound;
            state.SkipWithError(why.str().c_str());
            return;
        }
        body(state);
        state.counters["rel_err_max"] = found.largest;
        state.counters["rel_err_median"] = found.median;
        state.counters["evaluations"] = found.evaluations;
        state.counters["values"] = static_cast<double>(found.values);
        state.counters["wrong"] = static_cast<double>(found.wrong);
        state.counters["beyond_estimate"] = static_cast<double>(found.beyond_estimate);
    });
}

/// Sixteen orders of \p size problems, so that no branch predictor learns the sequence by heart.
inline const std::vector<std::vector<std::size_t>>& orders(std::size_t size) {
    static std::map<std::size_t, std::vector<std::vector<std::size_t>>> all;
    auto& out = all[size];
    std::uint64_t state = 1;
    while (out.size() < 16) {
        std::vector<std::size_t> order(size);
        std::iota(order.begin(), order.end(), std::size_t{0});
        for (std::size_t i = size; i > 1; --i) {
            state = state * 6364136223846793005U + 1442695040888963407U;
            std::swap(order[i - 1], order[(state >> 33) % i]);
        }
        out.push_back(std::move(order));
    }
    return out;
}

/// Times \p call(i) for the elements i of a set of \p size in changing order; the time shown is that of one element.
template <class Call>
void time_elements(benchmark::State& state, std::size_t size, const Call& call) {
    const auto& order = orders(size);
    std::size_t pass = 0;
    while (state.KeepRunningBatch(static_cast<benchmark::IterationCount>(size)))
        for (const std::size_t i : order[pass++ % order.size()]) {
            auto result = call(i);
            benchmark::DoNotOptimize(result);
        }
}

/// Median over the problems of the least of five times of a call [ns], each the mean of 20.
template <class Call>
double median_time(std::size_t size, const Call& call) {
    using Clock = std::chrono::steady_clock;
    std::vector<double> times(size, std::numeric_limits<double>::infinity());
    for (int repetition = 0; repetition < 5; ++repetition)
        for (std::size_t i = 0; i < size; ++i) {
            const auto begin = Clock::now();
            for (int n = 0; n < 20; ++n) {
                auto result = call(i);
                benchmark::DoNotOptimize(result);
            }
            times[i] = std::min(times[i], std::chrono::duration<double, std::nano>(Clock::now() - begin).count() / 20);
        }
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(size / 2), times.end());
    return times[size / 2];
}

/// \p method (from Problem to Values) on the problems that \p set() returns; ns_median_problem is the median over them.
template <class Set, class Method>
void row_on(const Set& set, const std::string& name, const Which& which, double bound, Method method,
            Expect expect = Expect::right) {
    verified_row(
        name, bound, [=] { return accuracy(set(), which, method); },
        [=](benchmark::State& state) {
            const std::vector<Problem>& all = set();
            const auto call = [&](std::size_t i) { return method(all[i]); };
            time_elements(state, all.size(), call);
            // of interest where the cost differs from problem to problem, and cheap enough there
            if (&all == &problems(hard) && state.iterations() > static_cast<benchmark::IterationCount>(10 * all.size()))
                state.counters["ns_median_problem"] = median_time(all.size(), call);
        },
        expect);
}

/// The same on a grid of tests/data. The rows are named integrals/<method>/<what>/<grid>/<setting>.
template <class Method>
void row(const std::string& method_name, const std::string& what, const char* grid, const std::string& setting,
         const Which& which, double bound, Method method, Expect expect = Expect::right) {
    const auto set = [grid]() -> const std::vector<Problem>& { return problems(grid); };
    row_on(set, "integrals/" + method_name + "/" + what + "/" + grid + "/" + setting, which, bound, method, expect);
}

}  // namespace bench
