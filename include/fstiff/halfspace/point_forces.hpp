// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Deflection of points of an elastic half space by forces on these points and their images, all by all in O(n log n).
///
///     u_i = sum_j g(x_i, x_j) F_j/E       g = sum over the images of j of 1/(pi r), less its mean; without i on itself
///     1/r = erfc(a r)/r + erf(a r)/r      the first summed over the images within r_c = 4.2/a, the second on a grid:
///                                         2/q erfc(q/(2a)), forces spread and read through a window of 10 points
///
/// The images are those of a repeating or a mirrored cell. Derivation: docs/theory-contact.md, section 11.
/// Reference   Ewald, Ann. Phys. 369 (1921) 253, here for 1/r over a plane; Hockney, Eastwood, Computer Simulation
///             Using Particles (1988), ch. 8; window: Barnett et al., SIAM J. Sci. Comput. 41 (2019) C479
/// Units       x, y, u [m], F/E [m^2]
/// Valid       points within the cell; two points not at the same place
/// Time        3 ms for 5000 points, after 25 ms for the pairs; a quick split 0.5 ms
/// Accuracy    2e-9 of the largest deflection against a direct sum, a quick split 2e-4 (tests/halfspace)

#include <fstiff/core/error.hpp>
#include <fstiff/halfspace/surface_compliance.hpp>
#include <fstiff/math/fft.hpp>
#include <fstiff/math/quadrature.hpp>
#include <fstiff/topography/line_transform.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Border between the sum over images and the grid: 2e-9 of the largest deflection.
struct FineSplit {
    static constexpr int window = 10;     ///< points of the grid along one side
    static constexpr double reach = 4.2;  ///< a r_c
    static constexpr double waves = 7.4;  ///< over a: up to this wave number the window is resolved twice
};
/// The same for iterations, in a fifth of the time: 2e-4 of the largest deflection.
struct QuickSplit {
    static constexpr int window = 5;
    static constexpr double reach = 2.6;
    static constexpr double waves = 4.8;
};

/// Points of one cell and their deflections by forces on each other.
template <Real T = double, class Split = FineSplit>
class PointForces {
    using Values = Eigen::Array<T, Eigen::Dynamic, 1>;

public:
    /// Points at \p x, \p y from a corner of a cell of \p width by \p height [m].
    /// \throws domain_error for numbers of x and y that differ, a cell that is not finite and positive, points outside
    /// of it.
    PointForces(Values x, Values y, T width, T height, Edges edges)
        : PointForces(std::move(x), std::move(y), Cell{width, height, edges}) {}

    /// u [m] of \p force over E [m^2] on each point.
    [[nodiscard]] Values deflections(const Values& force) {
        Values u = self_ * force - mean_ * force.sum();
        for (std::size_t i = 0; i + 1 < start_.size(); ++i) {
            T sum = 0;
            for (std::size_t k = start_[i]; k < start_[i + 1]; ++k) sum += near_value_[k] * force[near_point_[k]];
            u[static_cast<Eigen::Index>(i)] += sum;
        }
        spread(force);
        compliance_.deflect(grid_);
        read(u);
        return u;
    }

    /// A number less than u [m] under \p force over E [m^2] at any point without a force: of the grid alone.
    [[nodiscard]] T least_deflection(const Values& force) {
        spread(force);
        compliance_.deflect(grid_);
        return grid_.minCoeff() - T(1e-5) * grid_.abs().maxCoeff() - mean_ * force.sum();
    }

    /// Calls \p use(other, value) for the images of other points within r_c of \p point; value is erfc(a r)/(pi r)
    /// [1/m].
    template <class Use>
    void visit_close(Eigen::Index point, const Use& use) const {
        const auto i = static_cast<std::size_t>(point);
        for (std::size_t k = start_[i]; k < start_[i + 1]; ++k)
            if (near_point_[k] != point) use(near_point_[k], near_value_[k]);
    }

private:
    static constexpr int window = Split::window;
    static constexpr int neighbours = 60;  ///< within r_c, of points that are spread evenly
    static constexpr Eigen::Index margin = (window + 1) / 2;
    static constexpr T end_over_a = T(9);  ///< q/a at which erfc(q/(2a)) is 2e-10
    static constexpr T shape = T(2.3) * window;

    struct Cell {
        T width, height;
        Edges edges;
    };
    struct Image {
        T x, y;
        Eigen::Index point;
    };
    struct Window {
        Eigen::Index first;  ///< column of the margined grid
        std::array<Eigen::Index, static_cast<std::size_t>(window)> row;
        Eigen::Array<T, 1, window> along_x, along_y;
    };

    PointForces(Values x, Values y, const Cell& cell)
        : range_(range_of(x, y, cell)),
          compliance_(
              cells(cell.height), cells(cell.width), cell.width / T(cells(cell.width)),
              cell.height / T(cells(cell.height)), cell.edges,
              [a = T(Split::reach) / range_](T q) { return q > end_over_a * a ? T(0) : std::erfc(q / (2 * a)); },
              [](T phase) {
                  const T factor = transform_of_window(T(0)) / transform_of_window(phase);
                  return factor * factor;
              }) {
        grid_.resize(cells(cell.height), cells(cell.width));
        margined_.resize(grid_.rows(), grid_.cols() + 2 * margin);
        const T a = T(Split::reach) / range_, pi = std::numbers::pi_v<T>;
        self_ = -2 * a / (pi * std::sqrt(pi));
        mean_ = 2 / (a * std::sqrt(pi) * cell.width * cell.height);
        per_cell_ = T(grid_.size()) / (cell.width * cell.height);  // a force becomes a pressure
        make_windows(x, y, cell);
        make_pairs(x, y, cell);
    }

    [[nodiscard]] static T range_of(const Values& x, const Values& y, const Cell& cell) {
        require_positive("width", cell.width);
        require_positive("height", cell.height);
        require(x.size() == y.size() && x.size() > 0, "points", y.size(), "as many x as y, and at least 1");
        require((x >= 0).all() && (x <= cell.width).all() && (y >= 0).all() && (y <= cell.height).all(), "points",
                x.size(), "within the cell");
        const T even = std::sqrt(T(neighbours) * cell.width * cell.height / (std::numbers::pi_v<T> * T(x.size())));
        return (std::min)(even, (std::min)(cell.width, cell.height) / 2);
    }

    /// Cells of the grid along \p side: up to the wave number Split::waves a the window is resolved twice.
    [[nodiscard]] Eigen::Index cells(T side) const {
        const T step = std::numbers::pi_v<T> * range_ / T(2 * Split::reach * Split::waves);
        return static_cast<Eigen::Index>(
            math::fast_fft_size((std::max)(std::size_t{2 * window}, static_cast<std::size_t>(std::ceil(side / step)))));
    }

    [[nodiscard]] static T window_at(T offset) {
        const T rest = 1 - offset * offset * 4 / (window * window);
        return std::exp(shape * (std::sqrt((std::max)(rest, T(0))) - 1));
    }

    /// int window_at(t) cos(phase t) dt over the window.
    [[nodiscard]] static T transform_of_window(T phase) {
        constexpr std::size_t count = 48;
        const auto& rule = math::GaussLegendre<T, count>::get();
        static const auto weight = [&] {
            std::array<T, count> result;
            for (std::size_t i = 0; i < count; ++i)
                result[i] = T(window) / 2 * rule.weight[i] * window_at(T(window) / 2 * rule.node[i]);
            return result;
        }();
        T sum = 0;
        for (std::size_t i = 0; i < count; ++i) sum += weight[i] * std::cos(phase * (T(window) / 2 * rule.node[i]));
        return sum;
    }

    /// Index of a grid of \p size cells that goes on beyond its edges.
    [[nodiscard]] static Eigen::Index wrapped(Eigen::Index i, Eigen::Index size, Edges edges) {
        if (i >= 0 && i < size) return i;
        if (edges == Edges::periodic) return i < 0 ? i + size : i - size;
        return i < 0 ? -1 - i : 2 * size - 1 - i;
    }

    void make_windows(const Values& x, const Values& y, const Cell& cell) {
        const T total = transform_of_window(T(0));
        // centres of the cells lie at half steps; a point on one is the same window whatever its rounding
        const T half = T(window) / 2 + 64 * std::numeric_limits<T>::epsilon() * T(grid_.rows() + grid_.cols());
        const auto first_of = [half](T place) { return static_cast<Eigen::Index>(std::ceil(place - half)); };
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const T right = x[i] / cell.width * T(grid_.cols()) - T(0.5),
                    down = y[i] / cell.height * T(grid_.rows()) - T(0.5);
            Window patch;
            patch.first = first_of(right) + margin;
            for (int k = 0; k < window; ++k) {
                patch.row[static_cast<std::size_t>(k)] = wrapped(first_of(down) + k, grid_.rows(), cell.edges);
                patch.along_x[k] = window_at(T(first_of(right) + k) - right) / total;
                patch.along_y[k] = window_at(T(first_of(down) + k) - down) / total;
            }
            windows_.push_back(patch);
        }
        for (Eigen::Index k = 0; k < margin; ++k) {
            beyond_.push_back({k, wrapped(k - margin, grid_.cols(), cell.edges)});
            beyond_.push_back({grid_.cols() + margin + k, wrapped(grid_.cols() + k, grid_.cols(), cell.edges)});
        }
    }

    /// The pressures of \p force on the grid.
    void spread(const Values& force) {
        margined_.setZero();
        for (std::size_t i = 0; i < windows_.size(); ++i) {
            const Window& patch = windows_[i];
            const Eigen::Array<T, 1, window> share = per_cell_ * force[static_cast<Eigen::Index>(i)] * patch.along_x;
            for (int k = 0; k < window; ++k)
                margined_.row(patch.row[static_cast<std::size_t>(k)]).template segment<window>(patch.first) +=
                    patch.along_y[k] * share;
        }
        grid_ = margined_.middleCols(margin, grid_.cols());
        for (const auto& [outside, inside] : beyond_) grid_.col(inside) += margined_.col(outside);
    }

    /// Adds the deflections of the grid at the points to \p u.
    void read(Values& u) {
        margined_.middleCols(margin, grid_.cols()) = grid_;
        for (const auto& [outside, inside] : beyond_) margined_.col(outside) = grid_.col(inside);
        for (std::size_t i = 0; i < windows_.size(); ++i) {
            const Window& patch = windows_[i];
            Eigen::Array<T, 1, window> sum = Eigen::Array<T, 1, window>::Zero();
            for (int k = 0; k < window; ++k)
                sum += patch.along_y[k] *
                       margined_.row(patch.row[static_cast<std::size_t>(k)]).template segment<window>(patch.first);
            u[static_cast<Eigen::Index>(i)] += (sum * patch.along_x).sum();
        }
    }

    /// The pairs of a point and an image of a point within r_c.
    void make_pairs(const Values& x, const Values& y, const Cell& cell) {
        std::vector<Image> images;
        const auto places = [&](T place, T side) {
            return cell.edges == Edges::periodic ? std::array<T, 3>{place, place - side, place + side}
                                                 : std::array<T, 3>{place, -place, 2 * side - place};
        };
        for (Eigen::Index i = 0; i < x.size(); ++i)
            for (const T u : places(x[i], cell.width))
                for (const T v : places(y[i], cell.height))
                    if (u > -range_ && u < cell.width + range_ && v > -range_ && v < cell.height + range_)
                        images.push_back({u, v, i});
        const auto left = [](const Image& a, const Image& b) { return a.x < b.x; };
        std::sort(images.begin(), images.end(), left);
        const T a = T(Split::reach) / range_;
        start_.push_back(0);
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            auto image = std::lower_bound(images.begin(), images.end(), Image{x[i] - range_, 0, 0}, left);
            for (; image != images.end() && image->x < x[i] + range_; ++image) {
                if (std::abs(image->y - y[i]) >= range_) continue;
                const T right = image->x - x[i], down = image->y - y[i], r = std::sqrt(right * right + down * down);
                if (r >= range_ || r == 0) continue;  // 0: the point itself
                near_point_.push_back(image->point);
                near_value_.push_back(std::erfc(a * r) / (std::numbers::pi_v<T> * r));
            }
            start_.push_back(near_point_.size());
        }
    }

    T range_, self_{}, mean_{}, per_cell_{};
    SurfaceCompliance<T> compliance_;
    GridField<T> grid_, margined_;  ///< the latter with columns beyond the edges, for windows across them
    std::vector<std::pair<Eigen::Index, Eigen::Index>> beyond_;  ///< each such column and where it belongs
    std::vector<Window> windows_;
    std::vector<std::size_t> start_;  ///< of the pairs of each point
    std::vector<Eigen::Index> near_point_;
    std::vector<T> near_value_;
};

}}}  // namespace fstiff::detail
