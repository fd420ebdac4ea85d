// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads maps of Sensofar (.plux): a zip archive of index.xml and layers. Needs what X3P needs.
///
/// Elements of index.xml that are used, below its root:
///
///     GENERAL/IMAGE_SIZE_X, IMAGE_SIZE_Y  columns, rows        LAYER_0/FILENAME_Z  the file of the heights
///     GENERAL/FOV_X, FOV_Y                steps of x and y [um]
///
/// The heights in um are stored row after row as float32, the least significant byte first. NaN is a missing point. The
/// first layer is read, the record lists the others.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence)
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; files up to 2^30 bytes
/// Accuracy    the float32 of the file times 1e-6, rounded once (tests/io/plux_test.cpp)

#include "io/readers.hpp"

#include "io/file_bytes.hpp"
#include "io/zip_archive.hpp"

#ifdef FSTIFF_HAS_X3P
#include <pugixml.hpp>

namespace fstiff::inline v0_1::io::detail {

namespace {

class PluxReader {
public:
    PluxReader(std::string_view bytes, const std::string& name, const SurfaceOptions& options)
        : name_(name), archive_(bytes, name_, options.x3p_limits) {}

    Reading read() {
        const auto index = archive_.find("index.xml");
        if (!index) refuse_file(name_, {"holds no index.xml; must be a whole Sensofar file (.plux)"});
        const std::string text = archive_.content(*index);
        if (!document_.load_buffer(text.data(), text.size()))
            refuse_file(name_, {"index.xml is not valid XML; must be a whole Sensofar file (.plux)"});
        root_ = document_.document_element();
        const auto columns = count_at("IMAGE_SIZE_X"), rows = count_at("IMAGE_SIZE_Y");
        const double dx = step_at("FOV_X"), dy = step_at("FOV_Y");
        const std::string data = heights_name();
        const auto found = archive_.find(data);
        if (!found) refuse_field(name_, "LAYER_0/FILENAME_Z", shown_cell(data), "the name of a file of the archive");
        archive_.require_points(*found, 4, columns, rows);
        const std::string heights = archive_.content(*found);
        RawMap map;
        read_grid(map, FileBytes(heights, name_), {0, 4, columns, rows, 0},
                  [](std::string_view height) { return real_at(height, false) * 1e-6; });
        set_spacings(map, dx, dy, name_);
        Record record = record_of(map, data);
        return {std::move(map), std::move(record)};
    }

private:
    std::string text_at(const char* element) const {
        return std::string(trimmed(root_.child("GENERAL").child(element).text().get()));
    }
    double number_at(const char* element) const {
        const std::string text = text_at(element), place = std::string("GENERAL/") + element;
        if (text.empty()) refuse_file(name_, {"index.xml has no ", place, "; must have one"});
        return stated_number(name_, place, text);
    }
    std::size_t count_at(const char* element) const { return require_count(name_, element, number_at(element)); }
    double step_at(const char* element) const { return require_step(name_, element, number_at(element) * 1e-6); }

    /// The file that the first LAYER_... names; all of them are counted.
    std::string heights_name() {
        const auto is_layer = [](const pugi::xml_node& node) {
            return std::string_view(node.name()).starts_with("LAYER_");
        };
        std::string first;
        for (const pugi::xml_node& node : root_.children())
            if (is_layer(node) && node.child("FILENAME_Z") && layers_++ == 0)
                first = trimmed(node.child("FILENAME_Z").text().get());
        if (layers_ == 0)
            refuse_file(name_, {"index.xml has no LAYER_0 with a FILENAME_Z; must have a layer of heights"});
        while (first.starts_with("./") || first.starts_with(".\\")) first.erase(0, 2);
        return first;
    }

    Record record_of(const RawMap& map, const std::string& data) const {
        Record record;
        const std::string date = printable(text_at("DATE"), 40);
        record.note("form", "Sensofar (.plux), 32-bit floating-point heights from " + shown_cell(data) +
                                (date.empty() ? "" : ", measured " + date));
        if (layers_ > 1) record.note("other layers", std::to_string(layers_ - 1) + ", not read");
        record.note("units", "um");
        record.note("spacing", "from FOV_X and FOV_Y");
        record.note_points(map);
        return record;
    }

    std::string name_;
    ZipArchive archive_;
    pugi::xml_document document_;
    pugi::xml_node root_;
    std::size_t layers_ = 0;
};

}  // namespace

}  // namespace fstiff::inline v0_1::io::detail
#endif

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Whether the end of a zip archive, which lists its files, names index.xml and no main.xml.
bool is_plux(std::string_view bytes) {
    const std::string_view list = bytes.substr(bytes.size() - (std::min<std::size_t>)(bytes.size(), 1 << 16));
    return bytes.starts_with("PK\3\4") && list.find("index.xml") < list.size() && list.find("main.xml") >= list.size();
}

}  // namespace

extern constexpr Reader plux_reader{
    .format = SurfaceFormat::plux,
    .endings = ".plux",
    .holds = "map of Sensofar, where fstiff reads X3P",
    .recognised = "its first bytes, those of a ZIP archive, and its index.xml",
    .begins = is_plux,
#ifdef FSTIFF_HAS_X3P
    .read = read_by<PluxReader>,
#endif
};

}  // namespace fstiff::inline v0_1::io::detail
