// SPDX-License-Identifier: BSD-3-Clause
// Frequency with which D +- 1.96 errors covers the D of the generator of a self-affine profile, at every 1st to 16th of
// its points: whole, cut from one four times as long, or of a spectrum that turns flat.
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/catch.hpp"

namespace coverage_test {

using namespace fstiff;

namespace {

struct Covered {
    int inside = 0, fitted = 0;
    double scatter = 0, error = 0;
};

/// \p seeds profiles of 8192 points, cut from \p lengths as long, with every \p step th point kept; their
/// spectrum turns flat at \p longest [m], 0: nowhere, and lags below \p lambda_s [m] are left out.
Covered covered(double hurst, std::size_t step, std::size_t lengths, int seeds, double longest = 0,
                double lambda_s = 0) {
    Covered result;
    double sum = 0, square = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        constexpr std::size_t points = 8192;
        const auto whole = self_affine_profile<double>({.hurst = hurst,
                                                        .rms = 1e-6,
                                                        .longest_wavelength = longest,
                                                        .exact_rms = false,
                                                        .seed = static_cast<std::uint64_t>(seed)},
                                                       lengths * points, 1e-6);
        Profile<double> part{{}, 1e-6 * static_cast<double>(step)};
        for (std::size_t i = 0; i < points; i += step) part.heights.push_back(whole.heights[i]);
        try {
            const auto fit = fit_fractal(detail::level(part, Form::line), {.resamples = 60, .lambda_s = lambda_s});
            const double off = fit.fractal.dimension - (2 - hurst);
            ++result.fitted;
            result.inside += std::abs(off) < 1.96 * fit.dimension_error ? 1 : 0;
            result.error += fit.dimension_error;
            sum += off;
            square += off * off;
        } catch (const domain_error&) {  // a short one may hold no half decade
        }
    }
    const double count = result.fitted;
    result.error /= count;
    result.scatter = std::sqrt(square / count - sum / count * (sum / count));
    return result;
}

}  // namespace

TEST_CASE("The interval of 95 % covers D at every decimation of 40 self-affine profiles") {
    const double hurst = GENERATE(0.2, 0.5, 0.8);
    for (const std::size_t step : {1u, 4u, 16u}) {
        const Covered c = covered(hurst, step, 1, 40);
        CAPTURE(hurst, step, c.inside, c.fitted, c.scatter, c.error);
        CHECK(c.fitted >= 32);
        // of 32 and more at 95 % one in 200 such sets has a share below 85 %, and these seeds are always the same
        CHECK(c.inside >= 0.85 * c.fitted);
        CHECK(c.error < 2 * c.scatter);
    }
}

TEST_CASE("The interval of 95 % covers D of 200 self-affine profiles 90 % of the time and more", "[long]") {
    const double hurst = GENERATE(0.2, 0.5, 0.8);
    const std::size_t lengths = GENERATE(1u, 4u);
    for (const std::size_t step : {1u, 2u, 4u, 8u, 16u}) {
        const Covered c = covered(hurst, step, lengths, 200);
        WARN("H = " << hurst << ", every " << step << ". point, cut from " << lengths << " lengths: covered "
                    << 100.0 * c.inside / c.fitted << " % of " << c.fitted << ", scatter " << c.scatter << ", error "
                    << c.error);
        CHECK(c.inside >= 0.9 * c.fitted);
        CHECK(c.error < 2 * c.scatter);
    }
}

TEST_CASE("The interval of 95 % covers D 90 % of the time and more where the spectrum turns flat within the profile",
          "[long]") {
    struct Case {
        double longest, lambda_s;
        std::size_t steps;  // at most, that leave half a decade of lags before the bend
    };
    const double hurst = GENERATE(0.2, 0.5, 0.8);
    const auto [longest, lambda_s, steps] =
        GENERATE(Case{1024e-6, 0, 16}, Case{1024e-6, 40e-6, 16}, Case{256e-6, 0, 4}, Case{2731e-6, 20e-6, 16});
    for (std::size_t step = 1; step <= steps; step *= 4) {
        const Covered c = covered(hurst, step, 2, 200, longest, lambda_s);
        WARN("H = " << hurst << ", flat from " << longest << " m, lambda_s " << lambda_s << " m, every " << step
                    << ". point: covered " << 100.0 * c.inside / c.fitted << " % of " << c.fitted << ", scatter "
                    << c.scatter << ", error " << c.error);
        CHECK(c.inside >= 0.9 * c.fitted);
        CHECK(c.error < 2.5 * c.scatter);
    }
}

TEST_CASE("A spectrum that is flat at every lag that is left is refused") {
    CHECK(covered(0.5, 16, 2, 20, 256e-6).fitted == 0);
    CHECK(covered(0.8, 16, 2, 20, 256e-6).fitted == 0);
}

}  // namespace coverage_test
