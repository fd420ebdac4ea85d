// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Catch2 3 where it is installed, else Catch2 2: the tests use their common part.
// With this an exception from an assertion ends its case. It spares a seventh of what the tests cost to compile.
#define CATCH_CONFIG_FAST_COMPILE
#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#else
#define CATCH_CONFIG_EXTERNAL_INTERFACES  // the base of listeners, for support/skip.hpp
#include <catch2/catch.hpp>
#undef CHECK_THAT  // of Catch2 3 these are in a header of their own, which costs time in every test
#undef REQUIRE_THAT
#undef CHECK_THROWS_WITH
#undef REQUIRE_THROWS_WITH
#undef CHECK_THROWS_MATCHES
#undef REQUIRE_THROWS_MATCHES
#endif

// The scalars of a case that only the tests labelled `more` run in both (tests/CMakeLists.txt).
#ifdef FSTIFF_MORE_TESTS
#define FSTIFF_SCALARS float, double
#else
#define FSTIFF_SCALARS double
#endif
