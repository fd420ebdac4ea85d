// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Distance of a computed number from the truth: relative, and in units in the last place. Never Approx, which accepts
// five digits.
#include <fstiff/core/error.hpp>

#include <cmath>
#include <concepts>
#include <limits>
#include <string>
#include <string_view>

namespace test {

/// |computed - truth| / |truth|; |computed| where the truth is 0; infinity for NaN, so that no comparison lets it pass.
template <std::floating_point T>
T relative_error(T computed, T truth) {
    const T difference = std::abs(computed - truth);
    const T error = truth == 0 ? difference : difference / std::abs(truth);
    return std::isnan(error) ? std::numeric_limits<T>::infinity() : error;
}

/// relative_error in units of epsilon.
template <std::floating_point T>
T ulps(T computed, T truth) {
    return relative_error(computed, truth) / std::numeric_limits<T>::epsilon();
}

/// Text of the fstiff::domain_error or fstiff::file_error that the call throws, or "" when it does not throw.
template <class Call>
std::string refusal(const Call& call) {
    try {
        call();
    } catch (const fstiff::domain_error& error) {
        return error.what();
    } catch (const fstiff::file_error& error) {
        return error.what();
    }
    return {};
}

/// Whether the call is refused in a sentence that holds \p words.
template <class Call>
bool refused_for(std::string_view words, const Call& call) {
    return refusal(call).find(words) != std::string::npos;
}

}  // namespace test
