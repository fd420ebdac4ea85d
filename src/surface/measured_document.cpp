// SPDX-License-Identifier: BSD-3-Clause
// The JSON of fstiff measure, read back.
#include "surface/measured_surface.hpp"

#include "document/file.hpp"
#include "surface/points_json.hpp"

#include <fstiff/measure/unmeasured_waves.hpp>
#include <nlohmann/json.hpp>

namespace fstiff::surface {
namespace {

using Parsed = nlohmann::ordered_json;

double number_of(const Parsed& object, const char* key, const std::string& place) {
    const auto entry = object.find(key);
    if (entry == object.end() || !entry->is_number())
        throw domain_error(place + "." + key + ": is missing or not a number; must be that of fstiff measure");
    return entry->get<double>();
}

Measurement<double> measurement_of(const Parsed& object, const std::string& place) {
    if (!object.is_object()) throw domain_error(place + ": must be an object with value and error");
    return {number_of(object, "value", place), number_of(object, "error", place)};
}

std::string text_of(const Parsed& object, const char* key) {
    const auto entry = object.find(key);
    return entry != object.end() && entry->is_string() ? entry->get<std::string>() : "";
}

std::vector<std::string> texts_of(const Parsed& object, const char* key) {
    std::vector<std::string> texts;
    if (const auto entry = object.find(key); entry != object.end() && entry->is_array())
        for (const Parsed& item : *entry)
            if (item.is_string()) texts.push_back(item.get<std::string>());
    return texts;
}

/// The long end of the spectrum; none in documents of an older fstiff.
LongEnd<double> long_end_of(const Parsed& document, const std::string& name) {
    const auto end = document.find("long_end");
    if (end == document.end() || !end->is_object()) return {};
    const auto number = [&](const char* key, double most) {
        const double value = number_of(*end, key, name + ": long_end");
        if (!(value >= 0 && value <= most))
            throw domain_error(name + ": long_end." + key + ": must be from 0 to " + document::rounded(most));
        return value;
    };
    return {number("side_m", 1e6),
            number("hurst", 1),
            number("open", 1),
            number("log_error", 1e3),
            end->contains("law") && end->at("law") == true,
            number("form_share", 1e3)};
}

/// The moments of the object \p moments, with the rms gradient \p gradient.
HeightStatistics<double> statistics_of(const Parsed& moments, const Measurement<double>& gradient,
                                       const std::string& place) {
    const auto moment = [&](const char* key) { return number_of(moments, key, place); };
    const HeightStatistics<double> heights{.rms_gradient = gradient,
                                           .moments = {moment("m0_m2"), moment("m2"), moment("m4_per_m2")}};
    if (!(heights.moments.m2 > 0 && heights.moments.bandwidth() > 0 && gradient.value > 0 && gradient.error >= 0))
        throw domain_error(place + ": must be greater than 0, and needs rms_gradient");
    return heights;
}

/// Parameters, moments and cut-offs of \p document, or of one of its neighbours.
Surface<double> values_of(const Parsed& document, const std::string& name) {
    if (!document.is_object()) throw domain_error(name + ": must be an object");
    const auto values = document.find("surface");
    if (values == document.end() || !values->is_object())
        throw domain_error(name + ": surface: is missing; must be that of fstiff measure");
    Surface<double> surface;
    const auto cut_off = [&](const char* key) -> std::optional<double> {  // absent from documents of an older fstiff
        const auto entry = document.find(key);
        if (entry == document.end() || entry->is_null()) return {};
        return number_of(document, key, name);
    };
    surface.cut_offs.lambda_s = cut_off("lambda_s_m");
    surface.cut_offs.lambda_c = cut_off("lambda_c_m");
    if (const std::string filter = text_of(document, "filter"); !filter.empty())
        surface.cut_offs.filter = from_name<CutOffFilter>(filter, name + ": filter");
    surface.why_no_density = text_of(document, "no_peak_density");
    const auto read = [&](const char* key) -> std::optional<Measurement<double>> {
        const auto entry = values->find(key);
        if (entry == values->end()) return std::nullopt;
        return measurement_of(*entry, name + ": surface." + key);
    };
    for (const detail::ParameterRow& row : detail::surface_parameter_table) {
        const std::string key(row.key);
        if (const auto measured = read(key.c_str()))
            surface.set(row.parameter, *measured);
        else if (row.parameter == Parameter::rms_height ||
                 (row.parameter <= Parameter::peak_density && surface.why_no_density.empty()))
            throw domain_error(name + ": surface." + key + ": is missing; must be that of fstiff measure");
    }
    surface.max_peak_height = read("max_peak_height").value_or(Measurement<double>{});
    surface.fractal_roughness = read("fractal_roughness");
    if (const auto window = document.find("fractal_dimension_window_error"); window != document.end())
        surface.dimension_window_error = number_of(document, "fractal_dimension_window_error", name);
    if (const auto widest = document.find("widest_band"); widest != document.end() && !widest->is_null())
        surface.widest_band = number_of(document, "widest_band", name);
    surface.long_end = long_end_of(document, name);
    if (const auto share = document.find("shape_share"); share != document.end()) {
        surface.shape_share = number_of(document, "shape_share", name);
        if (!(surface.shape_share >= 0 && surface.shape_share <= 1))
            throw domain_error(name + ": shape_share: must be from 0 to 1");
    }
    if (const auto moments = document.find("moments"); moments != document.end() && moments->is_object()) {
        surface.heights =
            statistics_of(*moments, read("rms_gradient").value_or(Measurement<double>{}), name + ": moments");
        surface.heights->skewness = read("skewness").value_or(Measurement<double>{});
        surface.heights->kurtosis = read("kurtosis").value_or(Measurement<double>{0, 0});
        surface.rms_gradient = surface.heights->rms_gradient;
    }
    if (const auto waves = document.find("all_waves"); waves != document.end() && surface.heights)
        surface.all_waves = statistics_of(
            *waves, measurement_of(waves->value("rms_gradient", Parsed()), name + ": all_waves.rms_gradient"),
            name + ": all_waves");
    return surface;
}

}  // namespace

bool is_measured_document(std::string_view bytes) {
    const auto first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '{' && !is_points_json(bytes);
}

MeasuredSurface read_measured_document(const std::string& bytes, const std::string& name) {
    const Parsed document = Parsed::parse(bytes, nullptr, false);
    if (!document.is_object() || text_of(document, "command") != "measure")
        throw domain_error(name +
                           ": is not the JSON of fstiff measure, whole and unchanged; must be that, or a surface");
    if (const auto version = document.find("schema_version"); version == document.end() || *version != 1)
        throw domain_error(name + ": schema_version must be 1");
    MeasuredSurface surface;
    Surface<double>& parameters = surface.found = values_of(document, name);
    if (const auto source = document.find("source"); source != document.end() && source->is_object()) {
        surface.file = text_of(*source, "file");
        surface.sha256 = text_of(*source, "sha256");
        surface.kind = text_of(*source, "kind");
        parameters.is_profile = surface.is_profile();
        surface.decisions = texts_of(*source, "decisions");
        surface.of_file = texts_of(source->contains("warnings") ? *source : document, "warnings");
    }
    surface.warnings = texts_of(document, "warnings");
    for (const std::string& word : texts_of(document, "concerns"))  // unknown words, of a later version, are left out
        if (const auto concern = detail::find_named<MeasuredConcern>(word)) parameters.concerns.push_back(*concern);
    parameters.why_no_dimension = text_of(document, "no_fractal_dimension");
    parameters.why_no_peaks = text_of(document, "no_r_and_theta");
    if (const auto correlation = document.find("correlation_of_errors");
        correlation != document.end() && correlation->is_object()) {
        const auto matrix = correlation->find("matrix");
        for (std::size_t i = 0; i < detail::surface_parameter_count; ++i)
            for (std::size_t j = 0; j < detail::surface_parameter_count; ++j) {
                const bool there = matrix != correlation->end() && matrix->is_array() && i < matrix->size() &&
                                   (*matrix)[i].is_array() && j < (*matrix)[i].size() && (*matrix)[i][j].is_number();
                if (!there) throw domain_error(name + ": correlation_of_errors.matrix: must be 6 rows of 6 numbers");
                parameters.correlation[i][j] = (*matrix)[i][j].get<double>();
            }
    }
    if (const auto neighbours = document.find("neighbours"); neighbours != document.end() && neighbours->is_array())
        for (std::size_t k = 0; k < neighbours->size(); ++k)
            parameters.neighbours.push_back(
                values_of((*neighbours)[k], name + ": neighbours[" + std::to_string(k) + "]"));
    document::about_file(
        name, [&] { detail::SurfaceSampler<double>(parameters, 0); });  // refuses what no sample could be drawn of
    return surface;
}

}  // namespace fstiff::surface
