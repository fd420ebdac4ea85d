// SPDX-License-Identifier: BSD-3-Clause
// Heat, current and friction in what fstiff export writes, read back as each program reads it. Truth: the columns of
// fstiff run at pressures between the rows.
#include "cli/command.hpp"
#include "support/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace export_programs_test {

namespace {

constexpr double coefficient = 0.2;
const std::string bodies_and_law =
    "material = { upper = \"steel\", lower = \"aluminium\" }\n[surface]\nSq = \"0.8 um\"\nSdq = 0.1\n"
    "[contact]\nlaws = [\"hybrid\"]\n"
    "pressures = { from = \"1 MPa\", to = \"50 MPa\", count = 7, spacing = \"log\" }\n";
const std::string scene =
    bodies_and_law +
    "[gap]\nmedium = \"air\"\n[friction]\ncoefficient = 0.2\n[output]\nquantities = [\"stiffness\", "
    "\"separation\", \"tangential_stiffness\", \"thermal_conductance\", \"electrical_conductance\"]\n";

using Numbers = std::vector<double>;

/// The rows of the law that fstiff run prints, without those of the answer.
struct Printed {
    Numbers pressure, separation, tangential, heat, gap, current;
};

Printed printed() {
    const test::Csv run(test::run_fstiff("run - --format csv", scene).out);
    Printed all;
    for (std::size_t i = 0; i < run.size(); ++i) {
        if (run.text(i, "answer") == "1") continue;
        all.pressure.push_back(run.number(i, "pressure_Pa"));
        all.separation.push_back(run.number(i, "separation_m"));
        all.tangential.push_back(run.number(i, "tangential_stiffness_Pa_per_m"));
        all.gap.push_back(run.number(i, "thermal_conductance_gap_W_per_m2K"));
        all.heat.push_back(run.number(i, "thermal_conductance_W_per_m2K") + all.gap.back());
        all.current.push_back(run.number(i, "electrical_conductance_S_per_m2"));
    }
    return all;
}

/// The data lines of each card, by the line of its keyword, as columns.
std::map<std::string, std::vector<Numbers>> cards_of(const std::string& text) {
    std::map<std::string, std::vector<Numbers>> cards;
    std::string card;
    for (const std::string& line : test::lines(text)) {
        if (line.starts_with("**")) continue;
        if (line.starts_with("*")) {
            card = line;
            continue;
        }
        std::istringstream cells(line);
        std::size_t column = 0;
        for (std::string cell; std::getline(cells, cell, ','); ++column) {
            if (cell.find_first_not_of(' ') == std::string::npos) continue;
            cards[card].resize(std::max(cards[card].size(), column + 1));
            cards[card][column].push_back(std::stod(cell));
        }
    }
    return cards;
}

/// The columns below a line of names, \p between the cells.
std::map<std::string, Numbers> columns_of(const std::string& text, const std::string& comment, char between,
                                          const std::string& before_names) {
    std::map<std::string, Numbers> columns;
    std::vector<std::string> names;
    for (std::string line : test::lines(text)) {
        const bool is_names = line.starts_with(before_names + "overclosure" + between);
        if (line.starts_with(comment) && !is_names) continue;
        if (is_names) line = line.substr(before_names.size());
        std::istringstream cells(line);
        std::size_t column = 0;
        for (std::string cell; std::getline(cells, cell, between); ++column) {
            if (is_names)
                names.push_back(cell);
            else
                columns[names.at(column)].push_back(std::stod(cell));
        }
    }
    return columns;
}

/// y at \p x on the lines between the points, and the end beyond them.
double interpolated(const Numbers& xs, const Numbers& ys, double x) {
    REQUIRE(xs.size() == ys.size());
    REQUIRE(xs.size() > 2);
    CHECK(std::is_sorted(xs.begin(), xs.end()));
    const auto above = std::lower_bound(xs.begin(), xs.end(), x);
    if (above == xs.begin()) return ys.front();
    if (above == xs.end()) return ys.back();
    const auto i = static_cast<std::size_t>(above - xs.begin());
    return ys[i - 1] + (ys[i] - ys[i - 1]) * (x - xs[i - 1]) / (xs[i] - xs[i - 1]);
}

}  // namespace

TEST_CASE("CalculiX finds the conductance of the pressure that a table gives it") {
    const auto outcome = test::run_fstiff("export - --to calculix --tolerance 1%", scene);
    CHECK(outcome.status == 0);
    auto cards = cards_of(outcome.out);
    const auto& pressure = cards["*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR"];
    const auto& exponential = cards["*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL"];
    const auto& heat = cards["*GAP CONDUCTANCE"];
    REQUIRE(heat.size() == 3);
    for (const double temperature : heat[2]) CHECK(temperature == 293);  // one curve: none of them depends on it
    const Printed truth = printed();
    for (std::size_t i = 0; i < truth.pressure.size(); ++i) {
        const double x = interpolated(pressure[0], pressure[1], 1e-6 * truth.pressure[i]);
        // p = p0 exp(ln(100) x/c0) of the manual
        const double seen = exponential[1][0] * std::exp(std::log(100.0) * x / exponential[0][0]);
        // 1 % of the pressure and 1 % of the conductance, which grows less than the pressure does
        CHECK(test::relative_error(interpolated(heat[1], heat[0], seen), 1e-3 * truth.heat[i]) < 0.02);
    }
    CHECK(test::contains(outcome.out, "step must have NLGEOM"));
    CHECK(outcome.out.find("EXPONENTIAL") < outcome.out.find("TABULAR"));  // the last card is the law of the contact
}

TEST_CASE("Abaqus finds conductances by the pressure") {
    for (const auto& [tolerance, largest] : {std::pair("1%", 0.01), std::pair("0.1%", 0.001)}) {
        auto cards =
            cards_of(test::run_fstiff(std::string("export - --to abaqus --tolerance ") + tolerance, scene).out);
        const auto& heat = cards["*Gap Conductance, pressure"];
        const auto& current = cards["*Gap Electrical Conductance, pressure"];
        REQUIRE(heat.size() == 2);
        REQUIRE(current.size() == 2);
        const Printed truth = printed();
        for (std::size_t i = 0; i < truth.pressure.size(); ++i) {
            const double p = 1e-6 * truth.pressure[i];
            CHECK(test::relative_error(interpolated(heat[1], heat[0], p), 1e-3 * truth.heat[i]) < largest);
            CHECK(test::relative_error(interpolated(current[1], current[0], p), 1e-6 * truth.current[i]) < largest);
        }
        CHECK(current[0][0] == 0);
        CHECK(heat[1][0] == 0);
    }
}

TEST_CASE("Where the faces touch without a pressure what fills the gap conducts alone") {
    const auto outcome = test::run_fstiff("export - --to abaqus --units m,N,Pa", scene);
    const Printed truth = printed();
    const std::string zero = outcome.out.substr(outcome.out.find("the mean planes of the roughness are then"));
    const double separation = std::stod(test::lines(zero).at(1).substr(2));
    constexpr double air = 0.0257;
    const double jump = air / truth.gap[0] - truth.separation[0];  // of the temperature, as a length
    auto cards = cards_of(outcome.out);
    CHECK(test::relative_error(cards["*Gap Conductance, pressure"][0][0], air / (separation + jump)) < 1e-6);
    const std::string without = bodies_and_law + "[output]\nquantities = [\"thermal_conductance\"]\n";
    cards = cards_of(test::run_fstiff("export - --to abaqus --units m,N,Pa", without).out);
    CHECK(cards["*Gap Conductance, pressure"][0][0] == 0);
}

TEST_CASE("A film on the spots and radiation are in the conductances of the file") {
    const std::string film = bodies_and_law +
                             "[gap]\nemissivity = 0.3\ntemperature = \"600 K\"\nthermal_film = \"1 mm^2 K/W\"\n"
                             "electrical_film = \"1 ohm um^2\"\n[output]\nquantities = [\"thermal_conductance\", "
                             "\"electrical_conductance\"]\n";
    auto cards = cards_of(test::run_fstiff("export - --to abaqus --units m,N,Pa", film).out);
    const test::Csv run(test::run_fstiff("run - --format csv", film).out);
    const std::size_t last = run.size() - 1;  // of the law, after the rows of the answer
    CHECK(test::relative_error(cards["*Gap Conductance, pressure"][0].back(),
                               run.number(last, "thermal_conductance_W_per_m2K") +
                                   run.number(last, "thermal_conductance_gap_W_per_m2K")) < 1e-6);
    CHECK(test::relative_error(cards["*Gap Electrical Conductance, pressure"][0].back(),
                               run.number(last, "electrical_conductance_S_per_m2")) < 1e-6);
}

TEST_CASE("The cards of friction stick with the tangential stiffness at one pressure") {
    const Printed truth = printed();
    const double middle = truth.pressure[3];  // of seven, in decades
    for (const std::string& at : {std::string(), " --at " + std::to_string(truth.pressure[1]) + "Pa"}) {
        const std::size_t row = at.empty() ? 3 : 1;
        auto calculix = cards_of(test::run_fstiff("export - --to calculix" + at, scene).out);
        const auto& friction = calculix["*FRICTION"];
        REQUIRE(friction.size() == 2);
        CHECK(friction[0][0] == coefficient);
        CHECK(test::relative_error(friction[1][0], 1e-9 * truth.tangential[row]) < 1e-4);

        auto abaqus = cards_of(test::run_fstiff("export - --to abaqus" + at, scene).out);
        const std::string keyword = "*Friction, elastic slip=";
        const auto card =
            std::find_if(abaqus.begin(), abaqus.end(), [&](const auto& one) { return one.first.starts_with(keyword); });
        REQUIRE(card != abaqus.end());
        CHECK(card->second[0][0] == coefficient);
        const double slip = std::stod(card->first.substr(keyword.size()));
        CHECK(test::relative_error(coefficient * 1e-6 * truth.pressure[row] / slip, 1e-9 * truth.tangential[row]) <
              1e-4);
    }
    const std::string text = test::run_fstiff("export - --to calculix --units m,N,Pa", scene).out;
    CHECK(test::contains(text, "holds at " + fstiff::detail::rounded_text(middle, 10) + " Pa; it is " +
                                   fstiff::detail::rounded_text(truth.tangential.front(), 4) + " at 1000000 Pa and " +
                                   fstiff::detail::rounded_text(truth.tangential.back(), 4) + " at 50000000 Pa"));
}

TEST_CASE("MOOSE and COMSOL find every column by overclosure and by pressure") {
    const Printed truth = printed();
    const auto check = [&](std::map<std::string, Numbers> columns) {
        REQUIRE(columns.size() == 5);
        const Numbers &x = columns["overclosure"], &p = columns["pressure"];
        CHECK(x.at(0) == 0);
        CHECK(p.at(0) == 0);
        for (std::size_t i = 0; i < truth.pressure.size(); ++i) {
            // rows lie on the law, so that the ways of the faces are those of the separations
            const double way = truth.separation[0] - truth.separation[i], begin = interpolated(p, x, truth.pressure[0]);
            const auto near = [&](const char* name, const Numbers& values) {
                INFO(name << " at " << truth.pressure[i]);
                CHECK(test::relative_error(interpolated(p, columns[name], truth.pressure[i]), values[i]) < 0.01);
                CHECK(test::relative_error(interpolated(x, columns[name], begin + way), values[i]) < 0.01);
            };
            near("pressure", truth.pressure);
            near("tangential_stiffness", truth.tangential);
            near("thermal_conductance", truth.heat);
            near("electrical_conductance", truth.current);
        }
    };
    const auto moose = test::run_fstiff("export - --to moose --units m,N,Pa", scene);
    CHECK(moose.status == 0);
    check(columns_of(moose.out, "#", ',', ""));
    const auto comsol = test::run_fstiff("export - --to comsol --units m,N,Pa", scene);
    CHECK(comsol.status == 0);
    check(columns_of(comsol.out, "%", ' ', "% "));
    CHECK(test::contains(moose.out, "# friction  coefficient 0.2\n"));

    const auto millimetres = columns_of(test::run_fstiff("export - --to moose", scene).out, "#", ',', "");
    const auto metres = columns_of(moose.out, "#", ',', "");
    for (const auto& [name, factor] :
         {std::pair("overclosure", 1e3), std::pair("pressure", 1e-6), std::pair("tangential_stiffness", 1e-9),
          std::pair("thermal_conductance", 1e-3), std::pair("electrical_conductance", 1e-6)})
        CHECK(test::relative_error(millimetres.at(name).back(), factor * metres.at(name).back()) < 1e-9);
}

TEST_CASE("A scene without heat and friction has their cards and columns in no file") {
    for (const std::string to : {"calculix", "abaqus", "moose", "comsol"}) {
        const std::string text = test::run_fstiff("export --to " + to).out;
        CHECK(text.size() > 1000);
        for (const std::string word : {"onductance", "CONDUCTANCE", "riction", "FRICTION", "EXPONENTIAL"})
            CHECK_FALSE(test::contains(text, word));
    }
    const auto columns = columns_of(test::run_fstiff("export --to moose").out, "#", ',', "");
    CHECK(columns.size() == 2);
}

TEST_CASE("export reports where CalculiX resamples a table") {
    const auto warnings = [](const std::string& options) { return test::run_fstiff("export - " + options, scene).err; };
    CHECK(test::contains(warnings("--to calculix --tolerance 0.001%"), "more than 200 rows"));
    const std::string shorter = warnings("--to calculix --slope-tolerance 0.5%");
    CHECK(test::contains(shorter, "a shorter range, such as "));
    CHECK(test::contains(shorter, " to 50 or 1 to "));
    CHECK_FALSE(test::contains(warnings("--to calculix --tolerance 0.1%"), "200"));
    CHECK_FALSE(test::contains(warnings("--to abaqus --tolerance 0.001%"), "200"));
}

TEST_CASE("export refuses a pressure of friction that it has no use for") {
    test::check_refused("export --to calculix --at '1 MPa'", 3, {"--at", "[friction]"});
    const std::string range = "must be from 1e+06 Pa to 5e+07 Pa, the range of the table";
    for (const auto& [at, why] : {std::pair("'51 MPa'", range), {"'0.9 MPa'", range}, {"5", ""}})
        test::check_refused("export - --to abaqus --at " + std::string(at), 3, {"--at", why}, scene);
}

}  // namespace export_programs_test
