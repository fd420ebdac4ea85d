// SPDX-License-Identifier: BSD-3-Clause
// Values that are computed once for all callers.
#include <fstiff/core/shared_values.hpp>

#include "support/catch.hpp"

#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace shared_values_test {

using namespace fstiff;

TEST_CASE("A shared value is computed once, and again only where more are asked for than are kept") {
    detail::SharedValues<int, int, 3> values;
    int made = 0;
    const auto square = [&](int i) {
        return values.at(i, [&] {
            ++made;
            return std::make_shared<const int>(i * i);
        });
    };
    const auto two = square(2);
    CHECK(*two == 4);
    CHECK(square(2) == two);
    CHECK(made == 1);
    for (int i = 10; i < 13; ++i) CHECK(*square(i) == i * i);
    CHECK(*two == 4);  // whoever has it keeps it
    CHECK(*square(2) == 4);
    CHECK(made == 5);
    CHECK_THROWS_AS(values.at(7, []() -> std::shared_ptr<const int> { throw std::runtime_error("no value"); }),
                    std::runtime_error);
    CHECK(*square(7) == 49);
}

TEST_CASE("Threads that ask for one shared value at once get the same") {
    detail::SharedValues<int, int> values;
    std::vector<std::shared_ptr<const int>> found(8);
    std::vector<std::thread> threads;
    for (auto& each : found)
        threads.emplace_back([&] { each = values.at(1, [] { return std::make_shared<const int>(5); }); });
    for (std::thread& thread : threads) thread.join();
    for (const auto& each : found) CHECK(each == found.front());
}

}  // namespace shared_values_test
