// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads heights of a MATLAB file of level 5 (.mat; io/mat_file.hpp).
///
/// The heights are the only variable of real numbers in two dimensions, the only one next to x and y, or z next to x.
/// Of several the options choose. A vector is a profile, a matrix a map of at least 4 a side, whose first index counts
/// the rows. x and y of these names are its positions: one for each column and row, or one for each height in any
/// order. They are equally spaced, to within a hundredth of a step, and rise in the map; points without a height are
/// missing. The file states no units, and without x no steps: they are given.
///
/// Units       map in m; SurfaceOptions::units are the file's
/// Valid       2 points a side at least, or one row; heights that vary
/// Accuracy    number times unit, rounded once (tests/io/mat_test.cpp)

#include "io/readers.hpp"

#include "io/given_lengths.hpp"
#include "io/mat_file.hpp"
#include "io/regular_grid.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

class MatReader {
public:
    MatReader(std::string_view bytes, const std::string& name, const SurfaceOptions& options)
        : bytes_(bytes), name_(name), options_(options) {}

    Reading read() {
        if (!is_mat(bytes_)) refuse_file(name_, {"does not begin as a MATLAB file of level 5; must begin so"});
        variables_ = mat_variables(bytes_, name_);
        const MatVariable& chosen = choose();
        const GivenUnits units = given_lengths(options_, name_, true);
        MatNumbers heights = mat_numbers(bytes_, name_, chosen);
        const std::string missing = take_heights(heights.values, units, options_, name_);
        RawMap map;
        const std::string from =
            is_placed() ? place(map, chosen, heights.values, units) : take_columns(map, chosen, heights.values);
        Record record;
        record.note("form", "MATLAB file, variable " + chosen.shown());
        record.note("units", units.note());
        record.note("spacing", "from " + from);
        record.note_points(map, missing);
        if (const std::string others = list(&chosen); !others.empty())
            record.note("other variables", others + ", not read" + (is_placed() ? " but for x and y" : ""));
        record.resolution = heights.are_whole ? units.vertical : 0;
        return {std::move(map), std::move(record)};
    }

private:
    /// Every variable but \p chosen, for messages.
    std::string list(const MatVariable* chosen = nullptr) const {
        std::string text;
        for (const MatVariable& variable : variables_)
            if (&variable != chosen && variable.number <= 20) text += (text.empty() ? "" : "; ") + variable.shown();
        return text + (variables_.size() > 20 ? " ..." : "");
    }

    /// The variable of numbers that is called \p letter in either case, if there is one.
    const MatVariable* named(std::string_view letter) const {
        const MatVariable* found = nullptr;
        for (const MatVariable& variable : variables_)
            if (variable.has_numbers() && lower_case(variable.name) == letter) {
                if (found) return nullptr;
                found = &variable;
            }
        return found;
    }

    const MatVariable& choose() const {
        const std::string wanted(trimmed(options_.channel));
        const std::string choice = given_as(options_.names, "channel", "\"1\"");
        std::vector<const MatVariable*> found;
        for (const MatVariable& variable : variables_)
            if (wanted.empty() ? variable.has_numbers()
                               : variable.name == wanted || std::to_string(variable.number) == wanted)
                found.push_back(&variable);
        if (found.size() > 1 && wanted.empty()) {
            const MatVariable *const x = named("x"), *const y = named("y"), *const z = named("z");
            std::vector<const MatVariable*> rest = found;
            std::erase_if(rest, [&](const MatVariable* one) { return x && (one == x || one == y); });
            if (!rest.empty()) found = std::move(rest);
            if (x && z) found = {z};
        }
        const std::string allowed = "; must be real numbers of two dimensions";
        if (variables_.empty()) refuse_file(name_, {"holds no variable", allowed});
        if (found.empty() && wanted.empty())
            refuse_file(name_, {"holds no variable of heights, but ", list(), allowed,
                                ": save the array itself as a variable, not within a struct or a cell"});
        if (found.size() > 1)
            refuse_file(name_, {"holds ", variables_.size(), " variables: ", list(),
                                "; the heights must be one of them, ", choice});
        if (found.empty())
            refuse_file(name_, {"has no variable ", shown_cell(wanted), "; must be one of ", list(), ", ", choice});
        if (!found.front()->has_numbers()) refuse_file(name_, {"holds ", found.front()->shown(), allowed});
        if (!found.front()->is_vector() && (std::min)(found.front()->sizes[0], found.front()->sizes[1]) < 4)
            refuse_file(name_, {"holds ", found.front()->shown(),
                                ", which may be columns of a table; must be a vector or a matrix of at least 4 a side: "
                                "save its columns as x, y and z"});
        return *found.front();
    }

    /// Whether x and y of the file are the positions.
    [[nodiscard]] bool is_placed() const {
        return named("x") && variables_.size() > 1 && !options_.spacing && !gives_size(options_);
    }

    /// The numbers as MATLAB stores them, column after column, with the steps of the options.
    std::string take_columns(RawMap& map, const MatVariable& chosen, const std::vector<double>& heights) const {
        const bool is_profile = chosen.is_vector();
        const std::size_t columns = is_profile ? heights.size() : static_cast<std::size_t>(chosen.sizes[1]),
                          rows = heights.size() / columns;
        const GivenSteps steps = given_steps_of(rows, columns, options_, name_);
        allocate(map, rows, columns);
        for (std::size_t i = 0; i < heights.size(); ++i) map.heights[i % rows * columns + i / rows] = heights[i];
        set_spacings(map, steps.dx, steps.dy, name_);
        return steps.from;
    }

    /// Positions of all heights along an axis: \p variable has one for each of them, or for each of the \p count that
    /// \p index(i) of height i counts.
    template <class Index>
    std::vector<double> positions(const MatVariable& variable, std::size_t heights, std::size_t count,
                                  const Index& index) const {
        if (variable.count() != heights && variable.count() != count)
            refuse_file(name_, {"has ", variable.count(), " positions ", shown_cell(variable.name), " for ", heights,
                                " heights; must be ", count, " or ", heights, ", or ", given_steps(options_.names)});
        const std::vector<double> values = mat_numbers(bytes_, name_, variable).values;
        if (values.size() == heights) return values;
        std::vector<double> each(heights);
        for (std::size_t i = 0; i < heights; ++i) each[i] = values[index(i)];
        return each;
    }

    /// The axis of \p positions called \p axis, which are numbers of a computation and not printed ones.
    GridAxis axis_of(std::vector<double> positions, std::string_view axis) const {
        const auto is_missing = [](double position) { return std::isnan(position); };
        if (std::any_of(positions.begin(), positions.end(), is_missing))
            refuse_file(name_, {"has a position ", axis, " that is missing; must have all"});
        std::sort(positions.begin(), positions.end());
        const double low = positions.front(), length = positions.back() - low;
        double largest = 0, least = length;
        for (std::size_t i = 1; i < positions.size(); ++i)
            largest = (std::max)(largest, positions[i] - positions[i - 1]);
        for (std::size_t i = 1; i < positions.size(); ++i)  // what is smaller is rounding
            if (const double gap = positions[i] - positions[i - 1]; gap > largest / 50) least = (std::min)(least, gap);
        const double steps = std::round(length / least);
        const auto refuse = [&] {
            refuse_file(name_,
                        {"has positions ", axis, " that are not equally spaced; must be, to a hundredth of a step"});
        };
        // no more places than twice the heights are filled
        if (!(length > 0 && std::isfinite(length) && steps >= 1 && steps < 2 * static_cast<double>(positions.size())))
            refuse();
        const GridAxis found{low, length / steps, static_cast<std::size_t>(steps) + 1};
        for (const double position : positions) {
            const double place = (position - low) / found.step;
            if (!(std::abs(place - std::round(place)) <= 0.01)) refuse();
        }
        return found;
    }

    /// The heights at their positions.
    std::string place(RawMap& map, const MatVariable& chosen, const std::vector<double>& heights,
                      const GivenUnits& units) const {
        const MatVariable &x = *named("x"), *const y = named("y");
        const std::size_t count = heights.size(), rows = static_cast<std::size_t>(chosen.sizes[0]);
        if (!y && !chosen.is_vector())
            refuse_file(
                name_, {"has positions x, but no y, of a matrix; must have both, or be ", given_steps(options_.names)});
        const bool is_vector = chosen.is_vector();
        const std::vector<double> xs = positions(x, count, is_vector ? count : count / rows,
                                                 [&](std::size_t i) { return is_vector ? i : i / rows; });
        const std::vector<double> ys =
            y ? positions(*y, count, is_vector ? count : rows, [&](std::size_t i) { return i % rows; })
              : std::vector<double>();
        const GridAxis along_x = axis_of(xs, "x"), along_y = y ? axis_of(ys, "y") : GridAxis{.count = 1};
        if (along_x.count > 2 * count / along_y.count)
            refuse_file(name_, {"has ", count, " heights at x and y that fill no grid, of ", along_x.count, " x ",
                                along_y.count, " points; must fill half of it at least"});
        allocate(map, along_y.count, along_x.count);
        std::fill(map.heights.begin(), map.heights.end(), std::numeric_limits<double>::quiet_NaN());
        std::vector<bool> filled(map.heights.size());
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = (y ? along_y.index(ys[i]) : 0) * along_x.count + along_x.index(xs[i]);
            if (filled[at]) refuse_file(name_, {"has two heights at one position; must have one"});
            filled[at] = true;
            map.heights[at] = heights[i];
        }
        set_spacings(map, along_x.step * units.lateral, along_y.step * units.lateral, name_);
        return y ? "x and y of the file" : "x of the file";
    }

    std::string_view bytes_;
    const std::string& name_;
    const SurfaceOptions& options_;
    std::vector<MatVariable> variables_;
};

}  // namespace

extern constexpr Reader mat_reader{
    .format = SurfaceFormat::mat,
    .endings = ".mat",
    .holds =
        "MATLAB file of versions 5 to 7: a vector is a profile, a matrix a map; compressed where fstiff was built "
        "with zlib",
    .recognised = "its first words, MATLAB 5.0",
    .asks_for = "--units, and without x and y --spacing, or of a map --dx and --dy or --width and --height",
    .options = "units spacing dx dy width height missing channel",
    .begins = is_mat,
    .read = read_by<MatReader>};

}  // namespace fstiff::inline v0_1::io::detail
