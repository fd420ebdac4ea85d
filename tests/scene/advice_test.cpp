// SPDX-License-Identifier: BSD-3-Clause
// Every sentence that advises something is tested by following it, over the scenes of data/ and docs/ and the
// files of tests/data: what is advised is not refused. A sentence that advises and is in no row of the table fails.
#include "actions/answered.hpp"
#include "actions/explanation.hpp"
#include "support/library.hpp"
#include "support/skip.hpp"

#include <filesystem>
#include <functional>
#include <regex>

namespace advice_test {

using namespace fstiff;

namespace {

/// A scene, and the name next to which its files are.
struct Text {
    std::string text, file;
};

/// A map and a profile of a self-affine surface, in files, for advice that asks for one.
const test::Folder& folder() {
    static const test::Folder of_all;
    static const bool written = [] {
        of_all.write("map.txt", test::map_text(64, 1e-6, {.hurst = 0.8, .rms = 0.3e-6, .shortest_wavelength = 8e-6}));
        return true;
    }();
    (void)written;
    return of_all;
}

/// \p text with \p line below the header of \p section, in place of a line of the same key, or in its inline table; the
/// section is made where it is not.
std::string with_line(const std::string& text, const std::string& section, const std::string& line) {
    const std::string key = line.substr(0, line.find(' ')),
                      name = std::regex_replace(section.substr(1, section.size() - 2), std::regex("\\."), "\\.");
    std::smatch inline_table;
    if (std::regex_search(text, inline_table, std::regex("\n" + name + " *= *\\{")))
        return std::string(inline_table.prefix()) + inline_table.str() + " " +
               std::regex_replace(line, std::regex("\n"), ", ") + "," + std::string(inline_table.suffix());
    std::smatch header;
    if (!std::regex_search(
            text, header, std::regex("\n" + std::regex_replace(section, std::regex("[\\[\\].]"), "\\$&") + "[^\n]*\n")))
        return text + "\n" + section + "\n" + line + "\n";
    const auto begin = static_cast<std::size_t>(header.position() + header.length());
    const std::size_t end = std::min(text.find("\n[", begin - 1), text.size());
    const std::string body =
        std::regex_replace("\n" + text.substr(begin, end - begin), std::regex("\n" + key + " *=[^\n]*"), "");
    return text.substr(0, begin) + line + body + text.substr(end);
}
/// \p line in the section of the upper body, which begins from its name where it was nothing else.
std::string with_strength(const std::string& text, const std::string& line) {
    std::smatch name;
    if (!std::regex_search(text, name, std::regex("\n(material\\.)?upper *= *(\"[^\"]*\")")))
        return with_line(text, "[material.upper]", line);
    return std::string(name.prefix()) + "\n" + name.str(1) + "upper = { name = " + name.str(2) + ", " + line + " }" +
           std::string(name.suffix());
}
std::string with_law(const std::string& text, const std::string& law) {
    if (text.find('"' + law + '"') != std::string::npos) return text;
    const std::regex laws("(\nlaws *= *\\[)");
    if (std::regex_search(text, laws)) return std::regex_replace(text, laws, "$1\"" + law + "\", ");
    return with_line(text, "[contact]", "laws = [\"" + law + "\"]");
}
std::string with_law_alone(const std::string& text, const std::string& law) {
    return with_law(std::regex_replace(text, std::regex("\nlaws *= *\\[[^\\]]*\\]"), ""), law);
}
/// \p text with \p surface in place of its [surface] and the sections of it.
std::string with_surface(const std::string& text, const std::string& surface) {
    const std::size_t begin = text.find("\n[surface") + 1;
    std::size_t end = text.find("\n[", begin);
    while (text.compare(end + 1, 8, "[surface") == 0) end = text.find("\n[", end + 1);
    return text.substr(0, begin) + surface + text.substr(end + 1);
}
std::string of_map(const std::string& text) {
    return with_surface(
        text, "[surface]\nfrom = '" + folder() / "map.txt" + "'\nlambda_s = \"none\"\nfractal_dimension = 1.4\n");
}
std::string of_two_maps(const std::string& text) {
    const std::string map = "from = '" + folder() / "map.txt" + "'\nlambda_s = \"none\"\n";
    return with_surface(text, "[surface.upper]\n" + map + "[surface.lower]\n" + map);
}

struct Advice {
    const char* says;
    std::function<std::string(const std::string& text, const std::smatch& said)> follow;
};

const std::vector<Advice>& table() {
    static const std::vector<Advice> rows{
        {R"(measure a map|only a map shows this|needs a map: surface\.from, or --surface, must name the file of one)",
         [](const std::string& text, const std::smatch&) { return with_law(of_map(text), "boundary_elements"); }},
        {R"(needs two maps of one grid)",
         [](const std::string& text, const std::smatch&) { return of_two_maps(text); }},
        {R"(set surface\.rms_gradient and surface\.alpha)",
         [](const std::string& text, const std::smatch&) {
             return with_law(with_line(with_line(text, "[surface]", "rms_gradient = 0.1"), "[surface]", "alpha = 8"),
                             "hybrid");
         }},
        {R"(set surface\.alpha)",
         [](const std::string& text, const std::smatch&) {
             return with_law(with_line(text, "[surface]", "alpha = 8"), "hybrid");
         }},
        {R"(needs material\.upper\.hardness or material\.upper\.yield_strength)",
         [](const std::string& text, const std::smatch&) { return with_strength(text, "hardness = \"3 GPa\""); }},
        {R"(needs material\.upper\.yield_strength)",
         [](const std::string& text, const std::smatch&) { return with_strength(text, "yield_strength = \"1 GPa\""); }},
        {R"(give process, or skewness and kurtosis)",
         [](const std::string& text, const std::smatch&) {
             return with_line(text, "[surface]", "process = \"honed\"");
         }},
        {R"(give contact\.nominal_area)",
         [](const std::string& text, const std::smatch&) {
             return with_line(text, "[contact]", "nominal_area = \"1 mm^2\"");
         }},
        {R"(fill = true next to surface\.from)",
         [](const std::string& text, const std::smatch&) { return with_line(text, "[surface]", "fill = true"); }},
        {R"((?:--)?spikes (= )?20 removes (it|them))",
         [](const std::string& text, const std::smatch&) { return with_line(text, "[surface]", "spikes = 20"); }},
        {R"(surface\.upper\.fractal_dimension: is missing; law \S+ needs it and fractal_roughness, of both faces)",
         [](const std::string& text, const std::smatch&) {
             const std::string fractal = "fractal_dimension = 1.5\nfractal_roughness = \"1e-10 m\"";
             return with_line(with_line(text, "[surface.upper]", fractal), "[surface.lower]", fractal);
         }},
        {R"(surface\.fractal_dimension: is missing)", [](const std::string& text, const std::smatch&) {
             return with_line(text, "[surface]", "fractal_dimension = 1.5");
         }}};
    return rows;
}

/// Words that advise: who reads them has something to do.
const std::regex advises(R"re(\b(use |measure a|only a map|fills them|takes (?:it|them) out|keeps the|set |state ))re"
                         R"re(|[;(] ?give |needs a map|needs material)re");

/// All scenes of data/, docs/ and of the pages, at one pressure and without a band, and one of them with a map in
/// place of its surface.
std::vector<Text> scenes() {
    std::vector<Text> all;
    const auto add = [&](std::string text, const std::string& file) {
        text = std::regex_replace("\n" + text, std::regex("\n(pressures|separations) *=[^\n]*"),
                                  "\npressures = [\"10 MPa\"]");
        text = with_line(with_line(text, "[uncertainty]", "samples = 0"), "[boundary_elements]", "points = 32");
        if (test::refusal([&] { (void)test::scene_of(text, file); }).empty()) all.push_back({text, file});
    };
    for (const char* path : {"/.", "/../docs"})
        for (const auto& entry : std::filesystem::directory_iterator(FSTIFF_SCENES + std::string(path))) {
            const std::string file = entry.path().string();
            if (file.ends_with(".toml")) add(test::read(file), file);
            if (!file.ends_with(".md")) continue;
            const std::string page = test::read(file), fence = "```toml\n";
            for (std::size_t at = 0; (at = page.find(fence, at)) != std::string::npos; ++at) {
                const std::string block =
                    page.substr(at + fence.size(), page.find("```\n", at + 1) - at - fence.size());
                if (test::contains(block, "[contact]") && test::contains(block, "[surface")) add(block, file);
            }
        }
    for (std::size_t i = 0; i < 1; ++i) all.push_back({of_map(all[i].text), all[i].file});
    return all;
}

/// The text that follows the first row that \p sentence is in; empty where it is in none.
std::string followed_by_first(const std::string& text, const std::string& sentence) {
    for (const Advice& advice : table()) {
        std::smatch said;
        if (std::regex_search(sentence, said, std::regex(advice.says))) return advice.follow(text, said);
    }
    return "";
}

/// The refusal of \p of after all that its refusals advise was done, at most three times; empty where it is computed.
std::string refusal_in_the_end(Text of, int* refused = nullptr) {
    std::string sentence = test::refused_scene(of.text, of.file);
    for (int steps = 0; steps < 3 && !sentence.empty(); ++steps) {
        if (refused) ++*refused;
        of.text = followed_by_first(of.text, sentence);
        if (of.text.empty()) break;
        sentence = test::refused_scene(of.text, of.file);
    }
    return sentence;
}

/// Follows \p sentence on \p of, by every row of the table that matches it; returns how many these are. The new
/// scene is computed, or its refusal names what else it needs.
int follow(const Text& of, const std::string& sentence) {
    int followed = 0;
    INFO("of " << of.file << ": " << sentence);
    for (const Advice& advice : table()) {
        std::smatch said;
        if (!std::regex_search(sentence, said, std::regex(advice.says))) continue;
        const std::string text = advice.follow(of.text, said);
        INFO("followed by the row " << advice.says << "\n" << text);
        CHECK(refusal_in_the_end({text, of.file}) == "");
        ++followed;
    }
    if (std::regex_search(sentence, advises)) CHECK(followed > 0);
    return followed;
}

/// All sentences about \p results. The explanation has at most three, and nothing asks for a law that was not
/// computed.
std::vector<std::string> sentences_of(const scene::Scene& read, const actions::Answered& results) {
    std::vector<std::string> all = results.explanation;
    CHECK(all.size() <= 3);
    for (const std::string& sentence : all) CHECK(sentence.find(". ") == std::string::npos);
    all.push_back(actions::outside_band(results));
    for (const auto* more : {&results.short_explanation, &results.warnings})
        all.insert(all.end(), more->begin(), more->end());
    if (test::face(read).measured)
        all.insert(all.end(), test::measured_of(read).warnings.begin(), test::measured_of(read).warnings.end());
    for (const std::string& sentence : all)
        for (const char* words : {"believe", "add \"", "contact.laws", "ecommended"})
            CHECK_FALSE(test::contains(sentence, words));
    return all;
}

}  // namespace

TEST_CASE("Advice in the explanation and the warnings of a scene can be followed, in every scene of data and docs") {
    int followed = 0;
    const auto all = scenes();
    CHECK(all.size() >= 8);
    for (const Text& of : all) {
        INFO(of.file);
        const scene::Scene read = test::scene_of(of.text, of.file);
        for (const std::string& sentence : sentences_of(read, actions::compute(read))) followed += follow(of, sentence);
    }
    CHECK(followed >= 5);  // the area of most of them is not known
}

TEST_CASE("Every law is computed in every scene of data and docs, or its refusal names the remedy, and that is enough",
          "[more]") {
    int refused = 0;
    for (const Text& of : scenes()) {
        if (test::contains(of.text, "shared/surfaces")) continue;  // a large map: its explanation is followed above
        for (const ChosenLaw& one : detail::all_laws()) {
            const detail::Law& law = one.row();
            INFO(of.file << ", law " << law.name);
            CHECK(refusal_in_the_end({with_law_alone(of.text, std::string(law.name)), of.file}, &refused) == "");
        }
    }
    CHECK(refused >= 20);
}

TEST_CASE("Advice about holes, spikes, a lay and waviness can be followed") {
    const std::string rest =
        "\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n[contact]\n"
        "pressures = [\"10 MPa\"]\nlaws = [\"hertz\"]\n[uncertainty]\nsamples = 0\n[boundary_elements]\npoints = 32\n";
    const auto surface = [&](const std::string& name, const std::string& keys) {
        return Text{"\n[surface]\nfrom = '" + folder() / name + "'\n" + keys + rest, "s.toml"};
    };
    fstiff::HeightMap<double> map =
        fstiff::self_affine_map<double>({.hurst = 0.8, .rms = 0.3e-6, .shortest_wavelength = 8e-6}, 64, 64, 1e-6, 1e-6);
    const auto write = [&](const std::string& name, const auto& heights) {
        std::ofstream file(folder() / name);
        fstiff::io::write_csv(file, heights);
        return name;
    };
    std::vector<Text> all;
    fstiff::HeightMap<double> holes = map, spiked = map, skewed = map;
    holes.heights(20, 30) = std::numeric_limits<double>::quiet_NaN();
    all.push_back(surface(write("holes.csv", holes), "lambda_s = \"none\"\n"));
    spiked.heights(20, 30) = 40e-6;
    all.push_back(surface(write("spiked.csv", spiked), "lambda_s = \"none\"\n"));
    skewed.heights = 1e-6 * (3e6 * map.heights).exp();
    all.push_back(surface(write("skewed.csv", skewed), "lambda_s = \"none\"\n"));
    fstiff::Profile<double> turned = fstiff::self_affine_profile<double>(
        {.hurst = 0.7, .rms = 0.12e-6, .longest_wavelength = 60e-6, .shortest_wavelength = 16e-6}, 1024, 4e-6);
    for (std::size_t i = 0; i < turned.size(); ++i) {
        const double x = std::remainder(double(i) * 4, 256);
        turned.heights[i] += x * x / 1600 * 1e-6;
    }
    all.push_back(surface(write("turned.csv", turned), ""));
    std::string said;
    for (const Text& of : all) {
        const scene::Scene read = test::scene_of(of.text, of.file);
        for (const std::string& sentence : sentences_of(read, actions::compute(read))) {
            (void)follow(of, sentence);
            said += sentence + "\n";
        }
        for (const ChosenLaw& one : detail::all_laws())
            if (const std::string why = read.refusal_of(one.row()); !why.empty())
                (void)follow({with_line(with_line(of.text, "[material.upper]", "yield_strength = \"1 GPa\""),
                                        "[surface]", "fractal_dimension = 1.5"),
                              of.file},
                             why);
    }
    for (const char* words : {"fill = true next to", "removes it", "only a map shows this"}) {
        INFO(said << "\nmissing: " << words);
        CHECK(test::contains(said, words));
    }
}

TEST_CASE("Advice about the files of tests/data is a key that their scene takes") {
    int followed = 0;
    for (const char* path : {FSTIFF_TEST_DATA "/formats", FSTIFF_SURFACES}) {
        if (!std::filesystem::exists(path)) continue;
        for (const auto& entry : std::filesystem::directory_iterator(path)) {
            if (!entry.is_regular_file() || entry.file_size() > 200000) continue;
            const Text of{"\n[surface]\nfrom = '" + entry.path().string() +
                              "'\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n[contact]\n"
                              "pressures = [\"10 MPa\"]\nlaws = [\"hertz\"]\n[uncertainty]\nsamples = 0\n"
                              "[boundary_elements]\npoints = 32\n",
                          "s.toml"};
            scene::Scene read;
            if (!test::refusal([&] { read = test::scene_of(of.text, of.file); }).empty()) continue;
            for (const std::string& sentence : sentences_of(read, actions::compute(read)))
                followed += follow(of, sentence);
        }
    }
    CHECK(followed >= 2);
}

}  // namespace advice_test
