// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Options of the measurement of a surface and their defaults: cleaning, form, cut-offs, estimates.
///
///     fstiff::MeasureOptions<double> how{.lambda_s = 1e-6, .lambda_c = fstiff::no_cut_off};
///
/// Units       lengths [m]
/// Valid       ranges as stated for each field; clean(), prepare() and measure() refuse other values

#include <fstiff/core/parallel.hpp>
#include <fstiff/measure/parameters.hpp>
#include <fstiff/profile/profile_form.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <type_traits>

namespace fstiff { inline namespace v0_1 {

namespace detail {

struct NoCutOff {};

}  // namespace detail

/// No cut-off: all waves are kept.
inline constexpr detail::NoCutOff no_cut_off{};

/// A requested cut-off: by default that of the tables (lambda_c: for Ra alone), else a length [m] or no_cut_off.
template <Real T = double>
class CutOff {
public:
    constexpr CutOff() = default;
    constexpr CutOff(detail::NoCutOff) : automatic_(false) {}
    constexpr CutOff(std::type_identity_t<T> length) : automatic_(false), length_(length) {}
    /// Cut-off of another measurement: \p wavelength, or none.
    [[nodiscard]] static constexpr CutOff of(const std::optional<T>& wavelength) {
        return wavelength ? CutOff(*wavelength) : CutOff(no_cut_off);
    }
    /// Whether the tables choose the cut-off.
    [[nodiscard]] constexpr bool automatic() const { return automatic_; }
    /// Given length [m]; empty without a filter, and where the tables choose.
    [[nodiscard]] constexpr const std::optional<T>& length() const { return length_; }

private:
    bool automatic_ = true;
    std::optional<T> length_{};
};

/// Filter of lambda_c: grooves and spikes shift the mean line (surface) of `gaussian` but not that of `robust`.
enum class CutOffFilter { gaussian, robust };
template <>
inline constexpr auto enum_names<CutOffFilter> = detail::name_list<CutOffFilter>({{CutOffFilter::gaussian, "gaussian"},
                                                                                  {CutOffFilter::robust, "robust"}});

/// A part of a surface, relative to its first point [m]; y is ignored for a profile.
template <Real T = double>
struct Crop {
    T x_from{}, x_to{}, y_from{}, y_to{};
};

/// Mask of the points of a surface: true where a point is used. A profile has one row or one column.
using PointMask = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Repairs before the removal of the form, in the order of the fields. None by default.
template <Real T = double>
struct Cleaning {
    std::optional<Crop<T>> crop{};
    PointMask mask{};                           ///< of the cropped surface; empty: every point is used
    LineAlignment align = LineAlignment::none;  ///< of the scan lines of a map
    ScanAxis scan_axis = ScanAxis::automatic;
    T spikes{};   ///< points so many robust standard deviations away become missing, 3 to 1000; 0: none
    bool fill{};  ///< whether missing points are filled
};

/// Options of cleaning, preparation and measurement.
template <Real T = double>
struct MeasureOptions {
    CutOff<T> lambda_s{};                          ///< of the short waves
    CutOff<T> lambda_c{};                          ///< of the long waves; by default none, and the tables' for Ra
    CutOffFilter filter = CutOffFilter::gaussian;  ///< of lambda_c
    T tip_radius{}, resolution{};                  ///< of the instrument [m]; 0: not known
    Form form = Form::line;                        ///< removed from a profile
    std::optional<T> form_cut_off{};               ///< of a Gaussian filter that removes the long waves with it [m]
    MapForm map_form = MapForm::plane;             ///< removed from a map
    T form_radius{};                               ///< of a circle, sphere or cylinder [m]; 0: the best one
    T height_step{};                               ///< in which heights were printed or counted [m]; 0: not known
    Cleaning<T> cleaning{};
    PeakSource peaks = PeakSource::islands;  ///< of a map
    std::optional<LengthRange<T>> window{};  ///< of the lags that give D; empty: automatic
    std::size_t resamples = 400;             ///< for the standard errors
    std::uint64_t seed = 2014;               ///< of the resamples
    bool texture = true;                     ///< whether Str of a map is computed, which detects a lay
    bool dimension = true;                   ///< whether D and G are computed
    bool neighbours = true;                  ///< whether the surface is measured with other lambda_s too
    bool neighbour_dimensions = true;        ///< whether D and G of these are computed
    bool keep_maps = true;                   ///< whether the neighbours keep their filtered maps
    ProgressHook progress{};                 ///< of the resamples; not called where they run in parallel
    ParallelHook parallel{};  ///< of the surface, its neighbours and parts of each; the results are equal
};

}}  // namespace fstiff
