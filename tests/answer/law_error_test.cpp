// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/answer/law_errors.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <limits>

namespace law_error_test {

using namespace fstiff;
using detail::KnownAs;
using detail::law_error;

using Question = detail::LawErrorQuestion<double>;

/// The error of the law of \p question for heights of this skewness and kurtosis.
CauseSpread<double> of_shape(Question question, Measurement<double> skewness, Measurement<double> kurtosis) {
    question.skewness = skewness, question.kurtosis = kurtosis;
    return law_error(question);
}

TEST_CASE("The error of a law is its table at the pressures of the table, and between its neighbours elsewhere") {
    for (const auto& [law, name] : enum_names<LawKind>)
        for (const KnownAs known : {KnownAs::map, KnownAs::trace, KnownAs::numbers, KnownAs::height}) {
            CAPTURE(name, static_cast<int>(known));
            const detail::LawErrorRow row = detail::law_error_row(law, known);
            for (std::size_t i = 0; i < row.low.size(); ++i) {
                const double p = detail::law_error_pressures[i];
                const auto error = law_error<double>(Question{.law = law, .known = known, .p_star = p});
                CHECK(test::relative_error(error.low, -row.low[i] / 100.0) < 1e-14);
                CHECK(test::relative_error(error.high, row.high[i] / 100.0) < 1e-14);
                CHECK(row.low[i] > 0);
                CHECK(row.high[i] > 0);
                if (i == 0) continue;
                const double middle = std::sqrt(p * detail::law_error_pressures[i - 1]);
                const auto between = law_error<double>(Question{.law = law, .known = known, .p_star = middle});
                CHECK(test::relative_error(between.low, -(row.low[i - 1] + row.low[i]) / 200.0) < 1e-12);
                CHECK(test::relative_error(between.high, (row.high[i - 1] + row.high[i]) / 200.0) < 1e-12);
            }
        }
}

TEST_CASE("The error of a law grows beyond its table without a step, and is the widest where p* is not known") {
    Question question{.law = LawKind::hybrid, .known = KnownAs::map};
    const auto at = [&question](double p) {
        question.p_star = p;
        return law_error(question);
    };
    CHECK(test::relative_error(at(0.25 * (1 + 1e-9)).low, at(0.25).low) < 1e-8);
    CHECK(test::relative_error(at(3e-4 * (1 - 1e-9)).high, at(3e-4).high) < 1e-8);
    CHECK(test::relative_error(at(0.25 * std::exp(1)).low, 2 * at(0.25).low) < 1e-12);
    CHECK(test::relative_error(at(3e-4 / 4).high, 2 * at(3e-4).high) < 1e-12);
    CHECK(at(1e300).high == 3);
    CHECK(at(0).low == -3);
    const auto unknown = at(std::numeric_limits<double>::quiet_NaN());
    for (const double p : detail::law_error_pressures) {
        CHECK(unknown.low <= at(p).low);
        CHECK(unknown.high >= at(p).high);
    }
}

TEST_CASE("Waves as long as a map widen the error of its laws, and add nothing to that of a trace") {
    for (const KnownAs known : {KnownAs::map, KnownAs::trace}) {
        Question question{.law = LawKind::boundary_elements, .known = known, .p_star = 0.01};
        const auto without = law_error(question);
        question.long_waves = 0.2;
        const auto with = law_error(question);
        const double of_waves = known == KnownAs::map ? 0.8 * 0.2 : 0;
        CHECK(test::relative_error(with.low, -std::hypot(without.low, of_waves)) < 1e-14);
        CHECK(test::relative_error(with.high, std::hypot(without.high, of_waves)) < 1e-14);
    }
}

TEST_CASE(
    "Heights that are far from Gaussian widen the error of traces and numbers at both ends, and not that of maps") {
    for (const KnownAs known : {KnownAs::trace, KnownAs::numbers}) {
        Question question{.law = LawKind::hybrid, .known = known, .p_star = 0.01};
        const auto plain = law_error(question);
        const auto of = [&](double skewness, double kurtosis) {
            return of_shape(question, {skewness, 0.1}, {kurtosis, 0.2});
        };
        const bool trace = known == KnownAs::trace;
        const double low = trace ? 0.6 : 0.78, high = trace ? 0.6 : 0.45;  // at this p*
        const auto check = [&](double skewness, double kurtosis, double m) {
            CAPTURE(trace, skewness, kurtosis);
            const auto error = of(skewness, kurtosis);
            CHECK(test::relative_error(error.low, -std::hypot(plain.low, m * low)) < 1e-14);
            CHECK(test::relative_error(error.high, std::hypot(plain.high, m * high)) < 1e-14);
        };
        check(0, 3, 0);
        check(0.3, 3.4, 0.5);
        check(-0.3, 2.6, 0.5);
        check(-0.6, 3.8, 1);
        check(2, 9, 1);
    }
    // a known alpha narrows that of numbers at the heaviest loads
    Question heavy{.law = LawKind::hybrid, .known = KnownAs::numbers, .p_star = 0.25};
    const auto open = of_shape(heavy, {1, 0.1}, {5, 0.2});
    heavy.alpha_known = true;
    CHECK(of_shape(heavy, {1, 0.1}, {5, 0.2}).high < 0.9 * open.high);
    heavy.p_star = 0.1;
    const auto known = of_shape(heavy, {1, 0.1}, {5, 0.2});
    heavy.alpha_known = false;
    CHECK(known.high == of_shape(heavy, {1, 0.1}, {5, 0.2}).high);
    const Question map{.law = LawKind::hybrid, .known = KnownAs::map, .p_star = 0.01};
    CHECK(of_shape(map, {1, 0.1}, {5, 0.2}).low == law_error(map).low);
}

TEST_CASE("Heights that are far from Gaussian widen plastic numbers by rows of their own at p/H") {
    // H/(E g) = 1e-3: hybrid has 4e-6 of the square; p/H = 0.01, 0.03 and 0.25, and less than the table has
    Question question{.law = LawKind::plastic, .known = KnownAs::numbers, .p_star = 1e-5, .hardness = 1e-3};
    for (const auto& [share, low, high] :
         {std::array{1e-2, 0.94, 0.46}, {3e-2, 0.94, 0.46}, {0.25, 0.52, 0.0}, {3e-4, 1.3, 0.46}, {1e-4, 1.3, 0.46}}) {
        question.p_star = share * question.hardness;
        const auto plain = law_error(question);
        CAPTURE(share);
        for (const bool alpha_known : {false, true}) {
            question.alpha_known = alpha_known;
            const auto half = of_shape(question, {0.3, 0.1}, {3.4, 0.2}), all = of_shape(question, {-1, 0.1}, {5, 0.2});
            CHECK(test::relative_error(half.low, -std::hypot(plain.low, low / 2)) < 1e-4);
            CHECK(test::relative_error(half.high, std::hypot(plain.high, high / 2)) < 1e-4);
            CHECK(test::relative_error(all.low, -std::hypot(plain.low, low)) < 1e-4);
            CHECK(test::relative_error(all.high, std::hypot(plain.high, high)) < 1e-4);
        }
    }
    // a shape that is not known has the rows of elastic peaks, at p/H
    question.p_star = 1e-5, question.shape_known = question.alpha_known = false;
    const auto plain = law_error(question), open = of_shape(question, {-1, 0.1}, {5, 0.2});
    CHECK(test::relative_error(open.low, -std::hypot(plain.low, 0.78)) < 1e-4);
    CHECK(test::relative_error(open.high, std::hypot(plain.high, 0.45)) < 1e-4);
    question.shape_known = true;
    // that of hybrid at p* for a great H; of a trace the row is the same at p* and p/H
    question.p_star = 0.03, question.hardness = 1e4, question.alpha_known = false;
    const auto hard = of_shape(question, {-1, 0.1}, {5, 0.2});
    question.law = LawKind::hybrid;
    CHECK(test::relative_error(hard.low, of_shape(question, {-1, 0.1}, {5, 0.2}).low) < 1e-4);
    question = {.law = LawKind::plastic, .known = KnownAs::trace, .p_star = 1e-4, .hardness = 1e-3};
    const auto trace = law_error(question), shaped = of_shape(question, {-1, 0.1}, {5, 0.2});
    CHECK(test::relative_error(shaped.high, std::hypot(trace.high, 0.6)) < 1e-12);
}

TEST_CASE("The error of plastic is that of p/H, does not grow where K goes as p/H, and that of hybrid for a great H") {
    Question question{.law = LawKind::plastic, .known = KnownAs::numbers, .p_star = 1e-6, .hardness = 1e-4};
    const detail::LawErrorRow row = detail::law_error_row(LawKind::plastic, KnownAs::numbers);
    // hybrid has the part 4 (H/(E g))^2 of the square, and its own error grows below the least p*
    CHECK(test::relative_error(law_error(question).high, row.high[3] / 100.0) < 1e-4);
    question.hardness = 1e-5;
    CHECK(test::relative_error(law_error(question).low, -row.low[5] / 100.0) < 1e-6);
    question.p_star = 9.5e-6;
    CHECK(test::relative_error(law_error(question).low, -row.low[6] / 100.0) < 1e-6);
    question.p_star = 1e-12;
    const auto least = law_error(question);
    CHECK(test::relative_error(least.high, std::sqrt(2.0) * row.high[0] / 100) < 3e-2);
    question = {.law = LawKind::plastic, .known = KnownAs::numbers, .p_star = 0.1, .hardness = 1e4};
    const double hard = law_error(question).high;
    question.law = LawKind::hybrid;
    const double of_hybrid = law_error(question).high;
    CHECK(test::relative_error(hard, of_hybrid) < 1e-6);
    question.hardness = 0.1;
    CHECK(law_error(question).high == of_hybrid);
    // half of the squares of either at H/(E g) = 1/2
    question = {.law = LawKind::plastic, .known = KnownAs::numbers, .p_star = 0.005, .hardness = 0.5};
    const detail::LawErrorRow elastic = detail::law_error_row(LawKind::hybrid, KnownAs::numbers);
    const double at_half = detail::at_pressure(elastic.high, 0.005);
    CHECK(test::relative_error(law_error(question).high, std::hypot(row.high[3] / 100.0, at_half) / std::sqrt(2.0)) <
          1e-12);
}

}  // namespace law_error_test
