// SPDX-License-Identifier: BSD-3-Clause
// hybrid and plastic of numbers and traces with a bearing curve. Truth: the Gaussian law, the library's hybrid_of_band,
// and the same surface written in another way.
#include "actions/answered.hpp"
#include "actions/measure.hpp"
#include "actions/one_contact.hpp"
#include "scene/scene.hpp"

#include "cli/command.hpp"
#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/library.hpp"

#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/measure/height_shape.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace bearing_of_numbers_test {

using namespace fstiff;

const std::string numbers = "[surface]\nrms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 8\n";
const std::string rest =
    "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\nhardness = \"2 GPa\"\n[contact]\n"
    "pressures = [\"10 MPa\", \"100 MPa\", \"1 GPa\"]\nlaws = [\"hybrid\"]\n[uncertainty]\nsamples = 0\n";

scene::Scene read(const std::string& surface, std::string text = rest) {
    return scene::read_scene(surface + text, {.name = "s.toml"});
}
std::vector<double> stiffnesses(const scene::Scene& scene) {
    std::vector<double> all;
    for (const auto& curve : actions::compute(scene).curves())
        for (const auto& state : test::states_of(curve)) all.push_back(state.stiffness.value);
    return all;
}
std::vector<double> stiffnesses(const std::string& surface) { return stiffnesses(read(surface)); }
std::string refusal(const std::string& surface) { return test::refused_scene(surface + rest, "s.toml"); }
double largest_change(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, test::relative_error(a[i], b[i]));
    return most;
}

/// Sk, Spk, Svk, Smr1, Smr2 of Gaussian heights of the rms 1 um, for which any share of peaks will do.
std::string gaussian_core(char letter) {
    const double share = 0.0907, z = math::normal_quantile(1 - share),
                 peak = 2 / share * (math::normal_density(z) - z * share);
    const std::string name(1, letter), length = std::to_string(peak);
    return name + "k = \"" + std::to_string(2 * z) + " um\"\n" + name + "pk = \"" + length + " um\"\n" + name +
           "vk = \"" + length + " um\"\n" + name + "mr1 = 0.0907\n" + name + "mr2 = 0.9093\n";
}

/// 1001 heights f(zeta) at the middles of equal shares.
template <class F>
std::string list(const F& f) {
    std::string text = "bearing_curve = [";
    for (int i = 0; i < 1001; ++i)
        text += (i ? ", \"" : "\"") + std::to_string(f(math::normal_quantile((i + 0.5) / 1001))) + " um\"";
    return text + "]\n";
}

TEST_CASE("hybrid of a Gaussian bearing curve is that of Gaussian numbers") {
    const auto gaussian = stiffnesses(numbers);
    CHECK(stiffnesses(numbers + "skewness = 0\nkurtosis = 3\n") == gaussian);  // the same law, to the last bit
    for (const char letter : {'S', 'R'})
        CHECK(largest_change(stiffnesses(numbers + gaussian_core(letter)), gaussian) < 1e-5);
    CHECK(largest_change(stiffnesses(numbers + list([](double z) { return z; })), gaussian) < 1e-5);
    // and next to it
    CHECK(largest_change(stiffnesses(numbers + "skewness = 1e-6\nkurtosis = 3\n"), gaussian) < 1e-4);
    const std::string plastic =
        rest.substr(0, rest.find("laws")) + "laws = [\"plastic\"]\n[uncertainty]\nsamples = 0\n";
    CHECK(stiffnesses(read(numbers + "skewness = 0\nkurtosis = 3\n", plastic)) == stiffnesses(read(numbers, plastic)));
    CHECK(largest_change(stiffnesses(read(numbers + gaussian_core('S'), plastic)),
                         stiffnesses(read(numbers, plastic))) < 2e-3);  // by the bound of a bearing curve, 6e-4 here
}

TEST_CASE("hybrid of skewness and kurtosis is the library's, and a list of the same heights agrees") {
    const double skewness = -1, kurtosis = 4.5;
    const auto found = stiffnesses(numbers + "skewness = -1\nkurtosis = 4.5\n"), gaussian = stiffnesses(numbers);
    const double modulus = 205e9 / (2 * (1 - 0.3 * 0.3));
    const auto curve = detail::bearing_of_moments(skewness, kurtosis);
    const auto law =
        hybrid_of_band(detail::band_of_moments(detail::moments_of_gradient(1e-6, 0.1, 8.0), 0.8), curve, modulus);
    CHECK(largest_change(found, {law.stiffness(10e6), law.stiffness(100e6), law.stiffness(1e9)}) < 1e-12);
    CHECK(found[0] > 1.5 * gaussian[0]);  // flattened peaks are stiffer, most at light loads
    CHECK(found[0] / gaussian[0] > found[2] / gaussian[2]);
    CHECK(stiffnesses(numbers + "skewness = 1\nkurtosis = 4.5\n")[0] < 0.7 * gaussian[0]);
    const auto listed = stiffnesses(numbers + list([&](double z) { return curve.height(z); }));
    CHECK(largest_change({listed[1], listed[2]}, {found[1], found[2]}) < 0.01);
    CHECK(largest_change(listed, found) < 0.05);  // 1 of 1001 heights ends at 3.3 sigma
    // as many numbers as a program has: without alpha
    Joint plain{.face = {.rms_height = 1e-6, .rms_gradient = 0.1, .peak_radius = 20e-6, .peak_density = 2e9},
                .effective_modulus = modulus};
    const std::vector<double> pressure{1e8};
    const auto stiffness = [&] {
        return actions::make_contact("hybrid", plain)
            .contact->at_pressures(pressure, Quantity::stiffness)[0]
            .state.stiffness.value;
    };
    const double without = stiffness();
    plain.face.skewness = -1, plain.face.kurtosis = 4.5;
    CHECK(stiffness() > 1.2 * without);
    plain.face.kurtosis = 0;
    CHECK_THROWS_AS(stiffness(), domain_error);
    plain.face.kurtosis = 1.5;
    CHECK_THROWS_AS(stiffness(), domain_error);
}

TEST_CASE("K and both ends of faces near the least kurtosis rise with the pressure, each point computed alone",
          "[more]") {
    const auto at = [](double skewness, double kurtosis, const std::string& rest, double pressure) {
        const auto results = test::results_of(
            "[surface]\nSq = \"1 um\"\n" + rest + "skewness = " + std::to_string(skewness) +
            "\nkurtosis = " + std::to_string(kurtosis) +
            "\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\nhardness = \"infinite\"\n"
            "[contact]\npressures = [\"" +
            std::to_string(pressure) + " Pa\"]\n");
        return results.answer.points.front().stiffness;
    };
    for (const auto& [skewness, kurtosis] :
         {std::pair(-1.5, 3.51), {-1.5, 3.6}, {-1.2, 2.7}, {-2.06, 5.78}, {0.0, 1.1}, {0.1, 1.25}, {-2.18, 5.9}})
        for (const std::string rest : {"", "Sdq = 0.1\n", "Sdq = 0.1\nalpha = 40\n"}) {
            fstiff::WithBand last{0, 0, 0};
            for (double pressure = 1e3; pressure < 1e9; pressure *= 2) {
                const auto band = at(skewness, kurtosis, rest, pressure);
                CAPTURE(skewness, kurtosis, rest, pressure);
                CHECK(band.low >= last.low);
                CHECK(band.value >= last.value);
                CHECK(band.high >= 0.99 * last.high);  // its knots are eight a decade
                last = band;
            }
        }
}

TEST_CASE("A kurtosis below the least that was compared counts as that, and none below that of any distribution") {
    const auto of = [](const std::string& kurtosis) {
        return test::results_of("[surface]\nSq = \"1 um\"\nSdq = 0.1\nskewness = 0\nkurtosis = " + kurtosis +
                                "\n[material]\nupper = \"steel\"\n[contact]\npressures = [\"10 MPa\"]\n")
            .answer.points.front()
            .stiffness;
    };
    CHECK(of("1.1").value == of("1.25").value);
    CHECK(of("1").high == of("1.25").high);
    CHECK(of("1.3").value != of("1.25").value);
}

TEST_CASE("Errors of a bearing curve are reported in one sentence") {
    const auto wrong = [](const std::string& keys, const std::string& sentence) {
        const std::string found = refusal(numbers + keys);
        CAPTURE(keys, found);
        CHECK(found.find(sentence) != std::string::npos);
        CHECK(found.starts_with("s.toml:"));
    };
    wrong("skewness = 1\n", "surface.kurtosis: is missing");
    wrong("kurtosis = 4\n", "surface.skewness: is missing");
    wrong("skewness = 1\nkurtosis = 1.9\n", "surface.kurtosis = 1.9: must be from skewness^2 + 1, here 2, to 100");
    wrong("skewness = 0\nkurtosis = 0.99\n", "surface.kurtosis = 0.99: must be from 1 to 100");
    wrong("skewness = 4\nkurtosis = 30\n", "surface.skewness = 4: must be from -3 to 3");
    wrong("skewness = \"1 um\"\nkurtosis = 4\n", "must be a plain number");
    wrong("Sk = \"2.5 um\"\n", "surface.Spk: is missing; Sk, Spk, Svk, Smr1 and Smr2 belong together");
    wrong("Sk = 2.5\nSpk = 1\nSvk = 1\nSmr1 = 0.1\nSmr2 = 0.9\n", "a number without a unit");
    wrong("Sk = \"0 um\"\nSpk = \"1 um\"\nSvk = \"1 um\"\nSmr1 = 0.1\nSmr2 = 0.9\n",
          "must be finite and greater than 0");
    wrong("Sk = \"2.5 um\"\nSpk = \"-1 um\"\nSvk = \"1 um\"\nSmr1 = 0.1\nSmr2 = 0.9\n",
          "must be finite and not negative");
    wrong("Sk = \"2.5 um\"\nSpk = \"1 um\"\nSvk = \"1 um\"\nSmr1 = 10\nSmr2 = 90\n",
          "must be a share from 0 to 1; 10 % is 0.1");
    wrong("Rk = \"2.5 um\"\nRpk = \"1 um\"\nRvk = \"1 um\"\nRmr1 = 0.9\nRmr2 = 0.1\n",
          "must be greater than surface.Rmr1");
    wrong("Sk = \"2.5 nm\"\nSpk = \"1 nm\"\nSvk = \"1 nm\"\nSmr1 = 0.1\nSmr2 = 0.9\n", "within a factor of 2");
    wrong("skewness = 0\nkurtosis = 3\nbearing_curve = []\n",
          "must not be given with surface.skewness; give one bearing curve");
    wrong("bearing_curve = [\"1 um\", \"2 um\"]\n", "must be a list of at least 10 lengths");
    wrong(
        "bearing_curve = [\"1 um\", \"1 um\", \"1 um\", \"1 um\", \"1 um\", \"1 um\", \"1 um\", \"1 um\", \"1 um\", "
        "\"1 um\"]\n",
        "different heights of a bearing curve");
}

/// A long trace of lognormal heights, or of Gaussian ones.
Profile<double> trace(double a) {
    SelfAffineOptions<double> options;
    options.hurst = 0.8, options.rms = 1, options.longest_wavelength = 1.0 / 100,
    options.shortest_wavelength = 1.0 / 300;
    options.seed = 3;
    Profile<double> profile = self_affine_profile(options, 4096, 1.0 / 4096);
    for (double& z : profile.heights) z = 1e-6 * (a > 0 ? std::expm1(a * z) / a : z);
    profile.spacing = 0.5e-6;
    return profile;
}

TEST_CASE("hybrid of a trace takes its skewness and kurtosis as far as they are known") {
    const test::Folder folder;
    const auto surface_of = [&](const Profile<double>& profile) {
        std::ofstream out(folder / "trace.txt");
        out.precision(17);
        out << "# x [m] z [m]\n";
        for (std::size_t i = 0; i < profile.size(); ++i)
            out << static_cast<double>(i) * profile.spacing << ' ' << profile.heights[i] << '\n';
        out.close();
        return "[surface]\nfrom = \"" + std::string(folder / "trace.txt") +
               "\"\nlambda_s = \"none\"\nlambda_c = \"none\"\ndetrend = \"mean\"\n";
    };
    const std::string text = surface_of(trace(0.4));
    const scene::Scene skewed = read(text);
    REQUIRE(skewed.joint.face.measured);
    const double share = skewed.joint.face.measured->shape_share;
    CHECK(share > 0.8);
    const auto& heights = *skewed.joint.face.heights;
    CHECK(heights.skewness.value > 0.7);
    CHECK(skewed.joint.face.shape.skewness == share * heights.skewness.value);
    CHECK(skewed.joint.face.shape.kurtosis == 3 + share * (heights.kurtosis.value - 3));
    // the same written by hand, and the Gaussian one
    const auto found = stiffnesses(skewed);
    const auto written = stiffnesses(text + "skewness = " + std::to_string(skewed.joint.face.shape.skewness) +
                                     "\nkurtosis = " + std::to_string(skewed.joint.face.shape.kurtosis) + "\n");
    CHECK(largest_change(found, written) < 1e-4);
    const auto gaussian = stiffnesses(text + "skewness = 0\nkurtosis = 3\n");
    CHECK(found[0] < 0.8 * gaussian[0]);
    // of the JSON of fstiff measure the same as of the file
    const surface::MeasuredSurface& measured = test::measured_of(skewed);
    std::ofstream(folder / "measured.json") << test::values_of(*measured.how, measured).str();
    const std::string json = "[surface]\nfrom = \"" + std::string(folder / "measured.json") + "\"\n";
    CHECK(largest_change(stiffnesses(json), found) < 1e-12);
    // two such faces: the sum is nearer to a Gaussian one
    const auto face = [&](const std::string& name) {
        return "[surface." + name + "]\n" + text.substr(text.find('\n') + 1);
    };
    const scene::Scene two = read(face("upper") + face("lower"));
    CHECK(test::relative_error(two.joint.face.shape.skewness, skewed.joint.face.shape.skewness / std::sqrt(2.0)) <
          1e-9);
    CHECK(two.joint.face.bearing);
    // heights of eight waves cannot know
    Profile<double> shorter = trace(0);
    shorter.heights.resize(320);
    const scene::Scene plain = read(surface_of(shorter));
    CHECK(plain.joint.face.measured->shape_share == 0);
    CHECK_FALSE(plain.joint.face.bearing);
    CHECK(stiffnesses(plain) == stiffnesses(surface_of(shorter) + "skewness = 0\nkurtosis = 3\n"));
}

}  // namespace bearing_of_numbers_test
