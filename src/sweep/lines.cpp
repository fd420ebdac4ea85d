// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/lines.hpp"

#include "actions/answered.hpp"
#include "document/file.hpp"
#include "document/json.hpp"

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fstiff::sweep {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Computes the scenes of a block into its rows.
class Computation {
public:
    Computation(const Grid& grid, SceneMaker& maker, SceneMaker::Work& work, Block& block)
        : grid_(grid), maker_(maker), work_(work), block_(block) {}

    void run() {
        std::vector<std::size_t> order(block_.values.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        const std::size_t* point = maker_.point_axis();
        if (point) sort_by_surface(*point, order);
        for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
            end = begin + 1;
            while (point && end < order.size() && maker_.alike(block_.values[order[begin]], block_.values[order[end]]))
                ++end;
            compute(std::span(order).subspan(begin, end - begin));
        }
        std::stable_sort(block_.rows.begin(), block_.rows.end(),
                         [](const Row& a, const Row& b) { return a.scene < b.scene; });
    }

private:
    /// Puts scenes that differ in their point alone side by side.
    void sort_by_surface(std::size_t point_axis, std::vector<std::size_t>& order) const {
        for (const Axis& axis : grid_.axes)
            if (axis.drawn && &axis != &grid_.axes[point_axis]) return;  // no two scenes are alike
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            for (std::size_t i = 0; i < grid_.axes.size(); ++i)
                if (i != point_axis && block_.values[a][i].place != block_.values[b][i].place)
                    return block_.values[a][i].place < block_.values[b][i].place;
            return false;
        });
    }

    /// Computes \p scenes, which differ in their point alone, as one scene with many points. Where a point cannot be
    /// computed, its scene alone has no result.
    void compute(std::span<const std::size_t> scenes) {
        if (scenes.size() == 1) return compute_one(scenes.front());
        if (scenes.size() <= detail::many_points && compute_together(scenes)) return;  // more are interpolated
        compute(scenes.first(scenes.size() / 2));
        compute(scenes.subspan(scenes.size() / 2));
    }

    void compute_one(std::size_t place) {
        const std::size_t rows = block_.rows.size();
        const auto refuse = [&](const std::exception& error) {
            ++block_.failed;
            block_.rows.resize(rows);
            block_.rows.push_back({.scene = place, .error = error.what()});
        };
        try {
            maker_.make(block_.values[place], work_);
            bool misses = false;
            const std::vector<AnswerCurve> curves = actions::curves_of(work_.scene, work_.contacts);
            take_columns(curves);
            for (const AnswerCurve& curve : curves)
                for (const AnswerPoint& point : curve.points) {
                    add(place, curve, point);
                    misses = misses || !point.ok();
                }
            block_.failed += misses ? 1 : 0;
        } catch (const domain_error& error) {
            refuse(error);
        } catch (const file_error& error) {
            refuse(error);
        }
    }

    bool compute_together(std::span<const std::size_t> scenes) {
        const std::size_t point = *maker_.point_axis();
        try {
            maker_.make(block_.values[scenes.front()], work_);
            std::vector<double>& points = work_.scene.points;
            points.clear();
            for (const std::size_t place : scenes) points.push_back(block_.values[place][point].number);
            const bool allowed = std::all_of(points.begin(), points.end(), [&](double x) {
                return std::isfinite(x) && (work_.scene.at_separations || x > 0);
            });
            const std::vector<AnswerCurve> curves =
                allowed ? actions::curves_of(work_.scene, work_.contacts) : std::vector<AnswerCurve>();
            points.resize(1);  // that of the next scene is put in its place
            if (!allowed) return false;
            for (const AnswerCurve& curve : curves)
                if (actions::count_of(curve) != scenes.size()) return false;
            take_columns(curves);
            for (std::size_t i = 0; i < scenes.size(); ++i)
                for (const AnswerCurve& curve : curves) add(scenes[i], curve, curve.points[i]);
            return true;
        } catch (const domain_error&) {
        } catch (const file_error&) {
        }
        work_.scene.points.resize(1);
        return false;
    }

    /// The columns of \p curves, under which their rows are.
    void take_columns(const std::vector<AnswerCurve>& curves) {
        const bool bands =
            std::any_of(curves.begin(), curves.end(), [](const AnswerCurve& curve) { return curve.has_band; });
        columns_ = work_.scene.columns(bands);
        if (block_.headers.empty() || block_.headers.back() != columns_) block_.headers.push_back(columns_);
    }

    /// A row of \p point of \p curve. One that the law does not reach has that point alone, and the reason.
    void add(std::size_t place, const AnswerCurve& curve, const AnswerPoint& point) {
        Row& row = block_.rows.emplace_back(Row{.scene = place,
                                                .law = point.ok() ? point.law : curve.law,
                                                .header = block_.headers.size() - 1,
                                                .begin = block_.numbers.size(),
                                                .answer = point.ok() && work_.scene.best});
        if (!point.ok()) row.error = "law " + std::string(name_of(curve.law)) + ": " + point.reason;
        block_.numbers.push_back(curve.theta.value_or(none));
        block_.numbers.push_back(curve.r.value_or(none));
        const std::string_view known = work_.scene.at_separations ? "separation" : "pressure";
        for (const scene::NumberOf& column : columns_) {
            const bool end_without_band = !curve.has_band && column.part.starts_with("_p");
            const bool is_point = column.quantity->word == known && column.part.empty();
            block_.numbers.push_back(point.ok() ? end_without_band ? none : column(point)
                                     : is_point ? work_.scene.points[point.place]
                                                : none);
        }
    }

    std::vector<scene::NumberOf> columns_{};
    const Grid& grid_;
    SceneMaker& maker_;
    SceneMaker::Work& work_;
    Block& block_;
};

/// As csv_of of a cell of run --format csv: 17 significant digits.
void append_exact(std::string& text, double value) { text += std::isnan(value) ? "null" : document::exact(value); }

void append_key(std::string& text, std::string_view key) {
    text += ",\"";
    text += key;
    text += "\":";
}

/// {"index":17,"surface.rms_height":5e-07
std::string beginning(const Grid& grid, std::uint64_t index, const std::vector<Value>& values) {
    std::string text = "{\"index\":" + std::to_string(index);
    for (std::size_t i = 0; i < grid.axes.size(); ++i) {
        const Axis& axis = grid.axes[i];
        append_key(text, axis.key);
        text +=
            axis.is_text() ? document::json_text(axis.texts[values[i].place]) : document::shortest(values[i].number);
    }
    return text;
}

}  // namespace

Block block_of(const Grid& grid, SceneMaker& maker, SceneMaker::Work& work, std::uint64_t first, std::uint64_t count) {
    Block block{.first = first, .end = first + count};
    block.values.resize(count);
    for (std::uint64_t i = 0; i < count; ++i) grid.values(first + i, block.values[i]);
    Computation(grid, maker, work, block).run();
    return block;
}

std::string lines_of(const Grid& grid, const Block& block) {
    std::string text, begin;
    const Row* last = nullptr;
    for (const Row& row : block.rows) {
        if (!last || last->scene != row.scene)
            begin = beginning(grid, block.first + row.scene, block.values[row.scene]);
        last = &row;
        text += begin;
        if (row.law != LawKind::none) {
            const double* number = block.numbers.data() + row.begin;
            append_key(text, "law");
            text += '"';
            text += name_of(row.law);
            text += '"';
            for (const char* key : {"theta", "r"}) {
                append_key(text, key);
                append_exact(text, *number++);
            }
            for (const scene::NumberOf& column : block.headers[row.header]) {
                append_key(text, column.key());
                append_exact(text, *number++);
            }
        }
        if (row.answer) text += ",\"answer\":1";
        if (!row.error.empty()) {
            append_key(text, "error");
            text += document::json_text(row.error);
        }
        text += "}\n";
    }
    return text;
}

}  // namespace fstiff::sweep
