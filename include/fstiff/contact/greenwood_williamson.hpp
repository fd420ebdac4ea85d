// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The contact of Greenwood and Williamson: Hertzian peaks of one radius R, their heights Gaussian or exponential.
///
///     p = (4/3) E D_p sigma^(3/2) R^(1/2) G_{3/2}(h)       K = 2 E D_p sigma^(1/2) R^(1/2) G_{1/2}(h)
///     A = pi R sigma D_p G_1(h)                            n = D_p G_0(h)
///
/// all per nominal area; h is the separation over sigma, G_n as in peaks/peak_distribution.hpp.
///
/// Reference   Greenwood, Williamson, Proc. R. Soc. Lond. A 295 (1966) 300-319.
/// Units       SI
/// Valid       separations from -1000 to 1e6 rms heights; pressures as for RoughContact
/// Accuracy    moments 16 epsilon (tests/contact/greenwood_williamson_test.cpp)

#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/peaks/single_radius.hpp>

namespace fstiff { inline namespace v0_1 {

/// Contact of spherical peaks of equal radius with Hertz's law: RoughContact with SingleRadius.
template <Real T = double>
struct GreenwoodWilliamson : RoughContact<T, HertzLaw<T>, SingleRadius<T>> {
    /// \throws domain_error naming the parameter that is out of range.
    GreenwoodWilliamson(const Roughness<T>& surface, std::type_identity_t<T> effective_modulus,
                        Heights heights = Heights::gaussian, const RoughContactOptions<T>& options = {})
        : RoughContact<T, HertzLaw<T>, SingleRadius<T>>(surface, SingleRadius<T>{heights}, HertzLaw<T>{},
                                                        effective_modulus, options) {}
    /// The same of peaks of other heights.
    GreenwoodWilliamson(const Roughness<T>& surface, std::type_identity_t<T> effective_modulus, PeakHeights<T> heights,
                        const RoughContactOptions<T>& options = {})
        : RoughContact<T, HertzLaw<T>, SingleRadius<T>>(
              surface, SingleRadius<T>{{}, std::make_shared<const PeakHeights<T>>(std::move(heights))}, HertzLaw<T>{},
              effective_modulus, options) {}
};

}}  // namespace fstiff
