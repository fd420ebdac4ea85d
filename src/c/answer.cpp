// SPDX-License-Identifier: BSD-3-Clause
// The answer of a joint.
#include "c/joint.hpp"
#include "c/law.hpp"
#include "scene/scene.hpp"

#include <fstiff/answer.hpp>
#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/resolve.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace fstiff::c {
namespace {

static_assert(FSTIFF_CAUSES == detail::cause_count);
static_assert(FSTIFF_CAUSE_LAY == static_cast<int>(Cause::lay) && FSTIFF_CAUSE_FORM == static_cast<int>(Cause::form));

/// The numbers that go into the arrays of \p to, where they are not NULL; NaN: none.
struct Output {
    double* array;
    std::function<double(const AnswerPoint& point)> value;
};
std::vector<Output> outputs_of(const fstiff_answer_points& to) {
    using Point = const AnswerPoint&;
    std::vector<Output> outputs{{to.stiffness, [](Point point) { return point.stiffness.value; }},
                                {to.stiffness_p05, [](Point point) { return point.stiffness.low; }},
                                {to.stiffness_p95, [](Point point) { return point.stiffness.high; }},
                                {to.loading_stiffness, [](Point point) { return point.loading_stiffness.value_or(0); }},
                                {to.tangential_stiffness, [](Point point) { return point["tangential_stiffness"]; }},
                                {to.approach, [](Point point) { return point["approach"]; }},
                                {to.contacts, [](Point point) { return point.contacts.value_or(0); }},
                                {to.p_star, [](Point point) { return point.p_star.value_or(0); }}};
    for (std::size_t i = 0; i < to.key_count; ++i) {
        (void)not_null(to.keys, "keys"), (void)not_null(to.numbers, "numbers");
        (void)not_null(to.keys[i], "keys"), (void)not_null(to.numbers[i], "numbers");
        outputs.push_back({to.numbers[i], scene::number_called(to.keys[i], "keys")});
    }
    std::erase_if(outputs, [](const Output& output) { return !output.array; });
    return outputs;
}

/// Gives \p points to the arrays of \p to. \return the status of the first without a K, whose reason is the message.
int give_points(const std::vector<AnswerPoint>& points, const fstiff_answer_points& to) {
    int first = FSTIFF_OK;
    const std::vector<Output> outputs = outputs_of(to);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const AnswerPoint& point = points[i];
        for (const Output& output : outputs) {
            const double value = point.ok() ? output.value(point) : 0;
            output.array[i] = std::isnan(value) ? 0 : value;
        }
        if (to.causes) {
            const auto shares = shares_of(point.causes);
            std::copy(shares.begin(), shares.end(), to.causes + i * FSTIFF_CAUSES);
        }
        if (to.law) to.law[i] = static_cast<int>(point.law);
        const int status = point.ok() ? FSTIFF_OK : FSTIFF_OUT_OF_REACH;
        if (to.status) to.status[i] = status;
        if (status != FSTIFF_OK && first == FSTIFF_OK) first = status, set_message(point.reason);
    }
    return first;
}

/// With all quantities where \p whole, else K and those that are known with it.
Answer answer_of(const fstiff_joint* joint, const double* pressures, std::size_t count, bool whole) {
    const fstiff_joint from = taken(joint, "joint");
    require_array(pressures, count, "pressures");
    if (from.samples < -1) refuse_argument("samples", from.samples, "-1, 0, or from 20 to 100000");
    AnswerOptions options;
    if (!whole) options.quantities = {"stiffness", "loading_stiffness", "tangential_stiffness"};
    if (from.samples != 0) options.samples = from.samples < 0 ? 0 : from.samples;
    if (from.seed != 0) options.seed = from.seed;
    if (from.seating != 0) options.seating = from.seating;
    return answer(joint_of(from, true), std::span(pressures, count), options);
}

/// The law that \p make has of the answer of \p from between two pressures, 0: the ends of \p pressures.
template <class Make>
fstiff_law* law_of(const fstiff_joint* from, const double* pressures, size_t count, double min_pressure,
                   double max_pressure, int outside, const Make& make) {
    const OutsideRange policy = outside_of(outside);
    const Answer answer = answer_of(from, pressures, count, false);
    const auto [least, greatest] = std::minmax_element(pressures, pressures + count);
    return new fstiff_law{make(answer, LawRange<double>{.min_pressure = min_pressure == 0 ? *least : min_pressure,
                                                        .max_pressure = max_pressure == 0 ? *greatest : max_pressure,
                                                        .outside = policy})};
}

}  // namespace
}  // namespace fstiff::c

using namespace fstiff::c;

int fstiff_answer(const fstiff_joint* joint, const double* pressures, size_t count, const fstiff_answer_points* points,
                  int* doubtful) {
    return guarded([&] {
        const fstiff_answer_points to = taken(points, "points");
        (void)outputs_of(to);  // before what takes long
        const bool whole = to.approach || to.key_count > 0;
        const fstiff::Answer answer = answer_of(joint, pressures, count, whole);
        if (doubtful) *doubtful = answer.doubtful ? 1 : 0;
        std::string units;
        for (const auto& check : answer.concerns)
            if (const std::string sentence = fstiff::detail::sentence_of_unit(check); !sentence.empty())
                units += (units.empty() ? "" : "\n") + sentence;
        set_message(units);
        return give_points(answer.points, to);
    });
}

int fstiff_answer_law(const fstiff_joint* joint, const double* pressures, size_t count, double quantile,
                      double min_pressure, double max_pressure, int outside, fstiff_law** made) {
    return made_by(made, [&] {
        return law_of(joint, pressures, count, min_pressure, max_pressure, outside,
                      [&](const fstiff::Answer& answer, const fstiff::LawRange<double>& range) {
                          return answer.law_at(quantile, range);
                      });
    });
}

int fstiff_answer_law_after(const fstiff_joint* joint, const double* pressures, size_t count, double quantile,
                            double greatest_pressure, double min_pressure, double max_pressure, int outside,
                            fstiff_law** made) {
    return made_by(made, [&] {
        return law_of(joint, pressures, count, min_pressure, max_pressure, outside,
                      [&](const fstiff::Answer& answer, const fstiff::LawRange<double>& range) {
                          return greatest_pressure == 0 ? answer.loading_law(quantile, range)
                                                        : answer.law_after(greatest_pressure, quantile, range);
                      });
    });
}

const char* fstiff_law_name(int law) {
    constexpr int count = static_cast<int>(fstiff::enum_names<fstiff::LawKind>.size());
    return law >= 0 && law < count ? name_of(static_cast<fstiff::LawKind>(law)).data() : "unknown law";
}

const char* fstiff_cause_name(int cause) {
    return cause >= 0 && cause < FSTIFF_CAUSES ? name_of(static_cast<fstiff::Cause>(cause)).data() : "unknown cause";
}
