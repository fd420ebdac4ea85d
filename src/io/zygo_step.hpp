// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Heights of Zygo MetroPro, which are counts of a step, in its binary form and in its text.
///
///     step = S O lambda / R,     R = 4096, 32768, 131072 by the phase resolution 0, 1, 2
///
/// S is the scale factor of the interferometer, O the obliquity factor, lambda the wavelength [m].
///
/// Units       m

#include "io/file_bytes.hpp"

namespace fstiff::inline v0_1::io::detail {

/// The step of the heights [m], whose factors are greater than 0. \throws domain_error for another \p resolution
inline double zygo_step(const std::string& name, double scale, double obliquity, double wavelength, double resolution) {
    if (resolution != 0 && resolution != 1 && resolution != 2)
        refuse_field(name, "phase resolution", number_text(resolution), "0, 1 or 2");
    return scale * obliquity * wavelength / (resolution == 0 ? 4096 : resolution == 1 ? 32768 : 131072);
}

/// The height of a \p count of steps [m]; NaN for a missing point.
inline double zygo_height(double count, double step) {
    return count >= 2147483640 ? std::numeric_limits<double>::quiet_NaN() : count * step;
}

/// Notes the \p step of the heights [m], which is negative where the file states that they are turned over.
inline void note_zygo_step(Record& record, double step) {
    record.note("units", "m, heights in steps of " + number_text(std::abs(step)) +
                             " m, from wavelength, scale factor and obliquity factor");
    if (step < 0)
        record.warnings.push_back("the file states that the sign of its heights is inverted; they were turned over");
    record.resolution = std::abs(step);
}

}  // namespace fstiff::inline v0_1::io::detail
