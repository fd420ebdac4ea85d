// SPDX-License-Identifier: BSD-3-Clause
// The band of K of one trace, against K of the mean spectrum of 100 traces of one process and its D.
#include "actions/answered.hpp"
#include "surface/measured_surface.hpp"

#include "cli/command.hpp"

#include <fstiff/synthetic/self_affine.hpp>

#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace coverage_test {

using namespace fstiff;

namespace {

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n"
    "[contact]\npressures = [\"10 MPa\"]\nlaws = [\"fractal\", \"hertz\"]\n";

/// Half a period of a Gaussian process whose rms is 1 um in the mean over all seeds, at every \p step th point.
std::string trace(double hurst, double longest, std::uint64_t seed, std::size_t step) {
    const auto whole = fstiff::self_affine_profile<double>({.hurst = hurst,
                                                            .rms = 1e-6,
                                                            .longest_wavelength = longest,
                                                            .shortest_wavelength = 2e-6,
                                                            .exact_rms = false,
                                                            .seed = seed},
                                                           16384, 1e-6);
    std::ostringstream text;
    text.precision(17);
    for (std::size_t i = 0; i < 8192; i += step)
        text << static_cast<double>(i) * 1e-6 << ',' << whole.heights[i] << '\n';
    return text.str();
}

/// [surface] with the numbers of the mean spectrum of \p files and the D of the process.
std::string process(double hurst, const std::vector<std::string>& files) {
    surface::MeasureOptions how;
    how.input.units = "m";
    how.input.lambda_s = "40 um", how.input.lambda_c = "none";
    how.neighbours = false;
    how.resamples = 2;
    std::ostringstream numbers;
    numbers.precision(17);
    numbers << "[surface]\nfractal_dimension = " << 2 - hurst << '\n';
    for (const auto& line : surface::parameter_lines(surface::measure_files(how, files)))
        if (line.name == "r" || line.name == "theta")
            numbers << line.name << " = " << line.measured.value << '\n';
        else if (line.name == "rms_height" || line.name == "peak_radius" || line.name == "peak_density")
            numbers << line.name << " = \"" << line.measured.value << ' ' << line.unit << "\"\n";
    return numbers.str();
}

}  // namespace

TEST_CASE("The band of 5 to 95 % holds K(10 MPa) of the process in 80 % of traces and more, at every decimation",
          "[long]") {
    // 90 % are asked for; 83 to 98 were found. 100 traces give the share to 3 %.
    struct Case {
        double hurst, longest;  // where the spectrum turns flat: an eighth of the trace, or twice its length
    };
    const auto [hurst, longest] = GENERATE(Case{0.8, 1e-3}, Case{0.5, 1e-3}, Case{0.8, 0}, Case{0.5, 0});
    for (const std::size_t step : {1u, 4u, 16u}) {
        const test::Folder folder;
        std::vector<std::string> files;
        for (std::uint64_t seed = 1; seed <= 100; ++seed)
            files.push_back(folder.write(std::to_string(seed) + ".csv", trace(hurst, longest, seed, step)));
        const auto truth = actions::compute(scene::read_scene(process(hurst, files) + rest, {.name = "truth"}));
        std::array<int, 2> covered{};
        int computed = 0;
        for (const std::string& file : files) {
            actions::Answered found;
            try {
                found = actions::compute(scene::read_scene("[surface]\nfrom = \"" + file +
                                                               "\"\nunits = \"m\"\nlambda_s = \"40 um\"\nlambda_c = "
                                                               "\"none\"\n" +
                                                               rest,
                                                           {.name = "trace"}));
            } catch (const fstiff::domain_error&) {  // no half decade of lags is a power law: no D
                continue;
            }
            ++computed;
            for (const std::size_t law : {0u, 1u}) {
                const auto& band = found.curves()[law].points.at(0).stiffness;
                const double K = truth.curves()[law].points.at(0).state.stiffness.value;
                covered[law] += band.low <= K && K <= band.high;
            }
        }
        WARN("H = " << hurst << ", flat from " << longest << " m, every " << step << ". point: fractal " << covered[0]
                    << ", hertz " << covered[1] << " of " << computed);
        CHECK(computed >= 50);
        CHECK(covered[0] >= 0.8 * computed);
        CHECK(covered[1] >= 0.8 * computed);
    }
}

}  // namespace coverage_test
