// SPDX-License-Identifier: BSD-3-Clause
#include "io/known_binary.hpp"

#include "io/binary_numbers.hpp"
#include "io/number.hpp"
#include "io/readers.hpp"
#include "io/utf16.hpp"

#include <cmath>

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Name of a binary format with these first bytes, and how to convert it.
struct KnownBinary {
    std::string_view magic;
    std::string_view name;
    std::string_view way;  // how its heights get out
};

// pip install 'fstiff[readers]' brings SurfaceTopography, which reads these
constexpr std::string_view from_the_instrument =
    "read it by python -m fstiff run --surface FILE, of the Python package with fstiff[readers], or export it from the "
    "program of the instrument or from Gwyddion";
constexpr std::string_view from_gwyddion = "save it with a newer Gwyddion";
constexpr std::string_view no_heights = "it is not a measured surface: export the heights themselves";
constexpr std::string_view from_python =
    "read it by python -m fstiff run --surface FILE, of the Python package with fstiff[readers], or write its array "
    "with "
    "a few lines of Python";
constexpr std::string_view unpack = "unpack it first";
constexpr std::string_view as_csv = "export its table as CSV";
constexpr std::string_view points = "export its points as a text of x, y and z";
constexpr std::string_view sample = "make an array of its heights by the lines with trimesh in docs/formats.md";
constexpr std::string_view json =
    "must be a list of points, [[x, y, z], ...], for the command, or numbers as CSV, or given to fstiff.measure in "
    "Python";
constexpr std::string_view from_the_program = "export the heights from the program that wrote it";

constexpr std::array known_binaries{
    KnownBinary{"\x89PNG\r\n", "a PNG picture", no_heights},
    KnownBinary{"\xFF\xD8\xFF", "a JPEG picture", no_heights},
    KnownBinary{"GIF8", "a GIF picture", no_heights},
    KnownBinary{"P5\n", "a PGM picture", no_heights},
    KnownBinary{"P6\n", "a PPM picture", no_heights},
    KnownBinary{std::string_view("II*\0", 4), "a TIFF picture or a file of JPK or Olympus (.tif, .jpk, .lext)",
                from_the_instrument},
    KnownBinary{std::string_view("MM\0*", 4), "a TIFF picture or a file of JPK or Olympus (.tif, .jpk, .lext)",
                from_the_instrument},
    KnownBinary{std::string_view("II+\0", 4), "a BigTIFF picture", no_heights},
    KnownBinary{"RIFF", "a picture, sound or film (RIFF)", no_heights},
    KnownBinary{"%!PS", "a PostScript picture", no_heights},
    KnownBinary{"%PDF-", "a PDF document", no_heights},
    KnownBinary{"\x89HDF\r\n", "an HDF5 file, such as a .datx of Zygo", from_python},
    KnownBinary{"MATLAB 7.3", "a MATLAB file of version 7.3 (.mat), which is HDF5",
                "save it in MATLAB by save(..., '-v7')"},
    KnownBinary{"GWYO", "a file of Gwyddion 1 (.gwy)", from_gwyddion},
    KnownBinary{"\\*File list", "a Nanoscope file of an atomic force microscope", from_the_instrument},
    KnownBinary{"Binary TrueMap Data File", "a TrueMap file (.tmd)", from_the_instrument},
    KnownBinary{"fileType ", "a file of Molecular Imaging or Agilent (.mi)", from_the_instrument},
    KnownBinary{"[DataSet]", "a Nanosurf file (.nid, .ezd)", from_the_instrument},
    KnownBinary{"FRTM_GLIDERV", "a file of FRT MicroProf (.frt)", from_the_instrument},
    KnownBinary{"fileformat = bcr", "a file of SPIP (.bcr, .bcrf)", from_the_instrument},
    KnownBinary{std::string_view("f\0i\0l\0e\0f\0o\0r\0m\0a\0t\0", 20), "a file of SPIP (.bcr, .bcrf)",
                from_the_instrument},
    KnownBinary{"WSxM file copyright", "a file of WSxM (.top, .stp, .tom)", from_the_instrument},
    KnownBinary{":NANONIS_VERSION:", "a Nanonis file (.sxm)", from_the_instrument},
    KnownBinary{"KPK0", "a file of Keyence VR (.zon)", from_the_instrument},
    KnownBinary{"KPK1", "a file of Keyence VR (.zon)", from_the_instrument},
    KnownBinary{"OmniSurf3D", "a file of OmniSurf3D (.os3d)", from_the_instrument},
    KnownBinary{"Zeta-Instruments", "a file of Zeta (.zmg)", from_the_instrument},
    KnownBinary{"\x01\xB0\x93\xFF", "a file of NT-MDT (.mdt)", from_the_instrument},
    KnownBinary{"OLYMPUSRAWFORMAT", "a file of an Olympus microscope (.oir)", from_the_instrument},
    KnownBinary{"ZISRAWFILE", "a file of a Zeiss microscope (.czi)", from_the_program},
    KnownBinary{"WIT_PR", "a project of WITec (.wip)", from_the_program},
    KnownBinary{"LASF", "a cloud of points (.las, .laz)", points},
    KnownBinary{"ASTM-E57", "a cloud of points (.e57)", points},
    KnownBinary{"# .PCD", "a cloud of points (.pcd)", points},
    KnownBinary{"# vtk DataFile", "a file of VTK (.vtk)", points},
    KnownBinary{"glTF", "a mesh (.glb)", sample},
    KnownBinary{"Kaydara FBX", "a mesh (.fbx)", sample},
    KnownBinary{"TDSm", "a file of LabVIEW (.tdms)", as_csv},
    KnownBinary{"CPYA", "a project of Origin (.opj)", as_csv},
    KnownBinary{"CPYUA", "a project of Origin (.opju)", as_csv},
    KnownBinary{"PAR1", "a table of Parquet", as_csv},
    KnownBinary{"ARROW1", "a table of Arrow (.feather)", as_csv},
    KnownBinary{"SIMPLE  =", "a FITS image", from_python},
    KnownBinary{"\x80\x04\x95", "a pickle of Python", from_python},
    KnownBinary{"\x80\x05\x95", "a pickle of Python", from_python},
    KnownBinary{"\x28\xB5\x2F\xFD", "a file packed by zstd", unpack},
    KnownBinary{"\x1F\x8B", "a file packed by gzip", unpack},
    KnownBinary{"BZh", "a file packed by bzip2", unpack},
    KnownBinary{"\xFD"
                "7zXZ",
                "a file packed by xz", unpack},
    KnownBinary{"7z\xBC\xAF", "a 7z archive", unpack},
    KnownBinary{"Rar!", "a RAR archive", unpack},
    KnownBinary{"PK\x03\x04", "a zip archive",
                "unpack it first; of an Excel workbook (.xlsx), save the sheet as CSV, or read it by python -m fstiff "
                "run --surface "
                "FILE, of the Python package with fstiff[readers]"},
    KnownBinary{"\xD0\xCF\x11\xE0", "an old Office document (.xls) or another file of its container, such as a .mnt",
                "save the sheet as CSV, or read a .mnt by python -m fstiff run --surface FILE, of the Python package "
                "with fstiff[readers]"},
    KnownBinary{"SQLite format 3", "a database", no_heights},
    KnownBinary{"\x7F"
                "ELF",
                "a program", no_heights},
};

/// Text that is no table, by its first words.
constexpr std::array known_texts{
    KnownBinary{"P2", "a PGM picture", no_heights},
    KnownBinary{"P3", "a PPM picture", no_heights},
    KnownBinary{"{\\rtf", "a text of a word processor (.rtf)", "save it as plain text"},
    KnownBinary{"solid", "a mesh of triangles (.stl)", sample},
    KnownBinary{"ISO-10303-21", "a part of CAD (.stp)", no_heights},
    KnownBinary{"{", "a text of JSON", json},
    KnownBinary{"[", "a text of JSON", json},
    KnownBinary{"<svg", "an SVG picture", no_heights},
    KnownBinary{"# vtk DataFile", "a file of VTK (.vtk)", points},
    KnownBinary{"<VTKFile", "a file of VTK (.vtu, .vti)", points},
    KnownBinary{"<?xml", "a text of XML", from_the_program},
    KnownBinary{"<!DOCTYPE html", "a page of HTML", from_the_program},
    KnownBinary{"<html", "a page of HTML", from_the_program},
};

/// Whether texts begin with \p magic too, as those that a microscope exports.
bool is_text_beside(std::string_view magic) {
    return magic[0] == '\\' || magic[0] == '[' || magic[0] == '#' || magic[0] == ':' || magic.starts_with("file") ||
           magic.starts_with("WSxM");
}

/// Whether \p rest begins with the words of \p magic and not with longer ones: "P2" and a size.
bool is_whole(std::string_view magic, std::string_view rest) {
    const std::string_view behind = rest.substr(magic.size());
    if (magic == "{" || magic == "[") {  // R prints [1] before its numbers
        const std::string_view inner = trimmed(behind);
        const LeadingNumber number = leading_number(inner);
        return inner.starts_with('"') || inner.starts_with('{') || inner.starts_with('[') ||
               (number.status == NumberStatus::ok && trimmed(inner.substr(number.length)).starts_with(','));
    }
    if (magic[0] == 'P') return behind.empty() || is_blank(behind[0]);
    return magic != "solid" || rest.substr(0, 4096).find("facet") < rest.size();
}

/// The number of \p size bytes at \p place, least significant first; 0 beyond the end.
std::uint64_t number_at(std::string_view bytes, std::size_t place, std::size_t size) {
    return bytes.size() < place + size ? 0 : unsigned_at(bytes.substr(place, size), false);
}

/// Forms without first words, by what their header holds.
KnownBinary known_by_content(std::string_view bytes) {
    // a bitmap states its size; packed in two bytes, so may text begin
    if (bytes.starts_with("BM") && number_at(bytes, 6, 4) == 0 && number_at(bytes, 14, 4) >= 12 &&
        number_at(bytes, 14, 4) <= 128)
        return {{}, "a BMP picture", no_heights};
    // STL: a title of 80 bytes, the number of triangles, and 50 bytes of each, which begin with its unit normal
    if (bytes.size() > 134 && 84 + 50 * number_at(bytes, 80, 4) >= bytes.size() &&
        std::abs(std::hypot(float_at(bytes.substr(84)), float_at(bytes.substr(88)), float_at(bytes.substr(92))) - 1) <
            1e-3)
        return {{}, "a mesh of triangles (.stl)", sample};
    // a wave of Igor: version 5 or 2, in either byte order, its header such that its words of 16 bits cancel
    for (const bool big : {false, true})
        for (const auto& [version, header] : {std::pair<std::uint64_t, std::size_t>{5, 384}, {2, 126}}) {
            if (bytes.size() < header || unsigned_at(bytes.substr(0, 2), big) != version) continue;
            std::uint64_t sum = 0;
            for (std::size_t i = 0; i < header; i += 2) sum += unsigned_at(bytes.substr(i, 2), big);
            if (sum % 65536 == 0)
                return {{}, "a wave of Igor Pro (.ibw), as Asylum Research writes it", from_the_instrument};
        }
    // Nanofocus: points and steps in mm at fixed places, then heights of two bytes
    const std::uint64_t columns = number_at(bytes, 1368, 4), rows = number_at(bytes, 1372, 4);
    if (bytes.size() > 3468 && columns > 1 && rows > 1 && columns < 100000 && rows < 100000 &&
        bytes.size() >= 3468 + 2 * columns * rows && double_at(bytes.substr(1376)) > 1e-9 &&
        double_at(bytes.substr(1376)) < 10 && double_at(bytes.substr(1384)) > 1e-9 &&
        double_at(bytes.substr(1384)) < 10)
        return {{}, "a file of Nanofocus (.nms)", from_the_instrument};
    // Leica: the length of a part, a star, and the length of its text in UTF-16
    if (number_at(bytes, 0, 4) == 0x70 && bytes.size() > 13 && bytes[8] == '*' && bytes[13] == '<')
        return {{}, "a file of a Leica microscope (.lif)", from_the_program};
    return {};
}

}  // namespace

std::string readable_forms() {
    std::string forms = "text (a profile, a matrix, or x, y, z)";
    for (const Reader* reader : readers())
        if (reader->begins)
            for (const char c : " " + std::string(reader->endings)) forms += c == ' ' ? ", " : std::string(1, c);
    return forms;
}

std::string known_binary_refusal(std::string_view bytes) {
    const auto refusal = [](const KnownBinary& known, const char* what) {
        return known.name.empty() ? std::string()
                                  : "is " + (what + std::string(known.name)) + ", which is not read; must be " +
                                        readable_forms() + ": " + std::string(known.way);
    };
    const bool has_nul = bytes.find('\0') != std::string_view::npos;
    for (const KnownBinary& known : known_binaries)
        // what instruments export as text begins so too
        if (bytes.starts_with(known.magic) && (has_nul || !is_text_beside(known.magic)))
            return refusal(known, "binary: ");
    if (has_nul) return refusal(known_by_content(bytes), "binary: ");
    std::string_view rest = bytes.substr(bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    for (const KnownBinary& known : known_texts)
        if (rest.starts_with(known.magic) && is_whole(known.magic, rest)) return refusal(known, "");
    return {};
}

bool may_hold_nul_bytes(std::string_view bytes) {
    const auto may_begin = [&](const Reader* reader) {
        return (reader->begins && reader->begins(bytes)) || (reader->may_begin && reader->may_begin(bytes));
    };
    return is_utf16(bytes) || std::any_of(readers().begin(), readers().end(), may_begin);
}

}  // namespace fstiff::inline v0_1::io::detail
