// SPDX-License-Identifier: BSD-3-Clause
#include "scene/verdict.hpp"

#include "scene/file.hpp"

#include <algorithm>
#include <cmath>

namespace fstiff::scene {
namespace {

bool has_law(const Scene& scene, std::string_view name) {
    return std::any_of(scene.laws.begin(), scene.laws.end(),
                       [&](const ChosenLaw& chosen) { return chosen.law->name == name; });
}

/// "add law "x" to contact.laws", unless it is there.
std::string unless_there(const Scene& scene, std::string_view law) {
    return has_law(scene, law) ? "" : " (add \"" + std::string(law) + "\" to contact.laws)";
}

struct AboutHeights {
    std::string sentence;            ///< empty for Gaussian heights
    bool far_from_gaussian = false;  ///< no law over a distribution of peaks holds
};

/// What the distribution of the heights does to every law over Gaussian peaks.
AboutHeights about_heights(const Scene& scene) {
    if (!scene.heights) return {};
    const double skewness = scene.heights->skewness.value, kurtosis = scene.heights->kurtosis.value;
    if (kurtosis == 0) return {};  // a document without it
    const double highest = scene.surface.max_peak_height / scene.surface.rms_height;
    const double summits = scene.map ? static_cast<double>(scene.map->summits.front().summits.size()) : 0;
    const double gaussian = std::sqrt(2 * std::log(std::max(summits, 2.0)));
    std::string numbers = "skewness " + rounded(skewness, 2) + ", kurtosis " + rounded(kurtosis, 2);
    if (summits > 0 && highest > 0)
        numbers += ", highest point " + rounded(highest, 2) + " sigma, where " + rounded(summits, 3) +
                   " Gaussian summits reach " + rounded(gaussian, 2);
    const bool too_high = summits > 0 && highest > 1.6 * gaussian;
    if (std::abs(skewness) > 1 || std::abs(kurtosis - 3) > 2 || too_high)
        return {"the heights are far from Gaussian (" + numbers +
                    "): no law over a distribution of peaks is near the truth " +
                    "here, and K may be wrong by 5 times; believe " +
                    (scene.map ? "boundary_elements" + unless_there(scene, "boundary_elements") +
                                     ", then summits at light loads" + unless_there(scene, "summits")
                               : std::string("boundary_elements of a map of this surface (fstiff truth)")),
                true};
    if (std::abs(skewness) > 0.3 || std::abs(kurtosis - 3) > 1)
        return {"the heights are not Gaussian (" + numbers + "): K of laws over Gaussian peaks is " +
                (skewness > 0 ? "1.05 to 1.9 times too large at skewnesses of 0.35 to 0.9"
                              : "too small, 0.3 to 0.9 of the truth at skewnesses of -0.9 to -0.23")};
    return {};
}

/// Which elastic law holds at the pressures of the scene.
std::string about_pressures(const Scene& scene, const Results& results) {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const Curve& curve : results.curves)
        for (const auto& state : curve.states) {
            if (!curve.rms_gradient) return "";
            const double p = dimensionless_pressure(state.pressure.value, results.modulus, *curve.rms_gradient);
            low = std::min(low, p);
            high = std::max(high, p);
        }
    if (low > high) return "";
    std::string text = "p* = p/(E g) is " + rounded(low, 2) + " to " + rounded(high, 2) +
                       ": of elastic contacts believe hybrid" + unless_there(scene, "hybrid") + ", to about ";
    text += low >= 0.003 ? "10 %" : low >= 0.001 ? "a quarter" : "a quarter above p* = 0.001 and a factor of two below";
    if (high > 0.01) text += "; hertz and the other sums over peaks give too little K above p* = 0.01, half at 0.1";
    if (high > 0.25) text += "; nothing was compared above p* = 0.25";
    return text;
}

std::string about_contacts(const Scene& scene, const Results& results) {
    const double area = scene.nominal_area ? *scene.nominal_area : scene.map ? scene.map->maps.front()->area() : 0;
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
    return "as few as " + rounded(least, 2) + " contacts are expected on the " +
           (scene.nominal_area ? "nominal area" : "map") + ": one surface departs from a law by about " + scatter +
           " there (rms); its own summits or boundary elements do not";
}

std::string about_flow(const Scene& scene, const Results& results) {
    if (!results.plasticity_index || *results.plasticity_index <= 1) return "";
    return "the peaks flow (plasticity index " + rounded(*results.plasticity_index, 3) +
           "): what a wave sees is the unloading stiffness of plastic or jackson_green" +
           unless_there(scene, "plastic") +
           ", several times K of an elastic law; plastic is good to a fifth up to p = 0.03 H where H/(E g) is 0.05 or "
           "less";
}

}  // namespace

std::vector<std::string> verdict(const Scene& scene, const Results& results) {
    std::vector<std::string> sentences;
    const auto [heights, far_from_gaussian] = about_heights(scene);
    for (std::string sentence :
         {heights, about_flow(scene, results), far_from_gaussian ? "" : about_pressures(scene, results),
          about_contacts(scene, results)})
        if (!sentence.empty()) sentences.push_back(std::move(sentence));
    sentences.insert(sentences.end(), results.about_band.begin(), results.about_band.end());
    return sentences;
}

}  // namespace fstiff::scene
