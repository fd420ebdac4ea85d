// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What every function of fstiff.h does: check its pointers and sizes, and turn whatever is thrown into a status.

#include <fstiff.h>

#include <fstiff/core/error.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

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
[[noreturn, gnu::cold]] void refuse_size(const char* name, std::size_t found, std::size_t expected);
[[noreturn, gnu::cold]] void refuse_argument(const char* name, long long value, const char* allowed);

template <class T>
T& not_null(T* pointer, const char* name) {
    if (!pointer) [[unlikely]]
        refuse_null(name);
    return *pointer;
}
/// A struct of fstiff.h, which begins with its size.
template <class T>
T& sized(T* pointer, const char* name) {
    if (not_null(pointer, name).size != sizeof(T)) refuse_size(name, pointer->size, sizeof(T));
    return *pointer;
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
/// To where a result is wanted.
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
