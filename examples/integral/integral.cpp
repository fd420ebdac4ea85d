// SPDX-License-Identifier: BSD-3-Clause
// Integrals over the peaks above a separation, for rows of a CSV table: a gauge that anybody can check.
//
//     example_integral [--tolerance X] [FILE]              J[a,b](eta; r, theta) of the columns a,b,r,theta,eta
//     example_integral --yielding [--tolerance X] [FILE]   load of peaks that yield, of the columns r,theta,eta
//
// Without FILE it reads standard input. The rows come back with value,error,evaluations added; other columns stay as
// they are, but an input column of one of these names becomes input_value and so on. Cells have no quotation marks.
#include <fstiff/contact/contact_integrals.hpp>
#include <fstiff/contact/tensor_integrals.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
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

void integrate(std::istream& in, const std::string& file, bool yielding, double tolerance) {
    const Cells names = yielding ? Cells{"r", "theta", "eta"} : Cells{"r", "theta", "eta", "a", "b"};
    std::vector<std::ptrdiff_t> columns;
    Cells header;
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
        Cells cells = cells_of(line);
        if (cells == Cells{""}) continue;
        fstiff::parts::located({.file = file, .line = number, .before_line = ":"}, [&] {
            if (header.empty()) {
                header = cells;
                for (const std::string& name : names) {
                    if (std::count(header.begin(), header.end(), name) != 1)
                        throw fstiff::domain_error("header: must name the column " + name + " once");
                    columns.push_back(std::find(header.begin(), header.end(), name) - header.begin());
                }
                for (const std::string& cell : header)
                    std::cout << (cell == "value" || cell == "error" || cell == "evaluations" ? "input_" : "") << cell
                              << ',';
                std::cout << "value,error,evaluations\n";
                return;
            }
            if (cells.size() != header.size())
                throw fstiff::domain_error("has " + std::to_string(cells.size()) + " cells; must have " +
                                           std::to_string(header.size()) + " as the header");
            std::vector<double> x;
            for (std::size_t i = 0; i < names.size(); ++i)
                x.push_back(number_of(*(cells.begin() + columns[i]), names[i]));
            const fstiff::PeakDistribution<double> peaks(x[0], x[1]);
            const auto found =
                yielding ? fstiff::peak_integral(YieldingPeak{}, peaks, x[2], {.relative_tolerance = tolerance})
                         : fstiff::contact_integral(x[3], x[4], peaks, x[2], {tolerance});
            for (const std::string& cell : cells) std::cout << cell << ',';
            std::printf("%.13g,%.0e,%d\n", found.value, found.error, found.evaluations);
        });
    }
    if (columns.empty()) throw fstiff::domain_error(file + ": is empty; must have a header and rows");
}

}  // namespace

int main(int argc, char** argv) {
    std::cout.sync_with_stdio();
    try {
        std::string file;
        bool yielding = false;
        double tolerance = 1e-13;
        for (int i = 1; i < argc; ++i) {
            const std::string word = argv[i];
            if (word == "--yielding")
                yielding = true;
            else if (word == "--tolerance" && i + 1 < argc)
                tolerance = number_of(argv[++i], word);
            else if (word.starts_with("--") || !file.empty())
                throw fstiff::domain_error(word + ": must be --yielding, --tolerance X or the name of one file");
            else
                file = word;
        }
        std::ifstream of_name(file);
        if (!file.empty() && !of_name) throw fstiff::domain_error(file + ": cannot be read; must be a CSV table");
        integrate(file.empty() ? std::cin : of_name, file.empty() ? "standard input" : file, yielding, tolerance);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "example_integral: " << error.what() << '\n';
        return 3;
    }
}
