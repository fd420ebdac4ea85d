// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Form of a joint: the gap between both faces in touch, before load, over the nominal area.
///
///     crown       F min(1, (x/a)^2 + (y/b)^2)          over a face of 2a by 2b
///     ring        F min(1, ((r - r_m)/b)^2)            across a ring of the width 2b, unrolled: a body as wide as it
///     measured    halfspace/measured_form
///
/// F is the height of both faces together: tolerances t1 and t2 make t1 + t2 at most. Which shape has the height hardly
/// matters: K of waves, cylinders and saddles is within a factor of two of that of a crown.
///
/// Units       [m]
/// Valid       8 points a side at least
/// Accuracy    of the grid: halfspace/formed_joint.hpp

#include <fstiff/core/error.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// \throws domain_error for fewer than 8.
inline void require_form_points(Eigen::Index points) {
    require(points >= 8, "points of the form a side", points, "at least 8");
}

}  // namespace detail

/// Gap between the faces of a joint in touch, before load. It is mirrored at its edges: what is beyond them carries
/// nothing into the face.
struct JointForm {
    HeightMap<double> gap;  ///< [m], of the nominal area or of a part that makes it up, mirrored

    /// Paraboloid of the height \p flatness [m] over a face of \p side_x by \p side_y [m]. \throws domain_error for
    /// sides that are not positive, a negative height and fewer than 8 \p points a side.
    [[nodiscard]] static JointForm crown(double side_x, double side_y, double flatness, Eigen::Index points = 64) {
        detail::require_positive("side_x", side_x);
        detail::require_positive("side_y", side_y);
        return quarter(side_x, side_y, flatness, points, 1);
    }
    /// Parabola of the height \p flatness [m] across a ring. \throws domain_error unless 0 <= \p inner_radius <
    /// \p outer_radius [m], for a negative height and fewer than 8 \p points across.
    [[nodiscard]] static JointForm ring(double inner_radius, double outer_radius, double flatness,
                                        Eigen::Index points = 64) {
        detail::require(inner_radius >= 0, "inner_radius", inner_radius, "0 or greater");
        detail::require(outer_radius > inner_radius && std::isfinite(outer_radius), "outer_radius", outer_radius,
                        "finite and greater than inner_radius");
        const double width = outer_radius - inner_radius;
        return quarter(width, width, flatness, points, 0);
    }

private:
    /// The quarter of \p points a side of the whole face; \p along_y 0: a strip along y, of one form.
    static JointForm quarter(double side_x, double side_y, double flatness, Eigen::Index points, double along_y) {
        detail::require(flatness >= 0 && std::isfinite(flatness), "flatness", flatness, "finite and 0 or greater");
        detail::require_form_points(points);
        const Eigen::Index half = (points + 1) / 2, rows = along_y > 0 ? half : 2;
        JointForm form;
        form.gap.dx = side_x / static_cast<double>(2 * half);
        form.gap.dy = side_y / static_cast<double>(2 * half);
        form.gap.heights = HeightMap<double>::Array::NullaryExpr(rows, half, [&](Eigen::Index j, Eigen::Index i) {
            const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(half),
                         y = (static_cast<double>(j) + 0.5) / static_cast<double>(half);
            return flatness * (std::min)(1.0, x * x + along_y * y * y);
        });
        return form;
    }
};

}}  // namespace fstiff
