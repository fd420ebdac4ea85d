// SPDX-License-Identifier: BSD-3-Clause
#include "input/description.hpp"

#include <string_view>

namespace fstiff::cli {
namespace {

std::string replaced(std::string text, std::string_view what, std::string_view by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

std::string joined(const std::vector<std::string>& words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? std::string() : std::string(between)) + word;
    return text;
}

/// Whether no word or file can be offered.
bool is_number(const DescribedOption& option) {
    return option.type == "INT" || option.type == "UINT" || option.type == "FLOAT";
}

std::vector<std::string> names_of(const DescribedCommand& command) {
    std::vector<std::string> names;
    for (const DescribedOption& option : command.options)
        if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
    return names;
}

std::vector<std::string> names_of(const std::vector<DescribedCommand>& commands) {
    std::vector<std::string> names;
    for (const DescribedCommand& command : commands) names.push_back(command.name);
    return names;
}

/// The words that an argument without a dash may be; none where it may be a file.
std::vector<std::string> words_of(const DescribedCommand& command) {
    for (const DescribedOption& option : command.options)
        if (option.positional && !option.choices.empty()) return option.choices;
    return {};
}

/// The cases of one command in the script for bash: values of options first, then options and words.
std::string bash_cases(const DescribedCommand& command) {
    std::string text;
    const auto pattern = [&](const DescribedOption& option) {
        std::vector<std::string> patterns;
        for (const std::string& name : option.names) patterns.push_back(command.name + ":" + name);
        return "    " + joined(patterns, " | ") + ") ";
    };
    for (const DescribedOption& option : command.options) {
        if (option.positional || option.type.empty()) continue;
        if (!option.choices.empty())
            text += pattern(option) + "words='" + joined(option.choices, " ") + "' ;;\n";
        else if (is_number(option))
            text += pattern(option) + "compopt +o default 2>/dev/null; return ;;\n";
        else
            text += pattern(option) + "return ;;\n";
    }
    text += "    " + command.name + ":*) options='" + joined(names_of(command), " ") + "'";
    if (const auto words = words_of(command); !words.empty()) text += " words='" + joined(words, " ") + "'";
    return text + " ;;\n";
}

/// A pair "option", "=", as bash splits it, is read as one; where nothing is offered bash offers files.
std::string bash(const DescribedProgram& program) {
    std::string text = R"(_fstiff() {
    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words= options=
    COMPREPLY=()
    if [ "$current" = '=' ]; then
        current=
    elif [ "$before" = '=' ] && [ "$COMP_CWORD" -gt 2 ]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    local place=${COMP_WORDS[1]}:$before
    [ "$COMP_CWORD" -gt 1 ] || place=
    case $place in
)";
    text += "    '') words='" + joined(names_of(program.commands), " ") + "' options='" +
            joined(names_of(program.whole), " ") + "' ;;\n";
    for (const DescribedCommand& command : program.commands) text += bash_cases(command);
    text += R"(    esac
    case $current in
    -*) words=$options ;;
    esac
    COMPREPLY=($(compgen -W "$words" -- "$current"))
}
complete -o default -F _fstiff fstiff
)";
    return replaced(text, "_fstiff", "_" + program.whole.name);
}

}  // namespace

std::string completion_script(const DescribedProgram& program) {
    return "# Completion for " + program.version + ", printed by " + program.whole.name + " help --completion bash.\n" +
           bash(program);
}

}  // namespace fstiff::cli
