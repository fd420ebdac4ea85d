// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The one exception of fstiff, and the one way to raise it.
///
/// Arguments are checked at the public border only. What is thrown names the parameter, the value it had and the values
/// that are allowed, in one sentence that a command can print as it is.

#include <fstiff/core/concepts.hpp>
#include <fstiff/core/config.hpp>
#include <fstiff/core/text.hpp>

#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace fstiff {

/// An argument or a datum outside the range that the model or the method allows.
class domain_error : public std::domain_error {
public:
    using std::domain_error::domain_error;
};

namespace detail {

/// Out of line and rarely called: one copy of each in a program, however many checks it has.
/// \throws domain_error "<parameter> = <value>: must be <allowed>".
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse(std::string_view parameter, const std::string& value,
                                                          std::string_view allowed) {
    throw domain_error(std::string(parameter) + " = " + value + ": must be " + std::string(allowed));
}
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse(std::string_view parameter, double value, int digits,
                                                          std::string_view allowed) {
    refuse(parameter, rounded_text(value, digits), allowed);
}
/// A template, so that only programs that compute in long double hold its digits.
template <Real T>
[[noreturn, gnu::cold, gnu::noinline]] void refuse(std::string_view parameter, T value, std::string_view allowed) {
    constexpr int digits = std::numeric_limits<T>::digits10;
    if constexpr (std::is_same_v<T, long double>)
        refuse(parameter, rounded_text(value, digits), allowed);
    else
        refuse(parameter, static_cast<double>(value), digits, allowed);
}

}  // namespace detail

/// Throws domain_error "<parameter> = <value>: must be <allowed>" unless \p satisfied.
/// The comparison that makes \p satisfied should be false for NaN, so that NaN is refused with the rest.
template <Real T>
constexpr void require(bool satisfied, std::string_view parameter, T value, std::string_view allowed) {
    if (!satisfied) detail::refuse(parameter, value, allowed);
}

/// Throws unless \p value is finite and greater than zero.
template <Real T>
constexpr void require_positive(std::string_view parameter, T value) {
    require(value > T(0) && value <= std::numeric_limits<T>::max(), parameter, value, "finite and greater than 0");
}

}  // namespace fstiff
