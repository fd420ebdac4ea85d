// SPDX-License-Identifier: BSD-3-Clause
// What is written is read back as it was: the inputs of a scene as a scene, a measured document as a surface, the
// options of a document as options.
#include "support/library.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>

#include <cmath>

namespace round_trip_test {

using namespace fstiff;

namespace {

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n[contact]\n"
    "pressures = [\"1 MPa\", \"20 MPa\"]\n";

/// A scene of \p inputs: each that was written is a line "key = value" of TOML, a path of dots; items of lists are
/// gathered.
std::string text_of(const std::vector<request::Input>& inputs) {
    std::string text;
    std::vector<std::pair<std::string, std::string>> lists;
    for (const request::Input& one : inputs) {
        if (!one.given || test::contains(one.written, "default") || one.key.find("peaks") != std::string::npos)
            continue;
        const bool plain = one.value && one.unit.empty();
        const std::string value = plain ? one.written : "\"" + one.written + "\"";
        const std::size_t list = one.key.find('[');
        if (list == std::string::npos) {
            text += one.key + " = " + value + "\n";
            continue;
        }
        const std::string key = one.key.substr(0, list);
        if (lists.empty() || lists.back().first != key) lists.emplace_back(key, "");
        lists.back().second += (lists.back().second.empty() ? "" : ", ") + value;
    }
    for (const auto& [key, items] : lists) text += key + " = [" + items + "]\n";
    return text;
}

void check_same_rows(const actions::Answered& a, const actions::Answered& b) {
    CHECK(test::csv_of(a) == test::csv_of(b));
}

}  // namespace

TEST_CASE("The inputs that a scene records make the same scene again, for random numbers in random units") {
    std::uint64_t state = 5;
    const auto random = [&](double from, double to) {
        return from * std::pow(to / from, 0.5 + 0.5 * std::tanh(fstiff::math::normal_pair<double>(state).real()));
    };
    for (int k = 0; k < 12; ++k) {
        const bool fine = k % 2 == 0;
        const auto quantity = [&](double metres) {
            return fine ? fstiff::detail::shortest_text(metres * 1e9) + " nm"
                        : fstiff::detail::shortest_text(metres * 1e3) + " mm";
        };
        std::string text = "name = \"random " + std::to_string(k) + "\"\n[surface]\nrms_height = \"" +
                           quantity(random(1e-7, 3e-6)) + "\"\npeak_radius = \"" + quantity(random(1e-5, 1e-4)) +
                           "\"\npeak_density = \"" + fstiff::detail::shortest_text(random(100, 1000)) +
                           " /mm^2\"\nfractal_dimension = " + fstiff::detail::shortest_text(random(1.1, 1.8)) +
                           "\nerrors = { rms_height = \"" + quantity(1e-8) + "\" }\n" + rest +
                           "laws = [\"fractal\", \"greenwood_williamson\"]\nnominal_area = \"" +
                           fstiff::detail::shortest_text(random(1, 100)) +
                           " mm^2\"\n[uncertainty]\nsamples = 20\nseed = " + std::to_string(k) +
                           "\n[output]\nquantities = [\"stiffness\", \"contacts\"]\n";
        INFO(text);
        const scene::Scene first = test::scene_of(text);
        const std::string again = text_of(first.inputs);
        INFO(again);
        const scene::Scene second = test::scene_of(again);
        check_same_rows(actions::compute(first), actions::compute(second));
        // and the inputs of the second are those of the first, so that nothing is lost on the way
        CHECK(text_of(second.inputs) == again);
    }
}

TEST_CASE(
    "The document of a surface, read by a scene, gives the numbers of the surface itself, with its neighbours and its "
    "band") {
    const test::Folder folder;
    const fstiff::SelfAffineOptions<double> how{
        .hurst = 0.6, .rms = 0.5e-6, .longest_wavelength = 60e-6, .shortest_wavelength = 3e-6};
    for (const std::string& text : {test::profile_text(4096, 0.5e-6, how), test::map_text(96, 1e-6, how)})
        for (const char* options : {"", "--lambda-s '6 um'", "--lambda-s none --lambda-c '30 um' --filter robust"}) {
            INFO(options);
            const std::string file = folder.write("surface.txt", text);
            const auto document = test::measured_files(options, {file});
            folder.write("surface.json", document.dump());
            std::string keys;
            const auto words = test::words_of(options);
            for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
                std::string key = words[i].substr(2);
                std::replace(key.begin(), key.end(), '-', '_');
                keys += key + " = \"" + words[i + 1] + "\"\n";
            }
            const auto results = [&](const std::string& surface) {
                return test::results_of(
                    "[surface]\nfrom = " + surface + rest +
                        "laws = [\"hertz\", \"greenwood_williamson\"]\n[uncertainty]\nsamples = 40\n",
                    folder / "scene.toml");
            };
            const auto direct = results("\"surface.txt\"\n" + keys), read = results("\"surface.json\"\n");
            check_same_rows(direct, read);
            // and the document of what was read is the document
            const auto second = test::parsed(
                actions::measured_document(surface::read_measured_document(document.dump(), "surface.json")));
            for (const char* part :
                 {"surface", "neighbours", "correlation_of_errors", "concerns", "moments", "lambda_s_m"}) {
                CAPTURE(part);
                CHECK(second.value(part, nlohmann::json()) == document.value(part, nlohmann::json()));
            }
        }
}

TEST_CASE("The inputs of a document, given as options again, give the document again") {
    const std::string text =
        test::profile_text(2048, 0.5e-6, {.hurst = 0.6, .rms = 0.5e-6, .longest_wavelength = 60e-6});
    for (const std::string options :
         {"", "--lambda-s '4 um' --lambda-c none", "--detrend gaussian --cutoff '80 um' --tip-radius '2 um'",
          "--crop '100 um,800 um' --spikes 5.5 --fill --window '3 um,40 um'",
          "--filter robust --lambda-c '50 um' --resolution '3 um'"}) {
        INFO(options);
        const auto document = test::measured(options, text);
        std::string again;
        for (const surface::SurfaceOptionRow& row : surface::surface_option_table()) {
            const std::string key(row.json_name());
            if (!document["inputs"].contains(key)) continue;
            const auto& value = document["inputs"][key];
            const std::string word = value.is_string() ? value.get<std::string>() : value.dump();
            if (word.empty() || word == "0" || word == "false" || value.is_null()) continue;
            again += " " + row.flag_name() + (value.is_boolean() ? "" : " '" + word + "'");
        }
        INFO(again);
        CHECK(test::measured(again, text) == document);
    }
}

}  // namespace round_trip_test
