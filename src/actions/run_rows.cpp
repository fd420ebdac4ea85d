// SPDX-License-Identifier: BSD-3-Clause
#include "actions/run.hpp"

#include "actions/explanation.hpp"
#include "actions/measure.hpp"

#include <fstiff/answer/checks.hpp>
#include <fstiff/answer/laws.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace fstiff::actions {

using document::Cell, document::Json, scene::Scene;

Json scene_json(const Scene& scene) { return {{"name", scene.name}, {"file", scene.file}, {"sha256", scene.sha256}}; }

Units units_of(const Answered& answered) {
    const auto& scene = *answered.scene;
    double least = 0, most = 0;
    std::vector<double> joint, stiffness;
    for (const AnswerCurve& curve : answered.curves())
        for (const AnswerPoint& point : curve.points) {
            if (!point.ok()) continue;
            most = std::max(most, point.pressure);
            if (point.pressure > 0) least = least > 0 ? std::min(least, point.pressure) : point.pressure;
            joint.push_back(point.stiffness.value * scene.joint.nominal_area.value_or(0));
        }
    const auto add = [&](const AnswerCurve& curve) {
        for (const std::size_t place : scene.points_of_answer())
            if (const AnswerPoint* point = curve.at(place)) stiffness.push_back(point->stiffness.value);
    };
    if (answered.has_answer()) add(answered.answer);
    for (const AnswerCurve& curve : answered.curves())
        if (!answered.has_answer()) add(curve);
    const double middle = std::sqrt(least * most);
    return {{"Pa", document::unit_of_pressure(middle)},
            {"m", document::unit_of_length(scene.joint.face.parameters.rms_height.value)},
            {"1/m^2", document::unit_of_density(scene.joint.face.parameters.peak_density.value)},
            {"Pa/m", document::shown_unit(stiffness, "Pa/m")},
            {"N", document::shown_unit(middle * scene.joint.nominal_area.value_or(0), "N")},
            {"N/m", document::shown_unit(joint, "N/m")}};
}

bool has_approach(const Answer& answer) {
    return std::any_of(answer.points.begin(), answer.points.end(),
                       [](const AnswerPoint& point) { return point.find("approach") != nullptr; });
}

bool is_further(const AnswerQuantity& quantity) {
    constexpr std::array<std::string_view, 10> own{
        "force",           "pressure",          "eta",       "separation", "approach", "stiffness",
        "joint_stiffness", "loading_stiffness", "real_area", "contacts"};
    return std::find(own.begin(), own.end(), quantity.word) == own.end();
}

std::vector<std::string> assumptions_of(const Answered& answered) {
    const auto& scene = *answered.scene;
    std::vector<std::string> assumptions = scene.assumptions;
    if (answered.has_answer())
        assumptions.insert(assumptions.end(), scene.assumptions_of_answer.begin(), scene.assumptions_of_answer.end());
    return assumptions;
}

std::optional<double> plasticity_index(const detail::ResolvedJoint& joint) {
    const auto checks = surface_checks(joint);
    const Check<double>* check = detail::find_check(checks, Concern::plasticity);
    return check ? std::optional(check->least) : std::nullopt;
}

document::Heading heading_of(const scene::NumberOf& column, const Units& units) {
    const auto& [quantity, part] = column;
    const auto known = units.find(quantity->unit);
    const document::ShownUnit unit = known != units.end() ? known->second : document::shown_unit(0, quantity->unit);
    if (part.empty()) return {column.key(), unit.heading(quantity->symbol), unit.factor};
    if (part != "_error") return {column.key(), unit.heading(part == "_p05" ? "5 %" : "95 %"), unit.factor};
    if (quantity->word != "stiffness") return {column.key()};  // the others have that of K
    return {column.key(), "numerical error [Pa/m]", 1, 2};
}

document::Rows point_rows(const Scene& scene, const AnswerCurve& curve, bool bands, const Units& units) {
    document::Rows rows;
    std::vector<const AnswerPoint*> points;
    for (const AnswerPoint& point : curve.points)
        if (point.ok()) points.push_back(&point);
    const auto of_point = [](const auto& value) { return [=](const AnswerPoint* point) { return value(*point); }; };
    rows.add({"law"}, points, of_point([](const AnswerPoint& point) { return name_of(point.law); }));
    rows.repeat({"theta"}, curve.theta, points.size());
    rows.repeat({"r"}, curve.r, points.size());
    for (const scene::NumberOf& column : scene.columns(bands)) {
        const bool has_ends = curve.has_band || !column.part.starts_with("_p");
        rows.add(heading_of(column, units), points, of_point([&](const AnswerPoint& point) {
                     const double number = column(point);
                     return std::isnan(number) || !has_ends ? Cell() : Cell(number);
                 }));
        const bool is_value = column.part.empty();
        if (column.quantity->word == "pressure" && !points.empty() && points.front()->p_star)
            rows.add({"", "p*", 1, 3}, points, of_point([](const AnswerPoint& point) { return Cell(point.p_star); }));
        else if (column.quantity->word == "stiffness" && is_value)
            rows.add({"", "K/A0 [Pa/m]", 1, 6}, points, of_point([&](const AnswerPoint& point) {
                         return Cell::finite(column(point), Cell::Kind::absent);
                     }));
        else if (column.quantity->word == "real_area")
            rows.add({"", "mean pressure [GPa]", 1e-9}, points, of_point([](const AnswerPoint& point) {
                         const double area = point.state.real_area_fraction.value;
                         return area > 0 ? Cell(point.pressure / area) : Cell();
                     }));
    }
    if (curve.has_band)
        rows.add({.key = "samples_out_of_reach", .csv = false}, points,
                 of_point([](const AnswerPoint& point) { return Cell(point.failed); }));
    return rows;
}

namespace {

/// The rows of \p answered for JSON: K with its causes, and the quantities of the scene that follow from K.
Json answer_json(const Answered& answered) {
    const auto& scene = *answered.scene;
    Json rows = Json::array();
    const double area = scene.joint.nominal_area.value_or(0);
    for (const AnswerPoint& point : answered.answer.points) {
        if (!point.ok()) continue;
        const auto& [low, K, high] = point.stiffness;
        Json row = {{"pressure_Pa", point.pressure},
                    {"stiffness_Pa_per_m", K},
                    {"stiffness_p05_Pa_per_m", low},
                    {"stiffness_p95_Pa_per_m", high},
                    {"law", name_of(point.law)}};
        if (scene.asks("force")) row["force_N"] = scene.forces[point.place];
        if (const auto* approach = point.find("approach")) row["approach_m"] = approach->number.value;
        if (point.faces) {
            const auto& [of_low, of_faces, of_high] = *point.faces;
            row["stiffness_of_faces_Pa_per_m"] = of_faces;
            row["stiffness_of_faces_p05_Pa_per_m"] = of_low;
            row["stiffness_of_faces_p95_Pa_per_m"] = std::min(of_high, 1e300);
        }
        if (point.loading_stiffness) row["loading_stiffness_Pa_per_m"] = *point.loading_stiffness;
        if (area > 0) {
            row["stiffness_N_per_m"] = K * area;
            row["stiffness_p05_N_per_m"] = low * area;
            row["stiffness_p95_N_per_m"] = std::min(high * area, 1e300);
        }
        for (const scene::NumberOf& column : scene.columns(true))
            if (is_further(*column.quantity))
                if (const double number = column(point); !std::isnan(number)) row[column.key()] = number;
        if (point.p_star) row["p_star"] = *point.p_star;
        if (point.contacts) row["contacts"] = *point.contacts;
        Json& causes = row["causes"] = Json::object();
        const auto shares = shares_of(point.causes);
        for (std::size_t c = 0; c < shares.size(); ++c)
            if (shares[c] > 0) causes[name_of(static_cast<Cause>(c))] = shares[c];
        row["band_due_to"] = shown_causes(point.causes);
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace

Json run_document(const Answered& answered) {
    const auto& scene = *answered.scene;
    Json document = document::json_document("run");
    document["scene"] = scene_json(scene);
    for (const auto& [name, face, file] : scene.measured_files()) {
        Json measured = measured_document(*file);
        Json& place = scene.joint.faces.empty() ? document["surface"] : document["surface"][name];
        place = {{"source", measured["source"]}, {"measured", measured["surface"]}};
        put_cut_offs(place, file->found.cut_offs);
    }
    if (answered.has_band())
        document["uncertainty"] = {
            {"samples", scene.samples}, {"seed", scene.seed}, {"quantiles", {0.05, 0.95}}, {"of", "stiffness"}};
    Json& inputs = document["inputs"] = Json::object();
    for (const request::Input& input : scene.inputs) {
        Json& entry = inputs[input.key] = {{"written", input.shown()}};
        if (input.value) entry["value"] = *input.value;
        if (!input.unit.empty()) entry["unit"] = input.unit;
    }
    document["answer"] = answer_json(answered);
    if (scene.ball) ball_rows(answered).append_to(document["ball"] = Json::array());
    document["explanation"] = answered.explanation;
    document["assumptions"] = assumptions_of(answered);
    document["outside_band"] = outside_band(answered);
    if (const std::string next = measure_next(answered); !next.empty()) document["measure_next"] = next;
    document["effective_modulus_Pa"] = scene.joint.effective_modulus;
    if (const auto index = plasticity_index(scene.joint)) document["plasticity_index"] = *index;
    if (scene.asks("tangential_stiffness") || scene.asks("shear_reflection"))
        document["tangential_ratio"] = tangential_ratio(scene.joint.upper, scene.joint.lower);
    if (scene.joint.ultrasound) {
        const UltrasonicWaves& waves = *scene.joint.ultrasound;
        Json& entry = document["ultrasound"] = {{"frequency_Hz", waves.frequency},
                                                {"impedance_Rayl", waves.longitudinal.incident},
                                                {"impedance2_Rayl", waves.longitudinal.beyond},
                                                {"equations", {"(5.1)"}}};
        if (waves.film_stiffness > 0) entry["film_stiffness_Pa_per_m"] = waves.film_stiffness;
        if (waves.shear) {
            entry["shear_impedance_Rayl"] = waves.shear->incident;
            entry["shear_impedance2_Rayl"] = waves.shear->beyond;
        }
    }
    Json& laws = document["laws"] = Json::object();
    for (const detail::Law* law : scene.laws)
        laws[law->name] = {{"load", law->load}, {"stiffness", law->stiffness}, {"peaks", law->peaks}};
    Json& rows = document["rows"] = Json::array();
    for (const AnswerCurve& curve : answered.curves()) point_rows(scene, curve, answered.has_band()).append_to(rows);
    return document;
}

document::Rows ball_rows(const Answered& answered) {
    using Ball = Answer::Ball;
    const std::vector<Ball>& balls = answered.balls;
    const auto cell = [](const auto& value) {
        return [=](const Ball& ball) { return ball.reason.empty() ? Cell(value(ball)) : Cell(); };
    };
    document::Rows rows;
    const auto add = [&](const std::string& key, const std::string& suffix, const char* shown, std::string_view si,
                         double ContactOfBall<double>::*member) {  // and that of Hertz
        std::vector<double> sizes;
        for (const Ball& ball : balls) sizes.push_back(ball.hertz.*member);
        const document::ShownUnit unit = document::shown_unit(sizes, si);
        rows.add({key + suffix, unit.heading(shown), unit.factor, 3}, balls,
                 cell([=](const Ball& ball) { return ball.contact.*member; }));
        rows.add({"hertz_" + key + suffix, "Hertz", unit.factor, 3}, balls,
                 [=](const Ball& ball) { return ball.hertz.*member; });
        return unit;
    };
    rows.add({"force_N"}, balls, [](const Ball& ball) { return ball.hertz.load; });
    rows.add({"", "force"}, balls, [](const Ball& ball) { return document::with_unit(ball.hertz.load, "N", 3); });
    add("contact_radius", "_m", "a", "m", &ContactOfBall<double>::radius);
    const document::ShownUnit K = add("stiffness", "_N_per_m", "K", "N/m", &ContactOfBall<double>::stiffness);
    rows.add({"stiffness_p05_N_per_m"}, balls, cell([](const Ball& ball) { return ball.low; }));
    rows.add({"stiffness_p95_N_per_m"}, balls, cell([](const Ball& ball) { return ball.high; }));
    rows.add({"", "90 % band"}, balls, cell([&](const Ball& ball) {
                 return document::rounded(ball.low * K.factor, 3) + "–" + document::rounded(ball.high * K.factor, 3);
             }));
    if (answered.answer.flows)
        rows.add({"loading_stiffness_N_per_m", "loading K", K.factor, 3}, balls,
                 cell([](const Ball& ball) { return ball.contact.loading_stiffness; }));
    const document::ShownUnit pressure = add("max_pressure", "_Pa", "max p", "Pa", &ContactOfBall<double>::pressure);
    rows.add({"mean_pressure_Pa", "mean p", pressure.factor, 3}, balls, cell([](const Ball& ball) {
                 return ball.contact.load / (std::numbers::pi * ball.contact.radius * ball.contact.radius);
             }));
    add("approach", "_m", "approach", "m", &ContactOfBall<double>::approach);
    rows.add({"relative_error"}, balls, cell([](const Ball& ball) { return ball.contact.error; }));
    return rows;
}

document::TextRows answer_table(const Answered& answered, std::size_t causes) {
    const auto& scene = *answered.scene;
    if (scene.ball) return ball_rows(answered).table();
    const Answer& answer = answered.answer;
    const std::vector<std::size_t> places = scene.points_of_answer();
    std::vector<double> joint;
    const double area = scene.joint.nominal_area.value_or(0);
    for (const std::size_t place : places)
        if (const AnswerPoint* point = answer.at(place)) joint.push_back(area * point->stiffness.value);
    const document::ShownUnit unit = units_of(answered).at("Pa/m"), joint_unit = document::shown_unit(joint, "N/m"),
                              height = document::unit_of_length(answer.rms_height);
    const auto at_point = [&](const auto& value) {
        return [&answer, value](std::size_t place) {
            const AnswerPoint* point = answer.at(place);
            return point ? Cell(value(*point)) : Cell();
        };
    };
    document::Rows rows;
    rows.add({"", scene.forces.empty() ? "pressure" : "force, pressure"}, places, [&](std::size_t place) {
        const AnswerPoint* point = answer.at(place);
        return point && scene.forces.empty() ? document::with_unit(point->pressure, "Pa", 3) : scene.shown_point(place);
    });
    rows.add({"", unit.heading("K/A0"), unit.factor, 3}, places,
             at_point([](const AnswerPoint& point) { return point.stiffness.value; }));
    rows.add({"", "90 % band"}, places, at_point([&](const AnswerPoint& point) {
                 const auto& [low, middle, high] = point.stiffness;
                 const int digits = high - low < 0.2 * middle ? 3 : 2;  // enough to distinguish the ends
                 return document::rounded(low * unit.factor, digits) + "–" +
                        document::rounded(high * unit.factor, digits);
             }));
    if (area > 0)
        rows.add({"", joint_unit.heading("K"), joint_unit.factor, 3}, places,
                 at_point([&](const AnswerPoint& point) { return point.stiffness.value * area; }));
    if (has_approach(answer))
        rows.add({"", height.heading("approach"), height.factor, 3}, places,
                 at_point([](const AnswerPoint& point) { return point["approach"]; }));
    if (answer.flows)
        rows.add({"", "loading K/A0", unit.factor, 3}, places,
                 at_point([](const AnswerPoint& point) { return point.loading_stiffness; }));
    const std::size_t law = rows.columns().size();
    rows.add({"", "law"}, places, at_point([](const AnswerPoint& point) { return name_of(point.law); }));
    if (causes > 0)
        rows.add({"", "band due to"}, places,
                 at_point([&](const AnswerPoint& point) { return shown_causes(point.causes, causes); }));
    document::TextRows table = rows.table();
    for (std::size_t column = law; column < table[0].size(); ++column) {  // text begins on the left
        std::size_t most = 0;
        for (const auto& row : table) most = std::max(most, document::shown_width(row[column]));
        for (auto& row : table) row[column] += std::string(most - document::shown_width(row[column]), ' ');
    }
    return table;
}

}  // namespace fstiff::actions
