// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Tabulated law as text, every number in hexadecimal, so that it comes back bit for bit.
///
///     fstiff contact law 3 8                            version of the form (3, 4 or 5), bytes of a number
///     pieces  policy  evaluations                       of the table by separation; OutsideRange
///     p_min p_max separation_min separation_max K/slope error         then a row of coefficients a line
///     sum                                               of the lines above, which no changed character leaves as it is
///
/// Version 3 holds p(separation), K(p), separation(p); version 4 also K(separation), with K/slope 0. Version 5 is a law
/// of parabolas: d, p, -dp/dd and its change by -d, K and its change by -d of each piece and at the end.
///
/// Units       SI
/// Valid       a law that is not empty, with a policy other than exact; lines may end in LF or CRLF

#include <fstiff/core/error.hpp>
#include <fstiff/tabulated/law_tables.hpp>

namespace fstiff { inline namespace v0_1 { namespace detail {

template <Real T>
[[nodiscard]] std::string law_text_head(int version) {
    return "fstiff contact law " + std::to_string(version) + ' ' + std::to_string(sizeof(T));
}

/// FNV-1a of \p text without carriage returns, in hexadecimal digits.
[[nodiscard]] inline std::string sum_of_text(std::string_view text) {
    std::uint64_t sum = 0xcbf29ce484222325;
    for (const char c : text)
        if (c != '\r') sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    char digits[16];
    return {digits, std::to_chars(digits, digits + sizeof digits, sum, 16).ptr};
}

template <Real T>
[[nodiscard]] std::array<T, 6> numbers_of(const Parabola<T>& piece) {
    return {piece.separation, piece.pressure, piece.slope, piece.bend, piece.stiffness, piece.stiffness_per_fall};
}
/// True if \p pieces are a table from \p law.min_pressure to max_pressure, with p and -d rising all the way.
template <Real T>
[[nodiscard]] bool is_table(const std::vector<Parabola<T>>& pieces, const LawTables<T>& law, T closest, T furthest) {
    if (pieces.front().pressure != law.min_pressure || pieces.back().pressure != law.max_pressure ||
        pieces.front().separation != furthest || pieces.back().separation != closest)
        return false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!(pieces[i].slope > 0 && pieces[i].stiffness > 0)) return false;
        if (i > 0 && !(pieces[i].pressure > pieces[i - 1].pressure && pieces[i].separation < pieces[i - 1].separation))
            return false;
    }
    return true;
}

template <Real T>
[[nodiscard]] std::string law_text(const LawTables<T>& law) {
    const bool kinked = !law.kinked.empty();
    std::string text = law_text_head<T>(kinked ? 5 : law.has_own_stiffness() ? 4 : 3) + '\n';
    text += std::to_string(kinked ? law.kinked.pieces().size() : law.by_separation.rows.size()) + ' ' +
            std::to_string(static_cast<int>(law.outside)) + ' ' + std::to_string(law.evaluations) + '\n';
    const auto add = [&text](const T* numbers, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            text += detail::hexadecimal_text(numbers[i]) + (i + 1 < count ? ' ' : '\n');
    };
    const T head[] = {law.min_pressure, law.max_pressure,         law.closest(),
                      law.furthest(),   law.stiffness_over_slope, law.relative_error};
    add(head, std::size(head));
    for (const Parabola<T>& piece : law.kinked.pieces()) {
        const auto numbers = numbers_of(piece);
        add(numbers.data(), numbers.size());
    }
    for (const auto* rows :
         {&law.by_separation.rows, &law.stiffness.rows, &law.separation.rows, &law.own_stiffness.rows})
        for (const math::Coefficients<T>& row : *rows) add(row.c, math::Row::terms);
    return text + sum_of_text(text) + '\n';
}

/// Reads the text of law_text, number after number.
template <Real T>
class LawTextReader {
public:
    explicit LawTextReader(std::string_view text) : text_(text) {}

    /// \throws domain_error for text that law_text did not write.
    [[nodiscard]] LawTables<T> read() {
        std::string_view line = text_.substr(0, text_.find('\n'));
        if (line.ends_with('\r')) line.remove_suffix(1);
        const bool own_stiffness = line == law_text_head<T>(4), kinked = line == law_text_head<T>(5);
        if (!own_stiffness && !kinked && line != law_text_head<T>(3))
            throw wrong(line.starts_with("fstiff contact law ") ? "is of another version or another scalar type"
                                                                : "begins with something else");
        require_sum();
        cursor_ += line.size();
        const auto pieces = number(Eigen::Index{});
        read_head();
        const T factor = law_.stiffness_over_slope;
        if (kinked ? factor < 0 : own_stiffness ? factor != 0 : !(factor > 0)) throw wrong("contradicts itself");
        // each number takes two characters or more: a size that the text cannot hold is refused before it is allocated
        const auto size = static_cast<Eigen::Index>(text_.size());
        if (pieces < (kinked ? 2 : 1) || pieces > size ||
            (!kinked && math::BinaryPieces<T>::pieces(law_.min_pressure, law_.max_pressure) > size))
            throw wrong("holds impossible sizes");
        kinked ? read_parabolas(static_cast<std::size_t>(pieces)) : read_polynomials(pieces, own_stiffness);
        return std::move(law_);
    }

private:
    [[nodiscard]] static domain_error wrong(const char* what) {
        return domain_error(Refusal{.parameter = "contact law text",
                                    .reason = std::string(what) + ": must be what to_text wrote for this scalar type"});
    }
    /// Takes the last line from the text, which it must be the sum of.
    void require_sum() {
        const std::size_t end = text_.find_last_not_of(" \r\n") + 1, last = text_.rfind('\n', end - 1) + 1;
        if (text_.substr(last, end - last) != sum_of_text(text_.substr(0, last)))
            throw wrong("was changed or cut short, as its check sum shows");
        text_ = text_.substr(0, last);
        end_ = text_.data() + last;
    }
    void skip() {
        while (cursor_ != end_ && (*cursor_ == ' ' || *cursor_ == '\n' || *cursor_ == '\r')) ++cursor_;
    }
    template <class Number>
    Number number(Number value) {
        skip();
        std::from_chars_result read{};
        if constexpr (std::is_floating_point_v<Number>)
            read = detail::read_hexadecimal(cursor_, end_, value);
        else
            read = std::from_chars(cursor_, end_, value);
        if (read.ec != std::errc{}) throw wrong("ends early or holds no number");
        if constexpr (std::is_floating_point_v<Number>)
            if (!std::isfinite(value)) throw wrong("holds a number that is not finite");
        cursor_ = read.ptr;
        return value;
    }
    void require_end() {
        skip();
        if (cursor_ != end_) throw wrong("goes on after its end");
    }

    void read_head() {
        law_.outside = static_cast<OutsideRange>(number(int{}));
        if (law_.outside != OutsideRange::refuse && law_.outside != OutsideRange::clamp &&
            law_.outside != OutsideRange::extrapolate)
            throw wrong("holds an unknown policy");
        law_.evaluations = number(int{});
        for (T* x : {&law_.min_pressure, &law_.max_pressure, &closest_, &furthest_, &law_.stiffness_over_slope,
                     &law_.relative_error})
            *x = number(T{});
        if (!(law_.min_pressure >= (std::numeric_limits<T>::min)() && law_.max_pressure > law_.min_pressure &&
              furthest_ > closest_))
            throw wrong("contradicts itself");
    }
    void read_parabolas(std::size_t count) {
        std::vector<Parabola<T>> pieces(count);
        for (Parabola<T>& piece : pieces)
            for (T* x : {&piece.separation, &piece.pressure, &piece.slope, &piece.bend, &piece.stiffness,
                         &piece.stiffness_per_fall})
                *x = number(T{});
        require_end();
        if (!is_table(pieces, law_, closest_, furthest_)) throw wrong("contradicts itself");
        law_.kinked = KinkedTables<T>(std::move(pieces));
    }
    void read_polynomials(Eigen::Index count, bool own_stiffness) {
        law_.by_separation = math::UniformPieces<T>(closest_, furthest_, count);
        if (!(law_.by_separation.pieces_per_length > 0 && std::isfinite(law_.by_separation.pieces_per_length)))
            throw wrong("contradicts itself");
        if (own_stiffness) law_.own_stiffness = law_.by_separation;
        law_.stiffness = law_.separation = math::BinaryPieces<T>(law_.min_pressure, law_.max_pressure);
        for (auto* rows :
             {&law_.by_separation.rows, &law_.stiffness.rows, &law_.separation.rows, &law_.own_stiffness.rows})
            for (math::Coefficients<T>& row : *rows)
                for (T& coefficient : row.c) coefficient = number(T{});
        require_end();
        law_.set_scales();
        law_.sum_energies();
    }

    std::string_view text_;
    const char *cursor_ = text_.data(), *end_ = cursor_ + text_.size();
    LawTables<T> law_{};
    T closest_{}, furthest_{};
};

}}}  // namespace fstiff::detail
