// SPDX-License-Identifier: BSD-3-Clause
// Integrals over the peaks above a separation, for rows of a CSV table: a gauge that anybody can check.
//
//     example_integral [--tolerance X] [FILE]              J[a,b](eta; r, theta) of the columns a,b,r,theta,eta
//     example_integral --yielding [--tolerance X] [FILE]   load of peaks that yield, of the columns r,theta,eta
//
// Without FILE it reads standard input. The rows come back with value,error,evaluations added; other columns stay as
// they are, but an input column of one of these names becomes input_value and so on. Cells have no quotation marks.
// X is the relative tolerance, 2.2e-14 by default. A value has the digits that its error leaves, and one more.
// Exit code 3: bad input, in one sentence.
#include <fstiff/peaks/contact_integrals.hpp>
#include <fstiff/peaks/tensor_integrals.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace {

using Cells = std::vector<std::string>;

/// A function of one's own: e^1.5/sqrt(t) as by Hertz up to e = 1/(2t), the tangent beyond, for a peak that yields.
struct YieldingPeak {
    static double critical(double t) { return 0.5 / t; }  // the kink, at which the integrator splits
    double operator()(double e, double t) const {
        const double elastic = (std::min)(e, critical(t));
        return std::sqrt(elastic / t) * (elastic + 1.5 * (e - elastic));
    }
};

Cells cells_of(const std::string& line) {
    Cells cells{""};
    for (const char c : line)
        if (c == ',')
            cells.emplace_back();
        else if (c != ' ' && c != '\t' && c != '\r')
            cells.back() += c;
    return cells;
}

double number_of(const std::string& text, const std::string& name) {
    const char *begin = text.data() + text.starts_with('+'), *end = text.data() + text.size();
    double value = 0;
    const auto [last, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || last != end)
        throw fstiff::domain_error(name + " = \"" + text + "\": must be a number, with a point as decimal mark");
    return value;
}

/// The integral of one row and its error; the last two columns are absent of a peak that yields.
fstiff::Estimate<double> integral_of(const std::vector<double>& row, double tolerance) {
    const fstiff::PeakDistribution<double> peaks(row[0], row[1]);
    const double eta = row[2];
    if (row.size() == 3) return fstiff::peak_integral(YieldingPeak{}, peaks, eta, {.relative_tolerance = tolerance});
    return fstiff::contact_integral(row[3], row[4], peaks, eta, {.relative_tolerance = tolerance});
}

/// Digits of a value whose rounding is below a tenth of its error.
int digits_of(const fstiff::Estimate<double>& integral) {
    const double ratio = std::abs(integral.value) / integral.error;
    return ratio < 1e16 ? 1 + static_cast<int>(std::ceil(std::log10((std::max)(ratio, 1.0)))) : 17;
}

/// Reads the header or, after it, a row; prints it with what is added.
void read_line(const Cells& cells, const Cells& names, Cells& header, double tolerance) {
    if (header.empty()) {
        for (const std::string& name : names)
            if (std::count(cells.begin(), cells.end(), name) != 1)
                throw fstiff::domain_error("header: must name the column " + name + " once");
        header = cells;
        for (const std::string& cell : cells)
            std::cout << (cell == "value" || cell == "error" || cell == "evaluations" ? "input_" : "") << cell << ',';
        std::cout << "value,error,evaluations\n";
        return;
    }
    if (cells.size() != header.size())
        throw fstiff::domain_error("has " + std::to_string(cells.size()) + " cells; must have " +
                                   std::to_string(header.size()) + " as the header");
    std::vector<double> row;
    for (const std::string& name : names)
        row.push_back(number_of(
            cells[static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin())], name));
    const fstiff::Estimate<double> integral = integral_of(row, tolerance);
    for (const std::string& cell : cells) std::cout << cell << ',';
    std::printf("%.*g,%.0e,%d\n", digits_of(integral), integral.value, integral.error, integral.evaluations);
}

void integrate(std::istream& in, const std::string& file, const Cells& names, double tolerance) {
    Cells header;
    std::size_t number = 0, lines = 0;
    for (std::string line; std::getline(in, line);) {
        if (++number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
        const Cells cells = cells_of(line);
        if (cells == Cells{""}) continue;
        try {
            read_line(cells, names, header, tolerance);
        } catch (const fstiff::domain_error& error) {
            throw error.with_place({.file = file, .line = number, .before_line = ":"});
        }
        ++lines;
    }
    if (lines < 2)
        throw fstiff::domain_error(file + (lines == 0 ? ": is empty" : ": has no row") +
                                   "; must have a header and rows");
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::string file;
        Cells names{"r", "theta", "eta", "a", "b"};
        double tolerance = 100 * std::numeric_limits<double>::epsilon();
        for (int i = 1; i < argc; ++i) {
            const std::string word = argv[i];
            if (word == "--yielding")
                names.resize(3);
            else if (word == "--tolerance" && i + 1 < argc)
                tolerance = number_of(argv[++i], word);
            else if (word.starts_with("--") || !file.empty())
                throw fstiff::domain_error(word + ": must be --yielding, --tolerance X or the name of one file");
            else
                file = word;
        }
        std::ifstream of_name(file);
        if (!file.empty() && !of_name) throw fstiff::domain_error(file + ": cannot be read; must be a CSV table");
        integrate(file.empty() ? std::cin : of_name, file.empty() ? "standard input" : file, names, tolerance);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "example_integral: " << error.what() << '\n';
        return 3;
    }
}
