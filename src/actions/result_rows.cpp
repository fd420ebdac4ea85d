// SPDX-License-Identifier: BSD-3-Clause
#include "actions/run.hpp"

#include "actions/explanation.hpp"
#include "actions/measure.hpp"

#include <fstiff/answer/checks.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace fstiff::actions {

using document::Cell, document::Json, scene::CurveQuantity, scene::Scene;

Json scene_json(const Scene& scene) { return {{"name", scene.name}, {"file", scene.file}, {"sha256", scene.sha256}}; }

Units units_of(const Scene& scene, const Results& results) {
    double least = 0, most = 0;
    std::vector<double> joint, stiffness;
    for (const Curve& curve : results.curves)
        for (const auto& state : curve.states) {
            const double p = state.pressure.value;
            most = std::max(most, p);
            if (p > 0) least = least > 0 ? std::min(least, p) : p;
            joint.push_back(state.stiffness.value * scene.nominal_area.value_or(0));
        }
    const auto add = [&](const Curve& curve) {
        for (const std::size_t place : points_of_answer(scene))
            if (const auto state = curve.state_at(place)) stiffness.push_back(curve.states[*state].stiffness.value);
    };
    if (results.answer) add(results.answer->curve);
    for (const Curve& curve : results.curves)
        if (!results.answer) add(curve);
    const double middle = std::sqrt(least * most);
    return {.pressure = document::unit_of_pressure(middle),
            .height = document::unit_of_length(scene.face.parameters.rms_height.value),
            .density = document::unit_of_density(scene.face.parameters.peak_density.value),
            .stiffness = document::shown_unit(stiffness, "Pa/m"),
            .force = document::shown_unit(middle * scene.nominal_area.value_or(0), "N"),
            .joint_stiffness = document::shown_unit(joint, "N/m")};
}

document::Heading heading_of(const scene::Column& column, const Units& units) {
    const std::string_view si = column.row().unit, symbol = column.row().symbol;
    const document::ShownUnit unit = si == "Pa"          ? units.pressure
                                     : si == "m"         ? units.height
                                     : si == "1/m^2"     ? units.density
                                     : si == "Pa/m"      ? units.stiffness
                                     : si == "N"         ? units.force
                                     : si == "N/m"       ? units.joint_stiffness
                                     : si == "S/m^2"     ? document::ShownUnit{"S/m²"}
                                     : si == "W/(m^2 K)" ? document::ShownUnit{"W/(m² K)"}
                                                         : document::ShownUnit{si};
    switch (column.statistic) {
        case scene::Statistic::value: return {column.key(), unit.heading(symbol), unit.factor};
        case scene::Statistic::error:  // the others have that of K
            if (column.quantity != CurveQuantity::stiffness) return {column.key()};
            return {column.key(), "numerical error [Pa/m]", 1, 2};
        case scene::Statistic::p05: return {column.key(), unit.heading("5 %"), unit.factor};
        case scene::Statistic::p95: return {column.key(), unit.heading("95 %"), unit.factor};
    }
    return {};
}

document::Rows point_rows(const Results& results, const Curve& curve, const Units& units) {
    document::Rows rows;
    const std::size_t size = curve.states.size();
    std::vector<std::string_view> laws;
    for (std::size_t i = 0; i < size; ++i) laws.push_back(curve.law_at(i).name);
    rows.add({"law"}, laws);
    rows.repeat({"theta"}, curve.theta, size);
    rows.repeat({"r"}, curve.r, size);
    for (const scene::Column& column : curve.columns) {
        rows.add(heading_of(column, units), column.values,
                 [](double value) { return std::isnan(value) ? Cell() : Cell(value); });
        if (column.quantity == CurveQuantity::pressure && curve.rms_gradient)
            rows.add({"", "p*", 1, 3}, column.values,
                     [&](double p) { return detail::dimensionless_pressure(p, results.modulus, *curve.rms_gradient); });
        else if (column.quantity == CurveQuantity::stiffness && column.statistic == scene::Statistic::value)
            rows.add({"", "K/A0 [Pa/m]", 1, 6}, column.values);
        else if (column.quantity == CurveQuantity::real_area)
            rows.add({"", "mean pressure [GPa]", 1e-9}, curve.states, [](const ContactState<double>& state) {
                const double area = state.real_area_fraction.value;
                return area > 0 ? Cell(state.pressure.value / area) : Cell();
            });
    }
    if (!curve.band.empty())
        rows.add({.key = "samples_out_of_reach", .csv = false}, curve.band, &detail::SampledBand<double>::failed);
    return rows;
}

std::string shown_point(const Scene& scene, std::size_t i) {
    const std::string point = document::with_unit(scene.points[i], scene.at_separations ? "m" : "Pa", 3);
    return scene.forces.empty() ? point : document::with_unit(scene.forces[i], "N", 3) + ", " + point;
}

Json answer_json(const Scene& scene, const Results& results) {
    Json rows = Json::array();
    if (!results.answer) return rows;
    const Curve& curve = results.answer->curve;
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        const detail::AnswerReason& reason = results.answer->reasons[i];
        const detail::SampledBand<double>& band = curve.band[i];
        const double K = curve.states[i].stiffness.value;
        Json row = {{"pressure_Pa", curve.states[i].pressure.value},
                    {"stiffness_Pa_per_m", K},
                    {"stiffness_p05_Pa_per_m", band.low},
                    {"stiffness_p95_Pa_per_m", band.high},
                    {"law", curve.law_at(i).name}};
        if (scene.asks(CurveQuantity::force)) row["force_N"] = scene.forces[curve.places[i]];
        if (scene.asks(CurveQuantity::approach) && !curve.separation_at_seating.empty())
            row["approach_m"] = curve.separation_at_seating[i] - curve.states[i].separation.value;
        if (reason.loading_stiffness) row["loading_stiffness_Pa_per_m"] = *reason.loading_stiffness;
        if (scene.nominal_area) {
            row["stiffness_N_per_m"] = K * *scene.nominal_area;
            row["stiffness_p05_N_per_m"] = band.low * *scene.nominal_area;
            row["stiffness_p95_N_per_m"] = std::min(band.high * *scene.nominal_area, 1e300);
        }
        for (const scene::Column& column : curve.columns)
            if (column.quantity >= CurveQuantity::tangential_stiffness &&
                column.quantity <= CurveQuantity::electrical_resistance && !column.values.empty() &&
                !std::isnan(column.values[i]))
                row[column.key()] = column.values[i];
        if (reason.p_star) row["p_star"] = *reason.p_star;
        if (reason.contacts) row["contacts"] = *reason.contacts;
        Json& causes = row["causes"] = Json::object();
        const auto shares = shares_of(reason.causes);
        for (std::size_t c = 0; c < shares.size(); ++c)
            if (shares[c] > 0) causes[name_of(static_cast<Cause>(c))] = shares[c];
        row["band_due_to"] = shown_causes(reason);
        rows.push_back(std::move(row));
    }
    return rows;
}

Json run_document(const Scene& scene, const Results& results) {
    Json document = document::json_document("run");
    document["scene"] = scene_json(scene);
    for (const auto& [name, face, file] : measured_files(scene)) {
        Json measured = measured_document(*file);
        Json& place = scene.faces.empty() ? document["surface"] : document["surface"][name];
        place = {{"source", measured["source"]}, {"measured", measured["surface"]}};
        put_cut_offs(place, file->found.cut_offs);
    }
    if (has_band(results))
        document["uncertainty"] = {
            {"samples", scene.samples}, {"seed", scene.seed}, {"quantiles", {0.05, 0.95}}, {"of", "stiffness"}};
    Json& inputs = document["inputs"] = Json::object();
    for (const request::Input& input : scene.inputs) {
        Json& entry = inputs[input.key] = {{"written", input.shown()}};
        if (input.value) entry["value"] = *input.value;
        if (!input.unit.empty()) entry["unit"] = input.unit;
    }
    document["answer"] = answer_json(scene, results);
    if (scene.ball) ball_rows(results).append_to(document["ball"] = Json::array());
    document["explanation"] = results.explanation;
    document["assumptions"] = assumptions_of(scene, results);
    document["outside_band"] = outside_band(scene, results);
    if (const std::string next = measure_next(scene, results); !next.empty()) document["measure_next"] = next;
    document["effective_modulus_Pa"] = scene.effective_modulus;
    if (results.plasticity_index) document["plasticity_index"] = *results.plasticity_index;
    if (scene.asks(CurveQuantity::tangential_stiffness) || scene.asks(CurveQuantity::shear_reflection))
        document["tangential_ratio"] = results.tangential_ratio;
    if (scene.ultrasound) {
        const Waves& waves = *scene.ultrasound;
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
    for (const Curve& curve : results.curves) point_rows(results, curve).append_to(rows);
    return document;
}

document::Rows ball_rows(const Results& results) {
    const std::vector<BallUnderForce>& balls = results.balls;
    const auto cell = [](const auto& value) {
        return [=](const BallUnderForce& ball) { return ball.reason.empty() ? Cell(value(ball)) : Cell(); };
    };
    document::Rows rows;
    const auto add = [&](const std::string& key, const std::string& suffix, const char* shown, std::string_view si,
                         double ContactOfBall<double>::*member) {  // and that of Hertz
        std::vector<double> sizes;
        for (const BallUnderForce& ball : balls) sizes.push_back(ball.hertz.*member);
        const document::ShownUnit unit = document::shown_unit(sizes, si);
        rows.add({key + suffix, unit.heading(shown), unit.factor, 3}, balls,
                 cell([=](const BallUnderForce& ball) { return ball.contact.*member; }));
        rows.add({"hertz_" + key + suffix, "Hertz", unit.factor, 3}, balls,
                 [=](const BallUnderForce& ball) { return ball.hertz.*member; });
        return unit;
    };
    rows.add({"force_N"}, balls, [](const BallUnderForce& ball) { return ball.hertz.load; });
    rows.add({"", "force"}, balls,
             [](const BallUnderForce& ball) { return document::with_unit(ball.hertz.load, "N", 3); });
    add("contact_radius", "_m", "a", "m", &ContactOfBall<double>::radius);
    const document::ShownUnit K = add("stiffness", "_N_per_m", "K", "N/m", &ContactOfBall<double>::stiffness);
    rows.add({"stiffness_p05_N_per_m"}, balls, cell([](const BallUnderForce& ball) { return ball.low; }));
    rows.add({"stiffness_p95_N_per_m"}, balls, cell([](const BallUnderForce& ball) { return ball.high; }));
    rows.add({"", "90 % band"}, balls, cell([&](const BallUnderForce& ball) {
                 return document::rounded(ball.low * K.factor, 3) + "–" + document::rounded(ball.high * K.factor, 3);
             }));
    if (results.answer->flows)
        rows.add({"loading_stiffness_N_per_m", "loading K", K.factor, 3}, balls,
                 cell([](const BallUnderForce& ball) { return ball.contact.loading_stiffness; }));
    const document::ShownUnit pressure = add("max_pressure", "_Pa", "max p", "Pa", &ContactOfBall<double>::pressure);
    rows.add({"mean_pressure_Pa", "mean p", pressure.factor, 3}, balls, cell([](const BallUnderForce& ball) {
                 return ball.contact.load / (std::numbers::pi * ball.contact.radius * ball.contact.radius);
             }));
    add("approach", "_m", "approach", "m", &ContactOfBall<double>::approach);
    rows.add({"relative_error"}, balls, cell([](const BallUnderForce& ball) { return ball.contact.error; }));
    return rows;
}

document::TextRows answer_table(const Scene& scene, const Results& results, std::size_t causes) {
    if (scene.ball) return ball_rows(results).table();
    const StiffnessAnswer& answer = *results.answer;
    const Curve& curve = answer.curve;
    const std::vector<std::size_t> places = points_of_answer(scene);
    std::vector<double> joint;
    const double area = scene.nominal_area.value_or(0);
    for (const std::size_t place : places)
        if (const auto state = curve.state_at(place)) joint.push_back(area * curve.states[*state].stiffness.value);
    const document::ShownUnit unit = units_of(scene, results).stiffness,
                              joint_unit = document::shown_unit(joint, "N/m"),
                              height = document::unit_of_length(scene.face.parameters.rms_height.value);
    const auto at_state = [&](const auto& value) {
        return [&curve, value](std::size_t place) {
            const auto state = curve.state_at(place);
            return state ? Cell(value(*state)) : Cell();
        };
    };
    document::Rows rows;
    rows.add({"", scene.forces.empty() ? "pressure" : "force, pressure"}, places, [&](std::size_t place) {
        const auto state = curve.state_at(place);
        return state && scene.forces.empty() ? document::with_unit(curve.states[*state].pressure.value, "Pa", 3)
                                             : shown_point(scene, place);
    });
    rows.add({"", unit.heading("K/A0"), unit.factor, 3}, places,
             at_state([&](std::size_t i) { return curve.states[i].stiffness.value; }));
    rows.add({"", "90 % band"}, places, at_state([&](std::size_t i) {
                 const auto& [low, median, high, failed] = curve.band[i];
                 const int digits = high - low < 0.2 * median ? 3 : 2;  // enough to distinguish the ends
                 return document::rounded(low * unit.factor, digits) + "–" +
                        document::rounded(high * unit.factor, digits);
             }));
    if (area > 0)
        rows.add({"", joint_unit.heading("K"), joint_unit.factor, 3}, places,
                 at_state([&](std::size_t i) { return curve.states[i].stiffness.value * area; }));
    if (scene.asks(CurveQuantity::approach) && !curve.separation_at_seating.empty())
        rows.add({"", height.heading("approach"), height.factor, 3}, places, at_state([&](std::size_t i) {
                     return curve.separation_at_seating[i] - curve.states[i].separation.value;
                 }));
    if (answer.flows)
        rows.add({"", "loading K/A0", unit.factor, 3}, places,
                 at_state([&](std::size_t i) { return answer.reasons[i].loading_stiffness; }));
    const std::size_t law = rows.columns().size();
    rows.add({"", "law"}, places, at_state([&](std::size_t i) { return curve.law_at(i).name; }));
    if (causes > 0)
        rows.add({"", "band due to"}, places,
                 at_state([&](std::size_t i) { return shown_causes(answer.reasons[i], causes); }));
    document::TextRows table = rows.table();
    for (std::size_t column = law; column < table[0].size(); ++column) {  // text begins on the left
        std::size_t most = 0;
        for (const auto& row : table) most = std::max(most, document::shown_width(row[column]));
        for (auto& row : table) row[column] += std::string(most - document::shown_width(row[column]), ' ');
    }
    return table;
}

}  // namespace fstiff::actions
