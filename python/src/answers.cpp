// SPDX-License-Identifier: BSD-3-Clause
// The answer of many joints that differ in their numbers or in what was measured.
#include "module.hpp"

#include "document/file.hpp"
#include "request/words.hpp"
#include "surface/measured_surface.hpp"

#include <fstiff/answer.hpp>
#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/resolved_joint.hpp>
#include <fstiff/asperity/named_materials.hpp>

#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>

namespace fstiff::python {
namespace {

using Numbers = std::map<std::string, double>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct FaceNumber {
    const char* name;
    std::optional<double> JointFace::*value;
};
constexpr FaceNumber face_numbers[]{{"height", &JointFace::rms_height},
                                    {"mean_height", &JointFace::mean_height},
                                    {"gradient", &JointFace::rms_gradient},
                                    {"profile_gradient", &JointFace::profile_gradient},
                                    {"profile_spacing", &JointFace::profile_spacing},
                                    {"alpha", &JointFace::alpha},
                                    {"hurst", &JointFace::hurst},
                                    {"skewness", &JointFace::skewness},
                                    {"kurtosis", &JointFace::kurtosis},
                                    {"peak_radius", &JointFace::peak_radius},
                                    {"peak_density", &JointFace::peak_density},
                                    {"fractal_dimension", &JointFace::fractal_dimension}};

/// \p error with the package's name of the parameter.
domain_error with_own_name(const domain_error& error) {
    constexpr std::string_view of_other = "other.";
    const bool other = error.parameter().starts_with(of_other);
    const std::string name(error.parameter().substr(other ? of_other.size() : 0));
    for (const auto& [given, own] :
         {std::pair("rms_height", "height"), {"rms_gradient", "gradient"}, {"nominal_area", "area"}})
        if (name == given) return error.with_parameter((other ? "other." : "") + std::string(own));
    return error;
}

/// A face as the package was given it: arrays of one length by their names, NaN where a number is not given, and what
/// was measured, of every joint or of all.
struct FaceInput {
    std::map<std::string, In> numbers;
    std::string process;
    std::vector<std::shared_ptr<const MeasuredFace>> measured;

    /// Whether a number of joint \p i is missing.
    [[nodiscard]] bool has_gap(std::size_t i) const {
        return std::any_of(numbers.begin(), numbers.end(),
                           [i](const auto& column) { return std::isnan(column.second.data()[i]); });
    }
    [[nodiscard]] JointFace at(std::size_t i) const {
        JointFace face;
        for (const auto& [name, value] : face_numbers)
            if (const auto found = numbers.find(name); found != numbers.end())
                if (const double one = found->second.data()[i]; !std::isnan(one)) face.*value = one;
        if (!process.empty()) face.process = detail::process_of(process, "process");
        if (!measured.empty()) face.measured = measured[measured.size() == 1 ? 0 : i];
        return face;
    }
};

/// A body by its name, and numbers in place of those of the name.
struct Solid {
    Body body{};
    std::optional<double> density{}, velocity{}, shear_velocity{}, thermal{}, electrical{};
};
Solid solid_of(const std::string& name, const Numbers& numbers, const char* which) {
    Solid solid;
    if (!name.empty()) {
        const NamedMaterial* found = find_material(name);
        if (!found)
            throw domain_error(std::string(which) + " = \"" + name.substr(0, 40) + "\": " +
                               request::unknown_material(name, "a dict with youngs_modulus and poisson_ratio"));
        const auto known = [](double value) { return value > 0 ? std::optional(value) : std::nullopt; };
        solid = {.body = body_of(*found),
                 .density = found->density,
                 .velocity = known(found->wave_speeds().first),
                 .shear_velocity = known(found->wave_speeds().second),
                 .thermal = known(found->thermal_conductivity),
                 .electrical = known(found->electrical_conductivity)};
    }
    const auto take = [&](const char* key, auto& to) {
        if (const auto given = numbers.find(key); given != numbers.end()) to = given->second;
    };
    take("youngs_modulus", solid.body.elastic.youngs_modulus), take("poisson_ratio", solid.body.elastic.poisson_ratio);
    take("yield_strength", solid.body.yield_strength), take("hardness", solid.body.hardness);
    take("density", solid.density), take("velocity", solid.velocity), take("shear_velocity", solid.shear_velocity);
    take("thermal_conductivity", solid.thermal), take("electrical_conductivity", solid.electrical);
    return solid;
}

/// What all joints share.
Joint joint_of(const Solid& upper, const Solid& lower, const Numbers& numbers) {
    const auto number = [&](const char* name) -> std::optional<double> {
        const auto found = numbers.find(name);
        return found == numbers.end() ? std::optional<double>() : found->second;
    };
    Joint joint{.upper = upper.body, .lower = lower.body, .nominal_area = number("area")};
    const auto both = [](const std::optional<double>& a, const std::optional<double>& b) {
        return a && b && *a > 0 && *b > 0 ? std::optional(joint_conductivity(*a, *b)) : std::nullopt;
    };
    joint.conduction.thermal = both(upper.thermal, lower.thermal);
    joint.conduction.electrical = both(upper.electrical, lower.electrical);
    if (const auto frequency = number("frequency"); frequency && upper.density && lower.density) {
        const auto impedances = [&](const std::optional<double>& a, const std::optional<double>& b) {
            return Impedances<double>{acoustic_impedance(*upper.density, *a), acoustic_impedance(*lower.density, *b)};
        };
        if (upper.velocity && lower.velocity)
            joint.waves = UltrasonicWaves{*frequency, impedances(upper.velocity, lower.velocity), {}};
        if (joint.waves) joint.waves->film_stiffness = number("film_stiffness").value_or(0);
        if (joint.waves && upper.shear_velocity && lower.shear_velocity)
            joint.waves->shear = impedances(upper.shear_velocity, lower.shear_velocity);
    }
    if (const auto friction = number("friction")) joint.friction = Friction{*friction, number("amplitude")};
    return joint;
}

/// What the package calls \p need.
std::string_view words_of(AnswerQuantity::Need need) {
    switch (need) {
        case AnswerQuantity::area: return "area";
        case AnswerQuantity::waves: return "frequency, and density and velocity of both bodies";
        case AnswerQuantity::shear_waves: return "frequency, and density and shear_velocity of both bodies";
        case AnswerQuantity::slip: return "friction and amplitude";
        case AnswerQuantity::heat: return "thermal_conductivity of both bodies";
        case AnswerQuantity::current: return "electrical_conductivity of both bodies";
        case AnswerQuantity::gap: return "a scene with the section gap";
        case AnswerQuantity::bodies: return "upper and lower";
        case AnswerQuantity::nothing: break;
    }
    return "";
}

/// What \p quantity needs that \p joint has not.
AnswerQuantity::Need lack_of(const AnswerQuantity& quantity, const Joint& joint) {
    detail::ResolvedJoint has;
    has.upper = joint.upper.elastic, has.nominal_area = joint.nominal_area, has.ultrasound = joint.waves;
    has.conduction = joint.conduction, has.friction = joint.friction;
    return detail::lack_of(quantity, has);
}

/// The quantities called \p names. \throws domain_error unless \p joint has what they need.
std::vector<const AnswerQuantity*> quantities_called(const std::vector<std::string>& names, const Joint& joint) {
    std::vector<const AnswerQuantity*> quantities;
    for (const std::string& name : names) {
        quantities.push_back(&detail::quantity_called(name, "quantities"));
        if (const auto need = lack_of(*quantities.back(), joint); need != AnswerQuantity::nothing)
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
    std::vector<double> rms_heights{};  ///< NaN of a joint without a K
    std::set<std::string> units{};      ///< sentences on numbers that are likely in another unit

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
        rms_heights.push_back(found.rms_height);
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
        rms_heights.push_back(none);
    }
};

nb::dict dict_of(Columns& columns) {
    nb::dict numbers, reasons, all;
    for (const auto& [key, column] : columns.numbers)
        numbers[key.c_str()] = NewArray(column, {columns.count, columns.pressures}).take();
    for (const auto& [place, reason] : columns.reasons) reasons[nb::int_(place)] = reason;
    all["numbers"] = numbers, all["reasons"] = reasons;
    all["laws"] = columns.laws, all["concerns"] = columns.concerns, all["doubtful"] = columns.doubtful;
    all["rms_heights"] = columns.rms_heights;
    all["units"] = std::vector(columns.units.begin(), columns.units.end());
    return all;
}

nb::dict answers(std::size_t count, const FaceInput& face, const std::optional<FaceInput>& other,
                 const std::pair<Solid, Solid>& bodies, const In& pressures, const Numbers& numbers,
                 const std::vector<std::string>& quantities, bool is_table) {
    Columns columns{.count = count, .pressures = pressures.size()};
    {
        const nb::gil_scoped_release free;
        Joint joint = joint_of(bodies.first, bodies.second, numbers);
        const std::vector<const AnswerQuantity*> wanted = quantities_called(quantities, joint);
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
                    lack_of(each, joint) == AnswerQuantity::nothing)
                    how.quantities.emplace_back(each.word);
        for (std::size_t i = 0; i < count; ++i) {
            how.progress("joints", i, count);
            try {
                joint.face = face.at(i);
                if (other) joint.other = other->at(i);
                columns.put(answer(joint, numbers_of(pressures), how), i, wanted);
            } catch (const domain_error& error) {
                const domain_error own = with_own_name(error);
                if (!is_table) throw own;
                if (!face.has_gap(i) && !(other && other->has_gap(i)))
                    throw own.with_place({.file = "surface " + std::to_string(i)});
                columns.put(own.what(), i, numbers_of(pressures));
            }
        }
    }
    return dict_of(columns);
}

}  // namespace

void add_answers(nb::module_& m) {
    nb::class_<FaceInput>(m, "Face", "A face, or as many as there are joints.")
        .def(
            "__init__",
            [](FaceInput* self, std::map<std::string, In> numbers, std::string process,
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
            return answers(count, face, other, {solid_of(upper, of_upper, "upper"), solid_of(lower, of_lower, "lower")},
                           pressures, numbers, quantities, is_table);
        },
        nb::arg("count"), nb::arg("face"), nb::arg("other").none(), nb::arg("upper"), nb::arg("of_upper"),
        nb::arg("lower"), nb::arg("of_lower"), nb::arg("pressures"), nb::arg("numbers"), nb::arg("quantities"),
        nb::arg("is_table"));
}

}  // namespace fstiff::python
