// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Windows that heights are multiplied by before their spectrum is computed.
///
///     hann: w_i = sin^2(pi (i + 1/2)/N)      none: w_i = 1           i = 0 ... N-1
///
/// Without a window the step between the two ends of a measured surface appears as roughness.
///
/// Reference   Harris, Proc. IEEE 66 (1978) 51.
/// Units       none
/// Valid       at least one point
/// Accuracy    2 ulp (tests/surface/spectrum_window_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/math/root.hpp>
#include <fstiff/surface/moments.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace fstiff { inline namespace v0_1 {

/// Window that the heights are multiplied by before the transform.
enum class SpectrumWindow {
    hann,  ///< for measured surfaces
    none   ///< for surfaces that repeat themselves
};
template <>
inline constexpr auto enum_names<SpectrumWindow> = detail::name_list<SpectrumWindow>({{SpectrumWindow::hann, "hann"},
                                                                                      {SpectrumWindow::none, "none"}});

namespace detail {

/// Weights w_i for \p points.
template <Real T>
[[nodiscard]] T window_weight(SpectrumWindow window, std::size_t i, std::size_t points) {
    if (window == SpectrumWindow::none) return T(1);
    const T sine = std::sin(std::numbers::pi_v<T> * (static_cast<T>(i) + T(0.5)) / static_cast<T>(points));
    return sine * sine;
}

}  // namespace detail

}}  // namespace fstiff
