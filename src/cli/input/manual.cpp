// SPDX-License-Identifier: BSD-3-Clause
#include "input/description.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string_view>

namespace fstiff::cli {
namespace {

/// The UTF-8 character at \p at of \p text as \[uXXXX]; moves \p at to its last byte.
std::string beyond_ascii(std::string_view text, std::size_t& at) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
    unsigned code = lead & (0x3FU >> more);
    for (int i = 0; i < more && at + 1 < text.size(); ++i)
        code = code << 6 | (static_cast<unsigned char>(text[++at]) & 0x3FU);
    char number[16];
    std::snprintf(number, sizeof number, "\\[u%04X]", code);
    return number;
}

/// \p text as roff prints it, letter by letter; a line of it must not begin with what roff takes for a command.
std::string roff(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool begins = i == 0 || text[i - 1] == '\n';
        if (begins && (c == '.' || c == '\'')) out += "\\&";
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if (c == '^')
            out += "\\(ha";
        else if (c == '~')
            out += "\\(ti";
        else if (c == '`')
            out += "\\(ga";
        else if (c == '\'')
            out += "\\(aq";
        else if (static_cast<unsigned char>(c) >= 0x80)
            out += beyond_ascii(text, i);
        else
            out += c;
    }
    return out;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

/// "one|two", or the type.
std::string value_of(const DescribedOption& option) {
    if (option.choices.empty()) return italic(option.type);
    std::string words;
    for (const std::string& choice : option.choices) words += (words.empty() ? "" : "|") + bold(choice);
    return words;
}

std::string entry(const DescribedOption& option) {
    std::string tag;
    if (option.positional) {
        tag = italic(option.names.front()) + (option.many ? " ..." : "");
        if (!option.choices.empty()) tag += " " + value_of(option);
    } else {
        for (const std::string& name : option.names) tag += (tag.empty() ? "" : ", ") + bold(name);
        if (!option.type.empty()) tag += " " + value_of(option);
    }
    std::string text = ".TP\n" + tag + "\n" + roff(option.help.empty() ? "one of these words" : option.help);
    if (!option.range.empty()) text += "; " + roff(option.range);
    if (option.required) text += " (required)";
    return text + "\n";
}

std::string entries(const DescribedCommand& command, bool positional) {
    std::string text;
    for (const DescribedOption& option : command.options)
        if (option.positional == positional) text += entry(option);
    return text;
}

std::string synopsis(const DescribedProgram& program, const DescribedCommand* command) {
    std::string text = bold(program.whole.name);
    if (!command) return text + " " + italic("COMMAND") + " [" + italic("OPTION") + " ...]\n";
    text += " " + bold(command->name) + " [" + italic("OPTION") + " ...]";
    for (const DescribedOption& option : command->options)
        if (option.positional) {
            const std::string name = italic(option.names.front()) + (option.many ? " ..." : "");
            text += option.required ? " " + name : " [" + name + "]";
        }
    return text + "\n";
}

/// What stands below the options of --help: sentences are filled, lines that are set in stay as they are, and the line
/// "Example:" begins a section.
std::string notes(std::string_view footer) {
    std::string text;
    bool kept = false, filled = false;  // inside set-in lines; whether the section holds anything
    while (!footer.empty()) {
        const std::size_t end = std::min(footer.find('\n'), footer.size());
        const std::string_view line = footer.substr(0, end);
        footer.remove_prefix(std::min(end + 1, footer.size()));
        const bool keep = line.starts_with("  ");
        if (kept && !keep) text += ".EE\n";
        if (line == "Example:") {
            text += ".SH EXAMPLE\n";
            filled = false;
        } else {
            if (keep != kept && filled) text += ".PP\n";
            if (keep && !kept) text += ".EX\n";
            text += roff(line) + "\n";
            filled = true;
        }
        kept = keep;
    }
    return text + (kept ? ".EE\n" : "");
}

std::string section(const std::string& name, const std::string& text) {
    return text.empty() ? "" : ".SH " + name + "\n" + text;
}

}  // namespace

std::string manual_page(const DescribedProgram& program, const DescribedCommand* command) {
    const DescribedCommand& page = command ? *command : program.whole;
    const std::string name = command ? program.whole.name + "-" + command->name : program.whole.name;
    std::string title = name;
    std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) { return std::toupper(c); });

    std::string text =
        ".TH " + roff(title) + " 1 \"\" \"" + program.version + "\" \"Manual of " + program.whole.name + "\"\n";
    const std::string_view description = page.description;
    const std::size_t stop = description.ends_with('.') ? 1 : 0;
    text += section("NAME", roff(name) + " \\- " + roff(description.substr(0, description.size() - stop)) + "\n");
    text += section("SYNOPSIS", synopsis(program, command));
    text += section("ARGUMENTS", entries(page, true));
    text += section("OPTIONS", entries(page, false));
    std::string also;
    if (!command) {
        std::string list;
        for (const DescribedCommand& one : program.commands) {
            list += ".TP\n" + bold(one.name) + "\n" + roff(one.description) + "\n";
            also += (also.empty() ? "" : ",\n") + bold(name + "-" + one.name) + "(1)";
        }
        text += section("COMMANDS", list);
    } else {
        also = bold(program.whole.name) + "(1): units, exit codes, all commands";
    }
    const std::string below = notes(page.footer);
    text += below.starts_with(".SH") ? below : section("NOTES", below);
    return text + section("SEE ALSO", also + "\n");
}

}  // namespace fstiff::cli
