// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The fields of the sections contact.<law> of a scene: reading, refusals and docs/scene.md follow them.

#include "request/field.hpp"
#include "scene/scene.hpp"

#include <fstiff/profile/profile_form.hpp>

#include <array>
#include <string_view>

namespace fstiff::request {
struct Source;
class Section;
}  // namespace fstiff::request

namespace fstiff::scene {

/// The laws that have options.
inline constexpr std::array laws_with_options{LawKind::summits, LawKind::persson, LawKind::boundary_elements};

/// Hands over the options of \p law.
template <class Take>
void each_law_option(LawKind law, detail::LawOptions& options, Take take) {
    using request::Field;
    if (law == LawKind::summits) take("mutual", options.mutual, Field{.form = request::Form::or_number});
    if (law == LawKind::persson) {
        take("gamma", options.gamma, Field{.high = 1, .above_low = true});
        take("spectrum", options.spectrum, Field{});
    }
    if (law == LawKind::boundary_elements) {
        take("points", options.points, Field{.low = 16, .high = 4096});
        take("edges", options.edges, Field{});
        take("hardness", options.hardness, request::positive(io::Dimension::pressure));
    }
}

/// Whether the section of \p law may also be at the root of a scene; its options count for other laws too.
constexpr bool is_shared(LawKind law) { return law == LawKind::persson || law == LawKind::boundary_elements; }

/// Reads the section contact.\p law, or \p law at \p root, into \p scene. Of a section that is not shared the
/// defaults are recorded.
void read_law_options(request::Source& source, const request::Section& root, LawKind law, Scene& scene);

}  // namespace fstiff::scene
