// SPDX-License-Identifier: BSD-3-Clause
// The band of K of a measured surface: its errors, and the spread over lambda_s.
#include "support/library.hpp"

#include <fstiff/answer/answer.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>

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
    REQUIRE(whole.curves().size() >= 2);
    for (std::size_t c = 0; c < whole.curves().size(); ++c)
        for (std::size_t i = 0; i < 2; ++i) {
            INFO(fstiff::actions::title(whole.curves()[c]) << ", point " << i);
            const auto stiffness = [&](const fstiff::actions::Answered& one) {
                return one.curves()[c].points[i].state.stiffness.value;
            };
            const double K = stiffness(whole), a = stiffness(less), b = stiffness(more);
            const auto &band = whole.curves()[c].points[i].stiffness, &errors = sampled.curves()[c].points[i].stiffness;
            CHECK(band.low < std::min(a, b));
            CHECK(band.high > std::max(a, b));
            CHECK(std::abs(of_document.curves()[c].points[i].stiffness.low / band.low - 1) < 1e-12);
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
    const auto& curve = held.curves().back();  // it takes these three alone, and they have no errors
    REQUIRE(fstiff::name_of(curve.law) == "greenwood_williamson");
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(std::abs(curve.points[i].stiffness.low / curve.points[i].state.stiffness.value - 1) < 1e-9);
        CHECK(std::abs(curve.points[i].stiffness.high / curve.points[i].state.stiffness.value - 1) < 1e-9);
    }
}

TEST_CASE("The ends of a band at separations are K of surfaces that are so much taller") {
    const auto of = [](double taller, const std::string& contact) {
        return test::results_of("[surface]\nrms_height = \"" + std::to_string(500 * taller) +
                                " nm\"\nrms_gradient = 0.1\nalpha = 10\nhurst = 0.8\nskewness = 0\nkurtosis = 3\n"
                                "[surface.errors]\nrms_height = \"50 nm\"\n[material.upper]\n"
                                "youngs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\nhardness = \"3 GPa\"\n[contact]\n" +
                                contact);
    };
    // K of proportional is a constant over the rms height: its band has the heights at 5 and 95 % of those drawn
    const auto heights = of(1, "pressures = [\"1 MPa\"]\nlaws = [\"proportional\"]\n[uncertainty]\nsamples = 400\n");
    const auto& band = heights.curves()[0].points[0].stiffness;
    const double K = heights.curves()[0].points[0].state.stiffness.value;
    const std::string laws = "separations = [\"1.5 um\", \"1 um\", \"0.5 um\"]\nlaws = [\"hybrid\", \"plastic\"]\n";
    const auto drawn = of(1, laws + "[uncertainty]\nsamples = 400\n"),
               low = of(K / band.high, laws + "[uncertainty]\nsamples = 0\n"),
               high = of(K / band.low, laws + "[uncertainty]\nsamples = 0\n");
    REQUIRE(drawn.curves().size() == 2);
    for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t i = 0; i < 3; ++i) {
            INFO(fstiff::actions::title(drawn.curves()[c]) << ", point " << i);
            const auto& ends = drawn.curves()[c].points[i].stiffness;  // K of drawn surfaces is right to 1.2e-3
            CHECK(std::abs(ends.low / low.curves()[c].points[i].state.stiffness.value - 1) < 1.2e-3);
            CHECK(std::abs(ends.high / high.curves()[c].points[i].state.stiffness.value - 1) < 1.2e-3);
        }
}

TEST_CASE("The band of a height with an error holds K one error above and below it, by every law") {
    // `rest_of_surface`: what is written, and what is assumed of it, which K of the other heights has alike
    for (const std::string surface :
         {"rms_gradient = 0.12\nalpha = 8\nhurst = 0.8\nfractal_dimension = 1.2\n", "RSm = \"60 um\"\n", "",
          "peak_radius = \"40 um\"\npeak_density = \"2000 /mm^2\"\nfractal_dimension = 1.3\n"})
        for (const std::string hardness : {"\"20 GPa\"", "\"1 GPa\"", "\"0.3 GPa\""}) {
            const auto of = [&](const std::string& height, const std::string& errors, const std::string& rest) {
                std::string laws =
                    "\"hybrid\", \"persson\", \"plastic\", \"greenwood_williamson\", \"hertz\", "
                    "\"plastic_peaks\", \"jackson_green\", \"kogut_etsion\", \"proportional\"";
                if (surface.find("dimension") != std::string::npos) laws += ", \"fractal\", \"fractal_consistent\"";
                return test::results_of("[surface]\nrms_height = \"" + height + "\"\n" + surface +
                                        "skewness = 0\nkurtosis = 3\n" + errors +
                                        "[material.upper]\nname = \"steel\"\nhardness = " + hardness +
                                        "\nyield_strength = \"0.35 GPa\"\n[contact]\npressures = [\"10 MPa\"]\n"
                                        "laws = [" +
                                        laws + "]\n" + rest);
            };
            const std::string no_band = "[uncertainty]\nsamples = 0\n";
            const auto whole = of("0.8 um", "errors = { rms_height = \"0.4 um\" }\n", ""),
                       less = of("0.4 um", "", no_band), more = of("1.2 um", "", no_band);
            REQUIRE(whole.curves().size() >= 9);
            for (std::size_t c = 0; c < whole.curves().size(); ++c) {
                CAPTURE(surface, hardness, fstiff::actions::title(whole.curves()[c]));
                for (const auto* other : {&less, &more}) {
                    const double K = other->curves()[c].points[0].state.stiffness.value;
                    CHECK(whole.curves()[c].points[0].stiffness.low < K);
                    CHECK(whole.curves()[c].points[0].stiffness.high > K);
                }
            }
            // of the answer too, and its largest cause is then the measurement
            const auto& answer = whole.answer;
            for (const auto* other : {&less, &more}) {
                CHECK(answer.points[0].stiffness.low < other->answer.points[0].state.stiffness.value);
                CHECK(answer.points[0].stiffness.high > other->answer.points[0].state.stiffness.value);
            }
            if (surface.starts_with("rms_gradient"))
                CHECK(fstiff::shares_of(answer.points[0].causes)[std::size_t(fstiff::Cause::measurement)] > 0.5);
        }
}

TEST_CASE("The band of 1 mm of a trace of a hard or a soft steel holds K of the 16 mm that it was cut from") {
    using namespace fstiff;
    for (const double hardness : {std::numeric_limits<double>::infinity(), 1e9}) {
        int held = 0, pieces = 0;
        for (const double longest : {2e-3, 0.7e-3})
            for (const std::uint64_t seed : {1, 2}) {
                const auto whole = self_affine_profile<double>(
                    {.hurst = 0.8, .rms = 1e-6, .longest_wavelength = longest, .seed = seed}, 32768, 0.5e-6);
                const auto stiffness = [&](const Profile<double>& trace) {
                    MeasureOptions<double> how;
                    how.lambda_s = CutOff<double>::of(2.5e-6);
                    const auto measured = measured_face(measure(trace, how));
                    const Body steel{.elastic = {205e9, 0.3}, .hardness = hardness};
                    return answer({.face = {.measured = measured}, .upper = steel, .lower = steel}, std::array{5e6})
                        .points[0]
                        .stiffness;
                };
                const double truth = stiffness(whole).value;
                for (std::size_t i = 0; i < whole.heights.size(); i += 4096, ++pieces) {
                    const auto from = whole.heights.begin() + static_cast<std::ptrdiff_t>(i);
                    const WithBand of_piece = stiffness({{from, from + 2048}, 0.5e-6});
                    held += of_piece.low <= truth && truth <= of_piece.high;
                }
            }
        CAPTURE(hardness, held, pieces);
        CHECK(10 * held >= 9 * pieces);  // the band is one of 90 %
    }
}

}  // namespace band_test
