// SPDX-License-Identifier: BSD-3-Clause
// What holds for every reader: a sample is known by its first bytes, has the heights that its maker put in, is refused
// when it is cut short, and makes no use of options that are not its own.
#include "support/samples.hpp"
#include "support/skip.hpp"

namespace readers_test {

using namespace fstiff;
using io::SurfaceFormat;
using io::detail::Reader;

namespace {

/// A file of the corpus: its steps, the unit of its heights 10 row + column^2, and whether one is missing. dx is 0 if
/// the test of its reader compares the heights.
struct Sample {
    SurfaceFormat format;
    const char* file;
    std::size_t trailer = 0;  // bytes at its end that may be missing
    double dx = 0, dy = 0, unit = 0;
    std::size_t missing = 1;
};

constexpr double nominal = double(0.5e-6F), opd_step = double(0.5e-3F) * 1e-3;

constexpr Sample samples[] = {
    {SurfaceFormat::al3d, "al3d/map.al3d", 0, 0.5e-6, 0.25e-6, 0x1p-20},
    {SurfaceFormat::gsf, "gsf/map.gsf"},
    {SurfaceFormat::gsf, "gsf/profile.gsf"},
    {SurfaceFormat::gwy, "gwy/map.gwy"},
    {SurfaceFormat::gwy, "gwy/profile.gwy"},
    {SurfaceFormat::mat, "mat/big.mat"},
    {SurfaceFormat::mat, "mat/map.mat"},
    {SurfaceFormat::mat, "mat/packed.mat"},
    {SurfaceFormat::mat, "mat/profile.mat", 0, 0.5e-6, 0.5e-6, 1e-6, 0},
    {SurfaceFormat::metropro, "metropro/map.dat", 0, nominal, nominal, 2.0 * 0.5 / 32768 * nominal},
    {SurfaceFormat::netcdf, "netcdf/map.nc", 0, 0.5e-6, 0.25e-6, 1e-6},
    {SurfaceFormat::netcdf, "netcdf/profile.nc", 80, 0.5e-6, 0.5e-6, 1e-6, 0},  // the positions are not read
    {SurfaceFormat::obj, "obj/map.obj", 2, 0.5e-6, 0.25e-6, 1e-6},              // the last digit, and the line end
    {SurfaceFormat::ply, "ply/map.ply", 0, 0.5e-6, 0.25e-6, 1e-6},
    {SurfaceFormat::ply, "ply/text.ply", 2, 0.5e-6, 0.25e-6, 1e-6},
    {SurfaceFormat::npy, "npy/fortran.npy"},
    {SurfaceFormat::npy, "npy/map-f4-big.npy"},
    {SurfaceFormat::opd, "opd/map.opd", 0, opd_step, opd_step / 2, 75e-9},
    {SurfaceFormat::opd, "opd/real.opd", 0, opd_step, opd_step / 2, 75e-9},
    {SurfaceFormat::opdx, "opdx/map.opdx", 5, 0.5e-6, 0.25e-6, 2e-9},  // the end of the items
    {SurfaceFormat::opdx, "opdx/profile.opdx", 5, 0.5e-6, 0.5e-6, 2e-9, 0},
    {SurfaceFormat::plu, "plu/map.plu", 44, 0.5e-6, 0.25e-6, 1e-6},  // the lowest, the highest and a picture
    {SurfaceFormat::plux, "plux/map.plux", 0, 0.5e-6, 0.25e-6, 1e-6},
    {SurfaceFormat::sdf, "sdf/binary-bcr.sdf"},
    {SurfaceFormat::sdf, "sdf/binary-type-7.sdf"},
    {SurfaceFormat::sdf, "sdf/text-1.sdf", 5},    // a line end, and the last asterisk
    {SurfaceFormat::smd, "smd/profile.smd", 13},  // the check sum
    {SurfaceFormat::smd, "smd/profile.prf", 7},   // the last two words
    {SurfaceFormat::sur, "sur/comment.sur"},
    {SurfaceFormat::sur, "sur/compressed-32-three-streams.sur"},
    {SurfaceFormat::sur, "sur/profile.pro"},
    {SurfaceFormat::surfer, "surfer/seven.grd", 0, 0.5e-6, 0.25e-6, 1e-6},
    {SurfaceFormat::surfer, "surfer/six.grd", 0, 0.5e-6, 0.25e-6, 1e-6},
    {SurfaceFormat::surfer, "surfer/text.grd", 3, 0.5e-6, 0.25e-6, 1e-6},  // a line end, and a digit of the last number
    {SurfaceFormat::vk4, "vk4/map.vk4", 0, 0.5e-6, 0.25e-6, 1e-10, 0},
    {SurfaceFormat::vk4, "vk4/map.vk6", 0, 0.5e-6, 0.25e-6, 1e-10, 0},
    {SurfaceFormat::x3p, "x3p/mask.x3p"},
    {SurfaceFormat::x3p, "x3p/stored.x3p"},
    {SurfaceFormat::zygo, "zygo/map.asc", 1, 0.5e-6, 0.5e-6, 2.0 * 0.5 / 32768 * 0.5e-6},  // a line end
};

/// Whether this build reads \p sample.
bool is_read(const Sample& sample) {
    const std::string_view file = sample.file;
    const bool needs_x3p = sample.format == SurfaceFormat::x3p || sample.format == SurfaceFormat::plux,
               is_read = ((!needs_x3p && !file.ends_with(".vk6")) || io::reads_x3p()) &&
                         ((file.find("compressed") > file.size() && file.find("packed") > file.size()) ||
                          io::reads_compressed_sur());
    if (!is_read) test::leave_out("built without its library: " + std::string(file));
    return is_read;
}

/// The reader of \p format, with the options that its files need.
test::FormReader reader(SurfaceFormat format) {
    if (format == SurfaceFormat::npy) return {format, {.units = "nm", .dx = 1e-6, .dy = 2e-6}};
    if (format == SurfaceFormat::mat || format == SurfaceFormat::surfer || format == SurfaceFormat::ply ||
        format == SurfaceFormat::obj)
        return {format, {.units = "um"}};
    return {format};
}

}  // namespace

TEST_CASE("A sample of each form is known by its first bytes and has the heights that were put in") {
    for (const Sample& sample : samples) {
        CAPTURE(sample.file);
        if (!is_read(sample)) continue;
        const std::string whole = test::sample(sample.file);
        const test::FormReader read = reader(sample.format);
        CHECK(io::form_of_first_bytes(whole) == sample.format);
        if (sample.dx > 0) test::check_sample(read(whole), sample.dx, sample.dy, sample.unit, sample.missing);
        std::istringstream input(whole);
        const io::Surface found = io::read_surface(input, "file", read.options);
        CHECK(found.record.format == sample.format);
        CHECK(found.record.format_from == "the first bytes");
        CHECK(found.is_profile() == (read(whole).map.rows == 1));
    }
}

TEST_CASE("Every beginning of a sample is refused in one line") {
    for (const Sample& sample : samples) {
        if (!is_read(sample)) continue;
        const std::string whole = test::sample(sample.file);
        const test::FormReader read = reader(sample.format);
        const test::RefusalOf refusal(read);
        for (std::size_t size = 0; size + sample.trailer < whole.size(); ++size) {
            CAPTURE(sample.file, size);
            const std::string said = refusal(whole.substr(0, size));
            REQUIRE(!said.empty());
            REQUIRE(said.find('\n') == std::string::npos);
            REQUIRE(
                !test::refusal([&] { (void)io::read_surface(whole.substr(0, size), "file", read.options); }).empty());
        }
    }
}

TEST_CASE("Options are refused by their names where a form has no use for them, and only there") {
    const std::pair<std::string, io::SurfaceOptions> options[] = {
        {"units", {.units = "um"}},
        {"spacing", {.spacing = 1}},
        {"column", {.column = 2}},
        {"x-column", {.x_column = 1}},
        {"dx", {.dx = 1}},
        {"dy", {.dy = 1}},
        {"width", {.width = 1}},
        {"height", {.height = 1}},
        {"missing", {.missing = "-9999"}},
        {"thousands", {.thousands = "'"}},
        {"resample", {.resample = true}},
        {"channel", {.channel = "1"}},
        {"grid", {.grid = 1}},
        {"x3p-increment", {.x3p_increment = io::X3pIncrement::ignore}}};
    for (const Reader* form : io::detail::readers())
        for (const auto& [name, of_reader] : options) {
            io::SurfaceOptions given = of_reader;  // clang 14 hands no structured binding to a lambda
            CAPTURE(name_of(form->format), name);
            given.format = form->format;
            const std::string words = " " + std::string(form->options) + " ",
                              said = test::refusal([&] {
                                  (void)io::read_surface("0 0 1\n1 0 2\n0 1 3\n1 1 main.xml\n", "file", given);
                              });
            CHECK(test::contains(said, "has no use for " + name + ";") != test::contains(words, " " + name + " "));
        }
}

TEST_CASE("Every form has a row in the order of its names, a sample, and a row of the documents") {
    std::string table = "| form | endings | holds | recognised by | needs |\n|---|---|---|---|---|\n";
    std::size_t next = 1;  // after automatic
    for (const Reader* form : io::detail::readers()) {
        CAPTURE(name_of(form->format));
        CHECK(form->format == enum_names<SurfaceFormat>[next++].value);
        CHECK(!form->begins == (std::find_if(std::begin(samples), std::end(samples), [&](const Sample& sample) {
                                    return sample.format == form->format;
                                }) == std::end(samples)));
        table += "| `" + std::string(name_of(form->format)) + "`";
        for (const std::string_view cell : {form->endings, form->holds, form->recognised, form->asks_for})
            table += " | " + std::string(cell);
        table += " |\n";
    }
    table.replace(table.find("\\x93NUMPY"), 9, "`\\x93NUMPY`");  // Doxygen takes a backslash for a command of its own
    INFO("docs/formats.md must hold:\n" << table);
    CHECK(test::contains(test::read(FSTIFF_TEST_DATA "/../../docs/formats.md"), table));
}

}  // namespace readers_test
