// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"
#include "support/skip.hpp"

#include <cmath>
#include <map>
#include <numbers>

using namespace test;

namespace {

/// The curves of a picture's CSV in the order of the file: label, then the points. Labels with commas stand in quotes.
struct Drawn {
    std::string label;
    std::vector<double> x, y, low, high;
};
std::vector<Drawn> curves(const std::string& file) {
    std::vector<Drawn> result;
    std::string last;
    const auto rows = lines(read(file));
    for (std::size_t i = 2; i < rows.size(); ++i) {  // after the mark and the header
        const auto cells = csv_cells(rows[i]);
        if (cells.at(0) != last) result.push_back({cells.at(2), {}, {}, {}, {}});
        last = cells.at(0);
        result.back().x.push_back(std::stod(cells.at(4)));
        result.back().y.push_back(std::stod(cells.at(6)));
        if (!cells.at(7).empty()) result.back().low.push_back(std::stod(cells.at(7)));
        if (!cells.at(8).empty()) result.back().high.push_back(std::stod(cells.at(8)));
    }
    return result;
}

const std::string scene_file = FSTIFF_SCENES "/../docs/stiffness.toml";

}  // namespace

TEST_CASE("run --plot draws the numbers of run, their band, the reference line and the reflection") {
    const Folder folder;
    const Outcome outcome = fstiff("run '" + scene_file + "' --format csv --plot '" + folder / "out.svg" + "'");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    for (const char* name : {"out.svg", "out.plot.csv", "out.plot.gp"}) CHECK(contains(outcome.err, name));
    CHECK(folder.files() == 3);

    const Csv table(outcome.out);
    const auto drawn = curves(folder / "out.plot.csv");
    REQUIRE(drawn.size() == 5);  // K of two laws, p/(0.48 sigma), R of two laws
    const std::size_t points = table.size() / 2;
    for (std::size_t law = 0; law < 2; ++law)
        for (std::size_t i = 0; i < points; ++i) {
            const std::size_t row = law * points + i;
            // the same doubles but for the division by the unit
            const auto same = [&](double found, const std::string& column, double unit) {
                INFO(column << " in row " << row);
                CHECK(std::abs(found * unit / table.number(row, column) - 1) < 1e-14);
            };
            same(drawn[law].x.at(i), "pressure_Pa", 1e6);
            same(drawn[law].y.at(i), "stiffness_Pa_per_m", 1e15);
            same(drawn[law].low.at(i), "stiffness_p05_Pa_per_m", 1e15);
            same(drawn[law].high.at(i), "stiffness_p95_Pa_per_m", 1e15);
            same(drawn[3 + law].y.at(i), "reflection", 1);
            same(drawn[3 + law].low.at(i), "reflection_p05", 1);
            same(drawn[3 + law].high.at(i), "reflection_p95", 1);
        }
    CHECK(drawn[2].label == "p/(0.48 σ)");
    for (std::size_t i = 0; i < drawn[2].x.size(); ++i)
        CHECK(std::abs(drawn[2].y[i] * 1e15 * 0.48 * 0.832e-6 / (drawn[2].x[i] * 1e6) - 1) < 1e-14);

    // the window: K where (5.1) gives 0.99 and 0.1
    const double spring = std::numbers::pi * 1e6 * 7850 * 5900;  // omega z / 2
    const std::string script = read(folder / "out.plot.gp");
    const auto at = script.find("from graph 0,first ");
    REQUIRE(at != std::string::npos);
    const double low = std::stod(script.substr(at + 19));
    const double high = std::stod(script.substr(script.find("to graph 1,first ", at) + 17));
    CHECK(std::abs(low * 1e15 / (spring * std::sqrt(1 / (0.99 * 0.99) - 1)) - 1) < 1e-12);
    CHECK(std::abs(high * 1e15 / (spring * std::sqrt(1 / (0.1 * 0.1) - 1)) - 1) < 1e-12);

    const std::string picture = read(folder / "out.svg");
    CHECK(contains(picture, "prefers-color-scheme:dark"));
    CHECK_FALSE(contains(picture, "<script"));
    for (const char* label : {"nominal pressure p [MPa]", "K/A₀ [GPa/µm]", "|R|"}) CHECK(contains(picture, label));

    if (shell("command -v gnuplot").status != 0) SKIP_CASE("there is no gnuplot: its script is not run");
    const Outcome gnuplot = shell("cd '" + folder / "" + "' && gnuplot out.plot.gp");
    CHECK(gnuplot.status == 0);
    CHECK(gnuplot.err.empty());
    CHECK(contains(read(folder / "out-gnuplot.svg"), "<path"));
}

TEST_CASE("run --plot writes the same picture twice, and into a page") {
    const Folder folder;
    REQUIRE(fstiff("run --plot '" + folder / "one.svg" + "'").status == 0);
    REQUIRE(fstiff("run --plot '" + folder / "two.svg" + "'").status == 0);
    CHECK(read(folder / "one.svg") == read(folder / "two.svg"));
    REQUIRE(fstiff("run --plot '" + folder / "page.html" + "'").status == 0);
    CHECK(contains(read(folder / "page.html"), "<!doctype html>"));
    CHECK(contains(read(folder / "page.html"), "<svg"));
}

TEST_CASE("run --plot refuses other endings, folders that are not there, and a scene without stiffness") {
    const Folder folder;
    CHECK(fstiff("run --plot '" + folder / "out.png" + "'").status == 2);
    CHECK(fstiff("run --plot '" + folder / "none/out.svg" + "'").status == 3);
    std::string text = read(FSTIFF_SCENES "/sand_blasted_fine.toml");
    text = replaced(text, "quantities = [\"stiffness\", ", "quantities = [");
    const std::string scene = folder.write("scene.toml", text);
    const Outcome outcome = fstiff("run '" + scene + "' --plot '" + folder / "out.svg" + "'");
    CHECK(outcome.status == 3);
    CHECK(contains(outcome.err, "stiffness"));
    CHECK(folder.files() == 1);
}
