// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Discrete Fourier transforms of several lines at once, a line in each lane of the machine's vectors.
///
///     Z_k = sum over j of z_j exp(-2 pi i j k / M)        of each of `width` complex lines
///
/// Stages of 4, 2 and odd factors that sort themselves (Stockham); the innermost loop shares one phase.
///
/// Reference   Stockham, AFIPS Proc. 28 (1966) 229; odd factors: Singleton, IEEE Trans. Audio 17 (1969) 93
/// Units       those of the data
/// Valid       M from 2 to 2^30 without a prime factor above 50
/// Accuracy    that of math/fft (tests/math/fft_of_lines_test.cpp)

#include <fstiff/math/fft.hpp>

#include <algorithm>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace math {

/// Transforms of `width` complex lines of one length; keeps its phases and its working space.
template <Real T>
class FftOfLines {
public:
    static constexpr std::size_t width = sizeof(T) <= 4 ? 8 : 4;

    /// \throws domain_error unless is_smooth_size(size) is true.
    explicit FftOfLines(std::size_t size) : size_(size), re_(width * size), im_(re_) {
        std::size_t rest = size;
        const auto take = [&](std::size_t factor) {
            for (; rest % factor == 0 && rest > 1; rest /= factor) stages_.push_back(Stage(factor, rest));
        };
        take(4);
        take(2);
        for (std::size_t factor = 3; factor <= largest_factor; factor += 2) take(factor);
    }

    [[nodiscard]] std::size_t size() const { return size_; }

    /// Number j of line l is \p re[j width + l] + i \p im[j width + l], before and after. With \p re and \p im
    /// exchanged it is the transform with the other sign: M times the inverse.
    void transform(T* re, T* im) {
        Planes from{re, im}, to{re_.data(), im_.data()};
        std::size_t run = width;
        for (const Stage& stage : stages_) {
            if (stage.factor == 4)
                by_four(stage, run, from, to);
            else if (stage.factor == 2)
                by_two(stage, run, from, to);
            else
                by_odd(stage, run, from, to);
            run *= stage.factor;
            std::swap(from, to);
        }
        if (from.re == re) return;
        std::copy_n(from.re, width * size_, re);
        std::copy_n(from.im, width * size_, im);
    }

private:
    static constexpr std::size_t largest_factor = 49;
    static constexpr int lanes = (std::min)(int(width), int(Eigen::internal::packet_traits<T>::size));
    using V = Lanes<T, lanes>;

    struct Planes {
        T *re, *im;
    };
    struct Complex {
        V re, im;

        EIGEN_ALWAYS_INLINE friend Complex operator+(const Complex& a, const Complex& b) {
            return {a.re + b.re, a.im + b.im};
        }
        EIGEN_ALWAYS_INLINE friend Complex operator-(const Complex& a, const Complex& b) {
            return {a.re - b.re, a.im - b.im};
        }
        EIGEN_ALWAYS_INLINE friend Complex operator*(const Complex& a, const std::complex<T>& b) {
            const V c = V::all(b.real()), s = V::all(b.imag());
            return {a.re * c - a.im * s, a.re * s + a.im * c};
        }
        EIGEN_ALWAYS_INLINE static Complex load(const Planes& from, std::size_t offset) {
            return {V::load(from.re + offset), V::load(from.im + offset)};
        }
        EIGEN_ALWAYS_INLINE void store(const Planes& to, std::size_t offset) const {
            re.store(to.re + offset);
            im.store(to.im + offset);
        }
    };

    /// M' = `factor` `parts` points become `factor` sets of `parts`.
    struct Stage {
        std::size_t factor, parts;
        std::vector<std::complex<T>> phase;  ///< exp(-2 pi i q k/M') at q (factor - 1) + k - 1
        std::vector<std::complex<T>> root;   ///< exp(-2 pi i k/factor)

        Stage(std::size_t radix, std::size_t points) : factor(radix), parts(points / radix) {
            for (std::size_t q = 0; q < parts; ++q)
                for (std::size_t k = 1; k < factor; ++k) phase.push_back(turn(q * k, points));
            for (std::size_t k = 0; k < factor; ++k) root.push_back(turn(k, factor));
        }
        [[nodiscard]] static std::complex<T> turn(std::size_t part, std::size_t points) {
            return std::polar(T(1), -2 * std::numbers::pi_v<T> * T(part) / T(points));
        }
    };

    static void by_four(const Stage& stage, std::size_t run, const Planes& from, const Planes& to) {
        const std::size_t apart = run * stage.parts;
        for (std::size_t q = 0; q < stage.parts; ++q) {
            const std::complex<T>* const phase = &stage.phase[3 * q];
            for (std::size_t in = q * run, out = 4 * q * run; in < (q + 1) * run; in += lanes, out += lanes) {
                const Complex a = Complex::load(from, in), b = Complex::load(from, in + apart);
                const Complex c = Complex::load(from, in + 2 * apart), d = Complex::load(from, in + 3 * apart);
                const Complex even = a + c, odd = b + d, across = a - c, turned{b.im - d.im, d.re - b.re};
                (even + odd).store(to, out);
                ((across + turned) * phase[0]).store(to, out + run);
                ((even - odd) * phase[1]).store(to, out + 2 * run);
                ((across - turned) * phase[2]).store(to, out + 3 * run);
            }
        }
    }

    static void by_two(const Stage& stage, std::size_t run, const Planes& from, const Planes& to) {
        const std::size_t apart = run * stage.parts;
        for (std::size_t q = 0; q < stage.parts; ++q)
            for (std::size_t in = q * run, out = 2 * q * run; in < (q + 1) * run; in += lanes, out += lanes) {
                const Complex a = Complex::load(from, in), b = Complex::load(from, in + apart);
                (a + b).store(to, out);
                ((a - b) * stage.phase[q]).store(to, out + run);
            }
    }

    /// Z_k and Z_(p-k) are sum +- i difference, of the cosines of z_j + z_(p-j) and the sines of z_j - z_(p-j).
    static void by_odd(const Stage& stage, std::size_t run, const Planes& from, const Planes& to) {
        const std::size_t p = stage.factor, half = p / 2, apart = run * stage.parts;
        std::array<Complex, largest_factor / 2 + 1> plus, minus;
        for (std::size_t q = 0; q < stage.parts; ++q)
            for (std::size_t in = q * run, out = p * q * run; in < (q + 1) * run; in += lanes, out += lanes) {
                const Complex first = Complex::load(from, in);
                Complex total = first;
                for (std::size_t j = 1; j <= half; ++j) {
                    const Complex a = Complex::load(from, in + j * apart);
                    const Complex b = Complex::load(from, in + (p - j) * apart);
                    plus[j] = a + b;
                    minus[j] = a - b;
                    total = total + plus[j];
                }
                total.store(to, out);
                for (std::size_t k = 1; k <= half; ++k) {
                    Complex sum = first, difference{V::all(0), V::all(0)};
                    for (std::size_t j = 1; j <= half; ++j) {
                        const std::complex<T>& root = stage.root[j * k % p];
                        const V c = V::all(root.real()), s = V::all(root.imag());
                        sum = sum + Complex{plus[j].re * c, plus[j].im * c};
                        difference = difference + Complex{minus[j].im * s, minus[j].re * s};
                    }
                    const std::complex<T>* const phase = &stage.phase[q * (p - 1)];
                    const Complex turned{V::all(0) - difference.re, difference.im};
                    ((sum + turned) * phase[k - 1]).store(to, out + k * run);
                    ((sum - turned) * phase[p - k - 1]).store(to, out + (p - k) * run);
                }
            }
    }

    std::size_t size_;
    std::vector<Stage> stages_;
    std::vector<T> re_, im_;
};

}}}  // namespace fstiff::math
