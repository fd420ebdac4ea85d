// SPDX-License-Identifier: BSD-3-Clause
#include "actions/measure.hpp"

#include "document/shown_unit.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/double/surfaces.hpp>
#include <fstiff/measure/pooled_surface.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>

#include <cmath>
#include <utility>

namespace fstiff::actions {

using document::Document, document::Json, surface::MeasuredSurface, surface::ParameterLine;

namespace {

Json roughness_json(const RoughnessTable& table) {
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

Json json_of_option(const surface::SurfaceOptionRow& row, const surface::SurfaceOptions& options) {
    return row.visit(options, []<class Value>(const Value& value) -> Json {
        if constexpr (std::is_same_v<Value, request::Amount>)
            return value.text("m");
        else if constexpr (std::is_same_v<Value, std::optional<io::X3pIncrement>>)
            return value ? Json(name_of(*value)) : Json("");
        else if constexpr (detail::NamedEnum<Value>)
            return name_of(value);
        else
            return value;
    });
}

/// The options as they were given.
Json json_inputs(const surface::SurfaceOptions& options, const std::string& form) {
    const surface::SurfaceOptions defaults;
    Json inputs = Json::object();
    for (const bool always : {true, false})
        for (const surface::SurfaceOptionRow& row : surface::surface_option_table()) {
            if (row.group == surface::OptionGroup::estimate || (row.echo == surface::Echo::always) != always) continue;
            if (always || !row.has_same(options, defaults)) inputs[row.json_name()] = json_of_option(row, options);
        }
    inputs["detrend"] = form;
    return inputs;
}

/// Parameters of \p surface, or of one of its neighbours.
void put_parameters(Json& document, const MeasuredSurface& surface, const Surface<double>& parameters) {
    put_cut_offs(document, parameters.cut_offs);
    Json& values = document["surface"] = Json::object();
    for (const ParameterLine& line : parameter_lines(surface, parameters)) {
        Json& entry = values[line.name] = Json::object();
        if (!line.unit.empty()) entry["quantity"] = document::shortest(line.measured.value) + " " + line.unit;
        entry["value"] = line.measured.value;
        entry["error"] = line.measured.error;
        if (!line.unit.empty()) entry["unit"] = line.unit;
        entry["how"] = line.how;
    }
    if (!parameters.why_no_density.empty()) document["no_peak_density"] = parameters.why_no_density;
    if (parameters.fractal_dimension) document["fractal_dimension_window_error"] = parameters.dimension_window_error;
    if (std::isfinite(parameters.widest_band)) document["widest_band"] = parameters.widest_band;
    if (const auto& end = parameters.long_end; end.side > 0)
        document["long_end"] = {{"side_m", end.side},     {"hurst", end.hurst}, {"open", end.open},
                                {"log_error", end.error}, {"law", end.law},     {"form_share", end.form_share}};
    if (!parameters.heights) return;
    const SpectralMoments<double>& moments = parameters.heights->moments;
    document["moments"] = {
        {"m0_m2", moments.m0}, {"m2", moments.m2}, {"m4_per_m2", moments.m4}, {"alpha", moments.bandwidth()}};
    document["shape_share"] = parameters.shape_share;
    if (const auto& waves = parameters.all_waves)
        document["all_waves"] = {
            {"rms_gradient", {{"value", waves->rms_gradient.value}, {"error", waves->rms_gradient.error}}},
            {"m0_m2", waves->moments.m0},
            {"m2", waves->moments.m2},
            {"m4_per_m2", waves->moments.m4}};
}

Json measure_json(const surface::MeasureOptions& options, const MeasuredSurface& surface, const RoughnessTable& table) {
    Json document = measured_document(surface);
    for (const MeasuredSurface& part : surface.parts) {
        Json entry = measured_document(part);
        document["files"].push_back({{"source", entry["source"]},
                                     {"surface", entry["surface"]},
                                     {"moments", entry["moments"]},
                                     {"roughness", roughness_json(roughness_of(part, {}, options.parallel))},
                                     {"concerns", entry["concerns"]},
                                     {"warnings", entry["warnings"]}});
    }
    document["inputs"] = json_inputs(options.input, options.input.detrend);
    for (const surface::SurfaceOptionRow& row : surface::surface_option_table())
        if (row.group == surface::OptionGroup::estimate &&
            (row.echo == surface::Echo::always || !row.has_same(options.input, {})))
            document["inputs"][row.json_name()] = json_of_option(row, options.input);
    document["inputs"].update({{"resamples", options.resamples}, {"seed", options.seed}});
    document["roughness"] = roughness_json(table);
    return document;
}

/// A parameter a row; \p file is the first column of the CSV, or empty.
document::Rows parameter_rows(const MeasuredSurface& surface, const std::string& file) {
    const std::vector<ParameterLine> lines = parameter_lines(surface);
    const auto unit = [](const ParameterLine& line) { return document::shown_unit(line.measured.value, line.unit); };
    document::Rows rows;
    if (!file.empty()) rows.repeat({.key = "file"}, file, lines.size());
    rows.add({"parameter", "parameter"}, lines, &ParameterLine::name);
    rows.add({"value"}, lines, [](const ParameterLine& line) { return line.measured.value; });
    rows.add({"error"}, lines, [](const ParameterLine& line) { return line.measured.error; });
    rows.add({"unit"}, lines, &ParameterLine::unit);
    rows.add({"", "value"}, lines, [&](const ParameterLine& line) {
        return document::rounded(line.measured.value * unit(line).factor, line.known ? 5 : 2);
    });
    rows.add({"", "+-"}, lines,
             [&](const ParameterLine& line) { return document::rounded(line.measured.error * unit(line).factor, 2); });
    rows.add({"", "unit"}, lines, [&](const ParameterLine& line) { return unit(line).name; });
    rows.add({"", "found by"}, lines, &ParameterLine::how);
    for (const Parameter which : {Parameter::peak_radius, Parameter::peak_density}) {
        if (surface.found.find(which)) continue;
        std::vector<document::Cell> cells{
            detail::row_of(which).key, {}, {}, "", {}, {}, "", "not known: " + surface.found.why_no_density};
        if (!file.empty()) cells.insert(cells.begin(), file);
        rows.add_row(std::move(cells));
    }
    return rows;
}

std::string text_of(const RoughnessTable& table) {
    const auto& lines = table.lines;
    const auto unit = [](const RoughnessLine& line) { return document::shown_unit(line.value.value_or(0), line.unit); };
    document::Rows rows;
    rows.add({"", "parameter"}, lines, &RoughnessLine::symbol);
    rows.add({"", "value"}, lines, [&](const RoughnessLine& line) {
        return line.value ? document::Cell(*line.value * unit(line).factor) : document::Cell();
    });
    rows.add({"", "unit"}, lines, [&](const RoughnessLine& line) { return line.value ? unit(line).name : ""; });
    rows.add({"", "meaning"}, lines, &RoughnessLine::meaning);
    return "\n  by " + table.standard + ", about the mean" +
           (table.files > 1 ? ": means of " + std::to_string(table.files) + " files" : "") + "\n  " +
           surface::sentence_of(table.cut_offs) + "\n" +
           (table.sections.empty()
                ? ""
                : "  sections: " + table.sections +
                      (table.section_length > 0 ? ", " + document::shown_length(table.section_length) : "") + "\n") +
           "\n" + rows.text();
}

using SharedSurface = std::shared_ptr<const MeasuredSurface>;
/// Null where it is computed once it is needed.
using SharedTable = std::shared_ptr<const RoughnessTable>;

/// That of a profile; null for a map, whose parameters take long, and where they refuse the profile.
SharedTable table_of_profile(const MeasuredSurface& surface) {
    if (!surface.is_profile()) return nullptr;
    try {
        return std::make_shared<const RoughnessTable>(roughness_of(surface));
    } catch (const domain_error&) {
        return nullptr;
    }
}

/// A warning that the lambda_c of the tables removes most of the heights; empty where it does not.
std::string removal_warning(const SharedTable& table) {
    if (!table || table->cut_offs.why_c == CutOffReason::given || !(table->removed > 0.5)) return "";
    return "lambda_c " + document::shown_length(*table->cut_offs.lambda_c) + ", that of Ra, removes " +
           document::shown_percent(table->removed) +
           " of the mean square height: most waves are longer than this cut-off, and Ra, Rq and Rz lack them (K has "
           "them)";
}

/// Adds the decisions about \p surface, \p line, and its tables; \p file as above.
void add_surface(Document& document, const SharedSurface& surface, const SharedTable& table, const std::string& file,
                 const std::string& line, const ParallelHook& parallel) {
    for (const std::string& decision : surface->decisions) document.line("  " + decision);
    document.text([line] { return line; });
    document.table(parameter_rows(*surface, file));
    document.text([=] { return text_of(table ? *table : roughness_of(*surface, {}, parallel)); });
}

}  // namespace

void put_cut_offs(Json& document, const CutOffs<double>& cut_offs) {
    document["lambda_s_m"] = cut_offs.lambda_s ? Json(*cut_offs.lambda_s) : Json();
    document["lambda_c_m"] = cut_offs.lambda_c ? Json(*cut_offs.lambda_c) : Json();
    document["filter"] = cut_offs.lambda_c ? Json(name_of(cut_offs.filter)) : Json();
}

void add_grid(Document& document, const surface::SurfaceInput& input, const PreparedMap<double>& levelled) {
    const HeightMap<double>& map = levelled.map;
    document.json.update({{"columns", map.columns()},
                          {"rows", map.rows()},
                          {"dx_m", map.dx},
                          {"dy_m", map.dy},
                          {"missing_points", input.missing()}});
    put_cut_offs(document.json, levelled.cut_offs);
    document.line("map", std::to_string(map.columns()) + " x " + std::to_string(map.rows()) + " points, dx " +
                             document::shown_length(map.dx) + ", dy " + document::shown_length(map.dy));
}

void add_source(Document& document, const surface::SurfaceOptions& options, const surface::SurfaceInput& input,
                const std::string& form) {
    const std::vector<std::string> decisions = input.surface.record.sentences();
    document.json["source"] = {{"file", document::display_name(options.file)},
                               {"sha256", input.sha256},
                               {"format", name_of(input.surface.record.format)},
                               {"kind", input.surface.is_profile() ? "profile" : "map"},
                               {"decisions", decisions}};
    document.json["inputs"] = json_inputs(options, form);
    for (const std::string& decision : decisions) document.line("file", decision);
}

void add_reading(Document& document, const surface::SurfaceInput& input, std::string_view consequence,
                 double rms_gradient) {
    for (std::string& warning : reading_warnings(input, consequence, rms_gradient))
        document.warnings.push_back(std::move(warning));
    document.doubtful = document.doubtful || !detail::is_plausible_gradient(rms_gradient);
}

Json measured_document(const MeasuredSurface& surface) {
    const Surface<double>& parameters = surface.found;
    Json document = document::json_document("measure");
    document["source"] = {{"file", surface.file},
                          {"sha256", surface.sha256},
                          {"kind", surface.kind},
                          {"decisions", surface.decisions},
                          {"warnings", surface.of_file}};
    put_parameters(document, surface, parameters);
    for (const Surface<double>& neighbour : parameters.neighbours) {
        Json values;
        put_parameters(values, surface, neighbour);
        Json entry = {{"lambda_s_m", values["lambda_s_m"]}, {"lambda_c_m", values["lambda_c_m"]},
                      {"surface", values["surface"]},       {"widest_band", values["widest_band"]},
                      {"moments", values["moments"]},       {"shape_share", neighbour.shape_share}};
        if (!neighbour.why_no_density.empty()) entry["no_peak_density"] = neighbour.why_no_density;
        document["neighbours"].push_back(std::move(entry));
    }
    if (!parameters.why_no_dimension.empty()) document["no_fractal_dimension"] = parameters.why_no_dimension;
    if (!parameters.why_no_peaks.empty()) document["no_r_and_theta"] = parameters.why_no_peaks;
    Json names = Json::array(), rows = Json::array();
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i) {
        names.push_back(detail::parameter_table[i].key);
        Json row = Json::array();
        for (const double entry : parameters.correlation[i]) row.push_back(entry);
        rows.push_back(std::move(row));
    }
    document["correlation_of_errors"] = {{"of", std::move(names)}, {"matrix", std::move(rows)}};
    Json& concerns = document["concerns"] = Json::array();
    for (const MeasuredConcern concern : parameters.concerns) concerns.push_back(name_of(concern));
    document["warnings"] = surface.warnings;
    return document;
}

RoughnessTable roughness_of(const MeasuredSurface& surface, const CutOff<double>& lambda_c,
                            const ParallelHook& parallel) {
    if (surface.parts.empty())
        return document::about_file(surface.file, [&] {
            const Surface<double>& parameters = surface.found;
            return parameters.profile ? roughness_table(*parameters.profile, lambda_c)
                                      : roughness_table(*parameters.map, parallel);
        });
    const auto tables = [&](const CutOff<double>& cut_off) {
        std::vector<RoughnessTable> parts;
        for (const MeasuredSurface& part : surface.parts) parts.push_back(roughness_of(part, cut_off, parallel));
        return parts;
    };
    const std::vector<RoughnessTable> by_table = tables(lambda_c);
    const CutOff<double> shared = detail::shared_cut_off(lambda_c, by_table, &CutOffs<double>::lambda_c);
    return mean_of(shared.automatic() ? by_table : tables(shared));
}

Document document_of(const surface::MeasureOptions& options, const std::shared_ptr<const MeasuredSurface>& surface) {
    Document document("measure");
    const SharedTable table = table_of_profile(*surface);
    document.warnings = surface->warnings;
    const std::string removal = removal_warning(table);
    if (!removal.empty()) document.warnings.push_back(removal);
    document.doubtful = is_doubtful(*surface);
    document.title("surface of " + document::printable(surface->file));
    add_surface(document, surface, table, surface->parts.empty() ? "" : "pooled", "\n", options.parallel);
    for (const MeasuredSurface& part : surface->parts) {
        document.line("\n" + document::printable(part.file));
        add_surface(document, SharedSurface(surface, &part), nullptr, part.file, "", options.parallel);
    }
    document.values([=](Json& to) {
        to = measure_json(options, *surface, table ? *table : roughness_of(*surface, {}, options.parallel));
        if (!removal.empty()) to["warnings"].push_back(removal);
    });
    return document;
}

}  // namespace fstiff::actions
