// SPDX-License-Identifier: BSD-3-Clause
// Binary files are called by their names; endless ones are refused at their first block.
#include "io/lines.hpp"
#include "support/samples.hpp"

namespace known_binary_test {

using namespace fstiff;
using namespace std::string_literals;

namespace {

const test::RefusalOf refusal{test::FileReader()};

}  // namespace

TEST_CASE("A binary file is named by its first bytes with a way to convert it") {
    const std::pair<std::string, const char*> files[] = {{"\x89PNG\r\n\x1A\n\0\0"s, "PNG"},
                                                         {"\xFF\xD8\xFF\xE0"s, "JPEG"},
                                                         {"II*\0"s, "TIFF"},
                                                         {"MM\0*"s, "TIFF"},
                                                         {"%PDF-1.7\n"s, "PDF"},
                                                         {"\x89HDF\r\n\x1A\n"s, "HDF5"},
                                                         {"GWYO\0"s, "Gwyddion 1"},
                                                         {"\x1F\x8B\x08"s, "gzip"},
                                                         {"\xD0\xCF\x11\xE0\xA1"s, ".xls"},
                                                         {"\\*File list\0"s, "Nanoscope"}};
    for (const auto& [bytes, name] : files) {
        INFO(name);
        CHECK(test::contains(refusal(bytes), name));
        CHECK(test::contains(refusal(bytes), "is binary: "));
        CHECK(test::contains(refusal(bytes),
                             "not read; must be text (a profile, a matrix, or x, y, z), .sdf, .x3p, .npy, "));
    }
    CHECK(test::contains(refusal("1 2\n\0"s), "holds NUL bytes"));
    const std::string stl = std::string(80, 'x') + test::little(2, 4) + test::little(0.0F) + test::little(0.6F) +
                            test::little(-0.8F) + std::string(88, '\0');
    const std::pair<std::string, const char*> others[] = {{"Binary TrueMap Data File v2.0\r\n\0"s, ".tmd"},
                                                          {"fileType      Image\n\0"s, ".mi"},
                                                          {"[DataSet]\r\nGroupCount=1\r\n\0"s, ".nid"},
                                                          {"FRTM_GLIDERV1.00\0"s, ".frt"},
                                                          {"fileformat = bcrf\n\0"s, ".bcrf"},
                                                          {"WSxM file copyright UAM\nSxM Image file\n\0"s, ".stp"},
                                                          {"BM\x36\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0"s, "BMP"},
                                                          {"\5\0\xFB\xFF"s + std::string(380, '\0'), ".ibw"},
                                                          {"P5\n2 2\n255\nabcd", "PGM"},
                                                          {"P2\n2 2\n255\n1 2\n3 4\n", "PGM"},
                                                          {"{\\rtf1\\ansi 1 2 3}", ".rtf"},
                                                          {"solid plate\nfacet normal 0 0 1\n", ".stl"},
                                                          {"# vtk DataFile Version 3.0\nz\nASCII\n1 2\n3 4\n", ".vtk"},
                                                          {stl, ".stl"},
                                                          {"KPK1\0"s, ".zon"},
                                                          {"OmniSurf3D\0"s, ".os3d"},
                                                          {"Zeta-Instruments\0"s, ".zmg"},
                                                          {"\x01\xB0\x93\xFF\0"s, ".mdt"},
                                                          {"OLYMPUSRAWFORMAT\0"s, ".oir"},
                                                          {"ZISRAWFILE\0"s, ".czi"},
                                                          {"WIT_PR06\0"s, ".wip"},
                                                          {"\x70\0\0\0\x64\0\0\0*\x10\0\0\0<\0L\0"s, ".lif"},
                                                          {"LASF\0"s, ".las"},
                                                          {"ASTM-E57\1\0"s, ".e57"},
                                                          {"# .PCD v0.7\nDATA binary\n\0"s, ".pcd"},
                                                          {"TDSm\x0E\0"s, ".tdms"},
                                                          {"CPYA 4.3318\0"s, ".opj"},
                                                          {"PAR1\x15\0"s, "Parquet"},
                                                          {"SIMPLE  =    T\n", "FITS"},
                                                          {"\x80\x04\x95\0"s, "pickle"},
                                                          {"MATLAB 7.3 MAT-file\0"s, "save(..., '-v7')"},
                                                          {"\x89HDF\r\n\x1A\n\0"s, ".datx"},
                                                          {"ISO-10303-21;\nHEADER;\n", ".stp"},
                                                          {"<svg width='1' height='2'>", "SVG"},
                                                          {"{\"x\": [1, 2], \"z\": [3, 4]}", "JSON"},
                                                          {"[[0, 1.5], [1, 2.5]]", "JSON"},
                                                          {"[ 1.5, 2.5]\n", "JSON"}};
    for (const auto& [bytes, name] : others) {
        INFO(name);
        CHECK(test::contains(refusal(bytes), name));
        CHECK(test::contains(refusal(bytes), "which is not read; must be text"));
        const std::string_view of_instruments[] = {".tmd", ".mi",  ".frt", ".bcrf", ".ibw",
                                                   ".zon", ".zmg", ".mdt", ".oir",  ".os3d"};
        for (const std::string_view of_instrument : of_instruments)
            if (name == of_instrument) CHECK(test::contains(refusal(bytes), "python -m fstiff run --surface FILE"));
    }
}

TEST_CASE("Text that begins as another form is read all the same") {
    std::string text = "[1] 0.5\n";  // as R prints
    for (int i = 0; i < 40; ++i) text += std::to_string(i * i % 7) + "\n";
    CHECK_FALSE(test::contains(refusal(text), "JSON"));
    CHECK(test::contains(refusal(std::string(300, '\1') + '\0'), "export the heights from the program that wrote it"));
}

TEST_CASE("Endless input is refused at its first block") {
    struct Endless : std::streambuf {
        char block[65536]{};
        int calls = 0;
        int_type underflow() override {
            if (++calls > 4) throw std::logic_error("read on");
            setg(block, block, block + sizeof block);
            return 0;
        }
    } buffer;
    std::istream input(&buffer);
    const std::string bytes = io::detail::read_bytes(input, "zero").bytes;
    CHECK(bytes.size() <= 2 * sizeof buffer.block);
    CHECK(test::contains(refusal(bytes), "is binary"));
    CHECK(buffer.calls <= 2);
}

}  // namespace known_binary_test
