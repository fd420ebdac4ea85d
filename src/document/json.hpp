// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A JSON document in the making: written like nlohmann's, which json.cpp alone includes. Keys keep their order.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace fstiff::scene {

class Json {
public:
    Json(std::nullptr_t = nullptr);
    Json(bool value);
    /// \throws std::logic_error for NaN and infinity, which JSON has not: a defect of fstiff.
    Json(double value);
    template <std::integral Integer>
    requires(!std::same_as<Integer, bool>) Json(Integer value)
        : Json(value < 0 ? Whole{true, static_cast<std::uint64_t>(-static_cast<std::int64_t>(value))}
                         : Whole{false, static_cast<std::uint64_t>(value)}) {}
    Json(const char* text);
    Json(std::string text);
    Json(std::string_view text);
    Json(const std::vector<std::string>& texts);
    Json(const std::vector<std::size_t>& counts);
    Json(const std::vector<double>& numbers);
    /// {{"key", value}, ...} is an object, any other list an array.
    Json(std::initializer_list<Json> items);
    Json(const Json& other);
    Json(Json&& other) noexcept;
    Json& operator=(const Json& other);
    Json& operator=(Json&& other) noexcept;
    ~Json();

    static Json array();
    static Json object();

    /// The value of \p key, which is made where there is none; null becomes an object.
    Json& operator[](std::string_view key);
    /// Appends to an array; null becomes one.
    void push_back(Json item);
    /// Takes over all keys of \p object.
    void update(const Json& object);
    /// The value at \p path, its keys and places in arrays with points between them, such as "psd.psd_m3" or "rows.0.model";
    /// null where there is none.
    [[nodiscard]] const Json* at(std::string_view path) const;
    /// The number, or all numbers of an array and of those in it, one after the other; null is NaN.
    /// \throws domain_error for anything else.
    [[nodiscard]] std::vector<double> numbers() const;
    /// The text of a value that is one.
    [[nodiscard]] const std::string& text() const;

    /// Indented by two, with a line end. Bytes that are no UTF-8 (of a file name, a header line) become U+FFFD: a document
    /// is always valid JSON.
    [[nodiscard]] std::string str() const;

private:
    enum class Kind : unsigned char { null, boolean, negative, whole, real, text, array, object };
    struct Whole {
        bool negative;
        std::uint64_t size;
    };
    struct Rest;  // of a value that is no number
    explicit Json(Whole value);
    void write(std::string& out, const std::string& line) const;

    Kind kind_ = Kind::null;
    union {
        double real_;
        std::uint64_t whole_;
    };
    std::unique_ptr<Rest> rest_;
};

/// Starts a JSON document: schema version, version of fstiff, name of the subcommand.
[[nodiscard]] Json json_document(std::string_view command);

}  // namespace fstiff::scene
