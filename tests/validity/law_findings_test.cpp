// SPDX-License-Identifier: BSD-3-Clause
// Every finding is reached, every threshold stands where docs/validation.md and docs/accuracy.md have it: from both sides.
#include <fstiff/validity/law_findings.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"

#include <limits>
#include <set>

namespace law_findings_test {

using namespace fstiff;

namespace {

using Question = parts::LawQuestion<double>;
using Found = LawFinding<double>;

const Found* find(const std::vector<Found>& findings, Finding wanted) {
    for (const Found& one : findings)
        if (one.finding == wanted) return &one;
    return nullptr;
}
bool has(const Question& question, Finding wanted) {
    return find(parts::law_findings(question), wanted) != nullptr;
}

/// Gaussian heights, p* from \p low to \p high, all laws.
Question at(double low, double high) {
    Question question;
    for (const auto& [law, word] : names<LawName>) question.available.push_back(law);
    question.least_pressure = low, question.greatest_pressure = high;
    return question;
}
Question of_heights(Measurement<double> skewness, Measurement<double> kurtosis) {
    Question question = at(0.003, 0.005);
    question.skewness = skewness, question.kurtosis = kurtosis;
    return question;
}
Question of_contacts(double contacts) {
    Question question = at(0.003, 0.005);
    question.fewest_contacts = contacts;
    return question;
}
const double above = 1 + 1e-9, below = 1 - 1e-9;

}  // namespace

TEST_CASE("K of hybrid is known to 15 %, a quarter or a factor of two by the least p*, to less by a shape of numbers") {
    const auto ratio = [](double low, parts::HeightsKnown heights = parts::HeightsKnown::map) {
        Question question = at(low, 0.2);
        question.heights = heights;
        return find(parts::law_findings(question), Finding::hybrid_holds)->ratio.high;
    };
    CHECK(ratio(0.002) == 1.15);
    CHECK(ratio(0.002 * below) == 1.25);
    CHECK(ratio(0.001) == 1.25);
    CHECK(ratio(0.001 * below) == 2);
    CHECK(ratio(0.01, parts::HeightsKnown::given_shape) == 1.25);
    CHECK(ratio(0.01, parts::HeightsKnown::measured_shape) == 1.5);
}

TEST_CASE("Crowded peaks begin at p* of 0.01, as in the checks of a curve, and comparison ends at 0.25 and 0.75") {
    CHECK_FALSE(has(at(0.002, 0.01), Finding::crowded_peaks));
    CHECK(has(at(0.002, 0.01 * above), Finding::crowded_peaks));
    CHECK(find(parts::law_findings(at(0.002, 0.1)), Finding::crowded_peaks)->limit ==
          parts::max_dimensionless_pressure<double>);
    CHECK_FALSE(has(at(0.01, 0.25), Finding::beyond_comparison));
    CHECK(has(at(0.01, 0.25 * above), Finding::beyond_comparison));
    CHECK(has(at(0.25, 0.3), Finding::hybrid_holds));
    CHECK_FALSE(has(at(0.25 * above, 0.3), Finding::hybrid_holds));
    CHECK(parts::law_advice(parts::law_findings(at(0.3, 0.75))).law == LawName::hybrid);
    CHECK_FALSE(parts::law_advice(parts::law_findings(at(0.3, 0.75 * above))).law);
}

TEST_CASE("Without a spectrum hertz has its range, and without a gradient nothing is found") {
    Question question = at(0.003, 0.005);
    std::erase(question.available, LawName::hybrid);
    const auto findings = parts::law_findings(question);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].finding == Finding::hybrid_missing);
    CHECK(findings[0].ratio.low == 0.8);
    CHECK_FALSE(parts::law_advice(findings).law);
    Question unknown;
    unknown.add_pressure(1e6, 1e11, std::nullopt);
    unknown.add_pressure(1e6, 1e11, 0.1);
    CHECK_FALSE(unknown.has_pressures());
    CHECK(parts::law_findings(unknown).empty());
}

TEST_CASE("Heights depart from Gaussian ones by their limits and by two standard errors") {
    CHECK(parts::law_findings(of_heights({0.3, 0.01}, {4, 0.1})).front().finding == Finding::hybrid_holds);
    CHECK(has(of_heights({0.3 * above, 0.01}, {3, 0.1}), Finding::sums_too_stiff));
    CHECK(has(of_heights({-0.3 * above, 0.01}, {3, 0.1}), Finding::sums_too_compliant));
    CHECK(has(of_heights({0, 0.01}, {4 * above, 0.1}), Finding::sums_off));
    CHECK_FALSE(has(of_heights({0.4, 0.2}, {3, 0.1}), Finding::sums_too_stiff));  // two standard errors
    CHECK(has(of_heights({0.4 * above, 0.2}, {3, 0.1}), Finding::sums_too_stiff));
    CHECK_FALSE(has(of_heights({1, 0.01}, {5, 0.1}), Finding::far_from_gaussian));
    CHECK(has(of_heights({above, 0.01}, {3, 0.1}), Finding::far_from_gaussian));
    CHECK(has(of_heights({0, 0.01}, {5 * above, 0.1}), Finding::far_from_gaussian));
    Question high = of_heights({0, 0.01}, {3, 0.1});
    high.summits = 1000;
    const double gaussian = std::sqrt(2 * std::log(1000.0));
    high.highest_point = 1.6 * gaussian * below;
    CHECK_FALSE(has(high, Finding::far_from_gaussian));
    high.highest_point = 1.6 * gaussian * above;
    CHECK(has(high, Finding::far_from_gaussian));
    CHECK(parts::law_findings(high).size() == 1);  // which law of peaks holds is no question then
    CHECK(parts::law_advice(parts::law_findings(high)).law == LawName::boundary_elements);
    std::erase(high.available, LawName::boundary_elements);
    CHECK(parts::law_advice(parts::law_findings(high)).law == LawName::hybrid);
}

TEST_CASE("Peaks flow above a plasticity index of 1, and a lay leaves no law") {
    Question question = at(0.003, 0.005);
    question.plasticity_index = 1;
    CHECK_FALSE(has(question, Finding::peaks_flow));
    question.plasticity_index = above;
    CHECK(parts::law_advice(parts::law_findings(question)).law == LawName::plastic);
    std::erase(question.available, LawName::plastic);
    CHECK(parts::law_advice(parts::law_findings(question)).law == LawName::plastic_peaks);
    std::erase(question.available, LawName::plastic_peaks);
    CHECK(parts::law_advice(parts::law_findings(question)).law == LawName::hybrid);
    CHECK(has(question, Finding::peaks_flow));
    question.has_lay = true;
    CHECK(parts::law_findings(question).front().finding == Finding::profile_with_lay);
    CHECK_FALSE(parts::law_advice(parts::law_findings(question)).law);
    CHECK_FALSE(has(question, Finding::hybrid_holds));
}

TEST_CASE("The scatter of one surface is that of its fewest contacts") {
    const auto scatter = [](double contacts) {
        return find(parts::law_findings(of_contacts(contacts)), Finding::few_contacts)->ratio.high - 1;
    };
    CHECK_FALSE(has(of_contacts(200), Finding::few_contacts));
    CHECK_FALSE(has(of_contacts(std::numeric_limits<double>::infinity()), Finding::few_contacts));
    for (const auto& [contacts, share] : {std::pair(200 * below, 0.07), {100 * above, 0.07}, {100, 0.11}, {40 * above, 0.11},
                                          {40, 0.16}, {15 * above, 0.16}, {15, 0.34}, {1, 0.34}})
        CHECK(std::abs(scatter(contacts) - share) < 1e-12);
    CHECK(has(of_contacts(below), Finding::no_contact));
    CHECK_FALSE(has(of_contacts(below), Finding::few_contacts));
    Question of_states;
    ContactState<double> state;
    state.pressure.value = 1e6, state.contact_density.value = 5e6;
    of_states.add_states(std::vector{state}, 1e10, 0.1, 1e-6);
    CHECK(test::relative_error(of_states.fewest_contacts, 5.0) < 1e-15);
    CHECK(test::relative_error(of_states.least_pressure, 1e-3) < 1e-15);
}

TEST_CASE("Every finding can be reached") {
    std::set<Finding> reached;
    const auto add = [&](const Question& question) {
        for (const Found& one : parts::law_findings(question)) reached.insert(one.finding);
    };
    Question flows = at(0.003, 0.3);
    flows.plasticity_index = 3;
    Question lay = flows;
    lay.has_lay = true;
    Question numbers = at(0.003, 0.3);
    numbers.available.clear();
    for (const Question& one : {flows, lay, numbers, of_contacts(0.5), of_contacts(50), of_heights({2, 0.1}, {3, 0.1}),
                                of_heights({0.5, 0.1}, {3, 0.1}), of_heights({-0.5, 0.1}, {3, 0.1}),
                                of_heights({0, 0.1}, {4.5, 0.1})})
        add(one);
    CHECK(reached.size() == static_cast<std::size_t>(Finding::no_contact) + 1);
}

TEST_CASE("recommended_law of a measured map and of numbers that are its own") {
    HeightMap<double> map = test::half_space_map("gaussian");
    map.heights = (1e-4 * map.heights).eval();
    map.dx = map.dy = 1e-4 / 256;
    MeasureOptions<double> options;
    options.neighbours = options.texture = options.dimension = false;
    options.resamples = 2;
    const Surface<double> surface = measure(map, options);
    const double E = 1e9, g = surface.rms_gradient.value;
    const auto advice = recommended_law(surface, E, std::vector{0.003 * E * g, 0.02 * E * g});
    CHECK(advice.law == LawName::hybrid);
    REQUIRE(find(advice.findings, Finding::crowded_peaks));
    CHECK(test::relative_error(find(advice.findings, Finding::crowded_peaks)->value, 0.02) < 1e-12);
    CHECK(recommended_law(surface, E, std::vector{0.003 * E * g}, 1e-3 * E * g).law == LawName::plastic);
    HeightMap<double> hole = map;
    hole.heights(20, 30) = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(recommended_law(measure(hole, options), E, std::vector{0.003 * E * g}).law);
    const auto skewed = [](double z) { return std::exp(1.5 * z); };
    map.heights = (1e-7 * (map.heights / rms_height(map)).unaryExpr(skewed)).eval();
    const auto far = recommended_law(measure(map, options), E, std::vector{0.003 * E * g});
    CHECK(far.findings.front().finding == Finding::far_from_gaussian);
    CHECK(far.law == LawName::boundary_elements);
    CHECK(test::refusal([&] { (void)recommended_law(surface, E, std::vector{-1.0}); }).find("pressure = -1") == 0);
}

}  // namespace law_findings_test
