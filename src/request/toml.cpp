// SPDX-License-Identifier: BSD-3-Clause
#define TOML_IMPLEMENTATION
#include "request/toml.hpp"

#include "document/file.hpp"

namespace fstiff::request {
namespace {

/// The depth of the tables and lists of a text, character after character; the parts of a.b.c count. Each level takes a
/// part of the stack, in toml++ and wherever its tree is copied or freed.
class Depth {
public:
    /// \p c is no part of a text or a comment, but may be the quotation mark of one. \return whether all is well
    bool passes(char c) {
        if (c == ' ' || c == '\t' || c == '\r') return blank_ = true;
        if (c == '[' || c == '{') outer_.push_back(depth_++);
        if (c == ']' || c == '}')
            depth_ = outer_.empty() ? 0 : outer_.back(), outer_.resize(outer_.size() - !outer_.empty());
        if (c == '.' && last_ != '.') ++depth_;  // between two points is no key
        if (c == ',' || c == '\n' || (blank_ && last_ != '.' && is_word(c))) depth_ = base();
        blank_ = c == '\n', last_ = c;
        return depth_ <= deepest;
    }
    static constexpr std::size_t deepest = 100;  ///< keeps to a tenth of a stack of 1 MB

private:
    static bool is_word(char c) { return std::string_view(".=[]{},\n").find(c) == std::string_view::npos; }
    std::size_t base() const { return outer_.empty() ? 0 : outer_.back() + 1; }

    std::vector<std::size_t> outer_;  ///< depths before the brackets that are open
    std::size_t depth_ = 0;
    char last_ = '\n';  ///< that is not blank
    bool blank_ = true;
};

/// The place in \p text after the comment, or the text in quotation marks, that begins at \p place; \p place elsewhere.
std::size_t after_quoted(std::string_view text, std::size_t place) {
    const char c = text[place];
    if (c == '#') return std::min(text.find('\n', place), text.size());
    if (c != '"' && c != '\'') return place;
    const std::string mark(text.substr(place, 3) == std::string(3, c) ? 3 : 1, c);
    place += mark.size();
    while (place < text.size() && text.substr(place, mark.size()) != mark && (mark.size() == 3 || text[place] != '\n'))
        place += c == '"' && text[place] == '\\' && place + 1 < text.size() ? 2 : 1;
    if (place < text.size() && text[place] == c) place += mark.size();
    for (int more = 0; mark.size() == 3 && more < 2 && text.substr(place).starts_with(c); ++more)
        ++place;  // of the text
    return place;
}

/// Whether \p quoted, a text in double quotation marks, has the escape of U+0000.
bool holds_nul(std::string_view quoted) {
    for (std::size_t i = 0; i + 1 < quoted.size(); i += quoted[i] == '\\' ? 2 : 1)
        if (quoted.substr(i).starts_with("\\u0000") || quoted.substr(i).starts_with("\\U00000000")) return true;
    return false;
}

/// Refuses what toml++ 3.3 must not see: characters beyond ASCII outside quotation marks and comments, which TOML does
/// not allow, run it into undefined behaviour, so that a forgotten quotation mark before a µ is reported here; tables
/// in tables without end overflow the stack; and U+0000 would end a message.
void refuse_unsafe(std::string_view text, const std::string& file) {
    std::size_t line = 1;
    const auto refuse = [&](const std::string& reason) {
        throw domain_error(file + ":" + std::to_string(line) + ": " + reason);
    };
    Depth depth;
    for (std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; i < text.size();) {
        if (static_cast<unsigned char>(text[i]) >= 0x80)
            refuse("is not valid TOML: a character beyond ASCII is outside quotation marks; it must be inside");
        const std::size_t end = after_quoted(text, i);
        const std::string_view quoted = text.substr(i, end - i);
        if (!quoted.starts_with('#') && !depth.passes(text[i]))
            refuse("has keys or lists more than " + std::to_string(Depth::deepest) + " levels deep; must have fewer");
        if (quoted.starts_with('"') && holds_nul(quoted))
            refuse("holds \\u0000, which is no character of a text; must be left out");
        line += static_cast<std::size_t>(std::count(quoted.begin(), quoted.end(), '\n')) +
                (quoted.empty() && text[i] == '\n');
        i = std::max(end, i + 1);
    }
}

/// The line at which toml++ trips over \p text: that of the shortest beginning of the text that breaks it too.
std::size_t breaking_line(std::string_view text) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') ends.push_back(i + 1);
    const auto broken = std::partition_point(ends.begin(), ends.end(), [text](std::size_t end) {
        try {
            static_cast<void>(toml::parse(text.substr(0, end)));
        } catch (const BrokenToml&) {
            return false;
        } catch (const toml::parse_error&) {  // a table or a text cut short
        }
        return true;
    });
    return static_cast<std::size_t>(broken - ends.begin()) + 1;
}

/// What is likely wrong with \p value, which follows "=" in a text that is not valid TOML; empty: nothing is.
std::string hint_of(std::string_view value) {
    value = value.substr(std::min(value.find_first_not_of(" \t["), value.size()));
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    if (value.empty()) return "";
    if (is_letter(value[0])) {
        const bool is_word = value.starts_with("true") || value.starts_with("false") || value.starts_with("inf") ||
                             value.starts_with("nan");
        return is_word ? "" : "; write a text in quotation marks, such as \"ground\"";
    }
    const std::size_t end = std::min(value.find_first_not_of("+-.0123456789"), value.size());
    if (value.find_first_of("0123456789") >= end) return "";
    const std::string_view after = value.substr(end);
    if (after.size() > 1 && after[0] == ',' && detail::is_decimal_digit(after[1]))
        return "; the decimal mark is the point, as in 0.8";
    const std::size_t unit = after.find_first_not_of(" \t");
    const bool has_unit = unit != after.npos && (is_letter(after[unit]) || after[unit] == '/' || after[unit] == '%');
    return has_unit ? "; write a quantity in quotation marks, such as \"0.8 um\"" : "";
}

/// The hint of the first value in line \p number of \p text that has one.
std::string hint_of_line(std::string_view text, std::size_t number) {
    for (; number > 1; --number) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    text = text.substr(0, text.find('\n'));
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '=')
            if (std::string hint = hint_of(text.substr(i + 1)); !hint.empty()) return hint;
        i = std::max(after_quoted(text, i), i + 1);
    }
    return "";
}

}  // namespace

std::string written(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* number = node.as_floating_point())
        return std::isfinite(number->get()) ? document::shortest(number->get())
               : std::isnan(number->get())  ? "nan"
               : number->get() < 0          ? "-inf"
                                            : "inf";
    if (const auto* number = node.as_integer()) return std::to_string(number->get());
    if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
    if (node.is_array()) return node.as_array()->empty() ? "[]" : "[...]";
    if (node.is_table()) return "{...}";
    return "a date or a time";
}

Value value_of(const toml::node& node) {
    using Kind = Value::Kind;
    Value value{.kind = Kind::other, .written = written(node), .giver = Value::Giver::scene};
    if (node.is_string()) value.kind = Kind::text;
    if (const auto* truth = node.as_boolean()) value.kind = Kind::truth, value.number = truth->get();
    if (const auto* real = node.as_floating_point()) value.kind = Kind::real, value.number = real->get();
    if (const auto* integer = node.as_integer()) {
        constexpr std::int64_t most = std::int64_t(1) << 53;  // which a double may not hold beyond
        const bool is_exact = integer->get() <= most && integer->get() >= -most;
        value.kind = Kind::integer;
        value.number = is_exact ? static_cast<double>(integer->get()) : std::numeric_limits<double>::quiet_NaN();
    }
    if (const auto* list = node.as_array()) {
        value.kind = Kind::list;
        for (const toml::node& item : *list) value.items.push_back(value_of(item));
    }
    return value;
}

toml::table parse_toml(const std::string& text, const std::string& file) {
    if (text.size() > document::longest_scene)
        throw domain_error(file + ": has " + std::to_string(text.size()) + " bytes or more; must be at most 1 MiB");
    const auto refuse = [&](std::size_t line, const std::string& reason) {
        return domain_error(file + ":" + std::to_string(line) + ": is not valid TOML: " + reason +
                            hint_of_line(text, line) +
                            (reason.ends_with("expected '=', saw ':'")
                                 ? "; write key = value, below a line with the section, such as [surface]"
                                 : ""));
    };
    if (text.find('\0') != std::string::npos)
        throw domain_error(file + ": is binary, or UTF-16 (it holds NUL bytes); must be TOML, a text in UTF-8");
    refuse_unsafe(text, file);
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw refuse(error.source().begin.line, std::string(error.description()));
    } catch (const BrokenToml&) {
        throw refuse(breaking_line(text), "a character that cannot begin a key or value");
    }
}

}  // namespace fstiff::request
