// SPDX-License-Identifier: BSD-3-Clause
// Truth: the sum that defines the transform, in long double.
#include <fstiff/math/fft.hpp>
#include <fstiff/math/fft_of_lines.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <complex>
#include <random>
#include <vector>

namespace fft_of_lines_test {

using namespace fstiff;

TEMPLATE_TEST_CASE("Transforms of lines are the sums that define them, and back with both parts exchanged", "",
                   FSTIFF_SCALARS) {
    using T = TestType;
    using Lines = math::FftOfLines<T>;
    constexpr std::size_t width = Lines::width;
    // phases of long double are its own
    const auto epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
    const std::size_t size = GENERATE(2u, 3u, 4u, 5u, 6u, 8u, 12u, 30u, 49u, 60u, 94u, 128u, 250u);
    std::mt19937 random(1);
    std::vector<T> re(width * size), im(re);
    for (auto* part : {&re, &im})
        for (T& z : *part) z = static_cast<T>(random()) / static_cast<T>(4294967296.0L) - T(0.3);
    std::vector<T> to_re = re, to_im = im;
    Lines fft(size);
    fft.transform(to_re.data(), to_im.data());
    CAPTURE(size);
    for (std::size_t line = 0; line < width; ++line)
        for (std::size_t k = 0; k < size; ++k) {
            std::complex<long double> sum = 0;
            for (std::size_t j = 0; j < size; ++j)
                sum += std::complex<long double>(re[j * width + line], im[j * width + line]) *
                       std::polar(1.0L, -2 * std::acos(-1.0L) * static_cast<long double>(j * k % size) /
                                            static_cast<long double>(size));
            const std::complex<long double> found(to_re[k * width + line], to_im[k * width + line]);
            // the rms of a transform is sqrt(M) 0.5; a stage rounds to epsilon of it, a factor p to p/2 epsilon
            CHECK(std::abs(found - sum) < 20 * epsilon * std::sqrt(static_cast<double>(size)));
        }
    fft.transform(to_im.data(), to_re.data());
    double off = 0;
    for (std::size_t i = 0; i < re.size(); ++i)
        off = std::max({off, std::abs(static_cast<double>(to_re[i] / static_cast<T>(size) - re[i])),
                        std::abs(static_cast<double>(to_im[i] / static_cast<T>(size) - im[i]))});
    CHECK(off < 20 * epsilon);
}

}  // namespace fft_of_lines_test
