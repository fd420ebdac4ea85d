// SPDX-License-Identifier: BSD-3-Clause
// The error of the law in a fit. Truth: K of boundary elements of faces that the error was not set on, and their sigma.
#include "command.hpp"

#include "support/table.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace identify_with_law_test {

TEST_CASE("the interval of sigma holds that of a face whose K is known once it has the error of the law") {
    const test::Table table("../../bench/face_truth.csv");
    const test::Folder folder;
    constexpr double modulus = 205e9 / (2 * (1 - 0.3 * 0.3)), side = 128e-6, gradient = 0.1;
    folder.write("scene.toml",
                 "[surface]\nrms_height = \"0.3 um\"\nrms_gradient = 0.1\n[material.upper]\nyoungs_modulus = \"205 "
                 "GPa\"\npoisson_ratio = 0.3\n[contact]\npressures = [\"10 MPa\"]\nlaws = [\"hybrid\"]\n");
    int faces = 0, by_data = 0, with_law = 0;
    for (std::size_t i = 0; i + 5 < table.size(); i += 6) {
        if (table.text(i, "calibrated") == "1" || table.text(i, "seed") != "1") continue;
        std::string data = "pressure [Pa],stiffness [Pa/m]\n";
        for (std::size_t k = i; k < i + 6; ++k) {
            char line[80];
            std::snprintf(line, sizeof line, "%.17g,%.17g\n", table.input(k, "p_star") * gradient * modulus,
                          table.input(k, "K") * modulus / side);
            data += line;
        }
        folder.write("data.csv", data);
        const auto outcome = test::run_fstiff("identify '" + folder / "scene.toml" + "' --measured '" +
                                              folder / "data.csv" + "' --fit sigma --format json");
        CAPTURE(table.text(i, "kind"), outcome.out, outcome.err);
        const auto sigma = nlohmann::json::parse(outcome.out)["fits"][0]["parameters"][0];
        const double truth = table.input(i, "rms_height");
        const auto holds = [&](const char* interval) {
            return sigma[interval]["low"].get<double>() <= truth && truth <= sigma[interval]["high"].get<double>();
        };
        ++faces, by_data += holds("interval"), with_law += holds("interval_with_law");
        CHECK(sigma["interval_with_law"]["low"] < sigma["interval"]["low"]);
        CHECK(sigma["interval_with_law"]["high"] > sigma["interval"]["high"]);
    }
    CAPTURE(faces, by_data, with_law);
    CHECK(faces == 19);
    CHECK(with_law >= 17);
    CHECK(with_law > by_data);
}

}  // namespace identify_with_law_test
