// SPDX-License-Identifier: BSD-3-Clause
#include "c/joint.hpp"

#include "c/measure.hpp"
#include "request/put_number.hpp"

#include <cmath>
#include <string>
#include <string_view>

namespace fstiff::c {
namespace {

static_assert(FSTIFF_PROCESS_SUPERFINISHED == static_cast<int>(Process::superfinished));
static_assert(FSTIFF_INTERACTION_AS_PRINTED == static_cast<int>(InteractionReading::as_printed));

JointFace face_of(const fstiff_face* given, const char* name, bool with_band) {
    const fstiff_face from = taken(given, name);
    if (from.process < FSTIFF_PROCESS_UNKNOWN || from.process > FSTIFF_PROCESS_SUPERFINISHED)
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

/// Puts \p value into the number of \p joint at \p path, such as "face.alpha". Waves, friction, the filling of the gap
/// and the other face begin to be there with a number. \return whether there is such a number.
bool take_number_at(Joint& joint, std::string_view path, double value) {
    const std::size_t dot = path.rfind('.');
    const auto take = [value](auto& of, std::string_view name) {
        return request::put_number(of, name, value).has_value();
    };
    if (dot == path.npos) return take(joint, path);
    const std::string_view owner = path.substr(0, dot), name = path.substr(dot + 1);
    const auto take_of_face = [&](JointFace& face) {
        return take(face, name) || request::put_flag(face, name, value != 0);
    };
    const auto begun = [](auto& part) -> auto& { return part ? *part : part.emplace(); };
    if (owner == "face") return take_of_face(joint.face);
    if (owner == "other") return take_of_face(begun(joint.other));
    if (owner == "upper") return take(joint.upper, name);
    if (owner == "lower") return take(joint.lower, name);
    if (owner == "waves") return take(begun(joint.waves), name);
    if (owner == "waves.longitudinal") return take(begun(joint.waves).longitudinal, name);
    if (owner == "waves.shear") return take(begun(begun(joint.waves).shear), name);
    if (owner == "friction") return take(begun(joint.friction), name);
    if (owner == "interaction") return take(joint.interaction, name);
    if (owner == "conduction.gap") return take(begun(joint.conduction.gap), name);
    return owner == "conduction" && take(joint.conduction, name);
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
    for (std::size_t i = 0; i < from.number_count; ++i) {
        (void)not_null(from.names, "names"), (void)not_null(from.names[i], "names"),
            (void)not_null(from.numbers, "numbers");
        const std::string_view name = from.names[i];
        const double value = from.numbers[i];
        if (!std::isnan(value) && !take_number_at(joint, name, value))
            throw domain_error("names: \"" + std::string(name.substr(0, 60)) +
                               "\" must be the name of a number of a joint, such as \"face.alpha\", or "
                               "\"lower.density\" (docs/linking-c.md)");
    }
    return joint;
}

}  // namespace fstiff::c
