// SPDX-License-Identifier: BSD-3-Clause
// Contacts and tabulated laws, evaluated on whole arrays without the GIL.
#include "module.hpp"

#include "actions/one_contact.hpp"

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/resolved_joint.hpp>
#include <fstiff/asperity/conductance.hpp>
#include <fstiff/asperity/material.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>
#include <fstiff/double/integrals.hpp>
#include <fstiff/peaks/peak_heights.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/law_after.hpp>
#include <fstiff/tabulated/slip_motion.hpp>

#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace fstiff {

template <>
inline constexpr auto enum_names<OutsideRange> = detail::name_list<OutsideRange>({{OutsideRange::refuse, "refuse"},
                                                                                  {OutsideRange::clamp, "clamp"},
                                                                                  {OutsideRange::exact, "exact"},
                                                                                  {OutsideRange::extrapolate,
                                                                                   "extrapolate"}});

}  // namespace fstiff

namespace fstiff::python {
namespace {

using actions::OneContact;
using TabulatedLaw = ContactLaw<double>;
using ArrayIn = Eigen::Map<const Eigen::ArrayXd>;
using ArrayOut = Eigen::Map<Eigen::ArrayXd>;

/// A quantity by the key that run has for it.
struct Output {
    const char* key;
    const char* quantity;  ///< as output.quantities of a scene calls it; null: always there
    Quantity needs;
    Estimate<double> ContactState<double>::*estimate;
    double Estimate<double>::*number;
};

using State = ContactState<double>;
constexpr auto value = &Estimate<double>::value;
constexpr std::array<Output, 7> outputs{
    {{"pressure_Pa", nullptr, Quantity::pressure, &State::pressure, value},
     {"separation_m", "separation", Quantity::separation, &State::separation, value},
     {"stiffness_Pa_per_m", "stiffness", Quantity::stiffness, &State::stiffness, value},
     {"stiffness_error_Pa_per_m", "stiffness", Quantity::stiffness, &State::stiffness, &Estimate<double>::error},
     {"loading_stiffness_Pa_per_m", "loading_stiffness", Quantity::loading_stiffness, &State::loading_stiffness, value},
     {"real_area_fraction", "real_area", Quantity::real_area_fraction, &State::real_area_fraction, value},
     {"contacts_per_m2", "contacts", Quantity::contact_density, &State::contact_density, value}}};

std::vector<std::string> quantities_of(const OneContact& contact) {
    std::vector<std::string> names;
    for (const Output& output : outputs)
        if (output.quantity && detail::has(contact.law->quantities, output.needs) &&
            (names.empty() || names.back() != output.quantity))
            names.emplace_back(output.quantity);
    return names;
}

/// The outputs that \p names ask for; none: all that the law gives.
std::vector<const Output*> chosen(const OneContact& contact, const std::optional<std::vector<std::string>>& names) {
    const std::vector<std::string> all = quantities_of(contact);
    if (names)
        for (const std::string& name : *names)
            if (std::find(all.begin(), all.end(), name) == all.end()) {
                std::vector<std::string_view> allowed(all.begin(), all.end());
                throw domain_error("quantities = \"" + name + "\": of law " + std::string(contact.law->name) +
                                   " must be among " + document::list_of(allowed));
            }
    const std::vector<std::string>& wanted = names ? *names : all;
    std::vector<const Output*> found;
    for (const Output& output : outputs)
        if (!output.quantity || std::find(wanted.begin(), wanted.end(), output.quantity) != wanted.end())
            found.push_back(&output);
    return found;
}

/// Columns by their keys, and why a point has none.
using Evaluated = std::pair<nb::dict, nb::dict>;

/// The states of \p contact at \p x, which are what \p at takes.
template <auto at>
Evaluated states(const OneContact& contact, const In& x, const std::optional<std::vector<std::string>>& names) {
    const auto wanted = chosen(contact, names);
    Quantity quantities = Quantity::pressure | Quantity::separation;
    std::vector<NewArray> columns;
    for (const Output* output : wanted) {
        quantities = quantities | output->needs;
        columns.emplace_back(x);
    }
    std::map<std::size_t, std::string> reasons;
    {
        const nb::gil_scoped_release free;
        const ProgressHook interrupted = until_interrupted();
        constexpr std::size_t part = 1024;
        const std::span<const double> all = numbers_of(x);
        for (std::size_t begin = 0; begin < all.size(); begin += part) {
            interrupted("points", begin, all.size());
            const auto points =
                (contact.contact.get()->*at)(all.subspan(begin, std::min(part, all.size() - begin)), quantities);
            for (std::size_t i = 0; i < points.size(); ++i) {
                const ContactPoint<double>& point = points[i];
                if (!point.ok())
                    reasons[begin + i] = point.status == PointStatus::out_of_reach
                                             ? point.reason
                                             : "a result is beyond the range of numbers";
                for (std::size_t k = 0; k < wanted.size(); ++k)
                    columns[k].data()[begin + i] = point.ok() ? point.state.*wanted[k]->estimate.*wanted[k]->number
                                                              : std::numeric_limits<double>::quiet_NaN();
            }
        }
    }
    nb::dict results, why;
    for (std::size_t k = 0; k < wanted.size(); ++k) results[wanted[k]->key] = columns[k].take();
    for (const auto& [index, reason] : reasons) why[nb::int_(index)] = reason;
    return {results, why};
}

/// The joint of numbers by their names; its face is \p measured where that is given.
Joint joint_of(const Numbers& numbers, const std::string& interaction,
               const surface::MeasuredSurface* measured = nullptr) {
    Joint joint;
    joint.upper.elastic.poisson_ratio = std::numeric_limits<double>::quiet_NaN();  // not known
    take_numbers(joint, numbers), take_numbers(joint.face, numbers), take_numbers(joint.upper, numbers);
    const auto length = numbers.find("interaction_length");
    joint.interaction = {from_name<InteractionReading>(interaction, "interaction"),
                         length == numbers.end() ? 0 : length->second};
    if (measured) joint.face.measured = fstiff::measured_face(measured->found);
    return joint;
}

/// \p heights are those of the peaks [m], or their skewness and kurtosis where \p moments is true; empty: Gaussian.
OneContact of_numbers(const std::string& law, const Numbers& numbers, const std::string& interaction,
                      const surface::MeasuredSurface* measured, const std::vector<double>& heights, bool moments) {
    const nb::gil_scoped_release free;
    Joint joint = joint_of(numbers, interaction, measured);
    if (!heights.empty()) {
        if (law != "greenwood_williamson")
            throw domain_error("peak_heights: are for greenwood_williamson, not for " + law);
        joint.face.peak_heights = std::make_shared<const PeakHeights<double>>(
            moments ? PeakHeights<double>::of_moments(heights[0], heights[1])
                    : PeakHeights<double>::measured(heights, joint.face.rms_height.value_or(0)));
    }
    return actions::make_contact(law, std::move(joint), until_interrupted());
}

/// Arrays of the caller that are filled; none: new ones.
using Filled = std::vector<nb::ndarray<double, nb::c_contig, nb::device::cpu>>;

/// \p call(in, out...) on whole arrays without the GIL. Returns the new arrays.
template <std::size_t count, class Call>
std::vector<Out> batch(const In& x, const Filled& filled, const Call& call) {
    if (!filled.empty() && filled.size() != count)
        throw domain_error("out: must be " + std::to_string(count) + " arrays");
    std::vector<NewArray> made;
    for (std::size_t i = 0; filled.empty() && i < count; ++i) made.emplace_back(x);
    const auto size = static_cast<Eigen::Index>(x.size());
    {
        const nb::gil_scoped_release free;
        const auto out = [&](std::size_t i) {
            return ArrayOut(made.empty() ? filled[i].data() : made[i].data(), size);
        };
        if constexpr (count == 1)
            call(ArrayIn(x.data(), size), out(0));
        else
            call(ArrayIn(x.data(), size), out(0), out(1));
    }
    std::vector<Out> taken;
    for (NewArray& array : made) taken.push_back(array.take());
    return taken;
}

/// \p call of the law at every number.
template <double (TabulatedLaw::*call)(double) const>
std::vector<Out> each(const TabulatedLaw& law, const In& x, const Filled& filled) {
    return batch<1>(x, filled, [&](const ArrayIn& in, ArrayOut out) {
        for (Eigen::Index i = 0; i < in.size(); ++i) out[i] = (law.*call)(in[i]);
    });
}

using Friction = TangentialLaw<double>;

/// Pieces on \p threads threads.
ParallelHook on_threads(std::size_t threads) {
    if (threads < 2) return {};
    return [threads](std::size_t count, const std::function<void(std::size_t)>& run) {
        std::vector<std::jthread> running;
        for (std::size_t t = 0; t < threads; ++t)
            running.emplace_back([&, t] {
                for (std::size_t i = t; i < count; i += threads) run(i);
            });
    };
}

using Slip = SlipState<double, 2>;

void add_slip(nb::module_& m) {
    using Kept = std::pair<double, std::vector<std::array<double, 3>>>;
    nb::class_<Slip>(m, "Slip", "What a path of friction leaves; see fstiff.Law.path.")
        .def("__init__", [](Slip* slip, double separation) { new (slip) Slip{.separation = separation}; })
        .def("__getstate__",
             [](const Slip& slip) {
                 Kept kept{slip.separation, {}};
                 for (const Slip::Node& node : std::span(slip.nodes).first(static_cast<std::size_t>(slip.count)))
                     kept.second.push_back({node.level, node.drag[0], node.drag[1]});
                 return kept;
             })
        .def("__setstate__", [](Slip* slip, const Kept& kept) {
            if (kept.second.size() > Slip::capacity) throw domain_error("a slip of too many levels");
            new (slip) Slip{.separation = kept.first};
            for (const auto& [level, x, y] : kept.second)
                slip->nodes[static_cast<std::size_t>(slip->count++)] = {level, {x, y}};
        });
}

/// The answer of one joint, as far as its laws need it.
Answer answer_of(const std::map<std::string, In>& points, const std::map<std::string, double>& facts) {
    const auto at = [&](const char* key, std::size_t i) { return points.at(key).data()[i]; };
    const auto known = [](double x) { return std::isnan(x) ? std::nullopt : std::optional(x); };
    Answer answer;
    answer.rms_height = facts.at("rms_height");
    answer.relative_hardness = known(facts.at("relative_hardness"));
    answer.flows = answer.relative_hardness.has_value();
    answer.greatest_pressure = known(facts.at("greatest_pressure"));
    for (std::size_t i = 0; i < points.at("pressure").size(); ++i) {
        if (std::isnan(at("value", i))) continue;
        AnswerPoint& point = answer.points.emplace_back();
        point.pressure = at("pressure", i), point.stiffness = {at("low", i), at("value", i), at("high", i)};
        point.loading_stiffness = known(at("loading", i));
        point.state.separation.value = at("separation", i);
    }
    return answer;
}

/// Laws of an answer: after each of \p greatest, of the first loading for 0 alone, and of its K where there is none.
std::vector<TabulatedLaw> laws_of_answer(const std::map<std::string, In>& points,
                                         const std::map<std::string, double>& facts,
                                         const std::vector<double>& greatest, double quantile, double min_pressure,
                                         double max_pressure, const std::string& outside) {
    const Answer answer = answer_of(points, facts);
    const LawRange<double> range{min_pressure, max_pressure, from_name<OutsideRange>(outside, "outside")};
    const nb::gil_scoped_release free;
    if (greatest.empty()) return {answer.law_at(quantile, range)};
    if (greatest.front() == 0) return {answer.loading_law(quantile, range)};
    return answer.law_after(greatest, quantile, range);
}

/// The laws of \p contact after each of \p greatest.
std::vector<TabulatedLaw> laws_after(const OneContact& contact, const std::vector<double>& greatest,
                                     double min_pressure, double max_pressure, const std::string& outside) {
    const LawRange<double> range{min_pressure, max_pressure, from_name<OutsideRange>(outside, "outside")};
    if (range.outside == OutsideRange::exact)
        detail::refuse("outside", "exact", "another policy for the law after a load");
    const nb::gil_scoped_release free;
    const TabulatedLaw loading = contact.contact->tabulate(range);
    const double hardness = detail::relative_hardness(*contact.problem).value_or(0);
    std::vector<TabulatedLaw> laws;
    for (const double p : greatest) laws.push_back(law_after(loading, p, hardness));
    return laws;
}

/// One law for all contacts, or one for each.
using Laws = std::vector<const TabulatedLaw*>;

/// \p call of the law of each contact, whose numbers are a row of \p x.
template <std::size_t count, class Call>
std::vector<Out> rows(const Laws& laws, const In& x, const Call& call) {
    std::vector<NewArray> made;
    for (std::size_t i = 0; i < count; ++i) made.emplace_back(x);
    {
        const nb::gil_scoped_release free;
        const std::size_t size = laws.empty() ? 0 : x.size() / laws.size();
        for (std::size_t c = 0; c < laws.size(); ++c)
            for (std::size_t i = c * size; i < (c + 1) * size; ++i) {
                const std::array<double, count> found = call(*laws[c], x.data()[i]);
                for (std::size_t k = 0; k < count; ++k) made[k].data()[i] = found[k];
            }
    }
    std::vector<Out> taken;
    for (NewArray& array : made) taken.push_back(array.take());
    return taken;
}

/// Friction of each contact of \p laws.
std::vector<Friction> frictions_of(const Laws& laws, const In& friction, const In& ratio) {
    const auto of = [](const In& numbers, std::size_t c) { return numbers.data()[numbers.size() == 1 ? 0 : c]; };
    const std::size_t count = std::max({laws.size(), friction.size(), ratio.size()});
    std::vector<Friction> made;
    for (std::size_t c = 0; c < count; ++c)
        made.emplace_back(*laws[laws.size() == 1 ? 0 : c], of(friction, c), of(ratio, c));
    return made;
}

/// Two numbers of what \p call of the law with friction gives at every separation and slip, arrays of one shape whose
/// rows are the contacts.
template <auto call, auto first, auto second>
std::vector<Out> slipped(const Laws& laws, const In& friction, const In& ratio, const In& separations,
                         const In& slips) {
    NewArray one(separations), other(separations);
    {
        const nb::gil_scoped_release free;
        const std::vector<Friction> with = frictions_of(laws, friction, ratio);
        const std::size_t size = separations.size() / with.size();
        for (std::size_t i = 0; i < separations.size(); ++i) {
            const auto at = (with[i / size].*call)(separations.data()[i], slips.data()[i]);
            one.data()[i] = at.*first, other.data()[i] = at.*second;
        }
    }
    return {one.take(), other.take()};
}

/// p, q, their tangents, and their derivatives by the directions of \p motion_by, of each step of \p contacts; the
/// slips go with them, and the energy that each stores in the end.
nb::tuple moved(const Laws& laws, const In& friction, const In& ratio, std::size_t contacts, std::vector<Slip> slips,
                const In& separations, const In& steps_by, const In& motion_by, std::size_t directions,
                std::size_t threads) {
    const std::size_t count = separations.size(), steps = contacts > 0 ? count / contacts : 0;
    SlipResponses<double> found;
    std::vector<double> energies;
    {
        const nb::gil_scoped_release free;
        const std::vector<Friction> with = frictions_of(laws, friction, ratio);
        std::vector<const Friction*> all;
        for (const Friction& one : with) all.push_back(&one);
        slip_responses<double>(all,
                               {.contacts = contacts,
                                .steps = steps,
                                .separations = numbers_of(separations),
                                .slips = numbers_of(steps_by),
                                .motion_by = numbers_of(motion_by),
                                .directions = directions,
                                .states = slips},
                               found, on_threads(threads));
        for (std::size_t c = 0; c < contacts; ++c)
            energies.push_back(with[with.size() == 1 ? 0 : c].stored_energy(slips[c]));
    }
    return nb::make_tuple(taken(std::move(found.pressures), {count}), taken(std::move(found.tractions), {count, 2}),
                          taken(std::move(found.tangents), {count, 3, 3}),
                          taken(std::move(found.responses_by), {count, 3, directions}),
                          taken(std::move(energies), {contacts}), slips);
}

void add_laws(nb::module_& m) {
    nb::class_<TabulatedLaw>(m, "Law", "A tabulated law; see fstiff.Law.")
        .def_static(
            "from_text", [](std::string_view text) { return TabulatedLaw::from_text(text); }, nb::arg("text"))
        .def_static("of_answer", &laws_of_answer)
        .def("to_text", &TabulatedLaw::to_text)
        .def("stiffness",
             [](const TabulatedLaw& law, const In& p, const Filled& out) {
                 return batch<1>(p, out, [&](const ArrayIn& in, ArrayOut k) { law.stiffness(in, k); });
             })
        .def("separation", &each<&TabulatedLaw::separation>)
        .def("stiffness_slope", &each<&TabulatedLaw::stiffness_slope>)
        .def("at_separation",
             [](const TabulatedLaw& law, const In& d, const Filled& out) {
                 return batch<2>(
                     d, out, [&](const ArrayIn& in, ArrayOut to, ArrayOut with) { law.at_separation(in, to, with); });
             })
        .def("tangent_at_separation",
             [](const TabulatedLaw& law, const In& d, const Filled& out) {
                 return batch<2>(d, out, [&](const ArrayIn& in, ArrayOut to, ArrayOut with) {
                     law.tangent_at_separation(in, to, with);
                 });
             })
        .def("energy", &each<&TabulatedLaw::energy>)
        .def_prop_ro("touch", &TabulatedLaw::touch)
        .def_prop_ro("pressures",
                     [](const TabulatedLaw& law) { return std::pair(law.pressures()[0], law.pressures()[1]); })
        .def_prop_ro("separations",
                     [](const TabulatedLaw& law) { return std::pair(law.separations()[0], law.separations()[1]); })
        .def_prop_ro("relative_error", &TabulatedLaw::relative_error)
        .def_prop_ro("stiffness_is_slope", &TabulatedLaw::stiffness_is_slope)
        .def_prop_ro("outside", [](const TabulatedLaw& law) { return std::string(name_of(law.outside())); });
    m.def("law_rows", [](const Laws& laws, const std::string& what, const In& x) {
        const auto one = [&](double (TabulatedLaw::*call)(double) const) {
            return rows<1>(laws, x, [call](const TabulatedLaw& law, double at) { return std::array{(law.*call)(at)}; });
        };
        if (what == "stiffness") return one(&TabulatedLaw::stiffness);
        if (what == "separation") return one(&TabulatedLaw::separation);
        if (what == "energy") return one(&TabulatedLaw::energy);
        return rows<2>(laws, x, [](const TabulatedLaw& law, double d) {
            const auto [p, slope] = law.tangent_at_separation(d);
            return std::array{p, slope};
        });
    });
    m.def("first_slip",
          &slipped<&Friction::first_slip, &Friction::FirstSlip::traction, &Friction::FirstSlip::stiffness>);
    m.def("slip_cycle", &slipped<&Friction::cycle, &Friction::Cycle::lost, &Friction::Cycle::loss_factor>);
    m.def("slip_paths", &moved);
}

}  // namespace

void add_contacts(nb::module_& m) {
    add_slip(m);
    add_laws(m);
    nb::class_<OneContact>(m, "Contact", "A contact; see fstiff.Contact.")
        .def_static("of_numbers", &of_numbers, nb::arg("law"), nb::arg("numbers"), nb::arg("interaction"),
                    nb::arg("measured").none(), nb::arg("heights"), nb::arg("moments"))
        .def("at_pressures", &states<&AnyContact::at_pressures>)
        .def("at_separations", &states<&AnyContact::at_separations>)
        .def(
            "tabulate",
            [](const OneContact& contact, double min_pressure, double max_pressure, const std::string& outside) {
                return contact.contact->tabulate({.min_pressure = min_pressure,
                                                  .max_pressure = max_pressure,
                                                  .outside = from_name<OutsideRange>(outside, "outside")});
            },
            nb::arg("min_pressure"), nb::arg("max_pressure"), nb::arg("outside"), nb::keep_alive<0, 1>(),
            nb::call_guard<nb::gil_scoped_release>())
        .def("laws_after", &laws_after)
        .def_prop_ro("quantities", &quantities_of)
        .def_prop_ro("law", [](const OneContact& contact) { return std::string(contact.law->name); })
        .def_prop_ro("nature", [](const OneContact& contact) { return std::string(contact.law->nature); });
    m.def(
        "sensitivity",
        [](const std::string& law, const Numbers& numbers, const std::string& interaction, double pressure) {
            const nb::gil_scoped_release free;
            return actions::sensitivity_of(law, joint_of(numbers, interaction), pressure);
        },
        nb::arg("law"), nb::arg("numbers"), nb::arg("interaction"), nb::arg("pressure"));
    const auto of_bodies = [&m](const char* name, auto call) {
        m.def(
            name,
            [call](double modulus, double poisson, double modulus2, double poisson2) {
                return call(Material<double>{modulus, poisson}, Material<double>{modulus2, poisson2});
            },
            nb::arg("youngs_modulus"), nb::arg("poisson_ratio"), nb::arg("youngs_modulus2"), nb::arg("poisson_ratio2"));
    };
    of_bodies("effective_modulus", [](const auto& one, const auto& other) { return effective_modulus(one, other); });
    of_bodies("tangential_ratio", [](const auto& one, const auto& other) { return tangential_ratio(one, other); });
    m.def(
        "spot_conductance",
        [](const In& stiffness, double conductivity, double modulus) {
            NewArray all(stiffness);
            for (std::size_t i = 0; i < stiffness.size(); ++i)
                all.data()[i] = spot_conductance(stiffness.data()[i], conductivity, modulus);
            return all.take();
        },
        nb::arg("stiffness"), nb::arg("conductivity"), nb::arg("effective_modulus"));
    m.def("law_names", [] {
        std::vector<std::string> names;
        for (const std::string_view name : detail::law_names()) names.emplace_back(name);
        return names;
    });
}

}  // namespace fstiff::python
