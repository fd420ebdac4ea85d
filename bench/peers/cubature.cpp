// SPDX-License-Identifier: BSD-3-Clause
// Peer: the p-adaptive rule of cubature, four integrals at once in the window and the variables of window.hpp.
#include "../methods.hpp"
#include "../row.hpp"
#include "window.hpp"

#include <cubature.h>

namespace {

using namespace bench;

struct Call {
    Window window;
    long evaluations;
};

int vector_integrand(unsigned, std::size_t count, const double* at, void* data, unsigned, double* out) {
    auto& call = *static_cast<Call*>(data);
    const Window& w = call.window;
    call.evaluations += static_cast<long>(count);
    for (std::size_t i = 0; i < count; ++i, at += 2, out += 4) {
        const double s = w.s_from + (w.s_to - w.s_from) * at[0];
        const double t = s * s, x = w.x(t);
        const auto row = w.row(x);
        const double u = row.from + (row.to - row.from) * at[1];
        const double g = (row.to - row.from) * std::erf(w.k * t) * u * std::exp(w.exponent(t, x, u * u));
        out[0] = s * g;
        out[1] = g * u * u * u;
        out[2] = g * u;
        out[3] = s > 0 ? g * u * u / s : 0;
    }
    return 0;
}

Values adaptive(const Problem& p, const Setting& with) {
    Call call{Window(p, with.depth, with.depth), 0};
    const double from[] = {0, 0}, to[] = {1, 1};
    double value[4], error[4];
    const int failed =
        pcubature_v(4, vector_integrand, &call, 2, from, to, 1000000, 0, with.outer, ERROR_INDIVIDUAL, value, error);
    Values out{{}, no_estimate, call.evaluations};
    for (std::size_t q = 0; q < 4; ++q)
        out.value[q] = failed != 0
                           ? std::numeric_limits<double>::quiet_NaN()
                           : value[q] * call.window.factor(powers[q][0]) * (call.window.s_to - call.window.s_from);
    return out;
}

const Rows rows_of_cubature([] {
    for (const Setting& with :
         {Setting{1e-3, 10, 1e-2, 0}, {1e-6, 32, 1e-3, 0}, {1e-9, 26, 1e-5, 0}, {1e-12, 32, 1e-7, 0}})
        row("cubature", "four", plain, text_of(with.tolerance), four, with.tolerance,
            [=](const Problem& p) { return adaptive(p, with); });
});

}  // namespace
