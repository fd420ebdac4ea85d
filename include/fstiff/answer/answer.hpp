// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The answer: one stiffness for each pressure, by the law that holds there, with a band and its causes.
///
///     const fstiff::Answer found = fstiff::answer(joint, pressures);
///     for (const fstiff::AnswerPoint& at : found.points)
///         if (at.ok()) use(at.pressure, at.stiffness.value, at.stiffness.low, at.stiffness.high, name_of(at.law));
///
/// What `fstiff run` computes of a scene that names no law. The functions are inline where fstiff/answer.hpp is
/// included; fstiff::double has them compiled.
///
/// Reference   answer/causes.hpp, answer/law_error.hpp
/// Units       SI
/// Valid       joints as answer/joint.hpp has them
/// Accuracy    K and both ends of `fstiff run`, to the last digit (tests/scene/joint_test.cpp); of the band:
///             docs/accuracy.md

#include <fstiff/answer/any_contact.hpp>
#include <fstiff/answer/causes.hpp>
#include <fstiff/answer/joint.hpp>
#include <fstiff/core/progress.hpp>
#include <fstiff/topography/line_transform.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fstiff::inline v0_1 {

/// How an answer is computed.
struct AnswerOptions {
    int samples = 400;          ///< surfaces drawn for the band; 0: K alone, without a band of the surface
    std::uint64_t seed = 2014;  ///< of them
    bool solve_map = true;      ///< boundary elements of a map where they know more, which take seconds
    int grid = 256;             ///< their points a side, at least 16
    Edges edges = Edges::mirrored;
    double gamma = 0.45;   ///< of Persson's theory, above 0 and at most 1
    double seating = 1e3;  ///< the approach is 0 at this pressure [Pa]
    ProgressHook progress{};
};

/// A value between the 5 % and the 95 % end of its band.
struct Banded {
    double low = 0, value = 0, high = 0;
};

/// The answer at one pressure.
struct AnswerPoint {
    double pressure = 0;                        ///< [Pa]
    std::string reason{};                       ///< why there is no K; empty where there is one
    Banded stiffness{};                         ///< K of the nominal area [Pa/m]
    LawName law{};                              ///< that gave it
    parts::Causes<double> causes{};             ///< of the band, in ln K: parts::shares_of() are their shares
    std::optional<double> p_star{};             ///< p/(E g)
    std::optional<double> contacts{};           ///< expected on the nominal area, or on that of the measurement
    std::optional<double> loading_stiffness{};  ///< -dp/dd of the first loading where peaks yield [Pa/m]
    std::optional<double> approach{};           ///< since AnswerOptions::seating [m]

    [[nodiscard]] bool ok() const { return reason.empty(); }
};

/// A number that was assumed, with 5 and 95 % of it.
struct AssumedNumber {
    parts::Unknown which{};
    Banded range{};         ///< of the number; of an rms height of Ra or Sa, Ra/Rq or Sa/Sq
    bool of_other = false;  ///< of Joint::other
};

/// The answer of a joint.
struct Answer {
    std::vector<AnswerPoint> points;            ///< one for each pressure, in their order
    bool flows = false;                         ///< the peaks yield: K is that of unloading, of vibration and waves
    bool of_map_itself = false;                 ///< the contact is the measured map, and no other piece of the surface
    std::optional<double> relative_hardness{};  ///< H/(E g), where both are known
    std::vector<AssumedNumber> assumed{};       ///< that the law of the answer depends on
};

/// K of \p joint under \p pressures [Pa], each above 0.
/// \throws domain_error naming the member of the joint, or where no law answers.
[[nodiscard]] Answer answer(const Joint& joint, std::span<const double> pressures, const AnswerOptions& options = {});

/// The contact of \p joint by \p law, of the first of its distributions of peaks. The contact keeps what it is made of.
/// \throws domain_error naming the member of the joint that the law needs.
[[nodiscard]] std::shared_ptr<const AnyContact> contact_of(const Joint& joint, LawName law,
                                                           const AnswerOptions& options = {});

}  // namespace fstiff::inline v0_1
