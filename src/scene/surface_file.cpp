// SPDX-License-Identifier: BSD-3-Clause
#include "scene/surface_file.hpp"

#include "scene/cleaning.hpp"
#include "scene/shown_unit.hpp"
#include "scene/surface_instances.hpp"

#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/profile/robust_gaussian_filter.hpp>
#include <fstiff/surface/moments.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/robust_gaussian_map_filter.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace fstiff::scene {
namespace {

/// The form called \p name; \p more stands behind the choices in the refusal.
template <NamedEnum FormOf>
FormOf form_of(const SurfaceOptions& options, std::string_view name, std::string_view what,
               const std::string& more = "") {
    if (const auto form = find_named<FormOf>(name)) return *form;
    throw option_error(std::string(options.prefix) + "detrend = \"" + std::string(name) + "\": of a " +
                       std::string(what) + " must be one of " + choices_text<FormOf>() + more);
}

void refuse_cutoff(const SurfaceOptions& options) {
    if (!options.cutoff.empty())
        throw option_error(std::string(options.prefix) + "cutoff belongs to " + std::string(options.prefix) +
                           "detrend gaussian, of a profile; must not be given without it");
}

/// What a robust filter says of itself, in words behind others.
template <class Robust>
std::string left_out(const Robust& robust, Eigen::Index points) {
    return ", " + std::to_string(robust.left_out) + " of " + std::to_string(points) + " points without weight, " +
           std::to_string(robust.iterations) + " iterations" + (robust.converged ? "" : ", not converged");
}

/// Root of twice the mean square slope between neighbours.
double gradient_of(const Profile<double>& profile) {
    double sum = 0, pairs = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const double slope = (profile.heights[i] - profile.heights[i - 1]) / profile.spacing;
        if (std::isnan(slope)) continue;
        sum += slope * slope;
        pairs += 1;
    }
    return std::sqrt(2 * sum / std::max(pairs, 1.0));
}

/// \p levelled without its waves above lambda_c, by the filter that \p cut_offs name.
LevelledProfile<double> without_waves_above(CutOffs& cut_offs, LevelledProfile<double> levelled) {
    if (cut_offs.filter == CutOffFilter::gaussian) return without_waviness(std::move(levelled), *cut_offs.lambda_c);
    const RobustWaviness<double> robust = robust_waviness(levelled.profile, *cut_offs.lambda_c);
    cut_offs.left_out = left_out(robust, static_cast<Eigen::Index>(levelled.profile.present()));
    if (!levelled.unfiltered) levelled.unfiltered = levelled.profile;
    for (std::size_t i = 0; i < levelled.profile.size(); ++i) levelled.profile.heights[i] -= robust.waviness.heights[i];
    levelled.lambda_c = cut_offs.lambda_c;
    return levelled;
}

/// Takes the waves beyond the cut-offs of \p result, which has some, out of its map; what it was stays as unfiltered.
void apply_cut_offs(PreparedMap& result) {
    CutOffs& cut_offs = result.cut_offs;
    if (!result.unfiltered) result.unfiltered = std::make_shared<const HeightMap<double>>(std::move(result.map));
    const HeightMap<double>& before = *result.unfiltered;
    if (cut_offs.lambda_s)
        result.map = gaussian_low_pass(before, *cut_offs.lambda_s);
    else
        result.map = before;
    if (const auto longest = cut_offs.lambda_c) {
        if (cut_offs.filter == CutOffFilter::robust) {
            const RobustMapWaviness<double> robust = robust_waviness(result.map, *longest);
            result.map.heights -= robust.waviness.heights;
            cut_offs.left_out = left_out(robust, result.map.present());
        } else {
            result.map = gaussian_high_pass(result.map, *longest);
        }
        result.lambda_c = *longest;
    }
}

}  // namespace

double parse_length(const std::string& text, std::string_view name) {
    return parse_positive(text, io::Dimension::length, name);
}

LagWindow<double> parse_window(const std::string& text, std::string_view name) {
    const auto comma = text.find(',');
    if (comma == std::string::npos)
        throw option_error(std::string(name) + " = \"" + text + "\": must be two lengths, such as \"1 um,100 um\"");
    if (text.find(',', comma + 1) != std::string::npos)
        throw option_error(std::string(name) + " = \"" + text +
                           "\": must be two lengths with one comma between them; the decimal mark is the point");
    const LagWindow<double> window{parse_length(text.substr(0, comma), name),
                                   parse_length(text.substr(comma + 1), name)};
    if (!(window.from < window.to))
        throw option_error(std::string(name) + " = \"" + text + "\": the first length must be less than the second");
    return window;
}

std::size_t SurfaceInput::points() const {
    if (dropped) return dropped->points;
    return surface.is_profile() ? surface.profile().size() : static_cast<std::size_t>(surface.map().size());
}

std::size_t SurfaceInput::missing() const {
    if (dropped) return dropped->missing;
    return points() -
           (surface.is_profile() ? surface.profile().present() : static_cast<std::size_t>(surface.map().present()));
}

void SurfaceInput::drop_map() {
    dropped = Counts{points(), missing()};
    std::get<1>(surface.data).heights.resize(0, 0);
}

namespace {

/// Whether \p bytes are a JSON document of fstiff.
bool is_document(std::string_view bytes) {
    const auto first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '{' &&
           bytes.substr(first, 200).find("\"fstiff_version\"") != std::string_view::npos;
}

void clean_input(const SurfaceOptions& options, SurfaceInput& input) {
    about_file(options.file, [&] {
        clean(options, input.surface);
        for (std::string& hint : cleaning_hints(options, input.surface))
            input.surface.record.warnings.push_back(std::move(hint));
    });
}

}  // namespace

SurfaceInput surface_of_heights(const SurfaceOptions& options, io::ProfileOrMap heights, const std::string& origin) {
    SurfaceInput input;
    std::visit([&](const auto& surface) { about_file(options.file, [&] { surface.validate(); }); }, heights);
    const double* const first =
        heights.index() == 0 ? std::get<0>(heights).heights.data() : std::get<1>(heights).heights.data();
    input.surface.data = std::move(heights);
    input.sha256 = sha256({reinterpret_cast<const char*>(first), input.points() * sizeof(double)});
    input.surface.record.name = display_name(options.file);
    input.surface.record.format = io::SurfaceFormat::npy;
    input.surface.record.format_from = origin;
    clean_input(options, input);
    return input;
}

SurfaceInput read_surface_input(const SurfaceOptions& options) {
    return read_surface_input(options, read_all(options.file));
}

SurfaceInput read_surface_input(const SurfaceOptions& options, std::string bytes) {
    if (is_document(bytes))
        throw domain_error(display_name(options.file) +
                           ": is JSON that fstiff printed; must be a profile or a map (run --surface and surface.from "
                           "read the JSON of fstiff measure)");
    io::SurfaceOptions how;
    how.format = io::surface_format(options.format);
    how.units = options.units;
    if (!options.prefix.empty()) how.names = {std::string(options.prefix), std::string(options.format_name), " "};
    how.column = static_cast<std::size_t>(options.column);
    how.x_column = static_cast<std::size_t>(options.x_column);
    const auto length = [&](const std::string& text, const char* name) {
        return text.empty() ? std::optional<double>() : parse_length(text, std::string(options.prefix) + name);
    };
    how.spacing = length(options.spacing, "spacing");
    how.dx = length(options.dx, "dx");
    how.dy = length(options.dy, "dy");
    how.width = length(options.width, "width");
    how.height = length(options.height, "height");
    how.missing = options.missing;
    how.resample = options.resample;
    if (!options.x3p_increment.empty())
        how.x3p_increment = parse<io::X3pIncrement>(
            options.x3p_increment,
            std::string(options.prefix) + (options.prefix.empty() ? "x3p_increment" : "x3p-increment"));
    how.channel = options.channel;
    SurfaceInput input;
    input.sha256 = sha256(bytes);
    input.surface = io::read_surface(std::move(bytes), display_name(options.file), how);
    clean_input(options, input);
    return input;
}

PreparedProfile level_profile(const SurfaceOptions& options, const SurfaceInput& input) {
    if (!input.surface.is_profile())
        throw domain_error(display_name(options.file) + ": holds a map (" +
                           std::to_string(input.surface.map().columns()) + " x " +
                           std::to_string(input.surface.map().rows()) + " points); must be a profile");
    PreparedProfile result;
    result.form = options.detrend.empty() ? "line" : options.detrend;
    const bool filter = result.form == gaussian_form;
    const Form form =
        filter ? Form::line : form_of<Form>(options, result.form, "profile", ", " + std::string(gaussian_form));
    const std::string name = std::string(options.prefix) + "cutoff";
    if (!filter) refuse_cutoff(options);
    if (filter && options.cutoff.empty())
        throw option_error(std::string(options.prefix) + "detrend gaussian needs " + name + ", such as \"0.8 mm\"");
    const Profile<double>& read = input.surface.profile();
    if (filter && !options.lambda_c.empty() && options.lambda_c != "none")
        throw option_error(std::string(options.prefix) + "detrend gaussian has the cut-off " + name +
                           " already; must not stand beside another cut-off of long waves");
    CutOffs& cut_offs = result.cut_offs = cut_offs_of(options, read.spacing, read.length());
    about_file(options.file, [&] {
        result.rms_as_read = rms_height(read);
        auto& levelled = static_cast<LevelledProfile<double>&>(result);
        levelled = level(read, form, filter ? cut_offs.lambda_c : std::nullopt, input.surface.record.resolution,
                         cut_offs.lambda_s);
        result.rms_levelled = rms_height(result.profile);
        if (!filter && is_automatic(options.lambda_c)) choose_lambda_c(cut_offs, levelled.profile);
        if (!filter && cut_offs.lambda_c) levelled = without_waves_above(cut_offs, std::move(levelled));
        result.rms = rms_height(result.profile);
    });
    result.rms_gradient = gradient_of(result.profile);
    return result;
}

CutOffs map_cut_offs(const SurfaceOptions& options, const HeightMap<double>& map) {
    CutOffs cut_offs =
        cut_offs_of(options, std::max(map.dx, map.dy),
                    std::min(static_cast<double>(map.columns()) * map.dx, static_cast<double>(map.rows()) * map.dy));
    if (is_automatic(options.lambda_c))
        cut_offs.why_c = "an S-F surface of ISO 25178-2: the form alone bounds the long waves";
    return cut_offs;
}

namespace {

/// What is asked before anything is computed: that the surface is a map, and its form.
MapForm form_of_map(const SurfaceOptions& options, const SurfaceInput& input, PreparedMap& result) {
    if (input.surface.is_profile())
        throw domain_error(display_name(options.file) + ": holds a profile (" +
                           std::to_string(input.surface.profile().size()) + " points); must be a map");
    result.form = options.detrend.empty() ? "plane" : options.detrend;
    const MapForm form = form_of<MapForm>(options, result.form, "map");
    refuse_cutoff(options);
    return form;
}

/// Takes the form out of the map of \p input into \p result.
void take_form(const SurfaceInput& input, MapForm form, PreparedMap& result) {
    const HeightMap<double>& read = input.surface.map();
    static_cast<LevelledMap<double>&>(result) = level(read, form, input.surface.record.resolution);
    result.rms_as_read = rms_height(read);
    result.rms_levelled = rms_height(result.map);
}

/// Takes out the waves beyond the cut-offs of \p result, and finds its statistics.
void finish(PreparedMap& result) {
    if (result.cut_offs.any()) apply_cut_offs(result);
    result.areal = areal_statistics(result.map);
    result.rms = result.areal.rms_height;
}

}  // namespace

PreparedMap level_map(const SurfaceOptions& options, const SurfaceInput& input) {
    PreparedMap result;
    const MapForm form = form_of_map(options, input, result);
    result.cut_offs = map_cut_offs(options, input.surface.map());
    about_file(options.file, [&] {
        take_form(input, form, result);
        finish(result);
    });
    return result;
}

PreparedMap level_map_of(const SurfaceOptions& options, SurfaceInput& input) {
    PreparedMap result;
    const MapForm form = form_of_map(options, input, result);
    result.cut_offs = map_cut_offs(options, input.surface.map());
    about_file(options.file, [&] {
        take_form(input, form, result);
        input.drop_map();
        finish(result);
    });
    return result;
}

PreparedMap map_without_form(const SurfaceOptions& options, SurfaceInput& input) {
    PreparedMap result;
    const MapForm form = form_of_map(options, input, result);
    (void)map_cut_offs(options, input.surface.map());  // what is wrong with them is said before anything is computed
    about_file(options.file, [&] {
        take_form(input, form, result);
        input.drop_map();
        result.unfiltered = std::make_shared<const HeightMap<double>>(std::move(result.map));
    });
    return result;
}

PreparedMap with_cut_offs(const SurfaceOptions& options, PreparedMap without_form) {
    without_form.cut_offs = map_cut_offs(options, *without_form.unfiltered);
    about_file(options.file, [&] {
        if (!without_form.cut_offs.any()) {
            without_form.map = *without_form.unfiltered;
            without_form.unfiltered.reset();
        }
        finish(without_form);
    });
    return without_form;
}

std::string gradient_warning(double rms_gradient, std::string_view origin) {
    if (is_plausible_gradient(rms_gradient)) return "";
    const bool flat = rms_gradient < min_plausible_gradient<double>;
    return "the rms gradient" + (std::isfinite(rms_gradient) ? ", " + rounded(rms_gradient, 3) + "," : std::string()) +
           " is " + (flat ? "below 1e-06" : "above 1") + " (" + std::string(origin) + "): no rough surface is so " +
           (flat ? "flat" : "steep") + "; a unit of its lengths is likely wrong";
}

std::vector<std::string> reading_warnings(const SurfaceInput& input, std::string_view consequence,
                                          std::optional<double> rms_gradient) {
    std::vector<std::string> all = input.surface.record.warnings;
    if (rms_gradient && !is_plausible_gradient(*rms_gradient))
        all.push_back(gradient_warning(*rms_gradient, "measured"));
    if (input.missing() > 0)
        all.push_back(std::to_string(input.missing()) + " of " + std::to_string(input.points()) +
                      " points are missing; " + std::string(consequence));
    return all;
}

}  // namespace fstiff::scene
