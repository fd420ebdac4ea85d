// SPDX-License-Identifier: BSD-3-Clause
// fstiff spectrum: the power spectral density or the autocorrelation of a measured profile or map, as numbers and as a picture.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "input/scene_options.hpp"
#include "input/surface_options.hpp"
#include "picture/plot.hpp"
#include "picture/scale.hpp"
#include "surface/documents.hpp"
#include "document/shown_unit.hpp"
#include "instances/surface_instances.hpp"

#include <fstiff/core/version.hpp>

#include <cmath>
#include <memory>

namespace fstiff::cli {

/// What is computed.
enum class SpectrumKind { psd, acf };

}  // namespace fstiff::cli

namespace fstiff {

template <>
inline constexpr auto names<cli::SpectrumKind> = name_list<cli::SpectrumKind>({{cli::SpectrumKind::psd, "psd"},
                                                                               {cli::SpectrumKind::acf, "acf"}});

}  // namespace fstiff

namespace fstiff::cli {
namespace spectrum_command {
namespace {

struct Options {
    OutputOptions output;
    SurfaceOptions surface;
    std::string picture;
    SpectrumKind of = SpectrumKind::psd;
    SpectrumWindow taper = SpectrumWindow::hann;
};

/// One curve: where its values stand, and they.
struct Curve {
    std::string label, x_key, x_shown, key, shown;  ///< shown: as people read it
    double x_factor = 1, factor = 1;                ///< from SI to what they read
    std::vector<double> x, y;
    std::string count_key = {};  ///< of what a value is the mean of, where that is said
    std::vector<std::size_t> counts = {};
};

struct Result {
    std::vector<Curve> curves;
    std::string form, convention, source;  ///< how the numbers are normalised, and by whom
    double rms_as_read{}, rms{}, rms_gradient{};
    CutOffs<double> cut_offs;
};

Curve profile_psd(const std::string& label, const std::string& suffix, std::vector<double> wavenumber,
                  std::vector<double> value) {
    return {.label = label,
            .x_key = "wavenumber" + suffix + "_rad_per_m",
            .x_shown = "q" + suffix + " [rad/µm]",
            .key = "psd" + suffix + "_m3",
            .shown = "C" + suffix + " [µm³]",
            .x_factor = 1e-6,
            .factor = 1e18,
            .x = std::move(wavenumber),
            .y = std::move(value)};
}

Curve acf(const std::string& label, const std::string& suffix, std::vector<double> lag, std::vector<double> value) {
    return {.label = label,
            .x_key = "lag" + suffix + "_m",
            .x_shown = "lag" + suffix + " [µm]",
            .key = "acf" + suffix,
            .shown = "A" + suffix,
            .x_factor = 1e6,
            .x = std::move(lag),
            .y = std::move(value)};
}

std::vector<Curve> curves_of(const Options& options, const Profile<double>& profile) {
    if (options.of == SpectrumKind::acf) {
        const auto found = autocorrelation(profile);
        Curve curve = acf("autocorrelation", "", found.lag, found.value);
        curve.count_key = "pairs";
        curve.counts = found.pairs;
        return {curve};
    }
    if (const std::size_t missing = profile.size() - profile.present(); missing > 0)
        throw domain_error("profile with " + std::to_string(missing) +
                           " missing points: must be filled before its spectrum is taken");
    auto found = power_spectrum(profile, options.taper);
    found.wavenumber.erase(found.wavenumber.begin());  // at q = 0 stands the mean, which was removed
    found.value.erase(found.value.begin());
    return {profile_psd("profile", "", found.wavenumber, found.value)};
}

std::vector<Curve> curves_of(const Options& options, const HeightMap<double>& map) {
    if (options.of == SpectrumKind::psd) {
        auto found = radial_spectrum(map, options.taper);
        return {{.label = "all directions, C(q)",
                 .x_key = "wavenumber_rad_per_m",
                 .x_shown = "q [rad/µm]",
                 .key = "psd_m4",
                 .shown = "C [µm⁴]",
                 .x_factor = 1e-6,
                 .factor = 1e24,
                 .x = std::move(found.wavenumber),
                 .y = std::move(found.value),
                 .count_key = "waves",
                 .counts = std::move(found.waves)},
                profile_psd("sections along x", "_x", found.along_x.wavenumber, found.along_x.value),
                profile_psd("sections along y", "_y", found.along_y.wavenumber, found.along_y.value)};
    }
    const auto found = areal_autocorrelation(map);
    auto radial = radial_autocorrelation(found);
    Curve all = acf("mean of all directions", "", std::move(radial.lag), std::move(radial.value));
    all.count_key = "lags";
    all.counts = std::move(radial.lags);
    Curve x = acf("along x", "_x", {}, {}), y = acf("along y", "_y", {}, {});
    for (Eigen::Index i = 0; i <= found.reach_x; ++i) {
        x.x.push_back(static_cast<double>(i) * map.dx);
        x.y.push_back(found.at(i, 0));
    }
    for (Eigen::Index j = 0; j <= found.reach_y; ++j) {
        y.x.push_back(static_cast<double>(j) * map.dy);
        y.y.push_back(found.at(0, j));
    }
    return {all, x, y};
}

/// The window of a psd. The laws take the spectrum of a map and its mirror images, without one (topography/map_spectrum.hpp).
std::string window_of(const Options& options) {
    return options.taper == SpectrumWindow::hann ? "Hann window, divided by its mean square" : "no window";
}

std::string convention_of(const Options& options, bool profile) {
    if (options.of == SpectrumKind::acf)
        return "mean over the pairs of points of a lag of the product of their heights, over the mean square";
    const std::string scale = profile
                                  ? "one-sided, int C dq = mean square height; "
                                  : "2 pi int q C dq = mean square height; C_x, C_y one-sided, means of all sections; ";
    return scale + window_of(options);
}

std::string source_of(const Options& options, bool profile) {
    if (options.of == SpectrumKind::acf) return profile ? "ISO 21920-2:2021" : "ISO 25178-2:2021";
    return profile ? "Jacobs, Junge, Pastewka 2017, whose C_1D is pi C"
                   : "Persson et al. 2005, C(q); Nayak 1971, C_x and C_y";
}

Result compute(const Options& options, const SurfaceInput& input) {
    const auto result_of = [&](const auto& levelled, const auto& heights, bool profile, double gradient) {
        return Result{.curves = about_file(options.surface.file, [&] { return curves_of(options, heights); }),
                      .form = form_name(levelled),
                      .convention = convention_of(options, profile),
                      .source = source_of(options, profile),
                      .rms_as_read = levelled.rms_as_read,
                      .rms = levelled.rms,
                      .rms_gradient = gradient,
                      .cut_offs = levelled.cut_offs};
    };
    if (input.surface.is_profile()) {
        const PreparedProfile<double> levelled = level_profile(options.surface, input);
        return result_of(levelled, levelled.profile, true, levelled.rms_gradient);
    }
    const PreparedMap<double> levelled = level_map(options.surface, input);
    return result_of(levelled, levelled.map, false, levelled.areal.rms_gradient);
}

/// \p values and then nothing, as many in all as the longest curve has; nothing where a lag has no pair.
template <class Values>
std::vector<Cell> padded(const Values& values, std::size_t size) {
    std::vector<Cell> cells;
    for (const auto value : values)
        cells.push_back(std::isnan(static_cast<double>(value)) ? Cell(Cell::Kind::null) : Cell(value));
    cells.resize(size, Cell(Cell::Kind::null));
    return cells;
}

Rows rows_of(const Result& result) {
    std::size_t size = 0;
    for (const Curve& curve : result.curves) size = std::max(size, curve.x.size());
    Rows rows;
    for (const Curve& curve : result.curves) {
        rows.add({curve.x_key, curve.x_shown, curve.x_factor}, padded(curve.x, size));
        rows.add({curve.key, curve.shown, curve.factor}, padded(curve.y, size));
        if (!curve.count_key.empty()) rows.add({curve.count_key, curve.count_key}, padded(curve.counts, size));
    }
    return rows;
}

std::string title_of(const Options& options) {
    return std::string(options.of == SpectrumKind::psd ? "power spectral density" : "autocorrelation function") +
           " of " + shown_name(options.surface.file);
}

std::string table(const Options& options, const SurfaceInput& input, const Result& result) {
    std::string text = "fstiff " FSTIFF_VERSION ": " + title_of(options) + "\n" + source_lines(input, "  file     ");
    text += std::string(input.surface.is_profile() ? "  Rq       " : "  Sq       ") + shown_length(result.rms_as_read) +
            " as read, " + shown_length(result.rms) + " after removal of the form (" + result.form + ")\n";
    text += "  cut-offs " + sentence_of(result.cut_offs) + "\n";
    text += "  scale    " + result.convention + "\n  by       " + result.source + "\n\n";
    constexpr std::size_t shown = 24;
    const Rows rows = rows_of(result);
    const std::size_t step = (rows.size() + shown - 1) / shown;
    text += rows.text([&](std::size_t i) { return i % step == 0; });
    if (step > 1)
        text += "  every " + std::to_string(step) + ". of " + std::to_string(rows.size()) +
                " rows; all with --format csv\n";
    return text;
}

Json json(const Options& options, const SurfaceInput& input, const Result& result) {
    Json document = json_document("spectrum");
    document["source"] = json_source(options.surface, input);
    Json inputs = json_inputs(options.surface, result.form);
    inputs.update({{"of", name_of(options.of)}, {"taper", name_of(options.taper)}});
    document["inputs"] = inputs;
    document["convention"] = result.convention;
    document["by"] = result.source;
    document["missing_points"] = input.missing();
    put_cut_offs(document, result.cut_offs);
    document["rms_height_m"] = result.rms;
    document["rms_height_before_detrend_m"] = result.rms_as_read;
    document[name_of(options.of)] = rows_of(result).arrays();
    return document;
}

/// Means over shares of 2 % of q, so that a long spectrum can be seen.
Curve thinned(const Curve& curve) {
    Curve few = curve;
    few.x.clear();
    few.y.clear();
    for (std::size_t i = 0; i < curve.x.size();) {
        double x = 0, y = 0;
        std::size_t end = i;
        for (; end < curve.x.size() && curve.x[end] <= 1.02 * curve.x[i]; ++end) {
            x += curve.x[end];
            y += curve.y[end];
        }
        few.x.push_back(x / static_cast<double>(end - i));
        few.y.push_back(y / static_cast<double>(end - i));
        i = end;
    }
    return few;
}

/// The same horizontal axis in all panels.
void share_x(Figure& figure) {
    Range range;
    for (const Panel& panel : figure.panels)
        for (const PlotLine& line : panel.lines)
            for (const double x : line.x) range.add(x, panel.x.logarithmic);
    if (range.low < range.high && figure.panels.size() > 1)
        for (Panel& panel : figure.panels) panel.x.low = range.low, panel.x.high = range.high;
}

Figure figure_of(const Options& options, const Result& result) {
    const bool psd = options.of == SpectrumKind::psd;
    Figure figure{
        .title =
            (psd ? "Power spectral density of " : "Autocorrelation function of ") +
            shown_file(display_name(options.surface.file)),
        .panels = {},
        .note = "fstiff " FSTIFF_VERSION ", " + sentence_of(result.cut_offs) +
                (psd ? "; " + window_of(options) + "; means over 2 % of q" : "")};
    const auto begin_panel = [&](const std::string& title, const std::string& label) {
        figure.panels.push_back(psd ? Panel{.title = title, .x = {.label = "q [rad/µm]"}, .y = {.label = label}}
                                    : Panel{.title = title,
                                            .x = {.label = "lag", .logarithmic = false, .si = "m"},
                                            .y = {.label = label, .logarithmic = false}});
    };
    const bool map = result.curves.size() > 1;
    for (std::size_t k = 0; k < result.curves.size(); ++k) {
        const Curve curve = psd ? thinned(result.curves[k]) : result.curves[k];
        // C(q) in m^4 and the sections in m^3 do not share an axis
        if (k == 0) begin_panel(map && psd ? "All directions" : "", psd ? curve.shown : "A");
        if (k == 1 && psd) begin_panel("Sections", "C of a section [µm³]");
        PlotLine line{.label = map ? curve.label : "", .x = curve.x, .y = curve.y};
        for (std::size_t i = 0; psd && i < line.x.size(); ++i) {
            line.x[i] *= curve.x_factor;
            line.y[i] *= curve.factor;
        }
        figure.panels.back().lines.push_back(std::move(line));
    }
    share_x(figure);
    if (!psd) {
        std::vector<PlotLine>& lines = figure.panels.back().lines;
        double end = 0;
        for (const PlotLine& line : lines) end = std::max(end, line.x.back());
        lines.push_back({.label = std::string("0.2, which gives ") + (map ? "Sal and Str" : "Ral"),
                         .x = {0, end},
                         .y = {0.2, 0.2},
                         .colour = neutral,
                         .stroke = Stroke::dashed});
    }
    return figure;
}

Report execute(const Options& options) {
    if (!options.picture.empty()) keep_for_picture(options.picture);
    const SurfaceInput input = read_surface_input(options.surface);
    const Result result = compute(options, input);
    std::vector<std::string> files;
    if (!options.picture.empty()) files = write_figure(figure_of(options, result), options.picture);
    Report made = report({.table = [&] { return table(options, input, result); },
                          .csv = [&] { return rows_of(result).csv(); },
                          .json = [&] { return json(options, input, result); },
                          .warnings = reading_warnings(input, "their pairs are left out", result.rms_gradient),
                          .status = is_plausible_gradient(result.rms_gradient) ? success : doubtful_result},
                         options.output.format);
    say_written(made, files);
    return made;
}

}  // namespace
}  // namespace spectrum_command

Command add_spectrum(CLI::App& app) {
    using namespace spectrum_command;
    auto options = std::make_shared<Options>();
    Arguments command(app, "spectrum", "Power spectral density or autocorrelation of a measured profile or map");
    command.option("file", options->surface.file, "profile or map, as fstiff formats lists them; - is standard input")
        .required();
    command.option("--of", options->of,
                   "psd (default), the power spectral density, or acf, the autocorrelation function");
    command.option("--taper", options->taper,
                   "window that the heights are multiplied by before a psd: hann (default), or none for a surface that "
                   "repeats itself");
    add_surface_options(command, options->surface);
    add_output_options(command, options->output);
    add_picture_option(command, options->picture, "draw the curves");
    command.footer(
        "Of a map: C(q) over all directions, and the mean of its sections along x and along y. The CSV holds every "
        "value.\n"
        "Example:\n"
        "  fstiff generate map --points 256 --spacing \"0.5 um\" --hurst 0.8 --rms \"1 um\" --shortest \"4 um\" |\n"
        "      fstiff spectrum -");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
