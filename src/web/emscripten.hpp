// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Included by cmake/web.cmake before every source: what Emscripten 3.1.6 (Debian 12) lacks.
#if __cplusplus >= 202002L
#include <version>

#if _LIBCPP_VERSION < 14000
#include <type_traits>
namespace std {
template <class To, class From>
requires(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>) constexpr To
    bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}
}  // namespace std
#endif
#endif
