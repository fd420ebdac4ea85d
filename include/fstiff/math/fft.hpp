// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Discrete Fourier transforms, on the kissfft that comes with Eigen.
///
///     Z_k = sum over j of z_j exp(-2 pi i j k / M),  k = 0 ... M/2,  of z padded with zeros to M points
///     z_j = 1/M sum over all k of Z_k exp(2 pi i j k / M)               for real data the other half is the conjugate
///
/// Fastest where M is 2^a 3^b 5^c and a multiple of 4. A length with a prime factor above 50 is a convolution of
/// chirps, by transforms of a fast length of 2M or more, so that every length takes O(M log M).
///
/// Reference   Borgerding, kissfft (in Eigen, MPL2); Bluestein, IEEE Trans. Audio Electroacoust. 18 (1970) 451
/// Units       those of the data
/// Valid       M up to 2^30, 2^28 for a length with a large prime factor
/// Accuracy    rms error for 2^20 points 4e-16 of the rms in double, 2e-15 by chirps (tests/math/fft_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/lanes.hpp>

#include <numbers>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#endif
#include <unsupported/Eigen/FFT>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include <algorithm>
#include <complex>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace fstiff::inline v0_1::math {

/// The least multiple of 4 that has no prime factor above 5 and holds \p points. \throws domain_error beyond 2^30.
[[nodiscard]] inline std::size_t fast_fft_size(std::size_t points) {
    constexpr std::size_t largest = std::size_t{1} << 30;
    detail::require(points <= largest, "points", points, "at most 2^30");
    std::size_t best = largest;
    for (std::size_t fives = 1; fives < largest; fives *= 5)
        for (std::size_t odd = fives; odd < largest; odd *= 3) {
            std::size_t size = 4 * odd;
            while (size < points) size *= 2;
            best = (std::min)(best, size);
        }
    return best;
}

/// True if kissfft, which takes p^2 steps for a prime factor p, transforms \p size numbers quickly.
/// \throws domain_error for a size out of range.
[[nodiscard]] inline bool is_smooth_size(std::size_t size) {
    std::size_t rest = size;
    for (std::size_t p = 2; p <= 50 && rest > 1; ++p)
        while (rest % p == 0 && rest > 0) rest /= p;
    const std::size_t largest = std::size_t{1} << (rest == 1 ? 30 : 28);
    if (size == 0 || size > largest)
        detail::refuse("size of a transform", size, rest == 1 ? "from 1 to 2^30" : "from 1 to 2^28");
    return rest == 1 && size > 1;  // kissfft does not do one number
}

/// Transforms of complex data of one length; keeps its phases from call to call.
template <Real T = double>
class ComplexFft {
    using Complex = std::complex<T>;

public:
    /// \throws domain_error for 0 and beyond 2^30, 2^28 where \p size has a prime factor above 50.
    explicit ComplexFft(std::size_t size) : size_(size) {
        fft_.SetFlag(Eigen::FFT<T>::Unscaled);
        if (is_smooth_size(size)) return;
        chirp_.resize(size);  // exp(-pi i j^2/M)
        for (std::size_t j = 0; j < size; ++j)
            chirp_[j] =
                std::polar(T(1), -std::numbers::pi_v<T> * static_cast<T>(j * j % (2 * size)) / static_cast<T>(size));
        std::vector<Complex> wrapped(fast_fft_size(2 * size - 1));
        for (std::size_t j = 0; j < size; ++j)
            wrapped[j] = wrapped[j == 0 ? 0 : wrapped.size() - j] = std::conj(chirp_[j]) / T(wrapped.size());
        fft_.fwd(kernel_, wrapped);
    }

    /// sum over j of in_j exp(-2 pi i j k/M)
    void forward(const std::vector<Complex>& in, std::vector<Complex>& out) {
        if (chirp_.empty())
            fft_.fwd(out, in);
        else
            by_chirps(in, out, false);
    }
    /// sum over k of in_k exp(2 pi i j k/M): M times the inverse of forward().
    void backward(const std::vector<Complex>& in, std::vector<Complex>& out) {
        if (chirp_.empty())
            fft_.inv(out, in);
        else
            by_chirps(in, out, true);
    }

private:
    void by_chirps(const std::vector<Complex>& in, std::vector<Complex>& out, bool conjugate) {
        work_.assign(kernel_.size(), Complex(0));
        for (std::size_t j = 0; j < size_; ++j) work_[j] = (conjugate ? std::conj(in[j]) : in[j]) * chirp_[j];
        fft_.fwd(product_, work_);
        for (std::size_t k = 0; k < product_.size(); ++k) product_[k] *= kernel_[k];
        fft_.inv(work_, product_);
        out.resize(size_);
        for (std::size_t k = 0; k < size_; ++k) {
            out[k] = work_[k] * chirp_[k];
            if (conjugate) out[k] = std::conj(out[k]);
        }
    }

    std::size_t size_;
    Eigen::FFT<T> fft_;
    std::vector<Complex> chirp_, kernel_, work_, product_;  ///< empty where kissfft is fast
};

/// Transforms of real data of one length; keeps its phases from call to call.
template <Real T = double>
class RealFft {
public:
    /// \throws domain_error for 0 and beyond 2^30, 2^28 where \p size has a prime factor above 50.
    explicit RealFft(std::size_t size) : size_(size) {
        if (!is_smooth_size(size)) any_.emplace(size);
        fft_.SetFlag(Eigen::FFT<T>::HalfSpectrum);
    }

    /// M.
    [[nodiscard]] std::size_t size() const { return size_; }

    /// Z_0 ... Z_(M/2) of \p data, padded with zeros. \throws domain_error when there are more than M numbers.
    void forward(std::span<const T> data, std::vector<std::complex<T>>& spectrum) {
        if (data.size() > size_)
            detail::refuse("data of a transform", std::to_string(data.size()) + " numbers",
                           "at most " + std::to_string(size_));
        const T* source = data.data();
        if (data.size() < size_) {
            padded_.assign(size_, T(0));
            std::copy(data.begin(), data.end(), padded_.begin());
            source = padded_.data();
        }
        spectrum.resize(size_ / 2 + 1);
        if (any_) {
            in_.assign(source, source + size_);
            any_->forward(in_, out_);
            std::copy_n(out_.begin(), spectrum.size(), spectrum.begin());
            return;
        }
        fft_.fwd(spectrum.data(), source, static_cast<Eigen::Index>(size_));
    }

    /// z_0 ... z_(M-1). \throws domain_error unless the spectrum has M/2 + 1 numbers.
    void inverse(std::span<const std::complex<T>> spectrum, std::vector<T>& data) {
        if (spectrum.size() != size_ / 2 + 1)
            detail::refuse("spectrum", std::to_string(spectrum.size()) + " numbers", std::to_string(size_ / 2 + 1));
        data.resize(size_);
        if (any_) {
            in_.resize(size_);
            for (std::size_t k = 0; k <= size_ / 2; ++k) {
                in_[k] = spectrum[k];
                if (k > 0) in_[size_ - k] = std::conj(spectrum[k]);
            }
            any_->backward(in_, out_);
            for (std::size_t j = 0; j < size_; ++j) data[j] = out_[j].real() / static_cast<T>(size_);
            return;
        }
        fft_.inv(data.data(), spectrum.data(), static_cast<Eigen::Index>(size_));
    }

private:
    std::size_t size_;
    Eigen::FFT<T> fft_;
    std::vector<T> padded_;
    std::optional<ComplexFft<T>> any_;  ///< used if kissfft is slow
    std::vector<std::complex<T>> in_, out_;
};

}  // namespace fstiff::inline v0_1::math

// Discrete Fourier transforms of several lines at once, a line in each lane of the machine's vectors.
//
//     Z_k = sum over j of z_j exp(-2 pi i j k / M)        of each of `width` complex lines
//
// Stages of 4, 2 and odd factors that sort themselves (Stockham); the innermost loop shares one phase.
//
// Reference   Stockham, AFIPS Proc. 28 (1966) 229; odd factors: Singleton, IEEE Trans. Audio 17 (1969) 93
// Units       those of the data
// Valid       M from 2 to 2^30 without a prime factor above 50
// Accuracy    that of math/fft (tests/math/fft_of_lines_test.cpp)

namespace fstiff::inline v0_1::math {

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

}  // namespace fstiff::inline v0_1::math
