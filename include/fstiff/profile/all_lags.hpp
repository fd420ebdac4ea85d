// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Structure function of a profile at every lag, by Fourier transform.
///
///     N_n S(n h) = A_n + B_n - 2 R_n + 2 b n sum(r_(i+n) - r_i) + N_n (b n)^2        eq. (2.8)
///     z_i = a + b i + r_i,  R_n = sum r_i r_(i+n),  A_n, B_n: sums of r_i^2 over the first and the last N_n points
///
/// The line is removed first and added again in closed form. The rounding error of A + B - 2R is bounded for every lag;
/// a lag with a bound above 1e-10 of S is evaluated again, short lags in segments, others from their pairs.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eq. (2.8)
/// Units       lag [m], S [m^2]
/// Valid       2 to 2^29 points; every height finite or NaN (missing)
/// Accuracy    1e-10 relative at every lag in double, tilt up to 1e6 times the roughness
///             (tests/profile/all_lags_test.cpp)
/// Cost        two transforms of 2N points, and N for every lag from its pairs: a few dozen for a rough profile

#include <fstiff/math/fft.hpp>
#include <fstiff/profile/structure_function.hpp>

#include <Eigen/Core>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Sums over pairs of one profile; heights are scaled, and 0 where \p present is 0; an empty \p present means that no
/// point is missing.
template <class F>
class AllLags {
public:
    AllLags(const std::vector<F>& heights, const std::vector<char>& present, std::size_t longest)
        : z_(heights), present_(present), size_(heights.size()), longest_(longest) {
        complete_ = present.empty();
        take_off_line();
        sum.resize(longest_);
        pairs.resize(longest_);
        complete_ ? correlate_whole() : correlate_present();
        recompute_marked();
    }

    std::vector<F> sum;              ///< of squared differences, at lag n - 1
    std::vector<std::size_t> pairs;  ///< at lag n - 1

private:
    static constexpr F tolerance = F(0.8e-10);  // the rest of 1e-10 is for the rounding of the sums themselves
    static constexpr F epsilon = (std::max)(std::numeric_limits<F>::epsilon(), static_cast<F>(2.3e-16L));
    static constexpr F fft_error =
        8 * epsilon;  // of a correlation, over its value at lag 0: six times the measured one

    /// Sum of \p term over the points that exist, in short runs so that rounding errors do not accumulate.
    template <class Term>
    F over_points(const Term& term) const {
        constexpr std::size_t run = 1024;
        F total = 0;
        for (std::size_t start = 0; start < size_; start += run) {
            F part = 0;
            for (std::size_t i = start; i < (std::min)(start + run, size_); ++i)
                if (complete_ || present_[i]) part += term(i);
            total += part;
        }
        return total;
    }

    void take_off_line() {
        const F centre = static_cast<F>(size_ - 1) / 2;  // exact
        const auto position = [&](std::size_t i) { return static_cast<F>(i) - centre; };
        const F points =
            complete_ ? static_cast<F>(size_) : (std::max)(over_points([](std::size_t) { return F(1); }), F(1));
        const F level = over_points([&](std::size_t i) { return z_[i]; }) / points;
        const F middle = complete_ ? F(0) : over_points(position) / points;
        const F square =
            complete_ ? points * (points * points - 1) / 12
                      : over_points([&](std::size_t i) { return (position(i) - middle) * (position(i) - middle); });
        slope_ = square > 0
                     ? over_points([&](std::size_t i) { return (position(i) - middle) * (z_[i] - level); }) / square
                     : F(0);
        residual_.resize(math::fast_fft_size(size_ + longest_));  // padded with zeros for the transform
        // z - level - slope u with the rounding errors of the difference and of the product
        for (std::size_t i = 0; i < size_; ++i) {
            if (!complete_ && !present_[i]) continue;
            const F u = position(i);  // exact, so that differences of the line are slope times lag
            const math::RoundedSum<F> difference = math::two_sum(z_[i], -level);
            const F product = slope_ * u, product_lost = std::fma(slope_, u, -product);
            residual_[i] = (difference.sum - product) + (difference.error - product_lost);
        }
        // the residual keeps a constant, slope times middle and the rounding: differences do not depend on it
        const F constant = over_points([&](std::size_t i) { return residual_[i]; }) / points;
        for (std::size_t i = 0; i < size_; ++i)
            if (complete_ || present_[i]) residual_[i] -= constant;
    }

    /// Replaces \p spectrum by the transform of its norms: a real even spectrum is its own inverse.
    static void transform_norms(math::RealFft<F>& fft, std::vector<std::complex<F>>& spectrum) {
        std::vector<F> even(fft.size());
        for (std::size_t k = 0; k < spectrum.size(); ++k)
            even[k] = even[(fft.size() - k) % fft.size()] =
                std::norm(spectrum[k]) * (F(1) / static_cast<F>(fft.size()));
        fft.forward(even, spectrum);
    }

    void correlate_whole() {
        math::RealFft<F> fft(residual_.size());
        std::vector<std::complex<F>> spectrum;
        fft.forward(residual_, spectrum);
        transform_norms(fft, spectrum);
        const F zero = over_points([&](std::size_t i) { return residual_[i] * residual_[i]; });
        // squares outside the pairs' beginnings and ends; last n less first n points
        math::CompensatedSum<F> left_out, edges;
        for (std::size_t n = 1; n <= longest_; ++n) {
            const F head = residual_[n - 1], tail = residual_[size_ - n];
            left_out.add(head * head + tail * tail);
            edges.add(tail - head);
            const F count = static_cast<F>(size_ - n), line = slope_ * static_cast<F>(n);
            // sum of r_(i+n) - r_i = (all - first n) - (all - last n)
            const F cross = 2 * line * edges.value();
            sum[n - 1] = (2 * zero - left_out.value()) - 2 * spectrum[n].real() + cross + count * line * line;
            pairs[n - 1] = size_ - n;
            mark_inaccurate(n, 2 * fft_error * zero + 4 * epsilon * (std::abs(cross) + count * line * line) +
                                   4 * epsilon * std::abs(line) * std::sqrt(zero * static_cast<F>(2 * n)));
        }
    }

    /// Sums with missing points: pairs, sum of differences and sum of squared differences are three correlations.
    void correlate_present() {
        math::RealFft<F> fft(residual_.size());
        const std::size_t half = fft.size() / 2;
        const F scale = F(1) / static_cast<F>(fft.size());
        std::vector<std::complex<F>> spectrum, other, mask;
        std::vector<F> even(fft.size()), work(size_);
        fft.forward(residual_, spectrum);
        for (std::size_t i = 0; i < size_; ++i) work[i] = present_[i] ? F(1) : F(0);
        fft.forward(work, mask);
        for (std::size_t i = 0; i < size_; ++i) work[i] = residual_[i] * residual_[i];
        fft.forward(work, other);
        const F zero = other[0].real(), points = mask[0].real();
        std::vector<F> odd(fft.size());
        for (std::size_t k = 0; k <= half; ++k) {
            // squares: A + B - 2R; differences: an odd imaginary spectrum, whose transform is imaginary
            const F squares = 2 * (std::real(std::conj(mask[k]) * other[k]) - std::norm(spectrum[k])) * scale;
            const F difference = 2 * std::imag(std::conj(mask[k]) * spectrum[k]) * scale;
            even[k] = even[(fft.size() - k) % fft.size()] = squares;
            odd[k] = difference;
            odd[(fft.size() - k) % fft.size()] = k == 0 || k == half ? F(0) : -difference;
            if (k == 0 || k == half) odd[k] = 0;
        }
        fft.forward(even, spectrum);
        fft.forward(odd, other);
        transform_norms(fft, mask);
        for (std::size_t n = 1; n <= longest_; ++n) {
            const F count = std::round(mask[n].real()), line = slope_ * static_cast<F>(n);
            const F cross = 2 * line * other[n].imag();
            sum[n - 1] = spectrum[n].real() + cross + count * line * line;
            pairs[n - 1] = count > 0 ? static_cast<std::size_t>(count) : 0;
            // twice as many correlations as above; that of mask and heights is at most sqrt(points times squares)
            mark_inaccurate(n, 4 * fft_error * zero + 4 * epsilon * (std::abs(cross) + count * line * line) +
                                   4 * fft_error * std::abs(line) * std::sqrt(zero * points));
        }
    }

    /// Records lag \p n for a second evaluation when the \p error of its sum may be too large.
    void mark_inaccurate(std::size_t n, F error) {
        if (pairs[n - 1] > 0 && !(error <= tolerance * sum[n - 1])) inaccurate_lags_.push_back(n);
    }

    /// Sum over the pairs of lag \p n that begin at \p from or later, in short runs so that rounding does not add up.
    F directly(std::size_t n, std::size_t from) const {
        constexpr std::size_t run = 1024;
        using Map = Eigen::Map<const Eigen::Array<F, Eigen::Dynamic, 1>>;
        F total = 0;
        for (std::size_t start = from; start < size_ - n; start += run) {
            const std::size_t end = (std::min)(start + run, size_ - n);
            const auto count = static_cast<Eigen::Index>(end - start);
            if (complete_) {
                total += (Map(z_.data() + start + n, count) - Map(z_.data() + start, count)).square().sum();
            } else {
                F part = 0;
                for (std::size_t i = start; i < end; ++i)
                    if (present_[i] && present_[i + n]) part += (z_[i + n] - z_[i]) * (z_[i + n] - z_[i]);
                total += part;
            }
        }
        return total;
    }

    /// Sums of lags 1 ... \p to in segments of the profile, by cross-correlations of x, the beginnings of the pairs,
    /// and y, their ends. Returns which lags are settled.
    std::vector<char> in_segments(std::size_t to) {
        std::vector<char> settled(to + 1);
        math::RealFft<F> fft(math::fast_fft_size(16 * to));
        const std::size_t width = fft.size(), begins = width - to, half = width / 2;
        std::vector<F> x, y;
        std::vector<std::complex<F>> begin, end, product(half + 1);
        std::vector<F> squares(to, F(0));
        F zero = 0;
        std::size_t from = 0;
        for (; from + width <= size_; from += begins) {
            const auto first = z_.begin() + static_cast<std::ptrdiff_t>(from);
            y.assign(first, first + static_cast<std::ptrdiff_t>(width));
            F mean = 0;
            for (const F z : y) mean += z;
            mean /= static_cast<F>(width);
            F total = 0;
            for (F& z : y) {
                z -= mean;
                total += z * z;
            }
            x.assign(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(begins));
            F own = 0;
            for (const F z : x) own += z * z;
            F moving = own;  // squares of the ends of the pairs
            for (std::size_t n = 1; n <= to; ++n) {
                moving += y[begins + n - 1] * y[begins + n - 1] - y[n - 1] * y[n - 1];
                squares[n - 1] += own + moving;
            }
            zero += total;
            fft.forward(x, begin);
            fft.forward(y, end);
            for (std::size_t k = 0; k <= half; ++k) product[k] += std::conj(begin[k]) * end[k];
        }
        if (from == 0) return settled;
        fft.inverse(product, x);
        // the sums above grow segment by segment and step by step
        const std::size_t count = size_ / begins;
        const F steps = std::sqrt(static_cast<F>(to)) + std::sqrt(static_cast<F>(count));
        for (std::size_t n = 1; n <= to; ++n) {
            const F segments = squares[n - 1] - 2 * x[n];
            const F bound = (16 + steps) * epsilon * zero;
            if (bound <= tolerance * segments) {
                sum[n - 1] = segments + directly(n, from);
                settled[n] = 1;
            }
        }
        return settled;
    }

    void recompute_marked() {
        // extent of the marked lags without a gap longer than half of the lags before it
        std::size_t last = 0, front = 0;
        while (front < inaccurate_lags_.size() && inaccurate_lags_[front] <= (std::min)(2 * last + 64, size_ / 64))
            last = inaccurate_lags_[front++];
        std::vector<char> settled;
        if (complete_ && front > 64) settled = in_segments(last);
        for (const std::size_t n : inaccurate_lags_)
            if (n >= settled.size() || !settled[n]) sum[n - 1] = directly(n, 0);
    }

    const std::vector<F>& z_;
    const std::vector<char>& present_;
    std::size_t size_, longest_;
    bool complete_{};
    F slope_{};  // per sample
    std::vector<F> residual_;
    std::vector<std::size_t> inaccurate_lags_;  // lags whose sum may be wrong, rising
};

/// S of \p profile at all lags of 1, 2, ... \p longest samples (0: all there are).
/// \throws domain_error as structure_function() does, and for a profile of fewer than 2 or more than 2^29 points.
template <Real T>
[[nodiscard]] StructureFunction<T> structure_function_at_all_lags(const Profile<T>& profile, std::size_t longest = 0,
                                                                  Divisor divisor = Divisor::pairs) {
    require_positive("spacing", profile.spacing);
    const std::size_t points = profile.size();
    if (points < 2 || points > std::size_t{1} << 29)
        throw domain_error("profile has " + std::to_string(points) + " points: must be between 2 and 2^29");
    if (longest >= points)
        refuse("lag", std::to_string(longest) + " samples", "between 1 and " + std::to_string(points - 1));
    const double scale = static_cast<double>(height_scale(profile));
    std::vector<double> heights(points);
    std::vector<char> present;
    if (profile.present() < points) present.resize(points);
    for (std::size_t i = 0; i < points; ++i) {
        const bool exists = !std::isnan(profile.heights[i]);
        if (!present.empty()) present[i] = exists ? 1 : 0;
        heights[i] = exists ? static_cast<double>(profile.heights[i]) / scale : 0.0;
    }
    AllLags<double> lags(heights, present, longest == 0 ? points - 1 : longest);
    StructureFunction<T> result;
    result.step.resize(lags.sum.size());
    result.lag.resize(lags.sum.size());
    if constexpr (std::is_same_v<T, double>)
        result.value = std::move(lags.sum);
    else
        result.value.assign(lags.sum.begin(), lags.sum.end());
    result.pairs = std::move(lags.pairs);
    std::size_t kept = 0;  // lags without enough pairs are left out in place
    for (std::size_t k = 0; k < result.pairs.size(); ++k) {
        const std::size_t pairs = result.pairs[k];
        const std::size_t count = divided_by(pairs, divisor);
        if (count == 0) continue;
        const T value = mean_square<T>(static_cast<double>(result.value[k]), static_cast<double>(count), scale);
        result.step[kept] = k + 1;
        result.lag[kept] = static_cast<T>(k + 1) * profile.spacing;
        result.value[kept] = value;
        result.pairs[kept] = pairs;
        ++kept;
    }
    result.step.resize(kept);
    result.lag.resize(kept);
    result.value.resize(kept);
    result.pairs.resize(kept);
    return result;
}

}}}  // namespace fstiff::detail
