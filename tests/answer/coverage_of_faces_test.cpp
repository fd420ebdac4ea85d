// SPDX-License-Identifier: BSD-3-Clause
// The bands of answers from numbers and from short traces against boundary elements of faces that they were not set on
// (bench/face_truth.csv and face_traces.f32 by bench/make_faces.py).
#include <fstiff/answer/answer.hpp>
#include <fstiff/math/tukey.hpp>
#include <fstiff/measure/measure.hpp>

#include "support/catch.hpp"
#include "support/table.hpp"

#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace coverage_of_faces_test {

using namespace fstiff;

namespace {

constexpr double modulus = 1e11, side = 128e-6, gradient = 0.1;

/// One map, and K of boundary elements under each pressure.
struct TrueFace {
    std::string group;
    int seed = 0;
    double rms_height = 0, skewness = 0, kurtosis = 0;
    std::vector<double> pressures{}, stiffness{};
};

/// The maps that the bands were not set on.
std::vector<TrueFace> unseen_faces() {
    const test::Table table("../../bench/face_truth.csv");
    std::vector<TrueFace> faces;
    std::string last;
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table.text(i, "calibrated") == "1") continue;
        const std::string key = table.text(i, "kind") + table.text(i, "seed");
        if (key != last)
            faces.push_back({.group = table.text(i, "group"),
                             .seed = std::stoi(table.text(i, "seed")),
                             .rms_height = table.input(i, "rms_height"),
                             .skewness = table.input(i, "skewness"),
                             .kurtosis = table.input(i, "kurtosis")});
        last = key;
        faces.back().pressures.push_back(table.input(i, "p_star") * gradient * modulus);
        faces.back().stiffness.push_back(table.input(i, "K") * modulus / side);
    }
    return faces;
}

constexpr double never_yields = std::numeric_limits<double>::infinity();

/// Bands that hold the truth, by group, and the widths of all.
class Coverage {
public:
    void add(const TrueFace& of, const JointFace& face) {
        const Answer found =
            answer({.face = face, .upper = {.hardness = never_yields}, .effective_modulus = modulus}, of.pressures);
        for (std::size_t i = 0; i < of.pressures.size(); ++i) {
            if (!found.points[i].ok()) continue;
            const WithBand& band = found.points[i].stiffness;
            auto& [inside, all] = groups_[of.group];
            inside += band.low <= of.stiffness[i] && of.stiffness[i] <= band.high, ++all;
            widths_.push_back(band.high / band.low);
        }
    }
    void check(double share, double share_of_group, double width) {
        double inside = 0, all = 0;
        for (const auto& [group, counts] : groups_) {
            CAPTURE(group, counts.first, counts.second);
            CHECK(counts.first >= share_of_group * counts.second);
            inside += counts.first, all += counts.second;
        }
        const double middle = math::median(widths_);
        CAPTURE(inside, all, middle);
        CHECK(inside >= share * all);
        CHECK(middle <= width);
    }

private:
    std::map<std::string, std::pair<int, int>> groups_;
    std::vector<double> widths_;
};

}  // namespace

TEST_CASE("Bands from numbers hold K of faces that they were not set on") {
    Coverage shape, numbers, height;
    for (const TrueFace& of : unseen_faces()) {
        JointFace face{.rms_height = of.rms_height};
        height.add(of, face);
        face.rms_gradient = gradient;
        numbers.add(of, face);
        face.skewness = of.skewness, face.kurtosis = of.kurtosis;
        shape.add(of, face);
    }
    SECTION("height, gradient and shape") { shape.check(0.85, 0.75, 2.6); }
    // plateaus and worn tops, which the answer names as outside of its band, and uneven faces have 60 %
    // the width is that of the prior of an unknown process, whose skewness goes down to -2 for the sake of worn tops
    SECTION("height and gradient") { numbers.check(0.82, 0.6, 6.5); }
    SECTION("height alone") { height.check(0.88, 0.75, 10); }
}

TEST_CASE("Bands from traces of 256 points across the lay hold K of faces that they were not set on") {
    std::ifstream file(FSTIFF_TEST_DATA "/face_traces.f32", std::ios::binary);
    Coverage traces;
    for (const TrueFace& of : unseen_faces())
        for (int place = 0; place < 2; ++place) {
            std::vector<float> heights(256);
            REQUIRE(file.read(reinterpret_cast<char*>(heights.data()), 4 * 256));
            const Profile<double> trace{.heights = {heights.begin(), heights.end()}, .spacing = 0.5e-6};
            const auto measured = measured_face(measure(trace));
            traces.add(of, {.measured = measured});
        }
    traces.check(0.86, 0.62, 10);  // uneven faces have the least
}

}  // namespace coverage_of_faces_test
