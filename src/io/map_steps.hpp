// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The steps of a map that has no positions: by the options, else as its header states them, or its size.
///
/// Units       m

#include "io/given_lengths.hpp"
#include "io/header.hpp"

namespace fstiff::inline v0_1::io::detail {

struct MapSteps {
    const SurfaceOptions& options;
    const StatedGrid& stated;
    const std::string& name;             // of the file
    std::string units;                   // that are to be given, for messages
    std::string subject;                 // of a refusal, after the name: "is a matrix that"
    std::string& from;                   // where the steps come from, for the record
    std::vector<std::string>& warnings;  // of options that contradict the header

    /// The step along x of \p columns points. \throws domain_error without one.
    double x(std::size_t columns);
    /// The same along y.
    double y(std::size_t rows);

private:
    double step_of(const LengthOption& step, const LengthOption& whole,
                   const std::optional<StatedGrid::Length>& stated_step,
                   const std::optional<StatedGrid::Length>& stated_whole, std::size_t count);
    void warn_of_step(const GivenStep& given, const std::optional<StatedGrid::Length>& length, double points);
};

}  // namespace fstiff::inline v0_1::io::detail
