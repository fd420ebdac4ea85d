// SPDX-License-Identifier: BSD-3-Clause
// Integrals over the peaks of a function of Python, which is called once for all nodes of a pass.
#include "module.hpp"

#include <fstiff/peaks/tensor_integrals.hpp>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>

#include <optional>
#include <tuple>

namespace fstiff::python {
namespace {

using Eight = Eigen::Array<double, 8, 1>;

/// A pass over the nodes: a visit writes them down, and the rule then takes the values in the same order.
struct Pass {
    nb::callable function;
    std::optional<nb::callable> kink;
    bool visited = false;
    std::vector<double> excess{}, curvature{}, values{}, criticals{};
    std::size_t next = 0, next_critical = 0;
};

template <bool kinked, NodeClustering of>
struct PassFunction {
    static constexpr NodeClustering axis = of;
    Pass& pass;

    double critical(double t) const requires kinked {
        if (pass.visited) return pass.criticals.at(pass.next_critical++);
        return pass.criticals.emplace_back(nb::cast<double>((*pass.kink)(t)));
    }
    Eight operator()(const Eight& excess, double t) const {
        if (!pass.visited) {
            pass.excess.insert(pass.excess.end(), excess.data(), excess.data() + 8);
            pass.curvature.insert(pass.curvature.end(), 8, t);
            return Eight::Zero();
        }
        const Eight values = Eigen::Map<const Eight>(&pass.values.at(pass.next));
        pass.next += 8;
        return values;
    }
    template <class Visit>
    void at_once(const Visit& visit) const {
        pass = {.function = pass.function, .kink = pass.kink};
        visit();
        const auto values = nb::cast<In>(pass.function(NewArray(std::span<const double>(pass.excess)).take(),
                                                       NewArray(std::span<const double>(pass.curvature)).take()));
        pass.values.assign(values.data(), values.data() + values.size());
        pass.visited = true;
    }
};

std::tuple<double, double, int> integral(const nb::callable& function, const std::optional<nb::callable>& kink,
                                         bool kinks_unknown, double r, double theta, double eta, double tolerance) {
    Pass pass{.function = function, .kink = kink};
    const PeakDistribution<double> peaks(r, theta);
    const TensorOptions<double> options{.relative_tolerance = tolerance};
    const auto found = kink ? peak_integral(PassFunction<true, NodeClustering::graded>{pass}, peaks, eta, options)
                       : kinks_unknown
                           ? peak_integral(PassFunction<false, NodeClustering::rough>{pass}, peaks, eta, options)
                           : peak_integral(PassFunction<false, NodeClustering::graded>{pass}, peaks, eta, options);
    return {found.value, found.error, found.evaluations};
}

}  // namespace

void add_integrals(nb::module_& m) {
    m.def("peak_integral", &integral, nb::arg("function"), nb::arg("kink").none(), nb::arg("kinks_unknown"),
          nb::arg("r"), nb::arg("theta"), nb::arg("eta"), nb::arg("relative_tolerance"));
}

}  // namespace fstiff::python
