// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A prepared surface with its form of least squares, which parameters of drawings and spectra have by their standards,
/// where K takes that of the upper half (math/upper_half.hpp).
///
/// Reference   ISO 21920-2:2021, ISO 25178-2:2012 (association by least squares)
/// Units       heights [m]
/// Valid       results of prepare()
/// Accuracy    of the form; next to the ends of a filtered profile that of the filter (tests/cli/spectrum_test.cpp)

#include <fstiff/measure/prepare.hpp>

#include <utility>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// \p prepared with the line or parabola of least squares, which parameters of drawings and spectra have, where it is
/// that of the upper half.
template <Real T>
[[nodiscard]] PreparedProfile<T> by_least_squares(PreparedProfile<T> prepared) {
    if (!prepared.settled) return prepared;
    prepared.settled = false;
    prepared.profile = detrend(prepared.profile, prepared.removed);
    if (prepared.unfiltered) prepared.unfiltered = detrend(*prepared.unfiltered, prepared.removed);
    prepared.rms_levelled = prepared.rms = rms_height(prepared.profile);
    prepared.rms_gradient = rms_gradient_of(prepared.profile);
    return prepared;
}
/// The same of the plane or quadratic surface of a map.
template <Real T>
[[nodiscard]] PreparedMap<T> by_least_squares(PreparedMap<T> prepared) {
    if (!prepared.settled) return prepared;
    prepared.settled.reset();
    prepared.map = remove_form(prepared.map, prepared.removed);
    prepared.rms_levelled = rms_height(prepared.map);
    prepared.areal = areal_statistics(prepared.map);
    prepared.rms = prepared.areal.rms_height;
    return prepared;
}

}  // namespace detail

}}  // namespace fstiff
