// SPDX-License-Identifier: BSD-3-Clause
// What people look at: pictures of a sweep and the sensitivities of K.
#include "cli/command.hpp"
#include "support/skip.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace sweep_views_test {

using namespace test;

namespace {

std::string grid(const std::string& rms, const std::string& radius, const std::string& pressures,
                 const std::string& more = "", const std::string& laws = "\"hertz\"") {
    return "[surface]\nfractal_dimension = 1.6\nrms_height = " + rms + "\npeak_radius = " + radius +
           "\npeak_density = \"500 /mm^2\"\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
           "yield_strength = \"400 MPa\"\n"
           "[contact]\nlaws = [" +
           laws + "]\npeaks = [ { theta = \"pi/3\", r = 0.5 } ]\n" + pressures + "\n" + more;
}

/// The rows of k.plot.csv of a sweep with --plot.
Csv drawn(const Folder& folder, const std::string& text) {
    const std::string file = folder.write("grid.toml", text);
    const Outcome outcome =
        run_fstiff("sweep '" + file + "' -o '" + folder / "out" + "' --plot '" + folder / "k.svg" + "'");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(contains(read(folder / "k.svg"), "<svg "));
    const std::string table = read(folder / "k.plot.csv");
    return Csv(table.substr(table.find('\n') + 1));  // after the line that names fstiff
}

/// All K of the results.
std::vector<double> stiffnesses(const std::string& results) {
    std::vector<double> all;
    for (const std::string& line : lines(results))
        all.push_back(std::stod(line.substr(line.find("\"stiffness_Pa_per_m\":") + 21)));
    return all;
}

}  // namespace

TEST_CASE("The picture of a sweep has K of the lines against the longer axis, a line for each value of the other") {
    const Folder folder;
    const Csv rows = drawn(folder, grid("[\"0.5 um\", \"1 um\", \"2 um\"]", "\"40 um\"",
                                        "pressures = [ { from = \"1 MPa\", to = \"100 MPa\", count = 5 } ]"));
    REQUIRE(rows.size() == 3 * 5);
    const auto wanted = stiffnesses(read(folder / "out"));
    std::map<std::string, int> labels;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ++labels[std::string(rows.text(i, "label"))];
        // the picture is in GPa/um
        CHECK(std::abs(rows.number(i, "y") * 1e15 / wanted[i] - 1) < 1e-12);
    }
    CHECK(labels.size() == 3);
    CHECK(labels["rms height = 0.5 µm"] == 5);
    CHECK(std::abs(rows.number(4, "x") - 100) < 1e-9);  // MPa
}

TEST_CASE("Of many lines of a sweep the largest value is drawn, and the legend is unbroken") {
    const Folder folder;
    const std::string laws = R"("fractal", "hertz", "greenwood_williamson", "plastic_peaks", "jackson_green")";
    const Csv rows =
        drawn(folder, grid("{ from = \"0.5 um\", to = \"2 um\", count = 20 }", "[\"20 um\", \"30 um\", \"40 um\"]",
                           "pressures = [ { from = \"1 MPa\", to = \"100 MPa\", count = 12 } ]", "", laws));
    std::map<std::string, int> labels;
    for (std::size_t i = 0; i < rows.size(); ++i) ++labels[std::string(rows.text(i, "label"))];
    CHECK(labels.size() == 8);
    for (const char* law : {"fractal", "hertz", "greenwood_williamson", "plastic_peaks"})
        for (const char* value : {"p = 1 MPa", "p = 100 MPa"}) {
            INFO(law << " " << value);
            CHECK(std::any_of(labels.begin(), labels.end(), [&](const auto& one) {
                return one.first.starts_with(law) && one.first.ends_with(value);
            }));
        }
    const std::string picture = read(folder / "k.svg");
    CHECK(contains(picture, "8 of 60 curves are drawn"));
    CHECK(contains(picture, "5\u00A0to\u00A095\u00A0%"));
    CHECK(contains(picture, "scenes of grid.toml"));
}

TEST_CASE("Draws are drawn as their median with 5 to 95 %") {
    const Folder folder;
    const Csv rows =
        drawn(folder, grid("{ lognormal = [\"0.8 um\", 0.1] }", "\"40 um\"",
                           "pressures = [ { values = [\"1 MPa\", \"10 MPa\"] } ]", "[sweep]\nsamples = 101\n"));
    REQUIRE(rows.size() == 2);
    auto all = stiffnesses(read(folder / "out"));
    // 101 draws under each of two pressures; the quantiles of 101 values are the values themselves
    for (const std::size_t i : {std::size_t(0), std::size_t(1)}) {
        std::vector<double> some;  // the pressure is the axis, the draws are adjacent
        some.assign(all.begin() + static_cast<std::ptrdiff_t>(101 * i),
                    all.begin() + static_cast<std::ptrdiff_t>(101 * (i + 1)));
        std::sort(some.begin(), some.end());
        CHECK(std::abs(rows.number(i, "y") * 1e15 / some[50] - 1) < 1e-12);
        CHECK(std::abs(rows.number(i, "low") * 1e15 / some[5] - 1) < 1e-12);
        CHECK(std::abs(rows.number(i, "high") * 1e15 / some[95] - 1) < 1e-12);
    }
}

TEST_CASE("Draws alone are drawn as the share of scenes below K") {
    const Folder folder;
    const Csv rows = drawn(folder, grid("{ normal = [\"0.8 um\", \"0.05 um\"] }", "\"40 um\"",
                                        "pressures = [\"1 MPa\"]", "[sweep]\nsamples = 100\n"));
    REQUIRE(rows.size() == 100);
    CHECK(rows.number(0, "y") == 0.005);
    CHECK(rows.number(99, "y") == 0.995);
    for (std::size_t i = 1; i < 100; ++i) CHECK(rows.number(i, "x") > rows.number(i - 1, "x"));
}

TEST_CASE("A sweep shows a bar with its rate and the time left on a terminal") {
    if (shell("script -qec true /dev/null").status != 0)
        SKIP_CASE("`script` makes no terminal here: the bar is not tested");
    const Folder folder;
    const std::string file = folder.write(
        "grid.toml",
        grid("\"0.8 um\"", "\"40 um\"", "pressures = [ { from = \"1 MPa\", to = \"100 MPa\", count = 20000 } ]"));
    const Outcome shown = shell("export TERM=vt100; script -qec \"'" FSTIFF_COMMAND "' sweep '" + file + "' -o '" +
                                folder / "out" + "'\" /dev/null");
    INFO(shown.out);
    CHECK(shown.status == 0);
    CHECK(contains(shown.out, "scenes ["));
    CHECK(contains(shown.out, "/s, "));
    CHECK(contains(shown.out, " s left"));
}

TEST_CASE("Sensitivities are those of the draws, and a shard or a grid without draws has none") {
    const Folder folder;
    // K of greenwood_williamson at a separation is E D_p sqrt(R sigma) f(d/sigma): of R, D_p and E a product of powers
    const std::string text =
        replaced(replaced(grid("\"0.8 um\"", "{ lognormal = [\"40 um\", 0.4] }", "separations = [\"1 um\"]",
                               "[sweep]\nsamples = 5000\n", "\"greenwood_williamson\""),
                          "peak_density = \"500 /mm^2\"", "peak_density = { lognormal = [\"500 /mm^2\", 0.1] }"),
                 "youngs_modulus = \"205 GPa\"", "youngs_modulus = { lognormal = [\"205 GPa\", 0.2] }");
    const std::string file = folder.write("grid.toml", text);
    const std::string sweep = "sweep '" + file + "' -o '" + folder / "out" + "' --sensitivity";
    const Outcome outcome = run_fstiff(sweep);
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.status == 0);
    const auto all = lines(outcome.out);
    const auto header =
        std::find_if(all.begin(), all.end(), [](const std::string& line) { return contains(line, "K of"); });
    REQUIRE(header != all.end());
    CHECK(contains(*header, "S peak radius"));
    std::istringstream cells((header + 1)->substr((header + 1)->find("williamson") + 10));
    std::vector<double> found;
    for (double x = 0; cells >> x;) found.push_back(x);
    REQUIRE(found.size() == 7);
    const double spread[]{0.5 * 0.4, 0.1, 0.2};  // of ln K by R^(1/2), D_p and E
    double sum = 0, shares = 0;
    for (const double one : spread) sum += one * one;
    for (int i = 0; i < 3; ++i) {
        const double index = (std::exp(spread[i] * spread[i]) - 1) / (std::exp(sum) - 1);
        INFO("input " << i << ": " << found[static_cast<std::size_t>(2 * i)] << " for " << index);
        CHECK(std::abs(found[static_cast<std::size_t>(2 * i)] - index) < 3 / std::sqrt(5000.0));
        const double rho = 6 / 3.14159265358979 * std::asin(spread[i] / std::sqrt(sum) / 2);
        CHECK(std::abs(found[static_cast<std::size_t>(2 * i + 1)] - rho) < 3 / std::sqrt(5000.0));
        shares += found[static_cast<std::size_t>(2 * i)];
    }
    CHECK(std::abs(found[6] - (1 - shares)) < 2e-3);  // rounded to three digits
    const Outcome shard = run_fstiff(sweep + " --shard 1/2");
    CHECK(shard.status == 2);
    CHECK(contains(shard.err, "merge the shards first"));
    // their needs are reported before anything is computed
    const auto refused = [&](const std::string& from, const std::string& to, const std::string& view,
                             const std::string& sentence) {
        const std::string other = folder.write("other.toml", replaced(text, from, to));
        const Outcome early = run_fstiff("sweep '" + other + "' -o '" + folder / "none" + "' " + view);
        INFO(early.err);
        CHECK(early.status == 2);
        CHECK(contains(early.err, sentence));
        CHECK_FALSE(std::filesystem::exists(folder / "none"));
    };
    const std::string no_stiffness = "samples = 5000\n[output]\nquantities = [\"separation\"]\n";
    refused("samples = 5000", "samples = 2", "--sensitivity", "sweep.samples = 2 must be 3 or more");
    refused("samples = 5000\n", no_stiffness, "--sensitivity", "--sensitivity needs K; output.quantities must hold");
    refused("samples = 5000\n", no_stiffness, "--plot '" + folder / "none.svg" + "'", "--plot needs K");
    const std::string plain = folder.write("plain.toml", grid("[\"0.8 um\"]", "\"40 um\"", "pressures = [\"1 MPa\"]"));
    CHECK(run_fstiff("sweep '" + plain + "' -o '" + folder / "plain" + "' --sensitivity").status == 2);
}

TEST_CASE("Inputs that K does not depend on have no sensitivities, and the picture of the same call is drawn") {
    const Folder folder;
    const std::string file = folder.write(
        "grid.toml", replaced(grid("\"0.8 um\"", "\"40 um\"", "pressures = [ { values = [\"1 MPa\", \"10 MPa\"] } ]",
                                   "[sweep]\nsamples = 5\n"),
                              "yield_strength = \"400 MPa\"", "yield_strength = { lognormal = [\"400 MPa\", 0.1] }"));
    const Outcome outcome =
        run_fstiff("sweep '" + file + "' -o '" + folder / "out" + "' --sensitivity --plot '" + folder / "k.svg" + "'");
    INFO(outcome.err);
    CHECK(outcome.status == 4);
    CHECK(contains(outcome.err, "no K in it varies over 3 draws or more"));
    CHECK(contains(read(folder / "k.svg"), "<svg "));
    CHECK(contains(outcome.out, "fstiff sweep: "));
}

TEST_CASE("Results whose lines were damaged are not drawn, and go on where they are whole") {
    const Folder folder;
    const std::string file =
        folder.write("grid.toml", grid("[\"0.5 um\", \"1 um\", \"2 um\"]", "\"40 um\"", "pressures = [\"1 MPa\"]"));
    const std::string sweep = "sweep '" + file + "' -o '" + folder / "out" + "'";
    REQUIRE(run_fstiff(sweep).status == 0);
    const std::string whole = read(folder / "out"), known = read(folder / "out.sweep");
    std::string damaged = whole;
    damaged.replace(whole.find('\n') + 60, 8, "????????");
    folder.write("out", damaged);
    const Outcome drawn = run_fstiff(sweep + " --plot '" + folder / "k.svg" + "'");
    INFO(drawn.err);
    CHECK(drawn.status == 3);
    CHECK(contains(drawn.err, "out:2: is not a whole line of results"));
    CHECK_FALSE(std::filesystem::exists(folder / "k.svg"));
    const Outcome merged = run_fstiff("sweep --merge '" + folder / "out" + "' -o '" + folder / "all" + "'");
    CHECK(merged.status == 4);
    CHECK(contains(merged.err, "was changed since it was finished: whole up to scene 1 of 3"));
    folder.write("out.sweep", replaced(known, "\"finished\": true", "\"finished\": false"));
    const Outcome again = run_fstiff(sweep);
    CHECK(again.status == 0);
    CHECK(contains(again.err, "are computed again"));
    CHECK(read(folder / "out") == whole);
}

}  // namespace sweep_views_test
