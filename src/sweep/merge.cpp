// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/results_file.hpp"

#include "document/file.hpp"

#include <fstiff/core/error.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

namespace fstiff::sweep {
namespace {

struct Part {
    std::string file;
    Description description;
};

/// The name of another shard's file, by that of one which has the number of its shard in it.
std::string name_like(const Part& known, std::uint64_t number) {
    const std::filesystem::path path = scene::path_of(known.file);
    std::string name = scene::name_of_path(path.filename());
    const std::string own = std::to_string(known.description.shard.number);
    const std::size_t found = name.rfind(own, name.rfind('.'));
    if (found == std::string::npos) return "part-" + std::to_string(number) + ".jsonl";
    name.replace(found, own.size(), std::to_string(number));
    return scene::name_of_path(path.parent_path() / scene::path_of(name));
}

/// How to compute the shard \p number.
std::string command(const Part& known, std::uint64_t number, const std::string& file) {
    return "fstiff sweep " + known.description.grid + " --shard " + Shard{number, known.description.shard.of}.text() +
           " -o " + file;
}

/// Errors of the shards as a whole.
std::vector<std::string> problems_of(const std::vector<Part>& parts) {
    std::vector<std::string> problems;
    const Part& first = parts.front();
    std::map<std::uint64_t, const Part*> by_number;
    for (const Part& part : parts) {
        const Description& of = part.description;
        if (of.hash != first.description.hash) {
            problems.push_back(part.file + " and " + first.file +
                               " are of different grids, or of one that was changed between them (hash " +
                               of.hash.substr(0, 12) + " and " + first.description.hash.substr(0, 12) +
                               "): run the shards of the old one again");
            continue;
        }
        if (of.shard.of != first.description.shard.of) {
            problems.push_back(part.file + " is shard " + of.shard.text() + " and " + first.file + " is shard " +
                               first.description.shard.text() + ": must be parts of one division");
            continue;
        }
        const auto [there, is_new] = by_number.emplace(of.shard.number, &part);
        if (!is_new)
            problems.push_back("shard " + of.shard.text() + " is given twice, as " + there->second->file + " and " +
                               part.file + ": leave one of them out");
        else if (!of.finished)
            problems.push_back(part.file + " is not finished; run: " + command(first, of.shard.number, part.file));
    }
    if (!problems.empty() && by_number.size() < parts.size()) return problems;
    for (std::uint64_t number = 1; number <= first.description.shard.of; ++number) {
        if (by_number.contains(number)) continue;
        problems.push_back("shard " + Shard{number, first.description.shard.of}.text() +
                           " is missing; run: " + command(first, number, name_like(first, number)));
    }
    return problems;
}

}  // namespace

Merged merge(std::vector<std::string> files, const std::string& output) {
    std::error_code none;
    const auto is_output = [&, target = scene::path_of(output)](const std::string& file) {
        return std::filesystem::equivalent(scene::path_of(file), target, none);
    };
    const bool own_output = std::any_of(files.begin(), files.end(), is_output);
    std::erase_if(files, [&](const std::string& file) {
        return file.ends_with(".sweep") || is_output(file);  // of a merge before
    });
    std::vector<Part> parts;
    for (const std::string& file : files) parts.push_back({file, read_description(file)});
    Merged merged;
    if (parts.empty() && own_output)
        throw domain_error(output + ": is the only file of results and the output too; give the output another name");
    if (parts.empty()) throw domain_error("merge: no results are given; must be files that fstiff sweep wrote");
    merged.problems = problems_of(parts);
    if (!merged.problems.empty()) return merged;
    std::sort(parts.begin(), parts.end(),
              [](const Part& a, const Part& b) { return a.description.shard.number < b.description.shard.number; });

    // copied while it is looked at; what turns out to be wrong is thrown away
    Description whole = parts.front().description;
    whole.shard = {};
    whole.bytes = whole.failed = 0;
    replace_file(scene::name_of_path(scene::output_target(output)), [&](const OpenFile& to) {
        for (const Part& part : parts) {
            const Description& of = part.description;
            const std::uint64_t first = of.shard.first(of.scenes), end = of.shard.end(of.scenes);
            const OpenFile from(part.file, scene::os::Opening::read, "cannot be read");
            const Scan scan = scan_results(from, first, true, [&](std::string_view bytes) {
                if (merged.problems.empty()) to.write(bytes);
            });
            if (scan.next != end || scan.kept != scan.bytes || scan.bytes != of.bytes)
                merged.problems.push_back(part.file + " was changed since it was finished: whole up to scene " +
                                          std::to_string(scan.next) + " of " + std::to_string(end) +
                                          "; remove it and " + description_file(part.file) +
                                          ", and run: " + command(part, of.shard.number, part.file));
            whole.bytes += scan.bytes;
            whole.failed += scan.failed;
        }
        return merged.problems.empty();
    });
    if (!merged.problems.empty()) return merged;
    write_description(output, whole);
    merged.scenes = whole.scenes;
    merged.failed = whole.failed;
    merged.shards = parts.size();
    return merged;
}

}  // namespace fstiff::sweep
