// SPDX-License-Identifier: BSD-3-Clause
// Truth: bands, shares and scatter worked by hand; both sides of every limit at which another law answers.
#include <fstiff/answer/law_choice.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <set>

namespace answer_test {

using namespace fstiff;
using detail::AnswerQuestion;
using test::relative_error;

namespace {

const std::vector<LawKind> of_map{LawKind::hybrid, LawKind::boundary_elements, LawKind::plastic, LawKind::hertz};

LawKind answers(std::vector<LawKind> available, double points_in_contact) {
    return detail::answering_law<double>({.available = std::move(available), .points_in_contact = points_in_contact});
}

double& low_of(Causes<double>& causes, Cause cause) { return causes[static_cast<std::size_t>(cause)].low; }
double& high_of(Causes<double>& causes, Cause cause) { return causes[static_cast<std::size_t>(cause)].high; }

}  // namespace

TEST_CASE("Boundary elements answer from 20 points in contact, where they are available") {
    const double unknown = std::numeric_limits<double>::quiet_NaN(), below = std::nextafter(20.0, 0.0);
    CHECK(answers(of_map, 20) == LawKind::boundary_elements);
    CHECK(answers(of_map, 1e5) == LawKind::boundary_elements);
    for (const double points : {below, 0.0, unknown}) CHECK(answers(of_map, points) != LawKind::boundary_elements);
    CHECK(answers({LawKind::hybrid}, 1e5) == LawKind::hybrid);
}

TEST_CASE("Plastic answers wherever it can, as it needs a hardness, and hybrid elsewhere") {
    CHECK(answers(of_map, 0) == LawKind::plastic);
    CHECK(answers({LawKind::hertz, LawKind::hybrid}, 0) == LawKind::hybrid);
}

TEST_CASE("Peaks alone are answered by Hertz or Greenwood and Williamson, and no surface by no law") {
    CHECK(answers({LawKind::greenwood_williamson, LawKind::hertz}, 0) == LawKind::hertz);
    CHECK(answers({LawKind::greenwood_williamson}, 0) == LawKind::greenwood_williamson);
    for (const std::vector<LawKind>& none : {std::vector<LawKind>{}, {LawKind::fractal}, {LawKind::boundary_elements}})
        CHECK_THROWS_AS(answers(none, 0), domain_error);
}

TEST_CASE("Causes of a band add by squares, each side by itself") {
    Causes<double> causes{};
    CHECK(detail::band_of(causes).low == 0);
    CHECK(detail::band_of(causes).high == 0);
    for (const double share : shares_of(causes)) CHECK(share == 0);
    low_of(causes, Cause::law) = -0.3, high_of(causes, Cause::law) = 0.12;
    low_of(causes, Cause::cut_offs) = -0.4, high_of(causes, Cause::cut_offs) = 0.05;
    high_of(causes, Cause::lay) = 3;
    const auto whole = detail::band_of(causes);
    CHECK(relative_error(whole.low, -0.5) < 1e-15);
    CHECK(relative_error(whole.high, std::sqrt(9.0169)) < 1e-15);
    const auto shares = shares_of(causes);
    const double all = 0.09 + 0.16 + 9.0169;
    CHECK(relative_error(shares[static_cast<std::size_t>(Cause::law)], (0.09 + 0.0144) / all) < 1e-14);
    CHECK(relative_error(shares[static_cast<std::size_t>(Cause::lay)], 9 / all) < 1e-14);
    CHECK(shares[static_cast<std::size_t>(Cause::contacts)] == 0);
    double sum = 0;
    for (const double share : shares) sum += share;
    CHECK(relative_error(sum, 1.0) < 1e-15);
}

TEST_CASE("K of a single surface scatters by 0.77 over the root of its contacts") {
    // one standard deviation at 100, 40, 15 and 5 contacts, as maps by seed gave them
    for (const auto& [contacts, percent] : {std::pair{100.0, 7.7}, {40.0, 11.0}, {15.0, 20.0}, {5.0, 36.0}}) {
        const auto spread = detail::scatter_of_contacts(contacts);
        CHECK(relative_error(spread.high / 1.6448536269514722, percent / 100) < 0.12);
        CHECK(spread.low == -spread.high);
    }
    CHECK(relative_error(detail::scatter_of_contacts(100.0).high, 0.126653729275263) < 1e-14);
    CHECK(detail::scatter_of_contacts(0.01).high == detail::scatter_of_contacts(1.0).high);
    CHECK(detail::scatter_of_contacts(4.0).high == detail::scatter_of_contacts(1.0).high / 2);
    CHECK(detail::scatter_of_contacts(1e300).high < 1e-149);
}

TEST_CASE("Every cause has a word of its own") {
    std::set<std::string_view> words;
    for (std::size_t i = 0; i < detail::cause_count; ++i) words.insert(name_of(static_cast<Cause>(i)));
    CHECK(words.size() == detail::cause_count);
    CHECK(name_of(Cause::measurement) == "measurement");
    CHECK(name_of(Cause::cut_offs) == "cut_offs");
    CHECK(name_of(Cause::long_waves) == "long_waves");
}

}  // namespace answer_test
