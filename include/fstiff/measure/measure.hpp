// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Measurement of a surface: from heights to every parameter that a contact needs, each with its standard error.
///
/// ```cpp
/// #include <fstiff/measure/measure.hpp>
/// #include <fstiff/synthetic/self_affine.hpp>
///
/// #include <cstdio>
///
/// int main() {
///     const fstiff::Profile<double> trace = fstiff::self_affine_profile<double>(  // or {heights, spacing}, in m
///         {.hurst = 0.8, .rms = 0.3e-6, .longest_wavelength = 100e-6, .seed = 3}, 16384, 0.5e-6);
///     const auto surface = fstiff::measure(trace);
///     std::printf("sigma = %.3f +- %.3f um, lambda_s = %.3g um, %zu concerns\n", surface.rms_height.value * 1e6,
///                 surface.rms_height.error * 1e6, *surface.cut_offs.lambda_s * 1e6, surface.concerns.size());
/// }
/// ```
/// ```text
/// sigma = 0.299 +- 0.011 um, lambda_s = 2.5 um, 0 concerns
/// ```
///
/// Steps: clean() (nothing by default), prepare() (form, lambda_s, lambda_c where given), surface_parameters(),
/// height_statistics(), ShapeOfHeights, concerns_of(). The neighbours are the same surface measured with a shorter and
/// a longer lambda_s, without errors; their change of K widens the band (answer/band).
/// Reference   measure/cut_offs.hpp, measure/prepare.hpp, measure/parameters.hpp
/// Units       SI
/// Valid       as prepare(), surface_parameters(); options.tip_radius only for profiles, PeakSource::summits for maps
/// Accuracy    that of the steps (tests/scene/one_measurement_test.cpp)

#include <fstiff/measure/concerns.hpp>
#include <fstiff/measure/height_shape.hpp>
#include <fstiff/measure/prepare.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>

#include <algorithm>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

namespace fstiff { inline namespace v0_1 {

/// A measured surface: its parameters with standard errors, and their origin.
template <Real T = double>
struct Surface : SurfaceParameters<T> {
    Measurement<T> rms_gradient{};                 ///< [1]; error 0: too few points for one
    std::optional<HeightStatistics<T>> heights{};  ///< none: too few points
    /// Of a map before the lambda_s of the tables, which K of it does not take; none of a profile, of a lambda_s that
    /// was given, and after a robust filter.
    std::optional<HeightStatistics<T>> all_waves{};
    T shape_share{};  ///< 0 to 1: factor of skewness and of kurtosis - 3 in a hybrid contact (counted_shape)
    CutOffs<T> cut_offs{};
    std::vector<MeasuredConcern> concerns{};
    CleaningReport cleaning{};
    bool is_profile = false;  ///< measured by profiles, not by maps
    T size{};                 ///< of the points that exist: length of the profile [m], area of the map [m^2]
    /// Ratio of the largest to the smallest wave number of the surface: from its length, or lambda_c, to two steps, or
    /// the lambda_s that K takes.
    T widest_band = std::numeric_limits<T>::infinity();
    std::shared_ptr<const PreparedProfile<T>> profile{};  ///< the measured profile; null for a map
    std::shared_ptr<const PreparedMap<T>> map{};          ///< null for a profile, and for a neighbour without keep_maps
    std::vector<Surface> neighbours{};                    ///< with a shorter and a longer lambda_s, without errors
    std::vector<Surface> parts{};                         ///< that were pooled (measure/pooled_surface); empty for one
};

/// Measures \p profile as a section of an isotropic surface.
/// \throws domain_error for a profile, a cut-off or an option out of range.
template <Real T>
[[nodiscard]] Surface<T> measure(const Profile<T>& profile, const MeasureOptions<T>& options = {});
/// Measures \p map. \throws as above.
template <Real T>
[[nodiscard]] Surface<T> measure(const HeightMap<T>& map, const MeasureOptions<T>& options = {});
/// Same as above; \p map is consumed and its memory released during the measurement.
template <Real T>
[[nodiscard]] Surface<T> measure(HeightMap<T>&& map, const MeasureOptions<T>& options = {});

namespace detail {

/// Whether \p surface is a profile that repeats itself, which does not determine K of its face.
template <Real T>
[[nodiscard]] bool is_profile_with_lay(const Surface<T>& surface) {
    return surface.is_profile && std::count(surface.concerns.begin(), surface.concerns.end(), MeasuredConcern::lay) > 0;
}

/// The parameters of \p used, those of \p surface or what replaced them, on which no result can rest: not known to a
/// factor of two, the R and D_p of islands whose density has no maximum, or the sigma of a form or a step.
template <Real T>
[[nodiscard]] std::vector<Parameter> unknown_parameters(const Surface<T>& surface, const SurfaceParameters<T>& used) {
    const auto has = [&](MeasuredConcern concern) {
        return std::find(surface.concerns.begin(), surface.concerns.end(), concern) != surface.concerns.end();
    };
    std::vector<Parameter> parameters = unknown_parameters(used);
    if (has(MeasuredConcern::long_waves)) std::erase(parameters, Parameter::r);
    const auto add_measured = [&](Parameter parameter) {
        const auto *estimate = used.find(parameter), *measured = surface.find(parameter);
        if (estimate && measured && estimate->value == measured->value) parameters.push_back(parameter);
    };
    if (has(MeasuredConcern::no_densest_level))
        add_measured(Parameter::peak_radius), add_measured(Parameter::peak_density);
    if (has(MeasuredConcern::form) || has(MeasuredConcern::step)) add_measured(Parameter::rms_height);
    std::sort(parameters.begin(), parameters.end());
    parameters.erase(std::unique(parameters.begin(), parameters.end()), parameters.end());
    return parameters;
}

template <Real T>
[[nodiscard]] SurfaceParameterOptions<T> parameter_options(const MeasureOptions<T>& options,
                                                           const CutOffs<T>& cut_offs) {
    SurfaceParameterOptions<T> result;
    result.fit.tip_radius = options.tip_radius;
    result.fit.resolution = options.resolution;
    result.fit.window = options.window;
    result.fit.lambda_s = cut_offs.lambda_s.value_or(T(0));
    result.fit.seed = result.seed = options.seed;
    result.resamples = options.resamples;
    if (!options.parallel) result.progress = result.fit.progress = result.islands.progress = options.progress;
    result.peaks = options.peaks;
    result.texture = options.texture;
    result.dimension = options.dimension;
    return result;
}

/// Same as above, with the loss of sigma by the removal of a form of \p terms in addition to the mean.
template <Real T, class Prepared>
[[nodiscard]] SurfaceParameterOptions<T> parameter_options(const MeasureOptions<T>& options, const Prepared& prepared,
                                                           int terms) {
    SurfaceParameterOptions<T> result = parameter_options(options, prepared.cut_offs);
    result.form_terms = terms;
    const T before = prepared.rms_as_read, after = rms_height(prepared.of_structure());
    if (terms > 0 && !options.form_cut_off && before > after)
        result.form_share = std::sqrt((before / after - 1) * (before / after + 1));
    return result;
}

/// Surface::widest_band for a surface whose longer side has \p length, whose coarser step is \p step.
template <Real T>
[[nodiscard]] T widest_band(T length, T step, const CutOffs<T>& cut_offs) {
    const T longest = (std::min)(length, cut_offs.lambda_c.value_or(length));
    const T widest = longest / (std::max)(2 * step, cut_offs.lambda_s.value_or(T(0)));
    return widest > T(1) ? widest : std::numeric_limits<T>::infinity();
}

/// Adds the statistics of \p heights; \p acf, if any, is the autocorrelation of a profile.
template <Real T, class Heights, class... Acf>
void add_statistics(Surface<T>& surface, const Heights& heights, const Acf&... acf) {
    try {
        surface.heights = height_statistics(heights);
        surface.rms_gradient = surface.heights->rms_gradient;
        ShapeOfHeights<T> shape;
        shape.add(heights, acf...);
        surface.shape_share = shape.share();
    } catch (const domain_error&) {  // too few points for a distribution; R and D_p may exist
    }
}

/// Surface with what \p find_parameters() and \p find_statistics(surface) find, and the concerns of both.
template <Real T, class FindParameters, class FindStatistics>
[[nodiscard]] Surface<T> surface_of(const CutOffs<T>& cut_offs, T rms_gradient, const ParallelHook& parallel,
                                    const FindParameters& find_parameters, const FindStatistics& find_statistics) {
    Surface<T> surface;
    SurfaceParameters<T> parameters;
    surface.rms_gradient.value = rms_gradient;
    run_pieces(parallel, 2,
               [&](std::size_t i) { i == 0 ? void(parameters = find_parameters()) : find_statistics(surface); });
    static_cast<SurfaceParameters<T>&>(surface) = std::move(parameters);
    surface.cut_offs = cut_offs;
    if (cut_offs.lambda_c) surface.long_end.open = 0;  // longer waves are excluded by the user
    surface.concerns = detail::concerns_of(static_cast<const SurfaceParameters<T>&>(surface), rms_gradient);
    return surface;
}

/// \p options for a neighbour of a surface with \p cut_offs.
template <Real T>
[[nodiscard]] MeasureOptions<T> neighbour_options(const CutOffs<T>& cut_offs, MeasureOptions<T> options, T lambda_s) {
    options.neighbours = false;
    options.resamples = 2;    // their errors are not used
    options.texture = false;  // their lay is that of the surface
    options.dimension = options.dimension && options.neighbour_dimensions;
    options.progress = {};
    options.lambda_s = lambda_s;
    if (!options.form_cut_off) options.lambda_c = CutOff<T>::of(cut_offs.lambda_c);  // fixed for all neighbours
    return options;
}

/// The surface of \p step and its neighbours; \p measure_one(options) measures one. Neighbours that cannot be measured
/// are left out: the cut-off is too long for the surface, or leaves too few peaks.
template <Real T, class MeasureOne>
[[nodiscard]] Surface<T> with_neighbours(const CutOffs<T>& cut_offs, const MeasureOptions<T>& options, T step,
                                         const MeasureOne& measure_one) {
    std::vector<MeasureOptions<T>> pieces;
    if (options.neighbours)
        for (const T lambda_s : neighbouring_lambda_s(cut_offs.lambda_s, step))
            pieces.push_back(neighbour_options(cut_offs, options, lambda_s));
    const std::size_t last = pieces.size();  // the surface itself, whose results then occupy no memory before
    pieces.push_back(options);
    std::vector<std::optional<Surface<T>>> surfaces(pieces.size());
    run_pieces(options.parallel, pieces.size(), [&](std::size_t i) {
        try {
            surfaces[i] = measure_one(pieces[i]);
            if (i < last && !options.keep_maps) surfaces[i]->map.reset();
        } catch (const domain_error&) {
            if (i == last) throw;
        }
    });
    Surface<T> surface = *std::move(surfaces.back());
    for (std::size_t i = 0; i < last; ++i)
        if (surfaces[i]) surface.neighbours.push_back(*std::move(surfaces[i]));
    return surface;
}

/// \p profile after the cleaning. Its structure function is that before lambda_s and lambda_c.
template <Real T>
[[nodiscard]] Surface<T> measure_profile(const Profile<T>& profile, const MeasureOptions<T>& options) {
    const CutOffs<T> cut_offs = choose_cut_offs(profile, options);
    std::optional<MeasuredStructureFunction<T>> structure;  // none: each surface has the reason
    if (options.dimension && options.neighbours)
        (void)fit_or_reason(structure, [&] {
            const auto flat =
                level(profile, options.form, options.form_cut_off, options.height_step, {}, options.form_radius);
            return profile_structure(flat.profile, parameter_options(options, cut_offs).fit);
        });
    return with_neighbours(cut_offs, options, profile.spacing, [&](const MeasureOptions<T>& chosen) {
        const auto prepared = std::make_shared<const PreparedProfile<T>>(prepare(profile, chosen));
        const Profile<T>& flat = prepared->profile;
        const Autocorrelation<T> acf = autocorrelation(flat);
        const auto parameters = [&] {
            const int degree = static_cast<int>(coefficients(chosen.form)) - 1;
            auto how = parameter_options(chosen, *prepared, degree);
            how.structure = structure ? &*structure : nullptr, how.autocorrelation = &acf;
            auto result = surface_parameters<T>(static_cast<const LevelledProfile<T>&>(*prepared), how);
            if (chosen.texture && chosen.form > Form::mean) {
                result.plain_form = detail::plain_form(flat, degree);
                result.plain_form.plateau = prepared->settled;
            }
            return result;
        };
        Surface<T> surface = surface_of(prepared->cut_offs, prepared->rms_gradient, chosen.parallel, parameters,
                                        [&](Surface<T>& found) { add_statistics(found, flat, acf); });
        surface.profile = prepared;
        surface.is_profile = true;
        surface.size = static_cast<T>(flat.present()) * flat.spacing;
        surface.widest_band = widest_band(static_cast<T>(flat.size()) * flat.spacing, flat.spacing, surface.cut_offs);
        return surface;
    });
}

/// A map without its form after the cleaning, with the cut-offs of \p options; \p sections are those before them.
template <Real T>
[[nodiscard]] Surface<T> measure_map(const PreparedMap<T>& without_form, const MeasureOptions<T>& options,
                                     const SectionStructures<T>* sections) {
    const auto prepared = std::make_shared<PreparedMap<T>>(with_cut_offs(without_form, options));
    const int degree = degree_of(options.map_form), terms = degree * (degree + 3) / 2;
    const HeightMap<T>& flat = prepared->map;
    const auto parameters = [&] {
        auto how = parameter_options(options, *prepared, terms);
        how.sections = sections;
        SurfaceParameters<T> result, of_map;
        run_pieces(options.parallel, options.texture ? 2 : 1, [&](std::size_t i) {
            if (i == 0) return void(result = surface_parameters<T>(static_cast<const LevelledMap<T>&>(*prepared), how));
            if (degree > 0) of_map.plain_form = detail::plain_form(flat, degree);
            of_map.plain_form.plateau = prepared->settled.has_value();
            std::tie(of_map.offset_lines, of_map.line_step) = line_offsets(*without_form.unfiltered);
        });
        result.plain_form = of_map.plain_form, result.offset_lines = of_map.offset_lines;
        result.line_step = of_map.line_step;
        return result;
    };
    Surface<T> surface = surface_of(prepared->cut_offs, static_cast<T>(prepared->areal.rms_gradient), options.parallel,
                                    parameters, [&](Surface<T>& found) { add_statistics(found, flat); });
    CutOffs<T> of_contact = surface.cut_offs;
    if (prepared->cut_offs.why_s != LambdaSReason::by_table)
        prepared->unfiltered.reset();  // D is found; K is of it
    else if (surface.heights && !(of_contact.lambda_c && of_contact.filter == CutOffFilter::robust))
        surface.all_waves = height_statistics(*prepared->unfiltered), of_contact.lambda_s.reset();
    surface.map = prepared;
    surface.size = static_cast<T>(flat.present()) * flat.dx * flat.dy;
    surface.widest_band =
        widest_band((std::max)(static_cast<T>(flat.columns()) * flat.dx, static_cast<T>(flat.rows()) * flat.dy),
                    (std::max)(flat.dx, flat.dy), of_contact);
    return surface;
}

/// A map without its form after the cleaning, with its neighbours.
template <Real T>
[[nodiscard]] Surface<T> measure_map(const PreparedMap<T>& without_form, const MeasureOptions<T>& options) {
    const HeightMap<T>& map = *without_form.unfiltered;
    const CutOffs<T> cut_offs = choose_cut_offs(map, options);
    std::optional<SectionStructures<T>> sections;  // none: each surface has the reason
    if (options.dimension)
        (void)fit_or_reason(sections, [&] {
            return section_structures(map, parameter_options(options, cut_offs).fit, options.parallel);
        });
    return with_neighbours(cut_offs, options, (std::max)(map.dx, map.dy), [&](const MeasureOptions<T>& chosen) {
        return measure_map(without_form, chosen, sections ? &*sections : nullptr);
    });
}

}  // namespace detail

template <Real T>
Surface<T> measure(const Profile<T>& profile, const MeasureOptions<T>& options) {
    if (options.peaks == PeakSource::summits)
        throw domain_error("peaks = summits: must be islands for a profile, whose R and D_p come from its curvature");
    Profile<T> cleaned = profile;
    const CleaningReport report = detail::clean(cleaned, options.cleaning);
    Surface<T> surface = detail::measure_profile(cleaned, options);
    surface.cleaning = report;
    return surface;
}

template <Real T>
Surface<T> measure(HeightMap<T>&& map, const MeasureOptions<T>& options) {
    const CleaningReport report = detail::clean(map, options.cleaning);
    if (options.tip_radius > T(0))
        detail::refuse("tip_radius", options.tip_radius, "left out for a map, whose lags cannot be freed of the tip");
    (void)detail::choose_cut_offs(map, options);  // throws for wrong ones before any computation
    const PreparedMap<T> flat = detail::without_form(std::move(map), options);
    Surface<T> surface = detail::measure_map(flat, options);
    surface.cleaning = report;
    return surface;
}

template <Real T>
Surface<T> measure(const HeightMap<T>& map, const MeasureOptions<T>& options) {
    return measure(HeightMap<T>(map), options);
}

}}  // namespace fstiff

#ifdef FSTIFF_COMPILED  // in fstiff::double, with all that a measurement consists of
#include <fstiff/double/surfaces.hpp>
#endif
