// SPDX-License-Identifier: BSD-3-Clause
#include "actions/spectrum.hpp"

#include <fstiff/double/surfaces.hpp>
#include <fstiff/measure/least_squares_form.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include "actions/measure.hpp"

#include <algorithm>
#include <cmath>

namespace fstiff::actions {

using document::Cell;

namespace {

SpectrumCurve psd_curve(const std::string& label, const std::string& suffix, std::vector<double> wavenumber,
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

SpectrumCurve acf_curve(const std::string& label, const std::string& suffix, std::vector<double> lag,
                        std::vector<double> value) {
    return {.label = label,
            .x_key = "lag" + suffix + "_m",
            .x_shown = "lag" + suffix + " [µm]",
            .key = "acf" + suffix,
            .shown = "A" + suffix,
            .x_factor = 1e6,
            .x = std::move(lag),
            .y = std::move(value)};
}

std::vector<SpectrumCurve> curves_of(const SpectrumRequest& request, const Profile<double>& profile) {
    if (request.of == SpectrumKind::acf) {
        const auto spectrum = autocorrelation(profile);
        SpectrumCurve curve = acf_curve("autocorrelation", "", spectrum.lag, spectrum.value);
        curve.count_key = "pairs";
        curve.counts = spectrum.pairs;
        return {curve};
    }
    if (const std::size_t missing = profile.size() - profile.present(); missing > 0)
        throw domain_error("profile with " + std::to_string(missing) +
                           " missing points: must be filled before its spectrum is taken");
    auto spectrum = power_spectrum(profile, request.taper);
    spectrum.wavenumber.erase(spectrum.wavenumber.begin());  // at q = 0 is the mean, which was removed
    spectrum.value.erase(spectrum.value.begin());
    return {psd_curve("profile", "", spectrum.wavenumber, spectrum.value)};
}

std::vector<SpectrumCurve> curves_of(const SpectrumRequest& request, const HeightMap<double>& map) {
    if (request.of == SpectrumKind::psd) {
        auto spectrum = radial_spectrum(map, request.taper);
        return {{.label = "all directions, C(q)",
                 .x_key = "wavenumber_rad_per_m",
                 .x_shown = "q [rad/µm]",
                 .key = "psd_m4",
                 .shown = "C [µm⁴]",
                 .x_factor = 1e-6,
                 .factor = 1e24,
                 .x = std::move(spectrum.wavenumber),
                 .y = std::move(spectrum.value),
                 .count_key = "waves",
                 .counts = std::move(spectrum.waves)},
                psd_curve("sections along x", "_x", spectrum.along_x.wavenumber, spectrum.along_x.value),
                psd_curve("sections along y", "_y", spectrum.along_y.wavenumber, spectrum.along_y.value)};
    }
    const auto spectrum = detail::areal_autocorrelation(map);
    auto radial = detail::radial_autocorrelation(spectrum);
    SpectrumCurve mean = acf_curve("mean of all directions", "", std::move(radial.lag), std::move(radial.value));
    mean.count_key = "lags";
    mean.counts = std::move(radial.lags);
    SpectrumCurve x = acf_curve("along x", "_x", {}, {}), y = acf_curve("along y", "_y", {}, {});
    for (Eigen::Index i = 0; i <= spectrum.reach_x; ++i) {
        x.x.push_back(static_cast<double>(i) * map.dx);
        x.y.push_back(spectrum.at(i, 0));
    }
    for (Eigen::Index j = 0; j <= spectrum.reach_y; ++j) {
        y.x.push_back(static_cast<double>(j) * map.dy);
        y.y.push_back(spectrum.at(0, j));
    }
    return {mean, x, y};
}

std::string convention_of(const SpectrumRequest& request, bool profile) {
    if (request.of == SpectrumKind::acf)
        return "mean over the pairs of points of a lag of the product of their heights, over the mean square";
    const std::string scale = profile
                                  ? "one-sided, int C dq = mean square height; "
                                  : "2 pi int q C dq = mean square height; C_x, C_y one-sided, means of all sections; ";
    return scale + window_of(request);
}

std::string source_of(const SpectrumRequest& request, bool profile) {
    if (request.of == SpectrumKind::acf) return profile ? "ISO 21920-2:2021" : "ISO 25178-2:2021";
    return profile ? "Jacobs, Junge, Pastewka 2017, whose C_1D is pi C"
                   : "Persson et al. 2005, C(q); Nayak 1971, C_x and C_y";
}

/// \p values and then nothing, as many in all as the longest curve has; nothing where a lag has no pair.
template <class Values>
std::vector<Cell> padded(const Values& values, std::size_t size) {
    std::vector<Cell> cells;
    for (const auto value : values) cells.push_back(std::isnan(double(value)) ? Cell(Cell::Kind::null) : Cell(value));
    cells.resize(size, Cell(Cell::Kind::null));
    return cells;
}

/// A position a row.
document::Rows curve_rows(const Spectrum& spectrum) {
    std::size_t size = 0;
    for (const SpectrumCurve& curve : spectrum.curves) size = std::max(size, curve.x.size());
    document::Rows rows;
    for (const SpectrumCurve& curve : spectrum.curves) {
        rows.add({curve.x_key, curve.x_shown, curve.x_factor}, padded(curve.x, size));
        rows.add({curve.key, curve.shown, curve.factor}, padded(curve.y, size));
        if (!curve.count_key.empty()) rows.add({curve.count_key, curve.count_key}, padded(curve.counts, size));
    }
    return rows;
}

}  // namespace

// The laws take the spectrum of a map and its mirror images, without one (topography/map_spectrum.hpp).
std::string window_of(const SpectrumRequest& request) {
    return request.taper == SpectrumWindow::hann ? "Hann window, divided by its mean square" : "no window";
}

Spectrum spectrum_of(const SpectrumRequest& request, const surface::SurfaceInput& input) {
    const auto result_of = [&](const auto& levelled, const auto& heights, bool profile, double gradient) {
        return Spectrum{
            .curves = document::about_file(request.surface.file, [&] { return curves_of(request, heights); }),
            .form = surface::form_name(levelled),
            .convention = convention_of(request, profile),
            .source = source_of(request, profile),
            .rms_as_read = levelled.rms_as_read,
            .rms = levelled.rms,
            .rms_gradient = gradient,
            .cut_offs = levelled.cut_offs};
    };
    if (input.surface.is_profile()) {
        const PreparedProfile<double> levelled = detail::by_least_squares(level_profile(request.surface, input));
        return result_of(levelled, levelled.profile, true, levelled.rms_gradient);
    }
    const PreparedMap<double> levelled = detail::by_least_squares(level_map(request.surface, input));
    return result_of(levelled, levelled.map, false, levelled.areal.rms_gradient);
}

document::Document document_of(const SpectrumRequest& request, const surface::SurfaceInput& input,
                               const Spectrum& spectrum) {
    document::Document document("spectrum");
    document.title((request.of == SpectrumKind::psd ? "power spectral density of " : "autocorrelation function of ") +
                   document::shown_name(request.surface.file));
    add_source(document, request.surface, input, spectrum.form);
    document.json["inputs"].update({{"of", name_of(request.of)}, {"taper", name_of(request.taper)}});
    document.json["convention"] = spectrum.convention;
    document.json["by"] = spectrum.source;
    document.json["missing_points"] = input.missing();
    put_cut_offs(document.json, spectrum.cut_offs);
    add_heights(document, input.surface.is_profile() ? "Rq" : "Sq", spectrum, spectrum.form);
    document.line("scale", spectrum.convention);
    document.line("by", spectrum.source + "\n");
    document.table(curve_rows(spectrum), {.key = std::string(name_of(request.of)), .thinned = "rows"});
    add_reading(document, input, "their pairs are left out", spectrum.rms_gradient);
    return document;
}

document::Document document_of(const SpectrumRequest& request, std::optional<surface::SurfaceInput> given) {
    const surface::SurfaceInput input = input_of(request.surface, std::move(given));
    return document_of(request, input, spectrum_of(request, input));
}

}  // namespace fstiff::actions
