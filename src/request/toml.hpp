// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// TOML as a giver of values: refusals with their place, a record of the inputs, and sections of known keys. Private to
// the files that read a scene: it brings in toml++.

#include "document/file.hpp"
#include "request/field.hpp"
#include "request/words.hpp"

#include <fstiff/core/error.hpp>

// toml++ 3.3 asserts, or assumes in an optimised build, what some malformed texts break. Its assertions are made to
// throw in every build; no other file includes toml++.
namespace fstiff::request {
struct BrokenToml {};
constexpr void expect_toml(bool holds) {
    if (!holds) throw BrokenToml{};
}
}  // namespace fstiff::request
#undef NDEBUG
#define TOML_ASSERT(expression) fstiff::request::expect_toml(static_cast<bool>(expression))
#define TOML_HEADER_ONLY 0  // toml.cpp holds the implementation
#include <toml++/toml.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace fstiff::request {

using document::list_of;
using io::Dimension;

/// The text of a value for messages and for the echo of the inputs.
[[nodiscard]] std::string written(const toml::node& node);

/// \p node as a value of a field.
[[nodiscard]] Value value_of(const toml::node& node);

/// Common data of all parts of one text: its name for messages, and the record of its inputs.
struct Source {
    std::string file;
    std::vector<Input> inputs{};
    const std::set<std::string>* in_si = nullptr;  ///< keys whose numbers a program gives

    std::string at(const toml::node& node) const {
        const auto line = node.source().begin.line;
        return line > 0 ? file + ":" + std::to_string(line) : file;
    }
    [[noreturn]] void refuse(const toml::node& node, const std::string& key, const std::string& reason) const {
        const std::string value = node.is_string() ? "\"" + written(node) + "\"" : written(node);
        throw domain_error(at(node) + ": " + key + " = " + value + ": " + reason);
    }
    Place place(const toml::node& node, std::string key = "") const {
        return {.file = file, .line = node.source().begin.line, .key = std::move(key), .before_line = ":"};
    }
    /// Runs a check or a reader of the library; what it throws gets the place.
    template <class Call>
    auto located(const toml::node& node, const Call& call) const {
        return detail::located(place(node), call);
    }
    void record(std::string key, std::string text, std::optional<double> value = {}, std::string_view unit = {}) {
        inputs.push_back({std::move(key), std::move(text), value, std::string(unit)});
    }
    /// Of a key that is not there.
    void record_default(std::string key, std::string text, std::optional<double> value = {},
                        std::string_view unit = {}) {
        inputs.push_back({std::move(key), std::move(text), value, std::string(unit), false});
    }

    /// Puts \p node into \p to, and on record.
    template <class Member>
    void read(const toml::node& node, const std::string& key, Member& to, const Field& field = {}) {
        Value value = value_of(node);
        if (in_si && in_si->contains(key)) value.giver = Value::Giver::program;
        located(node, [&] { put(value, to, key, field); });
        record(key, value, to, field);
    }
    double quantity(const toml::node& node, const std::string& key, Dimension dimension) {
        double value = 0;
        read(node, key, value, {.dimension = dimension});
        return value;
    }
    double positive(const toml::node& node, const std::string& key, Dimension dimension) {
        double value = 0;
        read(node, key, value, request::positive(dimension));
        return value;
    }
    double number(const toml::node& node, const std::string& key) {
        double value = 0;
        read(node, key, value);
        return value;
    }
    std::string text(const toml::node& node, const std::string& key) {
        std::string text;
        read(node, key, text);
        return text;
    }
    /// One of \p allowed, by its place in that list.
    std::size_t choice(const toml::node& node, const std::string& key, std::span<const std::string_view> allowed) {
        const Value value = value_of(node);
        const std::size_t place = located(node, [&] { return word(value, key, {allowed.begin(), allowed.end()}); });
        record(key, value.written);
        return place;
    }
    /// A non-empty list of choices, none twice.
    std::vector<std::size_t> choices(const toml::node& node, const std::string& key,
                                     std::span<const std::string_view> allowed) {
        if (!node.is_array() || node.as_array()->empty())
            refuse(node, key, "must be a list of one or more of " + list_of(allowed));
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0; i < node.as_array()->size(); ++i) {
            const toml::node& item = (*node.as_array())[i];
            const std::string item_key = key + "[" + std::to_string(i) + "]";
            chosen.push_back(choice(item, item_key, allowed));
            if (std::count(chosen.begin(), chosen.end(), chosen.back()) > 1) refuse(item, item_key, "is listed twice");
        }
        return chosen;
    }

private:
    /// The number of a field of numbers with its unit; of other fields the text alone.
    template <class Member>
    void record(const std::string& key, const Value& value, const Member& to, const Field& field) {
        if constexpr (requires {
                          typename Member::value_type;
                          to.has_value();
                      })
            record(key, value, *to, field);
        else if constexpr (std::is_arithmetic_v<Member>)
            std::is_same_v<Member, bool>&& field.form == Form::plain
                ? record(key, value.written)
                : record(key, value.written, static_cast<double>(to), field.dimension ? si_unit(*field.dimension) : "");
        else
            record(key, value.written);
    }
};

/// A table of the scene, without keys where it is null, with the path of its keys; a key outside \p valid is refused
/// with the list of them.
class Section {
public:
    Section(Source& source, const toml::table* table, std::string path, std::initializer_list<std::string_view> valid)
        : Section(source, table, std::move(path), std::span(valid.begin(), valid.size())) {}
    Section(Source& source, const toml::table* table, std::string path, std::span<const std::string_view> valid)
        : source_(source), table_(table ? *table : none()), path_(std::move(path)) {
        for (const auto& [key, node] : table_)
            if (std::find(valid.begin(), valid.end(), key.str()) == valid.end())
                throw domain_error(source.at(node) + ": " + this->key(key.str()) + ": " +
                                   unknown_key(key.str(), path_, valid));
    }
    std::string key(std::string_view name) const { return (path_.empty() ? "" : path_ + ".") + std::string(name); }
    /// The place of the section itself, for messages.
    const toml::node& node() const { return table_; }
    const toml::node* find(std::string_view name) const { return table_.get(name); }
    const toml::node& at(std::string_view name, const std::string& why = "is missing; the scene needs it") const {
        if (const auto* node = find(name)) return *node;
        throw domain_error((path_.empty() ? source_.file : source_.at(table_)) + ": " + key(name) + ": " + why);
    }
    /// Reads the fields that \p each hands over, in their order; \p absent is called with the key and the member of one
    /// that is not there.
    template <class Each, class Absent>
    void read(const Each& each, const Absent& absent) const {
        each([&](std::string_view name, auto& to, const Field& field) {
            if (const toml::node* node = find(name))
                source_.read(*node, key(name), to, field);
            else
                absent(name, to);
        });
    }
    template <class Each>
    void read(const Each& each) const {
        read(each, [](std::string_view, const auto&) {});
    }
    /// \throws domain_error with the place of the key \p name, which is there, and its value.
    [[noreturn]] void refuse(std::string_view name, const std::string& reason) const {
        source_.refuse(at(name), key(name), reason);
    }
    /// \throws domain_error where more than one of \p names is there. \return the one that is; empty where none is
    std::string_view one_of(std::span<const std::string_view> names,
                            const char* way_out = "give one of the two") const {
        std::string_view there;
        for (const std::string_view name : names) {
            if (!find(name)) continue;
            if (!there.empty())
                throw domain_error(source_.at(at(name)) + ": " + key(name) + ": must not be given with " + key(there) +
                                   "; " + way_out);
            there = name;
        }
        return there;
    }
    /// Null where there is none.
    const toml::table* find_subtable(std::string_view name) const { return find(name) ? &subtable(name) : nullptr; }
    const toml::table& subtable(std::string_view name) const {
        const toml::node& node = at(name, "is missing; the scene needs this section");
        if (!node.is_table()) source_.refuse(node, key(name), "must be a section of keys");
        return *node.as_table();
    }

    double positive(std::string_view name, Dimension dimension) const {
        return source_.positive(at(name), key(name), dimension);
    }
    std::optional<double> optional_positive(std::string_view name, Dimension dimension) const {
        return find(name) ? std::optional(positive(name, dimension)) : std::nullopt;
    }

private:
    static const toml::table& none() {
        static const toml::table empty;
        return empty;
    }

    Source& source_;
    const toml::table& table_;
    std::string path_;
};

/// \throws domain_error with the line of \p file where \p text is not valid TOML.
[[nodiscard]] toml::table parse_toml(const std::string& text, const std::string& file);

}  // namespace fstiff::request
