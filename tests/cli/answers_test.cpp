// SPDX-License-Identifier: BSD-3-Clause
// One answer for one request: spectra, generated surfaces, ultrasound, identification and exports through the C
// interface are what the command prints, byte for byte. tests/python/test_answers.py holds the Python package to the
// command.
#ifdef FSTIFF_TEST_HAS_C
#include "json.hpp"

#include <fstiff.h>

#include <memory>
#include <vector>

namespace answers_test {

namespace {

using Document = std::unique_ptr<fstiff_document, decltype(&fstiff_document_free)>;

/// What \p call makes.
template <class Call>
Document made_by(const Call& call) {
    fstiff_document* made = nullptr;
    const int status = call(&made);
    INFO(fstiff_last_message());
    CHECK(status == FSTIFF_OK);
    REQUIRE(made);
    return {made, &fstiff_document_free};
}

std::string text_of(const Document& document) {
    std::size_t length = 0;
    CHECK(fstiff_document_text(document.get(), nullptr, 0, &length) == FSTIFF_OK);
    std::string text(length + 1, 'x');
    CHECK(fstiff_document_text(document.get(), text.data(), length, &length) == FSTIFF_BAD_ARGUMENT);
    CHECK(fstiff_document_text(document.get(), text.data(), length + 1, &length) == FSTIFF_OK);
    CHECK(text.back() == '\0');
    text.pop_back();
    return text;
}

std::vector<double> numbers_at(const Document& document, const std::string& path) {
    std::size_t count = 0;
    CHECK(fstiff_document_numbers(document.get(), path.c_str(), nullptr, 0, &count) == FSTIFF_OK);
    std::vector<double> numbers(count);
    CHECK(fstiff_document_numbers(document.get(), path.c_str(), numbers.data(), count, &count) == FSTIFF_OK);
    return numbers;
}

}  // namespace

TEST_CASE("The C interface generates the files of the command, and has its spectra") {
    const std::string of_map = "kind = map\n\npoints=32\nrows = 24\nspacing = 1e-6\nhurst = 0.8\nrms = 0.1 um";
    const auto map = made_by([&](auto made) { return fstiff_generate(of_map.c_str(), made); });
    const auto written =
        test::run_fstiff("generate map --points 32 --rows 24 --spacing '1 um' --hurst 0.8 --rms '0.1 um'");
    CHECK(text_of(map) == written.out);
    const test::Folder folder;
    const std::string file = folder.write("map.csv", written.out);

    const auto spectrum = made_by([&](auto made) {
        return fstiff_spectrum(nullptr, ("file = " + file + "\nlambda_s = 3 um\ntaper = none").c_str(), made);
    });
    const auto printed =
        test::run_fstiff("measure --show spectrum '" + file + "' --lambda-s '3 um' --taper none --format json");
    CHECK(text_of(spectrum) == printed.out);
    const auto json = nlohmann::json::parse(printed.out);
    CHECK(numbers_at(spectrum, "psd.psd_m4") == json["psd"]["psd_m4"].get<std::vector<double>>());

    const std::vector<double> heights = numbers_at(map, "heights_m");
    const fstiff_heights array{sizeof array, heights.data(), 24, 32, 1e-6, 1e-6};
    const auto of_array =
        made_by([&](auto made) { return fstiff_spectrum(&array, "lambda_s = 3e-6\ntaper = none", made); });
    CHECK(numbers_at(of_array, "psd.psd_m4") == numbers_at(spectrum, "psd.psd_m4"));
    CHECK(numbers_at(of_array, "rms_height_m") == numbers_at(spectrum, "rms_height_m"));
    const fstiff_heights row{sizeof row, heights.data(), 0, 32 * 24, 1e-6, 0};  // a profile
    const auto of_profile = made_by([&](auto made) { return fstiff_spectrum(&row, "of = acf", made); });
    CHECK(numbers_at(of_profile, "acf.acf.0") == std::vector<double>{1});
}

TEST_CASE("The C interface reflects, identifies and exports what the command does") {
    const std::string data = FSTIFF_SCENES, curve = data + "/example_reflection.csv", steel = "\nimpedance = 46 MRayl";
    const auto one = made_by([&](auto made) {
        return fstiff_ultrasound(nullptr, ("stiffness = 1.764e15\nfrequency = 7e6" + steel).c_str(), made);
    });
    const std::string wave = " --frequency '7 MHz' --impedance '46 MRayl' --format json";
    CHECK(text_of(one) == test::run_fstiff("ultrasound --stiffness '1.764 GPa/um'" + wave).out);
    const auto rows = made_by([&](auto made) {
        return fstiff_ultrasound(nullptr, ("reflection = " + curve + "\nfrequency = 7 MHz" + steel).c_str(), made);
    });
    const auto printed = test::run_fstiff("ultrasound --reflection '" + curve + "'" + wave);
    CHECK(text_of(rows) == printed.out);
    const auto first = nlohmann::json::parse(printed.out)["rows"][0];
    const double p = first["pressure_Pa"], r = first["reflection"];
    const fstiff_measured_curve array{sizeof array, &p, &r, nullptr, 1, 1};
    const auto of_array =
        made_by([&](auto made) { return fstiff_ultrasound(&array, ("frequency = 7 MHz" + steel).c_str(), made); });
    CHECK(numbers_at(of_array, "rows.0.stiffness_Pa_per_m") == std::vector<double>{first["stiffness_Pa_per_m"]});

    const std::string file = data + "/sand_blasted_fine.toml", scene = test::read(file);
    const std::string measured = data + "/example_stiffness.csv";
    const auto found = made_by([&](auto made) {
        return fstiff_identify(scene.c_str(), scene.size(), file.c_str(), nullptr,
                               ("law = plastic\nfit = sigma,offset\nmeasured = " + measured).c_str(), made);
    });
    const auto fit = test::run_fstiff("identify '" + file + "' --law plastic --fit sigma,offset --measured '" +
                                      measured + "' --format json");
    CHECK(text_of(found) == fit.out);
    CHECK(numbers_at(found, "fits.0.covariance").size() == 4);
    CHECK(fstiff_document_is_doubtful(found.get()) == (fit.status == 4));

    const auto law = made_by([&](auto made) {
        return fstiff_export(scene.c_str(), scene.size(), file.c_str(), "to = abaqus\ntolerance = 5%\nuntil = 50e6",
                             made);
    });
    CHECK(text_of(law) == test::run_fstiff("export '" + file + "' --to abaqus --tolerance 5% --until '50 MPa'").out);
}

TEST_CASE("The C interface answers a scene as the command does") {
    const std::string scene = test::read(FSTIFF_SCENES "/built_in.toml");
    for (const bool with_name : {false, true}) {
        const test::Folder folder;
        const std::string file = folder.write("scene.toml", scene);
        const auto made = made_by([&](auto to) {
            return with_name ? fstiff_run(scene.c_str(), scene.size(), file.c_str(), nullptr, to)
                             : fstiff_run(nullptr, 0, nullptr, nullptr, to);
        });
        const auto printed =
            test::run_fstiff("run " + (with_name ? "'" + file + "'" : std::string()) + " --format json");
        if (!with_name) CHECK(text_of(made) == printed.out);
        const auto answer = nlohmann::json::parse(printed.out)["answer"];
        CHECK(answer.size() > 2);
        for (const char* key : {"pressure_Pa", "stiffness_Pa_per_m", "stiffness_p05_Pa_per_m", "stiffness_p95_Pa_per_m",
                                "stiffness_N_per_m"}) {
            std::vector<double> wanted;
            for (const auto& row : answer) wanted.push_back(row[key]);
            CHECK(numbers_at(made, "answer.*." + std::string(key)) == wanted);
        }
        char law[32];
        std::size_t length = 0;
        REQUIRE(fstiff_document_word(made.get(), "answer.1.law", law, sizeof law, &length) == FSTIFF_OK);
        CHECK(law == answer[1]["law"].get<std::string>());
        CHECK(fstiff_document_word(made.get(), "answer.1.pressure_Pa", law, sizeof law, &length) ==
              FSTIFF_BAD_ARGUMENT);
        std::size_t count = 0;
        CHECK(fstiff_document_numbers(made.get(), "answer.*.none", nullptr, 0, &count) == FSTIFF_BAD_ARGUMENT);
    }
}

TEST_CASE("The C interface refuses requests in one sentence") {
    fstiff_document* none = nullptr;
    const auto refused = [&](int status, int wanted, const std::string& words) {
        INFO(words << " in: " << fstiff_last_message());
        CHECK(status == wanted);
        CHECK(std::string(fstiff_last_message()).find(words) != std::string::npos);
        CHECK(!none);
    };
    refused(fstiff_spectrum(nullptr, "taper = none", &none), FSTIFF_REFUSED, "heights or the option file");
    refused(fstiff_spectrum(nullptr, "file = nowhere.csv", &none), FSTIFF_FILE, "no such file");
    refused(fstiff_spectrum(nullptr, "tapir = none", &none), FSTIFF_REFUSED, "tapir");
    for (const auto& [options, words] : {std::pair("kind = plane", "must be one of \"wm\", \"profile\", \"map\""),
                                         {"kind = map\nspacing = 1 um\nrms = 1 um", "needs hurst"},
                                         {"seed 3", "key = value"},
                                         {"seed = 3\nseed = 4", "seed is listed twice"},
                                         {"points = 1.5", "points = 1.5"}})
        refused(fstiff_generate(options, &none), FSTIFF_REFUSED, words);
    for (const auto& [options, words] : {std::pair("fit = sigma\nwave = perhaps", "perhaps"),
                                         {"fit = sigma\nshear = true", "shear is not an option"},
                                         {"fit = sigmas", "sigmas"}})
        refused(fstiff_identify(nullptr, 0, nullptr, nullptr, options, &none), FSTIFF_REFUSED, words);
    refused(fstiff_ultrasound(nullptr, "stiffness = 1e15\nfrequency = 7e6", &none), FSTIFF_REFUSED, "impedance");
    refused(fstiff_run(nullptr, 0, nullptr, "surface = nowhere.csv", &none), FSTIFF_FILE, "no such file");
    refused(fstiff_export(nullptr, 0, nullptr, "to = law\nlaw = summits", &none), FSTIFF_REFUSED, "summits");
    refused(fstiff_spectrum(nullptr, nullptr, nullptr), FSTIFF_BAD_ARGUMENT, "made");
    const fstiff_measured_curve empty{sizeof empty, nullptr, nullptr, nullptr, 0, 1};
    refused(fstiff_ultrasound(&empty, nullptr, &none), FSTIFF_BAD_ARGUMENT, "pressures");
    const auto wave = made_by([&](auto made) {
        return fstiff_ultrasound(nullptr, "stiffness = 1e15\nfrequency = 7e6\nimpedance = 46e6", made);
    });
    std::size_t count = 0;
    double one = 0;
    refused(fstiff_document_numbers(wave.get(), "reflection.x", &one, 1, &count), FSTIFF_BAD_ARGUMENT,
            "reflection.x: is not a path");
    refused(fstiff_document_numbers(wave.get(), "command", &one, 1, &count), FSTIFF_REFUSED, "neither a number");
    refused(fstiff_document_numbers(wave.get(), "reflection", &one, 0, &count), FSTIFF_BAD_ARGUMENT, "capacity = 0");
}

}  // namespace answers_test
#endif
