// SPDX-License-Identifier: BSD-3-Clause
#include "scene/verdict.hpp"

#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/validity/law_findings.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace fstiff::scene {
namespace {

using Question = parts::LawQuestion<double>;
using Found = LawFinding<double>;

bool has_law(const Scene& scene, LawName name) {
    return std::find(scene.laws.begin(), scene.laws.end(), &find_law(name)) != scene.laws.end();
}

/// What \p results and their scene tell of the contact.
Question question_of(const Scene& scene, const Results& results) {
    Question question;
    for (const Law& law : laws())
        if (has_law(scene, law.which) || refusal_of(law, scene).empty()) question.available.push_back(law.which);
    const MapOfSurface* map = scene.face.map.get();
    const double area = scene.nominal_area ? *scene.nominal_area : map ? map->maps.front()->area() : 0;
    for (const Curve& curve : results.curves)
        question.add_states(curve.states, results.modulus, curve.rms_gradient, area);
    if (scene.face.heights && scene.face.heights->kurtosis.value != 0) {  // 0: a document without it
        question.skewness = scene.face.heights->skewness;
        question.kurtosis = scene.face.heights->kurtosis;
    }
    const parts::SurfaceParameters<double>& surface = scene.face.parameters;
    question.highest_point = surface.max_peak_height.value / surface.rms_height.value;
    if (map) question.summits = map->summits.front().summits.size();
    if (scene.face.bearing && !(map && scene.face.spectrum_of_map))
        question.heights = scene.face.measured ? parts::HeightsKnown::measured_shape : parts::HeightsKnown::given_shape;
    question.has_lay = scene.has_lay;
    question.plasticity_index = results.plasticity_index;
    return question;
}

/// The sentences on findings.
class Words {
public:
    Words(const Scene& scene, const Question& question) : scene_(scene), question_(question) {}

    /// A sentence, or the part of one that is_part() of the sentence before.
    [[nodiscard]] std::string operator()(const Found& found) const {
        switch (found.finding) {
            case Finding::profile_with_lay:
                return "a profile repeats itself, so that its face has a lay: it cannot tell K, which may be up to " +
                       rounded(found.value) +
                       " times higher, as the bands say; believe hybrid or boundary_elements of a map";
            case Finding::far_from_gaussian:
                return "the heights are far from Gaussian (" + heights() +
                       "): no law over a distribution of peaks is near the truth here, and K may be wrong by " +
                       rounded(found.ratio.high) + " times; " + without_distribution();
            case Finding::sums_too_stiff:
                return not_gaussian("is too large, 1.05 to 1.9 times at skewnesses of 0.35 to 0.9");
            case Finding::sums_too_compliant:
                return not_gaussian("is too small, 0.3 to 0.9 of the truth at skewnesses of -0.9 to -0.23");
            case Finding::sums_off:
                return not_gaussian(
                    "is off, and the skewness, zero within two standard errors, leaves open to which side");
            case Finding::peaks_flow: return flow(found);
            case Finding::hybrid_holds:
                return "of elastic contacts believe " + advised(LawName::hybrid) +
                       accuracy(found, "a quarter above p* = 0.001 and a factor of two below");
            case Finding::hybrid_missing:
                return "hybrid " + refusal(LawName::hybrid) + "; hertz is good to a fifth at p* of " +
                       rounded(parts::hertz_from) + " to " + rounded(parts::hertz_to);
            case Finding::crowded_peaks:
                return "hertz and the other sums over peaks give too little K above p* = " + rounded(found.limit) +
                       ", half at 0.1";
            case Finding::beyond_comparison:
                return "above p* = " + rounded(found.limit) + " hybrid and persson alone were compared, within " +
                       std::to_string(parts::hybrid_accuracy_percent) + " % up to " +
                       rounded(parts::max_compared_pressure) + ", where the contact is closed";
            case Finding::few_contacts: return few_contacts(found);
            case Finding::no_contact:
                return "fewer than one contact is expected on the " + area() + " (" + rounded(found.value, 2) +
                       "): a law over peaks is a mean over many surfaces there and says nothing of a single one";
        }
        return "";
    }

    /// The same for a picture; empty where a picture has no room for it.
    [[nodiscard]] std::string shortly(const Found& found, bool goes_beyond) const {
        const std::string limit = rounded(parts::max_validated_pressure);
        switch (found.finding) {
            case Finding::profile_with_lay:
                return "A profile of a face with a lay cannot tell K: measure a map.";
            case Finding::far_from_gaussian:
                return "Heights far from Gaussian: use boundary_elements" + std::string(scene_.face.map ? "" : " of a map") +
                       "; other laws may be wrong by " + rounded(found.ratio.high) + " times.";
            case Finding::sums_too_stiff:
            case Finding::sums_too_compliant:
            case Finding::sums_off:
                return "Heights not Gaussian: K of laws over peaks may be wrong by 2 to 3 times.";
            case Finding::peaks_flow:
                return "The peaks flow (plasticity index " + rounded(found.value, 3) +
                       "): a wave sees K of plastic or jackson_green.";
            case Finding::hybrid_holds:
                return std::string("Recommended elastic law: hybrid") +
                       (has_law(scene_, LawName::hybrid) ? "" : " (not in contact.laws)") +
                       accuracy(found, "a factor of two") +
                       (goes_beyond ? "; the only one compared above p* = " + limit + "." : ".");
            case Finding::hybrid_missing:
                return "No elastic law is recommended: hybrid cannot be computed for this surface.";
            case Finding::beyond_comparison:
                return "Above p* = " + limit + " hybrid and persson alone were compared.";
            default: return "";
        }
    }

    /// Whether \p found is about the pressures, which have one sentence.
    [[nodiscard]] static bool is_part(const Found& found) {
        return found.finding >= Finding::hybrid_holds && found.finding <= Finding::beyond_comparison;
    }
    [[nodiscard]] std::string pressures() const {
        return "p* = p/(E g) is " + rounded(question_.least_pressure, 2) + " to " +
               rounded(question_.greatest_pressure, 2) + ": ";
    }

private:
    [[nodiscard]] std::string refusal(LawName law) const { return refusal_of(find_law(law), scene_); }
    /// "x (add "x" to contact.laws)", without the advice where it is there; empty where the scene cannot have the law.
    [[nodiscard]] std::string advised(LawName law) const {
        const std::string name(name_of(law));
        if (!question_.can(law)) return "";
        return has_law(scene_, law) ? name : name + " (add \"" + name + "\" to contact.laws)";
    }
    [[nodiscard]] std::string heights() const {
        const auto with_error = [](const Measurement<double>& one) {
            return rounded(one.value, 2) + " ± " + rounded(one.error, 2);
        };
        std::string numbers =
            "skewness " + with_error(*question_.skewness) + ", kurtosis " + with_error(*question_.kurtosis);
        if (question_.summits > 0 && question_.highest_point > 0)
            numbers += ", highest point " + rounded(question_.highest_point, 2) + " sigma, where " +
                       shown_count(static_cast<double>(question_.summits), 3) + " Gaussian summits reach " +
                       rounded(parts::highest_gaussian_summit<double>(question_.summits), 2);
        return numbers;
    }
    [[nodiscard]] std::string not_gaussian(const std::string& side) const {
        return "the heights are not Gaussian (" + heights() + "): K of laws over Gaussian peaks " + side +
               (scene_.face.bearing && !scene_.face.map ? "; hybrid takes both as far as they are known" : "");
    }
    /// What can be computed in place of laws over a distribution of peaks.
    [[nodiscard]] std::string without_distribution() const {
        if (!scene_.face.map)
            return std::string("believe boundary_elements of a map of this surface (fstiff truth)") +
                   (scene_.face.bearing
                        ? "; nearest comes hybrid, which takes skewness and kurtosis as far as they are known"
                        : "");
        const std::string elements = advised(LawName::boundary_elements),
                          hybrid = advised(LawName::hybrid);
        const std::string own = hybrid.empty() ? "" : hybrid + ", which takes the map's own summits and bearing curve";
        if (!elements.empty()) return "believe " + elements + (own.empty() ? "" : ", then " + own);
        return (own.empty() ? "" : "believe " + own + "; ") + "boundary_elements " +
               refusal(LawName::boundary_elements);
    }
    [[nodiscard]] std::string flow(const Found& found) const {
        if (!found.law) return "";
        return "the peaks flow (plasticity index " + rounded(found.value, 3) +
               "): what a wave sees is the unloading stiffness of " + advised(*found.law) +
               " or jackson_green, several times K of an elastic law" +
               (found.law == LawName::plastic ? "; plastic is good to a fifth from p = 0.003 H to 0.1 H" : "");
    }
    /// How far hybrid may be believed, with \p at_light_loads for within_factor_of_two.
    [[nodiscard]] static std::string accuracy(const Found& found, const std::string& at_light_loads) {
        const double high = found.ratio.high;
        if (high == parts::within_half.high) return ", to a factor of 1.5";
        return ", to about " + (high == parts::within_hybrid_accuracy.high
                                    ? std::to_string(parts::hybrid_accuracy_percent) + " %"
                                : high == parts::within_quarter.high ? "a quarter"
                                                                     : at_light_loads);
    }
    [[nodiscard]] std::string few_contacts(const Found& found) const {
        const double scatter = found.ratio.high - 1;
        return (found.value < 1.5 ? "as few as one contact is expected on the "
                                  : "as few as " + shown_count(found.value) + " contacts are expected on the ") +
               area() + ": one surface departs from a law by about " + rounded(100 * scatter, 2) + " %" +
               (scatter > parts::contact_scatter[2].share + 0.01 ? " or more" : "") +
               " there (rms); its own summits or boundary elements do not";
    }
    [[nodiscard]] std::string area() const { return scene_.nominal_area ? "nominal area" : "map"; }

    const Scene& scene_;
    const Question& question_;
};

}  // namespace

Verdict verdict(const Scene& scene, const Results& results) {
    const Question question = question_of(scene, results);
    const Words words(scene, question);
    const std::vector<Found> findings = parts::law_findings(question);
    const bool goes_beyond = std::any_of(findings.begin(), findings.end(), [](const Found& found) {
        return found.finding == Finding::beyond_comparison;
    });
    Verdict all;
    bool goes_on = false;
    for (const Found& found : findings) {
        const bool part = Words::is_part(found);
        if (const std::string sentence = words(found); part && goes_on)
            all.sentences.back() += "; " + sentence;
        else if (!sentence.empty())
            all.sentences.push_back((part ? words.pressures() : "") + sentence);
        const std::string shorter = goes_on && part ? "" : words.shortly(found, goes_beyond);
        if (!shorter.empty() && all.shorter.size() < (question.has_lay ? 1 : 2)) all.shorter.push_back(shorter);
        goes_on = part;
    }
    if (all.shorter.empty())
        all.shorter.emplace_back("No law is recommended: the rms gradient of the surface is not known.");
    all.sentences.insert(all.sentences.end(), results.about_band.begin(), results.about_band.end());
    return all;
}

}  // namespace fstiff::scene
