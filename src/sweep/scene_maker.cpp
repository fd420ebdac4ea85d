// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/scene_maker.hpp"

#include "scene/readers.hpp"
#include "sweep/template.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <new>
#include <string_view>

namespace fstiff::sweep {
namespace {

using scene::Scene;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_scenes_read = 16;  // of the cache: measured maps are large

template <Parameter parameter>
void put_parameter(Scene& scene, std::size_t, double value) {
    scene.joint.face.parameters.find(parameter)->value = value;
}
void put_point(Scene& scene, std::size_t place, double value) { scene.points[place] = value; }
void put_upper_modulus(Scene& scene, std::size_t is_of_both, double value) {
    scene.joint.upper.youngs_modulus = value;
    if (is_of_both) scene.joint.lower.youngs_modulus = value;
    scene.take_bodies();
}
void put_lower_modulus(Scene& scene, std::size_t, double value) {
    scene.joint.lower.youngs_modulus = value;
    scene.take_bodies();
}
void put_frequency(Scene& scene, std::size_t, double value) { scene.joint.ultrasound->frequency = value; }

constexpr SceneMaker::Number numbers[]{
    {"contact.pressures[", "Pa", put_point, 0, infinity},
    {"contact.separations[", "m", put_point, -infinity, infinity},
    {"material.upper.youngs_modulus", "Pa", put_upper_modulus, 0, infinity},
    {"material.lower.youngs_modulus", "Pa", put_lower_modulus, 0, infinity},
    {"ultrasound.frequency", "Hz", put_frequency, 1e-300, 1e300},
    {"surface.rms_height", "m", put_parameter<Parameter::rms_height>, 0, infinity},
    {"surface.peak_radius", "m", put_parameter<Parameter::peak_radius>, 0, infinity},
    {"surface.peak_density", "1/m^2", put_parameter<Parameter::peak_density>, 0, infinity},
    {"surface.fractal_dimension", "", put_parameter<Parameter::fractal_dimension>, 1, detail::greatest_dimension},
};

bool has(const toml::table& root, const char* key) { return static_cast<bool>(root.at_path(key)); }

bool is_measured(const toml::table& root) {
    return has(root, "surface.from") || has(root, "surface.upper") || has(root, "surface.lower");
}

}  // namespace

SceneMaker::Setter SceneMaker::setter_of(const Axis& axis) const {
    const toml::table& root = grid_.form->root;
    const auto number = std::find_if(std::begin(numbers), std::end(numbers), [&](const Number& row) {
        return (row.key.ends_with('[') ? axis.key.starts_with(row.key) : axis.key == row.key) &&
               (axis.unit == row.unit || (axis.unit.empty() && grid_.in_si.contains(axis.key)));
    });
    if (axis.is_text() || number == std::end(numbers)) return {};
    // of a face that is measured, or of which a gradient makes the peaks, other numbers follow while it is read
    if (number->key.starts_with("surface.") &&
        (measured_ || has(root, "surface.rms_gradient") || has(root, "surface.alpha")))
        return {};
    const std::size_t place = number->put == put_point           ? std::stoul(axis.key.substr(number->key.size()))
                              : number->put == put_upper_modulus ? !has(root, "material.lower")
                                                                 : 0;
    return {number, place};
}

SceneMaker::SceneMaker(const Grid& grid, scene::SceneSource from)
    : grid_(grid),
      from_(std::move(from)),
      measured_(from_.measured || !from_.surface.empty() || is_measured(grid.form->root)) {
    from_.name = grid.file;
    from_.in_si = &grid.in_si;
    for (const Axis& axis : grid.axes) setters_.push_back(setter_of(axis));

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
    const auto first = cached(values);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Axis& axis = grid.axes[i];
        if (axis.drawn || axis.key.ends_with(".from")) continue;  // a file is measured when it is its turn
        put(i, true);
        if (grid.mode == Mode::product) static_cast<void>(read(values));
        put(i, false);
    }

    const auto point = std::find_if(setters_.begin(), setters_.end(), [](const Setter& setter) {
        return setter.number && setter.number->put == put_point;
    });
    point_axis_ = static_cast<std::size_t>(point - setters_.begin());
    // boundary elements take seconds a point, and another law may not be computed so
    folds_ = point != setters_.end() && first->points.size() == 1 &&
             std::all_of(first->laws.begin(), first->laws.end(), [](const detail::Law* law) { return law->varies; }) &&
             std::none_of(grid.axes.begin(), grid.axes.end(),
                          [](const Axis& axis) { return axis.key.starts_with("contact.laws"); });
}

bool SceneMaker::alike(const std::vector<Value>& a, const std::vector<Value>& b) const {
    for (std::size_t i = 0; i < a.size(); ++i)
        if (i != point_axis_ && (a[i].place != b[i].place || a[i].number != b[i].number)) return false;
    return true;
}

RecentScenes::Read RecentScenes::get(const Key& key, const std::function<Read()>& read) {
    std::promise<Read> promise;
    std::shared_future<Read> result = promise.get_future().share();
    bool is_new = false;
    {
        const std::lock_guard lock(mutex_);
        const auto entry = std::find_if(all_.begin(), all_.end(), [&](const auto& kept) { return kept.first == key; });
        is_new = entry == all_.end();
        if (is_new) {
            all_.emplace_front(key, result);
            if (all_.size() > most_scenes_read) all_.pop_back();
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

std::shared_ptr<const Scene> SceneMaker::read_with(const std::vector<Value>& values, const Scene* surface) const {
    const toml::table root = table_of(grid_, values);
    scene::SceneSource from = from_;
    from.surface_of = surface;
    auto scene = std::make_shared<Scene>(scene::read_table(root, from));
    scene->solves_map = false;
    if (scene->ball)
        throw domain_error(from.name + ": contact.ball_radius: is for fstiff run; a sweep has the faces alone");
    scene->inputs.clear();
    scene->warnings.clear();
    return scene;
}

std::shared_ptr<const Scene> SceneMaker::read(const std::vector<Value>& values) {
    if (!measured_) return read_with(values, nullptr);
    RecentScenes::Key surface;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (grid_.axes[i].key.starts_with("surface.")) surface.emplace_back(values[i].place, values[i].number);
    std::shared_ptr<const Scene> scene;
    const auto first = surfaces_.get(surface, [&] { return scene = read_with(values, nullptr); });
    return scene ? scene : read_with(values, first.get());
}

std::shared_ptr<const Scene> SceneMaker::cached(const std::vector<Value>& values) {
    RecentScenes::Key key;
    bool once = false;  // of a draw, which no other scene has
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!setters_[i].number) {
            key.emplace_back(values[i].place, values[i].number);
            once = once || grid_.axes[i].drawn;
        }
    return once ? read(values) : scenes_.get(key, [&] { return read(values); });
}

void SceneMaker::make(const std::vector<Value>& values, Work& work) {
    const bool same = folds_ && !work.made_for.empty() && alike(values, work.made_for);
    work.made_for.clear();
    put(values, work);
    if (!same) {
        work.contacts.clear();  // before what they were made of
        if (work.scene.best)
            work.scene.laws = {&law_of_answer(work.scene.joint, work.scene.at_separations)};  // peaks may flow now
        work.contacts = contacts_of(work.scene.joint, work.scene.laws);
    }
    work.made_for = values;
}

void SceneMaker::put(const std::vector<Value>& values, Work& work) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Number* number = setters_[i].number;
        if (number && !(values[i].number > number->least && values[i].number < number->most)) {
            work.read = nullptr;
            work.scene = *read(values);  // which refuses it in words
            return;
        }
    }
    if (auto read = cached(values); read != work.read) {
        work.scene = *read;
        work.read = std::move(read);
    }
    for (std::size_t i = 0; i < values.size(); ++i)
        if (const auto [number, place] = setters_[i]; number) number->put(work.scene, place, values[i].number);
}

}  // namespace fstiff::sweep
