// SPDX-License-Identifier: BSD-3-Clause
// Contents of a scene and their messages: ranges of keys, values that contradict each other, values that were
// assumed, files that are listed twice.
#include "actions/answered.hpp"

#include "cli/command.hpp"

#include "actions/truth.hpp"
#include "document/file.hpp"
#include "document/rows.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/answer/face.hpp>
#include <fstiff/io/write.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>

#include "support/accuracy.hpp"
#include "support/half_space_maps.hpp"
#include "support/library.hpp"

#include <algorithm>
#include <cmath>

namespace read_scene_test {

using namespace fstiff;
using fstiff::Parameter;
using test::contains, test::joined;

namespace {

const std::string islands = "rms_height = \"1 um\"\npeak_radius = \"40 um\"\npeak_density = \"2000 /mm^2\"\n";
const std::string moments = "rms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 8\n";

/// A scene of \p surface, whose section [contact] ends with \p contact.
std::string text_of(const std::string& surface, const std::string& contact = "laws = [\"hertz\"]\n") {
    return "[surface]\n" + surface +
           "[material.upper]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0\n[contact]\npressures = [\"10 MPa\"]\n"
           "peaks = [{ theta = 1.0, r = 0.5 }]\n" +
           contact;
}

scene::Scene read(const std::string& text) { return scene::read_scene(text, {.name = "s.toml"}); }
std::string refused(const std::string& text) {
    return test::refusal([&] { (void)read(text); });
}
/// The relative width of the band of the first curve at its first point.
double width(const std::string& text) {
    const auto results = actions::compute(read(text));
    const auto& band = results.curves().front().points.at(0).stiffness;
    return std::log(band.high / band.low);
}

/// A trace of \p points heights in a file.
std::string trace(const test::Folder& folder, const std::string& name, int points, double phase = 0) {
    std::string text;
    std::uint64_t state = 7;
    double z = phase;
    for (int i = 0; i < points; ++i) {
        z = 0.9 * z + fstiff::math::normal_pair<double>(state).real();
        text += document::exact(i * 0.5) + " " + document::exact(z + std::sin(0.02 * i)) + "\n";
    }
    return folder.write(name, text);
}

std::string from_trace(const test::Folder& folder) {
    return "from = \"" + trace(folder, "trace.txt", 4000) + "\"\nunits = \"um\"\nlambda_s = \"3 um\"\n";
}

}  // namespace

TEST_CASE("theta written next to a measured r holds for the neighbours of lambda_s too") {
    const test::Folder folder;
    const std::string from = from_trace(folder);
    const scene::Scene measured = read(text_of(from)), theta = read(text_of(from + "theta = 1.5\n")),
                       r = read(text_of(from + "r = 0.25\n"));
    REQUIRE(measured.joint.face.neighbours.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        REQUIRE(measured.joint.face.neighbours[k].parameters.r);
        CHECK(measured.joint.face.neighbours[k].parameters.theta->value != 1.5);
        CHECK(theta.joint.face.neighbours[k].parameters.theta->value == 1.5);
        CHECK(theta.joint.face.neighbours[k].parameters.r->value ==
              measured.joint.face.neighbours[k].parameters.r->value);
        CHECK(r.joint.face.neighbours[k].parameters.r->value == 0.25);
        CHECK(r.joint.face.neighbours[k].parameters.theta->value ==
              measured.joint.face.neighbours[k].parameters.theta->value);
    }
}

TEST_CASE("What is written next to what was measured holds for the neighbours of lambda_s too, and without an error") {
    const test::Folder folder;
    const std::string from = from_trace(folder);
    const detail::Face measured = read(text_of(from)).joint.face,
                       written = read(text_of(from + "rms_height = \"2 um\"\nfractal_dimension = 1.25\nalpha = 9\n"
                                                     "hurst = 0.75\nskewness = -1\nkurtosis = 6\n"
                                                     "errors = { rms_height = \"0.5 um\" }\n"))
                                     .joint.face;
    REQUIRE(written.neighbours.size() == 2);
    for (const detail::Face* face : {&written, &written.neighbours[0], &written.neighbours[1]}) {
        CHECK(test::relative_error(face->parameters.rms_height.value, 2e-6) < 1e-15);
        CHECK(face->dimension() == 1.25);
        CHECK(face->alpha == 9);
        CHECK(face->hurst == 0.75);
        CHECK(face->shape.skewness == -1);
        CHECK(face->bearing);
        CHECK(face->parameters.correlation[0][1] == 0);
    }
    CHECK(test::relative_error(written.parameters.rms_height.error, 0.5e-6) < 1e-15);
    CHECK(written.parameters.peak_radius.value == measured.parameters.peak_radius.value);
    CHECK(written.parameters.peak_radius.error == measured.parameters.peak_radius.error);
    CHECK(written.measured->rms_height.value == measured.parameters.rms_height.value);
}

TEST_CASE("Without a band nothing is measured with other lambda_s, and all else is the same") {
    const test::Folder folder;
    const std::string from = from_trace(folder);
    const auto with = [&](int samples) {
        return read(text_of(from, "laws = [\"hertz\"]\n[uncertainty]\nsamples = " + std::to_string(samples) + "\n"));
    };
    const scene::Scene banded = with(20), plain = with(0);
    CHECK(banded.joint.face.neighbours.size() == 2);
    CHECK(plain.joint.face.neighbours.empty());
    CHECK(plain.joint.face.parameters.values() == banded.joint.face.parameters.values());
    for (const fstiff::detail::ParameterRow& row : fstiff::detail::surface_parameter_table) {
        const auto* one = plain.joint.face.parameters.find(row.parameter);
        const auto* other = banded.joint.face.parameters.find(row.parameter);
        REQUIRE(!one == !other);
        if (one) CHECK(one->error == other->error);
    }
    CHECK(plain.warnings == banded.warnings);
}

TEST_CASE("contact.summits.mutual is true or false, or 1 or 0") {
    const test::Folder folder;
    const fstiff::HeightMap<double> map = test::corner_of_map(48);
    const std::string from = "from = \"" + folder.write("map.csv", test::file_text(map)) + "\"\nlambda_s = \"none\"\n";
    const auto with = [&](const std::string& mutual) {
        return text_of(from, "laws = [\"summits\"]\n[contact.summits]\nmutual = " + mutual + "\n");
    };
    for (const char* yes : {"true", "1", "1.0"}) CHECK(read(with(yes)).joint.law_options.mutual);
    for (const char* no : {"false", "0"}) CHECK_FALSE(read(with(no)).joint.law_options.mutual);
    for (const char* other : {"-1", "0.5", "1e9", "\"yes\""}) {
        INFO(other);
        CHECK(contains(refused(with(other)), "contact.summits.mutual = "));
        CHECK(contains(refused(with(other)), "must be true or false, or 1 or 0"));
    }
}

TEST_CASE("The options of persson and of boundary_elements are below contact, as those of summits, or at the root") {
    for (const char* path : {"persson", "contact.persson"}) {
        CHECK(read(text_of(moments, "[" + std::string(path) + "]\ngamma = 0.5\n")).joint.law_options.gamma == 0.5);
        CHECK(contains(refused(text_of(moments, "[" + std::string(path) + "]\ngamma = 2\n")),
                       std::string(path) + ".gamma = 2"));
    }
    for (const char* path : {"boundary_elements", "contact.boundary_elements"})
        CHECK(read(text_of(moments, "[" + std::string(path) + "]\npoints = 64\n")).joint.law_options.points == 64);
    CHECK(contains(refused(text_of(moments, "[persson]\ngamma = 0.5\n[contact.persson]\ngamma = 0.5\n")),
                   "must not be given with contact.persson"));
    CHECK(contains(refused(text_of(moments, "persson = 3\n")), "contact.persson = 3: must be a section"));
}

TEST_CASE("D, its error and the Hurst exponent stay within what a surface can have") {
    const auto of_dimension = [](const std::string& d) { return islands + "fractal_dimension = " + d + "\n"; };
    CHECK(contains(refused(text_of(of_dimension("1.9999999999999998"))), "greater than 1 and at most 1.99"));
    CHECK(contains(refused(text_of(of_dimension("1.995"))), "fractal_dimension = 1.995"));
    CHECK(read(text_of(of_dimension("1.99"))).joint.face.dimension() == 1.99);
    const auto with_error = [&](const std::string& errors) {
        return text_of(of_dimension("1.5") + "errors = { " + errors + " }\n");
    };
    CHECK(contains(refused(with_error("fractal_dimension = 5.0")),
                   "must be at most 0.5, half the range of fractal_dimension"));
    CHECK(read(with_error("fractal_dimension = 0.2")).joint.face.parameters.fractal_dimension->error == 0.2);

    const scene::Scene odd = read(text_of(of_dimension("1.62") + "hurst = 0.8\n"));
    CHECK(contains(joined(odd.warnings),
                   "surface.hurst = 0.8 contradicts the fractal dimension 1.62, of which H = 2 - D is 0.38"));
    CHECK_FALSE(contains(joined(read(text_of(of_dimension("1.3") + "hurst = 0.7\n")).warnings), "contradicts"));
    CHECK_FALSE(contains(joined(read(text_of(islands + "hurst = 0.7\n")).warnings), "contradicts"));
}

TEST_CASE("The error of rms_gradient widens the band, of R and D_p too where they follow from it") {
    const std::string laws = "laws = [\"persson\", \"hertz\"]\n";
    CHECK(contains(refused(text_of(islands + "errors = { rms_gradient = 0.01 }\n")),
                   "needs the value of surface.rms_gradient"));
    CHECK(contains(refused(text_of(moments + "errors = { rms_gradient = -0.01 }\n")), "not negative"));
    const std::string error = "errors = { rms_gradient = 0.02 }\n";
    CHECK(read(text_of(moments + error)).joint.face.gradient_error == 0.02);
    // p* falls with g: at a light load K of either law does, by R and D_p or by the spectrum
    CHECK(width(text_of(moments + error, "laws = [\"persson\"]\n")) > 0.0015);
    const double follows = width(text_of(moments + error, "laws = [\"hertz\"]\n"));
    CHECK(follows > 0.02);
    // R and D_p that are written do not follow; hertz takes these alone
    CHECK(width(text_of(moments + "peak_radius = \"40 um\"\npeak_density = \"2000 /mm^2\"\n" + error,
                        "laws = [\"hertz\"]\n")) < 1e-9);
    const double twice = width(text_of(moments + "errors = { rms_gradient = 0.04 }\n", "laws = [\"hertz\"]\n"));
    CHECK(twice > 1.5 * follows);
}

TEST_CASE("H and alpha that were assumed are among the inputs, and those that were given are not assumed") {
    const auto input = [](const scene::Scene& of, const std::string& key) {
        const request::Input& found = test::input_of(of, key);
        return found.shown() + " " + document::rounded(*found.value, 3);
    };
    const std::string persson = "laws = [\"persson\"]\n";
    const std::string spectrum = "rms_height = \"1 um\"\npeak_radius = \"4 um\"\npeak_density = \"20000 /mm^2\"\n";
    const scene::Scene plain = read(text_of(spectrum, persson));
    CHECK(input(plain, "surface.hurst") == "assumed, since D is not known (default) 0.8");
    CHECK(contains(input(plain, "surface.alpha"), "of sigma, R and D_p (default) "));
    CHECK(plain.assumed().size() == 2);
    const scene::Scene fractal = read(text_of(spectrum + "fractal_dimension = 1.4\n", persson));
    CHECK(input(fractal, "surface.hurst") == "2 - D (default) 0.6");
    CHECK(read(text_of(moments + "hurst = 0.7\n", persson)).assumed().empty());
    CHECK(read(text_of(spectrum)).assumed().empty());  // no law takes a spectrum
}

TEST_CASE("A file that is listed twice counts once, and both names are reported") {
    const test::Folder folder;
    std::filesystem::create_directory(folder / "traces");
    const std::string a = trace(folder, "traces/a.txt", 1200), c = trace(folder, "traces/c.txt", 1200, 30);
    std::filesystem::copy_file(a, folder / "traces/b.txt");
    surface::MeasureOptions options;
    options.input.units = "um";
    options.neighbours = false;
    options.resamples = 20;
    const auto error_of = [](const surface::MeasuredSurface& of) { return of.found.rms_height.error; };
    const surface::MeasuredSurface once = surface::measure_files(options, {a}),
                                   nine = surface::measure_files(options, std::vector<std::string>(9, a));
    CHECK(nine.parts.empty());
    CHECK(error_of(nine) == error_of(once));
    CHECK(contains(joined(nine.warnings), a + ": is the same file as " + a));
    const surface::MeasuredSurface both = surface::measure_files(options, {a, c}),
                                   all = surface::measure_files(options, {folder / "traces"});
    CHECK(all.parts.size() == 2);
    CHECK(error_of(all) == error_of(both));
    CHECK(contains(joined(all.warnings), folder / "traces/b.txt" + ": is the same file as " + a));
    CHECK_FALSE(contains(joined(both.warnings), "same file"));
}

TEST_CASE("truth warns where elastic pressures exceed the hardness of the body, and not where they are cut") {
    const fstiff::HeightMap<double> map = test::corner_of_map(32);
    actions::TruthRequest request;
    request.surface.file = "map";
    request.modulus = 100e9;
    request.pressures = {1e6};
    request.known_hardness = 5e8;
    const surface::SurfaceInput input = surface::surface_of_heights(request.surface, {map}, "made here");
    const actions::TruthOfMap flows = actions::truth_of_map(request, input);
    REQUIRE(flows.at.front().state.max_pressure > 5e8);
    CHECK(contains(joined(actions::document_of(request, input).warnings),
                   "exceed the hardness of the softer body, 500 MPa"));
    request.known_hardness = 2 * flows.at.front().state.max_pressure;
    CHECK_FALSE(contains(joined(actions::document_of(request, input).warnings), "exceed"));
    request.known_hardness = request.hardness = 5e8;
    CHECK_FALSE(contains(joined(actions::document_of(request, input).warnings), "exceed"));
    test::check_refused("truth - --hardness '0 Pa'", 3, {"--hardness = 0", "greater than 0"}, "1 2\n");
}

TEST_CASE("The separation of boundary elements is that of the mean planes: of the highest point at a light load") {
    const fstiff::HeightMap<double> map = test::corner_of_map(64);
    actions::TruthRequest request;
    request.surface.file = "map";
    request.surface.detrend = "mean";
    request.surface.lambda_s = request.surface.lambda_c = "none";
    request.modulus = 100e9;
    request.pressures = {10};
    const auto solved =
        actions::truth_of_map(request, surface::surface_of_heights(request.surface, {map}, "made here"));
    const double highest = map.heights.maxCoeff() - map.heights.mean();
    CHECK(test::relative_error(solved.at.front().state.mean_gap, highest) < 1e-3);
    CHECK(contains(actions::pressure_rows(solved).text(), "separation [µm]"));
}

TEST_CASE("A cell of CSV with a comma, a quotation mark or a line end is quoted, and no other") {
    CHECK(document::csv_line({"a", "b c", "", "1.5"}) == "a,b c,,1.5\n");
    CHECK(document::csv_line({"b,c.csv", "5\" pipe", "two\nlines"}) == "\"b,c.csv\",\"5\"\" pipe\",\"two\nlines\"\n");
    CHECK(test::csv_cells("\"b,c.csv\",x") == std::vector<std::string>{"b,c.csv", "x"});
}

TEST_CASE("Percents are shown without an exponent") {
    CHECK(document::shown_percent(0.998) == "100 %");
    CHECK(document::shown_percent(1.81) == "181 %");
    CHECK(document::shown_percent(0.085) == "8.5 %");
    CHECK(document::shown_percent(0.0012) == "0.12 %");
}

TEST_CASE("What is not known to a factor of two is reported once") {
    fstiff::SurfaceParameters<double> values;
    values.set(Parameter::rms_height, {1e-6, 1e-7});
    values.set(Parameter::peak_radius, {40e-6, 72e-6});
    values.set(Parameter::peak_density, {5e8, 2e8});
    using Concern = fstiff::MeasuredConcern;
    const auto lines = surface::peak_warnings(
        {Concern::radius_uncertain, Concern::density_uncertain, Concern::parameter_unknown}, 100, values);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0] == "D_p is known to 40 % only");
    CHECK(contains(lines[1], "R (180 %): not known to a factor of two"));
}

}  // namespace read_scene_test
