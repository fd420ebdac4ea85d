// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/rows.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>

#include <fstream>

namespace fstiff::sweep {
namespace {

/// What stands behind "key": in a line; empty where it has no such key. Quotation marks inside of texts are escaped, so that
/// none of them looks like a key.
std::string_view value_of(std::string_view line, std::string_view quoted_key) {
    const std::size_t at = line.find(quoted_key);
    if (at == std::string_view::npos) return {};
    line.remove_prefix(at + quoted_key.size());
    return line.substr(0, line.find_first_of(",}"));
}

std::optional<double> number_of(std::string_view text) {
    double value = 0;
    if (text.empty() || read_decimal(text.data(), text.data() + text.size(), value).ec != std::errc()) return {};
    return value;
}

}  // namespace

void for_each_field(std::string_view line,
                    const std::function<void(std::string_view key, std::string_view value)>& call) {
    for (std::size_t at = 1; at < line.size() && line[at] == '"';) {
        const std::size_t key_end = line.find('"', at + 1);
        if (key_end == std::string_view::npos || key_end + 2 >= line.size()) return;
        const std::size_t begin = key_end + 2;
        std::size_t end = begin + 1;
        if (line[begin] == '"') {
            for (; end < line.size() && line[end] != '"'; ++end)
                if (line[end] == '\\') ++end;
            ++end;
        } else {
            end = line.find_first_of(",}", begin);
        }
        if (end >= line.size()) return;
        call(line.substr(at + 1, key_end - at - 1), line.substr(begin, end - begin));
        at = end + 1;
    }
}

void for_each_row(const std::string& file, const std::function<bool(const Row&)>& call) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw file_error(file, "cannot be read");
    std::string line, law;
    Row row, last;
    for (bool first = true; std::getline(stream, line);) {
        const auto index = number_of(value_of(line, "{\"index\":"));
        if (!index) throw file_error(file, "is no file of results; must be what fstiff sweep wrote");
        const std::string_view named = value_of(line, ",\"law\":\"");
        if (named.empty()) continue;  // no result
        row = {.index = static_cast<std::uint64_t>(*index),
               .law = named.substr(0, named.size() - 1),
               .theta = number_of(value_of(line, ",\"theta\":")),
               .r = number_of(value_of(line, ",\"r\":")),
               .pressure = number_of(value_of(line, ",\"pressure_Pa\":")).value_or(0),
               .stiffness = number_of(value_of(line, ",\"stiffness_Pa_per_m\":"))};
        const bool same =
            !first && row.index == last.index && row.law == last.law && row.theta == last.theta && row.r == last.r;
        row.point = same ? last.point + 1 : 0;
        if (!call(row)) return;
        law = row.law;
        last = row;
        last.law = law;
        first = false;
    }
}

}  // namespace fstiff::sweep
