// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Straight line through ln S2 over ln n, S2 of second differences, by generalised least squares.
///
///     ln S2(tau) = p ln tau + ln C + ln(4 - 2^p),  p = 4 - 2D                       eq. (2.5)
///                + a tau^-p + b tau^(4-p)                                           ends of the band
///                + harmonics 1, 2 of cos, sin(2 pi ln tau / ln gamma)               log-periodic
///
/// The terms a (waves missing below the resolution) and b (end of the spectrum) have a prior mean and deviation, so
/// that their uncertainty enters the error of D. The log-periodic terms enter where they explain half of the scatter.
///
/// Reference   Buczkowski et al., Arch. Mech. 66 (2014), eq. (2.5); Aitken, Proc. R. Soc. Edinb. 55 (1935) 42
/// Valid       at least 4 lags, 0 < p < 2
/// Accuracy    1e-10 of data that are a line (tests/profile/structure_fit_test.cpp)

#include <fstiff/core/parallel.hpp>
#include <fstiff/math/decompositions.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/profile/lag_window.hpp>

#include <numbers>

// Covariance of the structure function of second differences, in closed form and by resampling.
//
//     Cov(ln S2_n, ln S2_m) = 4 pi / sqrt(M_n M_m) int W_n W_m C^2 dq / (V_n V_m),  q from -pi to pi
//     W_n(q) = 4 (1 - cos q n)^2,  V_n = int W_n C dq,  M_n triples of n
//     C(q) = sum over all whole k of |q + 2 pi k|^-(1+p)                             the spectrum, sampled
//
// for a long Gaussian profile whose S grows as n^p; a sum over 48 wave numbers an octave, positive despite rounding.
// Resamples are blocks of neighbouring cells; a triple belongs to the cell of its centre.
//
// Units       ln S2 in any unit
// Valid       lags rising, 0 < p < 2
// Accuracy    5 % of the sum over all pairs of a profile of 20 lags and more (tests/profile/structure_errors_test.cpp)

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Covariance of ln S2 at the lags \p step, with \p triples each, for a Gaussian profile whose S grows as n^\p power.
template <Real T>
Matrix<T> log_covariance(const std::vector<std::size_t>& step, const std::vector<std::size_t>& triples, T power) {
    constexpr int per_octave = 48;
    const T pi = std::numbers::pi_v<T>, turn = 2 * pi;
    const auto longest = static_cast<T>(step.back());
    const auto nodes = static_cast<Eigen::Index>(per_octave * std::log2(10 * pi * longest)) + 1;
    const auto size = static_cast<Eigen::Index>(step.size());
    Matrix<T> shares(nodes, size);  // W_n C sqrt(dq), a column for every lag
    std::vector<T> means(step.size());
    for (Eigen::Index node = 0; node < nodes; ++node) {
        const T q = pi * std::exp2(-(static_cast<T>(node) + T(0.5)) / per_octave);
        const T width = q * std::log(T(2)) / per_octave;
        T spectrum = std::pow(q, -1 - power) + 2 * std::pow(turn, -1 - power) * std::pow(T(3.5), -power) / power;
        for (const int k : {1, 2, 3})
            spectrum +=
                std::pow(static_cast<T>(k) * turn - q, -1 - power) + std::pow(static_cast<T>(k) * turn + q, -1 - power);
        for (std::size_t n = 0; n < step.size(); ++n) {
            const T wave = 1 - std::cos(q * static_cast<T>(step[n]));
            T& share = shares(node, static_cast<Eigen::Index>(n));
            share = 4 * wave * wave * spectrum * std::sqrt(width);
            means[n] += share * std::sqrt(width);
        }
    }
    for (std::size_t n = 0; n < step.size(); ++n) {
        // both halves of the spectrum: V twice, the integral twice; at least one value for a lag
        const T triples_of_it = (std::max)(static_cast<T>(triples[n]), T(1));
        const T factor = std::sqrt(turn / triples_of_it) / means[n];
        for (Eigen::Index node = 0; node < nodes; ++node) shares(node, static_cast<Eigen::Index>(n)) *= factor;
    }
    Matrix<T> covariance(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index j = 0; j <= i; ++j)
            covariance(i, j) = covariance(j, i) = math::dot_in_lanes(&shares(0, i), &shares(0, j), nodes);
    return covariance;
}

/// ln S2 of moving-block resamples of the profile: steps by rows, resamples by columns.
template <Real T>
Matrix<T> bootstrap_log_structure(const Profile<T>& profile, const std::vector<std::size_t>& step, int resamples,
                                  std::uint64_t seed, const ProgressHook& progress) {
    constexpr std::size_t cells_wanted = 256;
    const std::vector<T>& z = profile.heights;
    const std::size_t cell = std::max<std::size_t>(1, z.size() / cells_wanted);
    const std::size_t cells = (z.size() + cell - 1) / cell;
    // four times the longest lag, so that blocks are nearly independent of their neighbours
    const std::size_t block =
        std::clamp<std::size_t>(4 * step.back() / cell + 1, 1, std::max<std::size_t>(1, cells / 4));
    math::BlockBootstrap<T> bootstrap(cells, block, static_cast<std::size_t>(resamples), seed);
    const T inverse = 1 / (2 * height_scale(profile));  // of a power of two: the products are exact
    const bool complete = profile.present() == z.size();
    Matrix<T> resampled(static_cast<Eigen::Index>(step.size()), resamples);
    std::vector<std::pair<T, T>> totals(cells);  // sums of squares, and triples
    for (std::size_t k = 0; k < step.size(); ++k) {
        if (progress) progress("bootstrap", k, step.size());
        const std::size_t n = step[k];
        const auto difference = [&](std::size_t i) {
            return (z[i + n] - z[i]) * inverse - (z[i] - z[i - n]) * inverse;
        };
        const auto square = [&](std::size_t i) {
            const T bend = difference(i);
            return complete || !std::isnan(bend) ? bend * bend : T(0);
        };
        std::fill(totals.begin(), totals.end(), std::pair<T, T>());
        std::size_t c = n / cell;
        math::sum_runs<T>(n, z.size() - n, cell, square, [&](T sum) {
            const std::size_t from = (std::max)(c * cell, n), end = (std::min)((c + 1) * cell, z.size() - n);
            auto triples = static_cast<T>(end - from);
            for (std::size_t i = from; !complete && i < end; ++i) triples -= std::isnan(difference(i)) ? T(1) : T(0);
            totals[c++] = {sum, triples};
        });
        const std::vector<T>& means = bootstrap.means([&](std::size_t part) { return totals[part]; });
        for (int r = 0; r < resamples; ++r)
            resampled(static_cast<Eigen::Index>(k), r) = std::log(means[static_cast<std::size_t>(r)]);
    }
    return resampled;
}

/// Covariance of \p a * y and \p b * y for values y of the covariance \p of_values.
template <Real T>
T covariance_of_rows(const Vector<T>& a, const Vector<T>& b, const Matrix<T>& of_values) {
    return math::dot_in_lanes(a.data(), math::product(of_values, b.data(), b.size()).data(), a.size());
}

/// Standard deviation of row * y for values y of this covariance.
template <Real T>
T expected_spread(const Vector<T>& row, const Matrix<T>& covariance) {
    return std::sqrt((std::max)(T(0), covariance_of_rows(row, row, covariance)));
}

/// Standard deviation of row * column over the columns of \p samples.
template <Real T>
T sample_spread(const Vector<T>& row, const Matrix<T>& samples) {
    const Eigen::Index size = samples.cols();
    Vector<T> values = math::vector_of<T>(
        size, [&](Eigen::Index i) { return math::dot_in_lanes(&samples(0, i), row.data(), row.size()); });
    const T mean = math::sum_in_lanes(values.data(), size) / static_cast<T>(size);
    for (Eigen::Index i = 0; i < size; ++i) values[i] -= mean;
    return std::sqrt(math::dot_in_lanes(values.data(), values.data(), size) /
                     static_cast<T>(std::max<Eigen::Index>(1, size - 1)));
}

/// Missing share of S2 at the first lag when no wave is shorter than that.
template <Real T>
T share_of_short_waves(T power) {
    using std::pow;
    const T pi = std::numbers::pi_v<T>;
    return 6 * std::tgamma(1 + power) * std::sin(pi * power / 2) /
           (pi * power * (4 - pow(T(2), power)) * pow(2 * pi, power));
}

/// Ratio of this share in sections of an isotropic map to that of a profile.
template <Real T>
T share_of_oblique_waves(T power) {
    return std::sqrt(std::numbers::pi_v<T>) * std::tgamma(1 + power / 2) / std::tgamma((1 + power) / 2);
}

/// Lower triangular root L of a = L L^T, which must be positive definite.
template <Real T>
Matrix<T> cholesky(const Matrix<T>& a) {
    Matrix<T> l = Matrix<T>::Zero(a.rows(), a.cols());
    for (Eigen::Index j = 0; j < a.rows(); ++j) {
        T left = a(j, j);
        for (Eigen::Index k = 0; k < j; ++k) left -= l(j, k) * l(j, k);
        l(j, j) = std::sqrt((std::max)(left, a(j, j) * std::numeric_limits<T>::epsilon()));
        for (Eigen::Index i = j + 1; i < a.rows(); ++i) {
            T sum = a(i, j);
            for (Eigen::Index k = 0; k < j; ++k) sum -= l(i, k) * l(j, k);
            l(i, j) = sum / l(j, j);
        }
    }
    return l;
}

/// L^-1 a.
template <Real T>
Matrix<T> forward_substituted(const Matrix<T>& l, Matrix<T> a) {
    for (Eigen::Index column = 0; column < a.cols(); ++column)
        for (Eigen::Index i = 0; i < l.rows(); ++i) {
            T sum = a(i, column);
            for (Eigen::Index k = 0; k < i; ++k) sum -= l(i, k) * a(k, column);
            a(i, column) = sum / l(i, i);
        }
    return a;
}

/// A line through the values of ln S2 in one window. Rows are over all lags of the LogStructure, 0 beyond the window:
/// their products with the values, and with the columns a and b, give the line and its changes.
template <Real T = double>
struct LogFit {
    IndexRange range;
    T reference{};       ///< ln n of the middle of the window
    T level{}, slope{};  ///< ln S2 there, without a and b, and p
    Vector<T> level_row, slope_row;
    Vector<T> fitted;               ///< the whole sum above at the lags of range, to be compared with ln S2
    T short_waves{}, long_waves{};  ///< a, b
    T residual{};                   ///< weighted sum of squares
    bool finite_band{};             ///< a or b differs from 0 by two of its standard deviations
    bool log_periodic{};
};

/// Fits lines to one structure function whose slope is near \p power.
template <Real T>
class LineFitter {
public:
    /// \p covariance of log.value; \p band_ends: no wave is much shorter than the window.
    LineFitter(const LogStructure<T>& log, Matrix<T> covariance, T power, T log_gamma, bool band_ends)
        : log_(log),
          covariance_(std::move(covariance)),
          power_(power),
          log_gamma_(log_gamma),
          short_sd_(T(0.6) * share_of_short_waves(power) * (log.apart > T(0) ? share_of_oblique_waves(power) : T(1))),
          expected_short_(short_sd_ * (band_ends          ? T(-1.25)
                                       : log.apart > T(0) ? T(-1)
                                                          : T(-0.75))),
          y_(log.value) {
        for (Eigen::Index k = 0; k < y_.size(); ++k) {
            // the logarithm of a mean of squares is low by half its variance
            y_[k] += (std::min)(covariance_(k, k), T(0.5)) / 2;
            covariance_(k, k) += T(0.0009);
        }
    }

    const Vector<T>& y() const { return y_; }

    /// Line in \p lags. The columns a and b are those of the window \p band.
    LogFit<T> fit(const IndexRange& lags, const IndexRange& band) const {
        LogFit<T> line = fit_with(lags, band, false);
        const T width = log_.lag[lags.last] - log_.lag[lags.first];
        if (width > 2 * log_gamma_ && lags.count() >= 12)
            if (LogFit<T> waves = fit_with(lags, band, true); waves.residual < line.residual / 2) line = waves;
        return line;
    }

    /// Covariance of row_a * ln S2 and row_b * ln S2 by sampling alone, and with the uncertainty of a and b of \p band.
    T covariance_of(const Vector<T>& row_a, const Vector<T>& row_b, const IndexRange& band) const {
        const Matrix<T> ends = band_columns(band);
        const auto share = [&](const Vector<T>& row, Eigen::Index end) {
            return math::dot_in_lanes(row.data(), &ends(0, end), row.size());
        };
        const T a = share(row_a, 0) * share(row_b, 0) * short_sd_ * short_sd_;
        const T b = share(row_a, 1) * share(row_b, 1) * long_sd * long_sd;
        return covariance_of_rows(row_a, row_b, covariance_) + a + b;
    }

private:
    static constexpr T long_sd = T(0.5);

    /// a and b at all lags: each is 1 at its own end of the band.
    Matrix<T> band_columns(const IndexRange& band) const {
        Matrix<T> columns(log_.lag.size(), 2);
        const auto fill = [&](Eigen::Index end, T power, T origin) {
            for (Eigen::Index i = 0; i < columns.rows(); ++i)
                columns(i, end) = (std::min)(power * (log_.lag[i] - origin), T(2));
            Eigen::Map<Eigen::Array<T, Eigen::Dynamic, 1>> column(&columns(0, end), columns.rows());
            column = column.exp();
        };
        fill(0, -power_, log_.lag[band.first]);
        fill(1, 4 - power_, log_.lag[band.last]);
        return columns;
    }

    LogFit<T> fit_with(const IndexRange& range, const IndexRange& band, bool log_periodic) const {
        const Eigen::Index count = range.count(), terms = log_periodic ? 8 : 4;
        LogFit<T> line;
        line.range = range;
        line.log_periodic = log_periodic;
        line.reference = (log_.lag[range.first] + log_.lag[range.last]) / 2;
        const Matrix<T> columns = columns_of(range, band, line.reference, terms), covariance = covariance_in(range);
        const Matrix<T> root = cholesky<T>(covariance);
        // two more values, 0: the prior of a and b
        Matrix<T> weighted = Matrix<T>::Zero(count + 2, terms), identity = Matrix<T>::Zero(count, count);
        const Matrix<T> divided = forward_substituted<T>(root, columns);
        for (Eigen::Index term = 0; term < terms; ++term)
            for (Eigen::Index i = 0; i < count; ++i) weighted(i, term) = divided(i, term);
        weighted(count, 2) = 1 / short_sd_;
        weighted(count + 1, 3) = 1 / long_sd;
        for (Eigen::Index i = 0; i < count; ++i) identity(i, i) = 1;
        const Matrix<T> inverse_root = forward_substituted<T>(root, std::move(identity));
        const Matrix<T> of_weighted = math::PivotedQr<T>(weighted).solver();
        Matrix<T> solver(terms, count);
        for (Eigen::Index k = 0; k < count; ++k)
            std::copy_n(math::product(of_weighted, &inverse_root(0, k), count).data(), terms, &solver(0, k));
        const Vector<T> y = math::vector_of<T>(
            count, [&](Eigen::Index i) { return y_[range.first + i] - expected_short_ * columns(i, 2); });
        const Vector<T> solution = math::product(solver, y.data(), count);
        const auto spread = [&](Eigen::Index term) {
            const Vector<T> row = math::vector_of<T>(count, [&](Eigen::Index i) { return solver(term, i); });
            return std::sqrt(covariance_of_rows(row, row, covariance));
        };
        line.level = solution[0], line.slope = solution[1], line.short_waves = solution[2] + expected_short_,
        line.long_waves = solution[3];
        line.finite_band = std::abs(solution[2]) > 2 * spread(2) || std::abs(solution[3]) > 2 * spread(3);
        Vector<T> missed = math::product(columns, solution.data(), terms);
        for (Eigen::Index i = 0; i < count; ++i) missed[i] = y[i] - missed[i];
        const Vector<T> left = math::product(inverse_root, missed.data(), count);
        line.residual = math::dot_in_lanes(left.data(), left.data(), count);
        line.fitted =
            math::vector_of<T>(count, [&](Eigen::Index i) { return log_.value[range.first + i] - missed[i]; });
        const auto row = [&](Eigen::Index term) {
            return math::vector_of<T>(log_.lag.size(), [&](Eigen::Index i) {
                return i >= range.first && i <= range.last ? solver(term, i - range.first) : T(0);
            });
        };
        line.level_row = row(0), line.slope_row = row(1);
        return line;
    }

    /// The columns of the line, of a and b, and with 8 \p terms those of the harmonics, at the lags of \p range.
    Matrix<T> columns_of(const IndexRange& range, const IndexRange& band, T reference, Eigen::Index terms) const {
        Matrix<T> columns(range.count(), terms);
        const Matrix<T> ends = band_columns(band);
        for (Eigen::Index i = 0; i < range.count(); ++i) {
            const Eigen::Index k = range.first + i;
            const T x = log_.lag[k] - reference;
            columns(i, 0) = 1, columns(i, 1) = x, columns(i, 2) = ends(k, 0), columns(i, 3) = ends(k, 1);
            for (Eigen::Index harmonic = 1; 2 + 2 * harmonic < terms; ++harmonic) {
                const T angle = 2 * static_cast<T>(harmonic) * std::numbers::pi_v<T> / log_gamma_ * x;
                columns(i, 2 + 2 * harmonic) = std::cos(angle), columns(i, 3 + 2 * harmonic) = std::sin(angle);
            }
        }
        return columns;
    }

    Matrix<T> covariance_in(const IndexRange& range) const {
        Matrix<T> part(range.count(), range.count());
        for (Eigen::Index k = 0; k < range.count(); ++k)
            std::copy_n(&covariance_(range.first, range.first + k), range.count(), &part(0, k));
        return part;
    }

    const LogStructure<T>& log_;
    Matrix<T> covariance_;
    T power_, log_gamma_, short_sd_, expected_short_;
    Vector<T> y_;
};

}}}  // namespace fstiff::detail
