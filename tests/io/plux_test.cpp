// SPDX-License-Identifier: BSD-3-Clause
// Archives whose files are stored may be changed in place, with the check sum of the file that was changed.
#include "io/plux.hpp"

#include "support/samples.hpp"

namespace plux_test {

using namespace fstiff;
using test::contains;
using test::little;
using test::put;

namespace {

io::Reading read(const std::string& bytes) { return io::read_plux(bytes, "file.plux"); }

std::int64_t check_sum(const std::string& bytes) {
    std::uint32_t sum = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xEDB88320U : 0);
    }
    return sum ^ 0xFFFFFFFFU;
}
/// The sample with \p to for \p from in index.xml, both as long as each other.
std::string with(const std::string& from, const std::string& to) {
    const std::string whole = test::sample("plux/map.plux");
    const std::size_t begin = whole.find("<xml>"), size = whole.find("</xml>") + 6 - begin;
    const std::string index = whole.substr(begin, size), changed = test::replaced(index, from, to);
    REQUIRE(changed.size() == index.size());
    std::string bytes = put(whole, begin, changed);
    const std::string sum = little(check_sum(index), 4);
    for (std::size_t at = bytes.find(sum); at != std::string::npos; at = bytes.find(sum))
        bytes = put(bytes, at, little(check_sum(changed), 4));
    return bytes;
}
std::string refusal(const std::string& from, const std::string& to) {
    return test::refusal([&] { (void)read(with(from, to)); });
}

}  // namespace

TEST_CASE("A map of an archive of Sensofar is float32 in micrometres in the file that its index names") {
    const std::string whole = test::sample("plux/map.plux");
    test::check_sample(read(whole), 0.5e-6, 0.25e-6, 1e-6, true);
    test::check_known(whole, io::SurfaceFormat::plux);
    test::check_cut(whole, read);
    CHECK(contains(read(whole).record.said("form"), "from \"LAYER_0.raw\", measured 10 March 2023 16:35:59"));
    CHECK(read(with("<INFO><ITEM_0><NAME>Device</NAME><VALUE>S neox</VALUE></ITEM_0></INFO>",
                    "<LAYER_1><FILENAME_Z>1</FILENAME_Z></LAYER_1>                         "))
              .record.said("other layers") == "1, not read");
}

TEST_CASE("Archives of Sensofar that cannot be meant are refused with element, value and range") {
    CHECK(contains(refusal("IMAGE_SIZE_X>4", "IMAGE_SIZE_X>x"), "IMAGE_SIZE_X"));
    CHECK(contains(refusal("IMAGE_SIZE_X>4", "IMAGE_SIZE_X>5"), "has 48 bytes; must have 4 for each of 5 x 3 points"));
    CHECK(contains(refusal("IMAGE_SIZE_Y>3", "IMAGE_SIZE_Y>0"), "IMAGE_SIZE_Y = 0: must be a whole number from 1"));
    CHECK(contains(refusal("FOV_X>0.5", "FOV_X>0.0"), "FOV_X = 0: must be finite and greater than 0"));
    CHECK(contains(refusal("FOV_Y>0.25", "FOV_Y>-1e0"), "FOV_Y = "));
    CHECK(contains(refusal("<FOV_Y>0.25</FOV_Y>", "<F__Y>0.25</F__Y>  "), "has no GENERAL/FOV_Y"));
    CHECK(contains(refusal(">LAYER_0.raw<", ">LAYER_9.raw<"), "LAYER_0/FILENAME_Z = \"LAYER_9.raw\""));
    CHECK(contains(refusal("<FILENAME_Z>LAYER_0.raw</FILENAME_Z>", "<FILENAME_C>LAYER_0.raw</FILENAME_C>"),
                   "has no LAYER_0 with a FILENAME_Z"));
    CHECK(contains(refusal("</xml>", "</xm> "), "index.xml is no XML"));
}

}  // namespace plux_test
