// SPDX-License-Identifier: BSD-3-Clause
#include "command.hpp"

#include "support/accuracy.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace identify_test {

namespace {

/// A scene with one law and peak density; \p sigma and \p density are what the fits start from.
std::string scene(const std::string& sigma = "0.832 um", const std::string& density = "500 /mm^2",
                  const std::string& laws = "\"hertz\"") {
    return "name = \"fine\"\n[surface]\nrms_height = \"" + sigma + "\"\npeak_radius = \"40 um\"\npeak_density = \"" +
           density +
           "\"\nfractal_dimension = 1.62\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
           "[contact]\npressures = { from = \"1 MPa\", to = \"60 MPa\", count = 12 }\nlaws = [" +
           laws +
           "]\npeaks = [ { theta = \"pi/3\", r = 0.4 } ]\n[ultrasound]\nfrequency = \"7 MHz\"\n"
           "upper = { density = \"7850 kg/m^3\", velocity = \"5900 m/s\", shear_velocity = \"3200 m/s\" }\n";
}

/// K(p) or R(p) of the scene as a measured file: with errors of \p error of K, or absolute for R, and disturbed by
/// \p noise of them up and down in turn.
std::string measured(const std::string& column, double error, double noise = 0, const std::string& text = scene()) {
    const auto outcome = test::run_fstiff("run - --format csv", text);
    REQUIRE(outcome.status == 0);
    const test::Csv rows(outcome.out);
    const bool is_stiffness = test::contains(column, "stiffness");
    std::string file = std::string("pressure [Pa],") + (is_stiffness ? "stiffness [Pa/m]" : "reflection") +
                       (error > 0 ? is_stiffness ? ",error [Pa/m]" : ",error" : "") + "\n";
    const double pattern[4] = {1, -0.6, -1.2, 0.8};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows.text(i, "answer") == "1") continue;  // of the law that is named
        const double value = rows.number(i, column), deviation = is_stiffness ? error * value : error;
        char line[128];
        std::snprintf(line, sizeof line, "%.17g,%.17g", rows.number(i, "pressure_Pa"),
                      value + noise * deviation * pattern[i % 4]);
        file += line;
        std::snprintf(line, sizeof line, ",%.17g", deviation);
        file += (error > 0 ? line : "") + std::string("\n");
    }
    return file;
}

/// identify of the scene and the data in \p folder.
test::Outcome outcome_of(const test::Folder& folder, const std::string& arguments) {
    return test::run_fstiff("identify '" + folder / "scene.toml" + "' --measured '" + folder / "data.csv" + "' " +
                            arguments);
}

nlohmann::json identify(const test::Folder& folder, const std::string& start, const std::string& data,
                        const std::string& arguments, int status = 0) {
    folder.write("scene.toml", start);
    folder.write("data.csv", data);
    const auto outcome = outcome_of(folder, "--format json " + arguments);
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == status);
    return nlohmann::json::parse(outcome.out);
}

/// The lines of \p data with \p factor of their pressures, plus \p shift.
std::string with_pressures(const std::string& data, double factor, double shift) {
    std::string all;
    for (const std::string& line : test::lines(data)) {
        char number[64] = "";
        if (!all.empty()) std::snprintf(number, sizeof number, "%.17g", factor * std::stod(line) + shift);
        all += (all.empty() ? line : number + line.substr(line.find(','))) + "\n";
    }
    return all;
}

double value(const nlohmann::json& fit, std::size_t i) { return fit["parameters"][i]["value"].get<double>(); }

}  // namespace

TEST_CASE("identify finds parameters from reflections, longitudinal and shear, and the offset of the pressure") {
    const test::Folder folder;
    const std::string start = scene("0.7 um", "600 /mm^2");
    for (const std::string wave : {"", "shear_"}) {
        const auto document =
            identify(folder, start, measured(wave + "reflection", 1e-4),
                     "--fit rms_height,peak_density" + std::string(wave.empty() ? "" : " --wave shear"));
        INFO(document.dump(1));
        // 1 - R is 4e-6 at 1 MPa and K comes from the lost digits; the points at high pressure carry the fit
        CHECK(test::relative_error(value(document["fits"][0], 0), 0.832e-6) < 1e-7);
        CHECK(test::relative_error(value(document["fits"][0], 1), 500e6) < 1e-7);
        CHECK(document["measured"]["quantity"] == "reflection");
    }
    // every pressure is read 0.2 MPa too low
    const std::string shifted = with_pressures(measured("stiffness_Pa_per_m", 0.01), 1, -0.2e6);
    const auto document = identify(folder, start, shifted, "--fit sigma,Dp,offset");
    CHECK(test::relative_error(value(document["fits"][0], 2), 0.2e6) < 1e-7);
}

TEST_CASE(
    "identify: the covariance is symmetric, its diagonal the squared errors, and the residuals are those of the data") {
    const test::Folder folder;
    const auto document = identify(folder, scene(), measured("stiffness_Pa_per_m", 0.02, 1), "--fit sigma,Dp");
    const auto& fit = document["fits"][0];
    CHECK(fit["status"] == "converged");
    CHECK(fit["degrees_of_freedom"] == 10);
    CHECK(fit["parameters"][0]["start"] == 0.832e-6);
    double sum = 0;
    for (const auto& row : fit["rows"]) {
        const double residual =
            (row["model"].get<double>() - row["stiffness_Pa_per_m"].get<double>()) / row["error"].get<double>();
        CHECK(std::abs(row["residual"].get<double>() - residual) < 1e-10);
        sum += residual * residual;
    }
    CHECK(test::relative_error(fit["chi_squared"].get<double>(), sum) < 1e-10);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& p = fit["parameters"][i];
        const double error = p["standard_error"].get<double>();
        CHECK(test::relative_error(fit["covariance"][i][i].get<double>(), error * error) < 1e-12);
        CHECK(fit["correlation"][i][i] == 1.0);
        // even in the logarithm, 1.96 standard errors to each side
        const double width = std::exp(1.959963984540054 * error / p["value"].get<double>());
        CHECK(test::relative_error(p["interval"]["high"].get<double>(), p["value"].get<double>() * width) < 1e-12);
        CHECK(test::relative_error(p["interval"]["low"].get<double>(), p["value"].get<double>() / width) < 1e-12);
    }
    CHECK(fit["covariance"][0][1] == fit["covariance"][1][0]);
}

TEST_CASE("identify without errors takes them from the scatter") {
    const test::Folder folder;
    const std::string with = measured("stiffness_Pa_per_m", 0.02, 1);
    std::string without;  // the same data without their last column
    for (const std::string& line : test::lines(with)) without += line.substr(0, line.rfind(',')) + "\n";
    const auto known = identify(folder, scene(), with, "--fit sigma")["fits"][0];
    const auto unknown = identify(folder, scene(), without, "--fit sigma")["fits"][0];
    CHECK(known["errors_known"] == true);
    CHECK(unknown["errors_known"] == false);
    // weights 1/(2 % of the true K) and 1/(measured K): nearly the same fit, the scatter instead of the errors
    const double scatter = std::sqrt(known["chi_squared"].get<double>() / 11);
    CHECK(test::relative_error(unknown["parameters"][0]["standard_error"].get<double>(),
                               scatter * known["parameters"][0]["standard_error"].get<double>()) < 0.05);
}

TEST_CASE("identify: parameters that the data cannot distinguish end with exit code 4 and their names") {
    const test::Folder folder;
    const std::string data = measured("stiffness_Pa_per_m", 0.02);
    const auto product = identify(folder, scene(), data, "--fit R,Dp,offset", 4);
    const std::string warning = product["warnings"][0];
    INFO(warning);
    CHECK(test::contains(warning, "cannot distinguish R and Dp"));
    CHECK(test::contains(warning, "E Dp sqrt(R)"));
    CHECK(product["fits"][0]["status"] == "singular");
    CHECK(!product["fits"][0].contains("covariance"));
    CHECK(!product["fits"][0]["parameters"][0].contains("value"));
    const auto blind = identify(folder, scene(), data, "--fit D", 4);
    CHECK(test::contains(blind["warnings"][0].get<std::string>(), "do not depend on D here"));
    const auto table = outcome_of(folder, "--fit R,Dp"), csv = outcome_of(folder, "--fit R,Dp --format csv");
    CHECK(table.status == 4);
    CHECK(test::contains(table.out, "singular"));
    CHECK(test::contains(table.out, "warning: hertz"));
    CHECK(test::Csv(csv.out).text(1, "value").empty());
    CHECK(test::contains(csv.err, "cannot distinguish R and Dp"));
}

TEST_CASE("identify reports a parameter at the end of its range, or hardly known") {
    const test::Folder folder;
    // D would have to make K smaller than the least that the factor f of the fractal law, 4/3, gives
    const auto hertz = identify(folder, scene("0.832 um", "500 /mm^2", "\"fractal\""),
                                measured("stiffness_Pa_per_m", 0.02), "--fit D", 4);
    CHECK(test::contains(hertz["warnings"].dump(), "D is at the end of its range"));
    CHECK(!test::contains(hertz["warnings"].dump(), "as many parameters as points"));
    CHECK(hertz["fits"][0]["status"] == "at_bound");
    CHECK(hertz["fits"][0]["parameters"][0]["at_bound"] == true);
    CHECK(!hertz["fits"][0]["parameters"][0].contains("standard_error"));
    const auto vague = identify(folder, scene(), "p [MPa],K [GPa/um],error [GPa/um]\n1,0.004,1\n2,0.008,1\n3,0.01,1\n",
                                "--fit sigma,Dp", 4);
    CHECK(test::contains(vague["warnings"].dump(), "hardly constrain sigma"));
    // three reflections without errors: sigma comes out as a factor of thousands
    const auto three = identify(folder, scene(), "p [MPa],R\n1,0.995\n10,0.9\n30,0.97\n", "--fit sigma", 4);
    CHECK(test::contains(three["fits"][0]["concerns"].dump(), "unresolved"));
}

TEST_CASE("identify fits every law of the scene and reports which describes the data") {
    const test::Folder folder;
    const std::string both = scene("0.8 um", "450 /mm^2", "\"hertz\", \"fractal\", \"greenwood_williamson\"");
    const std::string data = measured("stiffness_Pa_per_m", 0.02);
    const auto document = identify(folder, both, data, "--fit sigma");
    REQUIRE(document["fits"].size() == 3);
    CHECK(document["fits"][0]["chi_squared"].get<double>() < document["fits"][1]["chi_squared"].get<double>());
    CHECK(document["fits"][2]["law"] == "greenwood_williamson");
    CHECK(!document["fits"][2].contains("theta"));
    CHECK(test::contains(document["warnings"].dump(), "does not describe the data"));
    const auto one = identify(folder, both, data, "--fit sigma --law fractal", 4);
    REQUIRE(one["fits"].size() == 1);
    CHECK(one["fits"][0]["law"] == "fractal");
    CHECK(one["fits"][0]["parameters"] == document["fits"][1]["parameters"]);
}

TEST_CASE("identify: table, CSV and picture hold what the JSON does") {
    const test::Folder folder;
    const auto fit = identify(folder, scene(), measured("stiffness_Pa_per_m", 0.02, 1), "--fit 'sigma, Dp'")["fits"][0];
    const test::Csv csv(outcome_of(folder, "--fit sigma,Dp --format csv").out);
    REQUIRE(csv.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(csv.number(i, "value") == value(fit, i));
        CHECK(csv.number(i, "standard_error") == fit["parameters"][i]["standard_error"].get<double>());
        CHECK(csv.number(i, "correlation_Dp") == fit["correlation"][i][1].get<double>());
        CHECK(csv.number(i, "chi_squared") == fit["chi_squared"].get<double>());
    }
    const auto table = outcome_of(folder, "--fit sigma,Dp");
    CHECK(table.status == 0);
    for (const char* part : {"sigma [µm]", "D_p [1/mm²]", "standard error", "95 % from", "correlation", "chi²/dof",
                             "residual [errors]", "12 points"}) {
        INFO(part);
        CHECK(test::contains(table.out, part));
    }
    // the curve is so fine that it is smooth, and passes through the model at its ends
    const auto& curve = fit["curve"];
    const auto& points = fit["rows"];
    REQUIRE(curve["pressure_Pa"].size() == 41);
    for (const auto& [k, i] : {std::pair(0, std::size_t(0)), std::pair(40, points.size() - 1)}) {
        CHECK(test::relative_error(curve["pressure_Pa"][k].get<double>(), points[i]["pressure_Pa"].get<double>()) <
              1e-12);
        CHECK(test::relative_error(curve["stiffness_Pa_per_m"][k].get<double>(), points[i]["model"].get<double>()) <
              1e-10);
    }
}

TEST_CASE("identify refuses what it cannot fit, in one sentence") {
    const test::Folder folder;
    const std::string good = folder.write("scene.toml", scene()), start = "identify '" + good + "' --measured - ";
    const std::string data = measured("stiffness_Pa_per_m", 0.02);
    const auto refused = [&](const std::string& call, int status, const std::vector<std::string>& parts,
                             const std::string& input) { test::check_refused(call, status, parts, input); };
    refused(start + "--fit sigma,width", 2, {"--fit", "width", "\"offset\""}, data);
    refused(start + "--fit sigma,sigma", 2, {"--fit", "sigma", "twice"}, data);
    for (const char* empty : {"sigma,", ",sigma", "sigma,,R"})
        refused(start + "--fit " + empty, 2, {"--fit = \"" + std::string(empty) + "\"", "has an empty part"}, data);
    refused(start, 2, {"--fit"}, data);
    refused(start + "--fit sigma", 3, {"standard input:4: is the point of line 2 again"},
            "p [MPa],K [GPa/um]\n1,0.01\n2,0.02\n1,0.01\n");
    refused("identify '" + good + "' --fit sigma", 2, {"--measured"}, data);
    refused("identify - --measured - --fit sigma", 2, {"standard input"}, data);
    refused(start + "--fit sigma --law gauss", 2, {"--law"}, data);
    refused(start + "--fit sigma --law jackson_green", 3, {"\"jackson_green\", which --law asks for", "yield_strength"},
            data);
    refused(start + "--fit g,R --law hybrid", 2, {"--fit R", "follows from sigma, g and alpha"}, data);
    refused(start + "--fit sigma --wave shear", 2, {"--wave shear", "stiffnesses"}, data);
    refused(start + "--fit sigma", 3, {"standard input:1", "pressure"}, "a,b\n1,2\n");
    refused(start + "--fit sigma,Dp,offset", 3, {"2 points", "3 parameters"}, "p [MPa],K [GPa/um]\n1,0.01\n2,0.02\n");
    refused(start + "--fit sigma", 3, {"standard input:2", "error = 0", "greater than 0"},
            "p [MPa],K [GPa/um],error [GPa/um]\n1,0.01,0\n2,0.02,0.001\n");
    refused(start + "--fit sigma", 3, {"standard input:2", "reflection = 3"}, "p [MPa],R\n1,3\n2,0.9\n");
    refused(start + "--fit sigma", 3, {"standard input", "holds 5 computed curves", "must hold one curve"},
            test::run_fstiff("run '" FSTIFF_SCENES "/sand_blasted_fine.toml' --format csv").out);
    folder.write("scene.toml", test::replaced(scene(), "peaks =",
                                              "interaction = { reading = \"as_printed\", length = "
                                              "\"peak_spacing\" }\npeaks ="));
    refused(start + "--fit sigma", 3, {"contact.interaction", "none"}, data);
    folder.write("scene.toml", scene().substr(0, scene().find("[ultrasound]")));
    refused(start + "--fit sigma", 3, {"ultrasound", "missing"}, "p [MPa],R\n1,0.99\n2,0.9\n");
    folder.write("scene.toml",
                 test::replaced(scene(), "poisson_ratio = 0.3\n", "poisson_ratio = 0.3\nhardness = \"infinite\"\n"));
    refused(start + "--fit hardness", 3, {"material.upper.hardness", "infinite", "--fit hardness"}, data);
    folder.write("scene.toml", test::replaced(scene(), "fractal_dimension = 1.62\n", ""));
    refused(start + "--fit D", 3, {"surface.fractal_dimension", "missing"}, data);
    refused(start + "--fit sigma --law fractal", 3, {"\"fractal\"", "needs surface.fractal_dimension"}, data);
    folder.write("scene.toml", test::replaced(scene(), "r = 0.4", "r = 0.0"));
    refused(start + "--fit r", 3, {"r = 0", "between 0 and 1"}, data);
}

TEST_CASE("identify takes the CSV of run") {
    const test::Folder folder;
    folder.write("one.toml", scene());
    folder.write("start.toml", scene("1 um", "300 /mm^2"));
    // one curve with r and reflections with the stiffness: its r is the correlation, its errors are bounds
    const auto outcome = test::shell("fstiff run '" + folder / "one.toml" + "' --format csv | fstiff identify '" +
                                     folder / "start.toml" + "' --measured - --fit sigma,Dp --format json");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const auto document = nlohmann::json::parse(outcome.out);
    CHECK(document["measured"]["quantity"] == "stiffness");
    CHECK(document["measured"]["has_errors"] == false);
    const auto& fit = document["fits"][0];
    CHECK(fit["errors_known"] == false);
    CHECK(test::relative_error(value(fit, 0), 0.832e-6) < 1e-9);
    CHECK(test::relative_error(value(fit, 1), 500e6) < 1e-9);
    CHECK(fit["rows"].size() == 12);
    CHECK(!fit["rows"][0].contains("error"));

    // several curves: every fit takes the rows of its own law and peaks, so that nothing is to change
    const std::string paper = "'" FSTIFF_SCENES "/sand_blasted_fine.toml' ";
    const auto all = test::shell("fstiff run " + paper + "--format csv | fstiff identify " + paper +
                                 "--measured - --fit sigma,Dp --format json");
    INFO(all.err);
    REQUIRE(all.status == 4);  // elastic laws of steel that flows
    const auto several = nlohmann::json::parse(all.out);
    REQUIRE(several["fits"].size() == 5);
    for (const auto& one : several["fits"]) {
        CHECK(one["rows"].size() == 31);
        CHECK(test::relative_error(value(one, 0), 0.832e-6) < 1e-9);
        CHECK(test::relative_error(value(one, 1), 500e6) < 1e-9);
    }

    // the curve of one law, fitted by another
    const auto other =
        test::shell("fstiff run '" + folder / "one.toml" +
                    "' --format csv | fstiff identify --measured - --law fractal --fit Dp --format json");
    INFO(other.err);
    CHECK(other.status == 4);  // which misses the points
    CHECK(test::contains(other.err, "the points scatter by"));
}

TEST_CASE("A fit that misses its points, is bent by one of them or lies far from its start ends with exit code 4") {
    const test::Folder folder;
    std::string slipped = measured("stiffness_Pa_per_m", 0);  // one of twelve points read off wrongly
    const std::string line = test::lines(slipped)[6], number = line.substr(line.find(',') + 1);
    slipped = test::replaced(slipped, number, std::to_string(1.3 * std::stod(number)));
    // as many peaks per mm^2 as a wrong unit makes of them
    const std::string wrong = measured("stiffness_Pa_per_m", 0.02, 0, scene("0.832 um", "500000 /mm^2"));
    // the third of four points ten times too low
    const std::string four = "p [MPa],K [GPa/um]\n1,0.0045\n3,0.0125\n10,0.0038\n30,0.1\n";
    const std::string weighed =
        "p [MPa],K [GPa/um],error [GPa/um]\n1,0.0045,0.0002\n3,0.0125,0.0005\n10,0.3,0.002\n30,0.1,0.005\n";
    // K in a unit a thousand times too large
    const std::string large = "p [MPa],K [GPa/um]\n1,4.5\n3,12.5\n10,38\n30,100\n";
    const std::array<std::string, 3> rows[] = {{"[]", measured("stiffness_Pa_per_m", 0.02, 0.5), "sigma"},
                                               {"\"scattered\"", four, "sigma"},
                                               {"\"scattered\"", test::replaced(four, "30,0.1", "30,100"), "sigma"},
                                               {"[\"misfit\"", weighed, "sigma"},
                                               {"[\"far_from_start\"]", wrong, "Dp"},
                                               {"\"far_from_start\"", large, "sigma"},
                                               {"[\"outlier\"]", slipped, "sigma"}};
    for (const auto& [concerns, data, parameter] : rows) {
        const auto fit = identify(folder, scene(), data, "--fit " + parameter, concerns == "[]" ? 0 : 4)["fits"][0];
        INFO(concerns << " expected: " << fit["concerns"].dump());
        CHECK(test::contains(fit["concerns"].dump(), concerns));
    }
    const auto table = outcome_of(folder, "--fit sigma");
    CHECK(table.status == 4);
    CHECK(test::contains(test::as_one_line(table.out), "times as far from the model as the median of the points"));
}

TEST_CASE("identify fits hybrid and plastic, which run answers with") {
    const test::Folder folder;
    const auto of = [](const std::string& law, const std::string& sigma, const std::string& gradient) {
        return "[surface]\nrms_height = \"" + sigma +
               "\"\npeak_radius = \"14 um\"\npeak_density = \"1400 /mm^2\"\n"
               "rms_gradient = " +
               gradient +
               "\nalpha = 8.0\nhurst = 0.8\n"
               "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\nhardness = \"2 GPa\"\n"
               "[contact]\npressures = { from = \"1 MPa\", to = \"400 MPa\", count = 12 }\n" +
               (law.empty() ? "" : "laws = [\"" + law + "\"]\n");
    };
    for (const std::string law : {"hybrid", "plastic"}) {
        INFO(law);
        const std::string data = measured("stiffness_Pa_per_m", 0.01, 0.5, of(law, "0.8 um", "0.12"));
        const std::string flows = law == "hybrid" ? "--fit sigma,g" : "--fit sigma";
        const auto document =
            identify(folder, of(law, "0.5 um", law == "hybrid" ? "0.2" : "0.12"), data, flows, law == "hybrid" ? 4 : 0);
        REQUIRE(document["fits"].size() == 1);
        const auto& fit = document["fits"][0];
        CHECK(fit["law"] == law);
        CHECK(fit["status"] == "converged");
        for (const auto& one : fit["parameters"]) {
            const double truth = one["name"] == "sigma" ? 0.8e-6 : 0.12;
            CHECK(one["interval"]["low"].get<double>() < truth);
            CHECK(one["interval"]["high"].get<double>() > truth);
        }
        CHECK(std::abs(value(fit, 0) / 0.8e-6 - 1) < (law == "hybrid" ? 0.1 : 0.01));
        // elastic peaks of H/(E g) = 0.15 have no hardness to be found
        const bool told = test::contains(document["warnings"].dump(), "the peaks of the fitted surface yield");
        CHECK(told == (law == "hybrid"));
        if (told) CHECK(test::contains(document["warnings"].dump(), "H/(E g) = 0.1"));
        if (told)  // also with a hardness that is assumed
            CHECK(
                test::contains(identify(folder, test::replaced(of(law, "0.8 um", "0.12"), "hardness = \"2 GPa\"\n", ""),
                                        data, flows, 0)["warnings"]
                                   .dump(),
                               "is assumed): an elastic law"));
        // no law was chosen: the one for peaks that yield
        const auto best = identify(folder, of("", "0.5 um", "0.12"), data, "--fit sigma", law == "hybrid" ? 4 : 0);
        REQUIRE(best["fits"].size() == 1);
        CHECK(best["fits"][0]["law"] == "plastic");
    }
    const std::string data = measured("stiffness_Pa_per_m", 0.01, 0, of("plastic", "0.8 um", "0.12"));
    const auto hardness = identify(folder, of("hertz", "0.8 um", "0.12"), data, "--law plastic --fit sigma,hardness");
    CHECK(test::relative_error(value(hardness["fits"][0], 1), 2e9) < 1e-5);
    const auto product = identify(folder, of("hybrid", "0.8 um", "0.12"), data, "--fit g,E", 4);
    CHECK(test::contains(product["warnings"].dump(), "only as the product E g"));
    // of bodies that never yield hybrid is the law
    const std::string hard = test::replaced(of("", "0.8 um", "0.12"), "2 GPa", "infinite");
    CHECK(identify(folder, hard, data, "--fit sigma", 4)["fits"][0]["law"] == "hybrid");
}

TEST_CASE("sigma of a measured map is a factor of all its heights") {
    const test::Folder folder;
    folder.write("map.txt", test::run_fstiff("generate map --points 64 --spacing '0.5 um' --hurst 0.8 --rms '0.3 um' "
                                             "--shortest '3 um' --longest '16 um'")
                                .out);
    const std::string text =
        "[surface]\nfrom = \"" + folder / "map.txt" +
        "\"\n[material.upper]\nyoungs_modulus = \"205 GPa\"\n"
        "poisson_ratio = 0.3\n[contact]\npressures = { from = \"10 MPa\", to = \"1 GPa\", count = 10 }\n"
        "laws = [\"hybrid\"]\n";
    // K of heights t times as high under t p is K of the heights under p
    const std::string data = measured("stiffness_Pa_per_m", 0.02, 0, text);
    const auto fit = identify(folder, text, with_pressures(data, 1.25, 0), "--fit sigma")["fits"][0];
    CHECK(fit["status"] == "converged");
    CHECK(test::relative_error(value(fit, 0), 1.25 * fit["parameters"][0]["start"].get<double>()) < 1e-6);
    CHECK(fit["chi_squared"].get<double>() < 1e-6);
    test::check_refused("identify '" + folder / "scene.toml" + "' --measured '" + folder / "data.csv" + "' --fit g", 3,
                        {"--fit g", "scale with sigma alone"});
}

}  // namespace identify_test
