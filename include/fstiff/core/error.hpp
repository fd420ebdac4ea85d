// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The one exception of fstiff, and the one way to raise it.
///
/// Arguments are checked at the public border only. What is thrown names the parameter, the value it had and the values
/// that are allowed, in one sentence that a command can print as it is.

#include <fstiff/core/concepts.hpp>
#include <fstiff/core/config.hpp>

#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fstiff {

/// An argument or a datum outside the range that the model or the method allows.
class domain_error : public std::domain_error {
public:
    using std::domain_error::domain_error;
};

namespace detail {

/// \throws domain_error "<parameter> = <value>: must be <allowed>".
template <Real T>
[[noreturn]] void refuse(std::string_view parameter, T value, std::string_view allowed) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(std::numeric_limits<T>::digits10);
    text << parameter << " = " << value << ": must be " << allowed;
    throw domain_error(text.str());
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
