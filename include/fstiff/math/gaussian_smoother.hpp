// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Weighted sums of equally spaced numbers with the weights of the Gaussian filter, not normalised.
///
///     y_i = sum_k s(i-k) z_k,   s(n) = exp(-pi (n/(a w))^2),  a = sqrt(ln 2/pi) = 0.4697         w: cut-off in samples
///
/// Reference   ISO 16610-21:2011, 4.2 (weights)
/// Units       the numbers': any; w in samples
/// Valid       w > 0, as many numbers as were announced
/// Accuracy    1e-15 of the largest number times w (tests/math/gaussian_smoother_test.cpp); weights below 1e-17 are 0

#include <fstiff/math/fft.hpp>
#include <fstiff/math/fft_of_lines.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace math {

/// The sums above for data of one size; keeps the transform of the weights from call to call.
template <Real T = double>
class GaussianSmoother {
public:
    /// \throws domain_error unless there are numbers and the \p width, in samples, is positive.
    GaussianSmoother(std::size_t size, T width) : size_(size), fft_(fast_fft_size(size + reach(size, width))) {
        const auto weight = [&](std::size_t k) {
            const T x = static_cast<T>(k) / width;
            return std::exp(-std::numbers::pi_v<T> * std::numbers::pi_v<T> / std::numbers::ln2_v<T> * x * x);
        };
        std::vector<T> kernel(fft_.size());
        kernel[0] = weight(0);
        for (std::size_t k = 1; k <= reach(size, width); ++k) kernel[k] = kernel[fft_.size() - k] = weight(k);
        fft_.forward(kernel, shape_);
    }

    /// Replaces the numbers by their sums. \throws domain_error unless there are as many as were announced.
    void operator()(std::vector<T>& data) {
        detail::require(data.size() == size_, "numbers to smooth", static_cast<T>(data.size()),
                        "as many as were announced");
        fft_.forward(data, spectrum_);
        for (std::size_t k = 0; k < spectrum_.size(); ++k) spectrum_[k] *= shape_[k].real();  // the kernel is even
        fft_.inverse(spectrum_, data);
        data.resize(size_);
    }

    /// The most lines that are smoothed at once: two to each lane of a vector, the real and the imaginary part of one
    /// transform, which the weights leave apart since theirs is real.
    static constexpr std::size_t lines = 2 * FftOfLines<T>::width;
    /// The same for \p count lines; number i of line l is \p data[i step + l jump].
    void of_lines(T* data, std::size_t step, std::size_t jump, std::size_t count) {
        constexpr std::size_t width = lines / 2;
        const std::size_t size = fft_.size();
        if (!together_) together_.emplace(size);
        re_.assign(size * width, T(0));
        im_.assign(size * width, T(0));
        const auto part = [&](std::size_t l) { return l < width ? re_.data() + l : im_.data() + (l - width); };
        for (std::size_t l = 0; l < count; ++l)
            for (std::size_t i = 0; i < size_; ++i) part(l)[i * width] = data[i * step + l * jump];
        together_->transform(re_.data(), im_.data());
        for (std::size_t k = 0; k < size; ++k) {
            const T share = shape_[(std::min)(k, size - k)].real() / static_cast<T>(size);
            for (std::size_t l = k * width; l < (k + 1) * width; ++l) re_[l] *= share, im_[l] *= share;
        }
        together_->transform(im_.data(), re_.data());
        for (std::size_t l = 0; l < count; ++l)
            for (std::size_t i = 0; i < size_; ++i) data[i * step + l * jump] = part(l)[i * width];
    }

private:
    /// Reach of the weights, to 1e-17.
    static std::size_t reach(std::size_t size, T width) {
        detail::require_positive("numbers to smooth", static_cast<T>(size));
        detail::require_positive("width", width);
        // before the conversion to a whole number, whose range a huge width would leave
        return T(1.66) * width >= static_cast<T>(size - 1)
                   ? size - 1
                   : (std::min)(size - 1, static_cast<std::size_t>(T(1.66) * width) + 1);
    }

    std::size_t size_;
    RealFft<T> fft_;
    std::vector<std::complex<T>> shape_, spectrum_;
    std::optional<FftOfLines<T>> together_;
    std::vector<T> re_, im_;
};

}}}  // namespace fstiff::math
