// SPDX-License-Identifier: BSD-3-Clause
#include "document/json.hpp"

#include "document/file.hpp"
#include "io/number.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/version.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace fstiff::document {

Json::Json(double value) : value_(value) {
    if (!std::isfinite(value)) throw std::logic_error("a result is not a finite number; this is a defect of fstiff");
}

Json::Json(std::initializer_list<Json> items) : value_(Items(items)) {
    const auto is_member = [](const Json& item) {
        const auto* pair = std::get_if<Items>(&item.value_);
        return pair && pair->size() == 2 && std::holds_alternative<std::string>(pair->front().value_);
    };
    if (!std::all_of(items.begin(), items.end(), is_member)) return;
    value_ = Members();
    for (const Json& item : items) {
        const Items& pair = std::get<Items>(item.value_);
        (*this)[std::get<std::string>(pair[0].value_)] = pair[1];
    }
}

Json& Json::operator[](std::string_view key) {
    if (std::holds_alternative<std::nullptr_t>(value_)) value_ = Members();
    Members& members = std::get<Members>(value_);
    const auto entry =
        std::find_if(members.begin(), members.end(), [&](const auto& member) { return member.first == key; });
    return entry != members.end() ? entry->second : members.emplace_back(key, Json()).second;
}

void Json::push_back(Json item) {
    if (std::holds_alternative<std::nullptr_t>(value_)) value_ = Items();
    std::get<Items>(value_).push_back(std::move(item));
}

void Json::update(const Json& object) {
    for (const auto& [key, value] : std::get<Members>(object.value_)) (*this)[key] = value;
}

struct JsonPrinter {
    using Printed = nlohmann::ordered_json;
    Printed operator()(const Json& json) const { return std::visit(*this, json.value_); }
    Printed operator()(const Json::Items& items) const {
        Printed array = Printed::array();
        for (const Json& item : items) array.push_back((*this)(item));
        return array;
    }
    Printed operator()(const Json::Members& members) const {
        Printed object = Printed::object();
        for (const auto& [key, value] : members) object[key] = (*this)(value);
        return object;
    }
    Printed operator()(const auto& value) const { return value; }
};

namespace {

/// \p json with \uXXXX for the control characters that JSON itself lets pass.
std::string printed(const nlohmann::ordered_json& json, int indent) {
    std::string text = json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    for (std::size_t place = 0; place < text.size(); ++place) {
        if (static_cast<unsigned char>(text[place]) < 0x7f) continue;  // its line ends too
        const std::size_t length = io::detail::utf8_length(std::string_view(text).substr(place));
        const std::string_view character = std::string_view(text).substr(place, length);
        if (!is_control(character)) {
            place += length - 1;
            continue;
        }
        unsigned code = 0;  // of at most three bytes
        for (const char byte : character) code = code << 6 | (static_cast<unsigned char>(byte) & 0x3fu);
        code = length == 1 ? 0x7fu : code & 0xffffu;
        constexpr const char* digits = "0123456789abcdef";
        std::string escape = "\\u";
        for (int shift = 12; shift >= 0; shift -= 4) escape += digits[code >> shift & 15];
        text.replace(place, length, escape);
        place += escape.size() - 1;
    }
    return text;
}

}  // namespace

std::string Json::str() const { return printed(JsonPrinter()(*this), 2) + '\n'; }

std::string json_text(std::string_view text) { return printed(text, -1); }

const Json* Json::at(std::string_view path) const {
    if (path.empty()) return this;
    const std::size_t end = std::min(path.find('.'), path.size());
    const std::string_view key = path.substr(0, end), rest = path.substr(std::min(end + 1, path.size()));
    if (const auto* members = std::get_if<Members>(&value_)) {
        const auto entry =
            std::find_if(members->begin(), members->end(), [&](const auto& member) { return member.first == key; });
        return entry == members->end() ? nullptr : entry->second.at(rest);
    }
    const auto* items = std::get_if<Items>(&value_);
    std::size_t place = 0;
    const char* const last = key.data() + key.size();
    if (!items || std::from_chars(key.data(), last, place).ptr != last || place >= items->size()) return nullptr;
    return (*items)[place].at(rest);
}

std::vector<double> Json::numbers() const {
    if (std::holds_alternative<std::nullptr_t>(value_)) return {std::numeric_limits<double>::quiet_NaN()};
    if (const auto* real = std::get_if<double>(&value_)) return {*real};
    if (const auto* integer = std::get_if<std::int64_t>(&value_)) return {static_cast<double>(*integer)};
    if (const auto* count = std::get_if<std::uint64_t>(&value_)) return {static_cast<double>(*count)};
    const auto* items = std::get_if<Items>(&value_);
    if (!items) throw domain_error("is neither a number nor an array of them");
    std::vector<double> values;
    for (const Json& item : *items) {
        const std::vector<double> member = item.numbers();
        values.insert(values.end(), member.begin(), member.end());
    }
    return values;
}

Json json_document(std::string_view command) {
    return {{"schema_version", 1}, {"fstiff_version", FSTIFF_VERSION_TEXT}, {"command", command}};
}

}  // namespace fstiff::document
