// SPDX-License-Identifier: BSD-3-Clause
// Makes what use.cpp takes, compiled with other flags for the processor.
#include "made.hpp"

fstiff::ContactLaw<double> make_law() {
    const fstiff::Roughness<double> surface{.rms_height = 0.8e-6, .peak_radius = 40e-6, .peak_density = 500e6};
    const fstiff::RoughContact contact(surface, fstiff::PeakDistribution<double>(0.5, 1.0), fstiff::HertzLaw<double>{},
                                       112.6e9);
    return fstiff::ContactLaw<double>::tabulate(contact, {.min_pressure = 1e5, .max_pressure = 1e8});
}

fstiff::SummitContact<double> make_summits() {
    fstiff::Summits<double> map{.summits = {}, .area = 1e-6, .width = 1e-3, .height = 1e-3, .rms_height = 0.8e-6};
    for (int i = 0; i < 500; ++i) map.summits.push_back({1e-6 - i * 1e-9, 1e5, 1e5, 0, 0});
    return {map, 112.6e9};
}
