// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Number of heap allocations: the one test file of a binary that includes this replaces operator new.
#include <atomic>
#include <cstdlib>
#include <new>

namespace test {

inline std::atomic<long>& allocation_count() {
    static std::atomic<long> count{0};
    return count;
}

inline long allocations() { return allocation_count(); }

inline void* counted_or_null(std::size_t size) noexcept {
    ++allocation_count();
    return std::malloc(size == 0 ? 1 : size);
}

inline void* counted(std::size_t size) {
    if (void* memory = counted_or_null(size)) return memory;
    throw std::bad_alloc();
}

}  // namespace test

// GCC takes the pair of malloc and free below for a mismatch once it has inlined one of them
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif

void* operator new(std::size_t size) { return test::counted(size); }
void* operator new[](std::size_t size) { return test::counted(size); }
// else they are those of the address sanitizer, which does not take back what the operators below free
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return test::counted_or_null(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return test::counted_or_null(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
