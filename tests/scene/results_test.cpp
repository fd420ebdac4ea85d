// SPDX-License-Identifier: BSD-3-Clause
// fstiff::scene by itself: read_scene and compute, against the numbers that the command prints.
#include "actions/answered.hpp"

#include "cli/command.hpp"
#include "support/accuracy.hpp"
#include "support/library.hpp"

#include "actions/measured_curve.hpp"
#include "actions/run.hpp"
#include "document/file.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace results_test {

using namespace fstiff;

namespace {

/// A short scene whose section [contact] ends with \p contact.
std::string text_of(const std::string& contact) {
    return "name = \"short\"\n[surface]\nrms_height = \"1 um\"\npeak_radius = \"60 um\"\npeak_density = \"500 /mm^2\"\n"
           "fractal_dimension = 1.5\nerrors = { rms_height = \"0.1 um\" }\n[material.upper]\n"
           "youngs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n[uncertainty]\nsamples = 40\n"
           "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\nnominal_area = \"195 mm^2\"\n" +
           contact;
}

const std::string three_laws = "laws = [\"fractal\", \"hertz\", \"greenwood_williamson\"]\n";

}  // namespace

TEST_CASE("The scenes of data/ have the numbers that fstiff run prints") {
    for (const char* name : {"sand_blasted_fine", "sand_blasted_coarse", "electrical_discharge_machined"}) {
        const std::string file = std::string(FSTIFF_SCENES "/") + name + ".toml";
        INFO(file);
        const auto results = test::results_of(test::read(file), file);
        const auto outcome = test::run_fstiff("run '" + file + "' --format csv");
        CHECK(outcome.status == (results.doubtful ? 4 : 0));
        CHECK((outcome.out == document_of(results).csv()));
        const test::Csv printed(outcome.out);
        std::size_t row = 0;
        std::vector<const AnswerCurve*> curves{&results.answer};
        for (const auto& curve : results.curves()) curves.push_back(&curve);
        for (const AnswerCurve* curve : curves)
            for (std::size_t place = 0; place < curve->points.size(); ++place, ++row) {
                CHECK(printed.text(row, "law") == name_of(curve->points[place].law));
                CHECK(printed.text(row, "answer") == (curve == curves.front() ? "1" : "0"));
                CHECK(printed.number(row, "stiffness_Pa_per_m") == test::value_at(*curve, place, "stiffness"));
            }
        CHECK(row == printed.size());
    }
}

TEST_CASE("The built-in scene is the text of data/built_in.toml") {
    CHECK(test::read(FSTIFF_SCENES "/built_in.toml") == scene::builtin_scene);
}

TEST_CASE("Every column of a curve names its unit and has a value a point") {
    const auto read = scene::read_scene(text_of(three_laws), {.name = "short.toml"});
    std::size_t calls = 0;
    const auto results = actions::compute(read, [&](std::string_view, std::size_t done, std::size_t all) {
        CHECK(done < all);
        ++calls;
    });
    CHECK(calls > 0);
    REQUIRE(results.curves().size() == 5);
    for (const auto& curve : results.curves()) {
        REQUIRE(curve.points.size() == 2);
        for (const scene::NumberOf& column : read.columns(true)) {
            INFO(column.key());
            CHECK((column.quantity->unit.empty() || !column.quantity->suffix.empty()));
            CHECK(std::isfinite(column(curve.points[0])));
            CHECK(std::isfinite(column(curve.points[1])));
        }
        CHECK(test::value_at(curve, 0, "stiffness", "_p05") == curve.points[0].stiffness.low);
    }
}

TEST_CASE("Interaction makes every law softer, Greenwood and Williamson's too, and never stiffer than the bulk") {
    const std::string interaction = "interaction = { reading = \"effective_separation\", length = \"nominal\" }\n";
    const auto alone = actions::compute(scene::read_scene(text_of(three_laws), {.name = "short.toml"}));
    const auto with = actions::compute(scene::read_scene(text_of(three_laws + interaction), {.name = "short.toml"}));
    REQUIRE(alone.curves().size() == with.curves().size());
    const double length = std::sqrt(195e-6);
    for (std::size_t c = 0; c < with.curves().size(); ++c)
        for (std::size_t i = 0; i < 2; ++i) {
            INFO(actions::title(with.curves()[c]));
            const double k = with.curves()[c].points[i].state.stiffness.value;
            CHECK(k < alone.curves()[c].points[i].state.stiffness.value);
            if (fstiff::name_of(with.curves()[c].law) != "greenwood_williamson") continue;
            // two springs in series: 1/K' = 1/K + L/E, and K = -dp/dd for Hertzian peaks
            const double series =
                1 / (1 / alone.curves()[c].points[i].state.stiffness.value + length / with.answer.effective_modulus);
            CHECK(std::abs(k / series - 1) < 1e-9);
        }
    CHECK(std::none_of(with.warnings.begin(), with.warnings.end(),
                       [](const auto& line) { return test::contains(line, "not applied"); }));
}

TEST_CASE("Input that is not a scene is refused with the right option") {
    const auto refusal = [](const std::string& text) {
        return test::refusal([&] { static_cast<void>(scene::read_scene(text, {.name = "f"})); });
    };
    const std::string surface = "; a measured surface is given by --surface, or by surface.from in a scene";
    CHECK(test::contains(refusal("x [um],z [um]\n0,1.5\n1,2\n2,1e-3\n"), surface));
    CHECK(test::contains(refusal("1\t2\n3\t4\r\n5\t6"), surface));
    CHECK(test::contains(refusal("{\"command\": \"measure\"}"), surface));
    CHECK(test::contains(refusal(std::string("MM\0", 3)), surface));
    CHECK_FALSE(test::contains(refusal("[surface\n1,2\n"), surface));

    const std::string grid = "; several values are for a grid, which fstiff sweep reads";
    CHECK(test::contains(refusal(test::replaced(text_of(""), "\"1 um\"", "[\"1 um\", \"2 um\"]")), grid));
    CHECK(test::contains(refusal(test::replaced(text_of(""), "1.5", "{ values = [1.5, 1.6] }")), grid));
    CHECK_FALSE(test::contains(refusal(test::replaced(text_of(""), "\"1 um\"", "true")), grid));
    CHECK(refusal(text_of("") + "[sweep]\nseed = 1\n").starts_with("f:16: sweep: is a section of a grid"));
}

TEST_CASE("Values of a scene that make no peak radius, or have a decimal comma, are refused at their place") {
    const auto refusal = [](const std::string& from, const std::string& to) {
        const std::string text = test::replaced(text_of(""), from, to);
        return test::refusal([&] { static_cast<void>(scene::read_scene(text, {.name = "f"})); });
    };
    CHECK(refusal("peak_radius = \"60 um\"\npeak_density = \"500 /mm^2\"", "rms_gradient = 0.1\nalpha = 1e300") ==
          "f:5: surface.alpha = 1e+300: makes, with rms_height and rms_gradient, peak_radius = 0, which must be "
          "finite and greater than 0");
    CHECK(refusal("\"1 um\"", "\"0,8 um\"") ==
          "f:3: surface.rms_height = \"0,8 um\": has a comma; the decimal mark is the point, as in 0.8");
}

TEST_CASE("The pressure of the spots is the load over the real area, the hardness of a light plastic contact") {
    const auto found = test::results_of(
        "[surface]\nrms_height = \"0.8 um\"\nrms_gradient = 0.3\n[material.upper]\nname = \"steel\"\nhardness = \"1 "
        "GPa\"\n"
        "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\n[output]\nquantities = [\"stiffness\", \"spot_pressure\"]\n");
    for (const AnswerPoint& point : found.answer.points) {
        const double area = point.state.real_area_fraction.value;
        CHECK(test::relative_error(point["spot_pressure"], point.pressure / area) < 1e-15);
        CHECK(point["spot_pressure"] <= 1e9);
        CHECK(point["spot_pressure"] > 0.98e9);  // H/(E g) = 0.03: p/sqrt(1/H^2 + 4/(E g)^2), nearly
    }
    const nlohmann::json row = test::parsed(actions::run_document(found))["answer"][0];
    CHECK(row["spot_pressure_Pa"] == found.answer.points[0]["spot_pressure"]);
}

TEST_CASE("The explanation and the warnings do not depend on the columns asked for") {
    const auto said = [](const std::string& quantities) {
        const std::string text = test::replaced(text_of("laws = [\"hertz\"]\n"), "195 mm^2", "0.01 mm^2");
        const std::string output = "[output]\nquantities = [" + quantities + "]\n";
        auto results = actions::compute(scene::read_scene(text + output, {.name = "f"}));
        results.explanation.insert(results.explanation.end(), results.warnings.begin(), results.warnings.end());
        return results.explanation;
    };
    const auto all = said("\"stiffness\", \"contacts\", \"real_area\"");
    CHECK(said("\"stiffness\"") == all);
    CHECK(std::any_of(all.begin(), all.end(), [](const std::string& line) {
        return line.starts_with("fewer than 10 contacts on the nominal area");
    }));
}

TEST_CASE("All curves of a scene and its answer have one p*") {
    const auto check = [](const std::string& from, const std::string& to, double gradient, std::size_t curves) {
        const std::string text = test::replaced(text_of("laws = [\"hertz\", \"greenwood_williamson\"]\n"), from, to);
        const auto results = actions::compute(scene::read_scene(text, {.name = "f"}));
        REQUIRE(results.curves().size() == curves);
        for (const auto& curve : results.curves()) {
            const AnswerPoint& point = curve.points.front();
            REQUIRE(point.p_star);
            CHECK(test::relative_error(*point.p_star, point.pressure / (results.answer.effective_modulus * gradient)) <
                  1e-9);
        }
        REQUIRE(results.has_answer());
        CHECK(test::relative_error(results.answer.points[0].p_star.value(),
                                   1e6 / (results.answer.effective_modulus * gradient)) < 1e-9);
    };
    const double curvature = 3 * std::sqrt(3.141592653589793) / (8 * 60e-6), sigma = 1e-6;
    // R and D_p that no Gaussian surface has: those of islands
    check("500 /mm^2", "400 /mm^2", fstiff::detail::gradient_of_islands(sigma, 60e-6, 4e8).middle, 3);
    // unless by r and theta of the surface
    check("fractal_dimension", "r = 0.5\ntheta = 0.8\nfractal_dimension", std::sqrt(2 * 0.5 * sigma * curvature), 2);
    // an isotropic surface of the alpha that rms_gradient makes: one distribution of peaks
    check("fractal_dimension", "rms_gradient = 0.05\nfractal_dimension", 0.05, 2);
    // sigma R D_p = 0.3 is that of an isotropic Gaussian surface: the spectrum of the three numbers
    const auto moments = fstiff::detail::moments_of_peaks(sigma, 60e-6, 5e9);
    REQUIRE(moments.bandwidth() > 1.5);
    check("500 /mm^2", "5000 /mm^2", std::sqrt(2 * moments.m2), 3);
}

TEST_CASE(
    "The answer has all points of a list and of a range up to twelve, of a longer range the ends and the decades") {
    const auto points = [](std::vector<double> values, bool range = true, bool separations = false) {
        scene::Scene of;
        of.listed = !range;
        of.points = std::move(values);
        of.at_separations = separations;
        return of.points_of_answer();
    };
    using Indices = std::vector<std::size_t>;
    CHECK(points({1e7, 1e6, 1e8, 3e6}, false) == Indices{0, 1, 2, 3});
    CHECK(points({2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14}, false).size() == 13);
    CHECK(points({2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 13, 14}).size() == 12);
    CHECK(points({2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14}) == Indices{0, 8, 12});
    CHECK(points({2, 2.1, 2.2, 3, 4, 5, 5.5, 6, 6.5, 7, 8, 8.5, 9}) == Indices{0, 4, 8, 12});  // no decade within
    CHECK(points({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13}, true, true) == Indices{0, 4, 8, 12});
}

TEST_CASE("Every law of the table has a name, its equations and a contact, and is found by its name") {
    for (const ChosenLaw& one : detail::all_laws()) {
        const detail::Law& law = one.row();
        INFO(law.name);
        CHECK(detail::find_law(law.name) == &law);
        CHECK(law.contact != nullptr);
        CHECK(!law.load.empty());
        CHECK(!law.stiffness.empty());
        CHECK(!law.peaks.empty());
        CHECK(!law.nature.empty());
        if (law.needs_map || law.needs_spectrum || law.needs_hardness || law.needs_yield)
            continue;  // tests/scene/laws_test.cpp
        const auto read =
            scene::read_scene(text_of("laws = [\"" + std::string(law.name) + "\"]\n"), {.name = "x.toml"});
        CHECK(actions::compute(read).curves().size() == (law.has_peaks ? 2 : 1));
    }
    CHECK(detail::find_law("no law") == nullptr);
}

TEST_CASE("A gradient that no surface has is a warning of a wrong unit, and a doubt") {
    const auto with = [](const std::string& from, const std::string& to) {
        std::string text = text_of("laws = [\"hertz\"]\npeaks = [{ theta = \"pi/3\", r = 0.5 }]\n");
        text.replace(text.find(from), from.size(), to);
        return actions::compute(scene::read_scene(text, {.name = "short.toml"}));
    };
    const auto warns = [](const actions::Answered& results, const std::string& part) {
        return std::count_if(results.warnings.begin(), results.warnings.end(), [&](const std::string& line) {
            return test::contains(line, part) && test::contains(line, "a unit of its lengths is likely wrong");
        });
    };
    const std::string sigma = "rms_height = \"1 um\"", radius = "peak_radius = \"60 um\"";
    const auto sound = with(sigma, sigma);
    CHECK((warns(sound, "") == 0 && !sound.doubtful));
    for (const auto& [from, to, part] :
         {std::array<std::string, 3>{sigma, "rms_height = \"1 mm\"", "above 1 (implied by rms_height and peak_radius)"},
          {sigma, "rms_height = \"1 m\"", "above 1 (implied by rms_height"},
          {radius, "peak_radius = \"0.03 nm\"", "above 1 (implied by peak_radius and peak_density)"},
          {radius, "peak_radius = \"4.4e11 m\"", "below 1e-06 (implied by peak_radius"},
          {radius, radius + "\nrms_gradient = 100", "gradient, 100, is above 1 (rms_gradient)"},
          {radius, radius + "\nrms_gradient = 9e-7", "below 1e-06 (rms_gradient)"}}) {
        CAPTURE(to);
        const auto results = with(from, to);
        CHECK((warns(results, part) == 1 && results.doubtful));
    }
    // neither is of what is 1 or 1e-6
    CHECK(!with(radius, radius + "\nrms_gradient = 1").doubtful);
    const auto flat = with(radius, radius + "\nrms_gradient = 1e-6");  // 0.75 E g is 84 kPa: the answer is lost
    CHECK(warns(flat, "") == 0);
    CHECK(flat.doubtful);
    CHECK(test::contains(test::joined(flat.warnings), "the answer has no K"));
}

TEST_CASE("A measured curve has one decimal sign, and a point next to decimal commas is no decimal") {
    const test::Folder folder;
    const auto read = [&](const std::string& rows) {
        return actions::read_measured_curve(folder.write("curve.csv", "pressure [MPa];stiffness [GPa/um]\n" + rows))
            .points;
    };
    CHECK(read("1,5;0,25\n20;0,5\n")[0].pressure == 1.5e6);
    CHECK(read("1.5;0.25\n20;0.5\n")[0].pressure == 1.5e6);
    const std::string why = test::refusal([&] { (void)read("1,5;0,25\n1.000;0,5\n"); });
    CHECK(test::contains(why, "curve.csv:3: pressure = \"1.000\": must be a number with a decimal comma"));
}

}  // namespace results_test
