// SPDX-License-Identifier: BSD-3-Clause
// Gives any bytes to the reader of one form, which returns something valid or refuses them in one line.
#include <fstiff/io/write.hpp>
#include "io/readers.hpp"
#include "io/unpack.hpp"
#include "surface/points_json.hpp"

#include "../support/stored_archive.hpp"
#include "fuzz.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

using namespace fstiff;
using io::SurfaceFormat;
using io::SurfaceOptions;

namespace {

/// assert that no build type switches off
void require(bool satisfied, const char* what) {
    if (satisfied) return;
    std::fprintf(stderr, "fuzz: %s\n", what);
    std::abort();
}

/// Whether \p call returned; else it refused, in one line.
template <class Call>
bool returns(const Call& call) {
    try {
        call();
        return true;
    } catch (const domain_error& error) {
        const std::string text = error.what();
        require(!text.empty() && text.size() < 2000, "a refusal must be one sentence");
        for (const char c : text) require(c != '\n' && c != '\0', "a refusal must be one line");
        return false;
    }
}

/// Options with which texts are read.
std::vector<SurfaceOptions> options_of_text(bool is_profile) {
    using enum SurfaceFormat;
    if (is_profile)
        return {{.format = profile},
                {.format = profile, .units = "um,nm"},
                {.format = profile, .units = "um", .spacing = 1e-6, .column = 1},
                {.format = profile, .units = "um", .x_column = 2},
                {.format = profile, .units = "um", .missing = "-9999,void", .resample = true}};
    return {{},
            {.format = triples, .units = "mm,um"},
            {.format = matrix, .units = "um", .dx = 1e-6, .height = 1e-3},
            {.format = matrix, .units = "um,um", .missing = "-9999,void"},
            {.format = triples, .units = "um,um", .missing = "-9999,void"},
            {.units = "um", .grid = 0.7e-6}};
}

void fuzz_text(const std::string& bytes, bool is_profile) {
    for (const SurfaceOptions& options : options_of_text(is_profile)) {
        io::Surface found;
        if (!returns([&] { found = io::read_surface(bytes, "file", options); })) continue;
        std::visit([](const auto& data) { data.validate(2); }, found.data);
        require(!is_profile || found.record.details.size() >= 5, "five sentences");
        for (const io::MapForm form : {io::MapForm::matrix, io::MapForm::triples}) {
            std::ostringstream output;
            if (!returns([&] {
                    if (found.is_profile())
                        io::write_csv(output, found.profile());
                    else
                        io::write_csv(output, found.map(), form);
                }))
                continue;
            const io::Surface again = io::read_surface(output.str(), "again", {.missing = "none"});  // must be read
            require(found.is_profile()
                        ? again.profile().size() == found.profile().size()
                        : again.map().rows() == found.map().rows() && again.map().columns() == found.map().columns(),
                    "the same shape");
        }
    }
}

/// Options with which a file of \p format is read.
std::vector<SurfaceOptions> options_of(SurfaceFormat format) {
    switch (format) {
        case SurfaceFormat::gwy: return {{}, {.channel = "1"}, {.channel = "Height"}};
        case SurfaceFormat::npy:
            return {{.units = "nm", .dx = 1e-6, .dy = 2e-6}, {.units = "nm", .spacing = 1e-6, .missing = "-9999"}};
        case SurfaceFormat::surfer: return {{}, {.units = "um,nm"}, {.units = "um", .missing = "0"}};
        case SurfaceFormat::mat:
            return {{.units = "um"},
                    {.units = "um,nm", .dx = 1e-6, .height = 1e-3, .channel = "2"},
                    {.units = "nm", .spacing = 1e-6, .channel = "1"}};
        case SurfaceFormat::ply:
        case SurfaceFormat::obj: return {{.units = "mm"}, {.units = "mm,um", .grid = 0.7e-3}};
        default: return {{.x3p_limits = {.bytes = 1 << 24}}};
    }
}

void check(SurfaceFormat format, const io::Reading& found) {
    io::detail::validate_map(found.map, 2);
    require(found.record.sentences().size() >= 4, "four sentences at least");
    for (const auto& [key, text] : found.record.entries)
        require(!key.empty() && !text.empty(), "a sentence says something");
    if (format == SurfaceFormat::smd) require(found.map.rows == 1 && found.map.columns >= 16, "a profile");
}

/// What is written as a surface data file must be read, with the same heights.
void write_and_read(const io::detail::Reader& sdf, const io::detail::RawMap& map) {
    const io::Surface surface = io::detail::surface_of({map, {}});
    for (const bool binary : {true, false}) {
        std::ostringstream output;
        if (!returns([&] {
                std::visit([&](const auto& data) { io::write_sdf(output, data, {.binary = binary}); }, surface.data);
            }))
            continue;
        const io::detail::RawMap again = sdf.read(output.str(), "again", {}).map;
        require(again.rows == map.rows && again.columns == map.columns, "the same shape");
        for (std::size_t i = 0; i < again.heights.size(); ++i)
            require(again.heights[i] == map.heights[i] || (std::isnan(again.heights[i]) && std::isnan(map.heights[i])),
                    "the same heights");
    }
}

void fuzz_reader(const io::detail::Reader& reader, const std::string& bytes) {
    for (const SurfaceOptions& options : options_of(reader.format)) {
        io::Reading found;
        // damaged archives seldom pass their check sums: that of a .vk6 is taken for its Vk4File
        const auto unzip = [](std::string_view archive, std::string_view) { return std::string(archive); };
        if (!returns([&] {
                found = reader.format == SurfaceFormat::vk4 ? io::detail::read_vk4(bytes, "file", unzip)
                                                            : reader.read(bytes, "file", options);
            }))
            continue;
        check(reader.format, found);
        if (reader.format == SurfaceFormat::sdf) write_and_read(reader, found.map);
    }
}

}  // namespace

void fuzz(const std::string& form, const std::string& bytes) {
    if (form == "points_json") {
        std::string text;
        if (surface::is_points_json(bytes) && returns([&] { text = surface::lines_of_points(bytes, "file").text; }))
            fuzz_text(text, false);
        return;
    }
    if (form.ends_with("_text")) return fuzz_text(bytes, form == "profile_text");
    const io::detail::Reader& reader = io::detail::reader_of(from_name<io::SurfaceFormat>(form, "form"));
    fuzz_reader(reader, bytes);
    const bool is_x3p = form == "x3p";
    if ((!is_x3p && form != "plux") || bytes.starts_with("PK\3\4")) return;
    // bytes that are no archive are its description, and those after its end the heights
    const std::size_t end = bytes.rfind('>') == std::string::npos ? bytes.size() : bytes.rfind('>') + 1;
    const std::string description = bytes.substr(0, end), heights = bytes.substr(end);
    fuzz_reader(reader, is_x3p ? test::stored_archive({{"main.xml", description},
                                                       {"bindata/data.bin", heights},
                                                       {"bindata/valid.bin", heights.substr(0, 2)}})
                               : test::stored_archive({{"index.xml", description}, {"z", heights}}));
}
