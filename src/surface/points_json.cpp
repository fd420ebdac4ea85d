// SPDX-License-Identifier: BSD-3-Clause
#include "surface/points_json.hpp"

#include "io/number.hpp"

#include <fstiff/core/error.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace fstiff::surface {
namespace {

constexpr std::size_t most_depth = 32;

/// Takes the events of the parser, so that memory is that of the lines.
class PointHandler : public nlohmann::json_sax<nlohmann::json> {
public:
    PointLines lines;
    std::string problem;  ///< where the parser was ended

    bool null() override { return value("nan"); }
    bool boolean(bool) override { return other(); }
    bool number_integer(number_integer_t number) override { return value(std::to_string(number)); }
    bool number_unsigned(number_unsigned_t number) override { return value(std::to_string(number)); }
    bool number_float(number_float_t, const string_t& written) override { return value(written); }
    bool string(string_t& text) override { return io::detail::is_missing_word(text) ? value("nan") : other(); }
    bool binary(binary_t&) override { return other(); }
    bool key(string_t& name) override {
        frames_.back().key = name.substr(0, 64);
        return true;
    }
    bool start_object(std::size_t) override { return open(false); }
    bool start_array(std::size_t) override { return open(true); }
    bool end_object() override {
        const auto& [x, y, z] = frames_.back().members;
        const bool is_point = !x.empty() && !(y.empty() && z.empty());
        std::vector<std::string> cells;
        for (const std::string& cell : frames_.back().members)
            if (!cell.empty()) cells.push_back(cell);
        return close(is_point, cells);
    }
    bool end_array() override {
        const std::vector<std::string> cells = std::move(frames_.back().cells);
        return close(!frames_.back().has_other && cells.size() > 1 && in_array(), cells);
    }
    bool parse_error(std::size_t place, const std::string&, const nlohmann::detail::exception&) override {
        problem = "is no JSON at byte " + std::to_string(place) + "; must be a list of points";
        return false;
    }

private:
    struct Frame {
        bool is_array{};
        std::size_t id{};
        std::string key{};                     // of the member that is read
        std::vector<std::string> cells{};      // numbers of an array; one number more than a point has at most
        bool has_other = false;                // something that is no number
        std::array<std::string, 3> members{};  // x, y, z of an object
    };

    bool in_array() const { return frames_.size() > 1 && frames_[frames_.size() - 2].is_array; }

    bool open(bool is_array) {
        if (!frames_.empty()) frames_.back().has_other = true;
        if (frames_.size() == most_depth) return refuse("is JSON of more than 32 levels");
        frames_.push_back({.is_array = is_array, .id = ++opened_});
        return true;
    }
    /// Ends a frame, which is a point with the numbers \p cells where it \p is_point.
    bool close(bool is_point, const std::vector<std::string>& cells) {
        frames_.pop_back();
        if (!is_point) return true;
        std::size_t list = 0, named = 0;  // the list that holds it
        for (std::size_t i = 0; i < frames_.size(); ++i)
            if (frames_[i].is_array) list = frames_[i].id, named = i;
        if (lines.points > 0 && list != list_) return refuse("holds several lists of points");
        if (lines.points == 0 && named > 0) lines.list = io::detail::printable(frames_[named - 1].key, 32);
        list_ = list;
        ++lines.points;
        for (std::size_t k = 0; k < cells.size(); ++k) lines.text += (k == 0 ? "" : "\t") + cells[k];
        lines.text += '\n';
        return true;
    }
    bool value(const std::string& text) {
        if (frames_.empty()) return true;
        Frame& frame = frames_.back();
        if (frame.is_array) {
            if (frame.cells.size() < 16)
                frame.cells.push_back(text);
            else
                frame.has_other = true;
        } else if (frame.key.size() == 1) {
            const std::size_t k = std::string_view("xyzXYZ").find(frame.key);
            if (k < 6) frame.members[k % 3] = text;
        }
        return true;
    }
    bool other() {
        if (!frames_.empty() && frames_.back().is_array) frames_.back().has_other = true;
        return true;
    }
    bool refuse(const char* what) {
        problem = std::string(what) + "; must hold one list of points, such as [[x, y, z], ...]";
        return false;
    }

    std::vector<Frame> frames_;
    std::size_t opened_ = 0, list_ = 0;
};

}  // namespace

bool is_points_json(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    const auto skip = [&] { bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size())); };
    skip();
    if (bytes.starts_with('{')) {
        const std::string_view head = bytes.substr(0, 4096);
        return bytes.find("\"fstiff_version\"") == bytes.npos &&
               (head.find("\"x\"") < head.size() || head.find("\"X\"") < head.size() || head.find("[[") < head.size());
    }
    if (!bytes.starts_with('[')) return false;
    bytes.remove_prefix(1);
    skip();
    return bytes.starts_with('{') || bytes.starts_with('[');
}

PointLines lines_of_points(std::string_view bytes, const std::string& name) {
    PointHandler handler;
    const bool whole = nlohmann::json::sax_parse(bytes.begin(), bytes.end(), &handler);
    if (whole && handler.lines.points > 0) return std::move(handler.lines);
    throw domain_error(name + ": " +
                       (whole ? "is JSON without points; must hold a list such as [[x, y, z], ...]" : handler.problem));
}

}  // namespace fstiff::surface
