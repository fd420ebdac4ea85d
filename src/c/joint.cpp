// SPDX-License-Identifier: BSD-3-Clause
#include "c/joint.hpp"

#include "c/measure.hpp"

namespace fstiff::c {
namespace {

static_assert(FSTIFF_PROCESS_ERODED == static_cast<int>(Process::eroded));
static_assert(FSTIFF_INTERACTION_AS_PRINTED == static_cast<int>(InteractionReading::as_printed));

JointFace face_of(const fstiff_face* given, const char* name, bool with_band) {
    const fstiff_face from = taken(given, name);
    if (from.process < FSTIFF_PROCESS_UNKNOWN || from.process > FSTIFF_PROCESS_ERODED)
        refuse_argument("process", from.process, "one of FSTIFF_PROCESS_...");
    const fstiff_face_errors& errors = from.errors;
    JointFace face{.rms_height = known(from.rms_height),
                   .mean_height = known(from.mean_height),
                   .rms_gradient = known(from.rms_gradient),
                   .profile_gradient = known(from.profile_gradient),
                   .profile_spacing = known(from.profile_spacing),
                   .alpha = known(from.alpha),
                   .hurst = known(from.hurst),
                   .peak_radius = known(from.peak_radius),
                   .peak_density = known(from.peak_density),
                   .max_peak_height = known(from.max_peak_height),
                   .theta = known(from.theta),
                   .fractal_dimension = known(from.fractal_dimension),
                   .fractal_roughness = known(from.fractal_roughness),
                   .process = static_cast<Process>(from.process),
                   .errors = {.height = known(errors.height),
                              .gradient = known(errors.gradient),
                              .peak_radius = known(errors.peak_radius),
                              .peak_density = known(errors.peak_density),
                              .fractal_dimension = known(errors.fractal_dimension),
                              .r = known(errors.r),
                              .theta = known(errors.theta)}};
    if (face.theta) face.r = from.r;
    if (from.kurtosis == 0 && from.skewness != 0) throw domain_error("skewness: needs kurtosis");
    if (from.kurtosis != 0) face.skewness = from.skewness, face.kurtosis = from.kurtosis;
    if (!from.heights) return face;
    surface::MeasureOptions options = options_of(from.options);
    options.neighbours = with_band;
    const auto input = input_of(options.input, taken(from.heights, "heights"));
    face.measured = measured_face(measure_surface(options, input).found);
    return face;
}

Body body_of(const fstiff_solid& from) {
    return {.elastic = {from.youngs_modulus, from.poisson_ratio},
            .yield_strength = known(from.yield_strength),
            .hardness = known(from.hardness)};
}

}  // namespace

Joint joint_of(const fstiff_joint& from, bool with_band) {
    if (from.interaction < FSTIFF_NO_INTERACTION || from.interaction > FSTIFF_INTERACTION_AS_PRINTED)
        refuse_argument("interaction", from.interaction, "FSTIFF_NO_INTERACTION or one of the two readings");
    Joint joint{.face = face_of(from.face, "face", with_band),
                .upper = body_of(from.upper),
                .lower = body_of(from.lower),
                .effective_modulus = known(from.effective_modulus),
                .nominal_area = known(from.nominal_area),
                .interaction = {static_cast<InteractionReading>(from.interaction), from.interaction_length}};
    if (from.other) joint.other = face_of(from.other, "other", with_band);
    if (from.shifts != 0) joint.shifts = from.shifts;
    return joint;
}

}  // namespace fstiff::c
