// SPDX-License-Identifier: BSD-3-Clause
// Answers of commands to requests, as documents.
#include "c/measure.hpp"

#include "actions/answered.hpp"
#include "actions/export.hpp"
#include "actions/generate.hpp"
#include "actions/identify.hpp"
#include "actions/run.hpp"
#include "actions/spectrum.hpp"
#include "actions/ultrasound.hpp"
#include "io/number.hpp"
#include "request/values.hpp"
#include "surface/surface_option_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>

struct fstiff_document {
    std::string text;
    fstiff::document::Json numbers{};
    bool doubtful = false;
};

namespace fstiff::c {
namespace {

/// The options of a request, lines "key = value".
request::Values values_of(const char* text) {
    request::Values values;
    std::istringstream lines(text ? text : "");
    for (std::string line; std::getline(lines, line);) {
        const std::size_t sign = line.find('=');
        const std::string key(io::detail::trimmed(std::string_view(line).substr(0, sign)));
        if (key.empty() && sign == std::string::npos) continue;
        if (key.empty() || sign == std::string::npos)
            throw domain_error("options: \"" + line.substr(0, 40) + "\": must be key = value");
        values.add(key,
                   request::Value::of_text(std::string(io::detail::trimmed(std::string_view(line).substr(sign + 1))),
                                           request::Value::Giver::line));
    }
    return values;
}

template <class Request>
Request request_of(const char* options) {
    request::Values values = values_of(options);
    Request request;
    values.fill(request);
    if constexpr (requires { request.surface; }) values.fill(request.surface);
    values.require_known();
    return request;
}

/// The heights, or the file that \p options name.
std::optional<surface::SurfaceInput> surface_of(surface::SurfaceOptions& options, const fstiff_heights* heights) {
    if (!heights) return options.file.empty() ? std::nullopt : std::optional(read_surface_input(options));
    if (!options.file.empty()) throw domain_error("file: must not be given with heights");
    options.file = "heights";
    return input_of(options, taken(heights, "heights"));
}

std::optional<actions::MeasuredCurve> curve_of(const fstiff_measured_curve* given) {
    if (!given) return std::nullopt;
    const fstiff_measured_curve from = taken(given, "curve");
    require_array(from.pressures, from.count, "pressures");
    require_array(from.values, from.count, "values");
    const auto list = [&](const double* array) {
        return array ? std::span(array, from.count) : std::span<const double>();
    };
    return actions::curve_of_numbers(list(from.pressures), list(from.values), list(from.errors),
                                     from.is_reflection != 0, "curve");
}

scene::Scene scene_of(const char* text, std::size_t length, const char* name, const std::string& surface = {}) {
    if (!text && length > 0) refuse_null("scene");
    if (!text) return scene::read_scene(scene::builtin_scene, {.name = "built-in scene", .surface = surface});
    return scene::read_scene(std::string(text, length), {.name = name ? name : "scene", .surface = surface});
}

/// The numbers at \p path of \p document; "*" in it is every place of an array, where what is not there is null.
/// \throws argument_error where no place has the path.
std::vector<double> numbers_at(const document::Json& document, const std::string& path) {
    const std::size_t star = path.find('*');
    std::vector<double> numbers;
    bool known = false;
    const auto take = [&](const document::Json* json) {
        known = known || json;
        const std::vector<double> more =
            json ? fstiff::detail::located(fstiff::Place{.file = path}, [&] { return json->numbers(); })
                 : std::vector{std::numeric_limits<double>::quiet_NaN()};
        numbers.insert(numbers.end(), more.begin(), more.end());
    };
    if (star == std::string::npos) take(document.at(path));
    for (std::size_t i = 0; star != std::string::npos; ++i) {
        const std::string place = path.substr(0, star) + std::to_string(i);
        if (!document.at(place)) break;
        take(document.at(place + path.substr(star + 1)));
    }
    if (!known) throw argument_error(path + ": is not a path of the document");
    return numbers;
}

/// The text and the values of \p document; its warnings become the message.
fstiff_document* handle_of(const document::Document& document) {
    document::Json values = document.values();
    std::string text = document.file ? document.file() : values.str(), lines;
    for (const std::string& warning : document.warnings) lines += (lines.empty() ? "" : "\n") + warning;
    set_message(lines);
    return new fstiff_document{std::move(text), std::move(values), document.doubtful};
}

}  // namespace
}  // namespace fstiff::c

using namespace fstiff::c;

int fstiff_spectrum(const fstiff_heights* heights, const char* options, fstiff_document** made) {
    return made_by(made, [&] {
        auto request = request_of<fstiff::actions::SpectrumRequest>(options);
        auto input = surface_of(request.surface, heights);
        if (!input) throw fstiff::domain_error("file: is missing; heights or the option file must be given");
        return handle_of(document_of(request, std::move(input)));
    });
}

int fstiff_generate(const char* options, fstiff_document** made) {
    return made_by(made, [&] { return handle_of(document_of(request_of<fstiff::actions::GenerateRequest>(options))); });
}

int fstiff_ultrasound(const fstiff_measured_curve* curve, const char* options, fstiff_document** made) {
    return made_by(made, [&] {
        const auto request = request_of<fstiff::actions::ReflectionRequest>(options);
        return handle_of(document_of(request, curve_of(curve)));
    });
}

int fstiff_run(const char* scene, size_t length, const char* name, const char* options, fstiff_document** made) {
    return made_by(made, [&] {
        auto given = values_of(options);
        std::string surface;
        given.read("surface", surface);
        given.require_known();
        const auto read = scene_of(scene, length, name, surface);
        return handle_of(document_of(fstiff::actions::compute(read)));
    });
}

int fstiff_identify(const char* scene, size_t length, const char* name, const fstiff_measured_curve* curve,
                    const char* options, fstiff_document** made) {
    return made_by(made, [&] {
        const auto request = request_of<fstiff::actions::IdentifyRequest>(options);
        const auto read = scene_of(scene, length, name);
        return handle_of(document_of(read, identify_scene(read, request, curve_of(curve))));
    });
}

int fstiff_export(const char* scene, size_t length, const char* name, const char* options, fstiff_document** made) {
    return made_by(made, [&] {
        const auto request = request_of<fstiff::actions::ExportRequest>(options);
        return handle_of(document_of(scene_of(scene, length, name), request));
    });
}

int fstiff_document_text(const fstiff_document* document, char* buffer, size_t capacity, size_t* length) {
    return guarded([&] { return text_into(not_null(document, "document").text, buffer, capacity, length); });
}

int fstiff_document_word(const fstiff_document* document, const char* path, char* buffer, size_t capacity,
                         size_t* length) {
    return guarded([&] {
        const std::string key = &not_null(path, "path");
        const auto* known = not_null(document, "document").numbers.at(key);
        const std::string* word = known ? known->word() : nullptr;
        if (!word) throw argument_error(key + ": is not a path of a text in the document");
        return text_into(*word, buffer, capacity, length);
    });
}

int fstiff_document_numbers(const fstiff_document* document, const char* path, double* values, size_t capacity,
                            size_t* count) {
    return guarded([&] {
        const std::string key = &not_null(path, "path");
        const auto& from = not_null(document, "document").numbers;
        const auto numbers = numbers_at(from, key);
        not_null(count, "count") = numbers.size();
        if (!values && capacity == 0) return FSTIFF_OK;
        not_null(values, "values");
        if (capacity < numbers.size())
            throw argument_error("capacity = " + std::to_string(capacity) + ": must be at least " +
                                 std::to_string(numbers.size()) + " for " + key);
        std::transform(numbers.begin(), numbers.end(), values,
                       [](double number) { return std::isnan(number) ? 0 : number; });
        return FSTIFF_OK;
    });
}

int fstiff_document_is_doubtful(const fstiff_document* document) { return document && document->doubtful; }

void fstiff_document_free(fstiff_document* document) { delete document; }
