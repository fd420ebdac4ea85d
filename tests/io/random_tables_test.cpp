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

/// A table, and what must be read from it.
class RandomTable {
public:
    explicit RandomTable(unsigned seed) : random_(seed) {
        for (int i = 0; i < rows; ++i) add_row(i);
        text = head() + text + footer();
        if (one_in(6)) text = all_replaced(text, "-", "\xE2\x88\x92");
        text = all_replaced(text, "\n", std::array{"\n", "\n", "\r\n", "\r"}[below(4)]);
        encode();
        options.spacing = has_x() ? std::nullopt : std::optional(dx);
    }

    static constexpr int rows = 40;
    std::string text;
    io::SurfaceOptions options{};
    std::vector<double> heights{};  // [m], NaN where missing
    double dx = 0.5e-6;             // [m]

private:
    std::size_t below(std::size_t n) { return random_() % n; }
    bool one_in(std::size_t n) { return below(n) == 0; }
    bool has_x() const { return order_ != Order::z && order_ != Order::z_ok; }

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

    void add_row(int i) {
        const std::string n = std::to_string(i + 1), x = number(0.5 * i);
        double height = 0;
        std::string z = number(offset_ + 40 * std::sin(0.9 * i) + 7 * std::cos(2.3 * i * i), &height);
        const bool missing = !mark_.empty() && (i == 7 || i == 23);
        if (missing) z = mark_;
        heights.push_back(missing ? std::numeric_limits<double>::quiet_NaN() : height * 1e-9);
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

    void encode() {
        const std::size_t way = below(6);
        if (way == 0) text.insert(0, "\xEF\xBB\xBF");
        if (way == 1) text = all_replaced(text, "\xC2\xB5", "\xB5");
    }

    std::mt19937 random_;
    Order order_ = static_cast<Order>(below(10));
    Style style_ = static_cast<Style>(below(6));
    int decimals_ = static_cast<int>(style_ == Style::fixed ? 1 + below(5) : 4 + below(5));
    bool comma_ = one_in(2), quoted_ = one_in(2);
    double offset_ = one_in(2) ? 0 : 250;
    std::string separator_ = std::array{";", "\t", " ", "   ", ",", ", ", " | ", "|", " ; "}[below(9)];
    std::string mark_ = std::array{"", "", "NaN", "---", "BAD", "NA", "#N/A", "***"}[below(8)];
};

}  // namespace

TEST_CASE("A table drawn at random is read right or refused, and 17 of 20 are read") {
    constexpr unsigned count = 2000;
    unsigned right = 0;
    for (unsigned seed = 0; seed < count; ++seed) {
        const RandomTable table(seed);
        std::optional<io::Surface> found;
        (void)refusal([&] { found = read_text(table.text, table.options); });
        if (!found) continue;
        const std::string begin = table.text.substr(0, 300);
        CAPTURE(seed, begin);
        REQUIRE(found->is_profile());
        const Profile<double>& profile = found->profile();
        REQUIRE(static_cast<std::size_t>(profile.size()) == table.heights.size());
        CHECK(relative_error(profile.spacing, table.dx) <= 1e-6);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < table.heights.size(); ++i) {
            const double z = profile.heights[static_cast<Eigen::Index>(i)], truth = table.heights[i];
            wrong += !(std::isnan(truth) ? std::isnan(z) : std::abs(z - truth) <= 1e-12 * std::abs(truth));
        }
        CHECK(wrong == 0);
        ++right;
    }
    CHECK(right >= 17 * count / 20);
}

}  // namespace random_tables_test
