// SPDX-License-Identifier: BSD-3-Clause
// fstiff export. Truth: the separations that fstiff run prints.
#include "cli/command.hpp"
#include "support/accuracy.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/core/version.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace export_test {

namespace {

struct Table {
    std::vector<double> pressures, overclosures;
};

/// The data lines below the keywords.
Table table_of(const std::string& text) {
    Table table;
    for (const std::string& line : test::lines(text)) {
        if (line.starts_with("*") || line == "1.,") continue;
        const auto comma = line.find(", ");
        REQUIRE(comma != std::string::npos);
        table.pressures.push_back(std::stod(line.substr(0, comma)));
        table.overclosures.push_back(std::stod(line.substr(comma + 2)));
        CHECK(comma <= 20);  // what CalculiX and Abaqus read of a number
        CHECK(line.size() - comma - 2 <= 20);
    }
    return table;
}

/// -dp/dd of the line of \p table at the pressure \p p.
double slope_at(const Table& table, double p) {
    const auto above = std::lower_bound(table.pressures.begin() + 1, table.pressures.end() - 1, p);
    const auto i = static_cast<std::size_t>(above - table.pressures.begin());
    return (table.pressures[i] - table.pressures[i - 1]) / (table.overclosures[i] - table.overclosures[i - 1]);
}

}  // namespace

TEST_CASE("export writes the keywords of either program, and one table in the units of the model") {
    const auto calculix = test::run_fstiff("export --to calculix");
    CHECK(calculix.status == 0);
    CHECK(test::contains(
        calculix.out, "\n*SURFACE INTERACTION, NAME=FSTIFF\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n0, 0\n"));
    const auto abaqus = test::run_fstiff("export --to abaqus --units m,N,Pa");
    CHECK(abaqus.status == 0);
    CHECK(test::contains(
        abaqus.out,
        "\n*Surface Interaction, name=FSTIFF\n1.,\n*Surface Behavior, pressure-overclosure=TABULAR\n0, 0\n"));

    const Table millimetres = table_of(calculix.out), metres = table_of(abaqus.out);
    REQUIRE(millimetres.pressures.size() > 10);
    REQUIRE(metres.pressures.size() == millimetres.pressures.size());
    for (std::size_t i = 1; i < metres.pressures.size(); ++i) {
        CHECK(test::relative_error(metres.pressures[i], 1e6 * millimetres.pressures[i]) < 1e-9);
        CHECK(test::relative_error(metres.overclosures[i], 1e-3 * millimetres.overclosures[i]) < 1e-9);
    }
    const Table inches = table_of(test::run_fstiff("export --to abaqus --units in,lbf,psi").out);
    CHECK(test::relative_error(inches.pressures.back() * 6894.757293168361, 1e8) < 1e-9);
    CHECK(test::relative_error(inches.overclosures.back() * 0.0254, metres.overclosures.back()) < 1e-9);
}

TEST_CASE("The comments give the source of the table and its range") {
    const std::string text = test::run_fstiff("export --to calculix --law hertz --peaks 2 --tolerance 5%").out;
    for (const std::string part :
         {"** fstiff " FSTIFF_VERSION_TEXT ": contact law for calculix, pressure against overclosure; its slope is "
          "-dp/dd, which is K of law hertz, within ",
          "(built-in scene), SHA-256 ", "hertz, theta = 1.0472, r = ",
          "mm, N, MPa; pressure [MPa] against overclosure [mm]", "0.1 to 100 MPa", "tolerance 5 %", "tolerance 2 %",
          "faces drawn in contact have overclosure 0", "the pressure stays constant"}) {
        INFO(part);
        CHECK(test::contains(text, part));
    }
    const test::Folder folder;  // a name may hold what would end a comment
    const std::string scene = test::read(FSTIFF_SCENES "/sand_blasted_coarse.toml");
    folder.write("a\n*STEP.toml", scene);
    const auto odd = test::shell("fstiff export '" + folder / "a\n*STEP.toml" + "' --to abaqus");
    CHECK(odd.status == 0);
    CHECK_FALSE(test::contains(odd.out, "\n*STEP"));
}

TEST_CASE("export writes the law of the answer, the K that run prints, and where its slope is not K") {
    const auto outcome = test::run_fstiff("export --to abaqus --units m,N,Pa");
    const std::string first = test::lines(outcome.out).front();
    const test::Csv run(test::run_fstiff("run --format csv").out);
    CHECK(run.text(0, "law") == "plastic");
    CHECK(test::contains(first, "its slope is -dp/dd, 0."));  // of loading, where K is that of unloading
    CHECK(test::contains(first, " of K of law plastic, within "));
    const auto hertz = test::run_fstiff("export --to abaqus --law hertz");
    CHECK(test::contains(test::lines(hertz.out).front(), "its slope is -dp/dd, which is K of law hertz, within "));
    CHECK(hertz.err.find("slope") == std::string::npos);
    const double K = run.number(30, "stiffness_Pa_per_m");
    CHECK(test::contains(
        outcome.out, "** answer    at 100000000 Pa K is " + fstiff::detail::rounded_text(K, 4) + " Pa/m, 90 % band "));
    CHECK(outcome.status == 0);
    CHECK(test::contains(outcome.err, "warning: the slope of the table is -dp/dd, 0."));
    CHECK(test::contains(outcome.err, "--law answer has the K of the answer as its slope"));
    const auto fractal = test::run_fstiff("export --to abaqus --law fractal");
    // (2/3) (3 - D)/(2 - D) of D = 1.62
    CHECK(test::contains(test::lines(fractal.out).front(), "its slope is -dp/dd, 0.413 of K of law fractal"));
    CHECK(test::contains(fractal.err, "warning: the slope of the table is -dp/dd, 0.413 of K of law fractal"));
    CHECK_FALSE(test::contains(fractal.out, "** answer"));
}

TEST_CASE("The table of law answer has the K that run prints, and the ends of its band, as its slope") {
    const test::Folder folder;
    const std::string three = folder.write("three.toml",
                                           "surface = { rms_height = '0.8 um', rms_gradient = 0.1 }\n"
                                           "material = { upper = 'steel', lower = 'cast_iron' }\n"
                                           "contact.pressures = ['0.1 MPa', '7 MPa', '150 MPa']\n");
    const std::pair<std::string, std::string> ends[]{{"5%", "_p05"}, {"0.5", ""}, {"95%", "_p95"}};
    for (const std::string& scene : {std::string(), three})  // many points, and three
        for (const auto& [quantile, end] : ends) {
            CAPTURE(scene, quantile);
            const test::Csv run(test::run_fstiff("run " + scene + " --format csv").out);
            const std::string of_law = "export " + scene + " --law answer --quantile " + quantile;
            const auto outcome = test::run_fstiff(of_law + " --to abaqus --units m,N,Pa --slope-tolerance 0.1%");
            CHECK(outcome.status == test::run_fstiff("run " + scene).status);
            CHECK_FALSE(test::contains(outcome.err, "slope"));
            CHECK(test::contains(test::lines(outcome.out).front(), "its slope is -dp/dd, which is K of the answer"));
            const Table table = table_of(outcome.out);
            const auto law = fstiff::ContactLaw<double>::from_text(test::run_fstiff(of_law + " --to law").out);
            CHECK(law.stiffness_is_slope());
            for (std::size_t i = 0; i < run.size(); ++i) {
                const double p = run.number(i, "pressure_Pa"), K = run.number(i, "stiffness" + end + "_Pa_per_m");
                CAPTURE(p);
                if (scene.empty() && end == "_p05") continue;  // of faces, and run has the form of the joint there
                CHECK(test::relative_error(slope_at(table, p), K) < 1.1e-3);  // at an end of a line 1e-3
                CHECK(test::relative_error(law.stiffness(std::clamp(p, law.pressures()[0], law.pressures()[1])), K) <
                      1e-3);
            }
        }
}

TEST_CASE("Law answer goes to every program, with heat and friction of its own K") {
    const test::Folder folder;
    const std::string scene =
        folder.write("joint.toml",
                     "material.upper = { name = 'steel', thermal_conductivity = '45 W/(m K)' }\n"
                     "material.lower = { name = 'aluminium', thermal_conductivity = '165 W/(m K)' }\n"
                     "surface = { Sq = '0.8 um', Sdq = 0.1 }\n"
                     "contact.pressures = ['1 MPa', '10 MPa', '50 MPa']\n"
                     "gap.medium = 'air'\nfriction.coefficient = 0.2\n"
                     "output.quantities = ['stiffness', 'separation', 'tangential_stiffness', "
                     "'thermal_conductance']\n");
    const test::Csv run(test::run_fstiff("run " + scene + " --format csv").out);
    const std::size_t last = run.size() - 1;
    for (const std::string end : {"", "_p05", "_p95"}) {
        CAPTURE(end);
        const std::string of_law =
            "export " + scene + " --law answer" + (end.empty() ? "" : " --quantile " + end.substr(2) + "%") + " --to ";
        std::istringstream cells(test::lines(test::run_fstiff(of_law + "moose --units m,N,Pa").out).back());
        std::vector<double> row;
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
        REQUIRE(row.size() == 4);  // overclosure, pressure, tangential stiffness, conductance with the gap
        CHECK(test::relative_error(row[1], 50e6) < 1e-9);
        CHECK(test::relative_error(row[2], run.number(last, "tangential_stiffness" + end + "_Pa_per_m")) < 1e-3);
        CHECK(test::relative_error(row[3], run.number(last, "thermal_conductance" + end + "_W_per_m2K") +
                                               run.number(last, "thermal_conductance_gap_W_per_m2K")) < 1e-3);
        for (const std::string to : {"calculix", "abaqus", "comsol"}) CHECK(test::run_fstiff(of_law + to).status == 0);
    }
}

TEST_CASE("Law answer is that of a scene with laws or separations too, up to where the contact closes") {
    const test::Folder folder;
    const std::string begin =
        "surface = { rms_height = '0.8 um', rms_gradient = 0.1 }\n[material.upper]\nyoungs_modulus = '205 GPa'\n"
        "poisson_ratio = 0.3\nhardness = '50 MPa'\n[contact]\n";
    const auto law_of = [&](const std::string& contact, const std::string& range = "") {
        const std::string arguments =
            "export " + folder.write("scene.toml", begin + contact) + " --to law --law answer ";
        return fstiff::ContactLaw<double>::from_text(test::run_fstiff(arguments + range).out);
    };
    const auto closing = law_of("pressures = ['1 MPa', '10 MPa', '100 MPa']\n"),
               of_laws = law_of("laws = ['hybrid']\npressures = ['1 MPa', '10 MPa', '40 MPa']\n"),
               of_separations =
                   law_of("laws = ['hybrid']\nseparations = ['1 um', '2 um']\n", "--from '1 MPa' --until '40 MPa'");
    CHECK(closing.pressures()[1] > 39e6);
    CHECK(closing.pressures()[1] < 50e6);
    CHECK(test::relative_error(of_laws.stiffness(1e7), closing.stiffness(1e7)) < 1e-3);
    CHECK(test::relative_error(of_separations.stiffness(1e7), closing.stiffness(1e7)) < 1e-3);
    const std::string scene = folder.write("closing.toml", begin + "pressures = ['1 MPa', '10 MPa', '100 MPa']\n");
    CHECK(test::contains(test::run_fstiff("export --to abaqus --law answer " + scene).err, "no K at "));
}

TEST_CASE("export writes the law itself, of a map too, with the K that run prints") {
    const test::Folder folder;
    REQUIRE(
        test::run_fstiff("generate map --seed 3 --points 64 --rows 64 --spacing \"1 um\" --rms \"0.5 um\" --shortest "
                         "\"8 um\" --hurst 0.8 --format sdf -o " +
                         folder / "map.sdf")
            .status == 0);
    const std::string file = folder / "map.law";
    for (const std::string law : {"hybrid", "summits", "persson", "plastic", "hertz"}) {
        CAPTURE(law);
        const std::string scene =
            folder.write(law + ".toml",
                         "name = \"m\"\n[surface]\nfrom = \"map.sdf\"\n[material.upper]\nyoungs_modulus = \"205 GPa\"\n"
                         "poisson_ratio = 0.3\nhardness = \"6 GPa\"\n[material.lower]\nyoungs_modulus = \"205 GPa\"\n"
                         "poisson_ratio = 0.3\nhardness = \"6 GPa\"\n[contact]\nlaws = [\"" +
                             law + "\"]\npressures = [\"3 MPa\", \"10 MPa\", \"50 MPa\"]\n");
        const auto outcome = test::run_fstiff("export " + scene + " --to law -o " + file);
        CAPTURE(outcome.err);
        REQUIRE(outcome.status == 0);
        const auto table = fstiff::ContactLaw<double>::from_text(test::read(file));
        CHECK(table.relative_error() <= 1e-3);
        const test::Csv run(test::run_fstiff("run " + scene + " --format csv").out);
        for (std::size_t i = 0; i < run.size(); ++i) {
            if (run.text(i, "answer") == "1") continue;  // by boundary elements, which have no table
            const double p = std::clamp(run.number(i, "pressure_Pa"), table.pressures()[0], table.pressures()[1]);
            CHECK(test::relative_error(table.stiffness(p), run.number(i, "stiffness_Pa_per_m")) < 1e-3);
        }
    }
    test::check_refused("export --to law --law boundary_elements", 3, {"boundary_elements"});
}

TEST_CASE("The law after a load is stiffer below it than the answer, and meets the first loading there") {
    const test::Folder folder;
    const std::string scene = folder.write("joint.toml",
                                           "surface = { rms_height = '0.8 um', rms_gradient = 0.1 }\n"
                                           "material = { upper = 'steel', lower = 'cast_iron' }\n"
                                           "contact.pressures = ['1 MPa', '100 MPa']\n");
    const std::string of_law = "export " + scene + " --law answer";
    const auto law_of = [&](const std::string& more) {
        const auto outcome = test::run_fstiff(of_law + more + " --to law");
        CAPTURE(outcome.err);
        REQUIRE(outcome.status == 0);
        return fstiff::ContactLaw<double>::from_text(outcome.out);
    };
    const auto answer = law_of(""), after = law_of(" --after 30MPa");
    CHECK(after.stiffness_is_slope());
    CHECK(test::relative_error(after.stiffness(29.9e6), answer.stiffness(30e6)) < 5e-3);
    CHECK(after.stiffness(5e6) > 1.1 * answer.stiffness(5e6));
    CHECK(after.stiffness(31e6) < 0.9 * after.stiffness(29.9e6));  // the first loading goes on
    const auto card = test::run_fstiff(of_law + " --after 30MPa --until 30MPa --to calculix");  // without the jump
    CHECK(card.status == 0);
    CHECK(test::contains(card.out, "its slope is -dp/dd, which is K of the answer, after 30 MPa"));
    test::check_refused(of_law + " --after 300MPa --to law", 3,
                        {"--after = 3e+08: must be above 1e+06 and at most 1e+08 Pa"});
    test::check_refused(of_law + " --after 30 --to law", 3, {"--after", "without a unit"});
    test::check_refused("export " + scene + " --after 30MPa --to law", 3, {"--after: is for --law answer"});
}

TEST_CASE("export refuses in one sentence") {
    test::check_refused("export", 2, {"--to is required"});
    test::check_refused("export --to nastran", 2, {"nastran", "calculix"});
    test::check_refused("export --to abaqus --units mm", 3, {"--units = \"mm\"", "length, force and pressure"});
    test::check_refused("export --to abaqus --units mm,N,Pa", 3, {"consistent", "1 N/mm^2 is 1e+06 Pa"});
    test::check_refused("export --to abaqus --units mm,kgf,MPa", 3, {"kgf is not a unit of force"});
    test::check_refused("export --to abaqus --units mm,N,bananas", 3, {"--units", "bananas"});
    test::check_refused("export --to abaqus --tolerance much", 3, {"--tolerance", "much"});
    test::check_refused("export --to abaqus --tolerance 30%", 3, {"--tolerance = 0.3", "20 %"});
    test::check_refused("export --to abaqus --slope-tolerance 0.01%", 3, {"--slope-tolerance = 0.0001", "0.1 %"});
    test::check_refused("export --to abaqus --law nonsense", 3, {"--law = \"nonsense\"", "\"hertz\""});
    test::check_refused("export --to abaqus --law summits", 3, {"\"summits\"", "\"persson\", \"plastic\""});
    test::check_refused("export --to abaqus --law answer --quantile 10%", 3,
                        {"--quantile = 0.1: must be 5 %, 50 % or 95 %"});
    test::check_refused("export --to abaqus --law answer --quantile much", 3, {"--quantile", "much"});
    test::check_refused("export --to abaqus --quantile 5%", 3, {"--quantile: is for --law answer"});
    test::check_refused("export --to abaqus --from 5", 3, {"--from", "without a unit"});
    test::check_refused("export missing.toml --to abaqus", 3, {"missing.toml"});
}

}  // namespace export_test
