// SPDX-License-Identifier: BSD-3-Clause
// Depths and factors of heights in titles and headers. Truth: the numbers of the text, with the sign that is meant.
#include "support/texts.hpp"

namespace height_sense_test {

using namespace fstiff;
using namespace test;
using io::SurfaceOptions;

namespace {

const std::string sizes = "# Width: 5 um\n# Height: 4 um\n", um = "# Value units: um\n";

/// A profile, triples and a matrix below \p head. The title of their heights is \p z.
std::string section(const std::string& z, const std::string& head = "") {
    return head + "x [um];" + z + "\n" + rows("{x};{z}\n");
}
std::string points(const std::string& z, const std::string& head = "") {
    return head + "x [um];y [um];" + z + "\n" + triples("{i};{j};{z}\n");
}
std::string area(const std::string& head) { return sizes + head + matrix("\t"); }

const Decision as_profile = profile(0.5e-6, 1e-6);
const Decision turned_profile = profile(0.5e-6, -1e-6, {}, {""}), turned_map = map(1e-6, 1e-6, -1e-6, {}, {""});

std::size_t warnings(const std::string& text, const SurfaceOptions& options) {
    return read_text(text, options).record.warnings.size();
}

}  // namespace

TEST_CASE("A column of depths gives heights of the other sign, with a warning", "[sense]") {
    for (const std::string title : {"depth [um]",
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
        check_texts({{title, section(title), turned_profile},
                     {title, points(title), turned_map},
                     {title, "x [um]\t" + title + "\n" + rows("{x}\t{z}\n"), turned_profile}});
    }
    const std::string blanks = rows("{x} {z}\n");
    const Decision reported =
        map(1e-6, 1e-6, -1e-6, {},
            {"the heights are the numbers with the other sign, by line 1, which states \"depth [um]\""});
    check_texts({
        {"blanks", "x [um]  measured depth [um]\n" + blanks, turned_profile},
        {"blanks, triples", "x [um] y [um] measured depth [um]\n" + triples("{i} {j} {z}\n"), turned_map},
        {"units below", "x;Tiefe\n[um];[um]\n" + rows("{x};{z}\n"), turned_profile},
        {"one column", "depth [um]\n" + rows("{z}\n"), turned_profile, {.spacing = 0.5e-6}},
        {"unit given", "x;depth\n" + rows("{x};{z}\n"), turned_profile, {.units = "um"}},
        {"unit given, triples", "x,y,depth\n" + triples("{i},{j},{z}\n"), turned_map, {.units = "um"}},
        {"reported", points("depth [um]"), reported},
    });
}

TEST_CASE("A column of heights keeps its sign, whatever other columns and words are there", "[sense]") {
    for (const std::string title :
         {"z [um]", "Height [um]", "H\xC3\xB6he [um]", "z minus plane [um]", "Deep learning z [um]", "profile [um]",
          "Base height [um]", "[um]", "Height above depth gauge [um]"})
        check_text({title, section(title), as_profile});
    check_text({"a section through a wall", "depth [um];z [um]\n" + rows("{x};{z}\n"), as_profile});
    for (const std::string head :
         {"# Depth: 5 um", "# Measuring depth: 100 um", "# Bit depth: 16", "# depth of focus 3 um", "# Depth profile",
          "# inverted: no", "# inverted = 0", "# inverted: false", "# x inverted: yes", "# colormap inverted: yes",
          "# heights are not inverted", "# Direction: down", "# inverted microscope", "# sign: positive"})
        check_text({head, section("z [um]", head + "\n"), as_profile});
    check_text({"matrix", area("# Channel: Topography\n# Depth: 5 um\n" + um), map(1e-6, 1e-6, 1e-6)});
}

TEST_CASE("A header that inverts the heights, or calls them depths, is followed with a warning", "[sense]") {
    for (const std::string head :
         {"# inverted: yes", "inverted=true", "Inverted;1", "# Z inverted: on", "# invertiert: ja",
          "# heights inverted: yes", "# Heights are inverted", "# z axis: downwards", "# positive z: down",
          "# sign of z: -1", "# data: inverted", "# polarity: inverted", "# z inverted", "# z flipped: yes",
          "# invers\xC3\xA9: oui"}) {
        check_texts({{head, section("z [um]", head + "\n"), turned_profile},
                     {head, points("z [um]", head + "\n"), turned_map},
                     {head, area(um + head + "\n"), turned_map}});
    }
    for (const std::string head : {"# Channel: Depth", "# Quantity: depth", "# Depth unit: um", "# Depth map",
                                   "Tiefe [um]", "# depth in um", "# Kanal: Tiefe", "# Depth"})
        check_text({head, area(head + "\n"), turned_map, {.units = "um"}});
    check_texts({
        {"twice", section("depth [um]", "# inverted: yes\n"), refused("turns its heights over twice")},
        {"perhaps", section("z [um]", "# z inverted: perhaps\n"), refused("must be \"yes\" or \"no\"")},
    });
}

TEST_CASE("A factor in a title is refused without units, and reported with them", "[factor]") {
    const Decision unknown = refused("which is not understood");
    for (const std::string title : {"z/10 [um]",
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
        check_texts({{title, section(title), unknown},
                     {title, points(title), unknown},
                     {title, section(title, "# Z unit: um\n"), unknown}});
        CHECK(warnings(section(title), {.units = "um"}) >= 1);
        CHECK(warnings(points(title), {.units = "um,nm"}) >= 1);
    }
    check_texts({
        {"blanks", "x [um] z x 10 [um]\n" + rows("{x} {z}\n"), unknown},
        {"units below", "x;z/10\n[um];[um]\n" + rows("{x};{z}\n"), unknown},
        {"positions", "x*10 [um];z [um]\n" + rows("{x};{z}\n"), refused("for the positions")},
        {"one column", "z/10 [um]\n" + rows("{z}\n"), unknown, {.spacing = 1e-6}},
    });
}

TEST_CASE("A number of a channel or a profile in a title is no factor", "[factor]") {
    for (const std::string title : {"z2 [um]", "z 2 [um]", "Profile 2 [um]", "Trace-2 [um]", "Profil 1/3 [um]",
                                    "z1 [um]", "H\xC3\xB6he (Kanal 2) [um]", "2nd trace [um]", "z (3 x 3 median) [um]",
                                    "z (10 nm)", "z [10 nm]", "z [x10 nm]", "z*1 [um]", "z 12:30 [um]"})
        check_text({title, section(title), contains(title, "(10 nm)") ? refused("") : Decision()});
    for (const std::string titles : {"Profile X 2 [um];Profile Z 2 [um]", "x 2 [um];z 2 [um]", "x10 [um];z10 [um]"})
        check_text({titles, titles + "\n" + rows("{x};{z}\n"), as_profile});
}

TEST_CASE("A factor in the header is refused without units, and reported with them", "[factor]") {
    const Decision unknown = refused("not whether the heights are to be multiplied");
    for (const std::string head : {"scale = 0.1",
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
        const std::string in_profile = section("z [um]", head + "\n"), in_points = points("z [um]", head + "\n");
        check_texts({{head, in_profile, unknown},
                     {head, in_points, unknown},
                     {head, area(um + head + "\n"), unknown},
                     {head, in_profile, profile(0.5e-6, 1e-6, {}, {""}), {.units = "um"}},
                     {head, in_points, map(1e-6, 1e-6, 1e-6, {}, {""}), {.units = "um"}}});
    }
    for (const std::string head :
         {"Scale: 1", "Gain: 1.0", "scale 1:1", "Integral gain: 0.4", "Lens magnification: 50", "Objective: 20x",
          "x scale: 10", "Horizontal magnification: 10", "Scale bar: 10 um", "Gain: 20 dB", "Gain: auto",
          "# sampled 10 times per second", "Full scale: 5 V", "Correction factor: 1.02", "Grayscale: 16"})
        check_text({head, section("z [um]", head + "\n"), as_profile});
}

}  // namespace height_sense_test
