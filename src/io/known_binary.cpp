// SPDX-License-Identifier: BSD-3-Clause
#include "io/known_binary.hpp"

#include "io/stl.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Name of a binary format with these first bytes, and how to convert it.
struct KnownBinary {
    std::string_view magic;
    std::string_view name;
    std::string_view way;  // how its heights get out
};

constexpr std::string_view from_the_instrument = "export it from the program of the instrument or from Gwyddion";
constexpr std::string_view from_gwyddion = "save it with a newer Gwyddion";
constexpr std::string_view no_heights = "it is not a measured surface: export the heights themselves";
constexpr std::string_view from_python = "write its array with a few lines of Python";
constexpr std::string_view unpack = "unpack it first";

constexpr std::array known_binaries{
    KnownBinary{"\x89PNG\r\n", "a PNG picture", no_heights},
    KnownBinary{"\xFF\xD8\xFF", "a JPEG picture", no_heights},
    KnownBinary{"GIF8", "a GIF picture", no_heights},
    KnownBinary{std::string_view("II*\0", 4), "a TIFF picture", from_the_instrument},
    KnownBinary{std::string_view("MM\0*", 4), "a TIFF picture", from_the_instrument},
    KnownBinary{"%PDF-", "a PDF document", no_heights},
    KnownBinary{"\x89HDF\r\n", "an HDF5 file", from_python},
    KnownBinary{"MATLAB 5.0", "a MATLAB file", "write its matrix as text"},
    KnownBinary{"GWYO", "a file of Gwyddion 1 (.gwy)", from_gwyddion},
    KnownBinary{"\\*File list", "a Nanoscope file of an atomic force microscope", from_the_instrument},
    KnownBinary{"\x1F\x8B", "a file packed by gzip", unpack},
    KnownBinary{"BZh", "a file packed by bzip2", unpack},
    KnownBinary{"\xFD"
                "7zXZ",
                "a file packed by xz", unpack},
    KnownBinary{"7z\xBC\xAF", "a 7z archive", unpack},
    KnownBinary{"Rar!", "a RAR archive", unpack},
    KnownBinary{"PK\x03\x04", "a zip archive", "unpack it first; of an Excel workbook (.xlsx), save the sheet as CSV"},
    KnownBinary{"\xD0\xCF\x11\xE0", "an old Office document (.xls) or a file of its container",
                "save the sheet as CSV, or export it from the program that wrote it"},
    KnownBinary{"SQLite format 3", "a database", no_heights},
    KnownBinary{"\x7F"
                "ELF",
                "a program", no_heights},
};

}  // namespace

std::string known_binary_refusal(std::string_view bytes) {
    std::string_view name, way;
    for (const KnownBinary& known : known_binaries)
        if (name.empty() && bytes.starts_with(known.magic) &&
            // what a Nanoscope exports as text begins so too
            (known.magic[0] != '\\' || bytes.find('\0') != std::string_view::npos)) {
            name = known.name;
            way = known.way;
        }
    if (name.empty()) return {};
    return "is binary: " + std::string(name) + ", which is not read; must be " + std::string(readable_forms) + ": " +
           std::string(way);
}

bool may_hold_nul_bytes(std::string_view bytes) {
    for (const std::string_view first : {"PK", "\x93NUMPY", "Gwyddion Simple Field", "GWYP", "DIGITAL SURF",
                                         "DSCOMPRESSED", "ISO 5436", "\xFF\xFE", "\xFE\xFF"})
        if (bytes.starts_with(first)) return true;
    if (form_of_first_bytes(bytes) != SurfaceFormat::automatic || may_be_stl(bytes)) return true;
    return bytes.size() > 4 && (bytes.substr(1, 3) == "ISO" || bytes.substr(1, 3) == "BCR");
}

}  // namespace fstiff::inline v0_1::io::detail
