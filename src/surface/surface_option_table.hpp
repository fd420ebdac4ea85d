// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The table of the options of a measured surface: from its rows come the keys of a scene, the options of the command
// line, the inputs of JSON documents, the keywords of Python and the table of docs/measurement.md.

#include "surface/surface_options.hpp"

#include <fstiff/profile/profile_form.hpp>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace fstiff::surface {

/// What is read.
enum class SurfaceKind { profile, map, any };

/// Purpose of an option; the command line lists them in this order.
enum class OptionGroup {
    file,  ///< any file
    step,  ///< of a file or of an array
    file_of_profile,
    form_of_profile,
    step_of_map,  ///< of a file or of an array
    file_of_map,
    cleaning,
    cleaning_of_map,
    form,
    filter,
    estimate,  ///< of the parameters: of the commands that estimate them
};

/// The field of an option, whose type is the kind of its value.
using SurfaceField =
    std::variant<std::string SurfaceOptions::*, Amount SurfaceOptions::*, int SurfaceOptions::*,
                 double SurfaceOptions::*, bool SurfaceOptions::*, io::SurfaceFormat SurfaceOptions::*,
                 std::optional<io::X3pIncrement> SurfaceOptions::*, CutOffFilter SurfaceOptions::*,
                 PeakSource SurfaceOptions::*, LineAlignment SurfaceOptions::*, ScanAxis SurfaceOptions::*>;

/// When an option is in a JSON document.
enum class Echo { always, if_not_default };

/// One option.
struct SurfaceOptionRow {
    std::string_view key;  ///< of a scene and of Python; with dashes, of the command line
    OptionGroup group;
    SurfaceField field;
    Echo echo;
    std::string_view help;
    struct More {
        std::string_view help_of_profile{}, help_of_map{};  ///< where only these are read, and it is another
        int low = 0, high = 0;                              ///< of a number, both allowed
        request::Form form = request::Form::plain;
        std::vector<std::string_view> (*words)(SurfaceKind) = nullptr;  ///< of a text: those of the command line
        std::string_view flag{}, json{};  ///< its names on the command line and in documents, where they are others
        std::string (*more_help)() = nullptr;  ///< the end of its help, where it is a list
    } more{};

    [[nodiscard]] std::string flag_name() const;
    [[nodiscard]] std::string_view json_name() const { return more.json.empty() ? key : more.json; }
    /// Whether a command that reads \p kind has a use for it.
    [[nodiscard]] bool is_for(SurfaceKind kind) const;
    /// Whether it has no meaning for heights in memory.
    [[nodiscard]] bool is_of_file() const;
    /// Its help, range and words where \p kind is read.
    [[nodiscard]] Field field_for(SurfaceKind kind) const;
    /// \p call(options.*field), with the type of the field.
    template <class Options, class Call>
    decltype(auto) visit(Options& options, const Call& call) const {
        return std::visit([&](auto member) -> decltype(auto) { return call(options.*member); }, field);
    }
    /// Whether \p a and \p b hold the same of it.
    [[nodiscard]] bool has_same(const SurfaceOptions& a, const SurfaceOptions& b) const {
        return std::visit([&](auto member) { return a.*member == b.*member; }, field);
    }
};

/// All options, in the order of a scene's keys.
[[nodiscard]] std::span<const SurfaceOptionRow> surface_option_table();
/// The row of \p key. \throws std::logic_error for a key that is none.
[[nodiscard]] const SurfaceOptionRow& surface_option(std::string_view key);

template <class Take>
void SurfaceOptions::each_field(Take take) {
    take("file", file, Field{.form = request::Form::file});
    for (const SurfaceOptionRow& row : surface_option_table())
        row.visit(*this, [&](auto& to) { take(row.key, to, row.field_for(SurfaceKind::any)); });
}

/// Columns of a profile of text, as io/number_table.hpp bounds them.
inline constexpr int most_columns = static_cast<int>(io::detail::max_profile_columns);

/// \p key with dashes in place of underscores.
[[nodiscard]] std::string with_dashes(std::string_view key);
/// Name of the option of \p key in messages: "reflection_error", or after the prefix of a command line
/// "--reflection-error".
[[nodiscard]] std::string option_name(std::string_view prefix, std::string_view key);

}  // namespace fstiff::surface
