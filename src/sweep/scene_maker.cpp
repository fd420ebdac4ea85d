// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/scene_maker.hpp"

#include "scene/readers.hpp"
#include "sweep/template.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

namespace fstiff::sweep {
namespace {

using scene::Scene;

constexpr std::size_t most_surfaces = 16;  // measured maps are large

bool has(const toml::table& root, const char* key) { return static_cast<bool>(root.at_path(key)); }

bool is_measured(const toml::table& root) {
    return has(root, "surface.from") || has(root, "surface.upper") || has(root, "surface.lower");
}

}  // namespace

SceneMaker::SceneMaker(const Grid& grid, scene::SceneSource from)
    : grid_(grid),
      from_(std::move(from)),
      measured_(from_.measured || !from_.surface.empty() || is_measured(grid.form->root)) {
    from_.name = grid.file;
    from_.in_si = &grid.in_si;

    // errors of values are reported before anything is computed: the ends of every axis are read
    std::vector<Value> values(grid.axes.size());
    const auto put = [&](std::size_t i, bool last) {
        const Axis& axis = grid.axes[i];
        values[i].place = last ? axis.count() - 1 : 0;
        values[i].number = axis.drawn             ? axis.drawn->quantile(0.5)
                           : axis.range           ? axis.range->at(values[i].place)
                           : axis.numbers.empty() ? 0
                                                  : axis.numbers[values[i].place];
    };
    for (std::size_t i = 0; i < values.size(); ++i) put(i, false);
    const Scene first = read(values);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Axis& axis = grid.axes[i];
        if (axis.drawn || axis.key.ends_with(".from")) continue;  // a file is measured when it is its turn
        put(i, true);
        if (grid.mode == Mode::product) static_cast<void>(read(values));
        put(i, false);
    }

    const auto point = std::find_if(grid.axes.begin(), grid.axes.end(), [](const Axis& axis) {
        return !axis.is_text() && (axis.key == "contact.pressures[0]" || axis.key == "contact.separations[0]");
    });
    point_axis_ = static_cast<std::size_t>(point - grid.axes.begin());
    // boundary elements take seconds a point, and another law may not be computed so
    folds_ = point != grid.axes.end() && first.points.size() == 1 &&
             std::all_of(first.laws.begin(), first.laws.end(), [](const detail::Law* law) { return law->varies; }) &&
             std::none_of(grid.axes.begin(), grid.axes.end(),
                          [](const Axis& axis) { return axis.key.starts_with("contact.laws"); });
}

bool SceneMaker::alike(const std::vector<Value>& a, const std::vector<Value>& b) const {
    for (std::size_t i = 0; i < a.size(); ++i)
        if (i != point_axis_ && (a[i].place != b[i].place || a[i].number != b[i].number)) return false;
    return true;
}

RecentSurfaces::Read RecentSurfaces::get(const Key& key, const std::function<Read()>& read) {
    std::promise<Read> promise;
    std::shared_future<Read> result = promise.get_future().share();
    bool is_new = false;
    {
        const std::lock_guard lock(mutex_);
        const auto entry = std::find_if(all_.begin(), all_.end(), [&](const auto& kept) { return kept.first == key; });
        is_new = entry == all_.end();
        if (is_new) {
            all_.emplace_front(key, result);
            if (all_.size() > most_surfaces) all_.pop_back();
        } else {
            result = entry->second;
            all_.splice(all_.begin(), all_, entry);
        }
    }
    if (is_new) try {
            promise.set_value(read());
        } catch (const std::bad_alloc&) {  // not what is wrong with the scene: the next one tries again
            promise.set_exception(std::current_exception());
            const std::lock_guard lock(mutex_);
            all_.remove_if([&](const auto& kept) { return kept.first == key; });
        } catch (...) {
            promise.set_exception(std::current_exception());
        }
    return result.get();
}

Scene SceneMaker::read_with(const std::vector<Value>& values, const Scene* surface) const {
    const toml::table root = table_of(grid_, values);
    scene::SceneSource from = from_;
    from.surface_of = surface;
    Scene scene = scene::read_table(root, from);
    scene.solves_map = false;
    if (scene.ball)
        throw domain_error(from.name + ": contact.ball_radius: is for fstiff run; a sweep has the faces alone");
    return scene;
}

Scene SceneMaker::read(const std::vector<Value>& values) {
    if (!measured_) return read_with(values, nullptr);
    RecentSurfaces::Key surface;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (grid_.axes[i].key.starts_with("surface.")) surface.emplace_back(values[i].place, values[i].number);
    const auto with_surface =
        surfaces_.get(surface, [&] { return std::make_shared<const Scene>(read_with(values, nullptr)); });
    return read_with(values, with_surface.get());
}

void SceneMaker::make(const std::vector<Value>& values, Work& work) {
    if (folds_ && !work.made_for.empty() && alike(values, work.made_for)) {
        const double point = values[point_axis_].number;
        if (!(std::isfinite(point) && (work.scene.at_separations || point > 0)))
            (void)read(values);  // which refuses it
        work.scene.points.front() = point;
    } else {
        work.made_for.clear();
        work.contacts.clear();  // before what they were made of
        work.scene = read(values);
        work.contacts = contacts_of(work.scene.joint, work.scene.laws);
    }
    work.made_for = values;
}

}  // namespace fstiff::sweep
