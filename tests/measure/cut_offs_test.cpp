// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/measure/cut_offs.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <string>

namespace cut_offs_test {

using namespace fstiff;
using test::relative_error;

namespace {

/// A profile of \p points at \p step, of which cut-offs need no more.
Profile<double> line(double step, std::size_t points) { return {std::vector<double>(points), step}; }

HeightMap<double> grid(Eigen::Index rows, Eigen::Index columns, double dx, double dy) {
    return {HeightMap<double>::Array::Zero(rows, columns), dx, dy};
}

struct Case {
    const char* what;
    double step;
    std::size_t points;
    double tip, resolution;
    double index;  ///< by hand: 1, 2, 2.5, 5, 8 times powers of ten
    LambdaSReason why;
    IndexSource source;
};

/// \p message of the refusal of \p options by \p surface; empty for none.
template <class Heights>
std::string refusal(const Heights& surface, const MeasureOptions<double>& options) {
    try {
        (void)detail::choose_cut_offs(surface, options);
    } catch (const domain_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("lambda_s by the tables is the index of five steps, of the resolution or of the tip, if ten fit the length") {
    using enum LambdaSReason;
    using enum IndexSource;
    const std::vector<Case> cases{
        {"five steps are an index", 0.5e-6, 16384, 0, 0, 2.5e-6, by_table, step},
        {"2 % less step, the same index", 0.49e-6, 16384, 0, 0, 2.5e-6, by_table, step},
        {"1 % more step, the same index", 0.50042e-6, 16384, 0, 0, 2.5e-6, by_table, step},
        {"2 % more step, the next index", 0.51e-6, 16384, 0, 0, 5e-6, by_table, step},
        {"a stylus", 0.15625e-6, 9600, 0, 0, 0.8e-6, by_table, step},
        {"an atomic force microscope", 39.2e-9, 256, 0, 0, 200e-9, by_table, step},
        {"ten fit, to the last step", 0.5e-6, 51, 0, 0, 2.5e-6, by_table, step},
        {"ten are one step too long", 0.5e-6, 50, 0, 0, 2.5e-6, too_short, step},
        {"resolution below five steps", 0.5e-6, 16384, 0, 2.45e-6, 2.5e-6, by_table, step},
        {"resolution above five steps", 0.5e-6, 16384, 0, 2.55e-6, 5e-6, by_table, resolution},
        {"resolution too long", 0.5e-6, 101, 0, 7e-6, 8e-6, too_short, resolution},
        {"tip of 2 um: that of the table", 0.1e-6, 16384, 2e-6, 0, 2.5e-6, by_table, tip},
        {"tip of 5 um: that of the table", 0.5e-6, 16384, 5e-6, 0, 8e-6, by_table, tip},
        {"tip of 10 um: that of the table", 0.5e-6, 16384, 10e-6, 0, 25e-6, by_table, tip},
        {"sharp tip: 1.25 of its radius", 10e-9, 16384, 0.4e-6, 0, 0.5e-6, by_table, tip},
        {"blunt tip: 2.5 of its radius", 0.5e-6, 16384, 12e-6, 0, 50e-6, by_table, tip},
        {"a tip that the step outdoes", 2e-6, 16384, 2e-6, 0, 10e-6, by_table, step},
        {"a tip too long", 0.5e-6, 200, 12e-6, 0, 50e-6, too_short, tip}};
    for (const Case& one : cases) {
        INFO(one.what);
        const auto found =
            detail::choose_cut_offs(line(one.step, one.points), {.tip_radius = one.tip, .resolution = one.resolution});
        CHECK(relative_error(found.index, one.index) < 1e-14);
        CHECK(found.why_s == one.why);
        CHECK(found.index_source == one.source);
        CHECK(found.lambda_s.has_value() == (one.why == by_table));
        if (found.lambda_s) CHECK(*found.lambda_s == found.index);
        CHECK_FALSE(found.lambda_c);
        CHECK(found.tip_radius == one.tip);
        CHECK(found.step == one.step);
        CHECK(found.length == one.step * static_cast<double>(one.points - 1));
    }
}

TEST_CASE("lambda_s by the tables stays below a given lambda_c") {
    const auto profile = line(0.5e-6, 16384);
    const auto equal = detail::choose_cut_offs(profile, {.lambda_c = 2.5e-6});
    CHECK_FALSE(equal.lambda_s);
    CHECK(equal.why_s == LambdaSReason::not_below_lambda_c);
    CHECK(equal.lambda_c == 2.5e-6);
    CHECK(equal.why_c == CutOffReason::given);
    CHECK(detail::choose_cut_offs(profile, {.lambda_c = 2.55e-6}).lambda_s == 2.5e-6);
    const auto form = detail::choose_cut_offs(profile, {.form_cut_off = 2.5e-6});
    CHECK(form.lambda_c == 2.5e-6);
    CHECK(form.why_s == LambdaSReason::not_below_lambda_c);
}

TEST_CASE("Given cut-offs are used and none means no filter") {
    const auto profile = line(0.5e-6, 16384);
    const auto given =
        detail::choose_cut_offs(profile, {.lambda_s = 3e-6, .lambda_c = 0.3e-3, .filter = CutOffFilter::robust});
    CHECK(given.lambda_s == 3e-6);
    CHECK(given.lambda_c == 0.3e-3);
    CHECK(given.filter == CutOffFilter::robust);
    CHECK(given.why_s == LambdaSReason::given);
    CHECK(given.index == 0);
    CHECK(given.any());
    const auto none = detail::choose_cut_offs(profile, {.lambda_s = no_cut_off, .lambda_c = no_cut_off});
    CHECK_FALSE(none.any());
    CHECK(none.why_s == LambdaSReason::given);
    CHECK(none.why_c == CutOffReason::given);
    CHECK(CutOff<double>::of(std::nullopt).automatic() == false);
    CHECK(CutOff<double>::of(2e-6).length() == 2e-6);
    CHECK(CutOff<double>().automatic());
}

TEST_CASE("A given cut-off that a surface cannot hold is refused, with the bound that it misses") {
    const auto profile = line(1e-6, 101);  // 100 um
    struct Refused {
        CutOff<double> lambda_s, lambda_c;
        std::optional<detail::CutOffRefusal> why;
        bool long_waves;
        double limit;
    };
    using enum detail::CutOffRefusal;
    const std::vector<Refused> cases{{2e-6, no_cut_off, {}, false, 0},
                                     {1.96e-6, no_cut_off, below_steps, false, 2e-6},
                                     {100e-6, no_cut_off, {}, false, 0},
                                     {102e-6, no_cut_off, above_length, false, 100e-6},
                                     {-1e-6, no_cut_off, below_steps, false, 2e-6},
                                     {std::nan(""), no_cut_off, below_steps, false, 2e-6},
                                     {no_cut_off, 5e-6, {}, true, 0},
                                     {no_cut_off, 4.9e-6, below_steps, true, 5e-6},
                                     {no_cut_off, 100e-6, {}, true, 0},
                                     {no_cut_off, 102e-6, above_length, true, 100e-6},
                                     {9.9e-6, 10e-6, {}, false, 0},
                                     {10e-6, 10e-6, not_below_lambda_c, false, 10e-6},
                                     {11e-6, 10e-6, not_below_lambda_c, false, 10e-6}};
    for (const Refused& one : cases) {
        const MeasureOptions<double> options{.lambda_s = one.lambda_s, .lambda_c = one.lambda_c};
        CAPTURE(one.lambda_s.length().value_or(0), one.lambda_c.length().value_or(0));
        const auto found = detail::refused_cut_off(options, profile.spacing, profile.length());
        REQUIRE(found.has_value() == one.why.has_value());
        CHECK(refusal(profile, options).empty() == !found);
        if (!found) continue;
        CHECK(found->why == *one.why);
        CHECK(found->long_waves == one.long_waves);
        CHECK(relative_error(found->limit, one.limit) < 1e-14);
    }
    CHECK(refusal(profile, {.lambda_s = 1.96e-6}) == "lambda_s = 1.96e-06: must be at least 2 steps, 2e-06 m");
    CHECK(refusal(profile, {.lambda_s = 5e-6, .form_cut_off = 5e-6}) ==
          "lambda_s = 5e-06: must be less than lambda_c, 5e-06 m");
}

TEST_CASE("A map has a lambda_s of its coarser step and shorter side, and no lambda_c") {
    const auto found = detail::choose_cut_offs(grid(300, 400, 0.1e-6, 0.3e-6));
    CHECK(found.lambda_s == 2e-6);                       // five of 0.3 um
    CHECK(relative_error(found.length, 40e-6) < 1e-14);  // 400 of 0.1 um, shorter than 300 of 0.3
    CHECK_FALSE(found.lambda_c);
    CHECK(found.why_c == CutOffReason::form_alone);
    const auto narrow = detail::choose_cut_offs(grid(300, 197, 0.1e-6, 0.3e-6));  // 19.7 um
    CHECK(narrow.why_s == LambdaSReason::too_short);
    CHECK(detail::choose_cut_offs(grid(300, 200, 0.1e-6, 0.3e-6)).lambda_s == 2e-6);
    CHECK(detail::choose_cut_offs(grid(300, 400, 0.1e-6, 0.3e-6), {.lambda_c = no_cut_off}).why_c ==
          CutOffReason::given);
    CHECK_FALSE(refusal(grid(300, 400, 0.1e-6, 0.3e-6), {.form_cut_off = 5e-6}).empty());
}

TEST_CASE("The neighbours of lambda_s are a factor of two apart, and one alone where the surface holds no shorter") {
    const auto both = detail::neighbouring_lambda_s<double>(8e-6, 1e-6);
    REQUIRE(both.size() == 2);
    CHECK(relative_error(both[0] * both[1], 64e-12) < 1e-14);
    CHECK(relative_error(both[1] / both[0], 2.0) < 1e-14);
    CHECK(both[0] < 8e-6);
    CHECK(detail::neighbouring_lambda_s<double>(2.83e-6, 1e-6).size() == 2);
    CHECK(detail::neighbouring_lambda_s<double>(2.82e-6, 1e-6) == std::vector{5.64e-6});
    CHECK(detail::neighbouring_lambda_s<double>(std::nullopt, 1e-6) == std::vector{4e-6});
}

}  // namespace cut_offs_test
