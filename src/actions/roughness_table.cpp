// SPDX-License-Identifier: BSD-3-Clause
// The roughness parameters of a measured surface, a line each.
#include "actions/measure.hpp"

#include <fstiff/double/surfaces.hpp>
#include <fstiff/measure/least_squares_form.hpp>
#include <fstiff/profile/autocorrelation.hpp>

#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace fstiff::actions {

namespace {

/// Appended to the other lines: Sk, Spk, Svk, Smr1 and Smr2, with the \p letter of the standard, or why they are none.
void add_material_ratio(RoughnessTable& table, const std::string& letter, std::span<const double> heights) {
    std::optional<detail::MaterialRatio<double>> ratio;
    const std::string refusal = detail::fit_or_reason(ratio, [&] { return detail::material_ratio(heights); });
    const auto add = [&](const char* symbol, const char* unit, double detail::MaterialRatio<double>::*field,
                         const char* meaning) {
        table.lines.push_back(
            {letter + symbol, unit, ratio ? std::optional((*ratio).*field) : std::nullopt, ratio ? meaning : refusal});
    };
    add("k", "m", &detail::MaterialRatio<double>::core_height, "core of the material ratio curve");
    add("pk", "m", &detail::MaterialRatio<double>::reduced_peak_height, "peaks above the core, as a triangle");
    add("vk", "m", &detail::MaterialRatio<double>::reduced_valley_depth, "valleys below the core, as a triangle");
    add("mr1", "", &detail::MaterialRatio<double>::peak_share, "share of the points above the core");
    add("mr2", "", &detail::MaterialRatio<double>::core_and_peak_share, "share of the points in and above the core");
}

}  // namespace

RoughnessTable roughness_table(const PreparedProfile<double>& levelled, const CutOff<double>& lambda_c) {
    const PreparedProfile<double> filtered = with_drawing_cut_off(detail::by_least_squares(levelled), lambda_c);
    const Profile<double>& profile = filtered.profile;
    const auto parameters = roughness_parameters(profile, filtered.cut_offs.lambda_c);
    const auto length = detail::autocorrelation_length(autocorrelation(profile));
    RoughnessTable table{.standard = "ISO 21920-2:2021",
                         .lines = {},
                         .sections = {},
                         .section_length = parameters.section_length,
                         .cut_offs = filtered.cut_offs};
    const double kept = filtered.rms / filtered.rms_levelled;
    table.removed = filtered.cut_offs.lambda_c ? 1 - kept * kept : 0;
    table.sections =
        parameters.by_cutoff ? "five of lambda_c, in the middle of the profile" : "five of a fifth of the profile each";
    if (parameters.sections < 5)
        table.sections += ", " + std::to_string(parameters.sections) + " of which have a point";
    table.lines = {{"Ra", "m", parameters.mean_deviation, "mean of the distances from the mean height"},
                   {"Rq", "m", parameters.rms_height, "root of their mean square"},
                   {"Rz", "m", parameters.section_height, "from pit to peak, mean over the sections"},
                   {"Rp", "m", parameters.section_peak_height, "highest peak, mean over the sections"},
                   {"Rv", "m", parameters.section_pit_depth, "deepest pit, mean over the sections"},
                   {"Rt", "m", parameters.total_height, "from the deepest pit to the highest peak of all"},
                   {"Rsk", "", parameters.skewness, "skewness"},
                   {"Rku", "", parameters.kurtosis, "kurtosis"},
                   {"Rdq", "", parameters.rms_slope,
                    parameters.rms_slope ? "root of the mean square slope, by seven points"
                                         : "there are no seven points in a row"},
                   {"RSm", "m", parameters.mean_spacing,
                    parameters.mean_spacing
                        ? "mean width of the elements, from pits to peaks beyond a tenth of Rz and 1 % of a section"
                        : "no element has a peak and a pit beyond a tenth of Rz and 1 % of a section"},
                   {"Ral", "m", length,
                    length ? "lag at which the autocorrelation falls to 0.2"
                           : "the autocorrelation stays above 0.2 to half of the length, or lacks a lag"}};
    add_material_ratio(table, "R", profile.heights);
    return table;
}

RoughnessTable roughness_table(const PreparedMap<double>& measured, const ParallelHook& parallel) {
    std::optional<PreparedMap<double>> of_squares;
    if (measured.settled) of_squares = detail::by_least_squares(measured);
    const PreparedMap<double>& levelled = of_squares ? *of_squares : measured;
    const HeightMap<double>& map = levelled.map;
    const bool has_directions = map.rows() >= 4 && map.columns() >= 4;
    ArealParameters<double> parameters;
    detail::TextureParameters<double> texture;
    std::optional<double> direction;
    RoughnessTable table{.standard = "ISO 25178-2:2021", .lines = {}, .sections = {}, .cut_offs = levelled.cut_offs};
    RoughnessTable ratio;  // the last lines of the table
    detail::run_pieces(parallel, 3, [&](std::size_t i) {
        if (i == 0) parameters = areal_parameters(map, levelled.areal);
        if (i == 1 && has_directions) {
            const auto correlation = detail::areal_autocorrelation(map);
            texture = detail::texture_parameters(correlation);
            direction = detail::texture_direction(correlation);
        }
        if (i == 2) add_material_ratio(ratio, "S", {map.heights.data(), static_cast<std::size_t>(map.size())});
    });
    table.lines = {{"Sa", "m", parameters.mean_deviation, "mean of the distances from the mean height"},
                   {"Sq", "m", parameters.rms_height, "root of their mean square"},
                   {"Sp", "m", parameters.max_peak_height, "highest peak"},
                   {"Sv", "m", parameters.max_pit_depth, "deepest pit"},
                   {"Sz", "m", parameters.max_height, "from the deepest pit to the highest peak"},
                   {"Ssk", "", parameters.skewness, "skewness"},
                   {"Sku", "", parameters.kurtosis, "kurtosis"},
                   {"Sdq", "", parameters.rms_gradient, "root of the mean square gradient"},
                   {"Sdr", "", parameters.developed_area_ratio,
                    parameters.developed_area_ratio ? "area of the surface over that of its plane, less 1"
                                                    : "no four points of a cell are all there"}};
    std::string no_length = has_directions ? "the autocorrelation stays above 0.2 to half of each side"
                                           : "the map has fewer than 4 x 4 points",
                no_ratio = no_length;
    if (texture.shortest && !texture.aspect_ratio)
        no_ratio = "below " + document::rounded(*texture.shortest / texture.longest, 3) + ": no fall to 0.2 at " +
                   document::rounded(texture.longest_direction * 180 / std::numbers::pi_v<double>, 3) +
                   " degrees from x";
    table.lines.push_back({"Sal", "m", texture.shortest,
                           texture.shortest ? "shortest lag at which the autocorrelation falls to 0.2" : no_length});
    table.lines.push_back({"Str", "", texture.aspect_ratio,
                           texture.aspect_ratio ? "that over the longest such lag; 1: no direction" : no_ratio});
    constexpr double degree = std::numbers::pi_v<double> / 180;
    table.lines.push_back({"Std", "deg", direction ? std::optional(*direction / degree) : std::nullopt,
                           direction        ? "direction of the ridges, from x towards y; without meaning near Str 1"
                           : has_directions ? "the map has no waves"
                                            : no_length});
    table.lines.insert(table.lines.end(), ratio.lines.begin(), ratio.lines.end());
    return table;
}

namespace {

/// Mean of \p values [\p unit]; that of directions is a direction, as 1 and 179 degrees are 2 degrees apart.
double mean_of(const std::vector<double>& values, const std::string& unit) {
    constexpr double half_turn = 180, radian = half_turn / std::numbers::pi_v<double>;
    double sum = 0, across = 0;
    for (const double value : values) {
        sum += unit == "deg" ? std::cos(2 * value / radian) : value;
        across += std::sin(2 * value / radian);
    }
    if (unit != "deg") return sum / static_cast<double>(values.size());
    return std::fmod(std::atan2(across, sum) * radian / 2 + half_turn, half_turn);
}

}  // namespace

RoughnessTable mean_of(const std::vector<RoughnessTable>& tables) {
    RoughnessTable mean = tables.front();
    mean.files = tables.size();
    mean.removed = 0;
    for (const RoughnessTable& table : tables) mean.removed += table.removed / static_cast<double>(tables.size());
    for (const RoughnessTable& table : tables)  // to a fifth of the profile: unlike where the lengths are
        if (table.sections != mean.sections || table.section_length != mean.section_length)
            mean.sections = "of each file by itself", mean.section_length = 0;
    for (std::size_t i = 0; i < mean.lines.size(); ++i) {
        std::vector<double> values;
        for (const RoughnessTable& table : tables) {
            const RoughnessLine& line = table.lines[i];
            if (line.value)
                values.push_back(*line.value);
            else if (mean.lines[i].value)
                mean.lines[i] = {line.symbol, line.unit, std::nullopt, "not of every file: " + line.meaning};
        }
        if (mean.lines[i].value) mean.lines[i].value = mean_of(values, mean.lines[i].unit);
    }
    return mean;
}

}  // namespace fstiff::actions
