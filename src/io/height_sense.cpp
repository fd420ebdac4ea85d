// SPDX-License-Identifier: BSD-3-Clause
#include "io/height_sense.hpp"

#include "io/height_sense_words.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

/// \p text in lower case, with "*" and "/" for the signs of multiplication and division and a blank for "_".
std::string plain_text(std::string_view text) {
    static constexpr std::array<std::array<std::string_view, 2>, 7> signs{{{"\xC3\x97", "*"},
                                                                           {"\xC2\xB7", "*"},
                                                                           {"\xC3\xB7", "/"},
                                                                           {"\xC2\xA0", " "},
                                                                           {"\xE2\x88\x92", "-"},
                                                                           {"\xD7", "*"},
                                                                           {"\xF7", "/"}}};
    std::string all;
    for (std::size_t length = 1; !text.empty(); text.remove_prefix(length)) {
        const char c = text.front();
        length = (std::max)(utf8_length(text), std::size_t{1});
        if (static_cast<unsigned char>(c) < 0x80) {
            all += c == '_' ? ' ' : c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
            continue;
        }
        const std::string_view letter = text.substr(0, length);
        const auto sign = std::find_if(signs.begin(), signs.end(), [&](const auto& one) { return one[0] == letter; });
        all += sign == signs.end() ? letter : (*sign)[1];
        if (sign == signs.end() && length == 2 && c == '\xC3' && static_cast<unsigned char>(letter[1]) < 0x9F)
            all.back() = static_cast<char>(letter[1] + 0x20);  // a capital of Latin-1
    }
    return all;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; }

using Words = std::vector<std::string>;

/// The runs of letters in \p text, in lower case.
Words words_of(std::string_view text) {
    Words words;
    bool inside = false;
    for (const char c : plain_text(text)) {
        if (is_letter(c) && !inside) words.emplace_back();
        inside = is_letter(c);
        if (inside) words.back() += c;
    }
    return words;
}

template <std::size_t... N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>&... lists) {
    return (is_one_of_words(word, lists) || ...);
}
template <std::size_t... N>
bool any_of(const Words& words, const std::array<std::string_view, N>&... lists) {
    return std::any_of(words.begin(), words.end(), [&](const auto& word) { return is_one_of(word, lists...); });
}

bool is_factor_word(std::string_view word) {
    if (is_one_of_words(word, factor_words)) return true;
    return std::any_of(factor_prefixes.begin(), factor_prefixes.end(), [&](std::string_view prefix) {
        return word.size() > prefix.size() && word.starts_with(prefix) && is_factor_word(word.substr(prefix.size()));
    });
}

/// Whether each of \p words is of the heights, a filler or one that passes \p more.
template <class More>
bool are_of_heights(const Words& words, const More& more) {
    return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
        return is_one_of(word, upward_words, value_words, filler_words) || more(word);
    });
}

/// Whether \p words state a turn of the heights.
bool states_turn(const Words& words) {
    return any_of(words, inversion_words) || (any_of(words, turn_words) && any_of(words, upward_words, value_words));
}

/// A number of \p text in lower case, from \p place on, that no letter is glued to in front.
struct TitleNumber {
    double value{};
    std::size_t begin{}, end{};
};
std::vector<TitleNumber> numbers_in(const std::string& text) {
    std::vector<TitleNumber> numbers;
    for (std::size_t i = 0; i < text.size();) {
        const LeadingNumber number =
            is_digit(text[i]) || (text[i] == '.' && i + 1 < text.size() && is_digit(text[i + 1]))
                ? leading_number(std::string_view(text).substr(i))
                : LeadingNumber{};
        if (number.status == NumberStatus::ok) numbers.push_back({number.value, i, i + number.length});
        i += (std::max)(number.length, std::size_t{1});
    }
    return numbers;
}

/// \p title in lower case with blanks in place of the brackets that hold a unit.
std::string without_units(std::string_view title) {
    const std::string plain = plain_text(unquoted(title));
    std::string text = plain;
    for (const Bracket& bracket : brackets_in(plain)) {
        text[bracket.begin] = text[bracket.end - 1] = ' ';
        const std::size_t length = bracket.end - bracket.begin;
        if (is_unit(bracket.inside, Dimension::length)) text.replace(bracket.begin, length, length, ' ');
    }
    return text;
}

/// Whether \p text, a title of heights, has a sign of multiplication or division next to \p number; an x counts as one
/// where it is a word of its own.
bool has_sign(const std::string& text, const TitleNumber& number, bool heights) {
    const std::string_view before = trimmed(std::string_view(text).substr(0, number.begin)),
                           after = trimmed(std::string_view(text).substr(number.end));
    if (before.ends_with('*') || after.starts_with('*') || after.starts_with('^')) return true;
    if (before.ends_with('/')) {  // not "1/3"
        const std::string_view divided = trimmed(before.substr(0, before.size() - 1));
        return !divided.empty() && !is_digit(divided.back());
    }
    if (!heights) return false;  // "Profile X 2" are positions
    if (before.size() > 1 && before.ends_with('x') && !is_letter(before[before.size() - 2])) {
        const std::string_view multiplied = trimmed(before.substr(0, before.size() - 1));
        return !multiplied.empty() && !is_digit(multiplied.back());
    }
    const bool glued = number.end < text.size() && text[number.end] == 'x';
    return after.starts_with('x') && (glued || before.empty()) &&
           (after.size() == 1 || (!is_letter(after[1]) && !is_digit(trimmed(after.substr(1))[0])));
}

/// Whether \p first and \p next are "1:10", "10:1" or "1/10" in \p text.
bool is_ratio(const std::string& text, const TitleNumber& first, const TitleNumber& next) {
    const std::string_view sign = trimmed(std::string_view(text).substr(first.end, next.begin - first.end));
    if (sign == "/") return first.value == 1 && (next.value == 10 || next.value == 100 || next.value == 1000);
    return sign == ":" && (first.value == 1) != (next.value == 1);
}

}  // namespace

bool names_depth(std::string_view title) {
    const std::string text = plain_text(trimmed(unquoted(title)));
    const auto words = words_of(text);
    const bool minus = text.size() > 1 && text[0] == '-' && is_letter(text[1]);
    const bool turned = minus || states_turn(words) || (words.size() > 1 && words.front() == "minus");
    return turned != (any_of(words, depth_words) && !any_of(words, upward_words));
}

bool has_factor(std::string_view title, bool heights) {
    const std::string text = without_units(title);
    const auto words = words_of(text);
    const bool named = std::any_of(words.begin(), words.end(), is_factor_word) || any_of(words, times_words);
    const auto numbers = numbers_in(text);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const TitleNumber& number = numbers[i];
        if (i + 1 < numbers.size() && is_ratio(text, number, numbers[i + 1])) return true;
        if (number.value == 1) continue;
        if (has_sign(text, number, heights)) return true;
        if (number.begin > 0 && is_letter(text[number.begin - 1])) continue;  // "z2"
        if (named || text.substr(number.begin, number.end - number.begin).find('e') != std::string::npos) return true;
        if (trimmed(text.substr(0, number.begin)).empty() && text.substr(number.end, 1) == "z") return true;  // "10z"
    }
    return false;
}

namespace {

/// The factor that fills \p text: "10", "x10", "10 x", "10x", "10-fold", "1:10", "1/10", "50 %".
std::optional<double> factor_in(std::string_view written) {
    const std::string all = plain_text(written);
    std::string_view text = trimmed(all);
    while (!text.empty() && (text.front() == 'x' || text.front() == '*')) text = trimmed(text.substr(1));
    const LeadingNumber number = leading_number(text);
    if (number.status != NumberStatus::ok || !(number.value > 0)) return {};
    std::string_view rest = trimmed(text.substr(number.length));
    if (rest.starts_with(':') || rest.starts_with('/')) {
        const auto below = number_in(trimmed(rest.substr(1)), false);
        return below && *below > 0 ? std::optional(number.value / *below) : std::nullopt;
    }
    if (rest.starts_with('-')) rest.remove_prefix(1);
    if (rest == "%") return number.value / 100;
    const bool alone = rest.empty() || rest == "x" || rest == "*" || is_one_of_words(rest, times_words);
    return alone ? std::optional(number.value) : std::nullopt;
}

/// A line without a key, cut into its words and the number in it: "vertical magnification 10x", "10x magnified"; also a
/// key that ends with a number, which the colon of "1:10" made.
HeaderEntry with_number_as_value(const HeaderEntry& entry) {
    const std::string text = plain_text(entry.key.empty() ? entry.value : entry.key);
    const auto numbers = numbers_in(text);
    if (numbers.empty()) return {};
    std::size_t begin = numbers.front().begin, end = numbers.back().end;
    while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '*')) --begin;
    if (begin > 1 && text[begin - 1] == 'x' && text[begin - 2] == ' ') --begin;
    const std::size_t sign = (std::min)(text.find_first_not_of(' ', end), text.size());
    if (sign < text.size() && text[sign] == 'x') end = sign + 1;
    std::string value = text.substr(begin, end - begin) + (entry.key.empty() ? "" : ":" + entry.value);
    if (numbers.front().value == 0 && !entry.key.empty()) value = "0." + entry.value;  // the comma of "0,1"
    if (number_in(trimmed(value), true)) std::replace(value.begin(), value.end(), ',', '.');
    return {text.substr(0, begin) + " " + text.substr(end), value, entry.line};
}

}  // namespace

std::optional<double> height_factor(const HeaderEntry& entry) {
    if (entry.key.size() + entry.value.size() > 100) return {};
    const bool cut = entry.key.empty() || is_digit(entry.key.back());
    const HeaderEntry stated = cut ? with_number_as_value(entry) : entry;
    const auto words = words_of(stated.key);
    if (entry.key.starts_with("height conversion factor") ||  // has a unit
        !are_of_heights(words, [](const auto& word) {
            return word == "conversion" || is_one_of_words(word, times_words) || is_factor_word(word);
        }))
        return {};
    if (!std::any_of(words.begin(), words.end(), is_factor_word) && !(entry.key.empty() && any_of(words, times_words)))
        return {};
    const auto factor = factor_in(stated.value);
    return factor && std::isfinite(*factor) && *factor != 1 ? factor : std::nullopt;
}

namespace {

/// Whether \p entry states that the heights have the other sign. \throws domain_error where that is not clear.
bool states_inversion(const HeaderEntry& entry, const Words& key, const Words& value, const std::string& name) {
    static constexpr std::array<std::string_view, 12> yes{"yes",  "true", "on", "ja",        "wahr",      "oui",
                                                          "vrai", "si",   "y",  "s\xC3\xAD", "verdadero", "vero"};
    static constexpr std::array<std::string_view, 13> no{"no",   "false", "off", "nein", "falsch", "non",  "faux",
                                                         "none", "n",     "not", "x",    "keine",  "falso"};
    static constexpr std::array<std::string_view, 5> signs{"sign", "vorzeichen", "signe", "signo", "segno"};
    const auto turns = [](const std::string& word) { return is_one_of(word, inversion_words, turn_words); };
    if (entry.key.empty())  // "# heights are inverted"
        return value.size() < 8 && states_turn(value) && are_of_heights(value, turns);
    const auto number = number_in(entry.value, false);
    if (states_turn(key) && are_of_heights(key, turns)) {
        if (number ? *number == 0 : value.empty() || any_of(value, no)) return false;
        if (number ? std::abs(*number) == 1 : any_of(value, yes, upward_words, value_words)) return true;
        refuse_line(name, entry.line,
                    {"states ", shown_cell(entry.key + ": " + entry.value),
                     ", which may be of the heights; must be \"yes\" or \"no\""});
    }
    if (!any_of(key, upward_words, value_words) || !are_of_heights(key, [](const auto&) { return false; }))
        return false;
    if (any_of(value, no) || value.size() > 4) return false;
    const bool negative =
        entry.value == "-" || (number && *number < 0) || (value.size() == 1 && value[0] == "negative");
    return any_of(value, inversion_words, turn_words) || (negative && any_of(key, signs));
}

/// Whether \p entry states that the heights are depths.
bool states_depth(const HeaderEntry& entry, const Words& key, const Words& value) {
    const auto passes = [](const std::string& word) {
        return is_one_of(word, depth_words, unit_words) || is_unit(word, Dimension::length);
    };
    if (any_of(key, unit_words) && any_of(key, depth_words) && are_of_heights(key, passes))
        return is_unit(entry.value, Dimension::length);
    return value.size() < 6 && any_of(value, depth_words) && are_of_heights(value, passes) &&
           are_of_heights(key, [](const std::string& word) { return is_one_of_words(word, content_words); });
}

}  // namespace

void turn_over(RawMap& map, const ColumnTitle& title, const std::vector<HeaderEntry>& entries, const std::string& name,
               Record& record) {
    std::string depth, inversion;
    if (names_depth(title.text))
        depth = "line " + std::to_string(title.line) + ", which states " + shown_cell(title.text);
    const bool named = names_height(title_of(title.text).name);
    for (const HeaderEntry& entry : entries) {
        constexpr std::size_t longest = 100;  // of a line that states something of the heights
        if (entry.line == title.line || entry.key.size() + entry.value.size() > longest) continue;
        const Words key = words_of(entry.key);
        if (!are_of_heights(key, [](const std::string& word) {
                return is_one_of(word, inversion_words, turn_words, depth_words, unit_words, content_words);
            }))
            continue;
        const Words value = words_of(entry.value);
        if (inversion.empty() && states_inversion(entry, key, value, name)) inversion = shown_line(entry);
        if (depth.empty() && !named && states_depth(entry, key, value)) depth = shown_line(entry);
    }
    if (!depth.empty() && !inversion.empty())
        refuse_file(name,
                    {"turns its heights over twice, by ", depth, ", and by ", inversion, "; must be one of them"});
    const std::string& why = depth.empty() ? inversion : depth;
    if (why.empty()) return;
    record.warnings.push_back("the heights are the numbers with the other sign, by " + why);
    for (double& height : map.heights) height = -height;
}

}  // namespace fstiff::inline v0_1::io::detail
