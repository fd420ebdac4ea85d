// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/scene_maker.hpp"

#include "request/put_number.hpp"
#include "scene/readers.hpp"
#include "sweep/template.hpp"

#include <fstiff/answer/resolve.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <string>
#include <string_view>

namespace fstiff::sweep {
namespace {

using scene::Scene;

constexpr std::size_t most_surfaces = 16;  // measured maps are large

bool has(const toml::table& root, const char* key) { return static_cast<bool>(root.at_path(key)); }

bool is_measured(const toml::table& root) {
    return has(root, "surface.from") || has(root, "surface.upper") || has(root, "surface.lower");
}

/// Puts \p value into the number of \p owner called \p name. \return whether it has one that may have this value.
template <class Owner>
bool put_number(Owner& owner, std::string_view name, double value) {
    const auto facts = request::put_number(owner, name, value);
    return facts && facts->holds(value);
}

/// The same at \p axis of a scene, where the number enters as it is and no other one of \p root follows from it.
bool put_number_at(Scene& scene, const toml::table& root, const Axis& axis, double value) {
    const std::string_view key = axis.key;
    const std::size_t dot = key.rfind('.');
    const std::string_view section = key.substr(0, dot), name = key.substr(dot + 1);
    if (axis.point) {
        scene.points[*axis.point] = value;
        return std::isfinite(value) && (scene.at_separations || value > 0);
    }
    if (section == "surface") return put_number(scene.given.face, name, value);
    if (section == "friction" && scene.given.friction) return put_number(*scene.given.friction, name, value);
    if (section == "ultrasound" && scene.given.waves) return put_number(*scene.given.waves, name, value);
    if (section == "gap" && name.ends_with("_film")) return put_number(scene.given.conduction, name, value);
    if (section == "gap" && scene.given.conduction.gap) return put_number(*scene.given.conduction.gap, name, value);
    const bool upper = section == "material.upper";
    if (!upper && section != "material.lower") return false;
    const bool leads =
        name.ends_with("velocity") || name == "density" ||  // to impedances, and HBW to a pressure
        (name == "youngs_modulus" && has(root, upper ? "material.upper.hardness" : "material.lower.hardness"));
    return !leads && put_number(upper ? scene.given.upper : scene.given.lower, name, value) &&
           (!upper || has(root, "material.lower") || put_number(scene.given.lower, name, value));
}

/// Resolves \p scene, whose numbers are others than when it was read.
void resolve_anew(Scene& scene) {
    std::vector<detail::Peaks> peaks = std::move(scene.joint.peaks);
    const bool follow = scene.joint.default_peaks || peaks.front().of_surface;
    scene.joint.face = detail::face_of(scene.given.face);
    resolve(scene);
    if (scene.best) scene.laws = {&law_of_answer(scene.joint, scene.at_separations)};
    if (!follow) {
        scene.joint.peaks = std::move(peaks);
        return;
    }
    take_peaks(scene.joint);
    for (std::size_t i = 0; i < scene.joint.peaks.size(); ++i)
        scene.joint.peaks[i].where = peaks.front().where, scene.joint.peaks[i].key = peaks.front().key;
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
    const auto put = [&](std::size_t i, std::uint64_t place) { values[i] = {grid.axes[i].number_at(place), place}; };
    for (std::size_t i = 0; i < values.size(); ++i) put(i, 0);
    const Scene first = read(values);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Axis& axis = grid.axes[i];
        if (axis.drawn || axis.key.ends_with(".from")) continue;  // a file is measured when it is its turn
        put(i, axis.count() - 1);
        if (grid.mode == Mode::product) static_cast<void>(read(values));
        put(i, 0);
    }

    const auto point = std::find_if(grid.axes.begin(), grid.axes.end(),
                                    [](const Axis& axis) { return !axis.is_text() && axis.point == std::size_t(0); });
    point_axis_ = static_cast<std::size_t>(point - grid.axes.begin());
    // boundary elements take seconds a point, and another law may not be computed so
    folds_ = point != grid.axes.end() && first.points.size() == 1 &&
             std::all_of(first.laws.begin(), first.laws.end(), [](const detail::Law* law) { return law->varies; }) &&
             std::none_of(grid.axes.begin(), grid.axes.end(),
                          [](const Axis& axis) { return axis.key.starts_with("contact.laws"); });
}

bool SceneMaker::alike(const std::vector<Value>& a, const std::vector<Value>& b) const {
    for (std::size_t i = 0; i < a.size(); ++i)
        if (i != point_axis_ && a[i] != b[i]) return false;
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
        if (grid_.axes[i].key.starts_with("surface.")) surface.push_back(values[i]);
    std::shared_ptr<const Scene> own;
    const auto first =
        surfaces_.get(surface, [&] { return own = std::make_shared<const Scene>(read_with(values, nullptr)); });
    return own ? *own : read_with(values, first.get());
}

bool SceneMaker::put(const std::vector<Value>& values, Work& work) const {
    if (work.made_for.empty()) return false;
    bool only_points = true;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Axis& axis = grid_.axes[i];
        if (values[i] == work.made_for[i]) continue;
        if (axis.is_text() || !put_number_at(work.scene, grid_.form->root, axis, values[i].number)) return false;
        only_points = only_points && i == point_axis_;
    }
    if (only_points && folds_) return true;
    const std::vector<detail::Peaks>& peaks = work.scene.joint.peaks;
    if (measured_ ||
        (peaks.size() > 1 && std::any_of(peaks.begin(), peaks.end(), [](const auto& each) { return each.of_surface; })))
        return false;
    work.contacts.clear();  // before what they were made of
    try {
        resolve_anew(work.scene);
    } catch (const domain_error&) {  // which reading reports with its place
        return false;
    }
    work.contacts = contacts_of(work.scene.joint, work.scene.laws);
    return true;
}

void SceneMaker::make(const std::vector<Value>& values, Work& work) {
    if (!put(values, work)) {
        work.made_for.clear();
        work.contacts.clear();
        work.scene = read(values);
        work.contacts = contacts_of(work.scene.joint, work.scene.laws);
    }
    work.made_for = values;
}

}  // namespace fstiff::sweep
