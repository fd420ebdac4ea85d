// SPDX-License-Identifier: BSD-3-Clause
// The kernel in two dimensions with laws of a user: smooth ones, and one with a kink.
#include "methods.hpp"
#include "row.hpp"

namespace {

using namespace bench;
using fstiff::NodeClustering;

/// "kernel/<law>/<tolerance>", right within \p slack tolerances.
template <NodeClustering axis, class Law>
void law_rows(const std::string& name, std::initializer_list<double> wanted, double slack) {
    for (const double tolerance : wanted)
        row_on(law_problems<Law>, "kernel/" + name + "/" + text_of(tolerance), load, tolerance * slack,
               [=](const Problem& p) { return kernel<axis, Law>(p, tolerance); });
}

const Rows rows_of_kernel([] {
    law_rows<NodeClustering::even, HertzByUser>("hertz", {1e-3, 1e-6, 1e-9, 1e-12}, 1);
    law_rows<NodeClustering::even, GradualYield>("gradual_yield", {1e-3, 1e-6, 1e-9, 1e-12}, 1);
    law_rows<NodeClustering::graded, ElasticPlastic>("elastic_plastic", {1e-3, 1e-6, 1e-9, 1e-10, 1e-12}, 1);
    // not given the place of the kink: the error is what the nodes allowed by default leave, and is admitted
    law_rows<NodeClustering::rough, ElasticPlastic>("elastic_plastic_untold", {1e-3, 1e-6}, 1000);
});

}  // namespace
