// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace plu_test {

using namespace fstiff;
using test::contains;
using test::little;
using test::put;

namespace {

const test::FormReader read{io::SurfaceFormat::plu};
const test::RefusalOf refusal(read);

}  // namespace

TEST_CASE("A map of Sensofar is float32 in micrometres, and is known by its date and counts") {
    const std::string whole = test::sample("plu/map.plu");
    CHECK(read(put(whole, 489, little(3, 1))).record.said("other layers") == "2, not read");
    CHECK_FALSE(read.begins(whole.substr(0, 499)));
    CHECK_FALSE(read.begins(std::string(600, '\0')));
    CHECK_FALSE(read.begins(put(whole, 388, little(0, 4))));
}

TEST_CASE("Files of Sensofar that cannot be meant are refused with field, value and range") {
    const std::string whole = test::sample("plu/map.plu");
    CHECK(contains(refusal("nothing"), "ends within its header"));
    CHECK(contains(refusal(put(whole, 0, "\1")), "does not begin as a file of Sensofar"));
    CHECK(contains(refusal(put(whole, 428, little(1, 4))), "type of the measurement = 1: must be 3"));
    CHECK(contains(refusal(put(whole, 489, little(0, 1))), "layers = 0: must be at least 1"));
    CHECK(contains(refusal(put(whole, 504, little(-1, 4))), "declares 4294967295 x 3 heights of 4 bytes"));
    CHECK(contains(refusal(put(whole, 500, little(0, 4))), "4 x 0: must be at least 2 x 1"));
    CHECK(contains(refusal(put(whole, 404, little(0.0F))), "step of x = 0"));
    CHECK(contains(refusal(put(whole, 408, little(-1.0F))), "step of y = -1"));
    CHECK(std::isnan(read(put(whole, 508, little(-INFINITY))).map.at(0, 0)));
}

}  // namespace plu_test
