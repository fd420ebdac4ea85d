// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"
#include "support/paper.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <numbers>

namespace reproduce_test {

using namespace test;
using Json = nlohmann::json;

namespace {

constexpr double pi = std::numbers::pi;

/// The points of a picture's CSV: panel and label of the curve, then y at x. Cells with commas are in quotes.
using Curves = std::map<std::pair<int, std::string>, std::map<double, double>>;
Curves curves(const std::string& file) {
    Curves result;
    const auto rows = lines(read(file));
    for (std::size_t i = 2; i < rows.size(); ++i) {  // after the mark and the header
        const auto cells = csv_cells(rows[i]);
        result[{std::stoi(cells.at(1)), cells.at(2)}][std::stod(cells.at(4))] = std::stod(cells.at(6));
    }
    return result;
}

double at(const std::map<double, double>& curve, double x) {
    const auto after = curve.lower_bound(x * (1 - 1e-9));
    if (after == curve.end() || after->first > x * (1 + 1e-9)) throw std::runtime_error("the curve has no such point");
    return after->second;
}

/// Integral of f from a to b by the trapezoidal rule after t = tanh-like substitution: slow, and without the
/// library.
template <class F>
double integral(double a, double b, const F& f) {
    double sum = 0;
    constexpr int n = 400;
    for (int k = -n; k <= n; ++k) {
        const double u = 4.0 * k / n, s = std::sinh(u), w = pi / 2 * std::cosh(u) / std::pow(std::cosh(pi / 2 * s), 2);
        const double x = (a + b) / 2 + (b - a) / 2 * std::tanh(pi / 2 * s);
        if (x > a && x < b) sum += w * f(x);
    }
    return sum * (b - a) / 2 * 4.0 / n;
}

using Surface = test::PaperSurface;
constexpr double modulus = paper_modulus;

/// K of Greenwood and Williamson at a pressure, by bisection of the separation.
double classic(const Surface& s, double pressure) {
    const auto mean = [&](double eta, double power) {
        return integral(eta, eta + 12,
                        [&](double z) { return std::pow(z - eta, power) * std::exp(-z * z / 2) / std::sqrt(2 * pi); });
    };
    double low = -2, high = 6;
    for (int k = 0; k < 60; ++k) {
        const double eta = (low + high) / 2;
        const double p = 4.0 / 3 * modulus * s.peak_density * std::sqrt(s.peak_radius) * std::pow(s.rms_height, 1.5) *
                         mean(eta, 1.5);
        (p > pressure ? low : high) = eta;
    }
    return 2 * modulus * s.peak_density * std::sqrt(s.peak_radius * s.rms_height) * mean(low, 0.5);
}

}  // namespace

TEST_CASE("reproduce writes every figure three times, a page that holds them, and the errata") {
    const Folder folder;
    const Outcome outcome = test::run_fstiff("reproduce -o '" + folder / "paper" + "'");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const std::string page = read(folder / "paper/index.html");
    for (const char* figure : {"fig2", "fig4", "fig6", "fig7", "fig8", "fig9"}) {
        INFO(figure);
        const std::string stem = folder / ("paper/" + std::string(figure));
        const std::string picture = read(stem + ".svg");
        CHECK(contains(picture, "<path"));
        CHECK(contains(page, picture));
        CHECK(lines(read(stem + ".plot.csv")).size() > 20);
    }
    // nothing is fetched: no address but the names of the SVG elements, no script
    CHECK_FALSE(contains(page, "<script"));
    CHECK_FALSE(contains(page, "src=\"http"));
    CHECK_FALSE(contains(page, "href"));

    const std::string errata = read(FSTIFF_SCENES "/../docs/errata.md");
    CHECK(read(folder / "paper/errata.md").ends_with("-->\n" + errata));
    std::size_t titles = 0;
    for (const std::string& line : lines(errata))
        if (line.rfind("### ", 0) == 0) {
            ++titles;
            CHECK(contains(outcome.out, line.substr(4)));
        }
    CHECK(titles > 15);
    for (const std::string* text : {&outcome.out, &page}) CHECK(contains(*text, "Experimental points are not drawn"));

    std::size_t results = 0;
    for (const std::string& line : lines(outcome.out)) results += contains(line, "  result: ");
    CHECK(results == 3);
    CHECK(contains(outcome.out, "result: not testable: only that the models differ by a constant factor"));
    CHECK(contains(outcome.out, "result: holds at equal pressure, not at equal separation"));
    CHECK(contains(outcome.out, "result: half: it grows with the load, but is largest on the smoothest surface"));
}

TEST_CASE("The curves of Figs. 7, 8 and 9 are those of the table of arbitrary precision") {
    const Folder folder;
    REQUIRE(test::run_fstiff("reproduce -o '" + folder / "paper" + "'").status == 0);
    const Csv table(read(FSTIFF_TEST_DATA "/table1_curves.csv"));
    for (const Surface& s : paper_surfaces) {
        const Curves drawn = curves(folder / ("paper/" + std::string(s.figure) + ".plot.csv"));
        int compared = 0;
        for (std::size_t i = 0; i < table.size(); ++i) {
            if (table.text(i, "surface") != s.key) continue;
            const double theta = table.number(i, "theta"), r = table.number(i, "r");
            const bool quarter = std::abs(theta - pi / 4) < 1e-9 && r == 0;
            const bool third = std::abs(theta - pi / 3) < 1e-9 && std::abs(r * r - 2.0 / 3) < 1e-9;
            const double p = table.number(i, "pressure_Pa") / 1e6;
            if ((!quarter && !third) || std::abs(std::log10(p) - std::round(std::log10(p))) > 1e-9) continue;
            const auto check = [&](const std::string& label, const char* column) {
                INFO(s.name << ", " << label << " at " << p << " MPa");
                const double expected = table.number(i, column) / 1e15;
                // the table has 11 digits
                CHECK(std::abs(at(drawn.at({1, label}), p) / expected - 1) < 1e-10);
                ++compared;
            };
            check(quarter ? "fractal, θ = π/4" : "fractal, θ = π/3", "stiffness_fractal_Pa_per_m");
            if (quarter) check("statistical elastic, θ = π/4", "stiffness_hertz_Pa_per_m");
        }
        CHECK(compared == 12);
        const Csv flowing(read(FSTIFF_TEST_DATA "/plastic_curves.csv"));
        compared = 0;
        for (std::size_t i = 0; i < flowing.size(); ++i) {
            const std::string law = flowing.text(i, "law"), surface = flowing.text(i, "surface");
            const double p = flowing.number(i, "pressure_Pa") / 1e6;
            const bool drawn_point = std::abs(std::log10(p) - std::round(std::log10(p))) < 1e-9;
            if (!surface.starts_with(s.key) || flowing.number(i, "r") != 0 || !drawn_point ||
                (law != "plastic" && law != "jackson_green"))
                continue;
            INFO(surface << ", " << law << " at " << p << " MPa");
            const double expected = flowing.number(i, "unloading_stiffness_Pa_per_m") / 1e15;
            const double found = at(drawn.at({1, "plastic peaks (not in the paper): " + law}), p);
            CHECK(std::abs(found / expected - 1) < 1e-8);  // the table has 9 digits
            ++compared;
        }
        CHECK(compared == 8);
        for (const double p : {0.1, 1.0, 100.0}) {
            INFO(s.name << ", Greenwood-Williamson at " << p << " MPa");
            CHECK(std::abs(at(drawn.at({1, "Greenwood-Williamson"}), p) * 1e15 / classic(s, p * 1e6) - 1) < 1e-8);
        }
        // (4.11) adds the compliance of the layer: 1/K_with = 1/K_without + L/E for the elastic law, where K = -dp/dd
        for (const double p : {1.0, 100.0}) {
            const double alone = at(drawn.at({1, "statistical elastic, θ = π/4"}), p) * 1e15;
            const double with = at(drawn.at({2, "statistical elastic, θ = π/4"}), p) * 1e15;
            CHECK(std::abs(with * (1 / alone + std::sqrt(195e-6) / modulus) - 1) < 1e-9);
        }
    }
}

TEST_CASE("Fig. 2 is the density (4.4) integrated over the curvature") {
    const Folder folder;
    REQUIRE(test::run_fstiff("reproduce -o '" + folder / "paper" + "'").status == 0);
    const Curves drawn = curves(folder / "paper/fig2.plot.csv");
    const double theta = pi / 3;
    for (const auto& [label, r] : {std::pair{"r = 1/2", 0.5}, {"r = 1/3", 1.0 / 3}, {"r = 1/5", 0.2}})
        for (const double z : {-1.0, 0.5, 2.0}) {
            INFO(label << ", height " << z);
            const double expected = integral(0.0, 12.0, [&, r = r](double t) {
                return std::exp(-(z * z + t * t - 2 * r * z * t) / (2 * (1 - r * r))) /
                       (2 * theta * std::sqrt(2 * pi * (1 - r * r))) * std::sqrt(2 * pi) *
                       std::erf(t * std::tan(theta) / std::sqrt(2.0));
            });
            double found = -1;
            for (const auto& [x, y] : drawn.at({1, label}))
                if (std::abs(x - z) < 1e-9) found = y;
            CHECK(std::abs(found - expected) < 1e-10);
        }
}

TEST_CASE("Fig. 6 shows what was fitted, and Fig. 4 holds the radii at the level with the most islands") {
    const Folder folder;
    REQUIRE(test::run_fstiff("reproduce -o '" + folder / "paper" + "'").status == 0);
    const Curves six = curves(folder / "paper/fig6.plot.csv");
    const auto &points = six.at({1, "S₂ of its second differences"}),
               &fitted = six.at({1, "what is fitted to S₂, with D and G"});
    std::size_t both = 0;
    for (const auto& [lag, value] : points) {
        if (!fitted.contains(lag)) continue;
        INFO("lag " << lag << " µm");
        CHECK(std::abs(value / fitted.at(lag) - 1) < 0.1);
        ++both;
    }
    CHECK(both > 8);
    const auto &first = six.at({1, "S of the profile, eq. (2.8)"}),
               &expected = six.at({1, "S of the cosines that were summed"});
    for (const auto& [lag, value] : first)
        if (lag < 30) CHECK(std::abs(value / at(expected, lag) - 1) < 0.1);

    const Curves four = curves(folder / "paper/fig4.plot.csv");
    const std::string picture = read(folder / "paper/fig4.svg");
    const auto range = picture.rfind(" data-y=\"") + 9;
    const double low = std::stod(picture.substr(range)), high = std::stod(picture.substr(picture.find(' ', range) + 1));
    for (const auto& [key, curve] : four)
        if (key.first == 2)
            for (const auto& [share, radius] : curve)
                if (share < 45) CHECK((radius > low && radius < high));
    // the curves that lie on one another are named, and dashes mean θ = π/3 alone
    const std::string seven = read(folder / "paper/fig7.svg");
    CHECK(contains(seven, "(lies on statistical"));
    CHECK(contains(seven, "class=\"line c0 dash"));
    for (const char* solid : {"c1 dash", "c2 dash", "c3 dash", "c4 dash"})
        CHECK_FALSE(contains(seven, std::string("class=\"line ") + solid));
    const std::string page = read(folder / "paper/index.html");
    CHECK_FALSE(contains(page, "<th></th>"));
    CHECK(contains(page, "<th>G [nm]</th>"));
}

TEST_CASE("The numbers for the conclusions are the known ones") {
    const Folder folder;
    const Outcome outcome = test::run_fstiff("reproduce --format json -o '" + folder / "paper" + "'");
    REQUIRE(outcome.status == 0);
    const Json document = Json::parse(outcome.out);
    std::map<std::string, std::map<std::string, std::pair<double, double>>> found;
    for (const Json& conclusion : document.at("conclusions"))
        for (const Json& n : conclusion.at("numbers"))
            found[n.at("key")][n.at("surface")] = {n.at("least"), n.at("greatest")};
    // found with mpmath, rounded as here: the tolerance is half a unit of the last digit
    const std::map<std::string, std::vector<std::pair<double, double>>> known{
        {"fractal_over_greenwood_williamson", {{2.47, 2.58}, {2.29, 2.35}, {2.93, 3.00}}},
        {"theta_at_equal_pressure", {{1.06, 1.18}, {1.05, 1.14}, {1.05, 1.14}}},
        {"theta_at_equal_separation", {{1.68, 2.14}, {1.68, 2.14}, {1.68, 2.14}}}};
    for (std::size_t i = 0; i < 3; ++i) {
        const Surface& s = paper_surfaces[i];
        INFO(s.name);
        for (const auto& [key, bounds] : known) {
            INFO(key);
            CHECK(std::abs(found.at(key).at(s.name).first - bounds[i].first) < 0.0051);
            CHECK(std::abs(found.at(key).at(s.name).second - bounds[i].second) < 0.0051);
        }
        const double dimension = std::vector{1.62, 1.58, 1.70}[i], factor = 2.0 / 3 * (3 - dimension) / (2 - dimension);
        CHECK(std::abs(found.at("fractal_over_elastic").at(s.name).first / factor - 1) < 1e-12);
        CHECK(std::abs(found.at("fractal_over_elastic").at(s.name).second / factor - 1) < 1e-12);
        const double shift = 1e8 * std::sqrt(195e-6) / (modulus * s.rms_height);
        CHECK(std::abs(found.at("interaction_shift").at(s.name).second / shift - 1) < 1e-12);
    }
    CHECK(document.at("generated").size() == 19);
    CHECK(document.at("files").size() == 14);
}

TEST_CASE("reproduce gives the same files twice, and refuses an output that is not a folder") {
    const Folder folder;
    REQUIRE(test::run_fstiff("reproduce -o '" + folder / "one" + "'").status == 0);
    REQUIRE(test::run_fstiff("reproduce -o '" + folder / "two" + "'").status == 0);
    for (const auto& entry : std::filesystem::directory_iterator(folder / "one")) {
        const std::string name = entry.path().filename().string();
        INFO(name);
        CHECK(read(folder / ("one/" + name)) == read(folder / ("two/" + name)));
    }
    const std::string file = folder.write("file", "text");
    const Outcome refused = test::run_fstiff("reproduce -o '" + file + "'");
    CHECK(refused.status == 3);
    CHECK(contains(refused.err, "is not a folder"));
    CHECK(test::run_fstiff("reproduce").status == 2);
}

}  // namespace reproduce_test
