// SPDX-License-Identifier: BSD-3-Clause
// The band of K of a measured surface: its errors, and the spread over lambda_s.
#include "support/library.hpp"

#include <cmath>

namespace band_test {

namespace {

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n"
    "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\nlaws = [\"hertz\", \"greenwood_williamson\"]\n";

}  // namespace

TEST_CASE("The band holds K at half and twice the root of two of lambda_s, and the sampled band") {
    const test::Folder folder;
    const fstiff::SelfAffineOptions<double> rough{
        .hurst = 0.6, .rms = 1e-6, .longest_wavelength = 300e-6, .shortest_wavelength = 2e-6};
    // rough down to the step: R depends on lambda_s
    const std::string trace = folder.write("trace.csv", test::profile_text(8192, 1e-6, rough));
    const auto of = [&](const std::string& surface) {
        return test::results_of("[surface]\nfrom = \"" + surface + rest, folder / "scene.toml");
    };
    const auto behind = [&](const std::string& lambda_s) {
        return of("trace.csv\"\nlambda_s = \"" + lambda_s + "\"\nlambda_c = \"none\"\n");
    };
    const auto whole = behind("12 um"), less = behind("8.48528137423857 um"), more = behind("16.970562748477143 um");
    // without its neighbours the document of a measurement has the sampled band alone
    auto document = test::measured_files("--lambda-s '12 um' --lambda-c none", {trace});
    REQUIRE(document["neighbours"].size() == 2);
    folder.write("all.json", document.dump());
    document.erase("neighbours");
    folder.write("sampled.json", document.dump());
    const auto of_document = of("all.json\"\n"), sampled = of("sampled.json\"\n");
    REQUIRE(whole.curves.size() >= 2);
    for (std::size_t c = 0; c < whole.curves.size(); ++c)
        for (std::size_t i = 0; i < 2; ++i) {
            INFO(fstiff::actions::title(whole.curves[c]) << ", point " << i);
            const auto stiffness = [&](const fstiff::actions::Results& one) {
                return one.curves[c].states[i].stiffness.value;
            };
            const double K = stiffness(whole), a = stiffness(less), b = stiffness(more);
            const auto &band = whole.curves[c].band[i], &errors = sampled.curves[c].band[i];
            CHECK(band.low < std::min(a, b));
            CHECK(band.high > std::max(a, b));
            CHECK(std::abs(of_document.curves[c].band[i].low / band.low - 1) < 1e-12);
            const double up = std::log(std::max({a, b, K}) / K), down = std::log(std::min({a, b, K}) / K);
            CHECK(std::abs(std::log(band.high / K) - std::hypot(up, std::log(errors.high / K))) < 1e-9);
            CHECK(std::abs(std::log(band.low / K) + std::hypot(down, std::log(errors.low / K))) < 1e-9);
        }
}

TEST_CASE("Keys written in a scene hold for every lambda_s") {
    const test::Folder folder;
    folder.write(
        "trace.csv",
        test::profile_text(2048, 1e-6,
                           {.hurst = 0.6, .rms = 1e-6, .longest_wavelength = 200e-6, .shortest_wavelength = 2e-6}));
    const auto held = test::results_of(
        "[surface]\nfrom = \"trace.csv\"\nlambda_s = \"12 um\"\nrms_height = \"1 um\"\n"
        "peak_radius = \"50 um\"\npeak_density = \"900 /mm^2\"\n" +
            rest,
        folder / "scene.toml");
    const auto& curve = held.curves.back();  // it takes these three alone, and they have no errors
    REQUIRE(curve.law->name == "greenwood_williamson");
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(std::abs(curve.band[i].low / curve.states[i].stiffness.value - 1) < 1e-9);
        CHECK(std::abs(curve.band[i].high / curve.states[i].stiffness.value - 1) < 1e-9);
    }
}

TEST_CASE("The ends of a band at separations are K of surfaces that are so much taller") {
    const auto of = [](double taller, const std::string& contact) {
        const auto times = [taller](double value) { return std::to_string(value * taller); };
        return test::results_of("[surface]\nrms_height = \"" + times(500) + " nm\"\nrms_gradient = " + times(0.1) +
                                "\nalpha = 10\nhurst = 0.8\nskewness = 0\nkurtosis = 3\n"
                                "[surface.errors]\nrms_height = \"50 nm\"\n[material.upper]\n"
                                "youngs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\nhardness = \"3 GPa\"\n[contact]\n" +
                                contact);
    };
    // K of proportional is a constant over the rms height: its band has the heights at 5 and 95 % of those drawn
    const auto heights = of(1, "pressures = [\"1 MPa\"]\nlaws = [\"proportional\"]\n[uncertainty]\nsamples = 400\n");
    const auto& band = heights.curves[0].band[0];
    const double K = heights.curves[0].states[0].stiffness.value;
    const std::string laws = "separations = [\"1.5 um\", \"1 um\", \"0.5 um\"]\nlaws = [\"hybrid\", \"plastic\"]\n";
    const auto drawn = of(1, laws + "[uncertainty]\nsamples = 400\n"),
               low = of(K / band.high, laws + "[uncertainty]\nsamples = 0\n"),
               high = of(K / band.low, laws + "[uncertainty]\nsamples = 0\n");
    REQUIRE(drawn.curves.size() == 2);
    for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t i = 0; i < 3; ++i) {
            INFO(fstiff::actions::title(drawn.curves[c]) << ", point " << i);
            const auto& ends = drawn.curves[c].band[i];  // K of drawn surfaces is right to 1.2e-3
            CHECK(std::abs(ends.low / low.curves[c].states[i].stiffness.value - 1) < 1.2e-3);
            CHECK(std::abs(ends.high / high.curves[c].states[i].stiffness.value - 1) < 1.2e-3);
        }
}

}  // namespace band_test
