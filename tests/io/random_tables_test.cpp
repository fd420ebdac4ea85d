// SPDX-License-Identifier: BSD-3-Clause
// Tables of known heights in the ways of instruments, spreadsheets and scripts, drawn at random: what is read must be
// right, and most must be read. Truth: the numbers that are written.
#include "support/texts.hpp"

#include <array>
#include <cstdlib>
#include <random>

namespace random_tables_test {

using namespace fstiff;
using namespace test;

namespace {

enum class Style { fixed, exponent, fortran, three_digits, no_zero, plus };
enum class Order { z, xz, zx, nxz, txz, xzq, name_xz, xz_ok, xyz, z_ok };

/// Choices, and numbers in the way of one program.
class RandomText {
public:
    std::string text{};
    io::SurfaceOptions options{};
    std::vector<double> heights{};  // [m], NaN where missing

protected:
    explicit RandomText(unsigned seed) : random_(seed) {}

    std::size_t below(std::size_t n) { return random_() % n; }
    bool one_in(std::size_t n) { return below(n) == 0; }

    std::string number(double value, double* truth = nullptr) {
        char buffer[40];
        const bool fixed = style_ == Style::fixed || style_ == Style::no_zero || style_ == Style::plus;
        std::snprintf(buffer, sizeof buffer, fixed ? "%.*f" : "%.*E", decimals_, value);
        if (truth) *truth = std::strtod(buffer, nullptr);
        std::string cell = buffer;
        if (style_ == Style::fortran) cell = all_replaced(cell, "E", "D");
        if (style_ == Style::three_digits) cell.insert(cell.size() - 2, "0");
        if (style_ == Style::no_zero && std::abs(value) < 1 && cell.find("0.") < 2) cell.erase(cell.find("0."), 1);
        if (style_ == Style::plus && value >= 0) cell.insert(0, "+");
        if (!comma_) return cell;
        cell = with_commas(cell);
        return separator_.find(',') < separator_.size() && quoted_ ? '"' + cell + '"' : cell;
    }
    /// The height \p nanometres as it is written, or the mark of a missing point.
    std::string height(double nanometres, bool may_be_missing) {
        double written = 0;
        const std::string cell = number(nanometres, &written);
        const bool missing = may_be_missing && !mark_.empty();
        heights.push_back(missing ? std::numeric_limits<double>::quiet_NaN() : written * 1e-9);
        return missing ? mark_ : cell;
    }

    void finish() {
        if (one_in(6)) text = all_replaced(text, "-", "\xE2\x88\x92");
        text = all_replaced(text, "\n", std::array{"\n", "\n", "\r\n", "\r"}[below(4)]);
        const std::size_t way = below(6);
        if (way == 0) text.insert(0, "\xEF\xBB\xBF");
        if (way == 1) text = all_replaced(text, "\xC2\xB5", "\xB5");
    }

    std::mt19937 random_;
    Style style_ = static_cast<Style>(below(6));
    int decimals_ = static_cast<int>(style_ == Style::fixed ? 1 + below(5) : 4 + below(5));
    bool comma_ = one_in(2), quoted_ = one_in(2);
    std::string separator_ = std::array{";", "\t", " ", "   ", ",", ", ", " | ", "|", " ; "}[below(9)];
    std::string mark_ = std::array{"", "", "NaN", "---", "BAD", "NA", "#N/A", "***"}[below(8)];
};

/// A profile, and what must be read from it.
class RandomTable : public RandomText {
public:
    explicit RandomTable(unsigned seed) : RandomText(seed) {
        for (int i = 0; i < rows; ++i) add_row(i);
        text = head() + text + footer();
        finish();
        options.spacing = has_x() ? std::nullopt : std::optional(dx);
    }

    static constexpr int rows = 40;
    static constexpr double dx = 0.5e-6;  // [m]

private:
    bool has_x() const { return order_ != Order::z && order_ != Order::z_ok; }

    void add_row(int i) {
        const std::string n = std::to_string(i + 1), x = number(0.5 * i);
        const std::string z = height(offset_ + 40 * std::sin(0.9 * i) + 7 * std::cos(2.3 * i * i), i == 7 || i == 23);
        text += join({n, "P" + n, number(0.1 * i), x, number(2.5), z, number(90 + i % 7), "ok"}) + '\n';
    }

    /// The cells of the order, of index, name, time, x, y, z, quality and a mark, between separators.
    std::string join(const std::array<std::string, 8>& cells) const {
        static constexpr std::array<std::string_view, 10> orders{"5",   "35",  "53",  "035", "235",
                                                                 "356", "135", "357", "345", "57"};
        std::string line;
        for (const char c : orders[static_cast<std::size_t>(order_)])
            line += (line.empty() ? "" : separator_) + cells[static_cast<std::size_t>(c - '0')];
        return line;
    }

    std::string head() {
        std::string lines;
        for (const std::string_view remark :
             {"Stylus radius=2 um\n", "Speed: 0,5 mm/s\n", "Operator: Ann\n", "Date;2024-05-03\n", "[Data]\n"})
            if (one_in(5)) lines += remark;
        const std::array<std::string, 8> names{"Nr.", "Name", "t", "x", "y", "z", "Quality", "Status"};
        std::array<std::string, 8> titles = names;
        const std::string micro = one_in(4) ? "\xC2\xB5m" : "um";
        switch (below(5)) {
            case 0: options.units = has_x() ? "um,nm" : "nm"; return lines + (one_in(2) ? "" : join(names) + '\n');
            case 1:
                lines += "x-unit: " + micro + "\nz-unit: nm\n";
                return lines + (one_in(2) ? "" : join(names) + '\n');
            case 2: return lines + join(names) + '\n' + join({"-", "-", "s", micro, micro, "nm", "%", "-"}) + '\n';
            case 3: lines += one_in(2) ? "# " : ""; [[fallthrough]];
            default: {
                const std::string open = std::array{" [", "[", " (", "_", "/"}[below(5)];
                const std::string close = open.back() == '[' ? "]" : open.back() == '(' ? ")" : "";
                for (const std::size_t c : {3, 4}) titles[c] += open + micro + close;
                titles[5] += open + "nm" + close;
                return lines + join(titles) + '\n';
            }
        }
    }

    std::string footer() {
        if (!one_in(3)) return "";
        return std::array{"EOF\n", "\nRa;0.48\n", "Mean: 1.5\n", "[End]\n", "(40 rows)\n", "\x1A"}[below(6)];
    }

    Order order_ = static_cast<Order>(below(10));
    double offset_ = one_in(2) ? 0 : 250;
};

/// A map of 5 rows of 6, as a matrix or as points.
class RandomMap : public RandomText {
public:
    explicit RandomMap(unsigned seed) : RandomText(seed) {
        const bool points = one_in(2);
        std::vector<std::string> rows_of_points;
        std::string matrix = head(points);
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                const std::string z = height(250 * std::sin(1.9 * i + 2.3 * j * i) + 30 * j, i == 3 && j == 2);
                if (points) rows_of_points.push_back(point(i, j, z));
                if (axes_ && i == 0) matrix += number(2.0 * j) + separator_;
                matrix += z + (i + 1 < columns ? separator_ : "\n");
            }
        if (one_in(3)) std::shuffle(rows_of_points.begin(), rows_of_points.end(), random_);
        text = matrix;
        if (points) text = head_of_points_;
        for (const std::string& row : rows_of_points) text += row;
        finish();
    }

    static constexpr int rows = 5, columns = 6;
    static constexpr double dx = 0.5e-6, dy = 2e-6;  // [m]

private:
    std::string point(int i, int j, const std::string& z) {
        const std::array<std::string, 3> cells{number(0.5 * i), number(2.0 * j), z};
        std::string row = numbered_ ? std::to_string(columns * j + i + 1) + separator_ : "";
        for (const std::size_t c : order_) row += cells[c] + (c == order_[2] ? "" : separator_);
        return row + (named_ ? separator_ + "ok" : "") + '\n';
    }

    std::string head(bool points) {
        if (points) {
            const std::array<std::string, 3> titles{"x[um]", "y[um]", "z[nm]"};
            const bool titled = numbered_ || order_[0] != 0 || one_in(2);
            head_of_points_ = numbered_ ? "Nr." + separator_ : "";
            for (const std::size_t c : order_) head_of_points_ += titles[c] + (c == order_[2] ? "" : separator_);
            head_of_points_ += (named_ ? separator_ + "Status" : "") + '\n';
            if (titled) return "";
            head_of_points_.clear();
            options.units = "um,nm";
            return "";
        }
        std::string lines = one_in(3) ? "Stylus radius=2 um\nSpeed: 0,5 mm/s\n" : "";
        if (axes_) {
            std::string line = "y\\x[um]";
            for (int i = 0; i < columns; ++i) line += separator_ + number(0.5 * i);
            return lines + "# Value units: nm\n" + line + '\n';
        }
        switch (below(3)) {
            case 0:
                options.units = "nm";
                options.dx = dx, options.dy = dy;
                return lines;
            case 1: return lines + "# Width: 3 um\n# Height: 10 um\n# Value units: nm\n";
            default: return lines + "dx = 0.5 um\ndy = 2 um\nz-unit = nm\n";
        }
    }

    bool axes_ = one_in(3), numbered_ = one_in(3), named_ = one_in(3);
    std::array<std::size_t, 3> order_ = one_in(3)   ? std::array<std::size_t, 3>{2, 0, 1}
                                        : one_in(2) ? std::array<std::size_t, 3>{1, 0, 2}
                                                    : std::array<std::size_t, 3>{0, 1, 2};
    std::string head_of_points_{};
};

/// How many of the \p found heights are not those that are written in \p text.
std::size_t wrong_heights(const double* found, const RandomText& text) {
    std::size_t wrong = 0;
    for (const double truth : text.heights) {
        const double z = *found++;
        wrong += !(std::isnan(truth) ? std::isnan(z) : std::abs(z - truth) <= 1e-12 * std::abs(truth));
    }
    return wrong;
}

constexpr unsigned drawn = 2000;

/// Draws texts, and checks those that are read by \p check. \return how many these are
template <class Text, class Check>
unsigned right_of(const Check& check) {
    unsigned right = 0;
    for (unsigned seed = 0; seed < drawn; ++seed) {
        const Text text(seed);
        std::optional<io::Surface> found;
        (void)refusal([&] { found = read_text(text.text, text.options); });
        if (!found) continue;
        const std::string begin = text.text.substr(0, 300);
        CAPTURE(seed, begin);
        check(text, *found);
        ++right;
    }
    return right;
}

}  // namespace

TEST_CASE("A profile drawn at random is read right or refused, and 17 of 20 are read") {
    const unsigned right = right_of<RandomTable>([](const RandomTable& table, const io::Surface& found) {
        REQUIRE(found.is_profile());
        REQUIRE(found.profile().size() == table.heights.size());
        CHECK(relative_error(found.profile().spacing, table.dx) <= 1e-6);
        CHECK(wrong_heights(found.profile().heights.data(), table) == 0);
    });
    CHECK(right >= 17 * drawn / 20);
}

TEST_CASE("A map drawn at random is read right or refused, and nine of ten are read") {
    const unsigned right = right_of<RandomMap>([](const RandomMap& map, const io::Surface& found) {
        REQUIRE(!found.is_profile());
        const auto& heights = found.map().heights;
        REQUIRE((heights.rows() == map.rows && heights.cols() == map.columns));
        CHECK(relative_error(found.map().dx, map.dx) <= 1e-6);
        CHECK(relative_error(found.map().dy, map.dy) <= 1e-6);
        CHECK(wrong_heights(heights.data(), map) == 0);
    });
    CHECK(right >= 9 * drawn / 10);
}

}  // namespace random_tables_test
