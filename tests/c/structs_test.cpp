// SPDX-License-Identifier: BSD-3-Clause
// Structs of fstiff.h may grow: a program keeps the size that its own fstiff.h had.
#include "c/guard.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cstddef>

namespace {

/// A struct of the first version, and the same with a member more.
struct Old {
    std::size_t size;
    double first;
};
struct Grown {
    std::size_t size;
    double first, second;
};

}  // namespace

namespace fstiff::c {
template <>
inline constexpr std::size_t first_size<Grown> = sizeof(Old);
}  // namespace fstiff::c

namespace structs_test {

using fstiff::c::argument_error, fstiff::c::first_size, fstiff::c::give, fstiff::c::sized, fstiff::c::taken;

/// Memory of an old program, and the bytes beyond it.
struct Memory {
    Old old{sizeof(Old), 1};
    double beyond = 7;
    Grown* as_grown() { return reinterpret_cast<Grown*>(&old); }
};

TEST_CASE("a struct of an older program has 0 where it has no member", "[c]") {
    Memory memory;
    const Grown known = taken(memory.as_grown(), "it");
    CHECK(known.size == sizeof(Grown));
    CHECK(known.first == 1);
    CHECK(known.second == 0);
}

TEST_CASE("nothing is written beyond the struct of an older program", "[c]") {
    Memory memory;
    give({.size = 0, .first = 2, .second = 3}, *memory.as_grown());
    CHECK(memory.old.size == sizeof(Old));
    CHECK(memory.old.first == 2);
    CHECK(memory.beyond == 7);
}

TEST_CASE("a struct of today is taken and given whole", "[c]") {
    Grown grown{sizeof(Grown), 1, 2};
    CHECK(taken(&grown, "it").second == 2);
    give({.size = 0, .first = 3, .second = 4}, grown);
    CHECK(grown.size == sizeof(Grown));
    CHECK(grown.second == 4);
}

TEST_CASE("a size that no version had is refused", "[c]") {
    for (const std::size_t size : {std::size_t{0}, sizeof(Old) - 8, sizeof(Old) + 1, sizeof(Grown) + 8}) {
        Grown grown{size, 1, 2};
        CHECK_THROWS_AS(sized(&grown, "it"), argument_error);
    }
    Grown grown{8, 1, 2};
    CHECK(test::refusal([&] { sized(&grown, "it"); }).starts_with("it->size = 8: must be 16 to 24, "));
}

// Sizes where doubles, pointers and size_t have 8 bytes. These numbers never change.
TEST_CASE("the sizes of version 0.1 are taken", "[c]") {
    if (sizeof(void*) != 8) return;
    CHECK(first_size<fstiff_face> == 216);
    CHECK(first_size<fstiff_solid> == 32);
    CHECK(first_size<fstiff_joint> == 160);
    CHECK(first_size<fstiff_answer_points> == 96);
    CHECK(first_size<fstiff_points> == 72);
    CHECK(first_size<fstiff_law_facts> == 56);
    CHECK(first_size<fstiff_slip> == 408);
    CHECK(first_size<fstiff_measure_options> == 80);
    CHECK(first_size<fstiff_surface> == 304);
    CHECK(first_size<fstiff_heights> == 48);
    CHECK(first_size<fstiff_measured_curve> == 48);
}

}  // namespace structs_test
