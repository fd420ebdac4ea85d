// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads maps of Keyence VK microscopes (.vk3, .vk4, .vk6, .vk7).
///
/// "VK3_" or "VK4_", and a table of places in the file (uint32, the least significant byte first), of which are used:
///
///     12  of the settings                            36, 40, 44  of up to three images of heights, 0: none
///
/// The settings have at their bytes 168 and 172 the steps of x and y, at 176 that of the heights, as uint32 in pm. An
/// image has at its bytes 0 columns, 4 rows, 8 bits of a height (8, 16, 32), 12 compression (0: none), 16 bytes of the
/// heights, and from 796 on, after a palette, the heights row after row as unsigned integers.
///
///     height = number times step of the heights
///
/// The first image is read, the record lists the others. Missing points are not marked in these files.
///
/// A .vk6 or .vk7 begins with "VK6" or "VK7" and a picture (a NUL byte distinguishes it from text); its end is a zip
/// archive with a .vk4 as its file Vk4File.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence)
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; .vk6 and .vk7 where X3P is read
/// Accuracy    number times step, rounded twice (tests/io/vk4_test.cpp)

#include "io/readers.hpp"

#include "io/file_bytes.hpp"
#include "io/unpack.hpp"
#include "io/zip_archive.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Content of the file.
struct VkHeader {
    std::string form;  // "VK4"
    std::uint64_t bits{};
    std::size_t images{};  // of heights
    double step{};         // of the heights [m]
};

Record record_of(const VkHeader& file, const RawMap& map) {
    Record record;
    record.note("form", "Keyence " + file.form + ", heights of " + std::to_string(file.bits) + " bits");
    record.note("units", "pm, heights in steps of " + number_text(file.step) + " m, from the settings of the file");
    record.note("spacing", "from the steps of x and y in the settings");
    record.note_points(map, " (the form marks none)");
    if (file.images > 1) record.note("other images of heights", std::to_string(file.images - 1) + ", not read");
    record.resolution = file.step;
    return record;
}

/// The zip archive at the end of \p file, whose places count from its first byte or from that of the file.
std::string_view archive_at_end(const FileBytes& file) {
    const std::string_view bytes = file.at(0, file.size(), "the file");
    const std::size_t end = bytes.rfind("PK\5\6");
    if (end == std::string_view::npos)
        refuse_file(file.name(), {"has no zip archive after its picture; must be a whole .vk6 or .vk7"});
    const std::uint64_t size = file.number(end + 12, 4, "the end of its archive");
    const std::uint64_t place = file.number(end + 16, 4, "the end of its archive");
    if (size > end || place > end - size)
        refuse_file(file.name(), {"has a zip archive whose table is not where its end states; must be whole"});
    return bytes.substr(static_cast<std::size_t>(end - size - place));
}

/// A step of the settings, which are in pm [m].
double vk_step(const FileBytes& file, std::uint64_t place, const std::string& field) {
    const std::uint64_t picometers = file.number(place, 4, field);
    if (picometers == 0) refuse_field(file.name(), field, "0", "at least 1 pm");
    return static_cast<double>(picometers) * 1e-12;
}

/// The first image of heights of a .vk3 or .vk4.
Reading read_vk4_image(const FileBytes& file, VkHeader header) {
    const std::uint64_t settings = file.number(12, 4, "place of the settings");
    std::uint64_t image = 0;
    for (const std::uint64_t place : {44U, 40U, 36U})
        if (const std::uint64_t there = file.number(place, 4, "places of the images of heights"); there != 0) {
            image = there;
            ++header.images;
        }
    if (image == 0) refuse_file(file.name(), {"holds no image of heights; must hold one"});
    header.bits = file.number(image + 8, 4, "bits of a height");
    if (header.bits != 8 && header.bits != 16 && header.bits != 32)
        refuse_field(file.name(), "bits of a height", std::to_string(header.bits), "8, 16 or 32");
    if (const std::uint64_t packed = file.number(image + 12, 4, "compression"); packed != 0)
        refuse_field(file.name(), "compression", std::to_string(packed), "0 (none)");
    const StoredGrid grid{.place = image + 796,
                          .size = static_cast<std::size_t>(header.bits / 8),
                          .columns = file.number(image, 4, "columns"),
                          .rows = file.number(image + 4, 4, "rows")};
    header.step = vk_step(file, settings + 176, "step of the heights");
    RawMap map;
    read_grid(map, file, grid,
              [&](std::string_view height) { return static_cast<double>(unsigned_at(height, false)) * header.step; });
    set_spacings(map, vk_step(file, settings + 168, "step of x"), vk_step(file, settings + 172, "step of y"),
                 file.name());
    Record record = record_of(header, map);
    return {std::move(map), std::move(record)};
}

bool holds_vk4(std::string_view bytes) { return bytes.starts_with("VK4_") || bytes.starts_with("VK3_"); }

bool is_vk4(std::string_view bytes) {
    const bool packed = bytes.starts_with("VK6") || bytes.starts_with("VK7");
    return holds_vk4(bytes) || (packed && bytes.substr(0, 64).find('\0') != std::string_view::npos);
}

}  // namespace

Reading read_vk4(std::string_view bytes, const std::string& name, const Unzip& unzip) {
    if (!is_vk4(bytes)) refuse_file(name, {"does not begin as a file of Keyence VK; must begin with VK3_ to VK7"});
    const std::string form(bytes.substr(0, 3));
    if (holds_vk4(bytes)) return read_vk4_image(FileBytes(bytes, name), {.form = form});
    if (!unzip)
        refuse_file(name, {"is Keyence ", form,
                           ", which this program was built without (it needs what X3P needs); "
                           "must be saved as VK4"});
    const std::string inner = unzip(archive_at_end(FileBytes(bytes, name)), "Vk4File");
    if (!holds_vk4(inner)) refuse_file(name, {"holds a Vk4File that does not begin with VK4_; must begin so"});
    return read_vk4_image(FileBytes(inner, name), {.form = form});
}

extern constexpr Reader vk4_reader{
    .format = SurfaceFormat::vk4,
    .endings = ".vk3 .vk4 .vk6 .vk7",
    .holds = "map of Keyence VK; .vk6 and .vk7 where fstiff reads X3P",
    .recognised = "its first bytes, VK3_ to VK7",
    .begins = is_vk4,
    .read = [](std::string_view bytes, const std::string& name, [[maybe_unused]] const SurfaceOptions& options) {
#ifdef FSTIFF_HAS_X3P
        return read_vk4(bytes, name, [&](std::string_view archive, std::string_view entry) {
            return ZipArchive(archive, name, options.x3p_limits).content_of(entry);
        });
#else
        return read_vk4(bytes, name);
#endif
    }};

}  // namespace fstiff::inline v0_1::io::detail
