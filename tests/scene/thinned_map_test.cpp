// SPDX-License-Identifier: BSD-3-Clause
// K of hybrid of a map at every 1st, 2nd, 4th and 8th of its points along both sides, by the map itself and by its
// numbers: of measured maps (FSTIFF_SURFACES) and of a broad Gaussian one.
#include "actions/answered.hpp"
#include "scene/scene.hpp"

#include "cli/command.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

#include <fstiff/io/write.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace thinned_map_test {

using namespace fstiff;

std::string scene_of(const std::string& file, const std::string& keys, const std::string& spectrum) {
    return "[surface]\nfrom = \"" + file + "\"\nlambda_s = \"none\"\npeaks = \"summits\"\n" + keys +
           "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
           "[contact]\npressures = [\"1 MPa\", \"10 MPa\", \"100 MPa\"]\nlaws = [\"hybrid\"]\n"
           "[contact.persson]\nspectrum = \"" +
           spectrum + "\"\n[uncertainty]\nsamples = 0\n";
}

/// Largest over least K at each pressure, of \p map at every 1st to 8th point.
std::vector<double> spreads(const HeightMap<double>& map, const std::string& spectrum) {
    const test::Folder folder;
    std::vector<double> least(3, 1e300), most(3, 0);
    for (const Eigen::Index nth : {1, 2, 4, 8}) {
        HeightMap<double> thinned;
        thinned.dx = map.dx * static_cast<double>(nth), thinned.dy = map.dy * static_cast<double>(nth);
        thinned.heights.resize((map.rows() + nth - 1) / nth, (map.columns() + nth - 1) / nth);
        for (Eigen::Index j = 0; j < thinned.rows(); ++j)
            for (Eigen::Index i = 0; i < thinned.columns(); ++i) thinned.heights(j, i) = map.heights(j * nth, i * nth);
        const std::string file = folder / "map.csv";
        {
            std::ofstream out(file);
            io::write_csv(out, thinned);
        }
        const auto results =
            actions::compute(scene::read_scene(scene_of(file, "detrend = \"none\"\n", spectrum), {.name = "s.toml"}));
        REQUIRE(results.curves().size() == 1);
        REQUIRE(results.curves()[0].points.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            const double K = results.curves()[0].points[i].state.stiffness.value;
            least[i] = std::min(least[i], K), most[i] = std::max(most[i], K);
        }
    }
    for (std::size_t i = 0; i < 3; ++i) most[i] /= least[i];
    return most;
}

TEST_CASE("K of hybrid of the numbers of a measured map hardly depends on the step") {
    const std::filesystem::path surfaces = FSTIFF_SURFACES;
    if (!std::filesystem::exists(surfaces)) {
        test::leave_out("no folder of measured surfaces: " + surfaces.string());
        return;
    }
    for (const auto& [name, most] : {std::pair{"matrix-3.txt", 1.15}, std::pair{"x3p-2.x3p", 1.20}}) {
        CAPTURE(name);
        const scene::Scene whole =
            scene::read_scene(scene_of((surfaces / name).string(), "", "moments"), {.name = "s.toml"});
        const std::vector<double> found = spreads(whole.joint.face.measured->map->map, "moments");
        CAPTURE(found[0], found[1], found[2]);
        CHECK(found[0] < most);
        CHECK(found[1] < most);
        CHECK(found[2] < most);
    }
}

TEST_CASE(
    "K of hybrid of a broad map hardly depends on the step by its numbers, and by the map where many contacts carry") {
    SelfAffineOptions<double> options;
    options.hurst = 0.8, options.rms = 1e-6, options.seed = 5;
    options.longest_wavelength = 1.0 / 4, options.shortest_wavelength = 1.0 / 128;
    HeightMap<double> map = self_affine_map(options, 512, 512, 1.0 / 512, 1.0 / 512);
    map.dx = map.dy = 0.5e-6;
    const std::vector<double> numbers = spreads(map, "moments"), own = spreads(map, "map");
    CAPTURE(numbers[0], numbers[1], numbers[2], own[0], own[1], own[2]);
    for (const double one : numbers) CHECK(one < 1.05);
    CHECK(own[2] < 1.15);
    CHECK(own[0] < 2);  // a few summits, which thinning takes away
}

}  // namespace thinned_map_test
