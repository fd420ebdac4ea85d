// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/results_file.hpp"

#include "support/catch.hpp"

#include <fstiff/core/error.hpp>

#include <cstdlib>

namespace shard_test {

using namespace fstiff::sweep;

namespace {

const char* const variables[]{"SLURM_ARRAY_TASK_ID",
                              "SLURM_ARRAY_TASK_COUNT",
                              "SLURM_ARRAY_TASK_MIN",
                              "SLURM_ARRAY_TASK_STEP",
                              "OMPI_COMM_WORLD_RANK",
                              "OMPI_COMM_WORLD_SIZE",
                              "PMI_RANK",
                              "PMI_SIZE"};

/// Sets variables of the environment; none of the others is set.
std::string automatic(std::initializer_list<std::pair<const char*, const char*>> set) {
    for (const char* name : variables) unsetenv(name);
    for (const auto& [name, value] : set) setenv(name, value, 1);
    return parse_shard("auto").text();
}

}  // namespace

TEST_CASE("The shards of a grid hold every scene once, in their order") {
    for (const std::uint64_t size : {0ULL, 1ULL, 7ULL, 1000ULL, (1ULL << 53) - 1})
        for (const std::uint64_t n : {1ULL, 2ULL, 3ULL, 8ULL, 1000ULL}) {
            std::uint64_t at = 0;
            for (std::uint64_t i = 1; i <= n; ++i) {
                const Shard shard{i, n};
                CHECK(shard.first(size) == at);
                at = shard.end(size);
                CHECK(at - shard.first(size) <= size / n + 1);
            }
            CHECK(at == size);
        }
}

TEST_CASE("A shard is i/n, or that of the job") {
    CHECK(parse_shard("3/8").text() == "3/8");
    for (const char* wrong : {"0/8", "9/8", "3", "3/", "/8", "a/b", "3/8/2", "-1/8", "1/0", "3.0/8"})
        CHECK_THROWS_AS(parse_shard(wrong), fstiff::domain_error);
    CHECK_THROWS_AS(automatic({}), fstiff::domain_error);
    CHECK(automatic({{"SLURM_ARRAY_TASK_ID", "3"}, {"SLURM_ARRAY_TASK_COUNT", "8"}, {"SLURM_ARRAY_TASK_MIN", "1"}}) ==
          "3/8");
    CHECK(automatic({{"SLURM_ARRAY_TASK_ID", "0"}, {"SLURM_ARRAY_TASK_COUNT", "8"}, {"SLURM_ARRAY_TASK_MIN", "0"}}) ==
          "1/8");
    CHECK(automatic({{"SLURM_ARRAY_TASK_ID", "5"},
                     {"SLURM_ARRAY_TASK_COUNT", "4"},
                     {"SLURM_ARRAY_TASK_MIN", "1"},
                     {"SLURM_ARRAY_TASK_STEP", "2"}}) == "3/4");
    // an array with holes, such as 1,9, has no shard of its own for 9
    CHECK_THROWS_AS(
        automatic({{"SLURM_ARRAY_TASK_ID", "9"}, {"SLURM_ARRAY_TASK_COUNT", "2"}, {"SLURM_ARRAY_TASK_MIN", "1"}}),
        fstiff::domain_error);
    CHECK(automatic({{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "4"}}) == "1/4");
    CHECK(automatic({{"PMI_RANK", "3"}, {"PMI_SIZE", "4"}}) == "4/4");
    CHECK(automatic(
              {{"PMI_RANK", "3"}, {"PMI_SIZE", "4"}, {"SLURM_ARRAY_TASK_ID", "2"}, {"SLURM_ARRAY_TASK_COUNT", "2"}}) ==
          "2/2");
    CHECK_THROWS_AS(automatic({{"PMI_RANK", "x"}, {"PMI_SIZE", "4"}}), fstiff::domain_error);
    for (const char* name : variables) unsetenv(name);
}

}  // namespace shard_test
