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

namespace fstiff { inline namespace v0_1 { namespace math {

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

}}}  // namespace fstiff::math
