// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/shard.hpp"

#include "document/file.hpp"

#include <fstiff/core/error.hpp>

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace fstiff::sweep {
namespace {

std::optional<std::uint64_t> number_in(std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
    return number;
}

/// A variable of the environment; none where it is not set. \throws domain_error where it is not a whole number.
std::optional<std::uint64_t> variable(const char* name) {
    const char* text = std::getenv(name);
    if (!text) return std::nullopt;
    const auto number = number_in(text);
    if (!number)
        throw document::option_error(std::string(name) + " = \"" + text +
                                     "\": must be a whole number for --shard auto");
    return number;
}

Shard checked(std::uint64_t number, std::uint64_t count, const std::string& from) {
    constexpr std::uint64_t most = 1000000000;
    if (count < 1 || count > most || number < 1 || number > count)
        throw document::option_error("shard " + std::to_string(number) + "/" + std::to_string(count) + " of " + from +
                                     ": must be i/n with 1 <= i <= n");
    return {number, count};
}

Shard of_environment() {
    if (const auto task = variable("SLURM_ARRAY_TASK_ID")) {
        const auto count = variable("SLURM_ARRAY_TASK_COUNT"), least = variable("SLURM_ARRAY_TASK_MIN");
        if (!count)
            throw document::option_error(
                "SLURM_ARRAY_TASK_COUNT is not set; --shard auto needs it with SLURM_ARRAY_TASK_ID");
        const std::uint64_t step = variable("SLURM_ARRAY_TASK_STEP").value_or(1), begin = least.value_or(1);
        const std::string name = "SLURM_ARRAY_TASK_ID " + std::to_string(*task);
        if (*task < begin || step == 0 || (*task - begin) % step != 0) return checked(0, *count, name);
        return checked((*task - begin) / step + 1, *count, name);
    }
    const char* const pairs[][2]{{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"}, {"PMI_RANK", "PMI_SIZE"}};
    for (const auto& [rank, size] : pairs)
        if (const auto number = variable(rank)) {
            const auto of = variable(size);
            if (!of)
                throw document::option_error(std::string(size) + " is not set; --shard auto needs it with " + rank);
            return checked(*number + 1, *of, rank);
        }
    throw document::option_error(
        "--shard auto: neither SLURM_ARRAY_TASK_ID nor OMPI_COMM_WORLD_RANK nor PMI_RANK is set; must run in a Slurm "
        "job array or under mpirun, or be given as i/n");
}

}  // namespace

std::uint64_t Shard::first(std::uint64_t size) const {
    // floor(size (number - 1)/of) without a product beyond 64 bits
    return size / of * (number - 1) + size % of * (number - 1) / of;
}

std::uint64_t Shard::end(std::uint64_t size) const { return Shard{number + 1, of}.first(size); }

std::string Shard::text() const { return std::to_string(number) + "/" + std::to_string(of); }

Shard parse_shard(const std::string& text) {
    if (text == "auto") return of_environment();
    const std::size_t slash = text.find('/');
    const auto number = number_in(std::string_view(text).substr(0, slash));
    const auto of = slash == std::string::npos ? std::nullopt : number_in(std::string_view(text).substr(slash + 1));
    if (!number || !of) throw document::option_error("--shard \"" + text + "\": must be i/n such as 3/8, or auto");
    return checked(*number, *of, "--shard");
}

}  // namespace fstiff::sweep
