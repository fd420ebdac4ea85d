// SPDX-License-Identifier: BSD-3-Clause
// Sweeps: the rows of many scenes as columns.
#include "module.hpp"

#include "document/file.hpp"
#include "sweep/engine.hpp"

#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>

#include <algorithm>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

namespace fstiff::python {
namespace {

using namespace sweep;

/// The rows of all blocks by columns, in the order of the keys in the lines of `fstiff sweep`.
class SweptColumns {
public:
    explicit SweptColumns(const Grid& grid) : grid_(grid), axes_(grid.axes.size()) {}

    void add(const Block& block) {
        for (const Row& row : block.rows) {
            const std::size_t place = index_.size();
            index_.push_back(static_cast<double>(block.first + row.scene));
            for (std::size_t i = 0; i < axes_.size(); ++i) {
                const Value& value = block.values[row.scene][i];
                axes_[i].push_back(grid_.axes[i].is_text() ? static_cast<double>(value.place) : value.number);
            }
            const std::string_view law = row.law == LawKind::none ? std::string_view() : name_of(row.law);
            const auto known = std::find(names_.begin(), names_.end(), law);
            laws_.push_back(static_cast<double>(known - names_.begin()));
            if (known == names_.end()) names_.emplace_back(law);
            answers_.push_back(row.answer);
            if (!row.error.empty()) errors_[place] = row.error;
            if (row.law == LawKind::none) continue;
            const double* number = block.numbers.data() + row.begin;
            put(place, "theta", *number++);
            put(place, "r", *number++);
            for (const scene::NumberOf& column : block.headers[row.header]) put(place, column.key(), *number++);
        }
    }
    /// Needs the GIL.
    [[nodiscard]] nb::dict take() {
        nb::list axes, columns;
        for (std::size_t i = 0; i < axes_.size(); ++i)
            axes.append(nb::make_tuple(grid_.axes[i].key, grid_.axes[i].texts, NewArray(axes_[i]).take()));
        for (auto& [key, numbers] : columns_) {
            numbers.resize(index_.size(), none);
            columns.append(nb::make_tuple(key, NewArray(numbers).take()));
        }
        nb::dict all;
        all["index"] = NewArray(index_).take();
        all["axes"] = axes;
        all["laws"] = names_;
        all["law"] = NewArray(laws_).take();
        all["columns"] = columns;
        all["answer"] = NewArray(answers_).take();
        all["errors"] = errors_;
        return all;
    }

private:
    void put(std::size_t place, std::string_view key, double number) {
        if (next_ == columns_.size() || columns_[next_].first != key) {
            next_ = 0;
            while (next_ < columns_.size() && columns_[next_].first != key) ++next_;
            if (next_ == columns_.size()) columns_.emplace_back(key, std::vector<double>());
        }
        std::vector<double>& numbers = columns_[next_++].second;
        numbers.resize(place, none);
        numbers.push_back(number);
    }

    static constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const Grid& grid_;
    std::vector<double> index_, laws_, answers_;
    std::vector<std::vector<double>> axes_;
    std::vector<std::string> names_;  ///< of laws; empty: the scene cannot be computed
    std::map<std::size_t, std::string> errors_;
    std::vector<std::pair<std::string, std::vector<double>>> columns_;
    std::size_t next_ = 0;  ///< the column that likely comes next
};

nb::dict swept(const std::string& text, const std::string& file, const std::string& axes,
               const std::map<std::string, In>& numbers, const std::string& surface,
               const surface::MeasuredSurface* measured, std::optional<std::pair<std::uint64_t, std::uint64_t>> part,
               unsigned threads) {
    Given given{.text = axes};
    for (const auto& [key, array] : numbers)
        given.numbers[key].assign(numbers_of(array).begin(), numbers_of(array).end());
    nb::gil_scoped_release free;
    const Grid grid = file.empty() ? read_grid(text, "scene", given)
                                   : read_grid(document::read_all(file, document::longest_scene),
                                               document::display_name(file), given);
    const Rows rows = part ? Rows{part->first, part->second} : Rows{0, grid.size};
    grid.require(rows,
                 "rows = (" + std::to_string(rows.first) + ", " + std::to_string(rows.end) + "): must be (FROM, TO)");
    SceneMaker maker(grid, {.name = "", .surface = surface, .measured = measured});
    SweptColumns columns(grid);
    run(grid, maker, rows,
        {.threads = threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency()),
         .lines = false,
         .progress = until_interrupted()},
        [&](const Block& block) {
            try {
                columns.add(block);
            } catch (const std::bad_alloc&) {  // what was taken cannot be taken again
                const nb::gil_scoped_acquire held;
                PyErr_NoMemory();
                throw nb::python_error();
            }
        });
    const nb::gil_scoped_acquire held;
    return columns.take();
}

}  // namespace

void add_sweeps(nb::module_& m) {
    m.def("sweep", &swept, nb::arg("text"), nb::arg("file"), nb::arg("axes"), nb::arg("numbers"), nb::arg("surface"),
          nb::arg("measured").none(), nb::arg("rows").none(), nb::arg("threads"));
}

}  // namespace fstiff::python
