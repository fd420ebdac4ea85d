// SPDX-License-Identifier: BSD-3-Clause
// Maps of many kinds, for the second table of docs/validation.md, as CSV.
//
//     fstiff_maps truth FIRST LAST                    K by boundary elements for seeds FIRST to LAST of every kind
//     fstiff_maps laws bench/map_truth.csv [EVERY]    K of laws over it; EVERY: one map of so many, to check a file
//     fstiff_maps list                                KIND;GROUP of every kind, those of docs/accuracy.md too
//     fstiff_maps one KIND SEED SIZE P_STAR...        K by boundary elements of one map; SIZE 4: 1,024 points a side
//     fstiff_maps flowed KIND SEED HARDNESS SHARE...  the same for unloading, HARDNESS H/(E g) and SHARE p/H
//     fstiff_maps file KIND SEED SIZE FILE.gsf        the map, with steps of 0.5 um
#include "support/map_kinds.hpp"

#include <fstiff/contact/crossover.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/halfspace/boundary_elements.hpp>
#include <fstiff/measure/height_shape.hpp>
#include <fstiff/measure/pooled_surface.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/gaussian_order.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace {

struct Laws {
    explicit Laws(const fstiff::HeightMap<double>& map)
        : summits(fstiff::summits_of(map)),
          persson(fstiff::map_spectrum(map, edges), 1.0),
          mutual(summits, 1.0, edges),
          hybrid(of_map(map, summits)),
          numbers(fstiff::hybrid_of_band(fstiff::detail::band_of_moments(moments(map), 0.8), 1.0)),
          rms_height(fstiff::rms_height(map)) {}

    static constexpr fstiff::Edges edges = fstiff::Edges::periodic;
    using Hybrid = fstiff::HybridContact<double, fstiff::SummitContact<double>, fstiff::Crossover<double>>;

    static Hybrid of_map(const fstiff::HeightMap<double>& map, const fstiff::Summits<double>& summits) {
        const auto order = fstiff::detail::gaussian_order(map);
        const fstiff::MaterialRatioContact<double> crowded(
            fstiff::PerssonContact<double>(fstiff::map_spectrum(order.map, edges), 1.0), order.curve, order.rms_height);
        return {fstiff::SummitContact<double>(summits, 1.0), crowded,
                fstiff::detail::hand_over_of(summits, crowded, edges)};
    }
    /// m0, m2, m4 of all waves of the map.
    static fstiff::SpectralMoments<double> moments(const fstiff::HeightMap<double>& map) {
        fstiff::SpectralMoments<double> m;
        for (const auto& shell : fstiff::map_spectrum(map, edges).shells) {
            const double q = shell.q2_h2 / shell.q_h2;
            m.m0 += shell.q2_h2 / (q * q);
            m.m2 += shell.q2_h2 / 2;
            m.m4 += 3 * q * q * shell.q2_h2 / 8;
        }
        return m;
    }

    fstiff::Summits<double> summits;
    fstiff::PerssonContact<double> persson;
    fstiff::detail::MutualSummits<double> mutual;
    Hybrid hybrid;
    fstiff::HybridContact<double, fstiff::detail::BandHills<double>> numbers;
    double rms_height;
};

/// What hybrid makes of statistics alone.
class Statistics {
public:
    Statistics(const fstiff::HeightMap<double>& map, bool across) {
        const fstiff::SpectralMoments<double> m = Laws::moments(map);
        const double unit = 1 / std::sqrt(m.m0);
        const std::span<const double> heights(map.heights.data(), static_cast<std::size_t>(map.size()));
        const auto of = fstiff::height_statistics(map);
        const auto shape = fstiff::detail::counted_shape(of.skewness.value, of.kurtosis.value, 1.0);
        add("numbers, skewness and kurtosis", m, fstiff::detail::bearing_of_moments(shape.skewness, shape.kurtosis));
        add("numbers, Sk to Smr2", m,
            fstiff::detail::bearing_of_core(fstiff::detail::material_ratio(heights)).scaled(unit));
        add("numbers, bearing curve", m, fstiff::MaterialRatioSlope<double>::of_heights(heights).scaled(unit));
        for (const Eigen::Index rows : {1, 4, 16}) of_rows(map, across, rows);
    }
    template <class Use>
    void each(const Use& use) const {
        for (const auto& [name, law] : gaussian_) use(name, [&law = law](double p) { return law.stiffness(p); });
        for (const auto& [name, law] : laws_) use(name, [&law = law](double p) { return law.stiffness(p); });
    }

private:
    using Gaussian = fstiff::HybridContact<double, fstiff::detail::BandHills<double>>;

    static fstiff::BandSpectrum<double> band(fstiff::SpectralMoments<double> m) {
        m.m4 = std::max(m.m4, 1.51 * m.m2 * m.m2 / m.m0);
        return fstiff::detail::band_of_moments(m, 0.8);
    }
    void add(const std::string& name, const fstiff::SpectralMoments<double>& m,
             const fstiff::MaterialRatioSlope<double>& curve) {
        laws_.emplace(name, fstiff::hybrid_of_band(band(m), curve, 1.0));
    }
    /// \p count rows of \p map, or columns across a lay, as traces of one surface: by their moments, and by shape too.
    void of_rows(const fstiff::HeightMap<double>& map, bool across, Eigen::Index count) {
        std::vector<fstiff::HeightStatistics<double>> all;
        fstiff::detail::ShapeOfHeights<double> shape;
        for (Eigen::Index k = 0; k < count; ++k) {
            const Eigen::Index at = k * map.rows() / count;
            const Eigen::ArrayXd z = across ? Eigen::ArrayXd(map.heights.col(at)) : Eigen::ArrayXd(map.heights.row(at));
            const fstiff::Profile<double> row{std::vector<double>(z.begin(), z.end()), map.dx};
            all.push_back(fstiff::height_statistics(row));
            shape.add(row, fstiff::autocorrelation(row));
        }
        const auto of = fstiff::pooled(all, std::vector<double>(all.size(), 1.0));
        const std::string name = std::to_string(count) + (count == 1 ? " row" : " rows");
        gaussian_.emplace(name, fstiff::hybrid_of_band(band(of.moments), 1.0));
        const auto counted = fstiff::detail::counted_shape(of, shape.share());
        if (!counted.is_gaussian())
            add(name + ", shape", of.moments, fstiff::detail::bearing_of_moments(counted.skewness, counted.kurtosis));
        else
            gaussian_.emplace(name + ", shape", gaussian_.at(name));
    }

    std::map<std::string, Gaussian> gaussian_;
    std::map<std::string, fstiff::ScaledContact<double, Gaussian>> laws_;
};

/// K over \p truth, or none of a law that refuses the pressure.
template <class Law>
void print(const std::string& law, const std::string& where, double pressure, double truth, const Law& stiffness) {
    try {
        std::printf("%s,%s,%.4f\n", law.c_str(), where.c_str(), stiffness(pressure) / truth);
    } catch (const fstiff::domain_error&) {  // too crowded for it
    }
}

/// K of one map by boundary elements, as lines of CSV; with the hardness \p hardness over E g where it is not 0.
void solve(const test::MapKind& kind, std::uint64_t seed, const std::vector<double>& p_stars, double hardness = 0) {
    const fstiff::HeightMap<double> map = kind.map(seed);
    fstiff::BoundaryElementOptions<double> options;
    options.edges = fstiff::Edges::periodic;
    options.hardness = 0.1 * hardness;
    fstiff::BoundaryElements<double> solver(map, 1.0, options);
    for (const double p_star : p_stars) {
        const auto found = solver.at_pressure(0.1 * p_star);
        std::printf("\"%s\",%d,%g,%.5g,%.4g\n", kind.name.c_str(), static_cast<int>(seed), p_star, found.stiffness,
                    found.contact_fraction);
        std::fflush(stdout);
    }
}

void solve(std::uint64_t first, std::uint64_t last) {
    std::printf("kind,seed,p_star,K,area\n");
    for (const test::MapKind& kind : test::map_kinds())
        for (std::uint64_t seed = first; seed <= last; ++seed) solve(kind, seed, {0.001, 0.003, 0.01, 0.03, 0.1, 0.25});
}

/// Writes a map as Gwyddion simple field, with steps of 0.5 um, or its truth to the standard output. \returns the exit
/// code.
int one_map(int count, char** argument) {
    const std::string name = argument[2];
    const std::string mode = argument[1];
    const int size = mode == "flowed" ? 1 : std::atoi(argument[4]);
    std::vector<test::MapKind> kinds = test::map_kinds(size);
    for (test::MapKind& kind : test::more_map_kinds(size)) kinds.push_back(std::move(kind));
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.name == name; });
    if (kind == kinds.end()) return 1;
    const auto seed = static_cast<std::uint64_t>(std::atol(argument[3]));
    if (mode != "file") {
        const double hardness = mode == "flowed" ? std::atof(argument[4]) : 0;
        std::vector<double> p_stars;
        for (int k = 5; k < count; ++k) p_stars.push_back((hardness > 0 ? hardness : 1) * std::atof(argument[k]));
        solve(*kind, seed, p_stars, hardness);
        return 0;
    }
    const fstiff::HeightMap<double> map = kind->map(seed);
    std::ofstream file(argument[5], std::ios::binary);
    file << test::simple_field(map, 0.5e-6 * static_cast<double>(map.columns()));
    return file ? 0 : 1;
}

void list() {
    for (const bool more : {false, true})
        for (const auto& kind : more ? test::more_map_kinds() : test::map_kinds())
            std::printf("%s;%s\n", kind.name.c_str(), kind.group.c_str());
}

/// \returns the exit code.
int compare_laws(const char* truths, long every) {
    std::ifstream file(truths);
    std::string line;
    if (!std::getline(file, line)) return 1;
    const std::vector<test::MapKind> kinds = test::map_kinds();
    std::string last;
    std::unique_ptr<Laws> laws;
    std::unique_ptr<Statistics> statistics;
    std::printf("law,kind,group,seed,p_star,ratio\n");
    for (long map = -1; std::getline(file, line);) {
        const auto end = line.find('"', 1);
        const std::string name = line.substr(1, end - 1);
        std::istringstream rest(line.substr(end + 2));
        double seed, p_star, truth;
        char comma;
        rest >> seed >> comma >> p_star >> comma >> truth;
        const std::string key = line.substr(0, end + 2) + std::to_string(static_cast<int>(seed));
        const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.name == name; });
        if (kind == kinds.end()) return 1;
        if (key != last) {
            last = key;
            ++map;
            if (map % every == 0) {
                const auto heights = kind->map(static_cast<std::uint64_t>(seed));
                laws = std::make_unique<Laws>(heights);
                statistics = std::make_unique<Statistics>(heights, kind->group == "machined");
            }
        }
        if (map % every != 0) continue;
        std::ostringstream where;
        where << '"' << name << "\",\"" << kind->group << "\"," << seed << ',' << p_star;
        const double p = 0.1 * p_star;
        print("hybrid", where.str(), p, truth, [&](double x) { return laws->hybrid.stiffness(x); });
        print("summits", where.str(), p, truth,
              [&](double x) { return laws->mutual.at_pressure(x, fstiff::Quantity::stiffness).stiffness.value; });
        print("persson", where.str(), p, truth, [&](double x) { return laws->persson.stiffness(x); });
        print("hybrid of numbers", where.str(), p, truth, [&](double x) { return laws->numbers.stiffness(x); });
        print("p/(0.48 rms height)", where.str(), p, truth, [&](double x) { return x / (0.48 * laws->rms_height); });
        statistics->each([&](const std::string& law, const auto& stiffness) {
            print("\"" + law + "\"", where.str(), p, truth, stiffness);
        });
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace

int main(int arguments, char** argument) {
    const std::string mode = arguments > 2 ? argument[1] : "";
    if (mode == "laws") return compare_laws(argument[2], arguments > 3 ? std::atol(argument[3]) : 1);
    if (arguments == 2 && std::string(argument[1]) == "list") return list(), 0;
    if ((mode == "one" || mode == "flowed" || mode == "file") && arguments > 5) return one_map(arguments, argument);
    if (mode != "truth" || arguments != 4) return 2;
    solve(static_cast<std::uint64_t>(std::atol(argument[2])), static_cast<std::uint64_t>(std::atol(argument[3])));
}
