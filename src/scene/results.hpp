// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Results of a scene: one curve for each law and joint distribution of peaks, with bands, checks and reflections.
//
//     const Scene scene = read_scene(text, {.name = "scene.toml"});
//     const Results results = compute(scene);
//     for (const Curve& curve : results.curves)
//         for (const Column& column : curve.columns) use(curve.law->name, column.key(), column.values);

#include "scene/column.hpp"
#include "scene/scene.hpp"

#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/load_means.hpp>
#include <fstiff/core/progress.hpp>
#include <fstiff/measured/band_parts.hpp>
#include <fstiff/validity/answer.hpp>
#include <fstiff/validity/checks.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fstiff::scene {

/// A point of the scene that a law does not reach.
struct MissedPoint {
    std::size_t place = 0;         ///< among Scene::points
    std::string reason;            ///< of the law
    bool unrepresentable = false;  ///< a number is beyond the range of double precision
};

/// One law on one joint distribution of peaks, at every point of the scene that the law reaches.
struct Curve {
    const Law* law = nullptr;
    std::optional<double> theta{}, r{};    ///< none: a law without a joint distribution
    std::optional<double> rms_gradient{};  ///< of the surface, for p*; the same in every curve
    std::vector<ContactState<double>> states{};
    std::vector<std::size_t> places{};  ///< of the states among Scene::points
    std::vector<MissedPoint> missed{};  ///< the other points
    std::vector<double> seated{};       ///< separation at Scene::seating [m], one a state; empty: not known
    std::vector<double> growth{};       ///< d log K/d log p below each state, for Scene::loss_factor; empty: not known
    std::vector<parts::Check<double>> checks{};
    std::vector<parts::LoadMeans<double>> means{};  ///< of a plastic law, one a state
    std::vector<parts::SampledBand<double>>
        band{};  ///< of the stiffness, one a state; empty: the surface has no errors
    std::vector<parts::BandParts<double>> band_parts{};  ///< of the band, where the surface has neighbours
    std::vector<Column> columns{};                       ///< what Scene asks for; the same keys in every curve
    std::vector<const Law*> by{};                        ///< of an answer, the law of each state; empty: `law` gave all

    [[nodiscard]] const Law& law_at(std::size_t state) const { return by.empty() ? *law : *by[state]; }

    /// Whether the separation of \p state is known: law plastic has none where the mean planes would have met.
    [[nodiscard]] bool has_separation(std::size_t state) const {
        return law_at(state).which != LawName::plastic || states[state].separation.value > 0;
    }
    /// Index of the state of the point \p place of the scene; none where the law does not reach it.
    [[nodiscard]] std::optional<std::size_t> state_at(std::size_t place) const;
    /// \p statistic of \p quantity at the point \p place of the scene; none where there is no such column or state.
    [[nodiscard]] std::optional<double> value_at(std::size_t place, CurveQuantity quantity,
                                                 Statistic statistic = Statistic::value) const;
};

/// The names of the laws that gave the states of \p curve: "boundary_elements and hybrid".
[[nodiscard]] std::string laws_of(const Curve& curve);
/// "fractal, theta = 0.7854, r = 0.5".
[[nodiscard]] std::string title(const Curve& curve);

/// Why K of the answer at one state is what it is.
struct AnswerReason {
    parts::Causes<double> causes{};  ///< of the band
    std::optional<double> p_star;    ///< p/(E g)
    std::optional<double> contacts;  ///< expected on the area of the contact
    std::optional<double>
        loading_stiffness;  ///< [Pa/m] where the peaks yield: for a load that rises for the first time
};

/// One K for each point, by the law that holds there.
struct StiffnessAnswer {
    Curve curve;                        ///< its band is that of the surface
    std::vector<AnswerReason> reasons;  ///< one a state
    bool of_map_itself = false;         ///< the contact is the measured map, and no other piece of the surface
    bool flows = false;                 ///< K is that of unloading
    bool waves_at_least = false;  ///< waves longer than the measurement have no law: the band holds the least of them
    std::optional<double> relative_hardness;  ///< H/(E g)
};

struct Results {
    double modulus = 0;           ///< effective [Pa]
    double tangential_ratio = 0;  ///< of the tangential stiffness to K
    std::optional<double> plasticity_index;
    std::vector<parts::Check<double>> surface_checks;
    std::optional<StiffnessAnswer> answer;  ///< none: no law answers at any point
    std::vector<Curve> curves;             ///< of the laws that are named; where none is, the curve of the answer alone
    std::vector<std::string> warnings;     ///< sentences on the checks that do not hold, and on the scene
    std::vector<std::string> explanation;  ///< three sentences at most: the kind of K, its uses and its source
    std::vector<std::string> short_explanation;  ///< the same for a picture: one or two short sentences
    /// A real area above the nominal one, integrals that did not converge, points that a law does not reach, an rms
    /// gradient that no surface has, or a measured surface with unknown_parameters().
    bool doubtful = false;
};

/// The measured parameters of \p scene on which no result can rest; an answer rests on the rms height alone.
[[nodiscard]] std::vector<Parameter> unknown_parameters(const Scene& scene);

/// The curve of the answer, then those of the laws that are named.
[[nodiscard]] std::vector<const Curve*> shown_curves(const Results& results);

/// Whether any curve has a band.
[[nodiscard]] bool has_band(const Results& results);

/// The interaction of the scene with its length [m].
[[nodiscard]] Interaction<double> interaction(const Scene& scene);

/// Everything the scene asks for. A point that a law does not reach leaves the others alone, with a warning. \p
/// progress is called while a band is sampled.
/// \throws domain_error where the model cannot give it, or no law reaches any point, naming the place in the scene.
[[nodiscard]] Results compute(const Scene& scene, const ProgressHook& progress = {});
/// A contact of a scene, and its curve still without states.
struct MadeContact {
    Curve curve;
    std::unique_ptr<AnyContact> contact;
};
/// The contacts of \p scene, for many scenes that differ in their points alone; the scene must live as long.
/// \throws domain_error as compute().
[[nodiscard]] std::vector<MadeContact> contacts_of(const Scene& scene);
/// The curves of compute() with their states, bands and columns, but without checks, means and warnings.
/// \p contacts are those of the scene, or of one with other points. \throws domain_error as compute().
[[nodiscard]] std::vector<Curve> curves_of(const Scene& scene, const std::vector<MadeContact>& contacts);

}  // namespace fstiff::scene
