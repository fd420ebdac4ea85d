// SPDX-License-Identifier: BSD-3-Clause
// The answer of a joint of numbers, as a loop over a design calls it, next to one point of its contact.
#include "row.hpp"

#include <fstiff/answer_inline.hpp>
#include <fstiff/asperity/named_materials.hpp>

namespace {

using namespace bench;
using fstiff::AnswerOptions, fstiff::Joint;

constexpr double pressure = 10e6;
constexpr std::size_t joint_count = 8;

/// Ground steel of one of so many heights.
Joint joint(std::size_t i) {
    const fstiff::Body steel = body_of(*fstiff::find_material("steel"));
    return {.face = {.rms_height = 0.8e-6 + 0.05e-6 * static_cast<double>(i), .rms_gradient = 0.1},
            .upper = steel,
            .lower = steel};
}

/// Its contact with the hardness that the answer assumes.
std::shared_ptr<const fstiff::AnyContact> contact(std::size_t i) {
    Joint of = joint(i);
    of.upper.hardness = of.lower.hardness = of.upper.hardness_range->middle;
    return contact_of(of, fstiff::laws::plastic);
}

double stiffness_of(const fstiff::AnyContact& contact) {
    return contact.at_pressures(std::span(&pressure, 1), fstiff::Quantity::stiffness).front().state.stiffness.value;
}

/// \p call(i) is K of joint i; the counter is its time over that of one point of a contact that was made before.
template <class Call>
void answer_row(const std::string& what, const Call& call) {
    verified_row(
        "answer/numbers/" + what, 1e-12,
        [=] {
            AccuracyCollector collector;
            for (std::size_t i = 0; i < joint_count; ++i) collector.add(call(i), stiffness_of(*contact(i)));
            return collector.accuracy();
        },
        [=](benchmark::State& state) {
            std::vector<std::shared_ptr<const fstiff::AnyContact>> contacts;
            for (std::size_t i = 0; i < joint_count; ++i) contacts.push_back(contact(i));
            time_elements(state, joint_count, call);
            state.counters["over_contact"] =
                median_time(joint_count, call) /
                median_time(joint_count, [&](std::size_t i) { return stiffness_of(*contacts[i]); });
        });
}

const Rows rows_of_answer([] {
    answer_row("contact", [](std::size_t i) { return stiffness_of(*contact(i)); });
    answer_row("stiffness", [](std::size_t i) {
        return answer(joint(i), pressure, {.quantities = {"stiffness"}, .samples = 0}).stiffness.value;
    });
    answer_row("approach", [](std::size_t i) { return answer(joint(i), pressure, {.samples = 0}).stiffness.value; });
    answer_row("band", [](std::size_t i) { return answer(joint(i), pressure).stiffness.value; });
});

}  // namespace
