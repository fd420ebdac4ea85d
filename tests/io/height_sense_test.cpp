// SPDX-License-Identifier: BSD-3-Clause
// Depths and factors of heights in titles and headers. Truth: the numbers of the text, with the sign that is meant.
#include "io/height_sense.hpp"
#include "support/samples.hpp"

namespace height_sense_test {

using namespace fstiff;
using namespace fstiff::io::detail;
using io::SurfaceOptions;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

double number(int i) { return 0.1 * ((i * i + 3) % 11) - 0.35; }
std::string profile(const std::string& head, const std::string& separator = ";") {
    std::string text = head + "\n";
    for (int i = 0; i < 20; ++i)
        text += std::to_string(i / 2) + (i % 2 ? ".5" : ".0") + separator + number_text(number(i)) + "\n";
    return text;
}
std::string heights_alone(const std::string& head) {
    std::string text = head + "\n";
    for (int i = 0; i < 20; ++i) text += number_text(number(i)) + "\n";
    return text;
}
std::string triples(const std::string& head, const std::string& separator = ";") {
    std::string text = head + "\n";
    for (int i = 0; i < 20; ++i)
        text += std::to_string(i % 5) + separator + std::to_string(i / 5) + separator + number_text(number(i)) + "\n";
    return text;
}
std::string matrix(const std::string& head) {
    std::string text = head + "\n";
    for (int i = 0; i < 20; ++i) text += number_text(number(i)) + (i % 5 < 4 ? "\t" : "\n");
    return text;
}
constexpr test::FileReader read{};
const test::RefusalOf refusal(read);

/// The sign and the factor that the heights of \p text have over its numbers; 0 where they differ.
double ratio(const std::string& text, const SurfaceOptions& options = {}) {
    const io::Surface surface = read(text, options);
    const auto heights = [&](int i) {
        return surface.is_profile() ? surface.profile().heights[static_cast<std::size_t>(i)]
                                    : surface.map().heights.data()[i];
    };
    const double first = heights(0) / number(0);
    for (int i = 1; i < 20; ++i)
        if (!(std::abs(heights(i) - first * number(i)) < 1e-12 * std::abs(first))) return 0;
    return first / 1e-6;
}
std::size_t warnings(const std::string& text, const SurfaceOptions& options = {}) {
    return read(text, options).record.warnings.size();
}
bool is(double value, double truth) { return std::abs(value - truth) < 1e-12 * std::abs(truth); }
const std::string sizes = "# Width: 5 um\n# Height: 4 um\n";

}  // namespace

TEST_CASE("A column of depths gives heights of the other sign, with a warning", "[sense]") {
    for (const char* title : {"depth [um]",
                              "Depth (um)",
                              "DEPTH/um",
                              "depth_um",
                              "z depth [um]",
                              "Measured Depth [um]",
                              "z (depth) [um]",
                              "Tiefe [um]",
                              "tiefe in um",
                              "Profondeur (um)",
                              "profundidad [um]",
                              "Profondit\xC3\xA0 [um]",
                              "Profondit\xE0 [um]",
                              "\xE6\xB7\xB1\xE5\xBA\xA6 [um]",
                              "\xE6\xB7\xB1\xE3\x81\x95 (um)",
                              "-z [um]",
                              "\xE2\x88\x92z [um]",
                              "z inverted [um]",
                              "Height (inverted) [um]",
                              "H\xC3\xB6he invertiert [um]",
                              "inverted z (um)",
                              "minus z [um]",
                              "z downwards [um]",
                              "\"Tiefe [um]\""}) {
        CAPTURE(title);
        CHECK(is(ratio(profile("x [um];" + std::string(title))), -1));
        CHECK(warnings(profile("x [um];" + std::string(title))) == 1);
        CHECK(is(ratio(triples("x [um];y [um];" + std::string(title))), -1));
        CHECK(is(ratio(profile("x [um]\t" + std::string(title), "\t")), -1));
    }
    CHECK(is(ratio(profile("x [um]  measured depth [um]", " ")), -1));
    CHECK(is(ratio(triples("x [um] y [um] measured depth [um]", " ")), -1));
    CHECK(is(ratio(profile("x;Tiefe\n[um];[um]")), -1));
    CHECK(is(ratio(heights_alone("depth [um]"), {.spacing = 1e-6}), -1));
    CHECK(is(ratio(profile("x;depth"), {.units = "um"}), -1));
    CHECK(is(ratio(triples("x,y,depth", ","), {.units = "um"}), -1));
    const auto found = read(triples("x [um];y [um];depth [um]"));
    CHECK(found.record.warnings[0] ==
          "the heights are the numbers with the other sign, by line 1, which states \"depth [um]\"");
}

TEST_CASE("A column of heights keeps its sign, whatever other columns and words are there", "[sense]") {
    for (const char* title : {"z [um]", "Height [um]", "H\xC3\xB6he [um]", "z minus plane [um]", "Deep learning z [um]",
                              "profile [um]", "Base height [um]", "[um]", "Height above depth gauge [um]"}) {
        CAPTURE(title);
        CHECK(is(ratio(profile("x [um];" + std::string(title))), 1));
        CHECK(warnings(profile("x [um];" + std::string(title))) == 0);
    }
    CHECK(is(ratio(profile("depth [um];z [um]")), 1));  // of a section through a wall
    for (const char* head :
         {"# Depth: 5 um", "# Measuring depth: 100 um", "# Bit depth: 16", "# depth of focus 3 um", "# Depth profile",
          "# inverted: no", "# inverted = 0", "# inverted: false", "# x inverted: yes", "# colormap inverted: yes",
          "# heights are not inverted", "# Direction: down", "# inverted microscope", "# sign: positive"}) {
        CAPTURE(head);
        CHECK(is(ratio(profile(std::string(head) + "\nx [um];z [um]")), 1));
    }
    CHECK(is(ratio(matrix(sizes + "# Channel: Topography\n# Depth: 5 um\n# Value units: um")), 1));
}

TEST_CASE("A header that inverts the heights, or calls them depths, is followed with a warning", "[sense]") {
    for (const char* head : {"# inverted: yes", "inverted=true", "Inverted;1", "# Z inverted: on", "# invertiert: ja",
                             "# heights inverted: yes", "# Heights are inverted", "# z axis: downwards",
                             "# positive z: down", "# sign of z: -1", "# data: inverted", "# polarity: inverted",
                             "# z inverted", "# z flipped: yes", "# invers\xC3\xA9: oui"}) {
        CAPTURE(head);
        const std::string line = std::string(head) + "\n";
        CHECK(is(ratio(profile(line + "x [um];z [um]")), -1));
        CHECK(is(ratio(triples(line + "x [um];y [um];z [um]")), -1));
        CHECK(is(ratio(matrix(sizes + "# Value units: um\n" + line)), -1));
        CHECK(warnings(matrix(sizes + "# Value units: um\n" + line)) == 1);
    }
    for (const char* head : {"# Channel: Depth", "# Quantity: depth", "# Depth unit: um", "# Depth map", "Tiefe [um]",
                             "# depth in um", "# Kanal: Tiefe", "# Depth"}) {
        CAPTURE(head);
        CHECK(is(ratio(matrix(sizes + head), {.units = "um"}), -1));
    }
    CHECK(has(refusal(profile("# inverted: yes\nx [um];depth [um]")), "turns its heights over twice"));
    CHECK(has(refusal(profile("# z inverted: perhaps\nx [um];z [um]")), "must be \"yes\" or \"no\""));
}

TEST_CASE("A factor in a title is refused without units, and reported with them", "[factor]") {
    for (const char* title : {"z/10 [um]",
                              "z / 10 [um]",
                              "10*z [um]",
                              "10 * z [um]",
                              "z*10 [um]",
                              "z x 10 [um]",
                              "z x10 [um]",
                              "z \xC3\x97 10 [um]",
                              "z\xC3\x97"
                              "10 [um]",
                              "10 x z [um]",
                              "10x z [um]",
                              "z 10x [um]",
                              "z [um]/10",
                              "z [um] * 10",
                              "z\xC3\xB7"
                              "10 [um]",
                              "0.1*z [um]",
                              "z (x10) [um]",
                              "z (gain 10) [um]",
                              "z magnified 10 times [um]",
                              "z scaled by 10 [um]",
                              "Tiefe/10 [um]",
                              "H\xC3\xB6he x 100 (um)",
                              "z_x_10 [um]",
                              "z 1:10 [um]",
                              "z \xC3\xBC\x62\x65rh\xC3\xB6ht 10x [um]",
                              "10z [um]",
                              "1e3*z [um]",
                              "z 10^-3 [um]",
                              "z*10**3 [um]",
                              "z 1e-3 [um]",
                              "z mal 10 [um]"}) {
        CAPTURE(title);
        const std::string cell(title);
        CHECK(has(refusal(profile("x [um];" + cell)), "which is not understood"));
        CHECK(has(refusal(triples("x [um];y [um];" + cell)), "which is not understood"));
        CHECK(has(refusal(profile("# Z unit: um\nx [um];" + cell)), "which is not understood"));
        CHECK(warnings(profile("x [um];" + cell), {.units = "um"}) >= 1);
        CHECK(warnings(triples("x [um];y [um];" + cell), {.units = "um,nm"}) >= 1);
    }
    CHECK(has(refusal(profile("x [um] z x 10 [um]", " ")), "which is not understood"));
    CHECK(has(refusal(profile("x;z/10\n[um];[um]")), "which is not understood"));
    CHECK(has(refusal(profile("x*10 [um];z [um]")), "for the positions"));
    CHECK(has(refusal(heights_alone("z/10 [um]"), {.spacing = 1e-6}), "which is not understood"));
}

TEST_CASE("A number of a channel or a profile in a title is no factor", "[factor]") {
    for (const char* title : {"z2 [um]", "z 2 [um]", "Profile 2 [um]", "Trace-2 [um]", "Profil 1/3 [um]", "z1 [um]",
                              "H\xC3\xB6he (Kanal 2) [um]", "2nd trace [um]", "z (3 x 3 median) [um]", "z (10 nm)",
                              "z [10 nm]", "z [x10 nm]", "z*1 [um]", "z 12:30 [um]"}) {
        CAPTURE(title);
        CHECK(refusal(profile("x [um];" + std::string(title))).empty() != has(title, "(10 nm)"));
    }
    CHECK(refusal(profile("Profile X 2 [um];Profile Z 2 [um]")).empty());
    CHECK(refusal(profile("x 2 [um];z 2 [um]")).empty());
    CHECK(refusal(profile("x10 [um];z10 [um]")).empty());
}

TEST_CASE("A factor in the header is refused without units, and reported with them", "[factor]") {
    for (const char* head : {"scale = 0.1",
                             "Scale: 10",
                             "ZFactor;0.1",
                             "ZFactor 0.1",
                             "Z-Factor: 10",
                             "Gain: 10",
                             "z gain = 10x",
                             "# vertical magnification 10x",
                             "Vertical magnification: 10",
                             "magnification: 10",
                             "vertical exaggeration: 5",
                             "# Vertical exaggeration x5",
                             "# scale 1:10",
                             "Scale: 1:10",
                             "HeightScale=0.001",
                             "amplification: 100",
                             "Skalierungsfaktor: 10",
                             "Faktor z: 0,1",
                             "\xC3\x9C\x62\x65rh\xC3\xB6hung: 10",
                             "Verst\xC3\xA4rkung;20",
                             "facteur: 10",
                             "Echelle z: 0.1",
                             "factor de escala: 10",
                             "# heights multiplied by 10",
                             "# all heights are 10 times",
                             "# exaggerated 10x vertically",
                             "vertical scale: 50 %",
                             "# 10x vertical scale",
                             "Data gain: 2",
                             "V-Mag: 20",
                             "z scale 0,1"}) {
        CAPTURE(head);
        const std::string line = std::string(head) + "\n";
        CHECK(has(refusal(profile(line + "x [um];z [um]")), "not whether the heights are to be multiplied"));
        CHECK(has(refusal(triples(line + "x [um];y [um];z [um]")), "not whether the heights are to be multiplied"));
        CHECK(
            has(refusal(matrix(sizes + "# Value units: um\n" + line)), "not whether the heights are to be multiplied"));
        CHECK(warnings(profile(line + "x [um];z [um]"), {.units = "um"}) == 1);
        CHECK(warnings(triples(line + "x [um];y [um];z [um]"), {.units = "um"}) == 1);
    }
    for (const char* head :
         {"Scale: 1", "Gain: 1.0", "scale 1:1", "Integral gain: 0.4", "Lens magnification: 50", "Objective: 20x",
          "x scale: 10", "Horizontal magnification: 10", "Scale bar: 10 um", "Gain: 20 dB", "Gain: auto",
          "# sampled 10 times per second", "Full scale: 5 V", "Correction factor: 1.02", "Grayscale: 16"}) {
        CAPTURE(head);
        CHECK(refusal(profile(std::string(head) + "\nx [um];z [um]")).empty());
        CHECK(warnings(profile(std::string(head) + "\nx [um];z [um]")) == 0);
    }
}

}  // namespace height_sense_test
