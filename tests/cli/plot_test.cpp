// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

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

/// The place of \p x in \p curve, which is smooth: it has points between those of the scene.
std::size_t place_of(double x, const Drawn& curve) {
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (std::abs(curve.x[i] / x - 1) < 1e-12) return i;
    throw std::runtime_error("the curve has no such point");
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
    CHECK(drawn[0].x.size() > points);
    for (std::size_t law = 0; law < 3; ++law)
        for (std::size_t i = 0; i < points; ++i) {
            const std::size_t row = law * points + i, k = place_of(table.number(row, "pressure_Pa") / 1e6, drawn[law]);
            // the same doubles but for the division by the unit
            const auto same = [&](double found, const std::string& column, double unit) {
                INFO(column << " in row " << row);
                CHECK(std::abs(found * unit / table.number(row, column) - 1) < 1e-14);
            };
            same(drawn[law].y.at(k), "stiffness_Pa_per_m", unit_of_picture);
            same(drawn[law].low.at(k), "stiffness_p05_Pa_per_m", unit_of_picture);
            same(drawn[law].high.at(k), "stiffness_p95_Pa_per_m", unit_of_picture);
            same(drawn[4 + law].y.at(k), "reflection", 1);
            same(drawn[4 + law].low.at(k), "reflection_p05", 1);
            same(drawn[4 + law].high.at(k), "reflection_p95", 1);
        }
    CHECK(drawn[3].label == "linear law, elastic: p/(0.48 σ)");
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

TEST_CASE("run --plot writes the same picture twice") {
    const Folder folder;
    REQUIRE(run_fstiff("run --plot '" + folder / "one.svg" + "'").status == 0);
    REQUIRE(run_fstiff("run --plot '" + folder / "two.svg" + "'").status == 0);
    CHECK(read(folder / "one.svg") == read(folder / "two.svg"));
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
    // K from 1 to 1e6 kPa/um: its axis needs a power somewhere, so that 100 is one too
    CHECK(contains(picture, "text-anchor=\"end\">10²<"));
    CHECK_FALSE(contains(picture, "text-anchor=\"end\">100<"));
    // and 0 of |R| has the decimals of its neighbours
    CHECK(contains(picture, "text-anchor=\"end\">0.0<"));
    CHECK(contains(picture, "text-anchor=\"end\">0.2<"));
}

TEST_CASE("A few pressures are marked on smooth curves") {
    const Folder folder;
    const std::string picture =
        drawn(folder, replaced(read(scene_file), range, "pressures = [\"10 MPa\", \"10.01 MPa\", \"30 MPa\"]"));
    REQUIRE(plots(picture).size() == 2);
    for (const std::string& plot : plots(picture)) {
        CHECK(all_between(plot, "<circle", "/>").size() == 3 * 3);
        CHECK(all_between(plot, "<path class=\"band", "/>").size() == 3);
    }
    const auto all = curves(folder / "out.plot.csv");
    CHECK(all.at(0).x.size() == 41);
    CHECK(contains(picture, "text-anchor=\"middle\">10<"));
    CHECK(contains(picture, "text-anchor=\"middle\">20<"));
}

TEST_CASE("The law is marked where it changes") {
    const Folder folder;
    REQUIRE(run_fstiff("generate map --points 64 --spacing '1 um' --hurst 0.7 --rms '0.3 um' --shortest '6 um' -o '" +
                       folder / "map.txt" + "'")
                .status == 0);
    const std::string plot = plots(drawn(folder,
                                         "[surface]\nfrom = \"map.txt\"\n[material]\nupper = \"steel\"\n"
                                         "[contact]\npressures = [\"10 kPa\", \"100 MPa\"]\n"))
                                 .at(0);
    CHECK(all_between(plot, "<line class=\"line cn dot\"", "/>").size() == 1);
    CHECK(contains(plot, ">boundary_elements<"));
}

TEST_CASE("A title says what is shown, and one legend inside the frame names every line once") {
    const Folder folder;
    const std::string picture = drawn(folder, read(scene_file));
    CHECK(contains(picture, "class=\"title\">Contact stiffness: sand blasted (fine) on steel<"));
    CHECK(all_between(picture, "<g class=\"legend\"", "</g>").size() == 1);  // |R| has the same lines
    for (const char* name : {">answer (plastic)", ">hertz, theta", ">linear law, elastic: p/(0.48 σ)<"})
        CHECK(all_between(picture, name, "/text").size() == 1);
    const std::string frame = all_between(picture, "<rect class=\"frame\" ", "/>").at(0),
                      place = all_between(picture, "<g class=\"legend\" transform=\"translate(", ")").at(0),
                      veil = all_between(picture, "<rect class=\"veil\" ", "/>").at(0);
    const auto size = [](const std::string& rectangle, const std::string& of) {
        return std::stod(rectangle.substr(rectangle.find(" " + of + "=\"") + of.size() + 3));
    };
    const double x = std::stod(place), y = std::stod(place.substr(place.find(' ')));
    CHECK(x > 0);
    CHECK(y > 0);
    CHECK(x + size(veil, "width") < size(frame, "width"));
    CHECK(y + size(veil, "height") < size(frame, "height"));
    // no line and no band passes there: the legend is in the upper left corner
    for (const std::string& path : all_between(plots(picture).at(0), "<path class=\"", "/>")) {
        std::istringstream points(path.substr(path.find(" d=\"M") + 5));
        for (char letter = 'L'; letter == 'L'; points >> letter) {
            double at_x = 0, at_y = 0;
            points >> at_x >> at_y;
            CHECK((at_x > x + size(veil, "width") || at_y > y + size(veil, "height")));
        }
    }
    const std::string unnamed =
        drawn(folder, replaced(read(scene_file), "name = \"sand blasted (fine) on steel\"", ""));
    CHECK(contains(unnamed, "class=\"title\">Contact stiffness against pressure<"));
}

TEST_CASE("A short legend takes a free corner, and the frame stays as it is") {
    const Folder folder;
    const std::string scene =
        "[surface]\nSq = \"0.8 um\"\nSdq = 0.1\nskewness = 0\nkurtosis = 3\nalpha = 10\nhurst = 0.8\n"
        "[material]\nupper = { name = \"steel\", hardness = \"infinite\" }\n"
        "[contact]\npressures = [\"1 kPa\", \"100 MPa\"]\n";
    CHECK(contains(all_between(drawn(folder, scene), "<rect class=\"frame\" ", "/>").at(0), "height=\"360\""));
}

TEST_CASE("The conductance of the gap is in the panel of the contacts") {
    const Folder folder;
    const std::string picture = drawn(folder, read(FSTIFF_SCENES "/../examples/interface/heat_sink.toml"));
    CHECK(plots(picture).size() == 2);
    CHECK(contains(picture, ">Thermal conductance of the contacts and of the gap<"));
    CHECK(contains(picture, ">gap, answer (plastic)<"));
    const Csv table(run_fstiff("run '" + folder / "scene.toml" + "' --format csv").out);
    const auto all = curves(folder / "out.plot.csv");
    REQUIRE(all.size() >= 4);
    for (const auto& [label, column] : {std::pair("contacts, answer (plastic)", "thermal_conductance_W_per_m2K"),
                                        {"gap, answer (plastic)", "thermal_conductance_gap_W_per_m2K"}}) {
        const auto curve = std::find_if(all.begin(), all.end(), [&](const Drawn& one) { return one.label == label; });
        REQUIRE(curve != all.end());
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t k = place_of(table.number(i, "pressure_Pa") / 1e6, *curve);
            CHECK(std::abs(curve->y.at(k) / table.number(i, column) - 1) < 1e-12);
        }
    }
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
    CHECK(last - first > 0.3);  // the band of the answer, which the frame holds, is wide
}

TEST_CASE("Of many curves the first are drawn, and long names are broken", "[more]") {
    const Folder folder;
    std::string many = "peaks = [";
    for (int k = 1; k <= 10; ++k)
        many += std::string(k > 1 ? ", " : "") + "{ theta = \"pi/4\", r = 0.0" + std::to_string(k) + " }";
    std::string text =
        replaced(read(scene_file), "peaks     = [ { theta = \"pi/4\", r = \"exponential\" } ]", many + "]");
    std::string name;
    for (int k = 0; k < 40; ++k) name += "sample ";
    text = replaced(replaced(text, "sand blasted (fine) on steel", name + "end"), "count = 31", "count = 5");
    const std::string picture = drawn(folder, text);
    std::string note;
    for (const std::string& line : all_between(picture, "class=\"small\">", "<")) note += line + " ";
    CHECK(contains(note, "8 of 21 curves are drawn"));
    std::vector<std::string> looks = all_between(plots(picture).at(0), "<path class=\"line ", "\"");
    CHECK(looks.size() == 9);  // and p/(0.48 sigma)
    std::sort(looks.begin(), looks.end());
    looks.erase(std::unique(looks.begin(), looks.end()), looks.end());
    CHECK(looks.size() == 9);
    CHECK(std::stod(all_between(picture, "viewBox=\"0 0 ", " ").at(0)) < 1100);
    CHECK(all_between(picture, "class=\"title\">", "<").size() >= 3);
}

TEST_CASE("At one pressure the curves are marks with bars") {
    const Folder folder;
    const std::string picture = drawn(folder, replaced(read(scene_file), range, "pressures = [\"10 MPa\"]"));
    for (const std::string& plot : plots(picture)) {
        CHECK(all_between(plot, "<path class=\"bar ", "/>").size() == 3);
        CHECK(all_between(plot, "<path class=\"band", "/>").empty());
        CHECK(all_between(plot, "<circle", "/>").size() >= 3);
    }
    CHECK(contains(picture, "5\u00A0to\u00A095\u00A0%"));
    CHECK_FALSE(contains(picture, "± error"));
    const auto rows = curves(folder / "out.plot.csv");
    REQUIRE(rows.size() == 7);
    CHECK(rows[3].label == "linear law, elastic: p/(0.48 σ)");
    for (const auto& row : rows) CHECK(row.x == std::vector<double>{10});
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
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = place_of(truth.number(i, "pressure_Pa") / 1e6, curve);
        const double value = truth.number(i, "stiffness_Pa_per_m"), error = truth.number(i, "stiffness_error_Pa_per_m"),
                     unit = value / curve.y.at(k);
        CHECK(error > 1e-4 * value);
        CHECK(std::abs(curve.high.at(k) * unit / (value + error) - 1) < 1e-9);
        if (error < 0.9 * value) CHECK(std::abs(curve.low.at(k) * unit / (value - error) - 1) < 1e-9);
    }
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
