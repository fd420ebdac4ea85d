// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The answer: one stiffness for each pressure, by the law that holds there, with a band and its causes.
///
///     const fstiff::Answer plates = fstiff::answer(joint, pressures);
///     for (const fstiff::AnswerPoint& point : plates.points)
///         if (point.ok()) use(point.pressure, point.stiffness.value, point.stiffness.low, point.stiffness.high);
///
/// What `fstiff run` computes of a scene that names no law. Where the functions come from: docs/linking-cpp.md.
///
/// Reference   answer/causes.hpp
/// Units       SI
/// Valid       joints as answer/joint.hpp has them
/// Accuracy    K and both ends of `fstiff run`, to the last digit (tests/scene/joint_test.cpp); of the band:
///             docs/accuracy.md

#include <fstiff/answer/answer_quantity.hpp>
#include <fstiff/answer/any_contact.hpp>
#include <fstiff/answer/causes.hpp>
#include <fstiff/answer/chosen_law.hpp>
#include <fstiff/answer/concern.hpp>
#include <fstiff/answer/joint.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/parallel.hpp>
#include <fstiff/topography/edges.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// How an answer is computed.
struct AnswerOptions {
    std::vector<ChosenLaw> laws{};          ///< that have a curve each next to the answer
    bool laws_alone = false;                ///< without the answer
    std::vector<std::string> quantities{};  ///< words of answer_quantities(); none: all that the joint has, where those
                                            ///< of a separation take twelve times as long as K without a band
    bool next = false;          ///< what to measure next too, which takes up to five more answers at one pressure
    int samples = 400;          ///< surfaces drawn for the band; 0: K alone, without a band of the surface
    std::uint64_t seed = 2014;  ///< of them
    bool solve_map = true;      ///< boundary elements of a map where they know more, which take seconds
    int grid = 256;             ///< their points a side, at least 16
    Edges edges = Edges::mirrored;
    double gamma = 0.45;          ///< of Persson's theory, above 0 and at most 1
    double seating = 1e3;         ///< the approach is 0 at this pressure [Pa]
    bool at_separations = false;  ///< the points are separations of the mean planes [m], not pressures
    /// Places among the points at which boundary elements are solved and, of more than 100 points next to laws, the
    /// answer is given; none: all.
    std::vector<std::size_t> places{};
    std::string (*pressure_text)(double pressure) = nullptr;  ///< how reasons show one; null: in Pa
    ProgressHook progress{};
    ParallelHook parallel{};  ///< runs what takes long: contacts of a map, surfaces of the band, boundary elements;
                              ///< the latter two report no progress then
};

/// A value between the 5 % and the 95 % end of its band; NaN where there is none.
struct WithBand {
    double low = std::numeric_limits<double>::quiet_NaN(), value = low, high = low;
};

/// K at one pressure, and what follows from it where the joint has what it takes.
struct AnswerPoint {
    /// Why there is no K.
    enum class Miss {
        none,
        law,       ///< by the reason that the law gives
        range,     ///< a number is beyond the range of double precision
        hardness,  ///< the pressure reaches the hardness
        closed     ///< the contact is closed above a pressure
    };
    /// A quantity; one that does not follow from K has no ends.
    struct Value {
        const AnswerQuantity* quantity = nullptr;
        WithBand number{};
        double error = 0;  ///< numerical, of the value
    };

    double pressure = 0;                        ///< [Pa]; NaN of a separation without a K
    std::string reason{};                       ///< why there is no K; empty where there is one
    Miss miss = Miss::none;                     ///< the kind of it
    std::size_t place = 0;                      ///< among the points that were asked for
    WithBand stiffness{};                       ///< K of the nominal area [Pa/m]; without a band three equal numbers
    LawKind law = LawKind::none;                ///< that gave it
    Causes<double> causes{};                    ///< of the band of an answer, in ln K: shares_of() are their shares
    std::optional<double> p_star{};             ///< p/(E g)
    std::optional<double> contacts{};           ///< expected on the nominal area, or on that of the measurement
    std::optional<double> loading_stiffness{};  ///< -dp/dd of the first loading where peaks yield [Pa/m]
    ContactState<double> state{};               ///< as the law gives it, with numerical errors
    std::vector<Value> values{};                ///< the quantities that were asked for, as far as the law gives them
    std::optional<WithBand> faces{};            ///< K of the faces [Pa/m] where the joint has a form
    std::optional<double> loading_of_faces{};   ///< their -dp/dd [Pa/m]
    std::size_t failed = 0;                     ///< surfaces drawn for the band that have no K there
    std::string doubt{};                        ///< why the law may be far off there; empty: nothing speaks against it

    [[nodiscard]] bool ok() const { return reason.empty(); }
    /// K of the faces under the nominal pressure [Pa/m]: what a contact element takes, and a narrow beam of ultrasound.
    [[nodiscard]] const WithBand& of_faces() const { return faces ? *faces : stiffness; }
    /// The quantity that answer_quantities() calls \p word; null where it is not there.
    [[nodiscard]] const Value* find(std::string_view word) const {
        const auto has_word = [&](const Value& value) { return value.quantity->word == word; };
        const auto found = std::find_if(values.begin(), values.end(), has_word);
        return found == values.end() ? nullptr : &*found;
    }
    /// Its number in SI; NaN where it is not there.
    [[nodiscard]] double operator[](std::string_view word) const {
        const Value* value = find(word);
        return value ? value->number.value : std::numeric_limits<double>::quiet_NaN();
    }
};

/// One law on one joint distribution of peaks, at every point.
struct AnswerCurve {
    LawKind law{};                        ///< of an answer that without boundary elements
    std::optional<double> theta{}, r{};   ///< of the peaks; none: a law without them
    std::vector<AnswerPoint> points{};    ///< in their order
    bool has_band = false;                ///< K has one
    std::vector<Check<double>> checks{};  ///< of the points, whether they hold or not; `first` is an AnswerPoint::place
    std::string no_approach{};            ///< why there is no approach, where it was asked for

    /// The point at \p place; null where it has no K.
    [[nodiscard]] const AnswerPoint* at(std::size_t place) const {
        const auto point = std::lower_bound(points.begin(), points.end(), place,
                                            [](const AnswerPoint& each, std::size_t x) { return each.place < x; });
        return point == points.end() || point->place != place || !point->ok() ? nullptr : &*point;
    }
};

/// A number that was assumed, with 5 and 95 % of it.
struct AssumedNumber {
    Unknown which{};
    WithBand range{};       ///< of the number; of an rms height of Ra or Sa, Ra/Rq or Sa/Sq
    bool of_other = false;  ///< of Joint::other
};

/// The answer of a joint: one K for each point, by the law that holds there.
struct Answer : AnswerCurve {
    std::vector<AnswerCurve> laws{};            ///< of AnswerOptions::laws, one for each distribution of peaks
    std::string refusal{};                      ///< why no law answers, next to laws; there are no points then
    std::size_t failed = 0;                     ///< most surfaces drawn for the bands of the laws that lack a K
    bool flows = false;                         ///< the peaks yield: K is that of unloading, of vibration and waves
    double long_waves = 1;                      ///< factor of K for waves longer than the measured piece; 1: none
    bool of_map_itself = false;                 ///< the contact is the measured map, and no other piece of the surface
    std::optional<double> relative_hardness{};  ///< H/(E g), where both are known
    std::optional<double> greatest_pressure{};  ///< of an earlier load under which the peaks had yielded [Pa]
    std::vector<AssumedNumber> assumed{};       ///< that the law of the answer depends on
    bool across_lay =
        false;  ///< a profile is taken to run across the lay, as ISO 21920 has it; along it K errs 2 to 5 times
    std::vector<Check<double>> concerns{};  ///< what does not hold; `first` is a place among the points
    bool doubtful = false;                  ///< `fstiff run` would end with exit code 4
    /// A measurement that narrows the band.
    struct Next {
        std::optional<Unknown> which{};   ///< none: four times the length or the area; of a trace across a lay, a map
        double pressure = 0;              ///< the middle one of the pressures [Pa]
        bool flatness = false;            ///< in place of `which`: how flat the faces are
        double factor = 0, narrowed = 0;  ///< high over low of its band, and once it finds what is assumed
    };
    std::optional<Next> next{};  ///< the measurement that narrows the band most, where AnswerOptions::next asks for it
    double rms_height = 0;       ///< of both faces [m]
    std::optional<double> rms_gradient{};  ///< of both faces, where it is known or assumed
    double effective_modulus = 0;          ///< [Pa]
    double hardness = 0;                   ///< of the softer body [Pa]; infinite: it never yields
    double yield_strength = 0;             ///< of the softer body, or its hardness over 2.8 [Pa]

    /// The law of the answer, or of an end of its band, whatever the form of the joint, between the pressures of its
    /// points: ln K by cubics over ln p that rise where the points do, and -dp/dd = K. Separations count from the
    /// greatest pressure of \p range: approach() and touch() of the law are those of the joint. Of peaks that yield it
    /// is the law of unloading. \p quantile is 0.05, 0.5 (K itself) or 0.95.
    /// The caller includes fstiff/tabulated/contact_law.hpp.
    /// \throws domain_error for another quantile, a range beyond the points, and a K that does not rise.
    [[nodiscard]] ContactLaw<double> law_at(double quantile, const LawRange<double>& range) const;

    /// The law of the first loading, by which a joint is tightened: p(d), and K of unloading from it. Separations as
    /// law_at(); of an elastic answer it is that. \throws domain_error as law_at(), and of a joint that has carried
    /// more.
    [[nodiscard]] ContactLaw<double> loading_law(double quantile, const LawRange<double>& range) const;
    /// The law of a joint that has carried \p greatest [Pa]: reversible below it, along loading_law() above, with which
    /// it shares separations (fstiff/tabulated/law_after.hpp). Friction takes it. Of an elastic answer it is law_at().
    /// Of a map the joint itself has the earlier load, as Joint::greatest_pressure, for boundary elements of what it
    /// left; \p greatest is then that pressure, and one of those of the answer. \throws domain_error as these.
    [[nodiscard]] ContactLaw<double> law_after(double greatest, double quantile, const LawRange<double>& range) const;
    /// The same after each of \p greatest, such as the preloads of many bolts: they are of one loading_law().
    [[nodiscard]] std::vector<ContactLaw<double>> law_after(std::span<const double> greatest, double quantile,
                                                            const LawRange<double>& range) const;

    struct Ball;
    /// A ball of the radius \p radius [m] on the face under each of \p forces [N]. Points whose pressures rise from
    /// where they carry nothing make its law: ball_pressures() of fstiff/answer/ball.hpp, which the caller includes.
    /// \throws domain_error for less than two points with a K.
    [[nodiscard]] std::vector<Ball> balls(double radius, std::span<const double> forces) const;
};

/// K of \p joint under \p pressures [Pa], at least one, each above 0. For set-up: one pressure on a joint of numbers
/// takes some 0.4 ms with its band and 1 ms more for what needs a separation, 0.2 ms of `{.quantities = {"stiffness"},
/// .samples = 0}`. A loop over pressures or separations takes Answer::law_at(), which is 1e5 times as fast. What is
/// assumed of a process is tabulated once in a program. Any threads may call it.
/// \throws domain_error naming the member of the joint or the option, or where no law answers and none is named.
[[nodiscard]] Answer answer(const Joint& joint, std::span<const double> pressures, const AnswerOptions& options = {});
/// K and what follows from it at one pressure. \throws domain_error as the above, and where the point has no K.
[[nodiscard]] inline AnswerPoint answer(const Joint& joint, double pressure, const AnswerOptions& options = {}) {
    AnswerPoint point = answer(joint, std::span(&pressure, 1), options).points.front();
    if (!point.ok()) throw domain_error(point.reason);
    return point;
}
/// Pressures in braces, or of Eigen.
[[nodiscard]] inline Answer answer(const Joint& joint, std::initializer_list<double> pressures,
                                   const AnswerOptions& options = {}) {
    return answer(joint, std::span(pressures.begin(), pressures.size()), options);
}
[[nodiscard]] inline Answer answer(const Joint& joint, const Eigen::Ref<const Eigen::VectorXd>& pressures,
                                   const AnswerOptions& options = {}) {
    return answer(joint, std::span(pressures.data(), static_cast<std::size_t>(pressures.size())), options);
}

/// The contact of \p joint by \p law, of the first of its distributions of peaks. The contact keeps what it is made of.
/// \throws domain_error naming the member of the joint that the law needs.
[[nodiscard]] std::shared_ptr<const AnyContact> contact_of(const Joint& joint, const ChosenLaw& law,
                                                           const AnswerOptions& options = {});

}}  // namespace fstiff
