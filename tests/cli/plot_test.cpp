// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"

#include <cmath>
#include <map>
#include <numbers>

namespace plot_test {

using namespace test;

namespace {

/// The curves of a picture's CSV in the order of the file: label, then the points. Labels with commas are in quotes.
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

/// The same of bodies that never yield.
std::string elastic() {
    const std::string text = read(scene_file);
    const std::size_t second = text.find("[material.lower]");
    const auto never = [](const std::string& part) {
        return replaced(part, "poisson_ratio  = 0.3", "poisson_ratio = 0.3\nhardness = \"infinite\"");
    };
    return never(text.substr(0, second)) + never(text.substr(second));
}

}  // namespace

TEST_CASE("run --plot draws the numbers of run, their band, the reference line and the reflection") {
    const Folder folder;
    const Outcome outcome = run_fstiff("run '" + scene_file + "' --format csv --plot '" + folder / "out.svg" + "'");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    for (const char* name : {"out.svg", "out.plot.csv"}) CHECK(contains(outcome.err, name));
    CHECK(folder.files() == 2);

    const std::string picture = read(folder / "out.svg");
    const double unit_of_picture = contains(picture, "K/A₀ [GPa/µm]") ? 1e15 : 1e12;
    const Csv table(outcome.out);
    const auto drawn = curves(folder / "out.plot.csv");
    REQUIRE(drawn.size() == 7);  // K of the answer and of two laws, p/(0.48 sigma), R of the answer and of two laws
    CHECK(drawn[0].label.starts_with("answer ("));
    const std::size_t points = table.size() / 3;
    for (std::size_t law = 0; law < 3; ++law)
        for (std::size_t i = 0; i < points; ++i) {
            const std::size_t row = law * points + i;
            // the same doubles but for the division by the unit
            const auto same = [&](double found, const std::string& column, double unit) {
                INFO(column << " in row " << row);
                CHECK(std::abs(found * unit / table.number(row, column) - 1) < 1e-14);
            };
            same(drawn[law].x.at(i), "pressure_Pa", 1e6);
            same(drawn[law].y.at(i), "stiffness_Pa_per_m", unit_of_picture);
            same(drawn[law].low.at(i), "stiffness_p05_Pa_per_m", unit_of_picture);
            same(drawn[law].high.at(i), "stiffness_p95_Pa_per_m", unit_of_picture);
            same(drawn[4 + law].y.at(i), "reflection", 1);
            same(drawn[4 + law].low.at(i), "reflection_p05", 1);
            same(drawn[4 + law].high.at(i), "reflection_p95", 1);
        }
    CHECK(drawn[3].label == "p/(0.48 σ)");
    for (std::size_t i = 0; i < drawn[3].x.size(); ++i)
        CHECK(std::abs(drawn[3].y[i] * unit_of_picture * 0.48 * 0.832e-6 / (drawn[3].x[i] * 1e6) - 1) < 1e-14);

    // the window: K where (5.1) gives 0.99 and 0.1
    const double spring = std::numbers::pi * 1e6 * 7850 * 5900;  // omega z / 2
    const auto at = picture.find(" data-range=\"");
    REQUIRE(at != std::string::npos);
    const double low = std::stod(picture.substr(at + 13));
    const double high = std::stod(picture.substr(picture.find(' ', at + 13) + 1));
    CHECK(std::abs(low * unit_of_picture / (spring * std::sqrt(1 / (0.99 * 0.99) - 1)) - 1) < 1e-12);
    CHECK(std::abs(high * unit_of_picture / (spring * std::sqrt(1 / (0.1 * 0.1) - 1)) - 1) < 1e-12);

    CHECK(contains(picture, "prefers-color-scheme:dark"));
    CHECK_FALSE(contains(picture, "<script"));
    for (const char* label : {"nominal pressure p [MPa]", "K/A₀ [", "|R|"}) CHECK(contains(picture, label));
}

TEST_CASE("run --plot writes the same picture twice, and into a page") {
    const Folder folder;
    REQUIRE(run_fstiff("run --plot '" + folder / "one.svg" + "'").status == 0);
    REQUIRE(run_fstiff("run --plot '" + folder / "two.svg" + "'").status == 0);
    CHECK(read(folder / "one.svg") == read(folder / "two.svg"));
    REQUIRE(run_fstiff("run --plot '" + folder / "page.html" + "'").status == 0);
    CHECK(contains(read(folder / "page.html"), "<!doctype html>"));
    CHECK(contains(read(folder / "page.html"), "<svg"));
}

TEST_CASE("run --plot refuses other endings, folders that are not there, and a scene without stiffness") {
    const Folder folder;
    CHECK(run_fstiff("run --plot '" + folder / "out.png" + "'").status == 2);
    CHECK(run_fstiff("run --plot '" + folder / "none/out.svg" + "'").status == 3);
    std::string text = read(FSTIFF_SCENES "/sand_blasted_fine.toml");
    text = replaced(text, "quantities = [\"stiffness\", ", "quantities = [");
    const std::string scene = folder.write("scene.toml", text);
    const Outcome outcome = run_fstiff("run '" + scene + "' --plot '" + folder / "out.svg" + "'");
    CHECK(outcome.status == 3);
    CHECK(contains(outcome.err, "stiffness"));
    CHECK(folder.files() == 1);
}

namespace {

/// All texts between \p open and \p close.
std::vector<std::string> all_between(const std::string& text, const std::string& open, const std::string& close) {
    std::vector<std::string> found;
    for (auto at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
        at += open.size();
        found.push_back(text.substr(at, text.find(close, at) - at));
    }
    return found;
}

/// The parts of a picture that its frames cut out: one a panel.
std::vector<std::string> plots(const std::string& picture) {
    return all_between(picture, "overflow=\"hidden\">", "</svg>");
}

std::string drawn(const Folder& folder, const std::string& scene) {
    const std::string file = folder.write("scene.toml", scene);
    const Outcome outcome = run_fstiff("run '" + file + "' --plot '" + folder / "out.svg" + "'");
    INFO(outcome.err);
    REQUIRE((outcome.status == 0 || outcome.status == 4));
    return read(folder / "out.svg");
}

const std::string range = "pressures = { from = \"0.1 MPa\", to = \"100 MPa\", count = 31, spacing = \"log\" }";

}  // namespace

TEST_CASE("The numbers of an axis are powers of ten or plain, never both") {
    const Folder folder;
    const std::string picture = drawn(folder, replaced(elastic(), "from = \"0.1 MPa\"", "from = \"1 kPa\""));
    // K from 1 to 1e6 kPa/um: its axis needs a power somewhere, so that 10 is one too
    CHECK(contains(picture, "text-anchor=\"end\">10¹<"));
    CHECK_FALSE(contains(picture, "text-anchor=\"end\">10<"));
    // and 0 of |R| has the decimals of its neighbours
    CHECK(contains(picture, "text-anchor=\"end\">0.0<"));
    CHECK(contains(picture, "text-anchor=\"end\">0.2<"));
}

TEST_CASE("Two pressures that are close are drawn as points between numbers") {
    const Folder folder;
    const std::string picture =
        drawn(folder, replaced(read(scene_file), range, "pressures = [\"10 MPa\", \"10.01 MPa\"]"));
    REQUIRE(plots(picture).size() == 2);
    for (const std::string& plot : plots(picture)) CHECK(all_between(plot, "<circle", "/>").size() >= 2 * 3);
    // with error bars in place of a band, which would have no width
    for (const std::string& plot : plots(picture)) {
        CHECK(all_between(plot, "<path class=\"band", "/>").empty());
        CHECK(all_between(plot, "<path class=\"bar", "/>").size() == 3);
    }
    CHECK(contains(picture, "text-anchor=\"middle\">10<"));
    CHECK(contains(picture, "text-anchor=\"middle\">20<"));
}

TEST_CASE("No reflection is drawn on the frame") {
    const Folder folder;
    // 1 MHz and 0.1 MPa: |R| is 0.9987 and 0.9998; the frame of 240 has room above 1
    for (const std::string& path : all_between(plots(drawn(folder, read(scene_file))).at(1), " d=\"M", "L")) {
        INFO(path);
        CHECK(std::stod(path.substr(path.find(' '))) > 5);
    }
    // where all of them are close to 1 they fill the frame: 50 MHz gives 0.9996 to 0.99997 at 1 and 0.1 MPa
    const std::string text = replaced(replaced(read(scene_file), "1 MHz", "50 MHz"), "100 MPa", "1 MPa");
    const auto lines = all_between(plots(drawn(folder, text)).at(1), "<path class=\"line c2\" d=\"M", "\"");
    REQUIRE(lines.size() == 1);
    const double first = std::stod(lines[0].substr(lines[0].find(' '))),
                 last = std::stod(lines[0].substr(lines[0].rfind(' ')));
    CHECK(first > 5);
    CHECK(last < 235);
    CHECK(last - first > 0.5);  // the band of the answer, which the frame holds, is wide
}

TEST_CASE("Of many curves a few distinguishable ones are drawn, and long names are broken") {
    const Folder folder;
    std::string many = "peaks = [";
    for (int k = 1; k <= 10; ++k)
        many += std::string(k > 1 ? ", " : "") + "{ theta = \"pi/4\", r = 0.0" + std::to_string(k) + " }";
    std::string text =
        replaced(read(scene_file), "peaks     = [ { theta = \"pi/4\", r = \"exponential\" } ]", many + "]");
    std::string name;
    for (int k = 0; k < 40; ++k) name += "sample ";
    text = replaced(replaced(text, "sand blasted (fine) on steel", name + "end"), "0.010", "0.1");
    const std::string picture = drawn(folder, text);
    CHECK(contains(picture, "7 of 21 curves are drawn"));
    std::vector<std::string> looks = all_between(plots(picture).at(0), "<path class=\"line ", "\"");
    CHECK(looks.size() == 8);  // and p/(0.48 sigma)
    // the legend names overlapping curves, which these nearly are
    CHECK(contains(picture, "(lies on"));
    CHECK(contains(picture, " wide"));
    for (std::string& look : looks) look = look.substr(0, look.find(" wide"));
    std::sort(looks.begin(), looks.end());
    looks.erase(std::unique(looks.begin(), looks.end()), looks.end());
    CHECK(looks.size() == 8);
    CHECK(std::stod(all_between(picture, "viewBox=\"0 0 ", " ").at(0)) < 1100);
    CHECK(all_between(picture, "class=\"title\">", "<").size() >= 3);
}

TEST_CASE("At one pressure the curves are next to one another with their error bars") {
    const Folder folder;
    std::string text = replaced(read(scene_file), range, "pressures = [\"10 MPa\"]");
    text = replaced(text, "peaks     = [ { theta = \"pi/4\", r = \"exponential\" } ]",
                    "peaks = [ { theta = \"pi/4\", r = \"exponential\" }, { theta = \"pi/3\", r = \"exponential\" } ]");
    const std::string picture = drawn(folder, text), plot = plots(picture).at(0);
    std::vector<double> places;
    for (const std::string& bar : all_between(plot, "<path class=\"bar ", "/>")) {
        INFO(bar);
        // M <left> <high> h8 M <x> <high> V <low> ...
        const double high = std::stod(bar.substr(bar.find(' ', bar.find("d=\"M")))),
                     low = std::stod(bar.substr(bar.find('V') + 1));
        CHECK(low - high > 10);  // pixels
        places.push_back(std::stod(bar.substr(bar.find("d=\"M") + 4)));
    }
    REQUIRE(places.size() == 5);
    for (std::size_t k = 1; k < places.size(); ++k) CHECK(places[k] - places[k - 1] > 8);
    // a mark for each distribution of peaks, as in the legend, and the linear law
    CHECK(all_between(plot, "<circle", "/>").size() + all_between(plot, "<polygon", "/>").size() == 6);
    CHECK(contains(picture, "p/(0.48 σ)"));
    const auto rows = curves(folder / "out.plot.csv");
    REQUIRE(rows.size() == 6 + 5);
    CHECK(rows[5].label == "p/(0.48 σ)");
    CHECK(std::abs(rows[5].y.at(0) * 1e15 * 0.48 * 0.832e-6 / 10e6 - 1) < 1e-14);
    for (const auto& row : rows) CHECK(row.x == std::vector<double>{10});  // the numbers stay where they are
}

TEST_CASE("Of many laws the same distributions of peaks are drawn, one stroke for each, and hidden ones are named") {
    const Folder folder;
    std::string text = read(FSTIFF_SCENES "/sand_blasted_fine.toml");
    const std::string laws = "laws         = [\"fractal\", \"hertz\", \"greenwood_williamson\"]";
    text = replaced(text, laws,
                    "laws = [\"fractal\", \"hertz\", \"greenwood_williamson\", \"plastic_peaks\", \"jackson_green\", "
                    "\"kogut_etsion\"]");
    const std::string picture = drawn(folder, text);
    CHECK(contains(picture, "7 of 12 curves are drawn"));
    for (const auto& curve : curves(folder / "out.plot.csv")) CHECK_FALSE(contains(curve.label, "π/3"));
    for (const std::string& look : all_between(plots(picture).at(0), "<path class=\"line c", "\"")) {
        INFO(look);
        CHECK((look == "n dash" || !contains(look, "da")));
    }
    CHECK(contains(picture, "greenwood_williamson (lies on hertz"));
    // four laws have room for both distributions: dashes are the second one, whatever lies on whatever
    text = replaced(text, ", \"jackson_green\", \"kogut_etsion\"", "");
    CHECK_FALSE(contains(drawn(folder, text), "curves are drawn"));
    const auto four = curves(folder / "out.plot.csv");
    const auto looks = all_between(plots(read(folder / "out.svg")).at(0), "<path class=\"line ", "\"");
    REQUIRE(looks.size() == four.size());
    for (std::size_t k = 0; k + 1 < looks.size(); ++k) {
        INFO(four[k].label << ": " << looks[k]);
        CHECK(contains(looks[k], "dash") == contains(four[k].label, "π/3"));
    }
}

TEST_CASE("The picture has the short explanation") {
    const Folder folder;
    const auto brief = [](const std::string& picture) {
        std::string all;
        for (const std::string& line : all_between(picture, "class=\"brief\">", "<")) all += line + " ";
        return all;
    };
    const std::string steel = brief(drawn(folder, read(FSTIFF_SCENES "/sand_blasted_fine.toml")));
    CHECK(contains(steel, "The peaks yield: K is that of unloading."));
    CHECK(steel.size() < 220);
    CHECK(brief(drawn(folder, elastic())) == "Taken as elastic. ");
}

TEST_CASE("The curve of boundary elements has the error that truth gives") {
    const Folder folder;
    REQUIRE(run_fstiff("generate map --points 32 --spacing '1 um' --hurst 0.7 --rms '0.3 um' --shortest '6 um' -o '" +
                       folder / "map.txt" + "'")
                .status == 0);
    const std::string scene =
        "[surface]\nfrom = \"map.txt\"\n[material.upper]\nyoungs_modulus = \"205 GPa\"\n"
        "poisson_ratio = 0.3\n[contact]\nlaws = [\"boundary_elements\"]\n"
        "pressures = [\"10 MPa\", \"100 MPa\", \"300 MPa\"]\n";
    const std::string plot = plots(drawn(folder, scene)).at(0);
    CHECK(all_between(plot, "<path class=\"bar ", "/>").size() == 1);
    const auto curve = curves(folder / "out.plot.csv").at(1);  // below that of the answer
    CHECK(curve.label == "boundary_elements");
    const Csv truth(
        run_fstiff("truth '" + folder / "map.txt" + "' --pressures '10 MPa,100 MPa,300 MPa' --format csv").out);
    REQUIRE(curve.low.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = truth.number(i, "stiffness_Pa_per_m"), error = truth.number(i, "stiffness_error_Pa_per_m"),
                     unit = value / curve.y.at(i);
        CHECK(error > 1e-4 * value);
        CHECK(std::abs(curve.high.at(i) * unit / (value + error) - 1) < 1e-9);
        if (error < 0.9 * value) CHECK(std::abs(curve.low.at(i) * unit / (value - error) - 1) < 1e-9);
    }
}

TEST_CASE("A page of one picture can be read on a telephone") {
    const Folder folder;
    REQUIRE(run_fstiff("run '" + scene_file + "' --plot '" + folder / "k.html" + "'").status == 0);
    const std::string page = read(folder / "k.html");
    CHECK(contains(page, "content=\"width=device-width\""));
    // letters of 16 pixels in a picture so narrow that 390 pixels show them with 10 at least
    CHECK(contains(page, "@media screen and (max-width:40rem)"));
    CHECK(16 * 368 / std::stod(all_between(page, "viewBox=\"0 0 ", " ").at(0)) > 10);
    CHECK(contains(page, "<h1>Contact stiffness: sand blasted (fine) on steel</h1>"));
}

TEST_CASE("The axes of a picture are in the unit that fits") {
    const Folder folder;
    // a light touch: pressures of kPa, stiffness of kPa/um
    std::string text =
        replaced(read(scene_file), "from = \"0.1 MPa\", to = \"100 MPa\"", "from = \"0.1 kPa\", to = \"10 kPa\"");
    const std::string picture = drawn(folder, text);
    CHECK(contains(picture, "nominal pressure p [kPa]"));
    CHECK(contains(picture, "K/A₀ [kPa/µm]"));
    const auto first = curves(folder / "out.plot.csv").at(0);
    const Csv run(run_fstiff("run '" + folder / "scene.toml" + "' --format csv").out);
    CHECK(std::abs(first.x.at(0) * 1e3 / run.number(0, "pressure_Pa") - 1) < 1e-14);
    CHECK(std::abs(first.y.at(0) * 1e9 / run.number(0, "stiffness_Pa_per_m") - 1) < 1e-14);
}

}  // namespace plot_test
