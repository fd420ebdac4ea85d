// SPDX-License-Identifier: BSD-3-Clause
// The loss factor of a scene with friction, against the tangential law of the same contact, and what is refused.
#include "actions/answered.hpp"
#include "actions/run.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/library.hpp"

#include <fstiff/asperity/tangential_ratio.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/tangential_law.hpp>

#include <cmath>
#include <numbers>
#include <string>

namespace friction_test {

namespace {

using namespace fstiff;
using test::results_of;

const std::string surface =
                      "material = { upper = \"steel\" }\n[surface]\nrms_height = \"0.8 um\"\n"
                      "peak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n",
                  contact = "[contact]\npressures = [\"1 MPa\", \"10 MPa\", \"100 MPa\"]\n",
                  friction = "[friction]\ncoefficient = 0.3\namplitude = \"20 nm\"\n";

double at(const AnswerCurve& curve, std::size_t i, std::string_view quantity, std::string_view statistic = "") {
    const auto value = test::value_at(curve, i, quantity, statistic);
    REQUIRE(value);
    return *value;
}

std::string refusal(const std::string& text) { return test::refused_scene(text, "s.toml"); }

}  // namespace

TEST_CASE("The loss factor of a law is that of its tangential law") {
    const auto found = results_of(surface + contact + "laws = [\"greenwood_williamson\"]\n" + friction);
    const fstiff::Roughness<double> same{.rms_height = 0.8e-6, .peak_radius = 40e-6, .peak_density = 5e8};
    const auto law = fstiff::ContactLaw<double>::tabulate(
        fstiff::GreenwoodWilliamson<double>(same, found.answer.effective_modulus), {1e4, 1e9});
    const fstiff::TangentialLaw<double> slips(law, 0.3, fstiff::tangential_ratio<double>({205e9, 0.3}, {205e9, 0.3}));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& curve = found.curves().front();
        const double truth = slips.cycle(law.separation(at(curve, i, "pressure")), 20e-9).loss_factor;
        CHECK(test::relative_error(at(curve, i, "loss_factor"), truth) < 0.03);  // K is not a power of p
        CHECK(truth > 0.01);
    }
}

TEST_CASE("The band of the loss factor is that of K, and for yielded peaks it holds both limits") {
    const std::string numbers = "[surface]\nrms_height = \"0.8 um\"\nrms_gradient = 0.1\n";
    const auto elastic =
        results_of("material.upper = { name = \"steel\", hardness = \"infinite\" }\n" + numbers + contact + friction);
    const auto flowed =
        results_of("material.upper = { name = \"steel\", hardness = \"2 GPa\" }\n" + numbers + contact + friction);
    const std::string below =
        test::replaced(contact, "\"1 MPa\", \"10 MPa\", \"100 MPa\"", "\"0.6 MPa\", \"6 MPa\", \"60 MPa\"");
    const auto slopes = [&](const actions::Answered& of, const std::string& hardness) {
        const auto less = results_of("material.upper = { name = \"steel\", hardness = \"" + hardness + "\" }\n" +
                                     numbers + below + friction);
        std::vector<double> all;
        for (std::size_t i = 0; i < 3; ++i)
            all.push_back(std::log(of.answer.points[i].stiffness.value / less.answer.points[i].stiffness.value) /
                          std::log(1 / 0.6));
        return all;
    };
    const std::vector<double> of_elastic = slopes(elastic, "infinite"), of_flowed = slopes(flowed, "2 GPa");
    for (std::size_t i = 0; i < 3; ++i) {
        const AnswerCurve& a = elastic.answer;
        const double p = at(a, i, "pressure");
        for (const std::string_view end : {"_p05", "", "_p95"}) {
            const double x = at(a, i, "tangential_stiffness", end) * 20e-9 / (0.3 * p);
            CHECK(test::relative_error(
                      at(a, i, "loss_factor", end),
                      fstiff::detail::loss_factor(fstiff::detail::PowerUnloading<double>{of_elastic[i]}, x)) < 1e-14);
        }
        CHECK(std::abs(of_elastic[i] - 0.9) < 0.15);
        const AnswerCurve& b = flowed.answer;
        const double x = at(b, i, "tangential_stiffness") * 20e-9 / (0.3 * p);
        const double least = fstiff::detail::loss_factor(fstiff::detail::FlowedUnloading<double>{}, x),
                     most = fstiff::detail::loss_factor(fstiff::detail::PowerUnloading<double>{of_flowed[i]}, x);
        CHECK(test::relative_error(at(b, i, "loss_factor"), std::sqrt(least * most)) < 1e-12);
        CHECK(at(b, i, "loss_factor", "_p05") < least);
        CHECK(at(b, i, "loss_factor", "_p95") > most);
    }
}

TEST_CASE("Friction is printed where a scene has it, and refused where it lacks a number") {
    CHECK(test::value_at(results_of(surface + contact).answer, 0, "tangential_stiffness") == std::nullopt);
    const auto without = results_of(surface + contact + "[friction]\ncoefficient = 0.3\n").answer;
    CHECK(test::value_at(without, 0, "tangential_stiffness"));
    CHECK_FALSE(test::value_at(without, 0, "loss_factor"));
    const std::string text = surface + contact;
    CHECK(refusal(text + "[output]\nquantities = [\"loss_factor\"]\n") ==
          "s.toml:9: output.quantities: needs friction.amplitude for \"loss_factor\"");
    CHECK(refusal(text + "[friction]\namplitude = \"1 um\"\n") ==
          "s.toml:8: friction.coefficient: is missing; the scene needs it");
    CHECK(refusal(text + "[friction]\ncoefficient = -0.1\n") ==
          "s.toml:9: friction.coefficient = -0.1: must be greater than 0 and at most 10");
    CHECK(refusal(text + "[friction]\ncoefficient = \"0.1\"\n").starts_with("s.toml:9: friction.coefficient"));
    CHECK(std::abs(at(results_of(text + "[friction]\ncoefficient = 0.1\namplitude = \"1e90 m\"\n").answer, 0,
                      "loss_factor", "_p95") -
                   4 / std::numbers::pi) < 1e-14);
    CHECK(refusal(text + "[friction]\ncoefficient = 0.1\namplitude = 1e-6\n")
              .starts_with("s.toml:10: friction.amplitude"));
    CHECK(refusal(text + "[friction]\nmu = 0.1\n").starts_with("s.toml:9: friction.mu: unknown key"));
}

}  // namespace friction_test
