// SPDX-License-Identifier: BSD-3-Clause
#include "scene/verdict.hpp"

#include "document/file.hpp"
#include "document/shown_unit.hpp"
#include "scene/validated_ratio.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace fstiff::scene {
namespace {

bool has_law(const Scene& scene, std::string_view name) {
    return std::any_of(scene.laws.begin(), scene.laws.end(),
                       [&](const ChosenLaw& chosen) { return chosen.law->name == name; });
}

/// "x (add "x" to contact.laws)", without the advice where it is there; empty where the scene cannot have the law.
std::string advised(const Scene& scene, std::string_view law) {
    if (has_law(scene, law)) return std::string(law);
    if (!refusal_of(*find_law(law), scene).empty()) return "";
    return std::string(law) + " (add \"" + std::string(law) + "\" to contact.laws)";
}

struct AboutHeights {
    std::string sentence;            ///< empty for Gaussian heights
    std::string shorter;             ///< for a picture
    bool far_from_gaussian = false;  ///< no law over a distribution of peaks holds
};

/// Whether \p one is farther from \p gaussian than \p limit, and than two standard errors.
bool departs(const Measurement<double>& one, double gaussian, double limit) {
    const double distance = std::abs(one.value - gaussian);
    return distance > limit && distance > 2 * one.error;
}

/// What can be computed in place of laws over a distribution of peaks.
std::string without_distribution(const Scene& scene) {
    if (!scene.face.map)
        return std::string("believe boundary_elements of a map of this surface (fstiff truth)") +
               (scene.face.bearing
                    ? "; nearest comes hybrid, which takes skewness and kurtosis as far as they are known"
                              : "");
    const std::string elements = advised(scene, "boundary_elements"), hybrid = advised(scene, "hybrid");
    const std::string refused = "boundary_elements " + refusal_of(*find_law("boundary_elements"), scene);
    const std::string own = hybrid.empty() ? "" : hybrid + ", which takes the map's own summits and bearing curve";
    if (elements.empty()) return own.empty() ? refused : "believe " + own + "; " + refused;
    return "believe " + elements + (own.empty() ? "" : ", then " + own);
}

/// To which side laws over Gaussian peaks are off.
std::string side_of_error(const Measurement<double>& skewness) {
    if (!departs(skewness, 0, 0))
        return "K of laws over Gaussian peaks is off, and the skewness, zero within two standard errors, leaves open "
               "to which side";
    return std::string("K of laws over Gaussian peaks is ") +
           (skewness.value > 0 ? "too large, 1.05 to 1.9 times at skewnesses of 0.35 to 0.9"
                               : "too small, 0.3 to 0.9 of the truth at skewnesses of -0.9 to -0.23");
}

/// What the distribution of the heights does to every law over Gaussian peaks.
AboutHeights about_heights(const Scene& scene) {
    if (!scene.face.heights) return {};
    const Measurement<double>&skewness = scene.face.heights->skewness, &kurtosis = scene.face.heights->kurtosis;
    if (kurtosis.value == 0) return {};  // a document without it
    const double highest = scene.face.parameters.max_peak_height.value / scene.face.parameters.rms_height.value;
    const double summits = scene.face.map ? static_cast<double>(scene.face.map->summits.front().summits.size()) : 0;
    const double gaussian = std::sqrt(2 * std::log(std::max(summits, 2.0)));
    const auto with_error = [](const Measurement<double>& one) {
        return rounded(one.value, 2) + " ± " + rounded(one.error, 2);
    };
    std::string numbers = "skewness " + with_error(skewness) + ", kurtosis " + with_error(kurtosis);
    if (summits > 0 && highest > 0)
        numbers += ", highest point " + rounded(highest, 2) + " sigma, where " + shown_count(summits, 3) +
                   " Gaussian summits reach " + rounded(gaussian, 2);
    const bool too_high = summits > 0 && highest > 1.6 * gaussian;
    if (departs(skewness, 0, 1) || departs(kurtosis, 3, 2) || too_high)
        return {"the heights are far from Gaussian (" + numbers +
                    "): no law over a distribution of peaks is near the truth here, and K may be wrong by 5 times; " +
                    without_distribution(scene),
                std::string("Heights far from Gaussian: use boundary_elements") + (scene.face.map ? "" : " of a map") +
                    "; other laws may be wrong by 5 times.",
                true};
    if (departs(skewness, 0, 0.3) || departs(kurtosis, 3, 1))
        return {"the heights are not Gaussian (" + numbers + "): " + side_of_error(skewness) +
                    (scene.face.bearing && !scene.face.map ? "; hybrid takes both as far as they are known" : ""),
                "Heights not Gaussian: K of laws over peaks may be wrong by 2 to 3 times."};
    return {};
}

/// Least and greatest p* of the scene; none where no gradient is known.
std::optional<std::pair<double, double>> relative_pressures(const Results& results) {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const Curve& curve : results.curves)
        for (const auto& state : curve.states) {
            if (!curve.rms_gradient) return std::nullopt;
            const double p = dimensionless_pressure(state.pressure.value, results.modulus, *curve.rms_gradient);
            low = std::min(low, p);
            high = std::max(high, p);
        }
    if (low > high) return std::nullopt;
    return std::pair(low, high);
}

/// How far hybrid may be believed down to \p least p*, as docs/validation.md found, with \p below for light loads.
std::string accuracy_of_hybrid(const Scene& scene, double least, const char* below) {
    if (scene.face.bearing && !(scene.face.map && scene.face.spectrum_of_map))
        return scene.face.measured ? ", to a factor of 1.5" : ", to about a quarter";
    if (least >= min_validated_pressure)
        return ", to about " + std::to_string(hybrid_accuracy_percent) + " %";
    return std::string(", to about ") + (least >= 0.001 ? "a quarter" : below);
}

/// Which elastic law holds at the pressures of the scene.
std::string about_pressures(const Scene& scene, const Results& results) {
    const auto range = relative_pressures(results);
    if (!range) return "";
    const auto [low, high] = *range;
    std::string text = "p* = p/(E g) is " + rounded(low, 2) + " to " + rounded(high, 2) + ": ";
    const std::string beyond = "above p* = " + rounded(max_validated_pressure) +
                               " hybrid and persson alone were compared, within 15 % up to " +
                               rounded(max_compared_pressure) + ", where the contact is closed";
    if (low > max_validated_pressure) return text + beyond;
    const std::string hybrid = advised(scene, "hybrid");
    text += hybrid.empty() ? "hybrid " + refusal_of(*find_law("hybrid"), scene) +
                                 "; hertz is good to a fifth at p* of 0.002 to 0.008"
                           : "of elastic contacts believe " + hybrid +
                                 accuracy_of_hybrid(scene, low, "a quarter above p* = 0.001 and a factor of two below");
    if (high > 0.01) text += "; hertz and the other sums over peaks give too little K above p* = 0.01, half at 0.1";
    return high > max_validated_pressure ? text + "; " + beyond : text;
}

std::string shortly_about_pressures(const Scene& scene, const Results& results) {
    const auto range = relative_pressures(results);
    if (!range) return "";
    const auto [low, high] = *range;
    const std::string limit = rounded(max_validated_pressure);
    if (low > max_validated_pressure) return "Above p* = " + limit + " hybrid and persson alone were compared.";
    if (advised(scene, "hybrid").empty())
        return "No elastic law is recommended: hybrid cannot be computed for this surface.";
    return std::string("Recommended elastic law: hybrid") + (has_law(scene, "hybrid") ? "" : " (not in contact.laws)") +
           accuracy_of_hybrid(scene, low, "a factor of two") +
           (high > max_validated_pressure ? "; the only one compared above p* = " + limit + "." : ".");
}

std::string about_contacts(const Scene& scene, const Results& results) {
    const double area = scene.nominal_area ? *scene.nominal_area
                        : scene.face.map   ? scene.face.map->maps.front()->area()
                                           : 0;
    double least = std::numeric_limits<double>::infinity();
    for (const Curve& curve : results.curves)
        for (const auto& state : curve.states)
            if (state.contact_density.value > 0) least = std::min(least, state.contact_density.value * area);
    if (!(area > 0) || !(least < 200)) return "";
    if (least < 1)
        return "fewer than one contact is expected on the " +
               std::string(scene.nominal_area ? "nominal area" : "map") + " (" + rounded(least, 2) +
               "): a law over peaks is a mean over many surfaces there and says nothing of a single one";
    const char* scatter = least > 100 ? "7 %" : least > 40 ? "11 %" : least > 15 ? "16 %" : "34 % or more";
    return (least < 1.5 ? "as few as one contact is expected on the "
                        : "as few as " + shown_count(least) + " contacts are expected on the ") +
           (scene.nominal_area ? "nominal area" : "map") + std::string(": one surface departs from a law by about ") +
           scatter + " there (rms); its own summits or boundary elements do not";
}

bool peaks_flow(const Results& results) { return results.plasticity_index && *results.plasticity_index > 1; }

std::string about_flow(const Scene& scene, const Results& results) {
    std::string plastic = advised(scene, "plastic");
    const bool of_spectrum = !plastic.empty();
    if (!of_spectrum) plastic = advised(scene, "plastic_peaks");
    if (!peaks_flow(results) || plastic.empty()) return "";
    return "the peaks flow (plasticity index " + rounded(*results.plasticity_index, 3) +
           "): what a wave sees is the unloading stiffness of " + plastic +
           " or jackson_green, several times K of an elastic law" +
           (of_spectrum ? "; plastic is good to a fifth from p = 0.003 H to 0.1 H" : "");
}

}  // namespace

std::vector<std::string> short_verdict(const Scene& scene, const Results& results) {
    const AboutHeights heights = about_heights(scene);
    std::vector<std::string> sentences;
    if (scene.has_lay) return {"A profile of a face with a lay cannot tell K: measure a map."};
    for (std::string sentence :
         {heights.shorter,
          peaks_flow(results) ? "The peaks flow (plasticity index " + rounded(*results.plasticity_index, 3) +
                                    "): a wave sees K of plastic or jackson_green."
                              : std::string(),
          heights.far_from_gaussian ? "" : shortly_about_pressures(scene, results)})
        if (!sentence.empty() && sentences.size() < 2) sentences.push_back(std::move(sentence));
    if (sentences.empty())
        sentences.emplace_back("No law is recommended: the rms gradient of the surface is not known.");
    return sentences;
}

std::vector<std::string> verdict(const Scene& scene, const Results& results) {
    std::vector<std::string> sentences;
    if (scene.has_lay)  // no law holds
        sentences.push_back("a profile repeats itself, so that its face has a lay: it cannot tell K, which may be up to " +
                            rounded(lay_factor) + " times higher, as the bands say; believe hybrid or boundary_elements of a map");
    const AboutHeights heights = about_heights(scene);
    for (std::string sentence :
         {scene.has_lay ? "" : heights.sentence, about_flow(scene, results),
          scene.has_lay || heights.far_from_gaussian ? "" : about_pressures(scene, results),
          about_contacts(scene, results)})
        if (!sentence.empty()) sentences.push_back(std::move(sentence));
    sentences.insert(sentences.end(), results.about_band.begin(), results.about_band.end());
    return sentences;
}

}  // namespace fstiff::scene
