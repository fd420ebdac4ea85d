// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure --show fit as a process: its table and exit codes. Its numbers: tests/scene/fractal_test.cpp.
#include "command.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include <algorithm>
#include <sstream>

namespace fit_test {

TEST_CASE("The readable fit prints its decisions about the file") {
    std::string text = "x [\xC2\xB5m];z [nm]\r\n";
    const auto profile = fstiff::self_affine_profile<double>({.hurst = 0.5, .rms = 1e-6}, 1024, 0.5e-6);
    for (std::size_t i = 0; i < profile.size(); ++i) {
        std::string row = fstiff::detail::shortest_text(static_cast<double>(i) * 0.5) + ";" +
                          fstiff::detail::shortest_text(profile.heights[i] * 1e9) + "\r\n";
        std::replace(row.begin(), row.end(), '.', ',');
        text += row;
    }
    const auto outcome = test::run_fstiff("measure --show fit - --lambda-s none", text);
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    for (const char* part :
         {"; separator: semicolon, decimal comma", "header: 1 line", "points: 1024", "units: heights in nm",
          "spacing 0.5 µm", "D = 1.", " m +- ", "Rq ", "(line)", "window ", "lag [µm]", "S [µm²]"}) {
        INFO(part);
        CHECK(test::contains(outcome.out, part));
    }
}

TEST_CASE("Files and options that fit cannot take end with exit codes 3 and 2") {
    const test::Folder folder;
    test::check_refused("measure --show fit '" + folder / "none.csv" + "'", 3, {"none.csv", "no such file"});
    test::check_refused("measure --show fit '" + folder / "." + "'", 3, {"folder"});
    test::check_refused("measure --show fit -", 3, {"empty"});
    test::check_refused("measure --show fit -", 3, {"empty"}, "\n \n");
    test::check_refused("measure --show fit - --convention own", 2, {"--convention", "own"}, "1\n");
    test::check_refused("measure --show fit - --units um --spacing '1 um' --detrend cubic", 2, {"--detrend", "cubic"},
                        "1\n2\n1\n3\n1\n2\n1\n4\n1\n2\n1\n3\n1\n2\n1\n5\n2\n1\n");
    test::check_refused("measure --show fit - --column 0", 2, {"--column"}, "1\n");
    test::check_refused("measure --show fit", 2, {"profile"});
}

TEST_CASE("Lengths of a fine profile are shown in nm, and a G that is not known to a factor of two with two digits") {
    const auto made = test::run_fstiff("generate profile --points 200 --spacing '5 nm' --hurst 0.3 --rms '3 nm'");
    REQUIRE(made.status == 0);
    const auto outcome = test::run_fstiff("measure --show fit - --lambda-s none", made.out);
    INFO(outcome.out);
    CHECK(test::contains(outcome.out, "spacing 5 nm, length 0.995 µm"));
    const auto at = outcome.out.find("  G = ");
    REQUIRE(at != std::string::npos);
    std::istringstream line(outcome.out.substr(at + 6));
    std::string value, unit, sign, error;
    line >> value >> unit >> sign >> error;
    REQUIRE(std::stod(error) > std::stod(value) / 2);
    CHECK(value.substr(0, value.find('e')).size() <= 3);  // such as 2.5
}

}  // namespace fit_test
