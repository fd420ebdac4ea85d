// SPDX-License-Identifier: BSD-3-Clause
#include "scene/law.hpp"

#include "instances/contact_instances.hpp"
#include "instances/surface_instances.hpp"

#include <fstiff/asperity/laws.hpp>
#include <fstiff/contact/contact_law.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/load_means.hpp>
#include <fstiff/contact/mutual_summits.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/contact/similar_hybrids.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/halfspace/truth.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace fstiff::scene {
namespace {

/// What ContactLaw::tabulate asks of a contact, through virtual functions: its tables are compiled once for all laws.
class Model {
public:
    virtual ~Model() = default;
    virtual ContactState<double> at_pressure(double pressure, Quantity wanted) const = 0;
    virtual ContactState<double> at_separation(double separation, Quantity wanted) const = 0;
    virtual LogSlope<double> log_pressure(double eta) const = 0;
    virtual Estimate<double> log_stiffness(double eta) const = 0;
};
template <class Contact>
class ModelOf final : public Model {
public:
    explicit ModelOf(Contact contact) : contact_(std::move(contact)) {}
    ContactState<double> at_pressure(double pressure, Quantity wanted) const override {
        return contact_.at_pressure(pressure, wanted);
    }
    ContactState<double> at_separation(double separation, Quantity wanted) const override {
        return contact_.at_separation(separation, wanted);
    }
    LogSlope<double> log_pressure(double eta) const override { return contact_.log_pressure(eta); }
    Estimate<double> log_stiffness(double eta) const override { return contact_.log_stiffness(eta); }

private:
    Contact contact_;
};

/// A fstiff::Contact over a Model.
class ModelContact {
public:
    template <class Contact>
    explicit ModelContact(const Contact& contact)
        : model_(std::make_shared<ModelOf<Contact>>(contact)),
          rms_height_(contact.rms_height()),
          has_kinks_(detail::has_kinks(contact)),
          bulk_compliance_(contact.bulk_compliance()),
          interaction_(contact.interaction()) {}
    ContactState<double> at_pressure(double pressure, Quantity wanted) const {
        return model_->at_pressure(pressure, wanted);
    }
    ContactState<double> at_separation(double separation, Quantity wanted) const {
        return model_->at_separation(separation, wanted);
    }
    ContactPoint<double> point_at_pressure(double pressure, Quantity wanted) const {
        return ContactPoint<double>::of(at_pressure(pressure, wanted));
    }
    ContactPoint<double> point_at_separation(double separation, Quantity wanted) const {
        return ContactPoint<double>::of(at_separation(separation, wanted));
    }
    LogSlope<double> log_pressure(double eta) const { return model_->log_pressure(eta); }
    Estimate<double> log_stiffness(double eta) const { return model_->log_stiffness(eta); }
    double rms_height() const { return rms_height_; }
    bool has_kinks() const { return has_kinks_; }
    double bulk_compliance() const { return bulk_compliance_; }
    Interaction<double> interaction() const { return interaction_; }

private:
    std::shared_ptr<const Model> model_;
    double rms_height_;
    bool has_kinks_;
    double bulk_compliance_;
    Interaction<double> interaction_;
};
/// One whose K is a constant times -dp/dd.
class ProportionalModelContact : public ModelContact {
public:
    template <class Contact>
    explicit ProportionalModelContact(const Contact& contact)
        : ModelContact(contact), stiffness_over_slope_(contact.stiffness_over_slope()) {}
    double stiffness_over_slope() const { return stiffness_over_slope_; }

private:
    double stiffness_over_slope_;
};

template <class Contact>
class Holder : public AnyContact {
public:
    explicit Holder(Contact contact) : contact_(std::move(contact)) {}
    std::vector<ContactPoint<double>> at_pressures(std::span<const double> pressures, Quantity wanted) const override {
        return curve_at_pressures(contact_, pressures, wanted);
    }
    std::vector<ContactPoint<double>> at_separations(std::span<const double> separations,
                                                     Quantity wanted) const override {
        return curve_at_separations(contact_, separations, wanted);
    }
    bool has_table() const override { return fstiff::Contact<Contact, double>; }
    ContactLaw<double> tabulate(const LawRange<double>& range) const override {
        if constexpr (ProportionalContact<Contact, double>)
            return ContactLaw<double>::tabulate(ProportionalModelContact(contact_), range);
        else if constexpr (fstiff::Contact<Contact, double>)
            return ContactLaw<double>::tabulate(ModelContact(contact_), range);
        else
            return AnyContact::tabulate(range);
    }

protected:
    Contact contact_;
};

/// A contact of plastic peaks, which begin to flow at omega_c = critical_over_radius R.
template <class Contact>
class PlasticHolder final : public Holder<Contact> {
public:
    PlasticHolder(Contact contact, double critical_over_radius)
        : Holder<Contact>(std::move(contact)), critical_over_radius_(critical_over_radius) {}
    std::vector<LoadMeans<double>> means_at(std::span<const double> etas) const override {
        std::vector<LoadMeans<double>> means;
        for (const double eta : etas) means.push_back(load_means(this->contact_, eta, critical_over_radius_));
        return means;
    }

private:
    double critical_over_radius_;
};

template <class Contact>
std::unique_ptr<AnyContact> held(Contact contact) {
    return std::make_unique<Holder<Contact>>(std::move(contact));
}

/// The mean over several maps: two faces meet at a shift that nobody knows. The errors hold the scatter of one shift.
class MeanOverShifts final : public AnyContact {
public:
    explicit MeanOverShifts(std::vector<std::unique_ptr<AnyContact>> contacts) : contacts_(std::move(contacts)) {}
    std::vector<ContactPoint<double>> at_pressures(std::span<const double> pressures, Quantity wanted) const override {
        return mean([&](const AnyContact& one) { return one.at_pressures(pressures, wanted); });
    }
    std::vector<ContactPoint<double>> at_separations(std::span<const double> separations,
                                                     Quantity wanted) const override {
        return mean([&](const AnyContact& one) { return one.at_separations(separations, wanted); });
    }
    bool has_table() const override { return contacts_.front()->has_table(); }
    /// Of the mean K and the mean separation under a pressure: the former is not the slope of the latter.
    ContactLaw<double> tabulate(const LawRange<double>& range) const override {
        if (!has_table()) return AnyContact::tabulate(range);
        const auto state_at = [this](double p) {
            const auto point = at_pressures(std::span(&p, 1), Quantity::separation | Quantity::stiffness).front();
            if (!point.ok()) throw domain_error(point.reason);
            return point.state;
        };
        const auto first = state_at(range.min_pressure);
        return ContactLaw<double>::tabulate_points(
            [&](double p) {
                const auto state = state_at(p);
                return LawPoint<double>{state.separation.value, state.stiffness.value};
            },
            first.separation.value / first.eta, range);
    }

private:
    static Estimate<double> mean_of(std::span<const Estimate<double>> all) {
        const auto n = static_cast<double>(all.size());
        double value = 0, error = 0, square = 0;
        int evaluations = 0;
        for (const auto& one : all) value += one.value / n, error += one.error / n, evaluations += one.evaluations;
        for (const auto& one : all) square += (one.value - value) * (one.value - value) / (n - 1);
        return {value, std::hypot(error, std::sqrt(square)), evaluations};
    }
    template <class Call>
    std::vector<ContactPoint<double>> mean(const Call& call) const {
        std::vector<std::vector<ContactPoint<double>>> all;
        for (const auto& one : contacts_) all.push_back(call(*one));
        std::vector<ContactPoint<double>> points = all.front();
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (const auto& of_shift : all)
                if (!of_shift[i].ok()) points[i] = of_shift[i];
            if (!points[i].ok()) continue;
            ContactState<double>& state = points[i].state;
            std::vector<Estimate<double>> values(all.size());
            for (const auto member :
                 {&ContactState<double>::separation, &ContactState<double>::pressure, &ContactState<double>::stiffness,
                  &ContactState<double>::real_area_fraction, &ContactState<double>::contact_density,
                  &ContactState<double>::loading_stiffness}) {
                std::transform(all.begin(), all.end(), values.begin(),
                               [&](const auto& of_shift) { return of_shift[i].state.*member; });
                state.*member = mean_of(values);
            }
            state.eta = 0;
            for (const auto& of_shift : all) state.eta += of_shift[i].state.eta / static_cast<double>(all.size());
        }
        return points;
    }

    std::vector<std::unique_ptr<AnyContact>> contacts_;
};

/// One contact as it is, more of them as their mean.
std::unique_ptr<AnyContact> mean_over(std::vector<std::unique_ptr<AnyContact>> contacts) {
    if (contacts.size() == 1) return std::move(contacts.front());
    return std::make_unique<MeanOverShifts>(std::move(contacts));
}

RoughContactOptions<double> options_of(const ContactInputs& inputs) {
    RoughContactOptions<double> options;
    options.interaction = inputs.interaction;
    return options;
}

// one contact and one fit are compiled for all three elastic laws
using LawOfDimension = ElasticLaw<double> (*)(double dimension);

ElasticLaw<double> fractal(double dimension) { return FractalLaw<double>(dimension); }
ElasticLaw<double> fractal_consistent(double dimension) { return FractalConsistentLaw<double>(dimension); }
ElasticLaw<double> hertz(double) { return HertzLaw<double>{}; }

/// A contact of joint peaks with the asperity law that \p of_dimension makes of the fractal dimension.
template <LawOfDimension of_dimension>
std::unique_ptr<AnyContact> joint(const ContactInputs& inputs) {
    return held(RoughContact(inputs.surface, *inputs.peaks, of_dimension(inputs.fractal_dimension),
                             inputs.effective_modulus, options_of(inputs)));
}

template <LawOfDimension of_dimension>
Identification<double> fitted(const FitInputs& inputs) {
    return identify(inputs.data, inputs.wanted, inputs.start, of_dimension, inputs.options);
}

std::unique_ptr<AnyContact> greenwood_williamson(const ContactInputs& inputs) {
    return held(
        GreenwoodWilliamson<double>(inputs.surface, inputs.effective_modulus, Heights::gaussian, options_of(inputs)));
}

/// Persson's contact of the spectrum.
PerssonContact<double> of_spectrum(const ContactInputs& inputs) {
    return inputs.map && inputs.spectrum_of_map
               ? PerssonContact<double>(inputs.map->spectrum(inputs.elements.edges), inputs.effective_modulus,
                                        inputs.gamma)
               : PerssonContact<double>(band_of_moments(inputs.moments, inputs.hurst), inputs.effective_modulus,
                                        inputs.gamma);
}

std::unique_ptr<AnyContact> persson(const ContactInputs& inputs) { return held(of_spectrum(inputs)); }

/// Whether summits push each other down; 0 for a sum of summits that do not, as which a band varies.
constexpr std::array<double, 1> quick_summits{0};
constexpr std::array<LawOption, 1> summit_options{{{.key = "mutual", .is_flag = true, .otherwise = 1}}};

/// The mean of what \p make makes of the summits of every shift and its number.
template <class Make>
std::unique_ptr<AnyContact> over_shifts(const ContactInputs& inputs, const Make& make) {
    std::vector<std::unique_ptr<AnyContact>> contacts;
    for (std::size_t shift = 0; shift < inputs.map->summits.size(); ++shift)
        contacts.push_back(held(make(inputs.map->summits[shift], shift)));
    return mean_over(std::move(contacts));
}

/// The crowded contact of one shift by its bearing curve.
BearingContact<double> crowded(const ContactInputs& inputs, std::size_t shift) {
    const MapOfSurface& map = *inputs.map;
    return map.bearings
        ->contact(map.first_bearing + shift, inputs.elements.edges, inputs.effective_modulus, inputs.gamma)
        .scaled(map.taller)
        .over_rms_height(map.rms_height());
}

std::unique_ptr<AnyContact> summits(const ContactInputs& inputs) {
    if (inputs.options.front() == 0)
        return over_shifts(
            inputs, [&](const Summits<double>& of, std::size_t) { return SummitContact<double>(of, inputs.effective_modulus); });
    return over_shifts(inputs, [&](const Summits<double>& of, std::size_t) {
        return MutualSummits<double>(of, inputs.effective_modulus, inputs.elements.edges);
    });
}

/// The hybrid law of one shift of a map, and of numbers.
auto hybrid_of_map(const ContactInputs& inputs, const Summits<double>& of, std::size_t shift) {
    const MapOfSurface& map = *inputs.map;
    SummitContact<double> peaks(of, inputs.effective_modulus);
    BearingContact<double> crowded_contact = crowded(inputs, shift);
    HandOver<double> hand_over =
        map.bearings->hand_over(map.first_bearing + shift, inputs.elements.edges, inputs.effective_modulus, inputs.gamma)
            .of(peaks, map.taller);
    return HybridContact(std::move(peaks), std::move(crowded_contact), std::move(hand_over));
}
/// What \p make makes of hybrid of numbers, of Gaussian heights or of a bearing curve.
template <class Make>
std::unique_ptr<AnyContact> of_hybrid_of_numbers(const ContactInputs& inputs, const Make& make) {
    const BandSpectrum<double> band = band_of_moments(inputs.moments, inputs.hurst);
    if (!inputs.bearing) return held(make(hybrid_of_band(band, inputs.effective_modulus, inputs.gamma)));
    return held(make(hybrid_of_band(band, *inputs.bearing, inputs.effective_modulus, inputs.gamma)));
}

std::unique_ptr<AnyContact> hybrid_of_numbers(const ContactInputs& inputs) {
    return of_hybrid_of_numbers(inputs, [](auto&& contact) { return std::move(contact); });
}

/// K of hybrid of one of many surfaces that a band is drawn of: from their table, and by the law itself beyond it.
class SimilarHybrid final : public AnyContact {
public:
    explicit SimilarHybrid(const ContactInputs& inputs) : inputs_(inputs) {}
    std::vector<ContactPoint<double>> at_pressures(std::span<const double> pressures, Quantity wanted) const override {
        std::vector<ContactPoint<double>> points;
        for (const double& p : pressures) {
            const auto K = inputs_.similar->stiffness(inputs_.moments, inputs_.hurst, inputs_.effective_modulus, p);
            if (!K) {
                points.push_back(itself().at_pressures(std::span(&p, 1), wanted).front());
                continue;
            }
            ContactState<double> state;
            state.pressure = {p, 0, 0};
            state.stiffness = {*K, SimilarHybrids<double>::accuracy * *K, 0};
            points.push_back(ContactPoint<double>::of(state));
        }
        return points;
    }
    std::vector<ContactPoint<double>> at_separations(std::span<const double> separations,
                                                     Quantity wanted) const override {
        return itself().at_separations(separations, wanted);
    }

private:
    const AnyContact& itself() const {
        if (!itself_) itself_ = hybrid_of_numbers(inputs_);
        return *itself_;
    }
    ContactInputs inputs_;
    mutable std::unique_ptr<AnyContact> itself_;
};

std::unique_ptr<AnyContact> hybrid(const ContactInputs& inputs) {
    if (!inputs.map || !inputs.spectrum_of_map) {
        if (inputs.similar) return std::make_unique<SimilarHybrid>(inputs);
        return hybrid_of_numbers(inputs);
    }
    return over_shifts(inputs, [&](const Summits<double>& of, std::size_t shift) {
        return hybrid_of_map(inputs, of, shift);
    });
}

/// Peaks that have flowed: the cut of the map itself, of numbers that of a Gaussian surface.
std::unique_ptr<AnyContact> plastic(const ContactInputs& inputs) {
    const double hardness = inputs.material.hardness_or_default(), E = inputs.effective_modulus;
    if (!inputs.map || !inputs.spectrum_of_map) {
        const double g = std::sqrt(2 * inputs.moments.m2);
        return of_hybrid_of_numbers(inputs, [&](auto&& contact) {
            return PlasticContact(std::move(contact), GaussianCut<double>(std::sqrt(inputs.moments.m0), g, E),
                                  hardness, E, g);
        });
    }
    const double g = inputs.map->spectrum(inputs.elements.edges).rms_gradient();
    return over_shifts(inputs, [&](const Summits<double>& of, std::size_t shift) {
        return PlasticContact(hybrid_of_map(inputs, of, shift),
                              inputs.map->bearings->cut(inputs.map->first_bearing + shift, inputs.elements.edges, E)
                                  .scaled(inputs.map->taller),
                              hardness, E, g);
    });
}

std::unique_ptr<AnyContact> plastic_peaks(const ContactInputs& inputs) {
    const double hardness = inputs.material.hardness_or_default();
    PlasticMaterial<double> material = inputs.material;  // omega_c of Kogut and Etsion, which follows from H alone
    material.effective_modulus = inputs.effective_modulus;
    material.hardness = hardness;
    if (!(material.yield_strength > 0)) material.yield_strength = hardness / 2.8;
    const double critical_over_radius = KogutEtsionLaw<double>(material).critical(1.0);
    return std::make_unique<PlasticHolder<RoughContact<double, PlasticLaw<double>>>>(
        RoughContact(inputs.surface, *inputs.peaks, PlasticLaw<double>(hardness, inputs.effective_modulus),
                     inputs.effective_modulus, options_of(inputs)),
        critical_over_radius);
}

/// A law of peaks that begin to flow. Its integrals have two dimensions, and the law itself is known to some percent.
template <class OfMaterial>
std::unique_ptr<AnyContact> elastic_plastic(const ContactInputs& inputs) {
    RoughContactOptions<double> options = options_of(inputs);
    options.integrals.relative_tolerance = 1e-9;
    PlasticMaterial<double> material = inputs.material;
    material.effective_modulus = inputs.effective_modulus;
    const OfMaterial law(material);
    return std::make_unique<PlasticHolder<RoughContact<double, OfMaterial>>>(
        RoughContact(inputs.surface, *inputs.peaks, law, inputs.effective_modulus, options), law.critical(1.0));
}

/// Boundary elements of the map itself.
class Elements final : public AnyContact {
public:
    Elements(std::shared_ptr<const HeightMap<double>> map, const ContactInputs& inputs)
        : map_(std::move(map)), modulus_(inputs.effective_modulus), how_(inputs.elements), progress_(inputs.progress) {}
    std::vector<ContactPoint<double>> at_pressures(std::span<const double> pressures, Quantity) const override {
        for (const double p : pressures) require_positive("pressure", p);
        const auto is_below_hardness = [&](double p) { return !(how_.hardness > 0) || p < how_.hardness; };
        std::vector<double> solvable;
        std::copy_if(pressures.begin(), pressures.end(), std::back_inserter(solvable), is_below_hardness);
        const double rms = fstiff::rms_height(*map_);
        const std::vector<TruthPoint<double>> solved =
            truth(*map_, modulus_, solvable,
                  {.points = how_.points, .edges = how_.edges, .hardness = how_.hardness, .progress = progress_});
        std::vector<ContactPoint<double>> points;
        for (auto next = solved.begin(); const double p : pressures)
            points.push_back(is_below_hardness(p)
                                 ? point_of(*next++, rms)
                                 : ContactPoint<double>::out_of_reach(
                                       "pressure = " + shortest_text(p) +
                                       ": must be less than boundary_elements.hardness (Pa)"));
        return points;
    }
    std::vector<ContactPoint<double>> at_separations(std::span<const double>, Quantity) const override {
        throw domain_error(
            "law boundary_elements: is computed at pressures; contact.pressures must stand in place of "
            "contact.separations");
    }

private:
    [[nodiscard]] ContactPoint<double> point_of(const TruthPoint<double>& solved, double rms) const {
        const BoundaryElementState<double>& found = solved.state;
        if (std::isinf(found.stiffness))
            return ContactPoint<double>::out_of_reach("all points of the map are in contact");
        if (std::isinf(solved.stiffness_error))
            return ContactPoint<double>::out_of_reach("all points of the grid half as fine are in contact");
        ContactState<double> state;
        state.pressure = {found.pressure, 0, 0};
        state.separation = {found.mean_gap, solved.gap_error, found.iterations};
        state.eta = found.mean_gap / rms;
        state.stiffness = {found.stiffness, solved.stiffness_error, found.iterations};
        if (!(how_.hardness > 0)) state.loading_stiffness = state.stiffness;
        state.real_area_fraction = {found.contact_fraction, 0, 0};
        state.contact_density = {static_cast<double>(found.spots) / map_->area(), 0, 0};
        return ContactPoint<double>::of(state);
    }

    std::shared_ptr<const HeightMap<double>> map_;
    double modulus_;
    ElementInputs how_;
    ProgressHook progress_;
};

std::unique_ptr<AnyContact> boundary_elements(const ContactInputs& inputs) {
    std::vector<std::unique_ptr<AnyContact>> of_shifts;
    for (const auto& map : inputs.map->maps) of_shifts.push_back(std::make_unique<Elements>(map, inputs));
    return mean_over(std::move(of_shifts));
}

constexpr Quantity without_contacts =
    Quantity::pressure | Quantity::separation | Quantity::stiffness | Quantity::real_area | Quantity::loading_stiffness;

const std::array<Law, 12> table{{
    {.name = "fractal",
     .nature = "the print of the paper: K is not the slope of the load (docs/errata.md)",
     .needs_dimension = true,
     .load = "(3.7)",
     .stiffness = "(3.14), (4.9)",
     .peaks = "(4.4)",
     .contact = joint<fractal>,
     .fit = fitted<fractal>},
    {.name = "fractal_consistent",
     .nature = "elastic: K of the paper, with the load whose slope it is",
     .needs_dimension = true,
     .load = "integral of (3.14)",
     .stiffness = "(3.14), (4.9)",
     .peaks = "(4.4)",
     .contact = joint<fractal_consistent>,
     .fit = fitted<fractal_consistent>},
    {.name = "hertz",
     .nature = "elastic: K is the slope of the load",
     .load = "(3.7)",
     .stiffness = "derivative of (3.7)",
     .peaks = "(4.4)",
     .contact = joint<hertz>,
     .fit = fitted<hertz>},
    {.name = "greenwood_williamson",
     .nature = "elastic, peaks of one radius",
     .has_peaks = false,
     .load = "(3.7)",
     .stiffness = "derivative of (3.7)",
     .peaks = "Gaussian, one radius",
     .contact = greenwood_williamson},
    {.name = "hybrid",
     .nature = "elastic, for all loads: peaks and Persson's theory",
     .has_peaks = false,
     .load = "at equal K",
     .stiffness = "(hertz^5 + persson^5)^(1/5)",
     .peaks = "of the spectrum cut where alpha is 6; of a map its summits, then its bearing curve",
     .contact = hybrid,
     .needs_spectrum = true,
     .holds_when_crowded = true},
    {.name = "persson",
     .nature = "elastic, of the spectrum: crowded contacts",
     .has_peaks = false,
     .load = "Persson (2007)",
     .stiffness = "Persson (2007), Almqvist et al. (2011)",
     .peaks = "none: the spectrum",
     .contact = persson,
     .quantities = without_contacts,
     .needs_spectrum = true,
     .holds_when_crowded = true},
    {.name = "summits",
     .nature = "elastic, the map's own summits, which push each other down",
     .has_peaks = false,
     .load = "(3.7)",
     .stiffness = "derivative of (3.7)",
     .peaks = "the summits of the map",
     .contact = summits,
     .options = summit_options,
     .needs_map = true,
     .needs_summits = true,
     .ends = true,
     .quick_options = quick_summits},
    {.name = "plastic",
     .nature = "peaks that have flowed: K is that of unloading, which a wave sees",
     .load = "hardness and hybrid",
     .stiffness = "(cut at p/H^1.9 + hybrid^1.9)^(1/1.9)",
     .peaks = "(4.4); of a map its summits",
     .contact = plastic,
     .quantities = without_contacts,
     .needs_spectrum = true,
     .needs_hardness = true,
     .holds_when_crowded = true},
    {.name = "plastic_peaks",
     .nature = "fully plastic peaks, each by itself: K is that of unloading, which a wave sees",
     .load = "hardness times area, 2 pi R omega",
     .stiffness = "unloading, 2 E a",
     .peaks = "(4.4)",
     .contact = plastic_peaks,
     .needs_hardness = true,
     .range = {.least_interference = 110, .most_radius_ratio = 0.4}},
    {.name = "jackson_green",
     .nature = "elastic to plastic: K is that of unloading, which a wave sees",
     .load = "Jackson, Green (2005)",
     .stiffness = "unloading, 2 E a",
     .peaks = "(4.4)",
     .contact = elastic_plastic<JacksonGreenLaw<double>>,
     .needs_yield = true,
     .range = {.most_radius_ratio = 0.41}},
    {.name = "kogut_etsion",
     .nature = "elastic to plastic: K is that of unloading, which a wave sees",
     .load = "Kogut, Etsion (2002)",
     .stiffness = "unloading, 2 E a",
     .peaks = "(4.4)",
     .contact = elastic_plastic<KogutEtsionLaw<double>>,
     .needs_yield = true,
     .range = {.most_interference = 110, .most_radius_ratio = 0.41}},
    {.name = "boundary_elements",
     .nature = "the half space solved on the map itself; the error is that of the grid",
     .has_peaks = false,
     .load = "elastic half space",
     .stiffness = "of the contact held together",
     .peaks = "the map itself",
     .contact = boundary_elements,
     .needs_map = true,
     .needs_whole_map = true,
     .holds_when_crowded = true,
     .varies = false},
}};

}  // namespace

ContactLaw<double> AnyContact::tabulate(const LawRange<double>&) const {
    throw domain_error("this law cannot be tabulated: each of its points is a solution by boundary elements; must be another");
}

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
