// SPDX-License-Identifier: BSD-3-Clause
// The answer of height, gradient, skewness and kurtosis where peaks flow against boundary elements: of maps
// (bench/answer_truth.csv) and of faces as processes leave them (tests/data/plastic_faces.csv by
// tests/contact/make_plastic_faces.py). Neither the law nor its errors for a known shape were set on them.
#include "support/answer_truth.hpp"
#include "support/library.hpp"
#include "support/map_kinds.hpp"
#include "support/table.hpp"

#include <array>
#include <map>
#include <span>

namespace plastic_numbers_test {

constexpr double modulus = 205e9 / (2 * (1 - 0.3 * 0.3)), side = 128e-6;

/// Rms height, skewness and kurtosis.
std::array<double, 3> shape_of(const fstiff::HeightMap<double>& map) {
    const Eigen::ArrayXXd z = map.heights.array() - map.heights.mean();
    const double rms = std::sqrt(z.square().mean());
    return {rms, z.cube().mean() / std::pow(rms, 3), z.square().square().mean() / std::pow(rms, 4)};
}

/// How many bands hold K, and the mean square of ln K over the truth.
struct Coverage {
    int inside = 0, all = 0;
    double square = 0;

    /// Of a face of the rms height \p rms [m] and the gradient 0.1, whose K is \p truth(p/H) [Pa/m]; \p hardness is
    /// H/(E g).
    template <class Truth>
    void add(double rms, double skewness, double kurtosis, double hardness, std::span<const double> shares,
             const Truth& truth) {
        std::ostringstream scene;
        scene << "[surface]\nrms_height = \"" << rms << " m\"\nrms_gradient = 0.1\nskewness = " << skewness
              << "\nkurtosis = " << kurtosis
              << "\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\nhardness = \""
              << hardness * 0.1 * modulus << " Pa\"\n[contact]\npressures = [";
        for (const double share : shares) scene << '"' << share * hardness * 0.1 * modulus << " Pa\",";
        scene << "]\n";
        const auto results = test::results_of(scene.str());
        REQUIRE(results.answer.points.size() == shares.size());
        for (std::size_t i = 0; i < shares.size(); ++i) {
            const double K = truth(shares[i]);
            const auto& found = results.answer.points[i].stiffness;
            inside += found.low <= K && K <= found.high;
            square += std::pow(std::log(found.value / K), 2);
            ++all;
        }
    }
    [[nodiscard]] double rms() const { return std::sqrt(square / all); }
};

TEST_CASE("The band of height, gradient, skewness and kurtosis holds K of boundary elements where peaks flow") {
    const auto truth = test::answer_truths();
    std::vector<test::MapKind> kinds = test::map_kinds();
    for (test::MapKind& kind : test::more_map_kinds()) kinds.push_back(std::move(kind));
    Coverage found;
    for (const auto& [name, seed] : {std::pair("skewness -0.5", 30),
                                     {"skewness 0.5", 10},
                                     {"kurtosis 5", 10},
                                     {"worn", 30},
                                     {"honed", 10},
                                     {"patchy", 30}}) {
        const std::string start = std::string(name) + ',' + std::to_string(seed) + ",1,";
        const auto kind =
            std::find_if(kinds.begin(), kinds.end(), [&, n = name](const auto& one) { return one.name == n; });
        REQUIRE(kind != kinds.end());
        const auto [rms, skewness, kurtosis] = shape_of(kind->map(static_cast<std::uint64_t>(seed)));
        for (const double hardness : {0.02, 0.1, 0.5})
            found.add(rms * side, skewness, kurtosis, hardness, std::array{0.003, 0.01, 0.03, 0.1, 0.3, 0.6, 0.9},
                      [&](double share) {
                          std::ostringstream key;
                          key << start << hardness << ',' << share;
                          return truth.at(key.str()) * modulus / side;
                      });
    }
    CAPTURE(found.inside, found.all, found.rms());
    CHECK(found.inside > 0.97 * found.all);
    CHECK(found.rms() < 0.2);
}

TEST_CASE("The same of faces as processes leave them") {
    const test::Table table("plastic_faces.csv");
    constexpr std::size_t loads = 4;
    constexpr double rms = 0.5e-6;
    Coverage found;
    int refused = 0;
    for (std::size_t row = 0; row < table.size(); row += loads) {
        const double skewness = table.input(row, "skewness"), hardness = table.input(row, "hardness_over_Eg");
        if (skewness > 3) {  // nests of grains: the answer refuses it
            refused += loads;
            continue;
        }
        std::array<double, loads> shares{};
        for (std::size_t i = 0; i < loads; ++i) shares[i] = table.input(row + i, "p_over_H");
        found.add(rms, skewness, table.input(row, "kurtosis"), hardness, shares, [&](double share) {
            const auto i = static_cast<std::size_t>(std::find(shares.begin(), shares.end(), share) - shares.begin());
            return table.input(row + i, "stiffness_sigma_over_Eg") * 0.1 * modulus / rms;
        });
    }
    CAPTURE(found.inside, found.all, refused, found.rms());
    CHECK(found.all + refused == 384);
    CHECK(std::round(100.0 * found.inside / (found.all + refused)) == 92);  // docs/accuracy.md
    CHECK(found.rms() < 0.27);
}

}  // namespace plastic_numbers_test
