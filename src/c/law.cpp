// SPDX-License-Identifier: BSD-3-Clause
// Tabulated laws.
#include "c/law.hpp"

#include "c/contact.hpp"

#include <fstiff/tabulated/law_after.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>

namespace fstiff::c {
namespace {

using Law = ContactLaw<double>;
using In = Eigen::Map<const Eigen::ArrayXd>;
using Out = Eigen::Map<Eigen::ArrayXd>;

/// \p one(x, first, second) for every point, with its status.
template <class One>
int point_by_point(const double* x, std::size_t count, double* first, double* second, int* status, const One& one) {
    int worst = FSTIFF_OK;
    std::string message;
    for (std::size_t i = 0; i < count; ++i) {
        double a = 0, b = 0;
        const int code = one(x[i], &a, &b);
        if (first) first[i] = a;
        if (second) second[i] = b;
        if (status) status[i] = code;
        if (code != FSTIFF_OK && worst == FSTIFF_OK) worst = code, message = fstiff_last_message();
    }
    if (worst != FSTIFF_OK) set_message(message);
    return worst;
}

constexpr std::size_t part = 256;  // points that are evaluated at once

/// Arrays in parts: \p many(in, a, b) evaluates one part into a and b; where it throws, or a result is not a number,
/// \p one does it point by point.
template <class Many, class One>
int in_parts(const double* x, std::size_t count, double* first, double* second, int* status, const Many& many,
             const One& one) {
    int worst = FSTIFF_OK;
    std::array<double, part> numbers, a, b;
    for (std::size_t begin = 0; begin < count; begin += part) {
        const std::size_t length = std::min(part, count - begin);
        const auto size = static_cast<Eigen::Index>(length);
        std::copy_n(x + begin, length, numbers.begin());  // the results may be written where the arguments were
        Out out_a(a.data(), size), out_b(b.data(), size);
        bool good = false;
        try {
            many(In(numbers.data(), size), out_a, out_b);
            good = out_a.isFinite().all() && out_b.isFinite().all();
        } catch (const domain_error&) {
        }
        double* const to_first = first ? first + begin : nullptr;
        double* const to_second = second ? second + begin : nullptr;
        int* const to_status = status ? status + begin : nullptr;
        if (good) {
            if (first) std::copy_n(a.begin(), length, to_first);
            if (second) std::copy_n(b.begin(), length, to_second);
            if (status) std::fill_n(to_status, length, FSTIFF_OK);
            continue;
        }
        const std::string before = worst == FSTIFF_OK ? std::string() : fstiff_last_message();
        const int found = point_by_point(numbers.data(), length, to_first, to_second, to_status, one);
        if (worst == FSTIFF_OK)
            worst = found;
        else
            set_message(before);
    }
    return worst;
}

}  // namespace
}  // namespace fstiff::c

using namespace fstiff::c;

int fstiff_law_make(const fstiff_contact* contact, double min_pressure, double max_pressure, int outside,
                    fstiff_law** made) {
    return made_by(made, [&] {
        not_null(contact, "contact");
        return new fstiff_law{contact->contact->tabulate(
            {.min_pressure = min_pressure, .max_pressure = max_pressure, .outside = outside_of(outside)})};
    });
}

int fstiff_law_after(const fstiff_law* first_loading, double greatest_pressure, double relative_hardness,
                     fstiff_law** made) {
    return made_by(made, [&] {
        return new fstiff_law{
            fstiff::law_after(not_null(first_loading, "first_loading").law, greatest_pressure, relative_hardness)};
    });
}

int fstiff_law_of_text(const char* text, size_t length, fstiff_law** made) {
    return made_by(made, [&] {
        not_null(text, "text");
        return new fstiff_law{Law::from_text(std::string_view(text, length))};
    });
}

int fstiff_law_text(const fstiff_law* law, char* buffer, size_t capacity, size_t* length) {
    return guarded([&] { return text_into(not_null(law, "law").law.to_text(), buffer, capacity, length); });
}

void fstiff_law_free(fstiff_law* law) { delete law; }

int fstiff_law_facts_of(const fstiff_law* law, fstiff_law_facts* facts) {
    return guarded([&] {
        const Law& table = not_null(law, "law").law;
        fstiff_law_facts to{};
        to.min_pressure = table.pressures()[0], to.max_pressure = table.pressures()[1];
        to.min_separation = table.separations()[0], to.max_separation = table.separations()[1];
        to.relative_error = table.relative_error();
        to.stiffness_is_slope = table.stiffness_is_slope();
        to.outside = static_cast<int>(table.outside());
        give(to, sized(facts, "facts"));
        return FSTIFF_OK;
    });
}

int fstiff_law_at_separation(const fstiff_law* law, double separation, double* pressure, double* stiffness,
                             double* slope) {
    return guarded([&]() -> int {
        const auto point = not_null(law, "law").law.at_separation(separation);
        const double minus_dp_dd = slope ? law->law.slope_at_separation(separation) : 0;
        if (const int status = all_finite(point.pressure, point.stiffness, minus_dp_dd)) return status;
        put(pressure, point.pressure), put(stiffness, point.stiffness), put(slope, minus_dp_dd);
        return FSTIFF_OK;
    });
}

int fstiff_law_at_pressure(const fstiff_law* law, double pressure, double* separation, double* stiffness,
                           double* stiffness_slope) {
    return guarded([&]() -> int {
        const Law& table = not_null(law, "law").law;
        const double d = separation ? table.separation(pressure) : 0;
        const double k = stiffness || !(separation || stiffness_slope) ? table.stiffness(pressure) : 0;
        const double slope = stiffness_slope ? table.stiffness_slope(pressure) : 0;
        if (const int status = all_finite(d, k, slope)) return status;
        put(separation, d), put(stiffness, k), put(stiffness_slope, slope);
        return FSTIFF_OK;
    });
}

int fstiff_law_energy(const fstiff_law* law, double separation, double* energy) {
    return guarded([&]() -> int {
        const double found = not_null(law, "law").law.energy(separation);
        if (const int status = all_finite(found)) return status;
        not_null(energy, "energy") = found;
        return FSTIFF_OK;
    });
}

int fstiff_law_touch(const fstiff_law* law, double* separation) {
    return guarded([&]() -> int {
        const double found = not_null(law, "law").law.touch();
        if (const int status = all_finite(found)) return status;
        not_null(separation, "separation") = found;
        return FSTIFF_OK;
    });
}

int fstiff_law_at_separations(const fstiff_law* law, const double* separations, size_t count, double* pressures,
                              double* stiffnesses, int* status) {
    return guarded([&] {
        const Law& table = not_null(law, "law").law;
        require_array(separations, count, "separations");
        return in_parts(
            separations, count, pressures, stiffnesses, status,
            [&](const In& d, Out& p, Out& k) { table.at_separation(d, p, k); },
            [&](double d, double* p, double* k) { return fstiff_law_at_separation(law, d, p, k, nullptr); });
    });
}

int fstiff_law_tangents_at_separations(const fstiff_law* law, const double* separations, size_t count,
                                       double* pressures, double* slopes, int* status) {
    return guarded([&] {
        const Law& table = not_null(law, "law").law;
        require_array(separations, count, "separations");
        return in_parts(
            separations, count, pressures, slopes, status,
            [&](const In& d, Out& p, Out& k) { table.tangent_at_separation(d, p, k); },
            [&](double d, double* p, double* k) { return fstiff_law_at_separation(law, d, p, nullptr, k); });
    });
}

int fstiff_law_at_pressures(const fstiff_law* law, const double* pressures, size_t count, double* separations,
                            double* stiffnesses, int* status) {
    return guarded([&] {
        const Law& table = not_null(law, "law").law;
        require_array(pressures, count, "pressures");
        return in_parts(
            pressures, count, separations, stiffnesses, status,
            [&](const In& p, Out& d, Out& k) {
                table.stiffness(p, k);
                for (Eigen::Index i = 0; i < p.size(); ++i) d[i] = separations ? table.separation(p[i]) : 0;
            },
            [&](double p, double* d, double* k) {
                return fstiff_law_at_pressure(law, p, separations ? d : nullptr, k, nullptr);
            });
    });
}
