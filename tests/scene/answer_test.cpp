// SPDX-License-Identifier: BSD-3-Clause
// The answer of a scene: one K a pressure with its band, its causes and its law. Truth: the law itself, named alone;
// the statements of docs/scene.md about it, one by one.
#include "actions/answered.hpp"
#include "actions/explanation.hpp"

#include "support/library.hpp"

#include <cmath>

namespace answer_test {

using namespace fstiff;
using nlohmann::json;
using test::contains;

namespace {

const std::string numbers = "[surface]\nrms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 8\nhurst = 0.8\n";
const std::string wide = "pressures = { from = \"1 MPa\", to = \"100 MPa\", count = 9 }\n";

/// A scene of \p surface on a body of E* = 100 GPa, with \p material, \p contact and 20 samples.
std::string text_of(const std::string& surface, const std::string& contact, const std::string& material = "") {
    return surface + "[material.upper]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0\n" +
           (material.empty() ? "hardness = \"infinite\"\n" : material) + "[contact]\n" + contact +
           "[uncertainty]\nsamples = 20\n";
}

/// A map of \p points a side, every 1 um and 0.3 um high, in a file of \p folder, after \p change of its heights.
template <class Change>
std::string map_of(const test::Folder& folder, int points, const Change& change) {
    fstiff::HeightMap<double> map = fstiff::self_affine_map<double>(
        {.hurst = 0.8, .rms = 0.3e-6, .longest_wavelength = 16e-6, .shortest_wavelength = 4e-6}, points, points, 1e-6,
        1e-6);
    change(map.heights);
    return "[surface]\nfrom = '" + folder.write("map.csv", test::file_text(map)) + "'\nlambda_s = \"none\"\n";
}
std::string map_of(const test::Folder& folder, int points) {
    return map_of(folder, points, [](auto&) {});
}

struct Answered {
    scene::Scene of;
    actions::Answered results;
    json rows;  ///< of the JSON document

    explicit Answered(const std::string& text, const std::string& file = "s.toml")
        : of(test::scene_of(text, file)),
          results(actions::compute(of)),
          rows(test::parsed(actions::run_document(results)).at("answer")) {}

    [[nodiscard]] std::string law(std::size_t row) const { return rows.at(row).at("law"); }
    [[nodiscard]] double K(std::size_t row) const { return rows.at(row).at("stiffness_Pa_per_m"); }
    [[nodiscard]] double width(std::size_t row) const {
        return double(rows.at(row).at("stiffness_p95_Pa_per_m")) / double(rows.at(row).at("stiffness_p05_Pa_per_m"));
    }
    [[nodiscard]] double of_faces(std::size_t row) const {  // without the form, which a larger face has more of
        return double(rows.at(row).at("stiffness_of_faces_p95_Pa_per_m")) /
               double(rows.at(row).at("stiffness_of_faces_p05_Pa_per_m"));
    }
    [[nodiscard]] std::string said() const { return test::joined(results.explanation); }
};

/// Each row has K within its band, a law, and causes that add up to 1.
void check_rows(const json& rows) {
    for (const json& row : rows) {
        INFO(row.dump());
        const double K = row.at("stiffness_Pa_per_m"), low = row.at("stiffness_p05_Pa_per_m"),
                     high = row.at("stiffness_p95_Pa_per_m");
        CHECK((0 < low && low < K && K < high));
        CHECK(double(row.at("pressure_Pa")) > 0);
        CHECK(detail::find_law(std::string(row.at("law"))));
        double sum = 0;
        for (const double share : row.at("causes")) sum += share;
        CHECK(std::abs(sum - 1) < 1e-12);
    }
}

}  // namespace

TEST_CASE("A scene that names no law has one answer for each pressure, as laws = best has") {
    const Answered absent(text_of(numbers, wide)), best(text_of(numbers, "laws = \"best\"\n" + wide));
    REQUIRE(absent.rows.size() == 9);
    check_rows(absent.rows);
    CHECK(absent.rows == best.rows);
    CHECK(absent.of.best);
    CHECK(absent.results.curves().size() == 1);
    CHECK(absent.law(0) == "hybrid");
    const Answered alone(text_of(numbers, "laws = [\"hybrid\"]\n" + wide));
    for (std::size_t i = 0; i < 9; ++i) CHECK(absent.K(i) == alone.results.curves()[0].points[i].state.stiffness.value);
}

TEST_CASE("Named laws change no digit of the answer, whichever they are and whatever is asked for") {
    const test::Folder folder;
    const std::string map = map_of(folder, 64);
    for (const std::string& surface : {numbers, map}) {
        const Answered best(text_of(surface, wide, "hardness = \"2 GPa\"\n"));
        for (const char* laws : {"\"persson\"", "\"hybrid\"", "\"plastic\", \"persson\""})
            CHECK(best.rows ==
                  Answered(text_of(surface, "laws = [" + std::string(laws) + "]\n" + wide, "hardness = \"2 GPa\"\n"))
                      .rows);
        CHECK(best.rows ==
              Answered(text_of(surface, wide, "hardness = \"2 GPa\"\n") + "[output]\nquantities = [\"separation\"]\n")
                  .rows);
    }
}

TEST_CASE("The band is there without samples, and without any error of a parameter") {
    const test::Folder folder;
    for (const std::string& surface : {numbers, map_of(folder, 64)}) {
        std::string text = text_of(surface, wide);
        const Answered none(test::replaced(text, "samples = 20", "samples = 0"));
        check_rows(none.rows);
        CHECK(none.rows.size() == 9);
    }
}

TEST_CASE(
    "Boundary elements answer for a map where they know a contact, and the law of peaks where they know a pixel") {
    const test::Folder folder;
    const std::string contact = "pressures = [\"100 MPa\", \"1 GPa\"]\n";
    const std::string map = map_of(folder, 64);
    const Answered answer(text_of(map, contact));
    const auto named = test::results_of(text_of(map, "laws = [\"boundary_elements\"]\n" + contact));
    REQUIRE(answer.rows.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& state = named.curves()[0].points[i].state;
        REQUIRE(state.real_area_fraction.value * 64 * 64 >= 20);
        CHECK(answer.law(i) == "boundary_elements");
        CHECK(test::relative_error(answer.K(i), state.stiffness.value) < 1e-12);
    }
    CHECK(contains(answer.said(), "Boundary elements solve the map itself."));
    check_rows(answer.rows);

    // one spike carries the least load alone
    const std::string spike = map_of(folder, 64, [](auto& heights) { heights(20, 30) = 20e-6; });
    const Answered pixel(text_of(spike, "pressures = [\"1 kPa\", \"1 GPa\"]\n"));
    CHECK(pixel.law(0) != "boundary_elements");
    for (const json& row : pixel.rows)
        if (row.at("law") == "boundary_elements") {
            const auto solved =
                test::results_of(text_of(spike, "laws = [\"boundary_elements\"]\npressures = [\"1 GPa\"]\n"));
            CHECK(solved.curves()[0].points[0].state.real_area_fraction.value * 64 * 64 >= 20);
        }
}

TEST_CASE(
    "A map of more points than boundary elements take is solved on fewer, and the band holds the error of the grid") {
    const test::Folder folder;
    const std::string map = map_of(folder, 64), contact = "pressures = [\"1 GPa\"]\n",
                      coarse = "[contact.boundary_elements]\npoints = 32\n";
    const Answered whole(text_of(map, contact)), coarser(text_of(map, contact + coarse));
    const auto named = test::results_of(text_of(map, "laws = [\"boundary_elements\"]\n" + contact + coarse));
    CHECK(coarser.law(0) == "boundary_elements");
    CHECK(coarser.K(0) == named.curves()[0].points[0].state.stiffness.value);
    CHECK(coarser.K(0) != whole.K(0));
    // the law's own error is that of one p*, whatever the grid
    const auto own = [&](const Answered& one, const std::string& grid) {
        const auto solved = test::results_of(text_of(map, "laws = [\"boundary_elements\"]\n" + contact + grid));
        const auto& K = solved.curves()[0].points[0].state.stiffness;
        const double high = one.results.answer.points[0].causes[static_cast<std::size_t>(fstiff::Cause::law)].high;
        CHECK(high > K.error / K.value);
        return std::sqrt(high * high - std::pow(K.error / K.value, 2));
    };
    CHECK(test::relative_error(own(coarser, coarse), own(whole, "")) < 1e-6);
}

TEST_CASE("A map with missing points is answered by its numbers") {
    const test::Folder folder;
    const std::string contact = "pressures = [\"100 MPa\"]\n";
    const std::string holes =
        map_of(folder, 64, [](auto& heights) { heights(20, 30) = std::numeric_limits<double>::quiet_NaN(); });
    const Answered missing(text_of(holes, contact));
    CHECK(missing.law(0) == "hybrid");
    CHECK_FALSE(contains(missing.said(), "summits and bearing curve"));
    check_rows(missing.rows);
}

TEST_CASE("Where a hardness is known one law answers, from elastic to p = H, with the loading stiffness next to it") {
    // E g = 10 GPa
    const auto at = [](const std::string& hardness) {
        return Answered(text_of(numbers, wide, "hardness = \"" + hardness + "\"\n"));
    };
    const Answered flows = at("6.9 GPa"), next = at("7.1 GPa"), hard = at("1000 GPa"), unknown = at("infinite");
    CHECK(contains(flows.said(), "The peaks yield at first loading (H/(E g) = 0.69): K is the unloading stiffness"));
    CHECK(contains(flows.said(), "Vibration and waves depend on K; the first static loading"));
    CHECK(contains(hard.said(), "The contact is nearly elastic (H/(E g) = 100)"));
    CHECK(contains(unknown.said(), "The bodies never yield"));
    for (std::size_t i = 0; i < 9; ++i) {
        for (const Answered* one : {&flows, &next, &hard}) {
            CHECK(one->law(i) == "plastic");
            CHECK(double(one->rows[i].at("loading_stiffness_Pa_per_m")) <= one->K(i));
        }
        CHECK(next.K(i) <= flows.K(i));
        CHECK(next.K(i) > 0.96 * flows.K(i));  // H is 3 % more
        CHECK(test::relative_error(hard.K(i), unknown.K(i)) < 1e-3);
        CHECK(test::relative_error(hard.width(i), unknown.width(i)) < 0.02);
    }
    const Answered yields(text_of(numbers, wide, "yield_strength = \"2.4642857142857144 GPa\"\n"));  // 6.9/2.8
    CHECK(yields.law(0) == "plastic");
    CHECK(test::relative_error(yields.K(4), flows.K(4)) < 1e-6);
}

TEST_CASE("The mean planes pass each other above half the hardness, and the approach goes on") {
    const auto results = test::results_of(
        text_of(numbers,
                "pressures = [\"10 MPa\", \"50 MPa\", \"67 MPa\", \"95 MPa\", \"100 MPa\"]\nlaws = [\"plastic\"]\n" +
                    std::string("[output]\nquantities = [\"approach\", \"stiffness\", \"loading_stiffness\"]\n"),
                "hardness = \"100 MPa\"\n"));
    const auto states = test::states_of(results.curves()[0]);
    REQUIRE(states.size() == 4);
    const double sigma = states[0].separation.value / states[0].eta;
    // H/(E g) = 0.01: d/sigma is -0.43 and -1.63 at 0.67 and 0.95 H (boundary elements, H/(E g) = 0.02), 0 at H/2
    CHECK(std::abs(states[1].separation.value) < 1e-3 * sigma);
    CHECK(std::abs(states[2].separation.value / sigma + 0.43) < 0.02);
    CHECK(std::abs(states[3].separation.value / sigma + 1.63) < 0.03);
    for (const auto& state : states) CHECK(state.loading_stiffness.value <= state.stiffness.value);
    CHECK(results.curves()[0].points.size() == 5);
    CHECK(contains(test::joined(results.warnings), "100 MPa reaches the hardness (100 MPa): the contact is closed"));
}

TEST_CASE("A contact that closes is reported, and has neither rows nor numbers beyond") {
    const test::Folder folder;
    const Answered closing(text_of(map_of(folder, 32), "pressures = [\"1 GPa\", \"900 GPa\"]\n"));
    REQUIRE(closing.rows.size() == 1);
    CHECK(closing.results.doubtful);
    const std::string said = test::joined(closing.results.warnings);
    INFO(said);
    CHECK(contains(said, "no K at 900 GPa: all points of the map are in contact"));
    CHECK_FALSE(contains(closing.rows.dump(), "null"));
    CHECK_FALSE(contains(test::csv_of(closing.results), "nan"));
}

TEST_CASE("nominal_area gives K in N/m and the scatter of as many contacts as it has") {
    const auto of_area = [](const std::string& area) {
        return Answered(text_of(numbers, "nominal_area = \"" + area + "\"\n" + wide));
    };
    const Answered none(text_of(numbers, wide)), large = of_area("100 mm^2"), small = of_area("0.01 mm^2");
    CHECK_FALSE(none.rows[0].contains("stiffness_N_per_m"));
    CHECK_FALSE(none.rows[0].contains("contacts"));
    CHECK(contains(actions::outside_band(none.results), "few contacts"));
    CHECK_FALSE(contains(actions::outside_band(large.results), "contacts"));
    for (std::size_t i = 0; i < 9; ++i) {
        CHECK(test::relative_error(double(large.rows[i].at("stiffness_N_per_m")), large.K(i) * 1e-4) < 1e-14);
        CHECK(test::relative_error(double(large.rows[i].at("contacts")), 1e4 * double(small.rows[i].at("contacts"))) <
              1e-12);
        CHECK(large.K(i) == small.K(i));
        CHECK(small.of_faces(i) > large.of_faces(i));
        CHECK(large.width(i) > none.width(i));
    }
    // the cause is that of the header, worked from the contacts
    const auto& reason = small.results.answer.points[4];
    CHECK(reason.causes[static_cast<std::size_t>(fstiff::Cause::contacts)].high ==
          fstiff::detail::scatter_of_contacts(*reason.contacts).high);
}

TEST_CASE(
    "A map is a piece of the face, or the contact itself where it is said to be the whole or the area is no larger") {
    const test::Folder folder;
    const std::string map = map_of(folder, 64), contact = "pressures = [\"100 MPa\"]\n";
    const Answered whole(text_of(map + "measured = \"whole\"\n", contact)), piece(text_of(map, contact)),
        written(text_of(map + "measured = \"piece\"\n", contact)),
        larger(text_of(map, "nominal_area = \"1 mm^2\"\n" + contact));
    CHECK(whole.results.answer.of_map_itself);
    CHECK_FALSE(piece.results.answer.of_map_itself);
    CHECK_FALSE(larger.results.answer.of_map_itself);
    CHECK(contains(actions::outside_band(whole.results), "other parts of the face (give contact.nominal_area)."));
    CHECK_FALSE(contains(actions::outside_band(larger.results), "nominal_area"));
    CHECK(whole.K(0) == piece.K(0));
    CHECK(written.width(0) == piece.width(0));
    CHECK(whole.rows[0].at("causes").size() < piece.rows[0].at("causes").size());
    CHECK(piece.width(0) > whole.width(0));
}

TEST_CASE("A profile across a lay widens the band upward, and the answer reports it") {
    const test::Folder folder;
    fstiff::Profile<double> profile = fstiff::self_affine_profile<double>(
        {.hurst = 0.7, .rms = 0.12e-6, .longest_wavelength = 60e-6, .shortest_wavelength = 16e-6}, 1024, 4e-6);
    const auto answered = [&](const char* name) {
        const std::string file = folder.write(name, test::file_text(profile));
        return Answered(text_of("[surface]\nfrom = '" + file + "'\n", "pressures = [\"10 MPa\"]\n"));
    };
    const Answered isotropic = answered("isotropic.csv");
    CHECK_FALSE(contains(isotropic.said(), "lay"));
    CHECK_FALSE(isotropic.rows[0].at("causes").contains("lay"));
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const double x = std::remainder(double(i) * 4, 256);
        profile.heights[i] += x * x / 1600 * 1e-6;
    }
    const Answered turned = answered("turned.csv");
    CHECK(has_lay(turned.of.joint));
    CHECK(turned.results.doubtful);
    CHECK(contains(turned.said(), "across a lay"));
    const double K = turned.K(0), low = turned.rows[0].at("stiffness_p05_Pa_per_m"),
                 high = turned.rows[0].at("stiffness_p95_Pa_per_m");
    CHECK(high / K >= fstiff::detail::lay_factor);
    CHECK(K / low < fstiff::detail::lay_factor);
    CHECK(double(turned.rows[0].at("causes").at("lay")) > 0.5);
}

TEST_CASE("The table of the answer has a row for each of its points, and fits the page") {
    const Answered answer(text_of(numbers, "nominal_area = \"1 mm^2\"\n" + wide, "hardness = \"1 GPa\"\n"));
    const auto table = actions::answer_table(answer.results);
    REQUIRE(table.size() == 10);
    CHECK(table[0] == std::vector<std::string>{"pressure", "K/A0 [MPa/µm]", "90 % band", "K [N/µm]", "loading K/A0",
                                               "law    ", table[0].back()});
    CHECK(table[1][0] == "1 MPa");
    for (std::size_t row = 1; row < 10; ++row) {
        CHECK(test::relative_error(std::stod(table[row][1]) * 1e12, answer.K(row - 1)) < 5e-3);
        CHECK(test::relative_error(std::stod(table[row][3]) * 1e6, answer.K(row - 1) * 1e-6) < 5e-3);
        CHECK(std::stod(table[row][4]) < std::stod(table[row][1]));
        CHECK(table[row][5] == "plastic");
        CHECK(contains(table[row][6], " %"));
    }
}

TEST_CASE("contact.interaction does not enter the answer, and one sentence reports it") {
    const std::string interaction = "interaction = { reading = \"effective_separation\", length = \"1 mm\" }\n";
    const Answered without(text_of(numbers, wide)), with(text_of(numbers, interaction + wide));
    CHECK(with.rows == without.rows);
    CHECK(without.results.warnings.empty());
    REQUIRE(with.results.warnings.size() == 1);
    CHECK(with.results.warnings[0] ==
          "contact.interaction does not affect the answer, whose laws include their own interaction");
    const auto named = test::results_of(text_of(numbers, "laws = [\"hertz\"]\n" + interaction + wide));
    CHECK_FALSE(contains(test::joined(named.warnings), "does not affect the answer"));
}

TEST_CASE("Causes in the band of the answer give no warning, except for laws that are named") {
    const test::Folder folder;
    fstiff::HeightMap<double> map = fstiff::self_affine_map<double>(
        {.hurst = 0.8, .rms = 0.3e-6, .longest_wavelength = 128e-6, .shortest_wavelength = 4e-6}, 128, 128, 1e-6, 1e-6);
    map.heights(20, 30) = 3e-6;  // a spike, which no band holds
    const std::string file = folder.write("map.csv", test::file_text(map)),
                      surface = "[surface]\nfrom = '" + file + "'\nlambda_s = \"none\"\n",
                      softer = "yield_strength = \"0.1 GPa\"\n";
    const Answered best(text_of(surface, "pressures = [\"10 MPa\"]\n", softer)),
        hertz(text_of(surface, "laws = [\"hertz\"]\npressures = [\"10 MPa\"]\n", softer));
    const std::string few = test::joined(best.results.warnings), all = test::joined(hertz.results.warnings);
    INFO(few << "\n---\n" << all);
    CHECK(best.results.warnings.size() == 2);  // the spike, and few summits
    CHECK(contains(few, "like spikes"));
    for (const char* words : {"like spikes", "waves longer than an eighth", "plasticity index"})
        CHECK(contains(all, words));
    CHECK_FALSE(best.results.doubtful);
    for (const std::string& sentence : best.results.warnings)  // the document of measure keeps which is which
        CHECK(std::count(test::measured_of(best.of).of_file.begin(), test::measured_of(best.of).of_file.end(),
                         sentence) == 1);
}

TEST_CASE("The measurement advised next narrows the band most, and by the printed factor") {
    const std::string metal = "hardness = \"2.6 GPa\"\n",
                      pressures = "pressures = [\"1 MPa\", \"10 MPa\", \"100 MPa\"]\n";
    const Answered little(text_of("[surface]\nRa = \"0.8 um\"\nprocess = \"blasted\"\n", pressures, metal)),
        more(text_of("[surface]\nRa = \"0.8 um\"\nprocess = \"blasted\"\nSdq = 0.22\n", pressures, metal));
    const std::string next = actions::measure_next(little.results), start = "measure Sdq or Rdq: the band at 10 MPa ";
    INFO(next);
    REQUIRE(next.starts_with(start + "narrows from a factor of "));
    double from = 0, to = 0;
    REQUIRE(std::sscanf(next.c_str() + start.size(), "narrows from a factor of %lf to %lf", &from, &to) == 2);
    CHECK(test::relative_error(from, little.width(1)) < 0.05);
    CHECK(test::relative_error(to, more.width(1)) < 0.05);
    CHECK(test::parsed(actions::run_document(little.results)).at("measure_next") == next);
    CHECK(actions::measure_next(more.results).starts_with("measure skewness and kurtosis"));
    const Answered all(text_of(numbers + "skewness = 0\nkurtosis = 3\n", pressures, metal));
    CHECK(actions::measure_next(all.results).empty());
    CHECK_FALSE(test::parsed(actions::run_document(all.results)).contains("measure_next"));
}

TEST_CASE("The band excludes a worn or honed face where the shape of the heights is not given") {
    const auto outside = [](const std::string& keys) {
        const Answered one(text_of("[surface]\nRa = \"0.8 um\"\n" + keys, wide));
        return actions::outside_band(one.results);
    };
    CHECK(contains(outside(""), "for a worn or honed face K may be several times higher (give process, or skewness"));
    for (const char* keys : {"process = \"honed\"\n", "skewness = 0\nkurtosis = 3\n"})
        CHECK_FALSE(contains(outside(keys), "honed"));
}

TEST_CASE("Without a measurement no band is described as sampled from errors") {
    const auto origin = [](const std::string& keys, const std::string& laws) {
        return actions::origin_of_band(test::results_of(text_of("[surface]\nRa = \"0.8 um\"\n" + keys, laws + wide)));
    };
    const std::string hybrid = "laws = [\"hybrid\"]\n", error = "errors = { Ra = \"0.1 um\" }\n";
    CHECK(origin("", hybrid) == "unknown parameters of the surface");
    CHECK(origin(error, hybrid) == "20 surfaces sampled from the errors, seed 2014; unknown parameters of the surface");
    CHECK(origin(error, "") == "the 90 % band of the answer");
}

}  // namespace answer_test
