// SPDX-License-Identifier: BSD-3-Clause
// K of hybrid of a map at every 1st to 8th point of it, of measured maps and of a broad Gaussian one; and of its numbers alone.
// Measured maps: FSTIFF_SURFACES.
#include "scene/results.hpp"
#include "scene/scene.hpp"

#include "cli/command.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

#include <fstiff/io/write_csv.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace thinned_map_test {

using namespace fstiff;

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n[contact]\n"
    "laws = [\"hybrid\"]\n[uncertainty]\nsamples = 0\n";

scene::Scene scene_of(const std::string& file, const std::string& keys, const std::string& pressures,
                      const std::string& spectrum) {
    std::string text = rest;
    text.replace(text.find("laws"), 0, "pressures = [" + pressures + "]\n[contact.persson]\nspectrum = \"" + spectrum +
                                           "\"\n[contact]\n");
    const auto second = text.rfind("[contact]\n");
    text = "[surface]\nfrom = \"" + file + "\"\nlambda_s = \"none\"\n" + keys +
           "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n[contact]\npressures = [" + pressures +
           "]\nlaws = [\"hybrid\"]\n[contact.persson]\nspectrum = \"" + spectrum + "\"\n[uncertainty]\nsamples = 0\n";
    (void)second;
    return scene::read_scene(text, {.name = "s.toml"});
}
