// SPDX-License-Identifier: BSD-3-Clause
#include "scene/law.hpp"

#include "scene/contact_instances.hpp"

#include <fstiff/asperity/laws.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/rough_contact.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace fstiff::scene {
namespace {

template <class Contact>
class Holder final : public AnyContact {
public:
    explicit Holder(Contact contact) : contact_(std::move(contact)) {}
    std::vector<ContactPoint<double>> at_pressures(std::span<const double> pressures, Quantity wanted) const override {
        return curve_at_pressures(contact_, pressures, wanted);
    }
    std::vector<ContactPoint<double>> at_separations(std::span<const double> separations,
                                                     Quantity wanted) const override {
        return curve_at_separations(contact_, separations, wanted);
    }

private:
    Contact contact_;
};

template <class Contact>
std::unique_ptr<AnyContact> held(Contact contact) {
    return std::make_unique<Holder<Contact>>(std::move(contact));
}

RoughContactOptions<double> options_of(const ContactInputs& inputs) {
    RoughContactOptions<double> options;
    options.interaction = inputs.interaction;
    return options;
}

/// A contact of joint peaks with the asperity law that \p of_dimension makes of the fractal dimension.
template <auto of_dimension>
std::unique_ptr<AnyContact> joint(const ContactInputs& inputs) {
    return held(RoughContact(inputs.surface, *inputs.peaks, of_dimension(inputs.fractal_dimension),
                             inputs.effective_modulus, options_of(inputs)));
}

template <auto of_dimension>
Identification<double> fitted(const FitInputs& inputs) {
    return identify(inputs.data, inputs.wanted, inputs.start, of_dimension, inputs.options);
}

constexpr auto fractal = [](double dimension) { return FractalLaw<double>(dimension); };
constexpr auto fractal_consistent = [](double dimension) { return FractalConsistentLaw<double>(dimension); };
constexpr auto hertz = [](double) { return HertzLaw<double>{}; };

std::unique_ptr<AnyContact> greenwood_williamson(const ContactInputs& inputs) {
    return held(
        GreenwoodWilliamson<double>(inputs.surface, inputs.effective_modulus, Heights::gaussian, options_of(inputs)));
}

const std::array<Law, 4> table{{
    {"fractal", true, true, "(3.7)", "(3.14), (4.9)", "(4.4)", joint<fractal>, fitted<fractal>},
    {"fractal_consistent", true, true, "integral of (3.14)", "(3.14), (4.9)", "(4.4)", joint<fractal_consistent>,
     fitted<fractal_consistent>},
    {"hertz", false, true, "(3.7)", "derivative of (3.7)", "(4.4)", joint<hertz>, fitted<hertz>},
    {"greenwood_williamson", false, false, "(3.7)", "derivative of (3.7)", "Gaussian, one radius",
     greenwood_williamson},
}};

}  // namespace

std::span<const Law> laws() { return table; }

std::vector<std::string_view> law_names() {
    std::vector<std::string_view> names;
    for (const Law& law : table) names.push_back(law.name);
    return names;
}

std::vector<std::string_view> fitted_law_names() {
    std::vector<std::string_view> names;
    for (const Law& law : table)
        if (law.fit) names.push_back(law.name);
    return names;
}

const Law* find_law(std::string_view name) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const Law& law) { return law.name == name; });
    return found == table.end() ? nullptr : &*found;
}

}  // namespace fstiff::scene
