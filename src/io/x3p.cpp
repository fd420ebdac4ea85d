// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads X3P files: a zip archive of main.xml and the heights. Needs zlib and pugixml.
///
/// main.xml may lie in a folder of the archive, and its root element in any namespace or in none; other files are left
/// alone. Heights are number times increment plus offset, of the types I (int16), L (int32), F and D, from a file
/// or from the list in main.xml. Missing points are NaN, an empty Datum, or not set in the mask of valid points (one
/// bit a point, the least significant first). Rows keep the order of the file.
///
/// Names in the archive are compared, never used as paths. Sizes are compared with the limits and with what main.xml
/// declares before anything is inflated. The CRC of each file is verified, MD5 sums are not.
///
/// Reference   ISO 25178-72:2017 (ISO 5436-2). Refused: absolute x or y axes, layers (SizeZ > 1), point clouds.
/// Units       map in m, as the increments of the file
/// Valid       2 points a side at least, or one profile (dy = dx where the file states none), of heights that vary;
///             files up to 2^30 bytes
/// Accuracy    number times increment, plus offset where there is one, each rounded once (tests/io/x3p_test.cpp)

#include "io/readers.hpp"

#include "io/binary_numbers.hpp"
#include "io/column_titles.hpp"
#include "io/option_names.hpp"
#include "io/required.hpp"
#include "io/zip_archive.hpp"

#include <fstiff/io/quantities.hpp>
#include <fstiff/io/units.hpp>

#ifdef FSTIFF_HAS_X3P
#include <pugixml.hpp>

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Content of main.xml.
struct X3pHeader {
    std::string main;        // of main.xml in the archive
    std::string data;        // of the heights in the archive; empty when they are in main.xml
    char data_type{};        // I, L, F or D
    std::string instrument;  // printable characters only
    std::size_t side_files{};
    std::size_t columns{}, rows{};
    bool mask{};           // there is a mask of valid points
    double increment = 1;  // of the z axis, as the file states it
    bool applied = true;   // the heights are times the increment

    /// Floating-point heights with an increment that changes them: two readings are possible.
    [[nodiscard]] bool doubtful() const { return (data_type == 'F' || data_type == 'D') && increment != 1; }
};

/// The child called \p name in whatever namespace; empty when there is none.
pugi::xml_node local_child(const pugi::xml_node& parent, std::string_view name) {
    for (pugi::xml_node child = parent.first_child(); child; child = child.next_sibling()) {
        std::string_view title = child.name();
        if (const std::size_t colon = title.find(':'); colon != std::string_view::npos) title.remove_prefix(colon + 1);
        if (title == name) return child;
    }
    return {};
}

Record record_of(const X3pHeader& file, const RawMap& map, const OptionNames& names) {
    Record record;
    record.note("form", "X3P, heights of type " + std::string(1, file.data_type) + " from " +
                            shown_cell(file.data.empty() ? file.main : file.data) +
                            (file.instrument.empty() ? "" : ", measured with " + file.instrument));
    const std::string increment = number_text(file.increment), increment_of_z = "the increment " + increment + " of CZ";
    record.note("units", !file.doubtful() ? "m"
                         : file.applied   ? "m, heights times " + increment_of_z
                                          : "m, heights as they are, without " + increment_of_z);
    record.note("spacing", "from the increments of CX and CY");
    record.note_points(map, file.mask ? ", from a mask" : "");
    if (file.side_files != 0) record.note("other files in the archive", std::to_string(file.side_files) + ", not read");
    if (file.doubtful())
        record.warnings.push_back(
            "the heights are floating-point numbers, and the file also states an increment of " + increment + ": " +
            (file.applied ? "they were taken times the increment; where they are metres already, the other reading is "
                          : "they were taken as metres, without the increment; the other reading is ") +
            of_words(names, "x3p_increment") + names.equals + (file.applied ? "ignore" : "apply"));
    record.resolution = file.data_type == 'I' || file.data_type == 'L' ? file.increment : 0;
    return record;
}

class X3pReader {
public:
    X3pReader(std::string_view bytes, const std::string& name, const SurfaceOptions& options)
        : name_(name), archive_(bytes, name_, options.x3p_limits), options_(options) {}

    Reading read() {
        find_main();
        const std::string main = archive_.content(*archive_.find(header_.main));
        if (!document_.load_buffer(main.data(), main.size()))
            refuse_file(name_, {shown_cell(header_.main), " is not valid XML; must be a whole X3P file"});
        for (pugi::xml_node root = document_.first_child(); root && !root_; root = root.next_sibling())
            if (local_child(root, "Record1") && local_child(root, "Record3")) root_ = root;
        if (!root_)
            refuse_file(name_, {shown_cell(header_.main),
                                " has no element that holds Record1 and Record3; must be "
                                "the description of an X3P file"});
        read_axes();
        read_size();
        const pugi::xml_node record3 = local_child(root_, "Record3");
        const pugi::xml_node link = local_child(record3, "DataLink");
        const pugi::xml_node list = local_child(record3, "DataList");
        if (bool(link) == bool(list))
            refuse_file(name_, {link ? "has both " : "has neither ", "DataLink", (link ? " and" : " nor"),
                                " DataList; must have one of them"});
        if (link)
            read_link(link);
        else
            read_list(list);
        set_spacings(map_, dx_, dy_, name_);
        describe();
        Record record = record_of(header_, map_, options_.names);
        if (!options_.units.empty()) replace_units(record);
        return {std::move(map_), std::move(record)};
    }

private:
    static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

    /// Takes the numbers of the file, which are metres, in the units of the options.
    void replace_units(Record& record) {
        const auto given =
            given_units(options_.units, 2, name_, "one unit, or two such as \"mm,um\" (x and y, heights)");
        const double lateral = unit_factor(given.front(), Dimension::length),
                     vertical = unit_factor(given.back(), Dimension::length);
        map_.dx *= lateral, map_.dy *= lateral;
        for (double& height : map_.heights) height *= vertical;
        record.resolution *= vertical;
        std::erase_if(record.entries, [](const auto& entry) { return entry.first == "units"; });
        record.note("units", "x and y in " + printable(given.front(), 16) + ", heights in " +
                                 printable(given.back(), 16) + ", from options");
        if (lateral != 1 || vertical != 1)
            record.warnings.push_back(
                contradiction(options_.names, "units", shown_cell(options_.units), "the form, whose numbers are m"));
    }

    /// main.xml, in the folder that is nearest to the root of the archive.
    void find_main() {
        std::size_t least = std::string::npos;
        bool twice = false;
        for (const std::string& entry : archive_.names()) {
            if (entry != "main.xml" && !entry.ends_with("/main.xml")) continue;
            if (entry.starts_with("__MACOSX/")) continue;
            const auto depth = static_cast<std::size_t>(std::count(entry.begin(), entry.end(), '/'));
            twice = depth == least;
            if (depth >= least) continue;
            least = depth;
            header_.main = entry;
        }
        if (least == std::string::npos) refuse_archive();
        if (twice) refuse_file(name_, {"holds more than one main.xml, none nearer to its root; must hold one"});
        folder_ = header_.main.substr(0, header_.main.size() - std::string_view("main.xml").size());
    }

    /// Refuses an archive that is not an X3P file, and names what it is.
    [[noreturn]] void refuse_archive() const {
        const auto any = [&](const auto& is) {
            return std::any_of(archive_.names().begin(), archive_.names().end(), is);
        };
        const char* what = "a zip archive";
        const char* way = "; unpack it, and give one file";
        if (any([](const std::string& entry) { return entry.starts_with("xl/"); })) {
            what = "an Excel workbook (.xlsx)";
            way = "; save the sheet as CSV";
        } else if (any([](const std::string& entry) { return entry == "content.xml"; })) {
            what = "an OpenDocument file (.ods)";
            way = "; save the sheet as CSV";
        } else if (any([](const std::string& entry) { return entry.starts_with("word/"); })) {
            what = "a document of Word (.docx)";
            way = "; write its numbers as text";
        } else if (any([](const std::string& entry) { return entry.ends_with(".oir"); })) {
            what = "an archive of an Olympus microscope (.poir)";
            way = "; export the heights from the program of the instrument, or unpack it and read the .oir by Python";
        } else if (any([](const std::string& entry) { return entry.ends_with(".model"); })) {
            what = "a mesh (.3mf)";
            way = "; export its points as text";
        } else if (any([](const std::string& entry) { return entry.find("LAYER_0") != std::string::npos; })) {
            what = "a Sensofar file (.plux)";
            way = "; export it from the program of the instrument";
        } else if (any([](const std::string& entry) { return entry.ends_with(".npy"); })) {
            what = "an archive of NumPy arrays (.npz)";
            way = "; write its array as text";
        }
        refuse_file(name_, {"is ", what, " that holds no main.xml; an X3P file must", way});
    }

    std::string text_at(const pugi::xml_node& node) const { return std::string(trimmed(node.text().get())); }

    double number_at(const pugi::xml_node& axis, const std::string& path, double otherwise) const {
        const std::string text = text_at(local_child(axis, path.substr(path.find('/') + 1)));
        if (text.empty()) return otherwise;
        return fstiff::detail::located({.file = name_}, [&] {
            if (text.size() > 64) fstiff::detail::refuse(path, shown_cell(text), "a number");
            return parse_number(printable(text, 80), path);
        });
    }

    void read_axes() {
        const pugi::xml_node record1 = local_child(root_, "Record1");
        const std::string feature = text_at(local_child(record1, "FeatureType"));
        if (feature != "SUR" && feature != "PRF")
            refuse_field(name_, "FeatureType", shown_cell(feature), "SUR (surface) or PRF (profile)");
        profile_ = feature == "PRF";
        const pugi::xml_node axes = local_child(record1, "Axes");
        const pugi::xml_node x = local_child(axes, "CX"), y = local_child(axes, "CY"), z = local_child(axes, "CZ");
        for (const auto& [axis, title] : {std::pair{x, "CX"}, {y, "CY"}}) {
            const std::string type = text_at(local_child(axis, "AxisType"));
            if (type != "I" && !(profile_ && axis == y && type.empty()))
                refuse_field(name_, std::string(title) + "/AxisType", shown_cell(type), "I (incremental)");
        }
        const std::string type = text_at(local_child(z, "AxisType"));
        if (type != "A") refuse_field(name_, "CZ/AxisType", shown_cell(type), "A (absolute)");
        const std::string data = text_at(local_child(z, "DataType"));
        if (data != "I" && data != "L" && data != "F" && data != "D")
            refuse_field(name_, "CZ/DataType", shown_cell(data), "I, L, F or D");
        header_.data_type = data[0];
        dx_ = number_at(x, "CX/Increment", 0);
        dy_ = number_at(y, "CY/Increment", 0);
        z_increment_ = number_at(z, "CZ/Increment", 1);
        z_offset_ = number_at(z, "CZ/Offset", 0);
        fstiff::detail::located({.file = name_}, [&] {
            fstiff::detail::require_positive("CX/Increment", dx_);
            if (!profile_) fstiff::detail::require_positive("CY/Increment", dy_);
            fstiff::detail::require(dy_ >= 0, "CY/Increment", dy_, "at least 0");
            fstiff::detail::require_positive("CZ/Increment", z_increment_);
        });
        header_.increment = z_increment_;
        header_.applied = !header_.doubtful() || options_.x3p_increment == X3pIncrement::apply;
        if (!header_.applied) z_increment_ = 1;
    }

    std::size_t count_at(const pugi::xml_node& parent, const std::string& title) const {
        return require_count(name_, title, number_at(parent, title, 0));
    }

    void read_size() {
        const pugi::xml_node record3 = local_child(root_, "Record3");
        if (const pugi::xml_node matrix = local_child(record3, "MatrixDimension")) {
            header_.columns = count_at(matrix, "SizeX");
            header_.rows = count_at(matrix, "SizeY");
            if (const std::size_t layers = count_at(matrix, "SizeZ"); layers != 1)
                refuse_field(name_, "SizeZ", std::to_string(layers), "1 (one layer)");
        } else if (profile_ && local_child(record3, "ListDimension")) {
            header_.columns = count_at(record3, "ListDimension");
            header_.rows = 1;
        } else {
            refuse_file(name_, {"has no MatrixDimension; must be a grid of points"});
        }
        points_ = std::uint64_t(header_.columns) * header_.rows;
    }

    void set(std::size_t index, double number) {
        double height = number * z_increment_;
        if (z_offset_ != 0) height += z_offset_;
        if (std::isinf(height) && !std::isinf(number))
            refuse_file(name_, {"height ", index + 1, " is beyond the range of double precision; must be within it"});
        set_height(map_, index, height);  // infinity marks missing points of Alicona
    }

    /// The file of the archive that \p node names, relative to main.xml.
    std::size_t linked(const pugi::xml_node& node, const std::string& title) const {
        std::string path = text_at(node);
        std::replace(path.begin(), path.end(), '\\', '/');
        while (path.starts_with("./")) path.erase(0, 2);
        const auto index = path.empty() ? std::nullopt : archive_.find(folder_ + path);
        if (!index)
            throw domain_error(
                {.parameter = title, .value = shown_cell(path), .reason = "must name a file of the archive"})
                .with_place({.file = name_});
        return *index;
    }

    void read_link(const pugi::xml_node& link) {
        const std::size_t size = header_.data_type == 'I' ? 2 : header_.data_type == 'D' ? 8 : 4;
        const std::size_t data = linked(local_child(link, "PointDataLink"), "PointDataLink");
        header_.data = archive_.names()[data];
        archive_.require_points(data, size, header_.columns, header_.rows);
        std::optional<std::size_t> mask;
        if (const pugi::xml_node node = local_child(link, "ValidPointsLink"); node && !text_at(node).empty()) {
            mask = linked(node, "ValidPointsLink");
            if (archive_.size(*mask) != points_ / 8 + (points_ % 8 != 0))
                refuse_file(name_, {shown_cell(archive_.names()[*mask]), " has ", archive_.size(*mask),
                                    " bytes; must have one bit for each of ", points_, " points"});
        }
        const std::string bytes = archive_.content(data);
        const std::string valid = mask ? archive_.content(*mask) : std::string();
        header_.mask = mask.has_value();
        allocate(map_, header_.rows, header_.columns);
        for (std::size_t i = 0; i < points_; ++i) {
            const bool is_valid = !mask || ((static_cast<unsigned char>(valid[i / 8]) >> (i % 8)) & 1) != 0;
            set(i, is_valid ? binary_number(std::string_view(bytes).substr(i * size, size)) : missing);
        }
    }

    double binary_number(std::string_view bytes) const {
        switch (header_.data_type) {
            case 'I': return static_cast<std::int16_t>(little_endian<std::uint16_t>(bytes));
            case 'L': return static_cast<std::int32_t>(little_endian<std::uint32_t>(bytes));
            case 'F': return static_cast<double>(float_at(bytes));
            default: return double_at(bytes);
        }
    }

    void read_list(const pugi::xml_node& list) {
        std::uint64_t found = 0;
        for (pugi::xml_node datum = list.first_child(); datum; datum = datum.next_sibling()) found += is_datum(datum);
        if (found != points_)
            refuse_file(name_,
                        {"DataList holds ", found, " heights; must hold ", header_.columns, " x ", header_.rows});
        allocate(map_, header_.rows, header_.columns);
        std::size_t index = 0;
        for (pugi::xml_node datum = list.first_child(); datum; datum = datum.next_sibling()) {
            if (!is_datum(datum)) continue;
            const std::string_view text = trimmed(datum.text().get());
            double number = missing;
            if (!text.empty() && !is_missing_word(text)) {
                const auto cell = number_in(text, false);
                if (!cell || std::isinf(*cell))
                    refuse_file(name_, {"height ", index + 1, " is ", shown_cell(text),
                                        "; must be a decimal number, or nothing where the point is missing"});
                number = *cell;
            }
            set(index++, number);
        }
    }

    static bool is_datum(const pugi::xml_node& node) {
        const std::string_view title = node.name();
        return title == "Datum" || title.ends_with(":Datum");
    }

    void describe() {
        const pugi::xml_node instrument = local_child(local_child(root_, "Record2"), "Instrument");
        for (const char* part : {"Manufacturer", "Model"}) {
            const std::string text = printable(text_at(local_child(instrument, part)), 80);
            if (!text.empty()) header_.instrument += (header_.instrument.empty() ? "" : " ") + text;
        }
        for (const std::string& entry : archive_.names())
            header_.side_files += !entry.ends_with('/') && entry != header_.main && entry != header_.data;
    }

    std::string name_;
    ZipArchive archive_;
    const SurfaceOptions& options_;
    std::string folder_;  // of main.xml, with its slash
    pugi::xml_document document_;
    pugi::xml_node root_;
    bool profile_ = false;
    double dx_{}, dy_{}, z_increment_{}, z_offset_{};
    std::uint64_t points_{};
    RawMap map_;
    X3pHeader header_;
};

}  // namespace

}  // namespace fstiff::inline v0_1::io::detail
#endif

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Whether a zip archive begins so, other than one of Sensofar.
bool is_x3p(std::string_view bytes) {
    return bytes.starts_with("PK\3\4") && !reader_of(SurfaceFormat::plux).begins(bytes);
}

}  // namespace

extern constexpr Reader x3p_reader{.format = SurfaceFormat::x3p,
                                   .endings = ".x3p",
                                   .holds = "ISO 25178-72, where fstiff was built with zlib and pugixml",
                                   .recognised = "its first bytes, those of a ZIP archive",
                                   .options = "units x3p-increment",
                                   .begins = is_x3p,
#ifdef FSTIFF_HAS_X3P
                                   .read = read_by<X3pReader>,
#endif
                                   .may_begin = [](std::string_view bytes) { return bytes.starts_with("PK"); }};

}  // namespace fstiff::inline v0_1::io::detail
