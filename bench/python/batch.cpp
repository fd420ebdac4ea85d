// SPDX-License-Identifier: BSD-3-Clause
// The C++ side of batch.py: the same law and the same contact, on the same pressures.
//
//     batch LAW PRESSURES OUT      doubles of the file PRESSURES; K of both goes to OUT, the least seconds to stdout
#include <fstiff/contact/contact_curve.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace fstiff;

std::string bytes_of(const char* file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The least CPU time of \p repetitions runs [s].
template <class Call>
double least_time(int repetitions, const Call& call) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < repetitions; ++i) {
        const std::clock_t begin = std::clock();
        call();
        least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    return least;
}

}  // namespace

int main(int, char** argv) {
    const auto law = ContactLaw<double>::from_text(bytes_of(argv[1]));
    const std::string raw = bytes_of(argv[2]);
    const auto count = static_cast<Eigen::Index>(raw.size() / sizeof(double));
    const Eigen::ArrayXd pressures =
        Eigen::Map<const Eigen::ArrayXd>(reinterpret_cast<const double*>(raw.data()), count);
    Eigen::ArrayXd of_law;
    const double law_time = least_time(30, [&] {
        Eigen::ArrayXd out(count);  // a batch makes its results
        law.stiffness(pressures, out);
        of_law = std::move(out);
    });
    const RoughContact hertz({0.832e-6, 40e-6, 500e6}, PeakDistribution<double>(0.5, 1.0), HertzLaw<double>{}, 112.6e9);
    const Eigen::Index some = count / 100;
    const std::vector<double> few(pressures.data(), pressures.data() + some);
    std::vector<ContactPoint<double>> points;
    const double contact_time = least_time(3, [&] {
        points = curve_at_pressures(hertz, few, Quantity::separation | Quantity::pressure | Quantity::stiffness);
    });
    std::ofstream out(argv[3], std::ios::binary);
    out.write(reinterpret_cast<const char*>(of_law.data()), static_cast<std::streamsize>(raw.size()));
    for (const auto& point : points)
        out.write(reinterpret_cast<const char*>(&point.state.stiffness.value), sizeof(double));
    std::printf("%.9g %.9g\n", law_time, contact_time);
}
