// SPDX-License-Identifier: BSD-3-Clause
// Reference of interface_test.c: numbers of the C++ library, made without the C interface and without scenes but
// for one. Prints "key count values..." in hexadecimal; the second argument names the file of a tabulated law.
#include <fstiff/answer.hpp>
#include <fstiff/answer/laws.hpp>
#include <fstiff/asperity/material.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/measure/measure.hpp>
#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/tangential_law.hpp>
#include <fstiff/topography/form.hpp>

#include "actions/answered.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <vector>

namespace {

using namespace fstiff;

std::FILE* out;

void print(const char* key, const std::vector<double>& values) {
    std::fprintf(out, "%s %zu", key, values.size());
    for (const double value : values) std::fprintf(out, " %a", value);
    std::fprintf(out, "\n");
}

std::vector<double> numbers_of(const ContactState<double>& s) {
    return {s.pressure.value,          s.separation.value,         s.stiffness.value,      s.stiffness.error,
            s.loading_stiffness.value, s.real_area_fraction.value, s.contact_density.value};
}

template <class Contact>
void print_states(const std::string& key, const Contact& contact, const std::vector<double>& pressures) {
    for (std::size_t i = 0; i < pressures.size(); ++i) {
        const auto at = contact.at_pressure(pressures[i]);
        print((key + "/p" + std::to_string(i)).c_str(), numbers_of(at));
        print((key + "/d" + std::to_string(i)).c_str(), numbers_of(contact.at_separation(at.separation.value)));
    }
}

std::vector<double> numbers_of(const SurfaceParameters<double>& found) {
    std::vector<double> all;
    for (const auto* one : {&found.rms_height, &found.peak_radius, &found.peak_density})
        all.insert(all.end(), {one->value, one->error});
    for (const auto* one : {&found.fractal_dimension, &found.fractal_roughness, &found.r, &found.theta}) {
        const auto value = one->value_or(Measurement<double>{0, 0});
        all.insert(all.end(), {value.value, value.error});
    }
    return all;
}

/// All numbers that fstiff_surface has of what measure() finds.
void print_surface(const char* key, const Surface<double>& found) {
    std::vector<double> all = numbers_of(found);
    for (const auto& one :
         {found.rms_gradient, found.heights->skewness, found.heights->kurtosis, found.max_peak_height})
        all.insert(all.end(), {one.value, one.error});
    all.insert(all.end(), {found.cut_offs.lambda_s.value_or(0), found.cut_offs.lambda_c.value_or(0),
                           static_cast<double>(found.peaks_counted)});
    print(key, all);
}

/// A path of closing, opening and turning: of each step d and s, p, q, the tangent, and what is remembered and stored.
void print_friction(const ContactLaw<double>& law) {
    const double ratio = tangential_ratio<double>({205e9, 0.3}, {70e9, 0.33}), d = law.separation(1e7);
    const TangentialLaw<double> rough(law, 0.3, ratio);
    const auto first = rough.first_slip(d, 1e-7);
    const auto cycle = rough.cycle(d, 1e-7);
    print("friction",
          {ratio, d, first.traction, first.stiffness, cycle.lost, cycle.loss_factor, law.energy(d), law.touch()});
    SlipState<double, 2> state{.separation = d};
    for (int i = 0; i < 40; ++i) {
        const Eigen::Vector2d slip(2e-7 * std::sin(3 * i), i < 10 ? 0 : 1e-7 * std::cos(5 * i));
        const double to = law.separation(1e7 * (1.5 + std::sin(i)));
        const auto at = rough.step(state, to, slip, state);
        std::vector<double> all{to, slip[0], slip[1], at.pressure, at.traction[0], at.traction[1]};
        for (int j = 0; j < 9; ++j) all.push_back(at.tangent(j / 3, j % 3));
        all.insert(all.end(), {rough.stored_energy(state), double(state.count)});
        for (int j = 0; j < state.count; ++j) {
            const auto& node = state.nodes[static_cast<std::size_t>(j)];
            all.insert(all.end(), {node.level, node.drag[0], node.drag[1]});
        }
        print(("friction/" + std::to_string(i)).c_str(), all);
    }
}

/// The law of an answer at its three quantiles, between the pressures of the joint and twice as far in.
void print_law_of_answer() {
    const Body steel{.elastic = {210e9, 0.3}, .hardness = 2e9};
    const Joint joint{.face = {.rms_height = 1e-6, .rms_gradient = 0.1}, .upper = steel, .lower = steel};
    std::vector<double> pressures;
    for (int i = 0; i <= 20; ++i) pressures.push_back(1e6 * std::pow(10, i / 10.0));
    print("answer/pressures", pressures);
    const Answer found = answer(joint, pressures);
    std::vector<double> all;
    for (const double quantile : {0.05, 0.5, 0.95}) {
        const auto law = found.law_at(quantile, {pressures.front(), pressures.back(), OutsideRange::extrapolate});
        for (const double p : pressures)
            all.insert(all.end(), {law.separation(p), law.stiffness(p), law.slope_at_separation(law.separation(p))});
    }
    print("answer/laws", all);
    std::vector<double> after;
    for (const double greatest : {0.0, 2e7}) {
        const LawRange<double> range{pressures.front(), pressures.back(), OutsideRange::extrapolate};
        const auto law = greatest == 0 ? found.loading_law(0.5, range) : found.law_after(greatest, 0.5, range);
        for (const double p : pressures)
            after.insert(after.end(),
                         {law.separation(p), law.stiffness(p), law.slope_at_separation(law.separation(p))});
    }
    print("answer/laws_after", after);
}

/// K by each law of a joint of numbers, or by those that need one of a joint of heights.
void print_laws(const HeightMap<double>& map, const std::vector<double>& pressures) {
    const Body steel{.elastic = {205e9, 0.3}, .yield_strength = 0.7e9, .hardness = 2e9};
    const Joint joint{.face = {.rms_height = 0.832e-6,
                               .rms_gradient = 0.1,
                               .peak_radius = 40e-6,
                               .peak_density = 500e6,
                               .max_peak_height = 5.3e-6,
                               .r = 0.5,
                               .theta = 1.0,
                               .fractal_dimension = 1.62},
                      .upper = steel,
                      .lower = steel};
    for (const ChosenLaw& law : detail::all_laws()) {
        std::vector<double> stiffness, some = pressures;
        try {
            for (const auto& point : contact_of(joint, law)->at_pressures(some, Quantity::stiffness))
                stiffness.push_back(point.ok() ? point.state.stiffness.value : 0);
        } catch (const domain_error&) {
            Joint of_map = joint;
            of_map.face = {.measured = measured_face(measure(map))};
            some.resize(2);
            for (const auto& point : contact_of(of_map, law)->at_pressures(some, Quantity::stiffness))
                stiffness.push_back(point.ok() ? point.state.stiffness.value : 0);
        }
        print(("law/" + std::string(law.row().name)).c_str(), stiffness);
    }
}

}  // namespace

int main(int, char** argv) {
    out = std::fopen(argv[1], "w");
    if (!out) return 1;
    const std::vector<double> pressures{1e5, 3e5, 1e6, 3e6, 1e7, 3e7, 1e8};
    print("pressures", pressures);
    const Roughness<double> fine{0.832e-6, 40e-6, 500e6, 5.3e-6};
    const PeakDistribution<double> peaks(0.5, 1.0);
    const RoughContact hertz(fine, peaks, HertzLaw<double>{}, 112.6e9);
    print_states("hertz", hertz, pressures);
    print_states("fractal", RoughContact(fine, peaks, FractalLaw<double>(1.62), 112.6e9), pressures);
    RoughContactOptions<double> options;
    options.interaction = {InteractionReading::effective_separation, 1e-4};
    print_states("interacting", RoughContact(fine, peaks, HertzLaw<double>{}, 112.6e9, options), pressures);

    const auto law = ContactLaw<double>::tabulate(hertz, {1e5, 1e8, OutsideRange::extrapolate});
    std::ofstream(argv[2], std::ios::binary) << law.to_text();
    for (std::size_t i = 0; i < pressures.size(); ++i) {
        const double p = pressures[i] * 1.5, d = law.separation(p);
        const auto at = law.at_separation(d);
        print(("law/" + std::to_string(i)).c_str(),
              {p, d, law.stiffness(p), law.stiffness_slope(p), at.pressure, at.stiffness, law.slope_at_separation(d)});
    }

    print_friction(law);
    print_law_of_answer();

    const std::string text =
        std::string(scene::builtin_scene) +  // which ends with [contact]
        "laws = [\"fractal\", \"hertz\", \"greenwood_williamson\"]\n"
        "peaks = [{ theta = \"pi/4\", r = \"exponential\" }, { theta = \"pi/3\", r = \"exponential\" }]\n";
    const actions::Answered scene = actions::compute(scene::read_scene(text, {.name = "builtin"}));
    std::ofstream(std::string(argv[2]) + ".scene", std::ios::binary) << text;
    for (std::size_t i = 0; i < 5; ++i) {
        std::vector<double> at_pressures, stiffness;
        for (const AnswerPoint& point : scene.curves()[i].points)
            at_pressures.push_back(point.pressure), stiffness.push_back(point.stiffness.value);
        print(("scene/p" + std::to_string(i)).c_str(), at_pressures);
        print(("scene/k" + std::to_string(i)).c_str(), stiffness);
    }

    SelfAffineOptions<double> surface;
    surface.hurst = 0.7, surface.rms = 1e-6;
    const Profile<double> profile = self_affine_profile(surface, 4096, 1e-6);
    print("profile", profile.heights);
    print("profile/measured", numbers_of(detail::surface_parameters<double>(detail::level(profile, Form::line), {})));
    print_surface("profile/default", measure(profile));
    const HeightMap<double> map = self_affine_map(surface, 96, 64, 1e-6, 1.5e-6);
    print("map", {map.heights.data(), map.heights.data() + map.size()});
    print("map/sides", {static_cast<double>(map.rows()), static_cast<double>(map.columns()), map.dx, map.dy});
    print("map/measured", numbers_of(detail::surface_parameters<double>(detail::level(map, MapForm::plane), {})));
    print_surface("map/default", measure(map));
    print_laws(map, pressures);
    HeightMap<double> missing = map;
    missing.heights(3, 4) = std::numeric_limits<double>::quiet_NaN();
    print_surface("map/missing", measure(missing));
    return std::fclose(out);
}
