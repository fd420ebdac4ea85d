// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads maps of Alicona (.al3d).
///
/// "AliconaImaging", NUL, CR LF, and tags of 52 bytes, each a key (20 characters), a value (30) and CR LF. The first
/// are Version and TagCount, the number of those that follow. Of them are used
///
///     Cols, Rows, PixelSizeXMeter, PixelSizeYMeter [m], DepthImageOffset, InvalidPixelValue
///
/// The heights in m begin at byte DepthImageOffset, row after row as float32, the least significant byte first,
/// each row filled up to a multiple of 8 bytes. Missing points are NaN or within 1.5e-7 of InvalidPixelValue.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence), whose map of a measured file is the same
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary
/// Accuracy    the float32 of the file (tests/io/al3d_test.cpp)

#include "io/readers.hpp"

#include "io/file_bytes.hpp"

#include <map>

namespace fstiff::inline v0_1::io::detail {

namespace {

bool is_al3d(std::string_view bytes) { return bytes.starts_with(std::string_view("AliconaImaging\0\r\n", 17)); }

class Al3dReader {
public:
    Al3dReader(std::string_view bytes, std::string_view name) : file_(bytes, std::string(name)) {}

    Reading read() {
        if (!is_al3d(file_.at(0, file_.size(), "the file")))
            refuse_file(file_.name(), {"does not begin as a file of Alicona; must begin with AliconaImaging"});
        read_tags();
        const std::uint64_t columns = count("Cols"), rows = count("Rows"), place = count("DepthImageOffset");
        if (place == 0) refuse_file(file_.name(), {"holds no depth image; must hold heights, not texture alone"});
        const StoredGrid grid{place, 4, columns, rows, columns % 2 * 4};
        const double missing =
            text("InvalidPixelValue").empty() ? std::numeric_limits<double>::quiet_NaN() : invalid_value();
        RawMap map;
        read_grid(map, file_, grid, [&](std::string_view height) {
            const double z = real_at(height, false);
            return std::abs(z - missing) < 1.5e-7 * std::abs(missing) || z == missing
                       ? std::numeric_limits<double>::quiet_NaN()
                       : z;
        });
        const double dx = step("PixelSizeXMeter"), dy = step("PixelSizeYMeter");
        set_spacings(map, dx, dy, file_.name());
        Record record;
        const std::string program = printable(text("CreatingApplication"), 40);
        record.note("form", "Alicona (.al3d)" + (program.empty() ? "" : ", written by " + program));
        record.note("units", "m, 32-bit floating-point heights");
        record.note("spacing", "from PixelSizeXMeter and PixelSizeYMeter");
        record.note_points(map);
        return {std::move(map), std::move(record)};
    }

private:
    static constexpr std::uint64_t magic_bytes = 17, tag_bytes = 52;

    /// Keeps the key and the value of tag \p index, counted from 0.
    void read_tag(std::uint64_t index) {
        const std::uint64_t place = magic_bytes + index * tag_bytes;
        if (file_.at(place + 50, 2, "the tags") != "\r\n")
            refuse_file(file_.name(), {"has a tag ", index + 1, " that does not end with CR LF; must be 52 bytes"});
        tags_.emplace(file_.words(place, 20, "the tags"), file_.words(place + 20, 30, "the tags"));
    }
    void read_tags() {
        read_tag(0);
        read_tag(1);
        const std::uint64_t tags = count("TagCount");
        for (std::uint64_t i = 0; i < tags; ++i) read_tag(2 + i);  // ends with the file at the latest
    }
    std::string_view text(std::string_view key) const {
        const auto found = tags_.find(key);
        return found == tags_.end() ? std::string_view() : found->second;
    }
    double number(const std::string& key) const {
        if (text(key).empty()) refuse_file(file_.name(), {"has no tag ", key, "; must have one"});
        return stated_number(file_.name(), key, text(key));
    }
    double step(const std::string& key) const { return require_step(file_.name(), key, number(key)); }
    /// The number that marks missing points; "NaN" and its like mark none but NaN.
    double invalid_value() const {
        return is_missing_word(text("InvalidPixelValue")) ? std::numeric_limits<double>::quiet_NaN()
                                                          : number("InvalidPixelValue");
    }
    std::uint64_t count(const std::string& key) const { return require_count(file_.name(), key, number(key), 0); }

    FileBytes file_;
    std::map<std::string_view, std::string_view> tags_;
};

}  // namespace

extern constexpr Reader al3d_reader{.format = SurfaceFormat::al3d,
                                    .endings = ".al3d",
                                    .holds = "map of Alicona",
                                    .recognised = "its first bytes, AliconaImaging",
                                    .begins = is_al3d,
                                    .read = read_by<Al3dReader>};

}  // namespace fstiff::inline v0_1::io::detail
