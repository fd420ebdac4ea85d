// SPDX-License-Identifier: BSD-3-Clause
// Measurement of profiles and maps.
#include "c/measure.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace fstiff::c {
namespace {

using request::Amount;
using surface::MeasuredSurface;
using surface::MeasureOptions;

Amount length(const char* name, double value) {
    if (value == 0) return {};
    detail::require_positive(name, value);
    return value;
}
Amount cut_off(const char* name, double value) {
    return value == FSTIFF_NO_CUT_OFF ? Amount("none") : length(name, value);
}

void put(fstiff_measured& to, const Measurement<double>& from) {
    to = {from.value, from.error, std::isfinite(from.value) && std::isfinite(from.error)};
    if (!to.known) to = {};
}

int write(const MeasuredSurface& surface, fstiff_surface& written) {
    const Surface<double>& from = surface.found;
    fstiff_surface to{};
    to.peaks = from.peaks_counted;
    to.lambda_s = from.cut_offs.lambda_s.value_or(0);
    to.lambda_c = from.cut_offs.lambda_c.value_or(0);
    put(to.rms_height, from.rms_height);
    if (from.find(fstiff::Parameter::peak_radius)) put(to.peak_radius, from.peak_radius);
    if (from.find(fstiff::Parameter::peak_density)) put(to.peak_density, from.peak_density);
    if (from.fractal_dimension) put(to.fractal_dimension, *from.fractal_dimension);
    if (from.r) put(to.r, *from.r);
    if (from.theta) put(to.theta, *from.theta);
    if (from.max_peak_height.value > 0) put(to.max_peak_height, from.max_peak_height);
    if (from.fractal_roughness) put(to.fractal_roughness, *from.fractal_roughness);
    if (from.heights) {
        put(to.rms_gradient, from.heights->rms_gradient);
        put(to.skewness, from.heights->skewness);
        put(to.kurtosis, from.heights->kurtosis);
        to.shape_share = from.shape_share;
    }
    give(to, written);
    std::string warnings;
    for (const std::string& warning : surface.warnings) warnings += (warnings.empty() ? "" : "\n") + warning;
    set_message(warnings);
    return FSTIFF_OK;
}

template <class Heights>
int measure(Heights heights, const fstiff_measure_options* given, fstiff_surface& to) {
    surface::SurfaceInput input;
    input.surface.data = std::move(heights);
    input.surface.record.name = "heights";
    return write(measure_surface(options_of(given), input), to);
}

}  // namespace

MeasureOptions options_of(const fstiff_measure_options* given) {
    MeasureOptions options;
    options.neighbours = false;  // for the band of K, which nobody asks here
    options.input.file = "heights";
    if (!given) return options;
    const fstiff_measure_options from = taken(given, "options");
    if (from.detrend) options.input.detrend = std::string(from.detrend).substr(0, 40);
    options.input.lambda_s = cut_off("lambda_s", from.lambda_s);
    options.input.lambda_c = cut_off("lambda_c", from.lambda_c);
    options.input.tip_radius = length("tip_radius", from.tip_radius);
    options.input.resolution = length("resolution", from.resolution);
    if (from.shortest_lag != 0 || from.longest_lag != 0) {
        detail::require_positive("shortest_lag", from.shortest_lag);
        detail::require_positive("longest_lag", from.longest_lag);
        options.input.window = std::vector<double>{from.shortest_lag, from.longest_lag};
    }
    if (from.filter != FSTIFF_FILTER_GAUSSIAN && from.filter != FSTIFF_FILTER_ROBUST)
        refuse_argument("filter", from.filter, "FSTIFF_FILTER_GAUSSIAN or FSTIFF_FILTER_ROBUST");
    options.input.filter = from.filter == FSTIFF_FILTER_ROBUST ? CutOffFilter::robust : CutOffFilter::gaussian;
    if (from.peaks != FSTIFF_PEAKS_ISLANDS && from.peaks != FSTIFF_PEAKS_SUMMITS)
        refuse_argument("peaks", from.peaks, "FSTIFF_PEAKS_ISLANDS or FSTIFF_PEAKS_SUMMITS");
    options.input.peaks = from.peaks == FSTIFF_PEAKS_SUMMITS ? PeakSource::summits : PeakSource::islands;
    if (from.resamples != 0) {
        detail::require(from.resamples >= 2 && from.resamples <= 100000, "resamples", from.resamples, "2 to 100000");
        options.resamples = from.resamples;
    }
    if (from.seed != 0) options.seed = from.seed;
    return options;
}

surface::SurfaceInput input_of(const surface::SurfaceOptions& options, const fstiff_heights& from) {
    const std::size_t rows = std::max<std::size_t>(from.rows, 1);
    if (from.columns > static_cast<std::size_t>(-1) / rows)
        throw argument_error("rows times columns: must fit into memory");
    require_array(from.heights, rows * from.columns, "heights");
    if (from.rows == 0)
        return surface_of_heights(options, Profile<double>{{from.heights, from.heights + from.columns}, from.dx},
                                  "an array");
    using Array = HeightMap<double>::Array;
    return surface_of_heights(options,
                              HeightMap<double>{Eigen::Map<const Array>(from.heights, static_cast<Eigen::Index>(rows),
                                                                        static_cast<Eigen::Index>(from.columns)),
                                                from.dx, from.dy},
                              "an array");
}

}  // namespace fstiff::c

using namespace fstiff::c;

int fstiff_measure_profile(const double* heights, size_t count, double spacing, const fstiff_measure_options* options,
                           fstiff_surface* surface) {
    return guarded([&] {
        require_array(heights, count, "heights");
        fstiff_surface& to = sized(surface, "surface");
        fstiff::Profile<double> profile{{heights, heights + count}, spacing};
        profile.validate();
        return measure(std::move(profile), options, to);
    });
}

int fstiff_measure_map(const double* heights, size_t rows, size_t columns, double dx, double dy,
                       const fstiff_measure_options* options, fstiff_surface* surface) {
    return guarded([&] {
        if (rows != 0 && columns > static_cast<std::size_t>(-1) / rows)
            throw argument_error("rows times columns: must fit into memory");
        require_array(heights, rows * columns, "heights");
        fstiff_surface& to = sized(surface, "surface");
        using Array = fstiff::HeightMap<double>::Array;
        fstiff::HeightMap<double> map{
            Eigen::Map<const Array>(heights, static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns)), dx,
            dy};
        map.validate();
        return measure(std::move(map), options, to);
    });
}
