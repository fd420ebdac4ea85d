// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Scenes of a grid. A scene that differs from the one before in numbers of its joint alone is resolved anew, any other
// is read of the TOML with its values. Scenes that differ in their point alone share the contacts, and what was
// measured of a file is kept for the scenes that have it.
//
// Reference   table_of and read_table of each scene alone give the same lines, byte for byte
//             (tests/sweep/lines_test.cpp)

#include "actions/answered.hpp"
#include "sweep/grid.hpp"

#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff::sweep {

/// The measured surfaces that were read last, for all threads: each in a scene that has it.
class RecentSurfaces {
public:
    using Key = std::vector<Value>;  ///< each value that distinguishes them
    using Read = std::shared_ptr<const scene::Scene>;

    /// The scene of \p key; where it is not there, what \p read gives. A thread waits while another one reads the
    /// same. \throws what \p read throws.
    [[nodiscard]] Read get(const Key& key, const std::function<Read()>& read);

private:
    std::mutex mutex_;
    std::list<std::pair<Key, std::shared_future<Read>>> all_;  ///< the last one used is first
};

/// Shared by all threads. The grid must live as long.
class SceneMaker {
public:
    /// \throws domain_error where the scene cannot be read with the first or the last values of an axis.
    /// \p from may have a surface, in place of that of the scene.
    explicit SceneMaker(const Grid& grid, scene::SceneSource from = {});

    /// A scene that one thread changes from one to the next, and its contacts.
    struct Work {
        scene::Scene scene;
        std::vector<detail::MadeContact> contacts;
        std::vector<Value> made_for{};  ///< whose contacts these are; empty: nobody's
    };
    /// The scene with \p values in work.scene, and its contacts, which stay where only the point is another.
    /// \throws domain_error, file_error as read_scene and contacts_of.
    void make(const std::vector<Value>& values, Work& work);

    /// The axis of the only point of a scene, so that scenes that differ in it alone are one scene with many points;
    /// none where there are more points, or a law is not computed point by point.
    [[nodiscard]] const std::size_t* point_axis() const { return folds_ ? &point_axis_ : nullptr; }
    /// Whether two scenes with these values differ in nothing but their point.
    [[nodiscard]] bool alike(const std::vector<Value>& a, const std::vector<Value>& b) const;

private:
    /// Puts \p values into the scene of \p work, which has others. \return whether all that differ are numbers of a
    /// joint that are allowed.
    [[nodiscard]] bool put(const std::vector<Value>& values, Work& work) const;
    [[nodiscard]] scene::Scene read(const std::vector<Value>& values);
    [[nodiscard]] scene::Scene read_with(const std::vector<Value>& values, const scene::Scene* surface) const;

    const Grid& grid_;
    scene::SceneSource from_;
    std::size_t point_axis_ = 0;
    bool folds_ = false;
    bool measured_ = false;  ///< the scenes have files of surfaces
    RecentSurfaces surfaces_;
};

}  // namespace fstiff::sweep
