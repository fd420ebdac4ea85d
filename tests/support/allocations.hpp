// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// How often the heap was asked for memory: the one test file of a binary that includes this replaces operator new.
#include <atomic>
#include <cstdlib>
#include <new>

namespace test {

inline std::atomic<long>& allocation_count() {
    static std::atomic<long> count{0};
    return count;
}

inline long allocations() { return allocation_count(); }

inline void* counted(std::size_t size) {
    ++allocation_count();
    if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
    throw std::bad_alloc();
}

}  // namespace test

// GCC takes the pair of malloc and free below for a mismatch once it has inlined one of them
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif

void* operator new(std::size_t size) { return test::counted(size); }
void* operator new[](std::size_t size) { return test::counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
