// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The two exceptions of fstiff, and the one way to refuse a value.
///
///     domain_error    an argument or a datum that the model or the method does not allow
///     file_error      a file that cannot be opened, read or written
///
/// Arguments are checked at the public border only. An exception has fields (parameter, value, what is allowed, place
/// in a file), and its sentence is composed from them. A command can print it, or add a place or the name of one of its
/// options:
///
///     <file>, line <line>: <key>: <parameter> = <value>: must be <allowed>
///
/// A field that is empty is left out.

#include <fstiff/core/config.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/core/text.hpp>

#include <stdexcept>
#include <string_view>
#include <utility>

namespace fstiff { inline namespace v0_1 {

/// Place in a file.
struct Place {
    std::string file{};                   ///< its name in messages
    std::size_t line = 0;                 ///< counted from 1; 0 when there is none to name
    std::string key{};                    ///< in the file, as in a scene: "surface.rms_height"
    const char* before_line = ", line ";  ///< between file and line; of static storage

    /// "<file>, line <line>: <key>"; empty for a place without names.
    [[nodiscard]] FSTIFF_COLD std::string text() const {
        std::string text = file;
        if (line > 0) text += before_line + std::to_string(line);
        if (!key.empty()) text += (text.empty() ? "" : ": ") + key;
        return text;
    }
};

/// Parts of a domain_error. The views need to live until it is made, no longer.
struct Refusal {
    std::string_view parameter{};
    std::string_view value{};    ///< as the sentence shows it, so quoted where it is a text
    std::string_view allowed{};  ///< text after "must be "
    std::string_view reason{};   ///< the end of the sentence where it is not "must be <allowed>"
};

namespace detail {

/// The part of \p text from \p begin on; less where a text ends sooner, as one with a NUL in it does.
constexpr std::string_view part(std::string_view text, std::size_t begin,
                                std::size_t length = std::string_view::npos) noexcept {
    return text.substr(begin < text.size() ? begin : text.size(), length);
}

}  // namespace detail

/// An argument or a datum outside the range that the model or the method allows. Copies do not throw. The views of its
/// fields live as long as the exception.
class domain_error : public std::domain_error {
public:
    explicit domain_error(const Refusal& refusal) : domain_error(Sentence(refusal)) {}
    /// A plain sentence, for a refusal without a parameter.
    template <std::convertible_to<std::string_view> Text>  // no template takes the braces that a Refusal has
    explicit domain_error(const Text& reason) : domain_error(Refusal{.reason = reason}) {}

    [[nodiscard]] std::string_view parameter() const noexcept { return field(spans_.parameter); }
    [[nodiscard]] std::string_view value() const noexcept { return field(spans_.value); }
    /// Text after "must be "; empty where the sentence ends otherwise.
    [[nodiscard]] std::string_view allowed() const noexcept { return field(spans_.allowed); }
    /// The end of the sentence, after place, parameter and value.
    [[nodiscard]] std::string_view reason() const noexcept { return field(spans_.reason); }
    /// The place that was given first, which is the nearest one.
    [[nodiscard]] FSTIFF_COLD Place place() const {
        return {std::string(field(spans_.file)), spans_.line, std::string(field(spans_.key)), spans_.before_line};
    }

    /// The same error at \p place. A place it has already is kept; only its sentence begins with \p place.
    [[nodiscard]] FSTIFF_COLD domain_error with_place(const Place& place) const {
        const std::string text = place.text();
        if (text.empty()) return *this;
        Sentence sentence(text + ": " + what(), spans_);
        for (Span* span : {&sentence.spans.file, &sentence.spans.key, &sentence.spans.parameter, &sentence.spans.value,
                           &sentence.spans.reason, &sentence.spans.allowed})
            span->begin += text.size() + 2;
        if (spans_.file.length + spans_.key.length + spans_.line == 0) {
            sentence.spans.file = {0, place.file.size()};
            sentence.spans.key = {text.size() - place.key.size(), place.key.size()};
            sentence.spans.line = place.line;
            sentence.spans.before_line = place.before_line;
        }
        return domain_error(sentence);
    }
    /// The same error for a parameter called \p name, put before the reason if the error had none.
    [[nodiscard]] FSTIFF_COLD domain_error with_parameter(std::string_view name) const {
        Sentence sentence(std::string(detail::part(what(), 0, spans_.parameter.begin)), spans_);
        sentence.spans.allowed = {};
        const bool is_range = !allowed().empty();
        sentence.put({.parameter = name,
                      .value = value(),
                      .allowed = allowed(),
                      .reason = is_range ? std::string_view() : reason()});
        return domain_error(sentence);
    }

private:
    /// Place of a field in the sentence: the same in every copy, without a pointer.
    struct Span {
        std::size_t begin = 0, length = 0;
    };
    struct Spans {
        Span file{}, key{}, parameter{}, value{}, reason{}, allowed{};
        std::size_t line = 0;
        const char* before_line = "";
    };
    struct Sentence {
        std::string text{};
        Spans spans{};
        Sentence(std::string before, const Spans& place) : text(std::move(before)), spans(place) {}
        explicit Sentence(const Refusal& refusal) { put(refusal); }
        Span put(std::string_view field) {
            text += field;
            return {text.size() - field.size(), field.size()};
        }
        FSTIFF_COLD void put(const Refusal& refusal) {
            spans.parameter = put(refusal.parameter);
            if (!refusal.parameter.empty() && !refusal.value.empty()) text += " = ";
            spans.value = put(refusal.value);
            if (!refusal.parameter.empty()) text += ": ";
            if (refusal.reason.empty()) {
                text += "must be ";
                spans.allowed = put(refusal.allowed);
                spans.reason = {spans.allowed.begin - 8, spans.allowed.length + 8};
            } else {
                spans.reason = put(refusal.reason);
            }
        }
    };
    explicit domain_error(const Sentence& sentence) : std::domain_error(sentence.text), spans_(sentence.spans) {}

    [[nodiscard]] std::string_view field(Span span) const noexcept {
        return detail::part(what(), span.begin, span.length);
    }

    Spans spans_;
};

/// A file that cannot be opened, read or written. Copies do not throw.
class file_error : public std::runtime_error {
public:
    /// \p file is its name in messages; the sentence is "<file>: <reason>".
    file_error(const std::string& file, const std::string& reason)
        : std::runtime_error(file + ": " + reason), end_of_file_(file.size()) {}

    [[nodiscard]] std::string_view file() const noexcept { return detail::part(what(), begin_, end_of_file_ - begin_); }
    [[nodiscard]] std::string_view reason() const noexcept { return detail::part(what(), end_of_file_ + 2); }

    /// The same error, whose sentence begins with \p place, where the file was named.
    [[nodiscard]] FSTIFF_COLD file_error with_place(const Place& place) const {
        const std::string text = place.text();
        if (text.empty()) return *this;
        const std::size_t shift = text.size() + 2;
        return {text + ": " + what(), begin_ + shift, end_of_file_ + shift};
    }

private:
    file_error(const std::string& sentence, std::size_t begin, std::size_t end)
        : std::runtime_error(sentence), begin_(begin), end_of_file_(end) {}

    std::size_t begin_ = 0, end_of_file_;
};

namespace detail {

/// Returns \p call(); its errors get \p place.
template <class Call>
auto located(const Place& place, const Call& call) {
    try {
        return call();
    } catch (const domain_error& error) {
        throw error.with_place(place);
    } catch (const file_error& error) {
        throw error.with_place(place);
    }
}

/// Out of line and rarely called: one copy of each in a program, however many checks it has.
/// \throws domain_error "<parameter> = <value>: must be <allowed>".
[[noreturn]] FSTIFF_COLD_OUT_OF_LINE inline void refuse(std::string_view parameter, std::string_view value,
                                                        std::string_view allowed) {
    throw domain_error({.parameter = parameter, .value = value, .allowed = allowed});
}
[[noreturn]] FSTIFF_COLD_OUT_OF_LINE inline void refuse(std::string_view parameter, double value, int digits,
                                                        std::string_view allowed) {
    refuse(parameter, rounded_text(value, digits), allowed);
}
template <class T>
requires Real<T> || std::integral<T>
[[noreturn]] FSTIFF_COLD_OUT_OF_LINE void refuse(std::string_view parameter, T value, std::string_view allowed) {
    constexpr int digits = std::numeric_limits<T>::digits10;
    if constexpr (std::integral<T>)
        refuse(parameter, std::to_string(value), allowed);
    else
        refuse(parameter, static_cast<double>(value), digits, allowed);
}

/// Throws domain_error "<parameter> = <value>: must be <allowed>" unless \p satisfied.
/// The comparison that makes \p satisfied should be false for NaN, so that NaN is refused with the rest.
template <class T>
requires Real<T> || std::integral<T>
constexpr void require(bool satisfied, std::string_view parameter, T value, std::string_view allowed) {
    if (!satisfied) detail::refuse(parameter, value, allowed);
}

/// Throws unless \p value is finite and greater than zero.
template <Real T>
constexpr void require_positive(std::string_view parameter, T value) {
    require(value > T(0) && value <= (std::numeric_limits<T>::max)(), parameter, value, "finite and greater than 0");
}

}  // namespace detail

}}  // namespace fstiff
