// SPDX-License-Identifier: BSD-3-Clause
#include "input/computed.hpp"

#include "input/progress.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

namespace fstiff::cli {

scene::Results computed(const scene::Scene& scene) {
    const ProgressHook progress = progress_bar();
    return scene::compute(scene, progress, [&](std::size_t count, const Piece& run) {
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            for (std::size_t i; (i = next++) < count;) run(i);
        };
        std::vector<std::future<void>> helpers;  // each ends before it is destroyed
        try {
            for (std::size_t i = 1; i < std::min<std::size_t>(std::thread::hardware_concurrency(), count); ++i)
                helpers.push_back(std::async(std::launch::async, work));
        } catch (const std::system_error&) {  // a limit on threads
        }
        for (std::size_t i; (i = next++) < count; run(i))
            if (progress) progress("pieces", i, count);
    });
}

}  // namespace fstiff::cli
