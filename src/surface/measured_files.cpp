// SPDX-License-Identifier: BSD-3-Clause
// Several files of one surface as one.
#include "surface/measured_surface.hpp"
#include "document/shown_unit.hpp"
#include "instances/surface_instances.hpp"

#include <fstiff/measured/pooled_surface.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fstiff::scene {
namespace {

/// \p names with the files of a folder in its place.
std::vector<std::string> without_folders(const std::vector<std::string>& names) {
    std::vector<std::string> files;
    for (const std::string& name : names) {
        std::error_code none;
        if (!std::filesystem::is_directory(name, none)) {
            files.push_back(name);
            continue;
        }
        std::vector<std::string> inside;
        std::error_code unreadable;
        for (const auto& entry : std::filesystem::directory_iterator(name, unreadable))
            if (entry.is_regular_file(none) && !entry.path().filename().string().starts_with('.'))
                inside.push_back(entry.path().string());
        if (unreadable) throw file_error(name, "cannot be read: " + unreadable.message());
        if (inside.empty()) throw domain_error(name + ": is a folder without files; must hold files of one surface");
        std::sort(inside.begin(), inside.end());
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

/// Shortest and longest of the two steps; once more of a profile.
std::pair<double, double> steps(const MeasuredSurface& one) {
    if (one.profile) return {one.profile->profile.spacing, one.profile->profile.spacing};
    return std::minmax(one.map->map.dx, one.map->map.dy);
}

bool differ(double a, double b) { return std::abs(a - b) > 1e-6 * std::abs(a); }

/// \throws domain_error unless \p one can be pooled with \p first.
void require_alike(const MeasuredSurface& first, const MeasuredSurface& one, const SurfaceOptions& options) {
    if (one.kind != first.kind)
        throw domain_error(one.file + ": is a " + one.kind + ", and " + first.file + " a " + first.kind +
                           "; files of one surface must be of one kind");
    const std::string short_name = options.name("lambda_s");
    const auto alike = [](const std::optional<double>& a, const std::optional<double>& b) {
        return a.has_value() == b.has_value() && (!a || !differ(*a, *b));
    };
    const auto shown = [](const std::optional<double>& a) { return a ? shown_length(*a) : std::string("none"); };
    if (!alike(one.cut_offs.lambda_s, first.cut_offs.lambda_s))
        throw domain_error(one.file + ": lambda_s " + shown(one.cut_offs.lambda_s) + ", that of " + first.file + " " +
                           shown(first.cut_offs.lambda_s) + "; files of one surface must have one " + short_name);
    if (!alike(one.cut_offs.lambda_c, first.cut_offs.lambda_c))
        throw domain_error(one.file + ": lambda_c " + shown(one.cut_offs.lambda_c) + ", that of " + first.file + " " +
                           shown(first.cut_offs.lambda_c) + "; files of one surface must have one " +
                           options.name("lambda_c"));
    if (!one.cut_offs.lambda_s &&
        (differ(steps(one).first, steps(first).first) || differ(steps(one).second, steps(first).second)))
        throw domain_error(one.file + ": has points " + shown_length(steps(one).first) + " apart, and " + first.file +
                           " " + shown_length(steps(first).first) + "; files of unlike steps must have one " +
                           short_name);
}

/// Cut-offs that the table chose differently for \p parts become the longest of them in \p options, or none where one part
/// has none. Returns whether there are such.
bool share_cut_offs(SurfaceOptions& options, const std::vector<MeasuredSurface>& parts) {
    const auto share = [&](Lengths& option, std::optional<double> CutOffs<double>::*of) {
        if (!parse_cut_off(option, "").automatic()) return false;
        const auto shorter = [&](const MeasuredSurface& a, const MeasuredSurface& b) {
            return (a.cut_offs.*of).value_or(0) < (b.cut_offs.*of).value_or(0);
        };
        const auto [low, high] = std::minmax_element(parts.begin(), parts.end(), shorter);
        const std::optional<double> least = low->cut_offs.*of, most = high->cut_offs.*of;
        if (!most || (least && !differ(*least, *most))) return false;
        option = least ? Lengths(*most) : Lengths("none");
        return true;
    };
    const bool short_waves = share(options.lambda_s, &CutOffs<double>::lambda_s);
    const bool long_waves = options.detrend != gaussian_form && share(options.lambda_c, &CutOffs<double>::lambda_c);
    return short_waves || long_waves;
}

MeasuredFace<double> measured_face(const MeasuredSurface& one) {
    const UncertainSurface<double>& p = one.parameters;
    const auto known = [&](Parameter which) {
        const std::size_t i = index_of(which);
        return p.known[i] ? std::optional(p.value[i]) : std::nullopt;
    };
    MeasuredFace<double> of;
    of.face.roughness = {*known(Parameter::rms_height), *known(Parameter::peak_radius), *known(Parameter::peak_density),
                         one.max_peak_height.value};
    const Roughness<double>& r = of.face.roughness;
    of.face.moments =
        one.heights ? one.heights->moments : moments_of_peaks(r.rms_height, r.peak_radius, r.peak_density);
    of.face.fractal_dimension = known(Parameter::fractal_dimension);
    if (one.fractal_roughness) of.face.fractal_roughness = one.fractal_roughness->value;
    of.face.r = known(Parameter::r);
    of.face.theta = known(Parameter::theta);
    of.uncertain = p;
    of.size = one.size();
    return of;
}

/// How much of the shape of all heights counts; where some are not kept, the mean of what counts of each.
double share_of(const std::vector<MeasuredSurface>& parts) {
    ShapeOfHeights<double> all;
    double sum = 0, size = 0;
    bool kept = true;
    for (const MeasuredSurface& part : parts) {
        if (part.profile) all.add(part.profile->profile);
        if (part.map) all.add(part.map->map);
        kept = kept && (part.profile || part.map);
        sum += part.size() * part.shape_share, size += part.size();
    }
    return kept ? all.share() : size > 0 ? sum / size : 0;
}

/// The names of \p files, or the first and how many more.
std::string names_of(const std::vector<MeasuredSurface>& parts) {
    std::string text;
    for (const MeasuredSurface& part : parts) text += (text.empty() ? "" : ", ") + part.file;
    return text.size() <= 80 ? text : parts.front().file + " and " + std::to_string(parts.size() - 1) + " more files";
}

/// What is said of all of \p parts is said once, the rest with the name of the file.
void gather_warnings(MeasuredSurface& whole) {
    const auto count = [&](const std::string& sentence) {
        return std::count_if(whole.parts.begin(), whole.parts.end(), [&](const MeasuredSurface& part) {
            return std::count(part.warnings.begin(), part.warnings.end(), sentence) > 0;
        });
    };
    for (const MeasuredSurface& part : whole.parts)
        for (const std::string& sentence : part.warnings) {
            const bool of_all = count(sentence) == std::ssize(whole.parts);
            if (!of_all)
                whole.warnings.push_back(part.file + ": " + sentence);
            else if (&part == &whole.parts.front())
                whole.warnings.push_back(sentence);
        }
}

/// The concerns of every file, and whether the pooled parameters are known.
std::vector<MeasuredConcern> concerns_of(const MeasuredSurface& whole) {
    std::vector<MeasuredConcern> all;
    const auto of_peaks = [](MeasuredConcern concern) {
        return concern == MeasuredConcern::few_peaks || concern == MeasuredConcern::radius_uncertain ||
               concern == MeasuredConcern::density_uncertain || concern == MeasuredConcern::parameter_unknown ||
               concern == MeasuredConcern::implausible_gradient;
    };
    for (const MeasuredConcern concern : whole.parts.front().concerns)
        if (!of_peaks(concern) && std::all_of(whole.parts.begin(), whole.parts.end(), [&](const MeasuredSurface& part) {
                return std::count(part.concerns.begin(), part.concerns.end(), concern) > 0;
            }))
            all.push_back(concern);
    if (std::any_of(whole.parts.begin(), whole.parts.end(), [](const MeasuredSurface& part) {
            return std::count(part.concerns.begin(), part.concerns.end(), MeasuredConcern::implausible_gradient) > 0;
        }))
        all.push_back(MeasuredConcern::implausible_gradient);
    const auto& p = whole.parameters;
    const auto pooled = [&](std::size_t i) { return Measurement<double>{p.value[i], p.error[i]}; };
    detail::add_peak_concerns(all, whole.peaks, pooled(index_of(Parameter::peak_radius)),
                              pooled(index_of(Parameter::peak_density)));
    const bool long_waves = std::count(all.begin(), all.end(), MeasuredConcern::long_waves) > 0;
    for (std::size_t i = 0; i < surface_parameter_count; ++i) {
        const bool told = long_waves && (i == index_of(Parameter::rms_height) || i == index_of(Parameter::r));
        if (!told && p.known[i] && !is_known(pooled(i))) {
            all.push_back(MeasuredConcern::parameter_unknown);
            break;
        }
    }
    return all;
}

MeasuredSurface pooled(std::vector<MeasuredSurface> parts) {
    MeasuredSurface whole;
    whole.parts = std::move(parts);
    std::vector<MeasuredFace<double>> faces;
    std::vector<HeightStatistics<double>> heights;
    std::vector<SizedMeasurement<double>> log_roughness, highest;
    std::vector<double> sizes;
    std::string hashes;
    for (const MeasuredSurface& part : whole.parts) {
        faces.push_back(measured_face(part));
        sizes.push_back(part.size());
        if (part.heights) heights.push_back(*part.heights);
        if (part.fractal_roughness)
            log_roughness.push_back({{std::log(part.fractal_roughness->value),
                                      part.fractal_roughness->error / part.fractal_roughness->value},
                                     part.size()});
        highest.push_back({part.max_peak_height, part.size()});
        whole.peaks += part.peaks;
        hashes += part.sha256 + "\n";
    }
    const MeasuredFace<double> mean = fstiff::pooled(faces);
    const MeasuredSurface& first = whole.parts.front();
    whole.file = names_of(whole.parts);
    whole.sha256 = sha256(hashes);
    whole.kind = first.kind;
    whole.cut_offs = first.cut_offs;
    whole.parameters = mean.uncertain;
    double sizes_with_dimension = 0;
    for (const MeasuredSurface& part : whole.parts)
        if (part.parameters.known[index_of(Parameter::fractal_dimension)]) {
            sizes_with_dimension += part.size();
            whole.dimension_window_error =
                std::hypot(whole.dimension_window_error, part.size() * part.dimension_window_error);
        }
    if (sizes_with_dimension > 0) whole.dimension_window_error /= sizes_with_dimension;
    whole.max_peak_height = {mean.face.roughness.max_peak_height, pooled_error(highest)};
    if (mean.face.fractal_roughness)
        whole.fractal_roughness = Measurement<double>{*mean.face.fractal_roughness,
                                                      *mean.face.fractal_roughness * pooled_error(log_roughness)};
    else
        whole.fractal_refusal = first.fractal_refusal;
    if (!mean.face.r) whole.peaks_refusal = first.peaks_refusal;
    whole.widest_band = 0;
    for (const MeasuredSurface& part : whole.parts) whole.widest_band = std::max(whole.widest_band, part.widest_band);
    if (heights.size() == sizes.size()) {
        whole.heights = fstiff::pooled(heights, sizes);
        whole.shape_share = share_of(whole.parts);
    }
    for (std::size_t k = 0; k < first.neighbours.size(); ++k) {
        std::vector<MeasuredSurface> neighbours;
        for (const MeasuredSurface& part : whole.parts)
            if (k < part.neighbours.size()) neighbours.push_back(part.neighbours[k]);
        if (neighbours.size() == whole.parts.size()) whole.neighbours.push_back(pooled(std::move(neighbours)));
    }
    whole.concerns = concerns_of(whole);
    whole.decisions = {std::to_string(whole.parts.size()) + " files pooled, each by its " +
                           (whole.kind == "profile" ? "length" : "area") + ": " + names_of(whole.parts),
                       sentence_of(whole.cut_offs),
                       "errors: those of the files, or of their scatter by Student's t where it is greater"};
    gather_warnings(whole);
    for (std::string& line : peak_warnings(whole.concerns, whole.peaks, whole.parameters))
        if (std::count(whole.warnings.begin(), whole.warnings.end(), line) == 0)
            whole.warnings.push_back(std::move(line));
    return whole;
}

}  // namespace

MeasuredSurface measure_files(MeasureOptions options, const std::vector<std::string>& names,
                              const ProgressHook& progress) {
    const std::vector<std::string> files = without_folders(names);
    std::vector<MeasuredSurface> parts;
    std::vector<std::string> copies;  // warnings of them
    const auto measure = [&] {
        parts.clear(), copies.clear();
        for (const std::string& file : files) {
            options.input.file = file;
            MeasuredSurface part = measure_surface(options, read_all(file), progress);
            const auto same = std::find_if(parts.begin(), parts.end(),
                                           [&](const MeasuredSurface& other) { return other.sha256 == part.sha256; });
            if (same == parts.end())
                parts.push_back(std::move(part));
            else
                copies.push_back(part.file + ": is the same file as " + same->file +
                                 ", byte for byte (SHA-256), and is not counted again");
        }
    };
    measure();
    const bool once = std::count(files.begin(), files.end(), "-") > 0;  // standard input is read once
    if (!once && share_cut_offs(options.input, parts)) measure();
    for (const MeasuredSurface& part : parts) require_alike(parts.front(), part, options.input);
    MeasuredSurface whole = parts.size() == 1 ? std::move(parts.front()) : pooled(std::move(parts));
    whole.warnings.insert(whole.warnings.begin(), copies.begin(), copies.end());
    return whole;
}

}  // namespace fstiff::scene
