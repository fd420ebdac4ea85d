// SPDX-License-Identifier: BSD-3-Clause
// Several files or arrays of one surface as one.
#include <fstiff/double/surfaces.hpp>
#include "document/shown_unit.hpp"
#include "surface/measured_surface.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/measure/pooled_surface.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace fstiff::surface {

std::vector<std::string> without_folders(const std::vector<std::string>& names) {
    std::vector<std::string> files;
    for (const std::string& name : names) {
        std::error_code none;
        if (!std::filesystem::is_directory(document::path_of(name), none)) {
            files.push_back(name);
            continue;
        }
        std::vector<std::string> inside;
        std::error_code unreadable;
        for (const auto& entry : std::filesystem::directory_iterator(document::path_of(name), unreadable))
            if (entry.is_regular_file(none) && !document::name_of_path(entry.path().filename()).starts_with('.'))
                inside.push_back(document::name_of_path(entry.path()));
        if (unreadable) throw file_error(name, "cannot be read: " + unreadable.message());
        if (inside.empty()) throw domain_error(name + ": is a folder without files; must hold files of one surface");
        std::sort(inside.begin(), inside.end());
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

namespace {

/// \throws domain_error unless \p next can be pooled with \p first; messages call both a \p noun.
void require_alike(const MeasuredSurface& first, const MeasuredSurface& next, const SurfaceOptions& options,
                   const std::string& noun) {
    const auto shown = [](const std::optional<double>& a) {
        return a ? document::shown_length(*a) : std::string("none");
    };
    const auto unlike = [&](const std::string& mine, const std::string& other, std::string_view option) {
        return domain_error(next.file + ": " + mine + first.file + " " + other + "; " + noun + "s of " +
                            std::string(option));
    };
    const CutOffs<double>&a = next.found.cut_offs, &b = first.found.cut_offs;
    switch (detail::unlikeness(first.found, next.found)) {
        case detail::Unlikeness::none: return;
        case detail::Unlikeness::kind:
            throw unlike("is a " + next.kind + ", and ", "a " + first.kind, "one surface must be of one kind");
        case detail::Unlikeness::lambda_s:
            throw unlike("lambda_s " + shown(a.lambda_s) + ", that of ", shown(b.lambda_s),
                         "one surface must have one " + options.name("lambda_s"));
        case detail::Unlikeness::lambda_c:
            throw unlike("lambda_c " + shown(a.lambda_c) + ", that of ", shown(b.lambda_c),
                         "one surface must have one " + options.name("lambda_c"));
        case detail::Unlikeness::step:
            throw unlike("has points " + document::shown_length(detail::step_of(next.found)) + " apart, and ",
                         document::shown_length(detail::step_of(first.found)),
                         "unlike steps must have one " + options.name("lambda_s"));
    }
}

/// Cut-offs that the table chose differently for \p parts become those of all in \p options. Returns whether there are
/// such.
bool share_cut_offs(SurfaceOptions& options, const std::vector<Surface<double>>& parts) {
    const auto share = [&](Amount& option, std::optional<double> CutOffs<double>::*cut_off) {
        const CutOff<double> asked = parse_cut_off(option, ""), shared = detail::shared_cut_off(asked, parts, cut_off);
        if (!asked.automatic() || shared.automatic()) return false;
        option = shared.length() ? Amount(*shared.length()) : Amount("none");
        return true;
    };
    const bool short_waves = share(options.lambda_s, &CutOffs<double>::lambda_s);
    const bool long_waves = options.detrend != gaussian_form && share(options.lambda_c, &CutOffs<double>::lambda_c);
    return short_waves || long_waves;
}

std::vector<Surface<double>> found_of(const std::vector<MeasuredSurface>& parts) {
    std::vector<Surface<double>> surfaces;
    for (const MeasuredSurface& part : parts) surfaces.push_back(part.found);
    return surfaces;
}

/// The names of \p files, or the first and how many more.
std::string names_of(const std::vector<MeasuredSurface>& parts) {
    std::string text;
    for (const MeasuredSurface& part : parts) text += (text.empty() ? "" : ", ") + part.file;
    return text.size() <= 80 ? text : parts.front().file + " and " + std::to_string(parts.size() - 1) + " more files";
}

/// Notes common to all of \p parts are given once, the others with the name of the file.
void gather_warnings(MeasuredSurface& pool) {
    const auto count = [&](const std::string& sentence) {
        return std::count_if(pool.parts.begin(), pool.parts.end(), [&](const MeasuredSurface& part) {
            return std::count(part.warnings.begin(), part.warnings.end(), sentence) > 0;
        });
    };
    for (const MeasuredSurface& part : pool.parts)
        for (const std::string& sentence : part.warnings) {
            const bool of_all = count(sentence) == std::ssize(pool.parts);
            if (of_all && &part != &pool.parts.front()) continue;
            pool.warnings.push_back((of_all ? "" : part.file + ": ") + sentence);
            if (std::count(part.of_file.begin(), part.of_file.end(), sentence) > 0)
                pool.of_file.push_back(pool.warnings.back());
        }
}

MeasuredSurface pooled(std::vector<MeasuredSurface> parts, const std::string& noun) {
    MeasuredSurface pool;
    pool.parts = std::move(parts);
    pool.found = fstiff::pooled(found_of(pool.parts));
    std::string hashes;
    for (const MeasuredSurface& part : pool.parts) hashes += part.sha256 + "\n";
    pool.file = names_of(pool.parts);
    pool.sha256 = document::sha256(hashes);
    pool.kind = pool.parts.front().kind;
    pool.decisions = {std::to_string(pool.parts.size()) + " " + noun + "s pooled, each by its " +
                          (pool.is_profile() ? "length" : "area") + ": " + names_of(pool.parts),
                      sentence_of(pool.found.cut_offs),
                      "errors: those of the " + noun + "s, or of their scatter by Student's t where it is greater"};
    gather_warnings(pool);
    for (std::string& line : peak_warnings(pool.found.concerns, pool.found.peaks_counted, pool.found))
        if (std::count(pool.warnings.begin(), pool.warnings.end(), line) == 0) pool.warnings.push_back(std::move(line));
    return pool;
}

}  // namespace

MeasuredSurface measure_parts(MeasureOptions options, std::size_t count, const MeasurePart& measure,
                              const std::string& noun, bool again) {
    std::vector<MeasuredSurface> parts;
    std::vector<std::string> copies;  // warnings of them
    const auto measure_all = [&] {
        parts.clear(), copies.clear();
        for (std::size_t i = 0; i < count; ++i) {
            MeasuredSurface part = measure(options, i);
            const auto same = std::find_if(parts.begin(), parts.end(), [&](const MeasuredSurface& other) {
                const SurfaceOptions &a = other.how->input, &b = part.how->input;
                return other.sha256 == part.sha256 && a.column == b.column && a.channel == b.channel;
            });
            if (same == parts.end())
                parts.push_back(std::move(part));
            else
                copies.push_back(part.file + ": is the same " + noun + " as " + same->file +
                                 ", byte for byte (SHA-256), and is not counted again");
        }
    };
    measure_all();
    if (again && share_cut_offs(options.input, found_of(parts))) measure_all();
    for (const MeasuredSurface& part : parts) require_alike(parts.front(), part, options.input, noun);
    MeasuredSurface pool = parts.size() == 1 ? std::move(parts.front()) : pooled(std::move(parts), noun);
    pool.warnings.insert(pool.warnings.begin(), copies.begin(), copies.end());
    return pool;
}

namespace {

/// The numbers of a list such as "2-180" or "2,4,6-9", from \p lowest on. \throws option_error.
std::vector<int> numbers_of_list(const std::string& list, const std::string& name, int lowest) {
    std::vector<int> numbers;
    const auto number = [&](std::string_view text) {
        int read = -1;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
        if (error != std::errc() || end != text.data() + text.size() || read < lowest || read > most_columns)
            throw document::option_error(name + " = \"" + list + "\": must be whole numbers from " +
                                         std::to_string(lowest) + " to " + std::to_string(most_columns) +
                                         ", such as \"2-180\" or \"2,4,6-9\"");
        return read;
    };
    for (const std::string& part : split_at_commas(list)) {
        const std::size_t dash = std::min(part.find('-'), part.size());
        const int first = number(part.substr(0, dash)),
                  last = dash < part.size() ? number(part.substr(dash + 1)) : first;
        if (last < first) throw document::option_error(name + " = \"" + list + "\": the numbers of a range must rise");
        for (int n = first; n <= last; ++n) numbers.push_back(n);
    }
    return numbers;
}

/// What of a file is measured: all of it, or one of its columns or channels.
struct FilePart {
    std::size_t file{};
    int number = 0;
};

}  // namespace

MeasuredSurface measure_files(const MeasureOptions& options, const std::vector<std::string>& names,
                              const ProgressHook& progress, const std::vector<std::string>& contents) {
    const std::vector<std::string> files = without_folders(names);
    const SurfaceOptions& input = options.input;
    if (!input.columns.empty() && !input.channels.empty())
        throw document::option_error(input.name("columns") + " and " + input.name("channels") +
                                     " are both given; must be one of them");
    const std::string key = !input.columns.empty() ? "columns" : !input.channels.empty() ? "channels" : "";
    std::vector<FilePart> parts;
    std::vector<int> numbers{0};
    if (!input.columns.empty()) numbers = numbers_of_list(input.columns, input.name(key), 1);
    if (!input.channels.empty()) numbers = numbers_of_list(input.channels, input.name(key), 0);
    for (std::size_t file = 0; file < files.size(); ++file)
        for (const int number : numbers) parts.push_back({file, number});
    std::string bytes;  // of the file of the last part
    const auto measure = [&](MeasureOptions of_part, std::size_t i) {
        const FilePart& part = parts[i];
        if (i == 0 || part.file != parts[i - 1].file)
            bytes = contents.empty() ? document::read_all(files[part.file]) : contents[part.file];
        of_part.input.file = files[part.file];
        of_part.input.columns.clear(), of_part.input.channels.clear();
        if (key == "columns") of_part.input.column = part.number;
        if (key == "channels") of_part.input.channel = std::to_string(part.number);
        MeasuredSurface measured = measure_surface(of_part, bytes, progress);
        if (!key.empty()) measured.file += ", " + key.substr(0, key.size() - 1) + " " + std::to_string(part.number);
        return measured;
    };
    const bool again = std::count(files.begin(), files.end(), "-") == 0;  // standard input is read once
    if (key.empty()) return measure_parts(options, parts.size(), measure, "file", again);
    MeasuredSurface pool = measure_parts(options, parts.size(), measure, key.substr(0, key.size() - 1), again);
    if (files.size() == 1 && !pool.parts.empty())
        pool.file = document::display_name(files.front()) + ", " + key + " " +
                    (key == "columns" ? input.columns : input.channels);
    return pool;
}

}  // namespace fstiff::surface
