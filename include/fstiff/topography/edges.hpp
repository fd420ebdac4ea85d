// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// How a map goes on beyond its edges.

#include <fstiff/core/names.hpp>

namespace fstiff { inline namespace v0_1 {

/// Continuation of a map beyond its edges.
enum class Edges {
    mirrored,  ///< reflected at each edge, so that no step arises: for measured maps
    periodic   ///< repeated: for generated maps that repeat themselves
};
template <>
inline constexpr auto enum_names<Edges> = detail::name_list<Edges>({{Edges::mirrored, "mirrored"},
                                                                    {Edges::periodic, "periodic"}});

}}  // namespace fstiff
