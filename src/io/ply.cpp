// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads the vertices and the faces of a polygon file (.ply), as text or binary in either byte order.
///
/// The lines "ply", "format ascii 1.0" (binary_little_endian, binary_big_endian), then "element NAME COUNT" with its
/// "property TYPE NAME" or "property list TYPE TYPE NAME", up to "end_header"; then the values of all elements in that
/// order. The element "vertex" has x, y, z; "face" has a list "vertex_indices" or "vertex_index", a polygon that is cut
/// into triangles. Other elements and properties are left out. The form states no unit.
///
/// Reference   G. Turk, The PLY polygon file format (1994); types also by their sizes (float32), as most programs write
/// Units       map in m
/// Valid       as io/gridded.hpp; memory of the file's size and not of the counts that it claims
/// Accuracy    as io/gridded.hpp (tests/io/ply_test.cpp)

#include "io/binary_numbers.hpp"
#include "io/lines.hpp"
#include "io/readers.hpp"
#include "io/triangle_mesh.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace fstiff::inline v0_1::io::detail {

namespace {

bool is_ply(std::string_view bytes) {
    return bytes.starts_with("ply") && bytes.size() > 3 && (bytes[3] == '\n' || bytes[3] == '\r');
}

/// A type of numbers: its kind and its size in bytes.
struct PlyType {
    char kind{};  // 'i', 'u' or 'f'
    std::size_t size{};
};

constexpr std::array<std::pair<std::string_view, PlyType>, 16> ply_types{{{"char", {'i', 1}},
                                                                          {"int8", {'i', 1}},
                                                                          {"uchar", {'u', 1}},
                                                                          {"uint8", {'u', 1}},
                                                                          {"short", {'i', 2}},
                                                                          {"int16", {'i', 2}},
                                                                          {"ushort", {'u', 2}},
                                                                          {"uint16", {'u', 2}},
                                                                          {"int", {'i', 4}},
                                                                          {"int32", {'i', 4}},
                                                                          {"uint", {'u', 4}},
                                                                          {"uint32", {'u', 4}},
                                                                          {"float", {'f', 4}},
                                                                          {"float32", {'f', 4}},
                                                                          {"double", {'f', 8}},
                                                                          {"float64", {'f', 8}}}};

struct PlyProperty {
    std::string_view name;
    PlyType type, count{};  // count: of a list
    bool is_list() const { return count.size > 0; }
};

struct PlyElement {
    std::string_view name;
    std::uint64_t count{};
    std::vector<PlyProperty> properties{};
};

class PlyReader {
public:
    PlyReader(std::string_view bytes, const std::string& name, const SurfaceOptions& options)
        : rest_(bytes), name_(name), options_(options) {}

    Reading read() {
        read_header();
        for (const PlyElement& element : elements_) {
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else
                for (std::uint64_t i = 0; i < element.count; ++i)
                    for (const PlyProperty& property : element.properties) read_values(property);
        }
        if (cloud_.points.empty()) refuse_file(name_, {"has no element vertex; must have some"});
        return map_of_mesh(std::move(cloud_), "PLY, " + std::string(format_), 0, name_, options_);
    }

private:
    /// The next line, which is taken; without the end of a line of Windows.
    std::string_view take_line() {
        const std::size_t end = rest_.find('\n');
        if (end == std::string_view::npos) refuse_file(name_, {"has a header without end_header; must have one"});
        const std::string_view line = trimmed(rest_.substr(0, end));
        rest_.remove_prefix(end + 1);
        ++line_;
        return line;
    }

    void read_header() {
        std::vector<std::string_view> words;
        take_line();
        for (std::string_view line = take_line(); line != "end_header"; line = take_line()) {
            words.clear();
            for (std::string_view left = line; !left.empty();) words.push_back(take_word(left));
            if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
            if (words[0] == "format" && words.size() == 3)
                format_ = words[1];
            else if (words[0] == "element" && words.size() == 3)
                elements_.push_back({words[1], count(words[2])});
            else if (words[0] == "property" && words.size() == 3 && !elements_.empty())
                elements_.back().properties.push_back({words[2], type(words[1])});
            else if (words[0] == "property" && words.size() == 5 && words[1] == "list" && !elements_.empty())
                elements_.back().properties.push_back({words[4], type(words[3]), type(words[2])});
            else
                refuse_line(name_, line_,
                            {shown_cell(line),
                             " is no line of a header; must be format, element, "
                             "property, comment or end_header"});
        }
        if (format_ != "ascii" && format_ != "binary_little_endian" && format_ != "binary_big_endian")
            refuse_field(name_, "format", shown_cell(format_), "ascii, binary_little_endian or binary_big_endian");
        // each element takes a byte at least, so that counts are bounded by the file
        for (const PlyElement& element : elements_)
            if (element.count > 0 && (element.properties.empty() || element.count > rest_.size()))
                refuse_file(name_, {"declares ", element.count, " times ", shown_cell(element.name), ", but holds ",
                                    rest_.size(), " bytes; must hold all"});
    }

    /// The word that \p text begins with, which is taken, with the blanks around it.
    static std::string_view take_word(std::string_view& text) {
        text = trimmed_front(text);
        std::size_t length = 0;
        while (length < text.size() && !is_blank(text[length])) ++length;
        const std::string_view word = text.substr(0, length);
        text = trimmed_front(text.substr(length));
        return word;
    }
    static std::string_view trimmed_front(std::string_view text) {
        while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
        return text;
    }

    std::uint64_t count(std::string_view word) const {
        const auto number = number_in(word, false);
        if (!number || !(*number >= 0 && *number < 4294967296.0) || *number != std::floor(*number))
            refuse_line(name_, line_, {shown_cell(word), " is no count; must be a whole number from 0 to 4294967295"});
        return static_cast<std::uint64_t>(*number);
    }
    PlyType type(std::string_view word) const {
        for (const auto& [name, type] : ply_types)
            if (name == word) return type;
        refuse_line(name_, line_,
                    {shown_cell(word),
                     " is no type; must be one of char, uchar, short, ushort, int, uint, "
                     "float, double, int8 to uint32, float32, float64"});
    }

    /// The next value, which is taken.
    double take(const PlyType& type) {
        if (format_ == "ascii") {
            const std::string_view word = take_word(rest_);
            if (word.empty()) refuse_end();
            if (is_missing_word(word)) return std::numeric_limits<double>::quiet_NaN();
            const auto number = number_in(word, false);
            if (!number) refuse_file(name_, {shown_cell(word), " among the elements is not a number; must be one"});
            return *number;
        }
        if (rest_.size() < type.size) refuse_end();
        const std::string_view bytes = rest_.substr(0, type.size);
        rest_.remove_prefix(type.size);
        const bool big = format_ == "binary_big_endian";
        return type.kind == 'f'   ? real_at(bytes, big)
               : type.kind == 'i' ? static_cast<double>(signed_at(bytes, big))
                                  : static_cast<double>(unsigned_at(bytes, big));
    }
    [[noreturn]] void refuse_end() const {
        refuse_file(name_, {"ends before the elements that its header declares; must hold all"});
    }

    /// The values of \p property of one element: of a list, or the only one.
    const std::vector<double>& read_values(const PlyProperty& property) {
        std::uint64_t count = 1;
        if (property.is_list()) {
            const double stated = take(property.count);
            if (!(stated >= 0 && stated <= static_cast<double>(rest_.size())) || stated != std::floor(stated))
                refuse_file(name_,
                            {"has a list of ", stated, " numbers, more than the rest of the file; must hold all"});
            count = static_cast<std::uint64_t>(stated);
        }
        values_.clear();
        for (std::uint64_t i = 0; i < count; ++i) values_.push_back(take(property.type));
        return values_;
    }

    void read_vertices(const PlyElement& element) {
        std::array<std::size_t, 3> places{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::string_view wanted = std::string_view("xyz").substr(k, 1);
            while (places[k] < element.properties.size() && element.properties[places[k]].name != wanted) ++places[k];
            if (places[k] == element.properties.size() || element.properties[places[k]].is_list())
                refuse_file(name_, {"has vertices without the property ", wanted, "; must have x, y and z"});
        }
        for (std::uint64_t i = 0; i < element.count; ++i) {
            auto& point = cloud_.points.emplace_back();
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const std::vector<double>& values = read_values(element.properties[p]);
                for (std::size_t k = 0; k < 3; ++k)
                    if (places[k] == p) point[k] = values.front();
            }
        }
    }

    void read_faces(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) {
                const std::vector<double>& values = read_values(property);
                if (!property.is_list() || (property.name != "vertex_indices" && property.name != "vertex_index"))
                    continue;
                for (const double index : values)
                    if (!(index >= 0 && index < 4294967295.0) || index != std::floor(index))
                        refuse_file(name_, {"has a face with vertex ", index, "; must be one of the file"});
                for (std::size_t k = 2; k < values.size(); ++k)
                    cloud_.faces.push_back({static_cast<std::uint32_t>(values[0]),
                                            static_cast<std::uint32_t>(values[k - 1]),
                                            static_cast<std::uint32_t>(values[k])});
            }
    }

    std::string_view rest_;
    std::string name_;
    const SurfaceOptions& options_;
    std::size_t line_ = 0;
    std::string_view format_;
    std::vector<PlyElement> elements_;
    std::vector<double> values_;
    PointCloud cloud_;
};

}  // namespace

extern constexpr Reader ply_reader{.format = SurfaceFormat::ply,
                                   .endings = ".ply",
                                   .holds = "points or a mesh, as text or binary in either byte order",
                                   .recognised = "its first line, ply",
                                   .asks_for = "--units, and --grid where x and y are on no regular grid",
                                   .options = "units grid",
                                   .begins = is_ply,
                                   .read = read_by<PlyReader>};

}  // namespace fstiff::inline v0_1::io::detail
