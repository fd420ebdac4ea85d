// SPDX-License-Identifier: BSD-3-Clause
// Scenes that would overflow the stack, cut a message or leave the range of double precision are refused by a sentence.
#include "support/library.hpp"

#include "sweep/grid.hpp"

#include <algorithm>
#include <ctime>

namespace unsafe_scene_test {

namespace {

const std::string contact = "[material]\nupper = \"steel\"\n[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\n";
const std::string good = "[surface]\nSq = \"0.8 um\"\nSdq = 0.15\n" + contact;

std::string repeated(const std::string& part, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += part;
    return text;
}

void check_both_refuse(const std::string& text, const std::vector<std::string>& parts) {
    test::check_sentence(test::refused_scene(text), parts);
    test::check_sentence(test::refusal([&] { (void)fstiff::sweep::read_grid(text, "scene.toml"); }), parts);
}

}  // namespace

TEST_CASE("Tables and lists without end are refused before they take the stack") {
    const std::vector<std::string> parts{"scene.toml:", "more than 100 levels deep"};
    for (const std::size_t n : {120u, 100000u}) {
        const std::string deep = repeated("a.", n) + "a";
        for (const std::string& text :
             {"[" + deep + "]\n", "[[" + deep + "]]\n", deep + " = 1\n", "x = {" + deep + " = 1}\n",
              "[surface]\n" + deep + " = \"1 um\"\n", "x = [{" + deep + "=1}]\n", repeated("\"a\" . ", n) + "a = 1\n",
              repeated("'a'.", n) + "a = 1\n", "x = \"\"\"\"a\"\"\"\"\ny = {z = ''''a'''', " + deep + " = 1}\n",
              "x = \"\\\\\"\n" + deep + " = 1\n", "x = " + repeated("[", n) + repeated("]", n) + "\n",
              "x = " + repeated("{a.a = ", n) + "1" + repeated("}", n) + "\n",
              "x = [\n# [\n" + repeated("{a=[\n", n) + repeated("]}", n) + "]\n"}) {
            INFO(text.substr(0, 80));
            check_both_refuse(text, parts);
        }
    }
    // what is nested by little more than half of that on both sides of a header is still read
    const std::string half = repeated("a.", 45) + "a";
    CHECK(test::contains(test::refused_scene("[" + half + "]\n" + half + " = {" + half + " = 1}\n"), "a: unknown key"));
}

TEST_CASE("Points and brackets of valid TOML are no levels") {
    const std::string dots = repeated("1.5 ", 300), brackets = repeated("[{.", 300);
    const std::string numbers = "skewness = -0.25\nkurtosis = 3.5\n# " + dots + brackets + "\n";
    std::string listed = "pressures = [";
    for (int i = 0; i < 300; ++i) listed += (i > 0 ? ",\n  " : "") + std::string("\"1.5 MPa\"");
    const std::string text = test::replaced(good, "Sdq = 0.15\n", "Sdq = 0.15\n" + numbers) +
                             "[output]\nquantities = [\n\"stiffness\",\n]\n";
    const auto with_name = [&](const std::string& name) { return "name = " + name + "\n" + text; };
    const std::string plain = test::csv_of(test::results_of(text));
    for (const std::string& name :
         {"\"" + dots + "\"", "'" + brackets + "'", "\"\"\"" + dots + "\n" + brackets + "\\\" \"\" \"\"\"",
          "'''\n" + brackets + "\n''" + dots + "'''", "\"\"\"" + dots + "\"\"\"\"\"", "\"#\" # \"" + dots}) {
        INFO(name.substr(0, 60));
        CHECK(test::csv_of(test::results_of(with_name(name))) == plain);
    }
    CHECK(test::results_of(test::replaced(good, "pressures = [\"1 MPa\", \"10 MPa\"]", listed + "]"))
              .answer.points.size() == 300);
    const auto grid = fstiff::sweep::read_grid(
        test::replaced(good, "0.15", "[0.1, 0.12, 0.15]\nprocess . values = [ 'ground', \"turned\" ]"), "g.toml");
    CHECK(grid.size == 6);
    // a text that is no TOML keeps its own refusal: a table of numbers, a list of contents
    for (const std::string& other : {repeated("0.1 0.2 0.3 ", 200) + "\n", "Contents " + repeated(".", 300) + " 1\n"})
        CHECK(test::contains(test::refused_scene(other), "scene.toml:1: is not valid TOML"));
}

TEST_CASE("The escape of U+0000 is refused, which would cut a message") {
    for (const char* nul : {"\\u0000", "\\U00000000", "m\\\\\\u0000"}) {
        INFO(nul);
        const std::string text = test::replaced(good, "0.8 um", "0.8 u" + std::string(nul));
        check_both_refuse(text, {"scene.toml:2: holds \\u0000"});
    }
    CHECK(test::contains(test::refused_scene("name = '\\u0000'\n" + good + "x = 1\n"), "unknown key"));
    CHECK(test::contains(test::refused_scene("name = \"\\\\u0000\"\n" + good + "x = 1\n"), "unknown key"));
}

TEST_CASE("A whole number beyond 2^53 is refused wherever a number is read") {
    const std::string more = test::replaced(good, "Sdq = 0.15", "Sdq = 0.15\nskewness = 0\nkurtosis = 3\nhurst = 0.8") +
                             "[persson]\ngamma = 0.45\n[friction]\ncoefficient = 0.3\n[gap]\nmedium = \"air\"\n"
                             "emissivity = 0.5\ntemperature = \"293 K\"\n";
    REQUIRE(test::refused_scene(more).empty());
    const std::vector<std::string> numbers{"skewness = 0", "kurtosis = 3",      "hurst = 0.8",     "Sdq = 0.15",
                                           "gamma = 0.45", "coefficient = 0.3", "emissivity = 0.5"};
    for (const char* whole : {"9007199254740993", "-9007199254740993", "9223372036854775807", "1152921504606846976",
                              "-9223372036854775808", "0x20000000000001"})
        for (const std::string& number : numbers) {
            const std::string key = number.substr(0, number.find(' ')), changed = key + " = " + whole;
            INFO(changed);
            test::check_sentence(test::refused_scene(test::replaced(more, number, changed)), {key + " = ", "2^53"});
            for (const std::string& grid :
                 {key + " = [1, " + whole + "]", key + " = [" + whole + ", 1]", key + " = { values = [" + whole + "] }",
                  key + " = { from = 0, to = " + whole + ", count = 3 }", key + " = { normal = [1, " + whole + "] }",
                  key + " = { lognormal = [" + whole + ", 1] }", key + " = { uniform = [-1e300, " + whole + "] }"}) {
                INFO(grid);
                const std::string text = test::replaced(more, number, grid);
                test::check_sentence(test::refusal([&] { (void)fstiff::sweep::read_grid(text, "scene.toml"); }),
                                     {key, "2^53"});
            }
        }
    CHECK(test::contains(test::refused_scene(test::replaced(more, "Sdq = 0.15",
                                                            "Sdq = 0.15\nerrors = { Sdq = "
                                                            "9007199254740993 }")),
                         "2^53"));
    // 2^53 itself is a double, and refused for what it is
    CHECK(test::contains(test::refused_scene(test::replaced(more, "hurst = 0.8", "hurst = 9007199254740992")),
                         "surface.hurst = 9007199254740992: must be"));
}

bool beyond_any_unit(const char* value) { return std::abs(std::log10(std::stold(value))) >= 100; }

/// Puts each of \p values in place of each number of scenes that have all keys.
void check_extreme(const std::vector<const char*>& values) {
    const std::string bodies =
        "[material.upper]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\nhardness = \"2 GPa\"\n"
        "yield_strength = \"400 MPa\"\nthermal_conductivity = \"40 W/(m K)\"\nelectrical_conductivity = \"7 MS/m\"\n"
        "[contact]\nnominal_area = \"150 mm^2\"\npressures = [\"1 MPa\", \"50 MPa\"]\nseating = \"1 kPa\"\n";
    const std::string tail =
        "[gap]\nconductivity = \"0.5 W/(m K)\"\nemissivity = 0.5\ntemperature = \"293 K\"\n"
        "thermal_film = \"1 mm^2 K/W\"\nelectrical_film = \"1 ohm um^2\"\ntemperature_jump = \"1 um\"\n"
        "[friction]\ncoefficient = 0.3\namplitude = \"1 nm\"\n"
        "[ultrasound]\nfrequency = \"5 MHz\"\n[ultrasound.upper]\ndensity = \"7850 kg/m^3\"\nvelocity = \"5900 m/s\"\n"
        "[ultrasound.lower]\nimpedance = \"33 MRayl\"\n[uncertainty]\nsamples = 20\n";
    const std::vector<std::string> scenes{
        "[surface]\nrms_height = \"0.8 um\"\nrms_gradient = 0.12\nalpha = 8\nhurst = 0.8\nskewness = -0.3\n"
        "kurtosis = 3.3\nerrors = { rms_height = \"0.05 um\", rms_gradient = 0.01 }\n" +
            bodies + tail,
        "[surface]\nRa = \"0.8 um\"\nRSm = \"60 um\"\n" + bodies + tail,
        "[surface]\nRq = \"0.8 um\"\nRk = \"2 um\"\nRpk = \"0.5 um\"\nRvk = \"0.9 um\"\nRmr1 = 0.1\n"
        "Rmr2 = 0.9\n" +
            bodies + tail,
        "[surface]\nrms_height = \"0.8 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n"
        "fractal_dimension = 1.62\nfractal_roughness = \"1.2e-8 m\"\nmax_peak_height = \"5.3 um\"\n" +
            test::replaced(bodies, "seating = \"1 kPa\"\n",
                           "laws = [\"fractal\", \"jackson_green\", \"hybrid\"]\n"
                           "peaks = [ { theta = 1.0, r = 0.5 } ]\n"
                           "interaction = { reading = \"effective_separation\", length = \"40 um\" }\n") +
            tail};
    const std::regex number(R"((\w+) = ("?)([-0-9.]+(?:e-?\d+)?)([^\n,}\]]*))");
    std::size_t keys = 0, outside = 0;
    for (const std::string& scene : scenes) {
        INFO(scene.substr(0, 60));
        if (const std::string refusal = test::refused_scene(scene); !refusal.empty()) FAIL(refusal);
        for (std::sregex_iterator found(scene.begin(), scene.end(), number), end; found != end; ++found, ++keys) {
            const std::smatch& at = *found;
            const bool quantity = at.str(2) == "\"";
            for (const char* value : values) {
                std::string text = scene;
                text.replace(static_cast<std::size_t>(at.position(3)), at.str(3).size(), value);
                INFO(at.str(1) << " = " << value);
                const std::string refusal = test::refused_scene(text);  // any other exception fails
                if (refusal.empty() || !quantity || !beyond_any_unit(value)) continue;
                outside += test::contains(refusal, "from 1e-100 to 1e100 ");
                CHECK(test::contains(refusal, at.str(1)));
            }
        }
    }
    CHECK(keys > 60);
    CHECK(outside > 33 * static_cast<std::size_t>(std::ranges::count_if(values, beyond_any_unit)));
}

TEST_CASE("No value of a scene leads beyond the range of double precision", "[more]") {
    check_extreme({"1.7e308", "5e-324", "1e99"});
}
TEST_CASE("No value of a scene leads beyond the range of double precision, however far beyond it is", "[long]") {
    check_extreme({"1e150", "1e200", "1.7e308", "1e-150", "1e-200", "5e-324", "1e99", "1e-99"});
}

TEST_CASE("A band costs no more at separations than the search for their pressures does") {
    const auto seconds = [](const std::string& points) {
        const std::string text =
            test::replaced(test::replaced(good, "pressures = [\"1 MPa\", \"10 MPa\"]", points), "Sdq = 0.15\n",
                           "Sdq = 0.15\nerrors = { Sq = \"0.05 um\", Sdq = 0.02 }\n");
        const std::clock_t start = std::clock();
        const auto results = test::results_of(text);
        CHECK(results.answer.points.size() == 20);
        return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    };
    const double at_pressures = seconds("pressures = { from = \"1 MPa\", to = \"2 GPa\", count = 20 }");
    // each state of the scene itself takes some thirty times as long there; each of 200 surfaces did too
    CHECK(seconds("separations = { from = \"0.2 um\", to = \"3 um\", count = 20 }") < 120 * at_pressures);
}

}  // namespace unsafe_scene_test
