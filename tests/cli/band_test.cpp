// SPDX-License-Identifier: BSD-3-Clause
// The band of K of a measured surface: its errors, and the spread over lambda_s.
#include "json.hpp"

#include <cmath>

namespace band_test {

namespace {

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n"
    "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\nlaws = [\"hertz\", \"greenwood_williamson\"]\n";

}  // namespace

TEST_CASE("the band holds K behind half and twice the root of two of lambda_s, and the sampled band") {
    const test::Folder folder;
    // rough down to the step: R hangs on lambda_s
    const auto made = test::run_fstiff(
        "generate profile --points 8192 --spacing '1 um' --hurst 0.6 --rms '1 um' --shortest '2 um' --longest '300 "
        "um'");
    folder.write("trace.csv", made.out);
    const auto scene = [&](const std::string& name, const std::string& lambda_s) {
        return folder.write(
            name, "[surface]\nfrom = \"trace.csv\"\nlambda_s = \"" + lambda_s + "\"\nlambda_c = \"none\"\n" + rest);
    };
    const auto whole = test::json_of("run " + scene("whole.toml", "12 um") + " --format json");
    const auto less = test::json_of("run " + scene("less.toml", "8.48528137423857 um") + " --format json"),
               more = test::json_of("run " + scene("more.toml", "16.970562748477143 um") + " --format json");
    // without its neighbours the document of measure has the sampled band alone
    auto document = test::json_of("measure " + folder / "trace.csv" + " --lambda-s '12 um' --lambda-c none");
    REQUIRE(document["neighbours"].size() == 2);
    const auto from_document = [&](const std::string& name) {
        folder.write(name + ".json", document.dump());
        return test::json_of("run " + folder.write(name + ".toml", "[surface]\nfrom = \"" + name + ".json\"\n" + rest) +
                             " --format json");
    };
    const auto all_of_document = from_document("all");
    document.erase("neighbours");
    const auto sampled = from_document("sampled");
    for (std::size_t i = 0; i < whole["rows"].size(); ++i) {
        const auto of = [&](const nlohmann::json& one, const char* key) { return one["rows"][i][key].get<double>(); };
        const char *k = "stiffness_Pa_per_m", *low = "stiffness_p05_Pa_per_m", *high = "stiffness_p95_Pa_per_m";
        INFO("row " << i);
        const double K = of(whole, k), a = of(less, k), b = of(more, k);
        CHECK(of(whole, low) < std::min(a, b));
        CHECK(of(whole, high) > std::max(a, b));
        CHECK(std::abs(of(all_of_document, low) / of(whole, low) - 1) < 1e-12);
        const double up = std::log(std::max({a, b, K}) / K), errors = std::log(of(sampled, high) / K);
        CHECK(std::abs(std::log(of(whole, high) / K) - std::hypot(up, errors)) < 1e-9);
        const double down = std::log(std::min({a, b, K}) / K), below = std::log(of(sampled, low) / K);
        CHECK(std::abs(std::log(of(whole, low) / K) + std::hypot(down, below)) < 1e-9);
    }
    std::string said;
    for (const std::string sentence : whole["verdict"])
        if (test::contains(sentence, "of the band of hertz")) said = sentence;
    CHECK(test::contains(said, "lambda_s between 8.5 µm and 17 µm"));
    CHECK(test::contains(said, "the errors dominate"));
    folder.write("trace.csv", test::run_fstiff("generate profile --points 131072 --spacing '1 um' --hurst 0.6 --rms '1 um' "
                                           "--shortest '2 um' --longest '300 um'")
                                  .out);  // 16 times as long: the errors are a quarter, the spread over lambda_s stays
    CHECK(test::contains(test::run_fstiff("run " + folder / "whole.toml").out, "choice of lambda_s dominates"));
    for (const std::string sentence : sampled["verdict"]) CHECK(!test::contains(sentence, "of the band"));
}

TEST_CASE("what a scene writes by hand holds behind every lambda_s") {
    const test::Folder folder;
    folder.write("trace.csv", test::run_fstiff("generate profile --points 2048 --spacing '1 um' --hurst 0.6 --rms '1 um' "
                                           "--shortest '2 um' --longest '200 um'")
                                  .out);
    const auto run = [&](const std::string& keys) {
        return test::json_of(
            "run " +
            folder.write("scene.toml", "[surface]\nfrom = \"trace.csv\"\nlambda_s = \"12 um\"\n" + keys + rest) +
            " --format json");
    };
    const auto held = run("rms_height = \"1 um\"\npeak_radius = \"50 um\"\npeak_density = \"900 /mm^2\"\n");
    const auto& row = held["rows"].back();  // greenwood_williamson takes these three alone, and they have no errors
    REQUIRE(row["law"] == "greenwood_williamson");
    const double K = row["stiffness_Pa_per_m"];
    CHECK(std::abs(row["stiffness_p05_Pa_per_m"].get<double>() / K - 1) < 1e-9);
    CHECK(std::abs(row["stiffness_p95_Pa_per_m"].get<double>() / K - 1) < 1e-9);
}

}  // namespace band_test
