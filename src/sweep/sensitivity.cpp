// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/sensitivity.hpp"

#include "sweep/rows.hpp"

#include <fstiff/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace fstiff::sweep {
namespace {

constexpr std::size_t most_draws = 1000000;

/// The places of \p values from the least to the greatest.
std::vector<std::size_t> order_of(std::span<const double> values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    return order;
}

/// K of one curve and point at one point of the grid, and the scenes they are of.
struct Draws {
    std::vector<double> stiffness;
    std::vector<std::uint64_t> scenes;
    std::optional<double> pressure{};
};

using Key = std::tuple<std::string, std::optional<double>, std::optional<double>, std::size_t>;

class Collector {
public:
    explicit Collector(const Grid& grid) : grid_(grid) {
        for (std::size_t i = 0; i < grid.axes.size(); ++i)
            if (grid.axes[i].drawn) drawn_.push_back(i);
    }
    void take(const Row& row) {
        const std::uint64_t place = row.index / grid_.samples;
        if (place != place_) finish();
        place_ = place;
        if (!row.stiffness) return;
        const Key key{std::string(row.law), row.theta, row.r, row.point};
        auto [at, is_new] = draws_.try_emplace(key);
        if (at->second.stiffness.empty())
            at->second.pressure = row.pressure;
        else if (at->second.pressure != row.pressure)
            at->second.pressure.reset();
        if (at->second.stiffness.size() == most_draws) return;
        at->second.stiffness.push_back(*row.stiffness);
        at->second.scenes.push_back(row.index);
        if (is_new) order_.push_back(key);
    }
    /// The means over the points of the grid.
    std::vector<SensitivityRow> rows() {
        finish();
        std::vector<SensitivityRow> all;
        for (const Key& key : order_) {
            SensitivityRow row = found_[key];
            if (row.places == 0) continue;
            for (Sensitivity& sensitivity : row.of_inputs) {
                sensitivity.first_order /= static_cast<double>(row.places);
                sensitivity.rank_correlation /= static_cast<double>(row.places);
            }
            all.push_back(std::move(row));
        }
        return all;
    }

private:
    /// Adds what was drawn at one point of the grid.
    void finish() {
        for (auto& [key, draws] : draws_) {
            if (draws.stiffness.size() < 3) continue;
            std::vector<std::vector<double>> inputs(drawn_.size());
            std::vector<Value> values;
            for (const std::uint64_t scene : draws.scenes) {
                grid_.values(scene, values);
                for (std::size_t i = 0; i < drawn_.size(); ++i) inputs[i].push_back(values[drawn_[i]].number);
            }
            SensitivityRow& row = found_[key];
            if (row.of_inputs.empty()) {
                row.of_inputs.resize(drawn_.size());
                std::tie(row.law, row.theta, row.r, row.point) = key;
                row.pressure = draws.pressure;
                row.draws = draws.stiffness.size();
            }
            if (row.pressure != draws.pressure) row.pressure.reset();
            row.draws = std::min(row.draws, draws.stiffness.size());
            bool varies = true;
            for (std::size_t i = 0; i < drawn_.size(); ++i)
                if (const auto one = sensitivity(inputs[i], draws.stiffness)) {
                    row.of_inputs[i].first_order += one->first_order;
                    row.of_inputs[i].rank_correlation += one->rank_correlation;
                } else {
                    varies = false;
                }
            row.places += varies ? 1 : 0;
        }
        for (auto& [key, draws] : draws_) draws = {};
    }

    const Grid& grid_;
    std::vector<std::size_t> drawn_;
    std::uint64_t place_ = 0;
    std::map<Key, Draws> draws_;
    std::vector<Key> order_;  ///< of their first rows
    std::map<Key, SensitivityRow> found_;
};

}  // namespace

std::optional<Sensitivity> sensitivity(std::span<const double> input, std::span<const double> output) {
    require(input.size() == output.size() && input.size() >= 3, "draws of an input", input.size(),
            "as many as outputs, 3 at least");
    const auto n = static_cast<double>(output.size());
    const double mean = std::accumulate(output.begin(), output.end(), 0.0) / n;
    double variance = 0;
    for (const double y : output) variance += (y - mean) * (y - mean) / n;
    if (!(variance > 0)) return std::nullopt;
    const std::vector<std::size_t> by_input = order_of(input), by_output = order_of(output);
    Sensitivity found;
    for (std::size_t j = 0; j < by_input.size(); ++j) {
        const double here = output[by_input[j]] - mean, next = output[by_input[(j + 1) % by_input.size()]] - mean;
        found.first_order += here * next / n;
    }
    found.first_order /= variance;
    std::vector<double> rank(output.size());
    for (std::size_t j = 0; j < by_output.size(); ++j) rank[by_output[j]] = static_cast<double>(j);
    const double middle = (n - 1) / 2;
    double product = 0;
    for (std::size_t j = 0; j < by_input.size(); ++j)
        product += (static_cast<double>(j) - middle) * (rank[by_input[j]] - middle);
    found.rank_correlation = product / (n * (n * n - 1) / 12);
    return found;
}

std::vector<SensitivityRow> sensitivities(const Grid& grid, const std::string& file) {
    Collector collector(grid);
    for_each_row(file, [&](const Row& row) {
        collector.take(row);
        return true;
    });
    std::vector<SensitivityRow> rows = collector.rows();
    if (rows.empty())
        throw domain_error(file +
                           ": no K in it varies over 3 draws or more at one point of the grid; K does not depend on "
                           "the distributed inputs");
    return rows;
}

}  // namespace fstiff::sweep
