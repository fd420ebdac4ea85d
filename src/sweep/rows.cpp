// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/rows.hpp"

#include "document/file.hpp"
#include "scene/joint.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <system_error>

namespace fstiff::sweep {
namespace {

/// The value after "key": in a line; empty where it has no such key. Quotation marks inside of texts are escaped, so
/// that none of them looks like a key.
std::string_view value_of(std::string_view line, std::string_view quoted_key) {
    const std::size_t at = line.find(quoted_key);
    if (at == std::string_view::npos) return {};
    line.remove_prefix(at + quoted_key.size());
    return line.substr(0, line.find_first_of(",}"));
}

std::optional<double> number_of(std::string_view text) {
    double value = 0;
    if (text.empty() || parts::read_decimal(text.data(), text.data() + text.size(), value).ec != std::errc()) return {};
    return value;
}

/// Where the text that begins with a quotation mark at \p at of \p line ends, with the escapes of json_text; npos for
/// none.
std::size_t end_of_text(std::string_view line, std::size_t at) {
    if (at >= line.size() || line[at] != '"') return std::string_view::npos;
    for (++at; at < line.size() && line[at] != '"'; ++at) {
        if (static_cast<unsigned char>(line[at]) < 32) return std::string_view::npos;
        if (line[at] != '\\') continue;
        const std::string_view escape = line.substr(++at, 5);
        if (escape.size() == 5 && escape[0] == 'u' &&
            std::all_of(escape.begin() + 1, escape.end(), parts::is_hexadecimal_digit))
            at += 4;
        else if (escape.empty() || std::string_view("\"\\bfnrt").find(escape[0]) == std::string_view::npos)
            return std::string_view::npos;
    }
    return at < line.size() ? at + 1 : std::string_view::npos;
}

/// Where the text, number or null that begins at \p at of \p line ends; npos where there is none.
std::size_t end_of_value(std::string_view line, std::size_t at) {
    if (at >= line.size()) return std::string_view::npos;
    if (line[at] == '"') return end_of_text(line, at);
    if (line.substr(at).starts_with("null")) return at + 4;
    double ignored = 0;
    const auto [end, error] = parts::read_decimal(line.data() + at, line.data() + line.size(), ignored);
    return error == std::errc::invalid_argument ? std::string_view::npos : static_cast<std::size_t>(end - line.data());
}

/// Whether \p line is {"key":value,"key":value} from its first to its last character.
bool is_object(std::string_view line) {
    std::size_t at = 0;
    for (char expected = '{'; at < line.size() && line[at] == expected; expected = ',') {
        at = end_of_text(line, at + 1);
        if (at >= line.size() || line[at] != ':') return false;
        at = end_of_value(line, at + 1);
    }
    return at + 1 == line.size() && line[at] == '}';
}

[[noreturn]] void refuse_line(const std::string& file, std::uint64_t number) {
    throw file_error(
        file + ":" + std::to_string(number),
        "is not a whole line of results, or not in its order; move the file and its .sweep away and run the "
        "sweep again");
}

}  // namespace

std::optional<std::uint64_t> index_of_line(std::string_view line) {
    constexpr std::string_view begin = "{\"index\":";
    if (!line.starts_with(begin)) return {};
    std::uint64_t index = 0;
    const char* const last = line.data() + line.size();
    const auto [end, error] = std::from_chars(line.data() + begin.size(), last, index);
    if (error != std::errc() || end == last || (*end != ',' && *end != '}') || !is_object(line)) return {};
    return index;
}

void for_each_line(const std::string& file,
                   const std::function<bool(std::string_view line, std::uint64_t index)>& call) {
    std::ifstream stream(scene::path_of(file), std::ios::binary);
    if (!stream) throw file_error(file, "cannot be read");
    std::string line;
    std::optional<std::uint64_t> last;
    for (std::uint64_t number = 1; std::getline(stream, line); ++number) {
        const auto index = index_of_line(line);
        if (!index && number == 1) throw file_error(file, "is not a file of results; must be what fstiff sweep wrote");
        if (!index || (last && *index != *last && *index != *last + 1)) refuse_line(file, number);
        if (!call(line, *index)) return;
        last = index;
    }
}

void for_each_row(const std::string& file, const std::function<bool(const Row&)>& call) {
    std::string law;
    Row row, last;
    std::optional<bool> has_stiffness;
    std::uint64_t number = 0;
    for_each_line(file, [&](std::string_view line, std::uint64_t index) {
        ++number;
        const std::string_view named = value_of(line, ",\"law\":\"");
        if (named.empty()) return true;  // no result
        const std::string_view stiffness = value_of(line, ",\"stiffness_Pa_per_m\":");
        row = {.index = index,
               .law = named.substr(0, named.size() - 1),
               .theta = number_of(value_of(line, ",\"theta\":")),
               .r = number_of(value_of(line, ",\"r\":")),
               .pressure = number_of(value_of(line, ",\"pressure_Pa\":")).value_or(0),
               .stiffness = number_of(stiffness)};
        if (value_of(line, ",\"answer\":") == "1") row.law = "answer";  // by whatever law, it is one curve
        if ((!scene::find_law(row.law) && row.law != "answer") ||
            has_stiffness.value_or(!stiffness.empty()) == stiffness.empty())
            refuse_line(file, number);
        const bool same = has_stiffness && row.index == last.index && row.law == last.law && row.theta == last.theta &&
                          row.r == last.r;
        row.point = same ? last.point + 1 : 0;
        has_stiffness = !stiffness.empty();
        if (!call(row)) return false;
        law = row.law;
        last = row;
        last.law = law;
        return true;
    });
}

}  // namespace fstiff::sweep
