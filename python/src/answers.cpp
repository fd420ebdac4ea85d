// SPDX-License-Identifier: BSD-3-Clause
// The answer of many joints that differ in their numbers or in what was measured.
#include "module.hpp"

#include "document/file.hpp"
#include "request/words.hpp"
#include "surface/measured_surface.hpp"

#include <fstiff/answer.hpp>
#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/joint_fields.hpp>
#include <fstiff/answer/resolve.hpp>
#include <fstiff/answer/resolved_joint.hpp>
#include <fstiff/asperity/named_materials.hpp>

#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>

namespace fstiff::python {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A face as the package was given it: arrays of one length by their names, NaN where a number is not given, and what
/// was measured, of every joint or of all.
struct FaceInput {
    std::map<std::string, In, std::less<>> numbers;
    std::string process;
    std::vector<std::shared_ptr<const MeasuredFace>> measured;

    /// Whether a number of joint \p i is missing.
    [[nodiscard]] bool has_gap(std::size_t i) const {
        return std::any_of(numbers.begin(), numbers.end(),
                           [i](const auto& column) { return std::isnan(column.second.data()[i]); });
    }
    [[nodiscard]] JointFace at(std::size_t i) const {
        JointFace face;
        take_numbers(face, [&](std::string_view key) -> std::optional<double> {
            const auto column = numbers.find(key);
            const double number = column == numbers.end() ? none : column->second.data()[i];
            return std::isnan(number) ? std::nullopt : std::optional(number);
        });
        if (!process.empty()) face.process = detail::process_of(process, "process");
        if (!measured.empty()) face.measured = measured[measured.size() == 1 ? 0 : i];
        return face;
    }
};

/// A body by its name, and numbers in place of those of the name.
Body body_called(const std::string& name, const Numbers& numbers, const char* which) {
    Body body;
    if (!name.empty()) {
        const NamedMaterial* found = find_material(name);
        if (!found)
            throw domain_error(std::string(which) + " = \"" + name.substr(0, 40) + "\": " +
                               request::unknown_material(name, "a dict with youngs_modulus and poisson_ratio"));
        body = body_of(*found);
    }
    take_numbers(body, numbers);
    return body;
}

/// What all joints share.
Joint joint_of(const Body& upper, const Body& lower, const Numbers& numbers) {
    Joint joint{.upper = upper, .lower = lower};
    take_numbers(joint, numbers);
    const auto has_waves = [](const Body& body) { return body.density && body.velocity; };
    if (numbers.contains("frequency") && has_waves(upper) && has_waves(lower))
        take_numbers(joint.waves.emplace(), numbers);
    if (const auto friction = numbers.find("friction"); friction != numbers.end())
        take_numbers(joint.friction.emplace(Friction{.coefficient = friction->second}), numbers);
    return joint;
}

/// What the package calls \p need.
std::string_view words_of(AnswerQuantity::Need need) {
    switch (need) {
        case AnswerQuantity::area: return "nominal_area";
        case AnswerQuantity::waves: return "frequency, and density and velocity of both bodies";
        case AnswerQuantity::shear_waves: return "frequency, and density and shear_velocity of both bodies";
        case AnswerQuantity::slip: return "friction and amplitude";
        case AnswerQuantity::heat: return "thermal_conductivity of both bodies";
        case AnswerQuantity::current: return "electrical_conductivity of both bodies";
        case AnswerQuantity::gap: return "a scene with the section gap";
        case AnswerQuantity::bodies: return "upper and lower";
        case AnswerQuantity::form: return "flatness";
        case AnswerQuantity::nothing: break;
    }
    return "";
}

/// \p joint resolved, with any height: no quantity needs one.
detail::ResolvedJoint with_any_face(Joint joint) {
    joint.face.rms_height = 1e-6;
    return detail::problem_of(joint, {});
}

/// The quantities called \p names. \throws domain_error unless \p joint has what they need.
std::vector<const AnswerQuantity*> quantities_called(const std::vector<std::string>& names,
                                                     const detail::ResolvedJoint& joint) {
    std::vector<const AnswerQuantity*> quantities;
    for (const std::string& name : names) {
        quantities.push_back(&detail::quantity_called(name, "quantities"));
        if (const auto need = detail::lack_of(*quantities.back(), joint); need != AnswerQuantity::nothing)
            throw domain_error("quantities: " + name + " needs " + std::string(words_of(need)));
    }
    return quantities;
}

/// Columns of count x pressures numbers, by their keys.
struct Columns {
    std::size_t count, pressures;
    std::map<std::string, std::vector<double>> numbers{};
    std::vector<std::string> laws{};
    std::map<std::size_t, std::string> reasons{};
    std::vector<std::vector<std::string>> concerns{};
    std::vector<int> doubtful{};
    LawColumns of_laws{};
    std::set<std::string> units{};  ///< sentences on numbers that are likely in another unit

    double& at(const std::string& key, std::size_t place) {
        std::vector<double>& column = numbers[key];
        if (column.empty()) column.assign(count * pressures, none);
        return column[place];
    }
    void put(const AnswerQuantity& quantity, std::size_t place, const WithBand& value) {
        at(quantity.key(), place) = value.value;
        if (!quantity.follows_stiffness()) return;
        at(quantity.key("_p05"), place) = value.low;
        at(quantity.key("_p95"), place) = value.high;
    }
    void put(const Answer& found, std::size_t i, const std::vector<const AnswerQuantity*>& wanted) {
        for (std::size_t k = 0; k < pressures; ++k) {
            const AnswerPoint& point = found.points[k];
            const std::size_t place = i * pressures + k;
            at("pressure_Pa", place) = point.pressure;
            laws.push_back(point.ok() ? std::string(name_of(point.law)) : "");
            if (!point.ok()) {
                reasons[place] = point.reason;
                continue;
            }
            put(detail::quantity_called("stiffness"), place, point.stiffness);
            at("loading_stiffness_Pa_per_m", place) = point.loading_stiffness.value_or(none);
            at("approach_m", place) = point["approach"];
            at("contacts", place) = point.contacts.value_or(none);
            at("p_star", place) = point.p_star.value_or(none);
            const auto shares = shares_of(point.causes);
            for (std::size_t c = 0; c < shares.size(); ++c)
                at("causes/" + std::string(name_of(static_cast<Cause>(c))), place) = shares[c];
            for (const AnswerQuantity* quantity : wanted) {
                const AnswerPoint::Value* value = point.find(quantity->word);
                put(*quantity, place, value ? value->number : WithBand{});
            }
        }
        std::vector<std::string>& names = concerns.emplace_back();
        for (const auto& one : found.concerns) {
            names.emplace_back(name_of(one.concern));
            if (std::string unit = fstiff::detail::sentence_of_unit(one); !unit.empty()) units.insert(std::move(unit));
        }
        doubtful.push_back(found.doubtful ? 1 : 0);
        of_laws.put(found);
    }
    /// Joint \p i has no K at any pressure.
    void put(const std::string& reason, std::size_t i, std::span<const double> at_pressures) {
        for (std::size_t k = 0; k < pressures; ++k) {
            const std::size_t place = i * pressures + k;
            at("pressure_Pa", place) = at_pressures[k];
            laws.emplace_back();
            reasons[place] = reason;
        }
        concerns.emplace_back();
        doubtful.push_back(1);
        of_laws.put(at_pressures);
    }
};

}  // namespace

void LawColumns::put(const Answer& found) {
    for (const AnswerPoint& point : found.points) {
        const bool ok = point.ok();
        const WithBand K = ok ? point.of_faces() : WithBand{};
        const auto& loading = point.faces ? point.loading_of_faces : point.loading_stiffness;
        points["pressure"].push_back(point.pressure);
        points["low"].push_back(K.low), points["value"].push_back(K.value), points["high"].push_back(K.high);
        points["loading"].push_back(ok ? loading.value_or(none) : none);
        points["separation"].push_back(ok ? point.state.separation.value : none);
    }
    facts["rms_height"].push_back(found.rms_height);
    facts["relative_hardness"].push_back(found.flows ? found.relative_hardness.value_or(0) : none);
    facts["greatest_pressure"].push_back(found.greatest_pressure.value_or(none));
}

void LawColumns::put(std::span<const double> pressures) {
    for (const double p : pressures) {
        points["pressure"].push_back(p);
        for (const char* key : {"low", "value", "high", "loading", "separation"}) points[key].push_back(none);
    }
    for (const char* key : {"rms_height", "relative_hardness", "greatest_pressure"}) facts[key].push_back(none);
}

nb::dict LawColumns::take(std::size_t joints) const {
    nb::dict of_points, of_joints, all;
    for (const auto& [key, column] : points)
        of_points[key.c_str()] = NewArray(column, {joints, joints > 0 ? column.size() / joints : 0}).take();
    for (const auto& [key, column] : facts) of_joints[key.c_str()] = NewArray(column).take();
    all["points"] = of_points, all["facts"] = of_joints;
    return all;
}

namespace {

nb::dict dict_of(Columns& columns) {
    nb::dict numbers, reasons, all;
    for (const auto& [key, column] : columns.numbers)
        numbers[key.c_str()] = NewArray(column, {columns.count, columns.pressures}).take();
    for (const auto& [place, reason] : columns.reasons) reasons[nb::int_(place)] = reason;
    all["numbers"] = numbers, all["reasons"] = reasons;
    all["laws"] = columns.laws, all["concerns"] = columns.concerns, all["doubtful"] = columns.doubtful;
    all["of_laws"] = columns.of_laws.take(columns.count);
    all["units"] = std::vector(columns.units.begin(), columns.units.end());
    return all;
}

nb::dict answers(std::size_t count, const FaceInput& face, const std::optional<FaceInput>& other,
                 const std::pair<Body, Body>& bodies, const In& pressures, const Numbers& numbers,
                 const std::vector<std::string>& quantities, bool is_table) {
    Columns columns{.count = count, .pressures = pressures.size()};
    {
        const nb::gil_scoped_release free;
        Joint joint = joint_of(bodies.first, bodies.second, numbers);
        const detail::ResolvedJoint of_bodies = with_any_face(joint);
        const std::vector<const AnswerQuantity*> wanted = quantities_called(quantities, of_bodies);
        AnswerOptions how;
        how.progress = until_interrupted();
        if (const auto found = numbers.find("samples"); found != numbers.end())
            how.samples = static_cast<int>(found->second);
        if (const auto found = numbers.find("seed"); found != numbers.end())
            how.seed = static_cast<std::uint64_t>(found->second);
        if (const auto found = numbers.find("seating"); found != numbers.end()) how.seating = found->second;
        if (!numbers.contains("seating"))  // the separation takes more time than all else
            for (const AnswerQuantity& each : answer_quantities())
                if (each.of_law != Quantity::separation && each.place > 0 &&
                    detail::lack_of(each, of_bodies) == AnswerQuantity::nothing)
                    how.quantities.emplace_back(each.word);
        for (std::size_t i = 0; i < count; ++i) {
            how.progress("joints", i, count);
            try {
                joint.face = face.at(i);
                if (other) joint.other = other->at(i);
                columns.put(answer(joint, numbers_of(pressures), how), i, wanted);
            } catch (const domain_error& error) {
                if (!is_table) throw;
                if (!face.has_gap(i) && !(other && other->has_gap(i)))
                    throw error.with_place({.file = "surface " + std::to_string(i)});
                columns.put(error.what(), i, numbers_of(pressures));
            }
        }
    }
    return dict_of(columns);
}

/// The names of the numbers of \p owner and other words for them, each with its SI unit, its meaning and its name.
template <class Owner>
nb::dict names_of(const Owner& owner) {
    nb::dict names;
    const auto text = [](std::string_view view) { return nb::str(view.data(), view.size()); };
    const auto take = [&](std::string_view name, const auto&, const NumberFacts& facts) {
        const nb::tuple known = nb::make_tuple(text(facts.unit), text(facts.help), text(name));
        names[text(name)] = known;
        for (const std::string_view word : facts.words) names[text(word)] = known;
    };
    each_field(owner, take);
    if constexpr (std::is_same_v<Owner, detail::Load>) detail::each_points(owner, take);
    if constexpr (std::is_same_v<Owner, JointFace>)
        detail::each_flag(owner, [&](std::string_view name, bool, std::string_view help) {
            names[text(name)] = nb::make_tuple(text(""), text("true: " + std::string(help)), text(name));
        });
    return names;
}

}  // namespace

void add_answers(nb::module_& m) {
    m.def("numbers_of_joint", [] {
        nb::dict all;
        all["face"] = names_of(JointFace()), all["body"] = names_of(Body()), all["joint"] = names_of(Joint());
        all["waves"] = names_of(UltrasonicWaves()), all["friction"] = names_of(Friction());
        all["load"] = names_of(detail::Load());
        return all;
    });
    nb::class_<FaceInput>(m, "Face", "A face, or as many as there are joints.")
        .def(
            "__init__",
            [](FaceInput* self, std::map<std::string, In, std::less<>> numbers, std::string process,
               const std::vector<std::shared_ptr<const surface::MeasuredSurface>>& measured) {
                std::vector<std::shared_ptr<const MeasuredFace>> faces;
                for (const auto& each : measured)
                    faces.push_back(measured_face(std::shared_ptr<const Surface<double>>(each, &each->found)));
                new (self) FaceInput{std::move(numbers), std::move(process), std::move(faces)};
            },
            nb::arg("numbers"), nb::arg("process"), nb::arg("measured"));
    m.def(
        "answers",
        [](std::size_t count, const FaceInput& face, const std::optional<FaceInput>& other, const std::string& upper,
           const Numbers& of_upper, const std::string& lower, const Numbers& of_lower, const In& pressures,
           const Numbers& numbers, const std::vector<std::string>& quantities, bool is_table) {
            return answers(count, face, other,
                           {body_called(upper, of_upper, "upper"), body_called(lower, of_lower, "lower")}, pressures,
                           numbers, quantities, is_table);
        },
        nb::arg("count"), nb::arg("face"), nb::arg("other").none(), nb::arg("upper"), nb::arg("of_upper"),
        nb::arg("lower"), nb::arg("of_lower"), nb::arg("pressures"), nb::arg("numbers"), nb::arg("quantities"),
        nb::arg("is_table"));
}

}  // namespace fstiff::python
