// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A case that cannot run here (no Chromium, no measured surfaces, ...) shows as skipped, never as passed: the case
// prints a line that begins with "SKIPPED:", which CTest looks for (SKIP_REGULAR_EXPRESSION in tests/CMakeLists.txt). A
// case that has failed prints none, because CTest would call it skipped. Catch2 2 has no SKIP, so the line is ours with
// Catch2 3 too.
#include "support/catch.hpp"

#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#endif

#include <iostream>
#include <string>
#include <vector>

namespace test {

/// Parts that the running case has left out.
inline std::vector<std::string>& left_out() {
    static std::vector<std::string> reasons;
    return reasons;
}

/// Notes that a part of the running case is not tested, and why; the case goes on.
inline void leave_out(const std::string& reason) { left_out().push_back(reason); }

#if __has_include(<catch2/catch_test_macros.hpp>)
using ListenerBase = Catch::EventListenerBase;
#else
using ListenerBase = Catch::TestEventListenerBase;
#endif

}  // namespace test

namespace {

/// Every file that includes this registers one: the first to see the end of a case prints, the others find nothing
/// left.
struct SkipListener : test::ListenerBase {
    using test::ListenerBase::ListenerBase;
    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        if (stats.totals.assertions.failed == 0)
            for (const std::string& reason : test::left_out()) std::cout << "SKIPPED: " << reason << std::endl;
        test::left_out().clear();
    }
};

CATCH_REGISTER_LISTENER(SkipListener)

}  // namespace

/// Ends the running case, which then is skipped. In the body of a TEST_CASE.
#ifdef SKIP
#define SKIP_CASE(reason)        \
    do {                         \
        test::leave_out(reason); \
        SKIP(reason);            \
    } while (false)
#else
#define SKIP_CASE(reason)        \
    do {                         \
        test::leave_out(reason); \
        return;                  \
    } while (false)
#endif
