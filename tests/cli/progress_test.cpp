// SPDX-License-Identifier: BSD-3-Clause
// The bar of long work, and the files after an interruption.
#include "cli/command.hpp"
#include "support/skip.hpp"

namespace progress_test {

namespace {

const std::string long_scene =
    "[surface]\nrms_height = \"1 um\"\npeak_radius = \"60 um\"\npeak_density = \"500 /mm^2\"\nfractal_dimension = 1.5\n"
    "errors = { rms_height = \"0.1 um\" }\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
    "[contact]\npressures = { from = \"1 MPa\", to = \"10 MPa\", count = 10 }\nlaws = "
    "[\"hertz\"]\n[uncertainty]\nsamples = 300\n";

}  // namespace

TEST_CASE("Long work shows a bar with the time left on a terminal, and nothing in a pipe") {
    const test::Folder folder;
    const std::string scene = folder.write("scene.toml", long_scene);
    const auto piped = test::run_fstiff("run '" + scene + "' --format csv");
    CHECK(piped.status == 0);
    CHECK(piped.err.empty());
    if (test::shell("script -qec true /dev/null").status != 0)
        SKIP_CASE("`script` makes no terminal here: the bar is not tested");
    const auto shown = test::shell("export TERM=vt100; script -qec \"'" FSTIFF_COMMAND "' run '" + scene +
                                   "' --format csv -o '" + folder / "out.csv" + "'\" /dev/null");
    INFO(shown.out << shown.err);
    CHECK(shown.status == 0);
    CHECK(test::contains(shown.out, "pieces ["));
    CHECK(test::contains(shown.out, " s left"));
    CHECK(shown.out.ends_with("\r\x1b[K"));  // wiped at the end
    CHECK(test::read(folder / "out.csv") == piped.out);
}

TEST_CASE("100000 pressures show a bar") {
    if (test::shell("script -qec true /dev/null").status != 0)
        SKIP_CASE("`script` makes no terminal here: the bar is not tested");
    const test::Folder folder;
    std::string scene = test::read(FSTIFF_SCENES "/sand_blasted_fine.toml");
    scene = test::replaced(scene, "count = 31", "count = 100000");
    scene = test::replaced(scene, "[\"fractal\", \"hertz\", \"greenwood_williamson\"]", "[\"greenwood_williamson\"]");
    folder.write("scene.toml", scene);
    const auto shown =
        test::shell("export TERM=vt100; script -qec \"'" FSTIFF_COMMAND "' run '" + folder / "scene.toml" +
                    "' --format csv -o '" + folder / "run.csv" + "'\" /dev/null");
    INFO(shown.out);
    CHECK(shown.status == 0);
    CHECK(test::contains(shown.out, "points ["));
    CHECK(test::contains(shown.out, " s left"));
    CHECK(test::contains(shown.out, "\r\x1b[K"));  // wiped before the warnings
}

TEST_CASE("Boundary elements of an answer show a bar") {
    if (test::shell("script -qec true /dev/null").status != 0)
        SKIP_CASE("`script` makes no terminal here: the bar is not tested");
    const test::Folder folder;
    const std::string map = folder / "map.csv";
    REQUIRE(
        test::run_fstiff("generate map --points 256 --spacing '1 um' --hurst 0.8 --rms '1 um' --longest '64 um' -o '" +
                         map + "'")
            .status == 0);
    const auto shown = test::shell("export TERM=vt100; script -qec \"'" FSTIFF_COMMAND "' run --surface '" + map +
                                   "' --format csv -o '" + folder / "run.csv" + "'\" /dev/null");
    INFO(shown.out);
    CHECK(shown.status == 0);
    CHECK(test::contains(shown.out, "pieces ["));
}

}  // namespace progress_test
