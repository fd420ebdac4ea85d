// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace plux_test {

using namespace fstiff;
using test::contains;

namespace {

const test::FormReader read{io::SurfaceFormat::plux};

/// The sample with \p to for \p from in index.xml.
std::string with(const std::string& from, const std::string& to) {
    const std::string whole = test::sample("plux/map.plux");
    const std::string heights = whole.substr(whole.find("LAYER_0.raw", whole.find("</xml>")) + 11, 48);
    const std::size_t begin = whole.find("<xml>"), size = whole.find("</xml>") + 6 - begin;
    return test::stored_archive(
        {{"index.xml", test::replaced(whole.substr(begin, size), from, to)}, {"LAYER_0.raw", heights}});
}
std::string refusal(const std::string& from, const std::string& to) {
    return test::refusal([&] { (void)read(with(from, to)); });
}

}  // namespace

TEST_CASE("A map of an archive of Sensofar is float32 in micrometres in the file that its index names") {
    const std::string whole = test::sample("plux/map.plux");
    CHECK(contains(read(whole).record.said("form"), "from \"LAYER_0.raw\", measured 10 March 2023 16:35:59"));
    CHECK(read(with("<INFO><ITEM_0><NAME>Device</NAME><VALUE>S neox</VALUE></ITEM_0></INFO>",
                    "<LAYER_1><FILENAME_Z>1</FILENAME_Z></LAYER_1>"))
              .record.said("other layers") == "1, not read");
}

TEST_CASE("Archives of Sensofar that cannot be meant are refused with element, value and range") {
    CHECK(contains(refusal("IMAGE_SIZE_X>4", "IMAGE_SIZE_X>x"), "IMAGE_SIZE_X"));
    CHECK(contains(refusal("IMAGE_SIZE_X>4", "IMAGE_SIZE_X>5"), "has 48 bytes; must have 4 for each of 5 x 3 points"));
    CHECK(contains(refusal("IMAGE_SIZE_Y>3", "IMAGE_SIZE_Y>0"), "IMAGE_SIZE_Y = 0: must be a whole number from 1"));
    CHECK(contains(refusal("FOV_X>0.5", "FOV_X>0.0"), "FOV_X = 0: must be finite and greater than 0"));
    CHECK(contains(refusal("FOV_Y>0.25", "FOV_Y>-1"), "FOV_Y = -"));
    CHECK(contains(refusal("<FOV_Y>0.25</FOV_Y>", ""), "has no GENERAL/FOV_Y"));
    CHECK(contains(refusal(">LAYER_0.raw<", ">LAYER_9.raw<"), "LAYER_0/FILENAME_Z = \"LAYER_9.raw\""));
    CHECK(contains(test::refusal([] { (void)read(test::stored_archive({{"z", "z"}})); }), "holds no index.xml"));
    CHECK(contains(refusal("<FILENAME_Z>LAYER_0.raw</FILENAME_Z>", "<FILENAME_C>LAYER_0.raw</FILENAME_C>"),
                   "has no LAYER_0 with a FILENAME_Z"));
    CHECK(contains(refusal("</xml>", "</xm>"), "index.xml is not valid XML"));
}

}  // namespace plux_test
