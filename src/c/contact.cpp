// SPDX-License-Identifier: BSD-3-Clause
// Contacts of joints and of scenes, and their points.
#include "c/contact.hpp"
#include "c/joint.hpp"

#include <fstiff/answer.hpp>
#include <fstiff/answer/laws.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace fstiff::c {
namespace {

/// An array of the caller, and what goes into it.
struct Output {
    double* array;
    const char* name;
    Quantity quantity;
    Estimate<double> ContactState<double>::*estimate;
    double Estimate<double>::*number;
};

std::array<Output, 7> outputs_of(const fstiff_points& points) {
    using State = ContactState<double>;
    constexpr auto value = &Estimate<double>::value;
    return {
        {{points.pressure, "pressure", Quantity::pressure, &State::pressure, value},
         {points.separation, "separation", Quantity::separation, &State::separation, value},
         {points.stiffness, "stiffness", Quantity::stiffness, &State::stiffness, value},
         {points.stiffness_error, "stiffness_error", Quantity::stiffness, &State::stiffness, &Estimate<double>::error},
         {points.loading_stiffness, "loading_stiffness", Quantity::loading_stiffness, &State::loading_stiffness, value},
         {points.real_area_fraction, "real_area_fraction", Quantity::real_area_fraction, &State::real_area_fraction,
          value},
         {points.contact_density, "contact_density", Quantity::contact_density, &State::contact_density, value}}};
}

int status_of(const ContactPoint<double>& point) {
    if (point.ok()) return FSTIFF_OK;
    set_message(point.status == PointStatus::out_of_reach ? point.reason : "a result is beyond the range of double");
    return point.status == PointStatus::out_of_reach ? FSTIFF_OUT_OF_REACH : FSTIFF_OUT_OF_NUMBERS;
}

/// Evaluates \p x, \p part points at a time: a part with a number that is refused is computed point by point.
template <class Call>
int evaluate(const fstiff_contact* contact, const double* x, std::size_t count, const fstiff_points* points,
             const char* name, const Call& call) {
    not_null(contact, "contact");
    require_array(x, count, name);
    const fstiff_points wanted_points = taken(points, "points");
    const auto outputs = outputs_of(wanted_points);
    Quantity wanted = Quantity::pressure | Quantity::separation;
    for (const Output& output : outputs) {
        if (!output.array) continue;
        if (!detail::has(contact->law->quantities, output.quantity))
            throw domain_error("law " + std::string(contact->law->name) + ": gives no " + output.name);
        wanted = wanted | output.quantity;
    }
    int first = FSTIFF_OK;
    std::string message;
    const auto put = [&](std::size_t i, int status, const ContactState<double>& state) {
        for (const Output& output : outputs)
            if (output.array) output.array[i] = status == FSTIFF_OK ? state.*output.estimate.*output.number : 0;
        if (wanted_points.status) wanted_points.status[i] = status;
        if (status != FSTIFF_OK && first == FSTIFF_OK) first = status, message = fstiff_last_message();
    };
    constexpr std::size_t part = 64;
    std::array<double, part> numbers;  // the results may be written where the arguments were
    for (std::size_t begin = 0; begin < count; begin += part) {
        const std::size_t length = std::min(part, count - begin);
        std::copy_n(x + begin, length, numbers.begin());
        std::vector<ContactPoint<double>> computed;
        try {
            computed = call(std::span<const double>(numbers.data(), length), wanted);
        } catch (const domain_error&) {
        }
        for (std::size_t i = 0; i < length; ++i) {
            try {
                const auto point = computed.size() == length
                                       ? computed[i]
                                       : call(std::span<const double>(&numbers[i], 1), wanted).front();
                put(begin + i, status_of(point), point.state);
            } catch (const domain_error&) {
                put(begin + i, status_of_exception(), {});
            }
        }
    }
    if (first != FSTIFF_OK) set_message(message);
    return first;
}

}  // namespace
}  // namespace fstiff::c

using namespace fstiff::c;

int fstiff_contact_make(const char* law, const fstiff_joint* joint, fstiff_contact** made) {
    return made_by(made, [&] {
        const fstiff::ChosenLaw& chosen = fstiff::actions::law_called(&not_null(law, "law"));
        const fstiff::Joint assembly = joint_of(taken(joint, "joint"), false);
        return new fstiff_contact{{.law = &chosen.row(), .contact = contact_of(assembly, chosen)}};
    });
}

int fstiff_contact_of_scene(const char* text, size_t length, const char* name, size_t law, size_t peaks,
                            fstiff_contact** made) {
    return made_by(made, [&] {
        not_null(text, "text");
        return new fstiff_contact{fstiff::actions::make_contact(
            fstiff::scene::read_scene(std::string(text, length), {.name = name ? name : "scene"}), law, peaks)};
    });
}

void fstiff_contact_free(fstiff_contact* contact) { delete contact; }

int fstiff_contact_at_pressures(const fstiff_contact* contact, const double* pressures, size_t count,
                                const fstiff_points* points) {
    return guarded([&] {
        return evaluate(contact, pressures, count, points, "pressures", [&](auto some, fstiff::Quantity wanted) {
            return contact->contact->at_pressures(some, wanted);
        });
    });
}

int fstiff_contact_at_separations(const fstiff_contact* contact, const double* separations, size_t count,
                                  const fstiff_points* points) {
    return guarded([&] {
        return evaluate(contact, separations, count, points, "separations", [&](auto some, fstiff::Quantity wanted) {
            return contact->contact->at_separations(some, wanted);
        });
    });
}
