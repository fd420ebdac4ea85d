// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Discrete Fourier transform of real data, on the kissfft that comes with Eigen.
///
///     Z_k = sum over j of z_j exp(-2 pi i j k / M),  k = 0 ... M/2,  of z padded with zeros to M points
///     z_j = 1/M sum over all k of Z_k exp(2 pi i j k / M)                           the other half is the conjugate
///
/// M is 2^a 3^b 5^c and a multiple of 4, so that no length is slow.
///
/// Reference   Borgerding, kissfft (in Eigen/unsupported, MPL2).
/// Units       those of the data
/// Valid       M up to 2^30
/// Accuracy    rms error of a transform of 2^20 points 4e-16 of its rms in double; long double is no better than
///             double, because Eigen makes its phases in double (tests/math/fft_test.cpp)

#include <fstiff/core/error.hpp>

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
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace fstiff {

/// The least multiple of 4 that has no prime factor above 5 and holds \p points.
/// \throws domain_error beyond 2^30.
[[nodiscard]] inline std::size_t fast_fft_size(std::size_t points);

/// Transforms of one length; keeps its phases from call to call.
template <Real T = double>
class RealFft {
public:
    /// \throws domain_error unless \p size is a fast_fft_size.
    explicit RealFft(std::size_t size);

    /// M.
    [[nodiscard]] std::size_t size() const { return size_; }

    /// Z_0 ... Z_(M/2) of \p data, padded with zeros. \throws domain_error when there are more than M numbers.
    void forward(std::span<const T> data, std::vector<std::complex<T>>& spectrum);

    /// z_0 ... z_(M-1). \throws domain_error unless the spectrum has M/2 + 1 numbers.
    void inverse(std::span<const std::complex<T>> spectrum, std::vector<T>& data);

private:
    std::size_t size_;
    Eigen::FFT<T> fft_;
    std::vector<T> padded_;
};

inline std::size_t fast_fft_size(std::size_t points) {
    constexpr std::size_t largest = std::size_t{1} << 30;
    require(points <= largest, "points", points, "at most 2^30");
    std::size_t best = largest;
    for (std::size_t fives = 1; fives < largest; fives *= 5)
        for (std::size_t odd = fives; odd < largest; odd *= 3) {
            std::size_t size = 4 * odd;
            while (size < points) size *= 2;
            best = std::min(best, size);
        }
    return best;
}

template <Real T>
RealFft<T>::RealFft(std::size_t size) : size_(size) {
    require(size != 0 && fast_fft_size(size) == size, "size of a transform", size,
            "a multiple of 4 up to 2^30 without prime factors above 5");
    fft_.SetFlag(Eigen::FFT<T>::HalfSpectrum);
}

template <Real T>
void RealFft<T>::forward(std::span<const T> data, std::vector<std::complex<T>>& spectrum) {
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
    fft_.fwd(spectrum.data(), source, static_cast<Eigen::Index>(size_));
}

template <Real T>
void RealFft<T>::inverse(std::span<const std::complex<T>> spectrum, std::vector<T>& data) {
    if (spectrum.size() != size_ / 2 + 1)
        detail::refuse("spectrum", std::to_string(spectrum.size()) + " numbers", std::to_string(size_ / 2 + 1));
    data.resize(size_);
    fft_.inv(data.data(), spectrum.data(), static_cast<Eigen::Index>(size_));
}

}  // namespace fstiff
