// SPDX-License-Identifier: BSD-3-Clause
#include "document/json.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/version.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace fstiff::scene {
namespace {

/// \p value in quotation marks, with all control characters as \u00XX; JSON itself asks that of those below U+0020 only.
std::string in_quotes(const std::string& value) {
    using nlohmann::json;
    std::string text = json(value).dump(-1, ' ', false, json::error_handler_t::replace);
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool is_delete = text[at] == 0x7f;
        const auto next = static_cast<unsigned char>(at + 1 < text.size() ? text[at + 1] : 0);
        if (!is_delete && !(text[at] == '\xc2' && next < 0xa0)) continue;
        constexpr const char* digits = "0123456789abcdef";
        const unsigned code = is_delete ? 0x7f : next;
        text.replace(at, is_delete ? 1 : 2, {'\\', 'u', '0', '0', digits[code / 16], digits[code % 16]});
        at += 5;
    }
    return text;
}

}  // namespace

struct Json::Rest {
    std::string text;
    std::vector<Json> items;
    std::vector<std::string> keys;  ///< of an object: one an item
};

Json::Json(std::nullptr_t) : whole_(0) {}
Json::Json(bool value) : kind_(Kind::boolean), whole_(value) {}
Json::Json(double value) : kind_(Kind::real), real_(value) {
    if (!std::isfinite(value)) throw std::logic_error("a result is not a finite number; this is a defect of fstiff");
}
Json::Json(Whole value) : kind_(value.negative ? Kind::negative : Kind::whole), whole_(value.size) {}
Json::Json(const char* text) : Json(std::string(text)) {}
Json::Json(std::string_view text) : Json(std::string(text)) {}
Json::Json(std::string text) : kind_(Kind::text), whole_(0), rest_(new Rest{std::move(text), {}, {}}) {}
Json::Json(const std::vector<std::string>& texts) : Json(array()) { rest_->items.assign(texts.begin(), texts.end()); }
Json::Json(const std::vector<std::size_t>& counts) : Json(array()) {
    rest_->items.assign(counts.begin(), counts.end());
}

Json::Json(const std::vector<double>& numbers) : Json(array()) { rest_->items.assign(numbers.begin(), numbers.end()); }

Json::Json(std::initializer_list<Json> items) : Json(array()) {
    const bool pairs = std::all_of(items.begin(), items.end(), [](const Json& item) {
        return item.kind_ == Kind::array && item.rest_->items.size() == 2 &&
               item.rest_->items.front().kind_ == Kind::text;
    });
    if (!pairs) {
        rest_->items = items;
        return;
    }
    kind_ = Kind::object;
    for (const Json& item : items) (*this)[item.rest_->items[0].text()] = item.rest_->items[1];
}

Json::Json(const Json& other) : kind_(other.kind_), whole_(other.whole_) {
    if (other.rest_) rest_ = std::make_unique<Rest>(*other.rest_);
}
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(const Json& other) { return *this = Json(other); }
Json& Json::operator=(Json&& other) noexcept = default;
Json::~Json() = default;

Json Json::array() {
    Json list;
    list.kind_ = Kind::array;
    list.rest_ = std::make_unique<Rest>();
    return list;
}

Json Json::object() {
    Json made = array();
    made.kind_ = Kind::object;
    return made;
}

Json& Json::operator[](std::string_view key) {
    if (kind_ == Kind::null) *this = object();
    if (kind_ != Kind::object) throw std::logic_error("a JSON value that is no object has no keys");
    const auto found = std::find(rest_->keys.begin(), rest_->keys.end(), key);
    if (found != rest_->keys.end()) return rest_->items[static_cast<std::size_t>(found - rest_->keys.begin())];
    rest_->keys.emplace_back(key);
    return rest_->items.emplace_back();
}

void Json::push_back(Json item) {
    if (kind_ == Kind::null) *this = array();
    if (kind_ != Kind::array) throw std::logic_error("a JSON value that is no array takes no items");
    rest_->items.push_back(std::move(item));
}

void Json::update(const Json& object) {
    for (std::size_t i = 0; i < object.rest_->keys.size(); ++i) (*this)[object.rest_->keys[i]] = object.rest_->items[i];
}

const std::string& Json::text() const {
    if (kind_ != Kind::text) throw std::logic_error("a JSON value that is no text");
    return rest_->text;
}

const Json* Json::at(std::string_view path) const {
    if (path.empty()) return this;
    const std::size_t end = std::min(path.find('.'), path.size());
    const std::string_view key = path.substr(0, end), rest = path.substr(std::min(end + 1, path.size()));
    std::size_t place = 0;
    if (kind_ == Kind::object)
        place = static_cast<std::size_t>(std::find(rest_->keys.begin(), rest_->keys.end(), key) - rest_->keys.begin());
    else if (const char* const last = key.data() + key.size();
             kind_ != Kind::array || std::from_chars(key.data(), last, place).ptr != last)
        return nullptr;
    return place < rest_->items.size() ? rest_->items[place].at(rest) : nullptr;
}

std::vector<double> Json::numbers() const {
    switch (kind_) {
        case Kind::null:
            return {std::numeric_limits<double>::quiet_NaN()};
        case Kind::negative:
            return {-static_cast<double>(whole_)};
        case Kind::whole:
            return {static_cast<double>(whole_)};
        case Kind::real:
            return {real_};
        default:
            break;
    }
    if (kind_ != Kind::array) throw domain_error("is neither a number nor an array of them");
    std::vector<double> all;
    for (const Json& item : rest_->items) {
        const std::vector<double> one = item.numbers();
        all.insert(all.end(), one.begin(), one.end());
    }
    return all;
}

std::string Json::str() const {
    std::string out;
    write(out, "\n");
    return out + '\n';
}

void Json::write(std::string& out, const std::string& line) const {
    using nlohmann::json;
    switch (kind_) {
        case Kind::null:
            out += "null";
            return;
        case Kind::boolean:
            out += whole_ ? "true" : "false";
            return;
        case Kind::negative:
            out += '-';
            [[fallthrough]];
        case Kind::whole:
            out += std::to_string(whole_);
            return;
        case Kind::real:
            out += json(real_).dump();
            return;
        case Kind::text:
            out += in_quotes(rest_->text);
            return;
        case Kind::array:
        case Kind::object:
            break;
    }
    const bool is_object = kind_ == Kind::object;
    out += is_object ? '{' : '[';
    for (std::size_t i = 0; i < rest_->items.size(); ++i) {
        out += (i ? "," : "") + line + "  ";
        if (is_object) out += in_quotes(rest_->keys[i]) + ": ";
        rest_->items[i].write(out, line + "  ");
    }
    if (!rest_->items.empty()) out += line;
    out += is_object ? '}' : ']';
}

Json json_document(std::string_view command) {
    Json document;
    document["schema_version"] = 1;
    document["fstiff_version"] = FSTIFF_VERSION;
    document["command"] = command;
    return document;
}

}  // namespace fstiff::scene
