// SPDX-License-Identifier: BSD-3-Clause
#include "surface/documents.hpp"

#include "surface/surface_option_table.hpp"

#include <fstiff/measured/pooled_surface.hpp>

#include <cmath>

namespace fstiff::scene {
namespace {

Json json_of(const RoughnessTable& table) {
    Json object = {{"standard", table.standard}};
    put_cut_offs(object, table.cut_offs);
    Json reasons = Json::object();
    for (const RoughnessLine& line : table.lines) {
        const std::string key = line.symbol + (line.unit.empty() ? "" : "_" + line.unit);
        object[key] = line.value ? Json(*line.value) : Json();
        if (!line.value) reasons[key] = line.meaning;
    }
    if (!table.sections.empty()) {
        object["section_length_m"] = table.section_length > 0 ? Json(table.section_length) : Json();
        object["sections"] = table.sections;
    }
    if (table.files > 1) object["mean_of_files"] = table.files;
    object["reasons"] = std::move(reasons);
    return object;
}

}  // namespace

void put_cut_offs(Json& document, const parts::CutOffs<double>& cut_offs) {
    document["lambda_s_m"] = cut_offs.lambda_s ? Json(*cut_offs.lambda_s) : Json();
    document["lambda_c_m"] = cut_offs.lambda_c ? Json(*cut_offs.lambda_c) : Json();
    document["filter"] = cut_offs.lambda_c ? Json(name_of(cut_offs.filter)) : Json();
}

void put_grid(Json& document, const HeightMap<double>& map, std::size_t missing,
              const parts::CutOffs<double>& cut_offs) {
    document["columns"] = map.columns();
    document["rows"] = map.rows();
    document["dx_m"] = map.dx;
    document["dy_m"] = map.dy;
    document["missing_points"] = missing;
    put_cut_offs(document, cut_offs);
}

Json json_source(const SurfaceOptions& options, const SurfaceInput& input) {
    return {{"file", display_name(options.file)},
            {"sha256", input.sha256},
            {"format", io::surface_format_name(input.surface.record.format)},
            {"kind", input.surface.is_profile() ? "profile" : "map"},
            {"decisions", input.surface.record.sentences()}};
}

namespace {

Json json_of(bool value) { return value; }
Json json_of(int value) { return value; }
Json json_of(double value) { return value; }
Json json_of(const std::string& text) { return text; }
Json json_of(const Amount& given) { return given.text("m"); }
template <parts::NamedEnum Enum>
Json json_of(Enum value) {
    return name_of(value);
}
template <parts::NamedEnum Enum>
Json json_of(const std::optional<Enum>& value) {
    return value ? Json(name_of(*value)) : Json("");
}

Json json_of_option(const SurfaceOptionRow& row, const SurfaceOptions& options) {
    return row.visit(options, [](const auto& value) { return json_of(value); });
}

}  // namespace

Json json_inputs(const SurfaceOptions& options, const std::string& form) {
    const SurfaceOptions defaults;
    Json inputs = Json::object();
    for (const bool always : {true, false})
        for (const SurfaceOptionRow& row : surface_option_table()) {
            if (row.group == OptionGroup::estimate || (row.echo == Echo::always) != always) continue;
            if (always || !row.has_same(options, defaults)) inputs[row.json_name()] = json_of_option(row, options);
        }
    inputs["detrend"] = form;
    return inputs;
}

namespace {

/// Parameters of \p of, or of one of its neighbours.
void put_found(Json& document, const MeasuredSurface& of, const Surface<double>& found) {
    put_cut_offs(document, found.cut_offs);
    Json& values = document["surface"] = Json::object();
    for (const ParameterLine& line : parameter_lines(of, found)) {
        Json& entry = values[line.name] = Json::object();
        if (!line.unit.empty()) entry["quantity"] = shortest(line.measured.value) + " " + line.unit;
        entry["value"] = line.measured.value;
        entry["error"] = line.measured.error;
        if (!line.unit.empty()) entry["unit"] = line.unit;
        entry["how"] = line.how;
    }
    if (!found.why_no_density.empty()) document["no_peak_density"] = found.why_no_density;
    if (found.fractal_dimension) document["fractal_dimension_window_error"] = found.dimension_window_error;
    if (std::isfinite(found.widest_band)) document["widest_band"] = found.widest_band;
    if (const auto& end = found.long_end; end.side > 0)
        document["long_end"] = {{"side_m", end.side},     {"hurst", end.hurst}, {"open", end.open},
                                {"log_error", end.error}, {"law", end.law},     {"form_share", end.form_share}};
    if (!found.heights) return;
    const SpectralMoments<double>& moments = found.heights->moments;
    document["moments"] = {
        {"m0_m2", moments.m0}, {"m2", moments.m2}, {"m4_per_m2", moments.m4}, {"alpha", moments.bandwidth()}};
    document["shape_share"] = found.shape_share;
}

}  // namespace

Json measured_document(const MeasuredSurface& surface) {
    const Surface<double>& found = surface.found;
    Json document = json_document("measure");
    document["source"] = {{"file", surface.file},
                          {"sha256", surface.sha256},
                          {"kind", surface.kind},
                          {"decisions", surface.decisions},
                          {"warnings", surface.of_file}};
    put_found(document, surface, found);
    for (const Surface<double>& neighbour : found.neighbours) {
        Json of;
        put_found(of, surface, neighbour);
        Json one = {{"lambda_s_m", of["lambda_s_m"]}, {"lambda_c_m", of["lambda_c_m"]},
                    {"surface", of["surface"]},       {"widest_band", of["widest_band"]},
                    {"moments", of["moments"]},       {"shape_share", neighbour.shape_share}};
        if (!neighbour.why_no_density.empty()) one["no_peak_density"] = neighbour.why_no_density;
        document["neighbours"].push_back(std::move(one));
    }
    if (!found.why_no_dimension.empty()) document["no_fractal_dimension"] = found.why_no_dimension;
    if (!found.why_no_peaks.empty()) document["no_r_and_theta"] = found.why_no_peaks;
    Json names = Json::array(), rows = Json::array();
    for (std::size_t i = 0; i < parts::surface_parameter_count; ++i) {
        names.push_back(parts::parameter_table[i].key);
        Json row = Json::array();
        for (const double one : found.correlation[i]) row.push_back(one);
        rows.push_back(std::move(row));
    }
    document["correlation_of_errors"] = {{"of", std::move(names)}, {"matrix", std::move(rows)}};
    Json& concerns = document["concerns"] = Json::array();
    for (const MeasuredConcern concern : found.concerns) concerns.push_back(name_of(concern));
    document["warnings"] = surface.warnings;
    return document;
}

RoughnessTable roughness_of(const MeasuredSurface& surface, const CutOff<double>& lambda_c) {
    if (surface.parts.empty())
        return about_file(surface.file, [&] {
            const Surface<double>& found = surface.found;
            return found.profile ? roughness_table(*found.profile, lambda_c) : roughness_table(*found.map);
        });
    const auto tables = [&](const CutOff<double>& of) {
        std::vector<RoughnessTable> all;
        for (const MeasuredSurface& part : surface.parts) all.push_back(roughness_of(part, of));
        return all;
    };
    const std::vector<RoughnessTable> by_table = tables(lambda_c);
    const CutOff<double> shared = parts::shared_cut_off(lambda_c, by_table, &parts::CutOffs<double>::lambda_c);
    return mean_of(shared.automatic() ? by_table : tables(shared));
}

Json measure_json(const MeasureOptions& options, const MeasuredSurface& surface) {
    Json document = measured_document(surface);
    for (const MeasuredSurface& part : surface.parts) {
        Json one = measured_document(part);
        document["files"].push_back({{"source", one["source"]},
                                     {"surface", one["surface"]},
                                     {"moments", one["moments"]},
                                     {"roughness", json_of(roughness_of(part))},
                                     {"concerns", one["concerns"]},
                                     {"warnings", one["warnings"]}});
    }
    document["inputs"] = json_inputs(options.input, options.input.detrend);
    for (const SurfaceOptionRow& row : surface_option_table())
        if (row.group == OptionGroup::estimate)
            document["inputs"][row.json_name()] = json_of_option(row, options.input);
    document["inputs"].update({{"resamples", options.resamples}, {"seed", options.seed}});
    document["roughness"] = json_of(roughness_of(surface));
    return document;
}

}  // namespace fstiff::scene
