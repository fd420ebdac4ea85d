// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Guards of every function of fstiff.h: they check its pointers and sizes, and turn every exception into a status.

#include <fstiff.h>

#include <fstiff/core/error.hpp>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace fstiff::c {

/// An argument that no value could have: a null pointer, a wrong size, an index.
class argument_error : public domain_error {
public:
    using domain_error::domain_error;
};

/// Keeps \p text for fstiff_last_message(); a long one is cut.
void set_message(std::string_view text) noexcept;
/// The status of the exception that is being handled, whose sentence becomes the message.
[[gnu::cold]] int status_of_exception() noexcept;

/// Runs \p body, which returns a status.
template <class Body>
int guarded(const Body& body) noexcept {
    try {
        return body();
    } catch (...) {
        return status_of_exception();
    }
}

[[noreturn, gnu::cold]] void refuse_null(const char* name);
[[noreturn, gnu::cold]] void refuse_size(const char* name, std::size_t size, std::size_t first, std::size_t now);
[[noreturn, gnu::cold]] void refuse_argument(const char* name, long long value, const char* allowed);

template <class T>
T& not_null(T* pointer, const char* name) {
    if (!pointer) [[unlikely]]
        refuse_null(name);
    return *pointer;
}

/// sizeof(T) in the first fstiff.h that had T. A struct that grows, always at its end, has a specialisation with the
/// number of then: a program that was compiled before goes on working.
template <class T>
inline constexpr std::size_t first_size = sizeof(T);
template <>
inline constexpr std::size_t first_size<fstiff_answer_points> = offsetof(fstiff_answer_points, key_count);

/// A struct of the caller, which begins with its size.
template <class T>
T& sized(T* pointer, const char* name) {
    const std::size_t size = not_null(pointer, name).size;
    if (size < first_size<std::remove_const_t<T>> || size > sizeof(T) || size % alignof(T) != 0)
        refuse_size(name, size, first_size<std::remove_const_t<T>>, sizeof(T));
    return *pointer;
}
/// A struct of the caller in the layout of this version: members that its fstiff.h did not have are 0.
template <class T>
T taken(const T* pointer, const char* name) {
    T known{};
    std::memcpy(&known, pointer, sized(pointer, name).size);
    known.size = sizeof known;
    return known;
}
/// Gives \p known to the struct \p to, which sized() has passed, as far as that goes; its size stays.
template <class T>
void give(T known, T& to) {
    known.size = to.size;
    std::memcpy(&to, &known, to.size);
}

/// \throws argument_error for an array that is null, empty or longer than memory.
void require_array(const double* array, std::size_t count, const char* name);

/// Whether results may be handed on: those that are no numbers are refused like those that the law has not.
inline int handed_on(bool finite) {
    if (finite) [[likely]]
        return FSTIFF_OK;
    set_message("a result is beyond the range of double");
    return FSTIFF_OUT_OF_NUMBERS;
}
int all_finite(auto... results) { return handed_on((std::isfinite(results) && ...)); }
/// Destination of a result.
inline void put(double* to, double value) {
    if (to) *to = value;
}

/// \p text and its closing 0 into a buffer of the caller, as fstiff_law_text() describes it.
int text_into(const std::string& text, char* buffer, std::size_t capacity, std::size_t* length);

/// Runs \p make and gives what it returns, a handle, to \p made.
template <class T, class Make>
int made_by(T** made, const Make& make) noexcept {
    if (made) *made = nullptr;
    return guarded([&] {
        not_null(made, "made");
        *made = make();
        return FSTIFF_OK;
    });
}

}  // namespace fstiff::c
