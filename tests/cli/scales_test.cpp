// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure --scales as a process. tests/scene/scales_test.cpp has its numbers.
#include "command.hpp"

namespace scales_test {

TEST_CASE("the table of --scales, its CSV and its picture are of one file") {
    const test::Folder folder;
    const auto map =
        folder.write("map.txt", test::run_fstiff("generate map --points 128 --spacing '1 um' --hurst 0.8 --rms '1 um' "
                                                 "--shortest '6 um' --longest '60 um'")
                                    .out);
    const auto csv = test::run_fstiff("measure " + map + " --scales --format csv");
    CHECK(csv.status % 4 == 0);
    CHECK(test::lines(csv.out).front() ==
          "lambda_s_m,lambda_c_m,rms_height_m,rms_gradient,peak_radius_m,peak_density_per_m2,fractal_dimension,"
          "stiffness_Pa_per_"
          "m");
    CHECK(test::contains(test::run_fstiff("measure " + map + " --scales --format table").out, "settled to 10 %"));
    CHECK(test::run_fstiff("measure " + map + " " + map + " --scales").status == 2);
    CHECK(test::run_fstiff("measure " + map + " --scales --pressure 10").status == 3);
    CHECK(test::run_fstiff("measure " + map + " --scales --modulus '0 GPa'").status == 3);
    // without --scales they are checked too
    test::check_refused("measure " + map + " --modulus /", 3, {"--modulus = \"/\""});
    test::check_refused("measure " + map + " --pressure a,b", 3, {"--pressure = \"a,b\""});
}

}  // namespace scales_test
