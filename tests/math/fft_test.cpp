// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/fft.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <random>

namespace fft_test {

using namespace fstiff;

TEMPLATE_TEST_CASE("A transform is the sum that defines it, and its inverse gives the data back", "", FSTIFF_SCALARS) {
    using T = TestType;
    const T epsilon = std::numeric_limits<T>::epsilon();
    const std::size_t size = GENERATE(2u, 3u, 4u, 7u, 8u, 12u, 53u, 60u, 97u, 100u, 106u, 1009u, 1024u);
    std::mt19937 random(1);
    std::vector<T> data(size - 1);  // one zero is padded
    T norm = 0;
    for (T& z : data) {
        z = static_cast<T>(random()) / static_cast<T>(4294967296.0L) - T(0.3);
        norm += z * z;
    }
    math::RealFft<T> fft(size);
    std::vector<std::complex<T>> spectrum;
    fft.forward(data, spectrum);
    REQUIRE(spectrum.size() == size / 2 + 1);
    for (std::size_t k = 0; k < spectrum.size(); ++k) {
        std::complex<long double> sum = 0;
        for (std::size_t j = 0; j < data.size(); ++j)
            sum += static_cast<long double>(data[j]) *
                   std::polar(1.0L, -2 * std::acos(-1.0L) * static_cast<long double>(j * k % size) /
                                        static_cast<long double>(size));
        const std::complex<T> truth(static_cast<T>(sum.real()), static_cast<T>(sum.imag()));
        CAPTURE(size, k);
        // every stage (at most 10) rounds to epsilon of the norm; the factor is loose by ten
        CHECK(std::abs(spectrum[k] - truth) < 10 * epsilon * std::sqrt(norm * static_cast<T>(size)));
    }
    std::vector<T> back;
    fft.inverse(spectrum, back);
    REQUIRE(back.size() == size);
    for (std::size_t j = 0; j < size; ++j)
        CHECK(std::abs(back[j] - (j < data.size() ? data[j] : T(0))) < 10 * epsilon * std::sqrt(norm));
}

TEST_CASE("A transform of 2^20 points has an rms error of 4e-16 of its rms") {
    // a chirp-like set of 5 waves, whose transform is known: z = sum of a cos(2 pi (m j / M) + phase)
    const std::size_t size = 1u << 20;
    const std::size_t waves[]{1, 77, 4099, 131071, 500003};
    const double phases[]{0.1, 1.2, 2.3, 3.4, 4.5};
    std::vector<double> data(size);
    for (std::size_t j = 0; j < size; ++j) {
        long double z = 0;
        for (int w = 0; w < 5; ++w)
            z += std::cos(2 * std::acos(-1.0L) * static_cast<long double>(waves[w] * j % size) /
                              static_cast<long double>(size) +
                          static_cast<long double>(phases[w]));
        data[j] = static_cast<double>(z);
    }
    math::RealFft<double> fft(size);
    std::vector<std::complex<double>> spectrum;
    fft.forward(data, spectrum);
    double error = 0, square = 0;
    for (std::size_t k = 0; k < spectrum.size(); ++k) {
        std::complex<double> truth = 0;
        for (int w = 0; w < 5; ++w)
            if (k == waves[w]) truth = std::polar(static_cast<double>(size) / 2, phases[w]);
        error += std::norm(spectrum[k] - truth);
        square += std::norm(truth);
    }
    const double relative = std::sqrt(error / square);
    CAPTURE(relative);
    CHECK(relative < 4e-16);
}

TEST_CASE("A fast size has only the factors 2, 3 and 5, is a multiple of 4, and none smaller would do") {
    const auto fast = [](std::size_t n) {
        if (n % 4 != 0) return false;
        for (const std::size_t p : {2u, 3u, 5u})
            while (n % p == 0) n /= p;
        return n == 1;
    };
    for (std::size_t n = 1; n < 3000; ++n) {
        const std::size_t size = math::fast_fft_size(n);
        REQUIRE(size >= n);
        REQUIRE(fast(size));
        for (std::size_t k = n; k < size; ++k) REQUIRE_FALSE(fast(k));
    }
    CHECK(math::fast_fft_size(0) == 4);
    CHECK(math::fast_fft_size(1000000) == 1000000);
    CHECK(math::fast_fft_size(std::size_t{1} << 30) == std::size_t{1} << 30);
    CHECK(test::refusal([] { (void)math::fast_fft_size((std::size_t{1} << 30) + 1); }).find("at most 2^30") !=
          std::string::npos);
}

TEST_CASE("Lengths that do not fit a transform are refused") {
    for (const std::size_t size : {std::size_t{0}, (std::size_t{1} << 28) + 3, (std::size_t{1} << 30) + 1}) {
        CHECK(test::refusal([&] { (void)math::RealFft<double>(size); }).find("size of a transform") == 0);
        CHECK(test::refusal([&] { (void)math::ComplexFft<double>(size); }).find("size of a transform") == 0);
    }
    math::RealFft<double> fft(8);
    std::vector<std::complex<double>> spectrum(4);
    std::vector<double> data(9);
    CHECK_FALSE(test::refusal([&] { fft.forward(data, spectrum); }).empty());
    CHECK_FALSE(test::refusal([&] { fft.inverse(spectrum, data); }).empty());
}

}  // namespace fft_test
