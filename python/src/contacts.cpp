// SPDX-License-Identifier: BSD-3-Clause
// Contacts and tabulated laws, evaluated on whole arrays without the GIL.
#include "module.hpp"

#include "actions/one_contact.hpp"

#include <fstiff/answer/answer.hpp>
#include <fstiff/asperity/conductance.hpp>
#include <fstiff/asperity/material.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>
#include <fstiff/double/integrals.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/tangential_law.hpp>

#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

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

OneContact of_numbers(const std::string& law, const Numbers& numbers, const std::string& interaction,
                      const surface::MeasuredSurface* measured) {
    const nb::gil_scoped_release free;
    return actions::make_contact(law, joint_of(numbers, interaction, measured), until_interrupted());
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

/// Two numbers of what \p call of the law with friction gives at every separation and slip, arrays of one shape.
template <auto call, auto first, auto second>
std::vector<Out> slipped(const TabulatedLaw& law, double friction, double ratio, const In& separations,
                         const In& slips) {
    NewArray one(separations), other(separations);
    {
        const nb::gil_scoped_release free;
        const Friction with(law, friction, ratio);
        for (std::size_t i = 0; i < separations.size(); ++i) {
            const auto at = (with.*call)(separations.data()[i], slips.data()[i]);
            one.data()[i] = at.*first, other.data()[i] = at.*second;
        }
    }
    return {one.take(), other.take()};
}

using Slip = SlipState<double, 2>;

/// p, q and their derivatives after each step of a path from \p slip, which goes with it.
nb::tuple moved(const TabulatedLaw& law, double friction, double ratio, Slip slip, const In& separations,
                const In& slips) {
    const std::size_t count = separations.size();
    std::vector<double> pressures, tractions, tangents;
    {
        const nb::gil_scoped_release free;
        const Friction with(law, friction, ratio);
        for (std::size_t i = 0; i < count; ++i) {
            const auto at =
                with.step(slip, separations.data()[i], {slips.data()[2 * i], slips.data()[2 * i + 1]}, slip);
            pressures.push_back(at.pressure);
            tractions.insert(tractions.end(), at.traction.begin(), at.traction.end());
            const auto rows = at.tangent.transpose().reshaped();
            tangents.insert(tangents.end(), rows.begin(), rows.end());
        }
    }
    return nb::make_tuple(NewArray(pressures).take(), NewArray(tractions, {count, 2}).take(),
                          NewArray(tangents, {count, 3, 3}).take(), slip);
}

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

/// The law of an answer with K and the ends of its band at \p pressures, NaN where there is none.
TabulatedLaw law_of_answer(const In& pressures, const In& low, const In& value, const In& high, double rms_height,
                           double quantile, double min_pressure, double max_pressure, const std::string& outside) {
    Answer answer;
    answer.rms_height = rms_height;
    for (std::size_t i = 0; i < pressures.size(); ++i)
        if (const WithBand K{low.data()[i], value.data()[i], high.data()[i]}; !std::isnan(K.value))
            answer.points.push_back({.pressure = pressures.data()[i], .stiffness = K});
    const auto policy = from_name<OutsideRange>(outside, "outside");
    const nb::gil_scoped_release free;
    return answer.law_at(quantile, {min_pressure, max_pressure, policy});
}

void add_laws(nb::module_& m) {
    nb::class_<TabulatedLaw>(m, "Law", "A tabulated law; see fstiff.Law.")
        .def_static(
            "from_text", [](std::string_view text) { return TabulatedLaw::from_text(text); }, nb::arg("text"))
        .def_static("of_answer", &law_of_answer)
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
        .def("first_slip",
             &slipped<&Friction::first_slip, &Friction::FirstSlip::traction, &Friction::FirstSlip::stiffness>)
        .def("cycle", &slipped<&Friction::cycle, &Friction::Cycle::lost, &Friction::Cycle::loss_factor>)
        .def("path", &moved)
        .def("stored_energy", [](const TabulatedLaw& law, double friction, double ratio,
                                 const Slip& slip) { return Friction(law, friction, ratio).stored_energy(slip); })
        .def_prop_ro("touch", &TabulatedLaw::touch)
        .def_prop_ro("pressures",
                     [](const TabulatedLaw& law) { return std::pair(law.pressures()[0], law.pressures()[1]); })
        .def_prop_ro("separations",
                     [](const TabulatedLaw& law) { return std::pair(law.separations()[0], law.separations()[1]); })
        .def_prop_ro("relative_error", &TabulatedLaw::relative_error)
        .def_prop_ro("stiffness_is_slope", &TabulatedLaw::stiffness_is_slope)
        .def_prop_ro("outside", [](const TabulatedLaw& law) { return std::string(name_of(law.outside())); });
}

}  // namespace

void add_contacts(nb::module_& m) {
    add_slip(m);
    add_laws(m);
    nb::class_<OneContact>(m, "Contact", "A contact; see fstiff.Contact.")
        .def_static("of_numbers", &of_numbers, nb::arg("law"), nb::arg("numbers"), nb::arg("interaction"),
                    nb::arg("measured").none())
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
