// SPDX-License-Identifier: BSD-3-Clause
// No pressure is lost without a sentence and a doubtful result, and no sentence contradicts the numbers above it.
// Truth: limits worked by hand (0.75 E g, the hardness), and the columns themselves.
#include "actions/answered.hpp"
#include "actions/explanation.hpp"
#include "support/csv.hpp"
#include "support/library.hpp"

#include <cmath>

namespace whole_answer_test {

using namespace fstiff;
using test::contains;

namespace {

/// A surface of sigma 1 um and g on bodies of E* = 100 GPa.
std::string text_of(double g, const std::string& upper, const std::string& contact, const std::string& rest = "") {
    return "[surface]\nrms_height = \"1 um\"\nrms_gradient = " + std::to_string(g) +
           "\nalpha = 8\nhurst = 0.8\nskewness = 0\nkurtosis = 3\n[material.upper]\nyoungs_modulus = \"200 GPa\"\n"
           "poisson_ratio = 0\n" +
           upper + "[contact]\n" + contact + rest;
}

const std::string never = "hardness = \"infinite\"\n";

std::string warned(const actions::Answered& results) { return test::joined(results.warnings); }

std::string cell(const actions::Answered& results, const std::string& column, std::size_t row) {
    std::istringstream csv(test::csv_of(results));
    std::string line;
    std::getline(csv, line);
    const auto names = test::csv_cells(line);
    for (std::size_t i = 0; i <= row; ++i) std::getline(csv, line);
    const auto cells = test::csv_cells(line);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == column) return cells.at(i);
    return "no column";
}

}  // namespace

TEST_CASE("A closed contact is reported with the pressure that closes it, in every scene") {
    // 0.75 E g
    for (const auto& [g, limit] : {std::pair(0.01, "750 MPa"), {0.02, "1.5 GPa"}, {0.1, "7.5 GPa"}, {0.4, "30 GPa"}})
        for (const char* points : {"\"10 MPa\", \"200 GPa\"", "\"200 GPa\", \"10 MPa\"",
                                   "\"1 MPa\", \"10 MPa\", \"500 MPa\", \"50 GPa\", \"200 GPa\""}) {
            const auto best = test::results_of(text_of(g, never, "pressures = [" + std::string(points) + "]\n"));
            INFO(warned(best));
            CHECK(best.doubtful);
            CHECK(contains(warned(best), "no K at "));
            CHECK(contains(warned(best), std::string("above ") + limit + " the contact is closed"));
            CHECK_FALSE(contains(test::joined(best.explanation), "closed"));
            const auto named = test::results_of(
                text_of(g, never, "laws = [\"persson\"]\npressures = [" + std::string(points) + "]\n"));
            CHECK(named.doubtful);
            CHECK(contains(warned(named), "the answer has no K at "));
            CHECK(contains(warned(named), std::string("above ") + limit + " the contact is closed"));
        }
    const std::string refused =
        test::refusal([] { (void)test::results_of(text_of(0.01, never, "pressures = [\"20 GPa\"]\n")); });
    CHECK(contains(refused, "contact.pressures: law hybrid: above 750 MPa the contact is closed"));
}

TEST_CASE("A pressure above the hardness is lost with a sentence, whichever laws are named") {
    for (const char* laws :
         {"", "laws = [\"hertz\"]\n", "laws = [\"hybrid\", \"persson\"]\n", "laws = [\"greenwood_williamson\"]\n"}) {
        const auto partly = test::results_of(
            text_of(0.1, "hardness = \"20 MPa\"\n", laws + std::string("pressures = [\"1 MPa\", \"25 MPa\"]\n")));
        INFO(laws << warned(partly));
        CHECK(partly.doubtful);
        REQUIRE(partly.has_answer());
        CHECK(actions::count_of(partly.answer) == 1);
        CHECK(contains(warned(partly), "25 MPa is above the hardness (20 MPa): the contact is closed"));
        if (!*laws) continue;
        const auto whole =
            test::results_of(text_of(0.1, "hardness = \"20 MPa\"\n", laws + std::string("pressures = [\"25 MPa\"]\n")));
        INFO(warned(whole));
        CHECK(whole.doubtful);
        CHECK_FALSE(whole.has_answer());
        CHECK(contains(warned(whole), "the answer has no K: "));
        CHECK(contains(warned(whole), "25 MPa is above the hardness (20 MPa)"));
    }
}

TEST_CASE("A pressure without a K keeps its row in the summary") {
    const scene::Scene read = test::scene_of(text_of(0.01, "", "pressures = [\"10 MPa\", \"2 GPa\", \"100 MPa\"]\n"));
    const auto table = actions::answer_table(actions::compute(read));
    REQUIRE(table.size() == 4);
    CHECK(table[2][0] == "2 GPa");
    CHECK(table[2][1] == "-");
    CHECK(table[3][0] == "100 MPa");
}

TEST_CASE("Law plastic is right up to the hardness, with a negative separation above half of it, and doubtful last") {
    // the median of ten half spaces with H/(E g) = 0.3 and pressures cut at H: at 0.33, 0.67 and 0.8 H
    constexpr double truth[] = {0.4094e16, 1.908e16, 4.152e16};
    const std::string upper = "hardness = \"3 GPa\"\n",
                      all = "[output]\nquantities = [\"stiffness\", \"separation\", \"loading_stiffness\"]\n",
                      up_to = "pressures = [\"0.99 GPa\", \"2.01 GPa\", \"2.4 GPa\"";
    const auto results = test::results_of(text_of(0.1, upper, up_to + ", \"2.9 GPa\"]\n", all));
    INFO(warned(results));
    CHECK(results.doubtful);
    CHECK(contains(warned(results),
                   "law plastic was compared up to 2.85 GPa, 95 % of the hardness: K at 2.9 GPa may be far off"));
    CHECK_FALSE(test::results_of(text_of(0.1, upper, up_to + "]\n")).doubtful);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(std::stod(cell(results, "stiffness_Pa_per_m", i)) / truth[i] - 1) < 0.2);
        CHECK(std::stod(cell(results, "loading_stiffness_Pa_per_m", i)) > 0);
        CHECK((std::stod(cell(results, "separation_m", i)) > 0) == (i == 0));
    }
}

TEST_CASE("No loading stiffness is above that of unloading") {
    for (const double kurtosis : {4.0, 5.0, 8.0, 10.0})
        for (const char* quantity : {"", "[output]\nquantities = [\"loading_stiffness\", \"stiffness\"]\n"}) {
            const std::string text =
                "[surface]\nSq = \"0.4 um\"\nSdq = 0.1\nskewness = 0\nkurtosis = " + std::to_string(kurtosis) +
                "\n[material.upper]\nname = \"steel\"\nhardness = \"3 GPa\"\n[contact]\npressures = [\"0.3 MPa\", "
                "\"1 MPa\", \"10 MPa\"]\n" +
                quantity;
            const auto results = test::results_of(text);
            for (std::size_t i = 0; i < 3; ++i) {
                const auto& state = results.answer.points[i].state;
                CHECK(results.answer.points[i].loading_stiffness.value() <= state.stiffness.value);
                if (*quantity)
                    CHECK(std::stod(cell(results, "loading_stiffness_Pa_per_m", i)) <=
                          std::stod(cell(results, "stiffness_Pa_per_m", i)));
            }
        }
}

TEST_CASE("Where one body alone has a hardness that of the other is assumed, and no contact is called elastic") {
    const auto said = [](const std::string& bodies) {
        const scene::Scene read = test::scene_of("[surface]\nSq = \"0.8 um\"\nSdq = 0.1\n[material]\n" + bodies +
                                                 "[contact]\npressures = [\"1 MPa\"]\n");
        const auto results = actions::compute(read);
        return test::joined(results.explanation) + test::joined(read.assumptions) +
               test::joined(results.short_explanation);
    };
    for (const char* soft : {"copper", "PMMA", "aluminium", "brass", "cast_iron", "titanium"}) {
        const std::string other(soft);
        for (const std::string& bodies :
             {"upper = { name = \"steel\", hardness = \"12 GPa\" }\nlower = \"" + other + "\"\n",
              "lower = { name = \"steel\", yield_strength = \"5 GPa\" }\nupper = \"" + other + "\"\n"}) {
            INFO(bodies << said(bodies));
            CHECK(contains(said(bodies), "of the softer of "));
            CHECK(contains(said(bodies), other));
            CHECK_FALSE(contains(said(bodies), "nearly elastic"));
        }
        // the softer one is no harder than 1 GPa: peaks flow in any case
        const std::string bodies =
            "upper = { name = \"nickel\", hardness = \"0.05 GPa\" }\nlower = \"" + other + "\"\n";
        CHECK(contains(said(bodies), "The peaks yield at first loading"));
    }
    const std::string both =
        said("upper = { name = \"steel\", hardness = \"12 GPa\" }\n");  // the lower is as the upper
    CHECK_FALSE(contains(both, "hardness"));
}

TEST_CASE("A strength that no material has is warned of") {
    const auto of = [](const std::string& upper) {
        return warned(test::results_of(text_of(0.1, upper, "pressures = [\"1 MPa\"]\n")));
    };
    CHECK(contains(of("yield_strength = \"400 GPa\"\n"), "is above a tenth of the modulus, 20 GPa"));
    CHECK(contains(of("hardness = \"100 GPa\"\n"), "is above a tenth of the modulus, 20 GPa"));
    CHECK(
        contains(of("hardness = \"100 MPa\"\nyield_strength = \"400 MPa\"\n"), "is below the yield strength, 400 MPa"));
    CHECK(of("hardness = \"9 GPa\"\nyield_strength = \"3 GPa\"\n").empty());
}

TEST_CASE("A band outside of which nothing is left to give asks for nothing") {
    const test::Folder folder;
    folder.write(
        "map.csv",
        test::map_text(64, 1e-6,
                       {.hurst = 0.8, .rms = 0.3e-6, .longest_wavelength = 16e-6, .shortest_wavelength = 4e-6}));
    const auto outside = [&](const std::string& area) {
        const scene::Scene read =
            test::scene_of("[surface]\nfrom = '" + folder / "map.csv" +
                           "'\n[material]\nupper = \"steel\"\n[contact]\n" + area + "pressures = [\"100 MPa\"]\n");
        return actions::outside_band(actions::compute(read));
    };
    CHECK(contains(outside(""), "long waves (give contact.nominal_area)"));
    for (const char* area : {"1e-3 mm^2", "4.096e-3 mm^2", "0.1 mm^2"})
        CHECK_FALSE(contains(outside("nominal_area = \"" + std::string(area) + "\"\n"), "give contact.nominal_area"));
}

TEST_CASE("Refusals of keys name one place, and options of a law are checked without it") {
    const std::string rest = "[material]\nupper = \"steel\"\n[contact]\npressures = [\"1 MPa\"]\n";
    const std::string core = test::refused_scene(
        "[surface]\nSq = \"1 um\"\nRk = \"1 um\"\nRpk = \"0.3 um\"\nRvk = \"0.3 um\"\nRmr1 = 10\nRmr2 = 0.9\n" + rest,
        "s.toml");
    INFO(core);
    CHECK(core.starts_with("s.toml:6: surface.Rmr1 = 10: must be a share"));
    const auto mutual = [&](const std::string& value) {
        return test::refused_scene("[surface]\nSq = \"1 um\"\n" + rest + "[contact.summits]\nmutual = " + value + "\n",
                                   "s.toml");
    };
    for (const char* value : {"\"xx\"", "[]", "[1]", "2"})
        CHECK(contains(mutual(value), "s.toml:8: contact.summits.mutual"));
    CHECK(mutual("false").empty());
}

TEST_CASE("Laws without a band name the reason that holds") {
    const auto why = [](const std::string& surface, const std::string& rest) {
        const scene::Scene read = test::scene_of("[surface]\n" + surface + "[material]\nupper = \"steel\"\n" + rest);
        return actions::why_no_band(actions::compute(read));
    };
    const std::string hertz = "[contact]\nlaws = [\"hertz\"]\npressures = [\"1 MPa\"]\n",
                      peaks = "rms_height = \"1 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n";
    CHECK(why(peaks, hertz) == "they depend on no parameter that is uncertain");
    CHECK(why("Ra = \"1 um\"\n", hertz + "[uncertainty]\nsamples = 0\n") == "the scene asks for no samples");
}

}  // namespace whole_answer_test
