// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A JSON document in the making: written like nlohmann's, with which json.cpp prints. Keys keep their order.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace fstiff::document {

class Json {
public:
    Json(std::nullptr_t = nullptr) {}
    Json(bool value) : value_(value) {}
    /// \throws std::logic_error for NaN and infinity, which JSON has not: a defect of fstiff.
    Json(double value);
    template <std::integral Integer>
    requires(!std::same_as<Integer, bool>) Json(Integer value)
        : value_(std::conditional_t<std::signed_integral<Integer>, std::int64_t, std::uint64_t>(value)) {}
    Json(const char* text) : value_(std::string(text)) {}
    Json(std::string text) : value_(std::move(text)) {}
    Json(std::string_view text) : value_(std::string(text)) {}
    /// Texts or numbers: an array.
    template <class Item>
    Json(const std::vector<Item>& items) : value_(Items(items.begin(), items.end())) {}
    /// {{"key", value}, ...} is an object, any other list an array.
    Json(std::initializer_list<Json> items);

    static Json array() { return Json(Items()); }
    static Json object() { return Json(Members()); }

    /// The value of \p key, which is made where there is none; null becomes an object.
    Json& operator[](std::string_view key);
    /// Appends to an array; null becomes one.
    void push_back(Json item);
    /// Takes over all keys of \p object.
    void update(const Json& object);
    /// The value at \p path, its keys and places in arrays with points between them, such as "psd.psd_m3" or
    /// "rows.0.model"; null where there is none.
    [[nodiscard]] const Json* at(std::string_view path) const;
    /// The number, or all numbers of an array and of those in it, one after the other; null is NaN.
    /// \throws domain_error for anything else.
    [[nodiscard]] std::vector<double> numbers() const;
    /// The text; null where it is something else.
    [[nodiscard]] const std::string* word() const { return std::get_if<std::string>(&value_); }

    /// Indented by two, with a line end. Bytes that are no UTF-8 (of a file name, a header line) become U+FFFD: a
    /// document is always valid JSON.
    [[nodiscard]] std::string str() const;

private:
    using Items = std::vector<Json>;
    using Members = std::vector<std::pair<std::string, Json>>;
    explicit Json(Items items) : value_(std::move(items)) {}
    explicit Json(Members members) : value_(std::move(members)) {}
    friend struct JsonPrinter;  // json.cpp

    std::variant<std::nullptr_t, bool, double, std::int64_t, std::uint64_t, std::string, Items, Members> value_;
};

/// \p text in quotation marks, with all control characters as \\uXXXX but those that have a letter, such as \\n; JSON
/// itself asks that of those below U+0020 only. Bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string json_text(std::string_view text);

/// Starts a JSON document: schema version, version of fstiff, name of the subcommand.
[[nodiscard]] Json json_document(std::string_view command);

}  // namespace fstiff::document
