// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// States of a law between those in a table, where an answer has thousands of pressures.
///
///     ln K, ln A, ln n and d over ln p at equal steps: the polynomial of degree 5 through the six around
///
/// Reference   Lagrange's interpolation; that of degree 3 through four of the six shows how smooth the law is
/// Units       SI
/// Valid       where both polynomials agree within 1e-6; elsewhere, as next to a kink, there is no state
/// Accuracy    1e-7 of K, A and n, and of the fall of d over a step (tests/scene/many_points_test.cpp)

#include <fstiff/contact/contact_state.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Weights of the polynomial through values at the places \p first to \p last, at the place \p t.
template <int first, int last>
[[nodiscard]] std::array<double, std::size_t{last - first + 1}> lagrange_weights(double t) {
    std::array<double, std::size_t{last - first + 1}> weights{};
    for (int k = first; k <= last; ++k) {
        double& weight = weights[static_cast<std::size_t>(k - first)] = 1;
        for (int j = first; j <= last; ++j)
            if (j != k) weight *= (t - j) / (k - j);
    }
    return weights;
}

class StateTable {
public:
    static constexpr double step = 1.0 / 16;  ///< of ln p, at most
    static constexpr double accuracy = 1e-7;

    /// The pressures of a table from \p low to \p high, at steps of \p most at most.
    [[nodiscard]] static std::vector<double> pressures(double low, double high, double most = step) {
        const double range = std::log(high / low), steps = (std::max)(7.0, std::ceil(range / most));
        std::vector<double> all;
        for (double i = 0; i <= steps; ++i) all.push_back(low * std::exp(range * i / steps));
        return all;
    }
    /// \p nodes are the points at \p pressures, which pressures() made.
    StateTable(const std::vector<double>& pressures, std::vector<ContactPoint<double>> nodes)
        : first_(std::log(pressures.front())),
          step_((std::log(pressures.back()) - first_) / static_cast<double>(pressures.size() - 1)),
          nodes_(std::move(nodes)) {}

    /// The state at \p pressure [Pa], within those of the table; none where the law is not smooth, or has none.
    [[nodiscard]] std::optional<ContactState<double>> at(double pressure) const {
        const double place = step_ > 0 ? (std::log(pressure) - first_) / step_ : 0;
        const auto i = static_cast<std::size_t>(std::clamp(place, 2.0, static_cast<double>(nodes_.size()) - 4));
        const Between between{std::span(nodes_).subspan(i - 2).first<6>(), place - static_cast<double>(i)};
        if (!between.has_nodes()) return std::nullopt;
        ContactState<double> state;
        bool smooth = true;
        state.pressure = {pressure, 0};
        state.eta = between.value([](const State& node) { return node.eta; }, 1, smooth);
        for (const Member member : {&State::separation, &State::stiffness, &State::real_area_fraction,
                                    &State::contact_density, &State::loading_stiffness})
            state.*member = between.estimate(member, smooth);
        return smooth ? std::optional(state) : std::nullopt;
    }

private:
    using State = ContactState<double>;
    using Member = Estimate<double> State::*;

    /// The six nodes around a pressure, and its place between the third and the fourth.
    struct Between {
        std::span<const ContactPoint<double>, 6> nodes;
        double t;
        std::array<double, 6> six = lagrange_weights<-2, 3>(t);
        std::array<double, 4> four = lagrange_weights<-1, 2>(t);

        [[nodiscard]] bool has_nodes() const {
            return std::all_of(nodes.begin(), nodes.end(), [](const auto& node) { return node.ok(); });
        }
        /// \p value_of a node, here; \p smooth becomes false where it is not, on a scale of \p scale.
        template <class ValueOf>
        double value(const ValueOf& value_of, double scale, bool& smooth) const {
            double by_six = 0, by_four = 0;
            for (std::size_t k = 0; k < 6; ++k) {
                const double node = value_of(nodes[k].state);
                by_six += six[k] * node;
                if (k > 0 && k < 5) by_four += four[k - 1] * node;
            }
            smooth = smooth && std::abs(by_six - by_four) <= 1e-6 * scale;
            return by_six;
        }
        [[nodiscard]] Estimate<double> estimate(Member member, bool& smooth) const {
            const auto value_of = [member](const State& node) { return (node.*member).value; };
            const auto all = [&](const auto& holds) {
                return std::all_of(nodes.begin(), nodes.end(),
                                   [&](const auto& node) { return holds(value_of(node.state)); });
            };
            if (all([](double x) { return x == 0; })) return {};  // the law does not give it
            double error = 0;
            for (const auto& node : nodes) error = (std::max)(error, (node.state.*member).error);
            if (member != &State::separation && all([](double x) { return x > 0; })) {
                const double x =
                    std::exp(value([&](const State& node) { return std::log(value_of(node)); }, 1, smooth));
                return {x, error + accuracy * x};
            }
            const double fall = std::abs(value_of(nodes[2].state) - value_of(nodes[3].state));
            return {value(value_of, fall, smooth), error + accuracy * fall};
        }
    };

    double first_, step_;
    std::vector<ContactPoint<double>> nodes_;
};

}}}  // namespace fstiff::detail
