// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What the parts of the module fstiff._core share: arrays of NumPy in and out, and Ctrl-C.

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/joint_fields.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/parallel.hpp>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff::python {

namespace nb = nanobind;

/// Numbers of the caller, read where they are.
using In = nb::ndarray<const double, nb::c_contig, nb::device::cpu>;
/// Numbers that own their memory.
using Out = nb::ndarray<nb::numpy, double>;

inline std::span<const double> numbers_of(const In& array) { return {array.data(), array.size()}; }

/// Memory for an array of the shape of \p like; it is left as it is.
class NewArray {
public:
    explicit NewArray(const In& like) : data_(new double[like.size()]) {
        for (std::size_t i = 0; i < like.ndim(); ++i) shape_.push_back(like.shape(i));
    }
    explicit NewArray(std::span<const double> values) : NewArray(values, {values.size()}) {}
    NewArray(std::span<const double> values, std::vector<std::size_t> shape)
        : data_(new double[values.size()]), shape_(std::move(shape)) {
        std::copy(values.begin(), values.end(), data_.get());
    }
    [[nodiscard]] double* data() { return data_.get(); }
    /// The array, which owns the memory from now on. Needs the GIL.
    [[nodiscard]] Out take() {
        double* const data = data_.release();
        const nb::capsule owner(data, [](void* p) noexcept { delete[] static_cast<double*>(p); });
        return Out(data, shape_.size(), shape_.data(), owner);
    }

private:
    std::unique_ptr<double[]> data_;
    std::vector<std::size_t> shape_;
};

/// \p values as an array of \p shape, without a copy. Needs the GIL.
inline Out taken(std::vector<double> values, const std::vector<std::size_t>& shape) {
    auto kept = std::make_unique<std::vector<double>>(std::move(values));
    double* const data = kept->data();
    const nb::capsule owner(kept.release(), [](void* p) noexcept { delete static_cast<std::vector<double>*>(p); });
    return Out(data, shape.size(), shape.data(), owner);
}

/// Numbers by their names.
using Numbers = std::map<std::string, double, std::less<>>;

/// Gives the fields of \p owner, of each_field(), the numbers that \p find has by their names or by other words for
/// them. \throws domain_error for a number by two names.
template <class Owner, class Find>
void take_numbers(Owner& owner, const Find& find) {
    each_field(owner, [&](std::string_view name, auto& value, const NumberFacts& facts) {
        std::string_view first;
        const auto take = [&](std::string_view key) {
            const std::optional<double> number = find(key);
            if (!number) return;
            if (!first.empty()) throw domain_error(std::string(key) + ": must not be given with " + std::string(first));
            first = key, value = *number;
        };
        take(name);
        for (const std::string_view word : facts.words) take(word);
    });
    if constexpr (std::is_same_v<Owner, JointFace>)
        detail::each_flag(owner, [&](std::string_view name, bool& value, std::string_view) {
            if (const std::optional<double> number = find(name)) value = *number != 0;
        });
}
template <class Owner>
void take_numbers(Owner& owner, const Numbers& numbers) {
    take_numbers(owner, [&](std::string_view key) {
        const auto given = numbers.find(key);
        return given == numbers.end() ? std::nullopt : std::optional(given->second);
    });
}

/// What the laws of answers go through: columns of joints x pressures, NaN where there is no K, and numbers of each joint.
struct LawColumns {
    std::map<std::string, std::vector<double>> points{}, facts{};

    /// \p found, at as many pressures as the other joints.
    void put(const Answer& found);
    /// A joint without a K at \p pressures.
    void put(std::span<const double> pressures);
    /// Arrays of \p joints x pressures. Needs the GIL.
    [[nodiscard]] nb::dict take(std::size_t joints) const;
};

/// Ends a computation by what a signal raises, KeyboardInterrupt for Ctrl-C.
ProgressHook until_interrupted();

void add_answers(nb::module_& m);
void add_contacts(nb::module_& m);
void add_integrals(nb::module_& m);
void add_scenes(nb::module_& m);
void add_surfaces(nb::module_& m);
void add_sweeps(nb::module_& m);

}  // namespace fstiff::python
