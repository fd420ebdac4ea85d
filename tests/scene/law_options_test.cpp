// SPDX-License-Identifier: BSD-3-Clause
// The options of laws are one table: every row is in docs/scene.md with its kind and range, and is read.
#include "scene/law_options.hpp"

#include "cli/command.hpp"
#include "support/accuracy.hpp"

#include <fstiff/core/text.hpp>

namespace law_options_test {

using namespace fstiff;

namespace {

/// A scene with \p option among its sections of laws.
std::string with(const std::string& option) {
    return "[surface]\nrms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 8\n[material.upper]\nyoungs_modulus = \"2 "
           "GPa\"\n"
           "poisson_ratio = 0\n[contact]\npressures = [\"1 MPa\"]\nlaws = [\"hertz\"]\n" +
           option;
}
/// What a field is in docs/scene.md: kind and range; a value that it may have, and one that it may not.
struct Expected {
    std::string cells, good, bad;
};
template <class Member>
Expected expected(std::string_view key, const Member&, const fstiff::request::Field& field) {
    const std::string low = fstiff::detail::shortest_text(field.low), high = fstiff::detail::shortest_text(field.high);
    if constexpr (std::is_same_v<Member, bool>) return {"true or false, or 1 or 0 | ", "false", "0.5"};
    if constexpr (std::is_same_v<Member, int>) return {"whole number | " + low + " to " + high, "64", "8"};
    if constexpr (std::is_same_v<Member, fstiff::Edges>)
        return {"text | `\"mirrored\"`, `\"periodic\"`", "\"periodic\"", "\"closed\""};
    if (key == "spectrum") return {"text | `\"map\"`, `\"moments\"`", "\"moments\"", "\"map\""};  // there is no map
    return field.dimension ? Expected{"pressure | > 0", "\"5 MPa\"", "\"0 MPa\""}
                           : Expected{"number | " + low + " < " + std::string(key) + " <= " + high, "0.5", "1.5"};
}

}  // namespace

TEST_CASE("Every option of a law is a row of docs/scene.md, is read, and refuses what is out of its range") {
    const std::string page = test::read(FSTIFF_SCENES "/../docs/scene.md");
    for (const fstiff::LawKind law : scene::laws_with_options) {
        detail::LawOptions defaults;
        const std::string section = "contact." + std::string(name_of(law));
        scene::each_law_option(law, defaults, [&](std::string_view name, auto& member, const auto& field) {
            const std::string key = section + "." + std::string(name);
            INFO(key);
            const auto [cells, good, bad] = expected(name, member, field);
            CHECK(test::contains(page, "| `" + key + "` | " + cells));
            if (!scene::is_shared(law)) return;  // is read where its law is computed: read_scene_test.cpp
            const auto read = [&](const std::string& value) {
                return scene::read_scene(with("[" + section + "]\n" + std::string(name) + " = " + value + "\n"),
                                         {.name = "s.toml"});
            };
            scene::Scene changed = read(good);
            bool differs = false;
            scene::each_law_option(law, changed.joint.law_options, [&](std::string_view other, auto& now, const auto&) {
                if constexpr (std::is_same_v<decltype(now), decltype(member)>)
                    if (other == name) differs = !(now == member);
            });
            CHECK(differs);
            CHECK(changed.inputs.end() != std::find_if(changed.inputs.begin(), changed.inputs.end(),
                                                       [&](const request::Input& one) { return one.key == key; }));
            CHECK(test::contains(test::refusal([&, refused = bad] { (void)read(refused); }), key + " = "));
        });
    }
}

TEST_CASE("The table of laws is in the order of their names") {
    for (const auto& [law, word] : fstiff::enum_names<fstiff::LawKind>) {
        CHECK(detail::find_law(law).which == law);
        CHECK(detail::find_law(word) == &detail::find_law(law));
    }
    CHECK(detail::find_law("linear") == nullptr);
}

}  // namespace law_options_test
