// SPDX-License-Identifier: BSD-3-Clause
// The three kernels of the contact integrals: one dimension, two dimensions, the paper's 50 x 50 points. A call computes what
// the name says at a new (r, theta, eta) each time: nothing is kept from one call to the next.
#include <fstiff/contact/contact_integrals.hpp>
#include <fstiff/contact/paper_integrals.hpp>
#include <fstiff/contact/tensor_integrals.hpp>

#include "problems.hpp"

namespace {

constexpr fstiff::Estimate<double> not_computed{0, -1, 0};

template <fstiff::Quantity wanted>
bench::Values reduced(const bench::Problem& problem, double tolerance) {
    const auto j = fstiff::contact_integrals(problem.peaks, problem.eta, wanted, {tolerance});
    const auto when = [](fstiff::Quantity quantity, const fstiff::Estimate<double>& value) {
        return fstiff::has(wanted, quantity) ? value : not_computed;
    };
    using enum fstiff::Quantity;
    return {when(contacts, j.contacts), when(pressure, j.load), when(stiffness, j.stiffness), when(real_area, j.area)};
}

/// One value, K's integral, by the two slow kernels.
bench::Values tensor(const bench::Problem& problem, double tolerance) {
    return {not_computed, not_computed, fstiff::tensor_integral(0.5, -0.5, problem.peaks, problem.eta, {tolerance}), not_computed};
}
bench::Values paper(const bench::Problem& problem) {
    return {not_computed, not_computed, fstiff::paper_integral(0.5, -0.5, problem.peaks, problem.eta), not_computed};
}

template <class Method>
void row(const std::string& name, const char* table, double bound, const Method& method) {
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { bench::run(state, table, bound, method); });
}

}  // namespace

int main(int argc, char** argv) {
    using fstiff::Quantity;
    constexpr const char* plain = "integrals_plain.csv";
    constexpr const char* hard = "integrals_hard.csv";
    const auto with = [](auto kernel, double tolerance) {
        return [=](const bench::Problem& problem) { return kernel(problem, tolerance); };
    };
    row("reduced/four/plain/1e-12", plain, 1e-12, with(reduced<Quantity::all>, 1e-12));
    row("reduced/four/plain/1e-03", plain, 1e-2, with(reduced<Quantity::all>, 1e-3));
    row("reduced/stiffness/plain/1e-12", plain, 1e-12, with(reduced<Quantity::stiffness>, 1e-12));
    row("reduced/four/hard/1e-12", hard, 1e-11, with(reduced<Quantity::all>, 1e-12));
    row("tensor/stiffness/plain/1e-12", plain, 1e-12, with(tensor, 1e-12));
    row("tensor/stiffness/plain/1e-03", plain, 1e-2, with(tensor, 1e-3));
    row("paper/stiffness/plain/50x50", plain, 1e-3, paper);
    benchmark::AddCustomContext("compiler", FSTIFF_BENCH_COMPILER);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
