// SPDX-License-Identifier: BSD-3-Clause
// fstiff formats: the files that are read.
#include "commands/commands.hpp"
#include "surface/surface_file.hpp"

#include <array>
#include <memory>

namespace fstiff::cli {
namespace formats_command {
namespace {

/// A file that some command reads.
struct Row {
    std::string_view name;  ///< as --input-format names it, for a surface
    std::string_view endings, holds, recognised, asked;
};

/// The name of a surface's file decides nothing: its first bytes and lines do.
constexpr std::array<Row, 22> rows{{
    {"profile", ".csv .txt .dat .asc ...", "text: heights, or position and height in a line",
     "one or two columns, or --spacing or --column", "--units without a header that has them; --spacing of heights"},
    {"triples", ".xyz .csv .txt ...", "text: x, y, z in a line", "three columns that fill a rectangular grid",
     "--units without a header that has them"},
    {"matrix", ".txt .asc .csv ...",
     "text: a row of the map in a line; exports of Gwyddion in any language, Keyence, SPIP, ESRI",
     "four columns and more, or a size in the header or by --dx or --width",
     "--units, and --dx or --width, without a header that has them"},
    {"sdf", ".sdf", "ISO 25178-71, text or binary", "its first bytes, such as aISO-1.0 or bISO-1.0", "nothing"},
    {"x3p", ".x3p", "ISO 25178-72, where fstiff was built with zlib and pugixml",
     "its first bytes, those of a ZIP archive", "nothing"},
    {"npy", ".npy", "NumPy array of integers or floating point: one dimension is a profile, two are a map",
     "its first bytes, \\x93NUMPY", "--units, and --spacing of a profile, --dx or --width of a map"},
    {"gsf", ".gsf", "Gwyddion simple field, with XReal, YReal and units of length", "its first bytes", "nothing"},
    {"gwy", ".gwy", "Gwyddion file: one channel, its masked points missing", "its first bytes, GWYP",
     "--channel, to read another than the lowest in lengths"},
    {"sur", ".sur .pro", "Digital Surf of 16 or 32 bits, one object, compressed where fstiff was built with zlib",
     "its first bytes, DIGITAL SURF or DSCOMPRESSED", "nothing"},
    {"smd", ".smd .prf", "profile of ISO 5436-2, and the older form of Mahr and Taylor Hobson",
     "its first line, ISO 5436, or its second, which ends with PRF", "nothing"},
    {"metropro", ".dat", "map of Zygo MetroPro", "its first bytes", "nothing"},
    {"vk4", ".vk3 .vk4 .vk6 .vk7", "map of Keyence VK; .vk6 and .vk7 where fstiff reads X3P",
     "its first bytes, VK3_ to VK7", "nothing"},
    {"opd", ".opd", "map of Wyko and Bruker Vision", "its first bytes", "nothing"},
    {"al3d", ".al3d", "map of Alicona", "its first bytes, AliconaImaging", "nothing"},
    {"plu", ".plu .apx", "map of Sensofar and Leica DCM", "the date and the counts in its header", "nothing"},
    {"plux", ".plux", "map of Sensofar, where fstiff reads X3P",
     "its first bytes, those of a ZIP archive, and its index.xml", "nothing"},
    {"stl", ".stl", "triangles over a grid of x and y, binary or text", "its size, or its first words, solid and facet",
     "--units"},
    {"netcdf", ".nc", "surface of contact.engineering, classic NetCDF", "its first bytes, CDF", "nothing"},
    {"opdx", ".opdx", "profile or map of Bruker Dektak", "its first bytes, VCA DATA", "nothing"},
    {"scene", ".toml", "TOML, as run --example prints it", "an argument of run, identify and report", "nothing"},
    {"surface", ".json", "the JSON of measure", "an argument of --surface, or surface.from in a scene", "nothing"},
    {"curve", ".csv", "text: pressure, and stiffness or reflection, with their errors if they are known",
     "an argument of identify --measured or ultrasound --reflection", "the columns and units in its first line"},
}};

/// Every form of a surface that can be asked for must be in the table.
constexpr bool is_complete() {
    for (const std::string_view name : parts::choices<io::SurfaceFormat>()) {
        bool found = name == "auto";
        for (const Row& row : rows) found = found || row.name == name;
        if (!found) return false;
    }
    return true;
}
static_assert(is_complete());

Document formats() {
    Document document("formats", 15);
    document.title("files that are read");
    for (const Row& row : rows) {
        document.line("\n" + std::string(row.name) + "  (" + std::string(row.endings) + ")");
        document.line("holds", row.holds);
        document.line("recognised by", row.recognised);
        document.line("needs", row.asked);
    }
    document.line(
        "\nThe first nineteen are profiles and maps, for measure, truth and run --surface. The name of a file\n"
        "is not used; --input-format overrides what was recognised. Text may be UTF-8, UTF-16 with a byte\n"
        "order mark, or of an 8-bit code page. Export files of other instruments from their own program, or convert\n"
        "them to X3P by a line of Python (docs/formats.md).");
    Rows table;
    table.add({"name"}, rows, &Row::name);
    table.add({"endings"}, rows, &Row::endings);
    table.add({"holds"}, rows, &Row::holds);
    table.add({"recognised_by"}, rows, &Row::recognised);
    table.add({"asks_for"}, rows, &Row::asked);
    document.table(std::move(table), {.key = "formats", .as_list = true});
    document.has_warnings = false;
    return document;
}

}  // namespace
}  // namespace formats_command

Command add_formats(Arguments& command) {
    using namespace formats_command;
    auto options = std::make_shared<OutputOptions>();
    add_output_options(command, *options);
    return {options.get(), [options] { return report(formats(), options->format); }};
}

}  // namespace fstiff::cli
