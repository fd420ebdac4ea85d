// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads profiles and maps of Bruker Dektak (.opdx).
///
/// "VCA DATA", 1, 0, 0, 55 (hex), and a tree of items, the least significant byte first. An item is its name (uint32
/// length, then the letters), a byte of its type, and its content; a length L is the number of its bytes (1, 2 or 4),
/// then itself.
///
///     01 bool           46, 47, 7D  L, then items up to one of type 7F     00  name, 4 bytes, name, L, a matrix
///     04, 05 int16      12  L, text                                        45  name, L, a matrix
///     06, 07 int32      13  L, float64, name and symbol of its unit        40  name, L, 5 bytes, float64s
///     0A, 0B int64      42  name, L, names                                 0E, 7C  name, L, left out
///     0C float32        15  9 bytes of a date                              18  L, left out
///     0D float64        a matrix: rows, columns (uint32), float32s row after row
///
/// The first channel of heights is read, MetaData/2D_Channels/Height or MetaData/1D_Channels/Height, or the map that
/// MetaData/PrimaryData2D names, in its folder of 2D_Data or 1D_Data:
///
///     Matrix, Dimension1Points, Dimension2Points, Dimension1Extent, Dimension2Extent, DataScale of a map (1 is y)
///     Array, NumPoints, Extent, DataScale of a profile
///
///     height = number DataScale,    step = extent / (points - 1)
///
/// NaN is a missing point.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence), whose profile of a measured file is the same
/// Units       map in m
/// Valid       2 points a side at least, or one profile; heights that vary; 100000 items, 32 within one another
/// Accuracy    number times scale times unit, rounded twice (tests/io/opdx_test.cpp)

#include "io/readers.hpp"

#include "io/file_bytes.hpp"

#include <map>

namespace fstiff::inline v0_1::io::detail {

namespace {

constexpr std::string_view opdx_magic("VCA DATA\1\0\0\x55", 12);

/// The content of an item, as far as its type has it.
struct OpdxItem {
    unsigned type{};
    double number{};                // of a number, or of a quantity
    std::string text;               // or the unit of a quantity
    std::vector<std::string> list;  // of names
    std::uint64_t place{}, size{};  // of the numbers of a matrix or an array
    std::uint64_t rows{}, columns{};
};

/// The items of a file by their paths, such as "1D_Data/Raw/Extent".
class OpdxTree {
public:
    explicit OpdxTree(const FileBytes& file) : file_(file) { items("", file.size(), 0); }

    const OpdxItem* find(const std::string& path) const {
        const auto found = items_.find(path);
        return found == items_.end() ? nullptr : &found->second;
    }

private:
    std::string_view take(std::uint64_t size, const std::string& path) {
        place_ += size;
        return file_.at(place_ - size, size, path.empty() ? "its items" : path);
    }
    std::uint64_t number(std::size_t size, const std::string& path) { return unsigned_at(take(size, path), false); }
    std::string name(const std::string& path) {
        const std::uint64_t size = number(4, path);
        if (size > 1024) refuse_file(file_.name(), {"has a name of ", size, " bytes; must be at most 1024"});
        return std::string(take(size, path));
    }
    std::uint64_t length(const std::string& path) {
        const std::uint64_t bytes = number(1, path);
        if (bytes != 1 && bytes != 2 && bytes != 4)
            refuse_file(file_.name(),
                        {"has a length of ", bytes, " bytes in ", shown_cell(path), "; must be 1, 2 or 4"});
        const std::uint64_t size = number(static_cast<std::size_t>(bytes), path);
        (void)file_.at(place_, size, path);
        return size;
    }

    /// Where the \p size bytes from here on end, which lie within a folder that ends at \p end.
    std::uint64_t end_within(std::uint64_t size, std::uint64_t end, const std::string& path) const {
        if (place_ + size > end)
            refuse_file(file_.name(), {"holds ", shown_cell(path), " that ends after its folder; must end within"});
        return place_ + size;
    }
    void one_more() {
        if (++count_ > 100000) refuse_file(file_.name(), {"has more than 100000 items and names; must have fewer"});
    }

    /// The items from here on to \p end, or to one that ends them.
    void items(const std::string& folder, std::uint64_t end, int depth) {
        if (depth > 32) refuse_file(file_.name(), {"has more than 32 items within one another; must have fewer"});
        while (place_ < end) {
            const std::string path = folder + name(folder);
            OpdxItem item;
            item.type = static_cast<unsigned>(number(1, path));
            if (item.type == 0x7F) return;
            if (item.type == 0x7D || item.type == 0x46 || item.type == 0x47) {
                const std::uint64_t inner_end = end_within(length(path), end, path);
                items(path + "/", inner_end, depth + 1);
                place_ = inner_end;
            } else {
                content(item, path);
                end_within(0, end, path);
                one_more();
                items_.emplace(path, std::move(item));
            }
        }
    }

    void content(OpdxItem& item, const std::string& path) {
        static const std::map<unsigned, std::size_t> sizes{{0x01, 1}, {0x04, 2}, {0x05, 2}, {0x06, 4}, {0x07, 4},
                                                           {0x0A, 8}, {0x0B, 8}, {0x0C, 4}, {0x0D, 8}, {0x15, 9}};
        if (const auto size = sizes.find(item.type); size != sizes.end()) {
            const std::string_view bytes = take(size->second, path);
            if (item.type == 0x15) return;
            const bool is_signed = item.type == 0x04 || item.type == 0x06 || item.type == 0x0A;
            item.number = value_at(bytes, item.type >= 0x0C ? 'f' : is_signed ? 'i' : 'u', false);
            return;
        }
        const bool named = item.type == 0x00 || item.type == 0x45 || item.type == 0x40 || item.type == 0x42 ||
                           item.type == 0x0E || item.type == 0x7C;
        if (!named && item.type != 0x12 && item.type != 0x13 && item.type != 0x18)
            refuse_file(file_.name(),
                        {"holds ", shown_cell(path), " of the type ", item.type, "; must be a known one"});
        if (named) name(path);
        if (item.type == 0x00) {
            take(4, path);
            name(path);
        }
        const std::uint64_t size = length(path), end = place_ + size;
        compound(item, path, size, end);
        place_ = end;
    }

    /// Number after a length.
    void compound(OpdxItem& item, const std::string& path, std::uint64_t size, std::uint64_t end) {
        if (item.type == 0x12) item.text = take(size, path);
        if (item.type == 0x13) {
            item.number = real_at(take(8, path), false);
            name(path);
            item.text = name(path);
        }
        if (item.type == 0x42)
            for (; place_ < end; one_more()) item.list.push_back(name(path));
        if (item.type == 0x40) item.size = size;
        if (item.type == 0x40) item.place = place_ + 5;
        if (item.type == 0x00 || item.type == 0x45) {
            item.rows = number(4, path);
            item.columns = number(4, path);
            item.size = size;
            item.place = place_;
        }
    }

    const FileBytes& file_;
    std::uint64_t place_ = opdx_magic.size();
    std::map<std::string, OpdxItem> items_;
    std::size_t count_ = 0;  // of items and of names in lists
};

class OpdxReader {
public:
    explicit OpdxReader(const FileBytes& file) : file_(file), tree_(file) {}

    Reading read() {
        choose();
        const double scale = scale_of("DataScale");
        RawMap map;
        if (is_map_) {
            const OpdxItem& matrix = required("Matrix");
            const StoredGrid grid{matrix.place, 4, points_of("Dimension2Points"), points_of("Dimension1Points"), 0};
            require_whole(grid, matrix.size, 8);
            if (matrix.rows != grid.rows || matrix.columns != grid.columns)
                refuse_file(file_.name(), {"declares ", grid.columns, " x ", grid.rows, " points over a matrix of ",
                                           matrix.columns, " x ", matrix.rows, "; must be as many"});
            read_grid(map, file_, grid, [&](std::string_view height) { return real_at(height, false) * scale; });
            const double dx = step("Dimension2Extent", grid.columns);
            set_spacings(map, dx, grid.rows == 1 ? dx : step("Dimension1Extent", grid.rows), file_.name());
        } else {
            const StoredGrid grid{required("Array").place, 8, points_of("NumPoints"), 1, 0};
            require_whole(grid, required("Array").size, 5);
            read_grid(map, file_, grid, [&](std::string_view height) { return real_at(height, false) * scale; });
            const double dx = step("Extent", grid.columns);
            set_spacings(map, dx, dx, file_.name());
        }
        Record record = record_of(map);
        return {std::move(map), std::move(record)};
    }

private:
    /// The channel to read, and those that are not.
    void choose() {
        const OpdxItem* const kind = tree_.find("MetaData/DataKind");
        const OpdxItem* const primary = tree_.find("MetaData/PrimaryData2D");
        for (const bool map : {true, false}) {
            const OpdxItem* const all = tree_.find(map ? "MetaData/2D_Channels/Height" : "MetaData/1D_Channels/Height");
            if (map && kind && kind->text == "Surface Profile") continue;
            std::vector<std::string> channels = all ? all->list : std::vector<std::string>();
            if (map && primary && !primary->text.empty()) {
                std::erase(channels, primary->text);
                channels.insert(channels.begin(), primary->text);
            }
            for (const std::string& channel : channels) {
                const std::string folder = (map ? "2D_Data/" : "1D_Data/") + channel + "/";
                if (!tree_.find(folder + (map ? "Matrix" : "Array"))) continue;
                if (folder_.empty())
                    folder_ = folder;
                else
                    others_ += (others_.empty() ? "" : ", ") + shown_cell(channel);
            }
            is_map_ = map;
            if (!folder_.empty()) return;
        }
        refuse_file(file_.name(), {"holds no channel of heights; must hold a map or a profile of them"});
    }
    const OpdxItem& required(const std::string& name) const {
        const OpdxItem* const found = tree_.find(folder_ + name);
        if (!found) refuse_file(file_.name(), {"has no ", printable(folder_ + name, 80), "; must have one"});
        return *found;
    }
    std::uint64_t points_of(const std::string& name) const {
        return require_count(file_.name(), name, required(name).number);
    }
    /// \throws unless the heights of \p grid fit into \p size bytes, the first \p before of which are others.
    void require_whole(const StoredGrid& grid, std::uint64_t size, std::uint64_t before) const {
        if (size < before || grid.rows > (size - before) / grid.size / grid.columns)
            refuse_file(file_.name(), {"declares ", grid.columns, " x ", grid.rows, " heights, but has ", size,
                                       " bytes of them; must hold all"});
    }
    /// The quantity \p name [m].
    double scale_of(const std::string& name) {
        const OpdxItem& item = required(name);
        const double factor = require_length_unit(file_.name(), "unit of " + name, item.text);
        units_ += (units_.empty() ? "" : ", ") + name + " in " + printable(item.text, 16);
        return require_step(file_.name(), name, item.number) * factor;
    }
    double step(const std::string& name, std::uint64_t points) {
        return scale_of(name) / static_cast<double>(points - 1);
    }

    Record record_of(const RawMap& map) const {
        Record record;
        record.note("form", std::string("Bruker Dektak (.opdx), ") + (is_map_ ? "map " : "profile ") +
                                shown_cell(folder_.substr(8, folder_.size() - 9)));
        if (!others_.empty()) record.note("other channels", others_ + ", not read");
        record.note("units", units_);
        record.note("spacing", "from extents over one point less than there are");
        record.note_points(map);
        return record;
    }

    const FileBytes& file_;
    OpdxTree tree_;
    bool is_map_ = false;
    std::string folder_, others_, units_;
};

bool is_opdx(std::string_view bytes) { return bytes.starts_with(opdx_magic); }

Reading read_opdx(std::string_view bytes, const std::string& name, const SurfaceOptions&) {
    const FileBytes file(bytes, name);
    if (!is_opdx(bytes)) refuse_file(file.name(), {"does not begin as a file of Dektak; must begin with VCA DATA"});
    return OpdxReader(file).read();
}

}  // namespace

extern constexpr Reader opdx_reader{.format = SurfaceFormat::opdx,
                                    .endings = ".opdx",
                                    .holds = "profile or map of Bruker Dektak",
                                    .recognised = "its first bytes, VCA DATA",
                                    .begins = is_opdx,
                                    .read = read_opdx};

}  // namespace fstiff::inline v0_1::io::detail
