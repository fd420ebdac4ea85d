// SPDX-License-Identifier: BSD-3-Clause
#include "io/mat_file.hpp"

#include "io/unpack.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

constexpr std::size_t mat_header = 128;
constexpr std::uint64_t mat_matrix = 14, mat_packed = 15;  // types of elements
constexpr std::array<std::string_view, 16> mat_kinds{"unknown", "cell",   "struct", "object", "char",  "sparse",
                                                     "double",  "single", "int8",   "uint8",  "int16", "uint16",
                                                     "int32",   "uint32", "int64",  "uint64"};

bool is_big(std::string_view bytes) { return bytes[126] == 'M'; }

/// An element: its type and content.
struct MatElement {
    std::uint64_t type{};
    std::string_view content;
};

/// Elements one after the other.
class MatCursor {
public:
    MatCursor(std::string_view rest, bool big, const std::string& name) : rest_(rest), big_(big), name_(name) {}

    [[nodiscard]] bool is_end() const { return rest_.empty(); }
    [[nodiscard]] std::size_t left() const { return rest_.size(); }

    /// The next element, which holds \p what.
    MatElement next(const std::string& what) {
        const std::uint64_t first = number(take(4, what));
        if (const std::uint64_t length = first >> 16; length != 0) {
            const std::string_view field = take(4, what);
            if (length > 4) refuse_file(name_, {"has ", length, " bytes in the 4 of ", what, "; must be at most 4"});
            return {first & 0xFFFF, field.substr(0, static_cast<std::size_t>(length))};
        }
        const std::uint64_t length = number(take(4, what));
        const std::string_view content = take(length, what);
        if (first != mat_packed) rest_.remove_prefix((std::min<std::size_t>)(-content.size() & 7, rest_.size()));
        return {first, content};
    }
    [[nodiscard]] std::uint64_t number(std::string_view bytes) const { return unsigned_at(bytes, big_); }

private:
    std::string_view take(std::uint64_t size, const std::string& what) {
        if (size > rest_.size())
            refuse_file(name_, {"ends within ", what, " (", size, " bytes, of which ", rest_.size(),
                                " are there); must be whole"});
        const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(size));
        rest_.remove_prefix(taken.size());
        return taken;
    }

    std::string_view rest_;
    bool big_;
    const std::string& name_;
};

std::string called(const MatVariable& variable) {
    return "variable " + std::to_string(variable.number) +
           (variable.name.empty() ? "" : " " + shown_cell(variable.name));
}

/// The first \p most bytes at most that the stream of \p variable holds; without zlib it is refused.
std::string first_bytes(const MatVariable& variable, [[maybe_unused]] std::size_t most, const std::string& name) {
#ifdef FSTIFF_HAS_ZLIB
    std::string first(most, '\0');
    first.resize(inflate_first(variable.bytes, first));
    if (first.size() >= 8) return first;
    refuse_file(name, {"has a damaged stream of ", called(variable), "; must be whole"});
#else
    refuse_file(name, {"has a compressed ", called(variable),
                       ", and this program was built without zlib; must be saved by save(..., '-v6')"});
#endif
}

/// The content of the element in the stream of \p variable.
std::string unpacked(const MatVariable& variable, bool big, const std::string& name) {
    const std::uint64_t size = 8 + unsigned_at(first_bytes(variable, 8, name).substr(4, 4), big);
    if (size > most_bytes || (size > (std::uint64_t(1) << 20) && size / 200 > variable.bytes.size()))
        refuse_file(name, {"declares a stream of ", variable.bytes.size(), " bytes that inflates to ", size, " for ",
                           called(variable), "; must be at most 200 times as many, and at most ", most_bytes});
    std::string whole(static_cast<std::size_t>(size), '\0');
#ifdef FSTIFF_HAS_ZLIB
    if (!inflate_zlib(variable.bytes, whole))
        refuse_file(name, {"has a stream of ", called(variable), " that does not inflate to its ", size,
                           " bytes; must be whole"});
#endif
    return whole.erase(0, 8);
}

/// Takes the description of \p variable from the beginning of its \p content.
void describe(MatVariable& variable, std::string_view content, bool big, const std::string& name) {
    MatCursor cursor(content, big, name);
    const std::string_view flags = cursor.next("the flags of " + called(variable)).content;
    if (flags.size() < 4) refuse_file(name, {"has no flags of ", called(variable), "; must have them"});
    const std::uint64_t word = cursor.number(flags.substr(0, 4));
    variable.kind = static_cast<unsigned>(word & 0xFF);
    variable.is_complex = (word & 0x800) != 0;
    variable.is_logical = (word & 0x200) != 0;
    const std::string_view sizes = cursor.next("the dimensions of " + called(variable)).content;
    for (std::size_t i = 0; i + 4 <= sizes.size(); i += 4)
        variable.sizes.push_back(cursor.number(sizes.substr(i, 4)) & 0x7FFFFFFF);
    variable.name = printable(cursor.next("the name of " + called(variable)).content, 64);
}

}  // namespace

bool MatVariable::has_numbers() const {
    return kind >= 6 && kind <= 15 && !is_complex && !is_logical && sizes.size() == 2 && sizes[0] > 0 && sizes[1] > 0 &&
           sizes[0] * sizes[1] >= 2 && sizes[0] * sizes[1] < most_bytes;
}

std::string MatVariable::shown() const {
    std::string text = std::to_string(number) + " " + shown_cell(name) + ", ";
    for (std::size_t i = 0; i < (std::min<std::size_t>)(sizes.size(), 4); ++i)
        text += (i == 0 ? "" : " x ") + std::to_string(sizes[i]);
    return text +
           (is_complex   ? " complex"
            : is_logical ? " logical"
                         : "") +
           " " + std::string(mat_kinds[kind < mat_kinds.size() ? kind : 0]);
}

bool is_mat(std::string_view bytes) { return bytes.starts_with("MATLAB 5.0"); }

std::vector<MatVariable> mat_variables(std::string_view bytes, const std::string& name) {
    const std::string_view order = FileBytes(bytes, name).at(0, mat_header, "its header").substr(124);
    if (order != std::string_view("\0\1IM", 4) && order != std::string_view("\1\0MI", 4))
        refuse_file(name, {"states no version and byte order of a MATLAB file of level 5; must state them"});
    const bool big = is_big(bytes);
    MatCursor cursor(bytes.substr(mat_header), big, name);
    std::vector<MatVariable> variables;
    while (!cursor.is_end()) {
        if (variables.size() == 10000) refuse_file(name, {"holds more than 10000 variables; must hold fewer"});
        MatVariable variable{.name = {}, .number = variables.size() + 1, .sizes = {}, .bytes = {}};
        const MatElement element = cursor.next(called(variable));
        if (element.type != mat_matrix && element.type != mat_packed)
            refuse_file(name, {"has an element of type ", element.type, " for ", called(variable),
                               "; must be 14 or 15, a variable"});
        variable.bytes = element.content;
        variable.is_packed = element.type == mat_packed;
        if (variable.is_packed)  // the longest name and 32 dimensions fit
            describe(variable, std::string_view(first_bytes(variable, 4096, name)).substr(8), big, name);
        else if (!element.content.empty())
            describe(variable, element.content, big, name);
        variables.push_back(std::move(variable));
    }
    return variables;
}

MatNumbers mat_numbers(std::string_view bytes, const std::string& name, const MatVariable& variable) {
    const bool big = is_big(bytes);
    const std::string inflated = variable.is_packed ? unpacked(variable, big, name) : std::string();
    MatCursor cursor(variable.is_packed ? std::string_view(inflated) : variable.bytes, big, name);
    for (const char* part : {"the flags of ", "the dimensions of ", "the name of "})
        (void)cursor.next(part + called(variable));
    const auto [type, content] = cursor.next("the numbers of " + called(variable));
    // bytes of a number by the type: 0 of one that is none
    constexpr std::array<std::size_t, 14> widths{0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8};
    const std::size_t width = type < widths.size() ? widths[static_cast<std::size_t>(type)] : 0;
    if (width == 0)
        refuse_file(name, {"stores the numbers of ", called(variable), " as type ", type,
                           "; must be an integer or floating point"});
    if (content.size() / width != variable.count() || content.size() % width != 0)
        refuse_file(name, {"declares ", variable.count(), " numbers of ", width, " bytes in ", called(variable),
                           ", but has ", content.size(), " bytes of them; must agree"});
    const bool is_signed = type == 1 || type == 3 || type == 5 || type == 12;
    const char kind = type == 7 || type == 9 ? 'f' : is_signed ? 'i' : 'u';
    MatNumbers numbers{.values = std::vector<double>(variable.count()), .are_whole = kind != 'f'};
    for (std::size_t i = 0; i < numbers.values.size(); ++i) {
        const double value = value_at(content.substr(i * width, width), kind, big);
        numbers.values[i] = std::isinf(value) ? std::numeric_limits<double>::quiet_NaN() : value;
    }
    return numbers;
}

}  // namespace fstiff::inline v0_1::io::detail
