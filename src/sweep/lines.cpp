// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/lines.hpp"

#include "document/file.hpp"
#include "document/json.hpp"
#include "scene/results.hpp"

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace fstiff::sweep {
namespace {

using scene::Curve;

/// As csv_of of a cell of run --format csv: 17 significant digits.
void append_exact(std::string& text, double value) {
    if (!std::isfinite(value)) throw std::logic_error("a result is not a finite number; this is a defect of fstiff");
#if FSTIFF_HAS_FLOAT_TO_CHARS
    char digits[40];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 17);
    text.append(digits, end);
#else
    text += scene::exact(value);
#endif
}

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
        text += axis.is_text() ? scene::json_text(axis.texts[values[i].place]) : scene::shortest(values[i].number);
    }
    return text;
}

void append_optional(std::string& text, const std::optional<double>& value) {
    if (value)
        append_exact(text, *value);
    else
        text += "null";
}

/// {"index":17,"surface.rms_height":5e-07,"law":"hertz","theta":1,"r":0.5
void append_law(std::string& text, const std::string& begin, const Curve& curve, std::string_view law) {
    text += begin;
    append_key(text, "law");
    text += '"';
    text += law;
    text += '"';
    append_key(text, "theta");
    append_optional(text, curve.theta);
    append_key(text, "r");
    append_optional(text, curve.r);
}

/// The line of a point that the law of \p curve does not reach: that point, null for all else, and why.
void append_missed(std::string& text, const std::string& begin, const Curve& curve, const scene::Scene& scene,
                   const scene::MissedPoint& missed) {
    append_law(text, begin, curve, curve.law->name);
    const auto known = scene.at_separations ? scene::CurveQuantity::separation : scene::CurveQuantity::pressure;
    for (const scene::Column& column : curve.columns) {
        append_key(text, column.key());
        append_optional(text, column.quantity == known ? std::optional(scene.points[missed.place]) : std::nullopt);
    }
    append_key(text, "error");
    text += scene::json_text("law " + std::string(curve.law->name) + ": " + reason_of(scene, missed)) + "}\n";
}

/// The line of the state \p i of \p curve after \p begin.
void append_row(std::string& text, const std::string& begin, const Curve& curve, std::size_t i) {
    append_law(text, begin, curve, curve.law_at(i).name);
    for (const scene::Column& column : curve.columns) {
        append_key(text, column.key());
        if (column.values.empty())
            text += "null";
        else
            append_optional(text, std::isnan(column.values[i]) ? std::nullopt : std::optional(column.values[i]));
    }
    if (!curve.by.empty()) text += ",\"answer\":1";
    text += "}\n";
}

/// Scenes of one block, in the order in which they are computed.
struct Scenes {
    std::uint64_t first = 0;
    std::vector<std::vector<Value>> values;
    std::vector<std::size_t> order;
};

/// Puts scenes that differ in their point alone side by side.
void sort_by_surface(const Grid& grid, std::size_t point_axis, Scenes& scenes) {
    for (const Axis& axis : grid.axes)
        if (axis.drawn && &axis != &grid.axes[point_axis]) return;  // no two scenes are alike
    std::stable_sort(scenes.order.begin(), scenes.order.end(), [&](std::size_t a, std::size_t b) {
        for (std::size_t i = 0; i < grid.axes.size(); ++i)
            if (i != point_axis && scenes.values[a][i].place != scenes.values[b][i].place)
                return scenes.values[a][i].place < scenes.values[b][i].place;
        return false;
    });
}

/// One scene that cannot be computed together with others.
std::string lines_of_one(const Grid& grid, SceneMaker& maker, SceneMaker::Work& work, std::uint64_t index,
                         const std::vector<Value>& values, std::uint64_t& failed) {
    const std::string begin = beginning(grid, index, values);
    std::string text;
    const auto refuse = [&](const std::exception& error) {
        ++failed;
        text = begin;
        append_key(text, "error");
        text += scene::json_text(error.what()) + "}\n";
    };
    try {
        maker.make(values, work);
        bool misses = false;
        for (const Curve& curve : scene::curves_of(work.scene, work.contacts)) {
            auto missed = curve.missed.begin();
            for (std::size_t place = 0; place < work.scene.points.size(); ++place)
                if (missed != curve.missed.end() && missed->place == place)
                    append_missed(text, begin, curve, work.scene, *missed++);
                else
                    append_row(text, begin, curve, place - static_cast<std::size_t>(missed - curve.missed.begin()));
            misses = misses || !curve.missed.empty();
        }
        failed += misses ? 1 : 0;
    } catch (const domain_error& error) {
        refuse(error);
    } catch (const file_error& error) {
        refuse(error);
    }
    return text;
}

/// Computes scenes that differ in their point alone as one scene with many points.
struct Together {
    const Grid& grid;
    SceneMaker& maker;
    SceneMaker::Work& work;
    const Scenes& scenes;
    std::vector<std::string> texts;  ///< of the scenes, in the order of the grid
    std::uint64_t& failed;

    /// Lines of the scenes from \p at up to \p end of scenes.order. Where a point cannot be computed, its scene alone
    /// has no result.
    void compute(std::size_t at, std::size_t end) {
        if (end - at == 1) {
            const std::size_t place = scenes.order[at];
            texts[place] = lines_of_one(grid, maker, work, scenes.first + place, scenes.values[place], failed);
        } else if (!as_one(at, end)) {
            const std::size_t middle = at + (end - at) / 2;
            compute(at, middle);
            compute(middle, end);
        }
    }

private:
    bool as_one(std::size_t at, std::size_t end) {
        const std::size_t point = *maker.point_axis();
        try {
            maker.make(scenes.values[scenes.order[at]], work);
            std::vector<double>& points = work.scene.points;
            points.clear();
            for (std::size_t i = at; i < end; ++i) points.push_back(scenes.values[scenes.order[i]][point].number);
            const bool allowed = std::all_of(points.begin(), points.end(), [&](double x) {
                return std::isfinite(x) && (work.scene.at_separations || x > 0);
            });
            const std::vector<Curve> curves =
                allowed ? scene::curves_of(work.scene, work.contacts) : std::vector<Curve>();
            points.resize(1);  // that of the next scene is put in its place
            if (!allowed) return false;
            for (const Curve& curve : curves)
                if (curve.states.size() != end - at) return false;
            for (std::size_t i = at; i < end; ++i) {
                const std::size_t place = scenes.order[i];
                const std::string begin = beginning(grid, scenes.first + place, scenes.values[place]);
                for (const Curve& curve : curves) append_row(texts[place], begin, curve, i - at);
            }
            return true;
        } catch (const domain_error&) {
        } catch (const file_error&) {
        }
        work.scene.points.resize(1);
        return false;
    }
};

}  // namespace

Block lines_of(const Grid& grid, SceneMaker& maker, SceneMaker::Work& work, std::uint64_t first, std::uint64_t count) {
    Scenes scenes{first, std::vector<std::vector<Value>>(count), std::vector<std::size_t>(count)};
    std::iota(scenes.order.begin(), scenes.order.end(), std::size_t(0));
    for (std::uint64_t i = 0; i < count; ++i) grid.values(first + i, scenes.values[i]);
    const std::size_t* point_axis = maker.point_axis();
    if (point_axis) sort_by_surface(grid, *point_axis, scenes);
    Block block;
    Together together{grid, maker, work, scenes, std::vector<std::string>(count), block.failed};
    for (std::size_t at = 0, end = 0; at < count; at = end) {
        end = at + 1;
        const auto& values = scenes.values[scenes.order[at]];
        while (point_axis && end < count && maker.alike(values, scenes.values[scenes.order[end]])) ++end;
        together.compute(at, end);
    }
    std::size_t size = 0;
    for (const std::string& text : together.texts) size += text.size();
    block.text.reserve(size);
    for (const std::string& text : together.texts) block.text += text;
    return block;
}

}  // namespace fstiff::sweep
