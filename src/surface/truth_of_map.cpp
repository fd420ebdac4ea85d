// SPDX-License-Identifier: BSD-3-Clause
#include "surface/truth_of_map.hpp"

#include <fstiff/double/surfaces.hpp>
#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/answer/checks.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff::scene {

std::size_t TruthOfMap::unresolved() const {
    return static_cast<std::size_t>(std::count_if(
        at.begin(), at.end(), [](const auto& point) { return point.stiffness_error > 0.2 * point.state.stiffness; }));
}

std::size_t TruthOfMap::failed() const {
    return static_cast<std::size_t>(
        std::count_if(at.begin(), at.end(), [](const auto& point) { return !point.state.converged; }));
}

bool TruthOfMap::doubtful() const {
    return unresolved() + failed() + closed() > 0 || !parts::is_plausible_gradient(rms_gradient);
}
std::size_t TruthOfMap::closed() const {
    return static_cast<std::size_t>(
        std::count_if(at.begin(), at.end(), [](const auto& point) { return std::isinf(point.state.stiffness); }));
}

TruthOfMap truth_of_map(const TruthRequest& options, const SurfaceInput& input) {
    if (input.surface.is_profile())
        throw domain_error(display_name(options.surface.file) + ": is a profile; boundary elements need a map");
    for (const double pressure : options.pressures) require_positive("pressure", pressure);
    SurfaceOptions surface = options.surface;
    if (const std::string text = surface.lambda_s.text("m"); text.empty() || text == "auto")
        surface.lambda_s = "none";  // K is of all short waves
    const parts::PreparedMap<double> map = level_map(surface, input);
    TruthOfMap solved;
    solved.file = display_name(options.surface.file);
    solved.form = form_name(map) + (map.cut_offs.any() ? ", " + sentence_of(map.cut_offs) : "");
    solved.points_option = std::string(options.surface.prefix) + "points";
    solved.modulus = options.modulus;
    solved.rms_height = map.rms;
    solved.rms_gradient = map.areal.rms_gradient;
    solved.reading = reading_warnings(input, "truth needs them filled", solved.rms_gradient);
    solved.points = std::min<Eigen::Index>(options.points, std::max(map.map.columns(), map.map.rows()));
    solved.edges = options.edges;
    if (!(options.hardness > 0)) solved.flows_above = options.known_hardness;
    solved.at = truth(
        map.map, solved.modulus, options.pressures,
        {.points = options.points, .edges = options.edges, .hardness = options.hardness, .progress = options.progress});
    for (const auto& [state, stiffness_error, gap_error] : solved.at)
        if (std::isnan(state.stiffness) || std::isnan(stiffness_error) || !std::isfinite(state.mean_gap) ||
            !std::isfinite(gap_error) || !std::isfinite(state.max_pressure))
            throw domain_error(solved.file + ": a result for pressure = " + shortest(state.pressure) +
                               " is beyond the range of double precision; pressures must be less extreme");
    if (solved.closed() == solved.at.size())
        throw domain_error(solved.file + ": all points of the map are in contact" +
                           (solved.at.size() == 1 ? " at " : " at every pressure, the least of them ") +
                           shortest(*std::min_element(options.pressures.begin(), options.pressures.end())) +
                           " Pa, so that there is no K; pressures must be lower, or the effective modulus higher");
    return solved;
}

namespace {

std::string shown_pressure(double pressure) { return unit_of_pressure(pressure)(pressure, 3); }

/// The first pressure at which a contact carries more than its hardness; null where none does.
const TruthPoint<double>* first_flowing(const TruthOfMap& solved) {
    if (!(solved.flows_above > 0)) return nullptr;
    const auto found = std::find_if(solved.at.begin(), solved.at.end(), [&](const TruthPoint<double>& point) {
        return point.state.max_pressure > solved.flows_above;
    });
    return found == solved.at.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::string> warnings_of(const TruthOfMap& solved) {
    std::vector<std::string> warnings = solved.reading;
    if (const std::size_t closed = solved.closed())
        warnings.push_back("all points of the map are in contact at " + std::to_string(closed) + " of " +
                           std::to_string(solved.at.size()) + " pressures: there is no K there");
    if (const std::size_t unresolved = solved.unresolved())
        warnings.push_back("K changes by more than a fifth from the grid half as fine at " +
                           std::to_string(unresolved) + " of " + std::to_string(solved.at.size()) +
                           " pressures: the contacts there are a few points wide (" + solved.points_option +
                           ", or a finer map)");
    if (const std::size_t failed = solved.failed())
        warnings.push_back(std::to_string(failed) + " solutions did not converge");
    if (const TruthPoint<double>* most = first_flowing(solved))
        warnings.push_back("elastic pressures of up to " + shown_pressure(most->state.max_pressure) +
                           " at p = " + shown_pressure(most->state.pressure) +
                           " exceed the hardness of the softer body, " + shown_pressure(solved.flows_above) +
                           ": the contacts yield, and this K does not apply to them (--hardness cuts the pressures)");
    return warnings;
}

Rows rows_of(const TruthOfMap& solved) {
    const auto if_finite = [](double value) { return std::isfinite(value) ? Cell(value) : Cell(Cell::Kind::null); };
    std::vector<double> pressure, gap, gap_error, area, largest;
    std::vector<Cell> relative, stiffness, error;
    std::vector<std::size_t> spots;
    std::vector<std::string> converged;
    for (const auto& [state, stiffness_error, change_of_gap] : solved.at) {
        pressure.push_back(state.pressure);
        relative.push_back(
            if_finite(parts::dimensionless_pressure(state.pressure, solved.modulus, solved.rms_gradient)));
        stiffness.push_back(if_finite(state.stiffness));
        error.push_back(std::isfinite(state.stiffness) ? if_finite(stiffness_error) : stiffness.back());
        gap.push_back(state.mean_gap);
        gap_error.push_back(change_of_gap);
        area.push_back(state.contact_fraction);
        largest.push_back(state.max_pressure);
        spots.push_back(static_cast<std::size_t>(state.spots));
        converged.emplace_back(state.converged ? "yes" : "no");
    }
    Rows rows;
    rows.add({"pressure_Pa", "p [MPa]", 1e-6}, pressure);
    rows.add({"p_star", "p*", 1, 3}, relative);
    rows.add({"stiffness_Pa_per_m", "K/A0 [GPa/µm]", 1e-15}, stiffness);
    rows.add({"stiffness_error_Pa_per_m", "+- grid", 1e-15, 2}, error);
    rows.add({"separation_m", "separation [µm]", 1e6}, gap);
    rows.add({"separation_error_m", "+- grid", 1e6, 2}, gap_error);
    rows.add({"real_area_fraction", "contact share"}, area);
    rows.add({"contacts", "contacts"}, spots);
    rows.add({"max_pressure_Pa", "largest p [GPa]", 1e-9}, largest);
    rows.add({"converged", "converged"}, converged);
    return rows;
}

Json truth_json(const TruthOfMap& solved) {
    Json document = json_document("truth");
    document["map"] = solved.file;
    document["points"] = solved.points;
    document["edges"] = name_of(solved.edges);
    document["effective_modulus_Pa"] = solved.modulus;
    document["rms_height_m"] = solved.rms_height;
    document["rms_gradient"] = solved.rms_gradient;
    Json& rows = document["rows"] = Json::array();
    rows_of(solved).append_to(rows);
    return document;
}

}  // namespace fstiff::scene
