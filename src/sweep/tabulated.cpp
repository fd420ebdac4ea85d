// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/tabulated.hpp"

#include <fstiff/contact/contact_law.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace fstiff::sweep {
namespace {

class Tabulated final : public scene::AnyContact {
public:
    Tabulated(ContactLaw<double> law, double rms_height) : law_(std::move(law)), rms_height_(rms_height) {}
    [[nodiscard]] std::vector<ContactPoint<double>> at_pressures(std::span<const double> pressures,
                                                                 Quantity) const override {
        std::vector<ContactPoint<double>> points;
        points.reserve(pressures.size());
        for (const double p : pressures) points.push_back(point(law_.separation(p), p, law_.stiffness(p)));
        return points;
    }
    [[nodiscard]] std::vector<ContactPoint<double>> at_separations(std::span<const double> separations,
                                                                   Quantity) const override {
        std::vector<ContactPoint<double>> points;
        points.reserve(separations.size());
        for (const double d : separations) {
            const auto at = law_.at_separation(d);
            points.push_back(point(d, at.pressure, at.stiffness));
        }
        return points;
    }

private:
    [[nodiscard]] ContactPoint<double> point(double separation, double pressure, double stiffness) const {
        ContactState<double> state;
        const double error = law_.relative_error();
        state.eta = separation / rms_height_;
        state.separation = {separation, error * rms_height_, 0};
        state.pressure = {pressure, error * pressure, 0};
        state.stiffness = {stiffness, error * stiffness, 0};
        return ContactPoint<double>::of(state);
    }

    ContactLaw<double> law_;
    double rms_height_;
};

}  // namespace

void tabulate(std::vector<scene::MadeContact>& contacts, const scene::Scene& scene, std::array<double, 2> range) {
    for (scene::MadeContact& made : contacts) {
        try {
            std::array<double, 2> pressures = range;
            if (scene.at_separations) {
                const auto ends = made.contact->at_separations(range, Quantity::pressure);
                if (!ends[0].ok() || !ends[1].ok()) continue;
                pressures = {ends[1].state.pressure.value, ends[0].state.pressure.value};
            }
            constexpr double room = 1e-3;  // so that no end falls out by rounding
            const LawRange<double> wider{pressures[0] * (1 - room), pressures[1] * (1 + room)};
            made.contact = std::make_unique<Tabulated>(made.contact->tabulate(wider),
                                                       scene.face.parameters.rms_height.value);
        } catch (const domain_error&) {  // no table of this law, or not so far: point by point
        }
    }
}

}  // namespace fstiff::sweep
