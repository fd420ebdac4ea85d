// SPDX-License-Identifier: BSD-3-Clause
// Structure functions made of pieces: the window is the piece with a power law, and has the reason of its ends.
#include <fstiff/profile/lag_window.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace lag_window_test {

using namespace fstiff;

namespace {

/// ln S2 of 10000 points with slope \p short_slope below lag \p bend, \p long_slope above.
detail::LogStructure<double> bent(double short_slope, double long_slope, double bend) {
    StructureFunction<double> s;
    for (const std::size_t n : detail::logarithmic_lags(2500)) {
        const double x = static_cast<double>(n) / bend;
        s.step.push_back(n);
        s.lag.push_back(static_cast<double>(n) * 1e-6);
        s.value.push_back(1e-16 * std::pow(x, x < 1 ? short_slope : long_slope));
        s.pairs.push_back(10000 - n);
    }
    return detail::log_structure<double>(s, 1e-6, 10000, {});
}

std::size_t lag(const detail::LogStructure<double>& log, Eigen::Index k) {
    return log.step[static_cast<std::size_t>(k)];
}

}  // namespace

TEST_CASE("The local slope of a power law is its power") {
    const auto log = bent(0.9, 0.9, 1);
    for (const double slope : log.slope) CHECK(std::abs(slope - 0.9) < 1e-12);
    CHECK(log.shortest() == 4);
    CHECK(log.longest() == 1000);
}

TEST_CASE("A power law throughout gives all the lags that are searched") {
    const auto log = bent(0.9, 0.9, 1);
    const auto chosen = detail::automatic_range<double>(log, 1e-6, {});
    CHECK(lag(log, chosen.range.first) == 4);
    CHECK((lag(log, chosen.range.last) <= 1000 && lag(log, chosen.range.last + 1) > 1000));
    CHECK(chosen.tolerance == 0.2);
    CHECK(detail::why_there(log, chosen.range, chosen.range.first - 1, WindowEnd::sampling) == WindowEnd::sampling);
    CHECK(detail::why_there(log, chosen.range, chosen.range.last + 1, WindowEnd::length) == WindowEnd::length);
}

TEST_CASE("The window ends where S saturates, becomes smooth, or bends") {
    struct Piece {
        double short_slope, long_slope, bend;
        WindowEnd begins, ends;
    };
    for (const Piece& piece : {Piece{0.4, 0.0, 300, WindowEnd::sampling, WindowEnd::bend},
                               Piece{3.5, 1.75, 20, WindowEnd::smooth, WindowEnd::length},
                               Piece{0.9, 0.35, 300, WindowEnd::sampling, WindowEnd::bend}}) {
        const auto log = bent(piece.short_slope, piece.long_slope, piece.bend);
        const auto chosen = detail::automatic_range<double>(log, 1e-6, {});
        CAPTURE(piece.short_slope, piece.long_slope, lag(log, chosen.range.first), lag(log, chosen.range.last));
        CHECK(detail::why_there(log, chosen.range, chosen.range.first - 1, WindowEnd::sampling) == piece.begins);
        CHECK(detail::why_there(log, chosen.range, chosen.range.last + 1, WindowEnd::length) == piece.ends);
        CHECK_FALSE(chosen.after_plateau);
    }
}

TEST_CASE("After a plateau there is a window only where none is before it") {
    const auto log = bent(0.0, 0.9, 20);
    const auto chosen = detail::automatic_range<double>(log, 1e-6, {});
    CHECK(chosen.after_plateau);
    CHECK(lag(log, chosen.range.first) >= 15);
}

TEST_CASE("A window stays away from where its power law would reach the highest value") {
    const auto log = bent(0.9, 0.0, 300);
    const auto chosen = detail::automatic_range<double>(log, 1e-6, {});
    CHECK(static_cast<double>(lag(log, chosen.range.last)) < 300 / 1.5 * 1.1);  // 0.05 of ln S2 for its scatter
    CHECK(static_cast<double>(lag(log, chosen.range.last)) > 300 / 1.5 / 1.1);
}

TEST_CASE("A slope that may be chance does not end a window") {
    auto log = bent(0.9, 0.9, 1);
    for (Eigen::Index k = 0; k < log.lag.size(); ++k)
        if (lag(log, k) > 100) log.slope[k] = k % 2 == 0 ? 0.5 : 1.3;
    CHECK(lag(log, detail::automatic_range<double>(log, 1e-6, {}).range.last) <= 100);
    log.slope_error = detail::Vector<double>::Constant(log.lag.size(), 0.25);
    CHECK(lag(log, detail::automatic_range<double>(log, 1e-6, {}).range.last) > 900);
}

TEST_CASE("A window that was given holds the lags between its ends") {
    const auto log = bent(0.9, 0.9, 1);
    const auto chosen = detail::given_range<double>(log, {10e-6, 100e-6}, 1e-6, {});
    CHECK((lag(log, chosen.range.first) >= 10 && lag(log, chosen.range.first - 1) < 10));
    CHECK((lag(log, chosen.range.last) <= 100 && lag(log, chosen.range.last + 1) > 100));
    const auto held = std::count_if(log.step.begin(), log.step.end(), [](auto n) { return n >= 10 && n <= 30; });
    const auto refusal = test::refusal([&] { (void)detail::given_range<double>(log, {10e-6, 30e-6}, 1e-6, {}); });
    CHECK(refusal == "window = 1e-05 m to 3e-05 m: holds " + std::to_string(held) +
                         " lags; must hold at least 4 and half a decade, between 1e-06 m and 0.009999 m");
}

TEST_CASE("Lags below the resolution are left out and the message reports it") {
    detail::ReliableLags<double> reliable{4e-6, WindowEnd::resolution};
    CHECK(reliable.holds(4e-6));
    CHECK_FALSE(reliable.holds(3e-6));
    CHECK(reliable.note(1e-3) == "; lags below 4e-06 m are left out for the resolution");
    reliable = {2e-3, WindowEnd::tip};
    CHECK(reliable.note(1e-3) == "; lags below any of this profile are left out for the tip radius");
    reliable = {4e-6, WindowEnd::lambda_s};
    CHECK(reliable.note(1e-3) == "; lags below 4e-06 m are left out for lambda_s");
    CHECK(detail::ReliableLags<double>{}.note(1e-3).empty());
}

}  // namespace lag_window_test
