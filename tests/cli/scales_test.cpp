// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure --scales: each row is the measurement with these cut-offs.
#include "json.hpp"

#include <cmath>

namespace scales_test {

TEST_CASE("each row of --scales is the measurement and the K behind its cut-offs") {
    const test::Folder folder;
    const auto trace =
        folder.write("trace.csv", test::run_fstiff("generate profile --points 4096 --spacing '1 um' --hurst 0.7 "
                                               "--rms '1 um' --shortest '4 um' --longest '400 um'")
                                      .out);
    const auto document =
        test::json_of("measure " + trace +
                      " --lambda-s '10 um' --lambda-c '800 um' --scales --pressure '20 MPa' --modulus "
                      "'100 GPa'");
    const auto& rows = document["scales"]["rows"];
    REQUIRE(rows.size() > 8);
    int checked = 0, chosen = 0;
    for (const auto& row : rows) {
        const auto text = [](const nlohmann::json& of) {
            return of.is_null() ? std::string("none") : "'" + of.dump() + " m'";
        };
        const std::string cut_offs = " --lambda-s " + text(row.value("lambda_s_m", nlohmann::json())) + " --lambda-c " +
                                     text(row.value("lambda_c_m", nlohmann::json()));
        if (text(row.value("lambda_s_m", nlohmann::json())) == "'1e-05 m'" &&
            text(row.value("lambda_c_m", nlohmann::json())) == "'0.0008 m'")
            ++chosen;
        if (!row.contains("stiffness_Pa_per_m") || row["stiffness_Pa_per_m"].is_null()) continue;
        const auto measured = test::json_of("measure " + trace + cut_offs);
        for (const auto& [key, of] :
             {std::pair("rms_height_m", "rms_height"), std::pair("peak_radius_m", "peak_radius"),
              std::pair("peak_density_per_m2", "peak_density"), std::pair("rms_gradient", "rms_gradient")})
            CHECK(std::abs(row[key].get<double>() / measured["surface"][of]["value"].get<double>() - 1) < 1e-12);
        folder.write("surface.json", measured.dump());
        const auto scene = folder.write("scene.toml",
                                        "[surface]\nfrom = \"surface.json\"\n[material.upper]\nyoungs_modulus = \"200 "
                                        "GPa\"\npoisson_ratio = 0.0\n[contact]\npressures = [\"20 MPa\"]\nlaws = [\"" +
                                            document["scales"]["law"].get<std::string>() + "\"]\n");
        const auto run = test::json_of("run " + scene + " --format json");
        CHECK(std::abs(row["stiffness_Pa_per_m"].get<double>() / run["rows"][0]["stiffness_Pa_per_m"].get<double>() -
                       1) < 1e-9);
        ++checked;
    }
    CHECK(checked > 8);
    CHECK(chosen == 2);  // among both lists
    CHECK(document["scales"]["settled"].size() == 2);
}

TEST_CASE("the table of --scales, its CSV and its picture are of one file") {
    const test::Folder folder;
    const auto map =
        folder.write("map.txt", test::run_fstiff("generate map --points 128 --spacing '1 um' --hurst 0.8 --rms '1 um' "
                                             "--shortest '6 um' --longest '60 um'")
                                    .out);
    const auto csv = test::run_fstiff("measure " + map + " --scales --format csv --plot " + folder / "map.svg");
    CHECK(csv.status % 4 == 0);
    CHECK(test::lines(csv.out).front() ==
          "lambda_s_m,lambda_c_m,rms_height_m,rms_gradient,peak_radius_m,peak_density_per_m2,fractal_dimension,"
          "stiffness_Pa_per_"
          "m");
    CHECK(test::contains(test::read(folder / "map.svg"), "ratio to the value at the chosen λs"));
    CHECK(test::contains(test::read(folder / "map.svg"), ">map.txt filtered with other cut-offs<"));
    CHECK(std::filesystem::exists(folder / "map.plot.csv"));
    CHECK(test::contains(test::run_fstiff("measure " + map + " --scales --format table").out, "settled to 10 %"));
    CHECK(test::run_fstiff("measure " + map + " " + map + " --scales").status == 2);
    CHECK(test::run_fstiff("measure " + map + " --plot " + folder / "other.svg").status == 2);
    CHECK(test::run_fstiff("measure " + map + " --scales --pressure 10").status == 3);
    CHECK(test::run_fstiff("measure " + map + " --scales --modulus '0 GPa'").status == 3);
}

}  // namespace scales_test
