// SPDX-License-Identifier: BSD-3-Clause
// Status, messages and the version.
#include "actions/one_contact.hpp"
#include "c/guard.hpp"

#include <fstiff/core/version.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>

namespace fstiff::c {
namespace {

thread_local std::array<char, 4096> message{};  // reports a lack of memory without allocating

}  // namespace

void set_message(std::string_view text) noexcept {
    const std::size_t length = std::min(text.size(), message.size() - 1);
    std::copy_n(text.data(), length, message.data());
    message[length] = '\0';
}

int status_of_exception() noexcept {
    const auto is = [](int status, std::string_view text) {
        set_message(text);
        return status;
    };
    try {
        throw;
    } catch (const argument_error& error) {
        return is(FSTIFF_BAD_ARGUMENT, error.what());
    } catch (const actions::no_such_entry& error) {
        return is(FSTIFF_BAD_ARGUMENT, error.what());
    } catch (const domain_error& error) {
        return is(FSTIFF_REFUSED, error.what());
    } catch (const file_error& error) {
        return is(FSTIFF_FILE, error.what());
    } catch (const std::bad_alloc&) {
        return is(FSTIFF_OUT_OF_MEMORY, "there is not enough memory");
    } catch (const std::length_error&) {
        return is(FSTIFF_OUT_OF_MEMORY, "an array does not fit into memory");
    } catch (const std::exception& error) {
        return is(FSTIFF_INTERNAL, error.what());
    } catch (...) {
        return is(FSTIFF_INTERNAL, "an exception without a message");
    }
}

void refuse_null(const char* name) { throw argument_error(std::string(name) + ": must not be NULL"); }

void refuse_size(const char* name, std::size_t size, std::size_t first, std::size_t now) {
    throw argument_error(std::string(name) + "->size = " + std::to_string(size) + ": must be " +
                         (first < now ? std::to_string(first) + " to " : "") + std::to_string(now) +
                         ", its sizeof in fstiff.h up to version " FSTIFF_VERSION_TEXT);
}

void refuse_argument(const char* name, long long value, const char* allowed) {
    throw argument_error(std::string(name) + " = " + std::to_string(value) + ": must be " + allowed);
}

void require_array(const double* array, std::size_t count, const char* name) {
    not_null(array, name);
    if (count == 0) throw argument_error(std::string(name) + ": must have at least one number");
    constexpr std::size_t most = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(double);
    if (count > most) throw argument_error(std::string(name) + ": must fit into memory");
}

int text_into(const std::string& text, char* buffer, std::size_t capacity, std::size_t* length) {
    not_null(length, "length") = text.size();
    if (!buffer && capacity == 0) return FSTIFF_OK;
    not_null(buffer, "buffer");
    if (capacity <= text.size())
        throw argument_error("capacity = " + std::to_string(capacity) + ": must be at least " +
                             std::to_string(text.size() + 1));
    std::memcpy(buffer, text.c_str(), text.size() + 1);
    return FSTIFF_OK;
}

}  // namespace fstiff::c

const char* fstiff_version() { return FSTIFF_VERSION_TEXT; }

const char* fstiff_strerror(int status) {
    switch (status) {
        case FSTIFF_OK: return "no error";
        case FSTIFF_BAD_ARGUMENT: return "an argument is null, empty or of the wrong size";
        case FSTIFF_REFUSED: return "a value or a text is not allowed";
        case FSTIFF_OUT_OF_REACH: return "the model has no state there";
        case FSTIFF_OUT_OF_NUMBERS: return "a result is beyond the range of double";
        case FSTIFF_FILE: return "a file cannot be read";
        case FSTIFF_OUT_OF_MEMORY: return "out of memory";
        case FSTIFF_INTERNAL: return "an internal error of fstiff";
        default: return "unknown status";
    }
}

const char* fstiff_last_message() { return fstiff::c::message.data(); }
