// SPDX-License-Identifier: BSD-3-Clause
#include "io/plux.hpp"

#include "io/file_bytes.hpp"
#include "io/zip_archive.hpp"

#include <fstiff/io/quantity.hpp>

#include <pugixml.hpp>

namespace fstiff::inline v0_1::io {

namespace detail {

namespace {

class PluxReader {
public:
    PluxReader(std::string_view bytes, std::string name, const X3pLimits& limits)
        : name_(std::move(name)), archive_(bytes, name_, limits) {}

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
        const std::size_t size = archive_.size(*found);
        if (size % 4 != 0 || size / 4 != columns * rows)
            refuse_file(name_, {shown_cell(data), " has ", size, " bytes; must have 4 for each of ", columns, " x ",
                                rows, " points"});
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
        return parts::located({.file = name_}, [&] { return parse_number(printable(text, 64), place); });
    }
    std::uint64_t count_at(const char* element) const {
        const double value = number_at(element);
        if (!(value >= 1 && value <= 4294967295.0 && value == std::floor(value)))
            refuse_field(name_, element, number_text(value), "a whole number from 1 to 4294967295");
        return static_cast<std::uint64_t>(value);
    }
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
        record.say("form", "Sensofar (.plux), 32-bit floating-point heights from " + shown_cell(data) +
                               (date.empty() ? "" : ", measured " + date));
        if (layers_ > 1) record.say("other layers", std::to_string(layers_ - 1) + ", not read");
        record.say("units", "um");
        record.say("spacing", "from FOV_X and FOV_Y");
        record.say_points(map);
        return record;
    }

    std::string name_;
    ZipArchive archive_;
    pugi::xml_document document_;
    pugi::xml_node root_;
    std::size_t layers_ = 0;
};

}  // namespace

}  // namespace detail

std::string zip_entry(std::string_view bytes, const std::string& name, std::string_view entry,
                      const X3pLimits& limits) {
    const detail::ZipArchive archive(bytes, name, limits);
    const auto found = archive.find(entry);
    if (!found) detail::refuse_file(name, {"holds no ", detail::shown_cell(entry), "; must hold it in its archive"});
    return archive.content(*found);
}

Reading read_plux(std::string_view bytes, std::string_view name, const SurfaceOptions& options) {
    return detail::PluxReader(bytes, std::string(name), options.x3p_limits).read();
}

}  // namespace fstiff::inline v0_1::io
