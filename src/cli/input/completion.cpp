// SPDX-License-Identifier: BSD-3-Clause
#include "input/description.hpp"

#include <algorithm>
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

/// The first clause of a help.
std::string brief(const std::string& help) {
    return help.substr(0, std::min({help.find("; "), help.find(": "), help.find(", such as")}));
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

bool takes_files(const DescribedCommand& command) {
    return std::any_of(command.options.begin(), command.options.end(),
                       [](const DescribedOption& option) { return option.positional && option.choices.empty(); });
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

std::string zsh_quoted(const std::string& text) { return "'" + replaced(text, "'", "'\\''") + "'"; }

std::string zsh_explained(const std::string& help) {
    return "[" + replaced(replaced(replaced(brief(help), "\\", "\\\\"), "[", "\\["), "]", "\\]") + "]";
}

/// What follows the message of a specification of _arguments.
std::string zsh_action(const DescribedOption& option) {
    if (!option.choices.empty()) return "(" + joined(option.choices, " ") + ")";
    return is_number(option) ? " " : "_files";
}

std::string zsh_command(const DescribedCommand& command) {
    std::string text = "    " + command.name + ")\n        _arguments";
    for (const DescribedOption& option : command.options) {
        text += " \\\n            ";
        if (option.positional) {
            text += zsh_quoted((option.many ? "*:" : "1:") + option.names.front() + ":" + zsh_action(option));
            continue;
        }
        std::vector<std::string> specifications;
        for (const std::string& name : option.names) {
            std::string one = option.names.size() > 1 ? "(" + joined(option.names, " ") + ")" : "";
            one += name;
            if (!option.type.empty()) one += name.starts_with("--") ? "=" : "+";
            one += zsh_explained(option.help);
            if (!option.type.empty()) one += ":" + replaced(option.type, ":", "\\:") + ":" + zsh_action(option);
            specifications.push_back(zsh_quoted(one));
        }
        text += joined(specifications, " ");
    }
    return text + "\n        ;;\n";
}

std::string zsh(const DescribedProgram& program) {
    std::string text = "    local -a commands\n    commands=(\n";
    for (const DescribedCommand& command : program.commands)
        text += "        " + zsh_quoted(command.name + ":" + command.description) + "\n";
    text += "    )\n    _arguments -C";
    for (const DescribedOption& option : program.whole.options)
        for (const std::string& name : option.names) text += " " + zsh_quoted(name + zsh_explained(option.help));
    text += R"( '1:command:->command' '*::argument:->argument'
    case $state in
    command)
        _describe command commands
        return
        ;;
    esac
    case $words[1] in
)";
    for (const DescribedCommand& command : program.commands) text += zsh_command(command);
    text += "    esac\n";
    const std::string name = "_" + program.whole.name;
    return "#compdef " + program.whole.name + "\n" + name +
           "() {\n    local curcontext=$curcontext state line\n    typeset -A opt_args\n" + text +
           "}\nif [ \"$funcstack[1]\" = " + name + " ]; then\n    " + name + " \"$@\"\nelse\n    compdef " + name +
           " " + program.whole.name + "\nfi\n";
}

std::string fish_quoted(const std::string& text) {
    return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
}

std::string fish_option(const DescribedOption& option) {
    std::string text;
    for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (!option.choices.empty())
        text += " -x -a " + fish_quoted(joined(option.choices, " "));
    else if (is_number(option))
        text += " -x";
    else if (!option.type.empty())
        text += " -r -F";
    return text + " -d " + fish_quoted(brief(option.help)) + "\n";
}

std::string fish(const DescribedProgram& program) {
    const std::string complete = "complete -c " + program.whole.name;
    std::string text = complete + " -f\n";
    for (const DescribedOption& option : program.whole.options)
        text += complete + " -n __fish_use_subcommand" + fish_option(option);
    for (const DescribedCommand& command : program.commands) {
        text += complete + " -n __fish_use_subcommand -a " + command.name + " -d " + fish_quoted(command.description) +
                "\n";
        const std::string here = complete + " -n '__fish_seen_subcommand_from " + command.name + "'";
        if (const auto words = words_of(command); !words.empty())
            text += here + " -a " + fish_quoted(joined(words, " ")) + "\n";
        else if (takes_files(command))
            text += here + " -F\n";
        for (const DescribedOption& option : command.options)
            if (!option.positional) text += here + fish_option(option);
    }
    return text;
}

}  // namespace

std::string completion_script(const DescribedProgram& program, const std::string& shell) {
    const std::string origin = "# Completion for " + program.version + ", printed by " + program.whole.name +
                               " help --completion " + shell + ".\n";
    if (shell == "bash") return origin + bash(program);
    if (shell == "fish") return origin + fish(program);
    const std::string text = zsh(program);  // its first line must stay the first
    const std::size_t second = text.find('\n') + 1;
    return text.substr(0, second) + origin + text.substr(second);
}

}  // namespace fstiff::cli
