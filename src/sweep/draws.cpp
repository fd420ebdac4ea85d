// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/draws.hpp"

#include <cmath>

namespace fstiff::sweep {
namespace {

/// c[0] + c[1] x + ... by Horner's rule.
double polynomial(const std::array<double, 8>& c, double x) {
    double sum = c[7];
    for (std::size_t i = 7; i-- > 0;) sum = sum * x + c[i];
    return sum;
}

// The three pairs of polynomials of AS 241: near the median, in the tails, far out in the tails.
constexpr std::array<double, 8> near_above{3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3,
                                           1.3731693765509461125e4, 4.5921953931549871457e4, 6.7265770927008700853e4,
                                           3.3430575583588128105e4, 2.5090809287301226727e3};
constexpr std::array<double, 8> near_below{1,
                                           4.2313330701600911252e1,
                                           6.8718700749205790830e2,
                                           5.3941960214247511077e3,
                                           2.1213794301586595867e4,
                                           3.9307895800092710610e4,
                                           2.8729085735721942674e4,
                                           5.2264952788528545610e3};
constexpr std::array<double, 8> tail_above{
    1.42343711074968357734e0, 4.63033784615654529590e0,  5.76949722146069140550e0,  3.64784832476320460504e0,
    1.27045825245236838258e0, 2.41780725177450611770e-1, 2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr std::array<double, 8> tail_below{1,
                                           2.05319162663775882187e0,
                                           1.67638483018380384940e0,
                                           6.89767334985100004550e-1,
                                           1.48103976427480074590e-1,
                                           1.51986665636164571966e-2,
                                           5.47593808499534494600e-4,
                                           1.05075007164441684324e-9};
constexpr std::array<double, 8> far_above{
    6.65790464350110377720e0,  5.46378491116411436990e0,  1.78482653991729133580e0,  2.96560571828504891230e-1,
    2.65321895265761230930e-2, 1.24266094738807843860e-3, 2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr std::array<double, 8> far_below{1,
                                          5.99832206555887937690e-1,
                                          1.36929880922735805310e-1,
                                          1.48753612908506148525e-2,
                                          7.86869131145613259100e-4,
                                          1.84631831751005468180e-5,
                                          1.42151175831644588870e-7,
                                          2.04426310338993978564e-15};

}  // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t first = std::uint64_t(0xD2511F53) * counter[0];
        const std::uint64_t second = std::uint64_t(0xCD9E8D57) * counter[2];
        counter = {static_cast<std::uint32_t>(second >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(second),
                   static_cast<std::uint32_t>(first >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(first)};
        key = {key[0] + 0x9E3779B9U, key[1] + 0xBB67AE85U};
    }
    return counter;
}

double uniform_draw(std::uint64_t seed, std::uint64_t index, std::uint32_t input) {
    const auto x = philox({static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32), input, 0},
                          {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
    // 52 bits: a half more than 53 of them would be rounded, and could become 1
    const std::uint64_t bits = ((std::uint64_t(x[0]) << 32) | x[1]) >> 12;
    return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

double normal_quantile(double probability) {
    const double q = probability - 0.5;
    if (std::abs(q) <= 0.425) {
        const double r = 0.180625 - q * q;
        return q * polynomial(near_above, r) / polynomial(near_below, r);
    }
    const double r = std::sqrt(-std::log(q < 0 ? probability : 1 - probability));
    const double z = r <= 5 ? polynomial(tail_above, r - 1.6) / polynomial(tail_below, r - 1.6)
                            : polynomial(far_above, r - 5) / polynomial(far_below, r - 5);
    return q < 0 ? -z : z;
}

double Distribution::quantile(double probability) const {
    if (kind == Kind::uniform) return (1 - probability) * a + probability * b;
    const double z = normal_quantile(probability);
    return kind == Kind::normal ? a + b * z : a * std::exp(b * z);
}

}  // namespace fstiff::sweep
