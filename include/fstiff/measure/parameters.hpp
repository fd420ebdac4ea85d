// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Parameters of the contact models from a measured profile or map, each with its standard error.
///
///                  map                                               profile, as a section of an isotropic surface
///     sigma        rms of the heights                                same
///     R            A_m/(2 pi h_m) of the representative islands      3 sqrt(pi)/(8 sigma_kappa)             eq. (4.10)
///     D_p          density of the islands; or both of summits      2 pi/(3 sqrt 3) n^2, n peaks per length
///     R_p          highest point above the mean                      same
///     r, theta     sigma_m^2/(sigma sigma_kappa), asin(h sigma_kappa/(2 sigma_m)) of triples of neighbours in the rows
///     D, G         mean of both directions (measure/sections)       profile/fractal_fit
///
/// Reference   Nayak (1971), Longuet-Higgins (1957), Kunsch (1989), Buczkowski et al. (2014), sections 2 to 4
/// Units       SI
/// Valid       form removed before, with level(); see detail::surface_parameters
/// Accuracy    sums 1e-12; errors 0.7 to 1.4 times the scatter of 60 surfaces, exceptions in docs/theory-surface.md

#include <fstiff/core/names.hpp>
#include <fstiff/measure/height_sums.hpp>
#include <fstiff/measure/lay.hpp>
#include <fstiff/measure/long_waves.hpp>
#include <fstiff/measure/uncertain_surface.hpp>
#include <fstiff/measure/unmeasured_waves.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/form.hpp>

#include <array>
#include <numbers>

namespace fstiff { inline namespace v0_1 {

/// Kind of the peaks of a map.
enum class PeakSource {
    islands,  ///< the representative island: where there are most (Figs. 3 and 4)
    summits   ///< points above their eight neighbours
};

template <>
inline constexpr auto enum_names<PeakSource> = detail::name_list<PeakSource>({{PeakSource::islands, "islands"},
                                                                              {PeakSource::summits, "summits"}});

namespace detail {

/// Options of the parameters of a surface and their errors.
template <Real T = double>
struct SurfaceParameterOptions {
    PeakSource peaks = PeakSource::islands;  ///< of a map
    IslandOptions<T> islands{};
    FractalFitOptions<T> fit{};
    bool texture = true;    ///< of a map: find Str, which costs two transforms of it
    bool dimension = true;  ///< find D and G
    T form_share{};         ///< rms height of the form that was removed over that of the rest
    int form_terms{};       ///< of the form, without its mean
    std::size_t tiles = 4;  ///< of a map, a side
    std::size_t resamples = 400;
    std::uint64_t seed = 2014;
    ProgressHook progress{};  ///< of the resamples; `islands` and `fit` have their own
    /// Of the profile, of it before its filters, and of the map before its filters, where they are known.
    const Autocorrelation<T>* autocorrelation = nullptr;
    const MeasuredStructureFunction<T>* structure = nullptr;
    const SectionStructures<T>* sections = nullptr;
};

/// Parameters of a surface after removal of its form, or of a surface as it is.
///
/// Profiles have at least 16 points and 8 triples, maps as representative_islands() and two separate islands or
/// summits. D, or r and theta, are left out with the reason where they are not available. R and D_p depend on the step
/// for surfaces that are rough below it; points of equal height are no peaks, so that coarse rounding loses peaks.
/// \throws domain_error for a surface or an option out of range, or one without peaks.
template <Real T>
[[nodiscard]] SurfaceParameters<T> surface_parameters(const LevelledProfile<T>& levelled,
                                                      const SurfaceParameterOptions<T>& options = {});
template <Real T>
[[nodiscard]] SurfaceParameters<T> surface_parameters(const Profile<T>& profile,
                                                      const SurfaceParameterOptions<T>& options = {}) {
    return surface_parameters(LevelledProfile<T>{profile}, options);
}
template <Real T>
[[nodiscard]] SurfaceParameters<T> surface_parameters(const HeightMap<T>& map,
                                                      const SurfaceParameterOptions<T>& options = {});
template <Real T>
[[nodiscard]] SurfaceParameters<T> surface_parameters(const LevelledMap<T>& levelled,
                                                      const SurfaceParameterOptions<T>& options = {});

/// Sums of heights in \p unit and of lengths in samples of \p dx by \p dy.
template <Real T>
void store_sums(SurfaceParameters<T>& result, const Estimates<double>& estimate, const EstimateSpread<double>& spread,
                double unit, double dx, double dy) {
    const auto measured = [&](std::size_t i, double scale) {
        return Measurement<T>{static_cast<T>(estimate[i] * scale),
                              static_cast<T>(estimate[i] * scale * spread.error[i])};
    };
    result.rms_height = measured(0, unit);
    result.peak_radius = measured(1, dx / unit * dx);
    result.peak_density = measured(2, 1 / dx / dy);
    result.max_peak_height = measured(3, unit);
    result.blocks = spread.blocks;
    constexpr std::array<std::size_t, 5> mine{0, 1, 2, 4, 5};  // without R_p, whose place in Parameter is that of D
    for (const std::size_t i : mine)
        for (const std::size_t j : mine) result.correlation[i][j] = static_cast<T>(spread.correlation[i][j]);
    const T r = static_cast<T>(estimate[4]), theta = static_cast<T>(estimate[5]);
    if (!std::isfinite(r) || !(theta > T(0)))
        result.why_no_peaks = "curvature of neighbouring points along x = 0: must be greater than 0 for r and theta";
    else if (!(r < T(1)))
        result.why_no_peaks = "r = " + rounded_text(r, 4) +
                              ", must be less than 1: too near to a single sine, a straight line or a zigzag";
    else if (!(theta < std::numbers::pi_v<T> / 2))
        result.why_no_peaks = "theta = pi/2, must be less: every point is above or below both of its neighbours";
    else {
        result.r = {r, static_cast<T>(spread.error[4])};
        result.theta = {theta, static_cast<T>(spread.error[5])};
    }
}

template <Real T>
void store_fit(SurfaceParameters<T>& result, const FractalFit<T>& fit) {
    result.fractal_dimension = {fit.fractal.dimension, fit.dimension_error};
    result.fractal_roughness = {fit.fractal.roughness, fit.roughness_error};
    result.log_fractal_roughness_error = fit.log_roughness_error;
    result.dimension_window_error = fit.window_dimension_error;
    result.window = fit.window;
    result.curved = fit.curved;
}

/// D and G of both directions combined, by weight.
template <Real T>
void store_mean_of_directions(SurfaceParameters<T>& result, const DirectionalFit<T>& fit) {
    result.anisotropic = fit.anisotropic();
    if (!fit.x && !fit.y) {
        result.why_no_dimension = "along x: " + fit.why_no_fit_x + "; along y: " + fit.why_no_fit_y;
        return;
    }
    store_fit(result, fit.x && (!fit.y || fit.x->dimension_error <= fit.y->dimension_error) ? *fit.x : *fit.y);
    if (!fit.x || !fit.y) return;
    const T ex = fit.x->dimension_error, ey = fit.y->dimension_error, square = ex * ex + ey * ey;
    const T share = square > T(0) ? ey * ey / square : T(0.5);  // of x
    const T dx = fit.x->fractal.dimension, dy = fit.y->fractal.dimension;
    const T gx = std::log(fit.x->fractal.roughness), gy = std::log(fit.y->fractal.roughness);
    const T log_g = share * gx + (1 - share) * gy;
    result.fractal_dimension = {share * dx + (1 - share) * dy,
                                (std::max)(std::hypot(share * ex, (1 - share) * ey), std::abs(dx - dy) / 2)};
    result.dimension_window_error =
        std::hypot(share * fit.x->window_dimension_error, (1 - share) * fit.y->window_dimension_error);
    result.log_fractal_roughness_error =
        (std::max)(std::hypot(share * fit.x->log_roughness_error, (1 - share) * fit.y->log_roughness_error),
                   std::abs(gx - gy) / 2);
    const T g = std::exp(log_g);
    result.fractal_roughness = {g, g * result.log_fractal_roughness_error};
    result.curved = fit.x->curved || fit.y->curved;
}

/// Long end of a piece with the \p side and the long waves \p waves: H from its D and these waves.
template <Real T, class Waves>
void store_long_end(SurfaceParameters<T>& result, const Waves& waves, T side,
                    const SurfaceParameterOptions<T>& options) {
    PriorHurst<T> prior;
    if (const auto& d = result.fractal_dimension)
        prior = {2 - d->value, (std::max)(d->error, result.curved ? T(0.3) : T(0.1))};
    result.long_end = detail::long_end(waves.squares, prior);
    result.long_end.side = side;
    result.long_end.error = static_cast<T>(waves.error);
    result.long_end.law = prior.error > T(0) && !result.curved;
    result.long_end.form_share =
        (std::min)(options.form_share, detail::greatest_form_share<T>(waves.squares, options.form_terms));
}

template <Real T>
void require_options(const SurfaceParameterOptions<T>& options) {
    require(options.resamples >= 2 && options.resamples <= 100000, "resamples", options.resamples,
            "between 2 and 100000");
    require(options.tiles >= 2 && options.tiles <= 32, "tiles a side", options.tiles, "between 2 and 32");
    check_options(options.fit);
}

/// \throws domain_error unless a contact can be computed from the result.
template <Real T>
void require_numbers(const SurfaceParameters<T>& result) {
    require_positive("rms height of the surface", result.rms_height.value);
    if (result.peak_radius.value != T(0)) require_positive("radius of the peaks", result.peak_radius.value);
    for (const auto& m : {result.rms_height, result.peak_radius, result.peak_density})
        require(m.error <= (std::numeric_limits<T>::max)(), "error of a surface parameter", m.error, "finite");
}

template <Real T>
SurfaceParameters<T> surface_parameters(const LevelledProfile<T>& levelled, const SurfaceParameterOptions<T>& options) {
    const Profile<T>& profile = levelled.profile;
    profile.validate(16);
    require_options(options);
    const std::size_t size = profile.size();
    const std::vector<T>& z = profile.heights;
    const double unit = height_scale(profile), mean = static_cast<double>(mean_height(profile));
    const double step = static_cast<double>(profile.spacing);

    // correlation length: double reaches 1 - 1/e of its end value
    const StructureFunction<T> s = structure_function(profile);
    const T sigma = rms_height(profile);
    std::size_t correlated = size / 4;
    for (std::size_t k = s.size(); k-- > 0;)
        if (s.value[k] >= T(2) * sigma * sigma * T(0.632)) correlated = s.step[k];
    const std::size_t cells = std::min<std::size_t>(256, size / 2), length = (size + cells - 1) / cells;
    std::vector<HeightSums<double>> sums((size + length - 1) / length);
    const auto height = [&](std::size_t i) { return (static_cast<double>(z[i]) - mean) / unit; };
    for (std::size_t i = 0; i < size; ++i) {
        sums[i / length].add_point(height(i));
        if (i > 0 && i + 1 < size) sums[i / length].triples.add(height(i) - height(i - 1), height(i + 1) - height(i));
    }
    HeightSums<double> total;
    for (const auto& cell : sums) total.add(cell);
    if (total.triples.triples < 8)
        throw domain_error("profile has " + std::to_string(total.triples.triples) +
                           " triples of neighbouring points: must be at least 8");
    const std::size_t block =
        std::clamp<std::size_t>((5 * correlated + length - 1) / length, 1, std::max<std::size_t>(1, sums.size() / 8));

    SurfaceParameters<T> result;
    constexpr auto count = PeakCount::profile;
    const auto estimate = detail::estimates(total, count);
    auto spread = detail::resample_cells(sums, block, count, options.resamples, options.seed, options.progress);
    const auto waves =
        detail::long_waves<double>(1, static_cast<Eigen::Index>(size), estimate[0] * estimate[0],
                                   [&](Eigen::Index, Eigen::Index i) { return height(static_cast<std::size_t>(i)); });
    result.long_wave_share = static_cast<T>(waves.share);
    detail::add_long_waves(spread, estimate, waves);
    result.repetition =
        detail::repetition(options.autocorrelation ? *options.autocorrelation : autocorrelation(profile));
    store_sums(result, estimate, spread, unit, step, step);
    if (total.triples.peaks == 0) result.why_no_density = "no peak";
    require_numbers(result);
    result.peaks_counted = total.triples.peaks;
    result.block_length = static_cast<T>(block * length) * profile.spacing;
    result.seed = options.seed;
    const auto fit = [&] {
        if (!options.structure) return fit_fractal(levelled, options.fit);
        return fit_profile(levelled.of_structure(), *options.structure, fit_options(levelled, options.fit));
    };
    result.why_no_dimension = options.dimension ? fit_or_reason(result.profile_fit, fit) : "D was not asked for";
    if (result.profile_fit) store_fit(result, *result.profile_fit);
    store_long_end(result, waves, static_cast<T>(size) * profile.spacing / std::numbers::sqrt2_v<T>, options);
    return result;
}

/// Sums over the part \p block of \p map, whose heights \p height gives in a unit; with \p summits also over its
/// summits.
template <Real T, class Height>
[[nodiscard]] HeightSums<double> sums_of_block(const HeightMap<T>& map, const MapBlock& block, const Height& height,
                                               bool summits) {
    using Index = Eigen::Index;
    HeightSums<double> tile;
    for (Index j = block.top; j < block.bottom; ++j)
        for (Index i = block.left; i < block.right; ++i) {
            tile.add_point(height(j, i));
            if (i > 0 && i + 1 < map.columns())
                tile.triples.add(height(j, i) - height(j, i - 1), height(j, i + 1) - height(j, i));
        }
    if (!summits) return tile;
    const double square_of_sides = static_cast<double>(map.dx) / map.dy * (static_cast<double>(map.dx) / map.dy);
    visit_inner_points(map, block, [&](Index j, Index i, bool summit) {
        tile.inner += 1;
        if (!summit) return;
        const double centre = height(j, i);
        const double along_x = (centre - height(j, i - 1)) + (centre - height(j, i + 1));
        const double along_y = (centre - height(j - 1, i)) + (centre - height(j + 1, i));
        tile.summits += 1;
        tile.summit_curvature += (along_x + along_y * square_of_sides) / 2;
    });
    return tile;
}

/// R and D_p of the islands of \p map, or the reason that it has none.
template <Real T>
void store_islands(SurfaceParameters<T>& result, const HeightMap<T>& map, const SurfaceParameterOptions<T>& options) {
    result.why_no_density = fit_or_reason(result.islands, [&] {
        return representative_islands(map, options.islands,
                                      {options.tiles, options.resamples, options.seed, options.progress});
    });
    if (!result.islands) return;
    const RepresentativeIslands<T>& islands = *result.islands;
    result.peaks_counted = islands.islands;
    if (islands.islands < 2) {
        result.why_no_density = "one island";
        result.islands.reset();
        return;
    }
    result.peak_radius = {islands.radius, islands.radius_error};
    result.peak_density = {islands.density, islands.density_error};
    const auto radius = index_of(Parameter::peak_radius), density = index_of(Parameter::peak_density);
    result.correlation[radius][density] = result.correlation[density][radius] = islands.correlation;
}

/// Parameters of \p map, with D and G from \p directions.
template <Real T, class Directions>
SurfaceParameters<T> map_parameters(const HeightMap<T>& map, const SurfaceParameterOptions<T>& options,
                                    const Directions& directions) {
    using Index = Eigen::Index;
    map.validate();
    require_options(options);
    const auto& z = map.heights;
    const double unit = height_scale(map), mean = static_cast<double>(mean_height(map));
    const auto height = [&](Index j, Index i) { return (static_cast<double>(z(j, i)) - mean) / unit; };
    const bool summits = options.peaks == PeakSource::summits;
    const Index tiles = static_cast<Index>(options.tiles);
    std::vector<HeightSums<double>> sums;
    HeightSums<double> sum;
    for (Index t = 0; t < tiles * tiles; ++t) {
        const Index row = t / tiles, column = t % tiles;
        const MapBlock block{row * map.rows() / tiles, (row + 1) * map.rows() / tiles, column * map.columns() / tiles,
                             (column + 1) * map.columns() / tiles};
        const HeightSums<double> tile = sums_of_block(map, block, height, summits);
        sum.add(tile);
        if (tile.points > 0.0) sums.push_back(tile);
    }
    require(sum.triples.triples > 0, "triples of neighbouring points in the rows", sum.triples.triples, "at least 1");
    const auto with_summits =
        std::count_if(sums.begin(), sums.end(), [](const auto& tile) { return tile.summits > 0; });

    SurfaceParameters<T> result;
    if (summits && with_summits < 2)
        result.why_no_density = with_summits == 0 ? "no summit" : "summits in one tile alone";
    const auto count = summits && result.why_no_density.empty() ? PeakCount::summits : PeakCount::none;
    const auto estimate = detail::estimates(sum, count);
    auto spread = detail::resample_cells(sums, 1, count, options.resamples, options.seed, options.progress);
    const auto waves = detail::long_waves<double>(map.rows(), map.columns(), estimate[0] * estimate[0], height);
    result.long_wave_share = static_cast<T>(waves.share);
    detail::add_long_waves(spread, estimate, waves);
    if (options.texture) result.texture_aspect_ratio = detail::texture_aspect_ratio(map);
    store_sums(result, estimate, spread, unit, static_cast<double>(map.dx), static_cast<double>(map.dy));
    result.peaks_counted = static_cast<std::size_t>(sum.summits);
    if (!summits) store_islands(result, map, options);
    if (!result.why_no_density.empty()) result.peak_radius = result.peak_density = {};
    require_numbers(result);
    result.seed = options.seed;
    result.why_no_dimension =
        options.dimension ? fit_or_reason(result.map_fit, [&] { return directions(); }) : "D was not asked for";
    if (result.map_fit) store_mean_of_directions(result, *result.map_fit);
    store_long_end(result, waves, std::sqrt(map.area()), options);
    return result;
}

template <Real T>
SurfaceParameters<T> surface_parameters(const HeightMap<T>& map, const SurfaceParameterOptions<T>& options) {
    return map_parameters(map, options, [&] { return fit_directions(map, options.fit); });
}

template <Real T>
SurfaceParameters<T> surface_parameters(const LevelledMap<T>& levelled, const SurfaceParameterOptions<T>& options) {
    return map_parameters(levelled.map, options, [&] {
        if (!options.sections) return fit_directions(levelled, options.fit);
        return fit_directions(*options.sections, fit_options(levelled, options.fit));
    });
}

}  // namespace detail

}}  // namespace fstiff
