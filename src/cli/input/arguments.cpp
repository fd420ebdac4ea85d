// SPDX-License-Identifier: BSD-3-Clause
#include "input/arguments.hpp"

#include "document/output.hpp"

#include <fstiff/core/text.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <sstream>
#include <system_error>

namespace fstiff::cli {

extern const char* const bash_completion;  // of input/completion.bash

namespace {

/// Names of all commands, or of those that --help lists.
std::vector<std::string> command_names(const CLI::App& program, bool listed = false) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        if (!listed || !command->get_group().empty()) names.push_back(command->get_name());
    return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

/// The sentence about a word that is not a subcommand of \p program.
Usage no_command(const CLI::App& program, const std::string& word) {
    std::string names;
    for (const std::string& name : command_names(program, true)) names += (names.empty() ? "" : ", ") + name;
    return Usage(word + ": is not a subcommand or option; must be one of " + names +
                 document::suggestion(word, word.starts_with("-") ? option_names(program) : command_names(program)) +
                 "; see " + program.get_name() + " --help");
}

bool is_existing_file(const std::string& word) {
    std::error_code none;
    return std::filesystem::exists(document::path_of(word), none);
}

/// The option of \p known that a scene calls otherwise: --impedance2 is ultrasound.lower.impedance there. Empty: none.
std::string option_of_side(const std::string& word, const std::vector<std::string>& known) {
    for (const auto& [side, end] : {std::pair("lower", "2"), std::pair("upper", "")})
        for (const std::string& option : known)
            if (option.ends_with(end) && option.size() > 3) {
                const std::string key = option.substr(2, option.size() - 2 - std::string_view(end).size());
                if (word == std::string("--") + side + "-" + key || word == "--" + key + "-" + side) return option;
            }
    return "";
}

/// The sentence about what CLI11 refused.
Usage refusal(const CLI::App& program, const CLI::ParseError& error) {
    const auto chosen = program.get_subcommands();
    const auto unknown = program.remaining(true);
    if (chosen.empty() && !unknown.empty()) return no_command(program, unknown.front());
    std::string text = error.what(), help = program.get_name();
    if (const std::size_t flag = text.find(" was given a disallowed flag override"); flag != text.npos)
        text = "--" + text.substr(0, flag) + " takes no value; must be given without =";
    if (!chosen.empty()) {
        help += " " + chosen.front()->get_name();
        if (!unknown.empty() && unknown.front().starts_with("-") && is_existing_file(unknown.front()))
            text += " (" + unknown.front() + " begins with - as an option does; such a file is given as ./" +
                    unknown.front() + ")";
        else if (!unknown.empty() && unknown.front().starts_with("--")) {
            const std::string word = unknown.front().substr(0, unknown.front().find('='));
            const std::vector<std::string> known = option_names(*chosen.front());
            const std::string meant = option_of_side(word, known);
            text += meant.empty() ? document::suggestion(word, known) : " (did you mean " + meant + "?)";
        }
    }
    return Usage(text + "; see " + help + " --help");
}

void refuse_empty(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const bool option_alone = word.starts_with("--") && word.find('=') == word.size() - 1;  // --plot=
        if (!word.empty() && !option_alone) continue;
        throw Usage("the argument " +
                    (option_alone ? word
                     : i > 0      ? "after " + words[i - 1]
                                  : "") +
                    " is empty; leave it out or give a value");
    }
}

}  // namespace

namespace {

/// The items of \p list as one text with commas between them, whose parts are read then.
request::Value joined(const request::Value& list) {
    request::Value text;
    for (const request::Value& item : list.items) text.written += (text.written.empty() ? "" : ",") + item.written;
    return text;
}

}  // namespace

void Arguments::add(const std::string& name, const request::Field& field, const Target& target) {
    using request::Value;
    const auto taken = [field, key = name.substr(name.find(',') + 1), put = target.put,
                        member = target.member](const Value& value) {
        try {
            put(value, member, key, field);
        } catch (const domain_error& error) {
            throw CLI::ValidationError(error.what());
        }
    };
    const bool several = std::string_view(target.kind) == "TEXT ...", are_files = field.form == request::Form::file;
    CLI::Option* option =
        several ? app_->add_option_function<std::vector<std::string>>(
                      name,
                      [taken, are_files](const std::vector<std::string>& texts) {
                          Value list{.kind = Value::Kind::list};
                          for (const std::string& text : texts) list.items.push_back({.written = text});
                          taken(are_files ? list : joined(list));
                      },
                      field.help)
                : app_->add_option_function<std::string>(
                      name, [taken](const std::string& text) { taken(Value::of_text(text, Value::Giver::command)); },
                      field.help);
    std::string type(several ? "TEXT" : target.kind), words;
    if (field.has_range())
        type += ":" + type + " in [" + request::Field::text_of(field.low) + " - " +
                request::Field::text_of(field.high) + "]";
    if (!field.type.empty()) type = field.type;
    for (const std::string_view word : target.words.empty() ? field.words : target.words)
        words += (words.empty() ? "" : ",") + std::string(word);
    option->type_name(type + (words.empty() ? "" : ":{" + words + "}"));
    option->required(field.required)->group(group_);
    if (field.shows_default) option->default_str(target.initial);
}
void Arguments::flag(const std::string& name, bool& to, const std::string& help) {
    app_->add_flag_function(
            name, [&to, name](std::int64_t) { to = true; }, help)
        ->disable_flag_override()
        ->group(group_);
}

void Arguments::word_or_flag(const std::string& name, std::optional<std::string>& to,
                             const std::vector<std::string>& words, const std::string& help) {
    std::string type;
    for (const std::string& word : words) type += (type.empty() ? "NAME:{" : ",") + word;
    const auto take = [&to, name, words](const std::string& word) {
        if (!word.empty() && std::find(words.begin(), words.end(), word) == words.end())
            throw CLI::ValidationError(
                name + " = \"" + word + "\": must be one of " +
                document::list_and_suggestion(word, std::vector<std::string_view>(words.begin(), words.end())));
        to = word;
    };
    app_->add_option_function<std::string>(name, take, help)->expected(0, 1)->type_name(type + "}")->group(group_);
}

namespace {

/// Values of the options of \p command that take any text, except its outputs; files are among them.
std::vector<std::string> given_texts(const CLI::App& command) {
    std::vector<std::string> texts;
    for (const CLI::Option* option : command.get_options()) {
        const bool is_choice = option->get_type_name().find('{') != std::string::npos;
        if (is_choice || option->check_lname("output") || option->check_lname("plot")) continue;
        const std::vector<std::string> given = option->results();
        texts.insert(texts.end(), given.begin(), given.end());
    }
    return texts;
}

}  // namespace

namespace {

/// The help with one blank line between groups, where CLI11 has two.
struct OneBlankLine : CLI::Formatter {
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
        for (std::size_t at = 0; (at = help.find("\n\n\n", at)) != help.npos;) help.erase(at, 1);
        return help;
    }
};

}  // namespace

Program::Program(const std::string& name, const std::string& version, const std::string& description,
                 const std::string& footer, std::span<const CommandRow> commands, std::span<const HelpTopic> topics,
                 std::span<const OldName> old_names)
    : app_(std::make_unique<CLI::App>(description, name)),
      version_(version),
      commands_(commands),
      topics_(topics),
      old_names_(old_names) {
    app_->formatter(std::make_shared<OneBlankLine>());
    app_->set_version_flag("-V,--version", version);
    app_->require_subcommand(1);
    app_->footer(footer);
    for (const CommandRow& row : commands_)
        app_->add_subcommand("command", row.summary)
            ->group(row.group)
            ->name(row.name)  // after add_subcommand(), which takes one word
            ->footer((*row.notes ? row.notes + std::string("\n") : "") + "Example:\n" + row.example);
    add_help();
}
Program::~Program() = default;

void Program::join(std::vector<std::string>& words, std::size_t first) const {
    for (const CommandRow& row : commands_) {
        std::istringstream text(row.name);
        const std::vector<std::string> example{std::istream_iterator<std::string>(text), {}};
        if (example.size() == 1 || words.size() <= first || words[first] != example.front()) continue;
        const auto begin = words.begin() + static_cast<std::ptrdiff_t>(first);
        auto place = std::search(begin, words.end(), example.begin() + 1, example.end());
        auto end = place + (place == words.end() ? 0 : std::ssize(example) - 1);
        if (place == words.end() && example.size() == 3) {  // --option=value
            place = std::find(begin, words.end(), example[1] + "=" + example[2]);
            end = place + (place == words.end() ? 0 : 1);
        }
        if (place == words.end()) continue;
        words.erase(place, end);
        words[first] = row.name;
        return;
    }
}

Command Program::add_options(const std::string& name) {
    for (const auto& [old, now] : old_names_)
        if (name == old) throw Usage(name + ": " + std::string(now));
    const auto row =
        std::find_if(commands_.begin(), commands_.end(), [&](const auto& command) { return command.name == name; });
    if (row == commands_.end()) throw no_command(*app_, name);
    Arguments arguments(*app_->get_subcommand(name));
    return row->add(arguments);
}

/// The command help: `help COMMAND` is COMMAND --help.
struct Program::Help {
    CLI::App* app;
    std::string command, shell;
    bool man = false;
};

void Program::add_help() {
    help_ = std::make_unique<Help>();
    Help& help = *help_;
    std::string names, listed;
    for (const HelpTopic& topic : topics_) {
        names += (names.empty() ? "" : ",") + std::string(topic.name);
        listed += (listed.empty() ? "" : ", ") + std::string(topic.name);
    }
    help.app = app_->add_subcommand(
        "help", "The options of a command, as its --help prints them; " + listed + "; manual pages");
    help.app->group("Help");
    help.app->add_option("command", help.command, "name of a command or of a table; without it the commands are listed")
        ->type_name("NAME:{" + names + "}");
    CLI::Option* const man =
        help.app->add_flag("--man", help.man, "print the manual page, for man -l -, instead of the options");
    help.app
        ->add_option("--completion", help.shell,
                     "print the script by which bash completes fstiff; it is read by source")
        ->check(CLI::IsMember({"bash"}))
        ->type_name("SHELL")
        ->excludes(man);
    help.app->footer("Example:\n  fstiff help run\n  fstiff help materials");
}

void Program::print_help() {
    const std::string &word = help_->command, name = app_->get_name();
    const auto page_of = [&](const std::string& command) {  // measure --show fit: fstiff-measure-fit
        std::string page = name;
        std::istringstream words(command);
        for (std::string part; words >> part;)
            if (part != "--show") page += "-" + part.substr(part.find_first_not_of('-'));
        return page;
    };
    if (!help_->shell.empty()) {
        std::cout << bash_completion;
    } else if (!word.empty()) {
        for (const HelpTopic& topic : topics_)
            if (word == topic.name)
                throw Usage(word + ": has no manual page; fstiff help " + word + " prints the table");
        const auto kept = word == "help" ? std::optional<Command>() : add_options(word);
        std::cout << manual_page(page_of(word), version_, app_->get_subcommand(word)->help(name), {name});
    } else {
        std::vector<std::string> pages = command_names(*app_);
        for (std::string& page : pages) page = page_of(page);
        // not app_->help(), which is that of the command help
        std::string help = app_->get_formatter()->make_help(app_.get(), name, CLI::AppFormatMode::Normal);
        const std::size_t end = help.find("Exit codes:");
        for (const HelpTopic& topic : topics_)
            if (topic.in_manual && end != help.npos) help.insert(end, topic.text());
        std::cout << manual_page(name, version_, help, pages);
    }
}

std::optional<Command> Program::parse(std::vector<std::string> words) {
    refuse_empty(words);
    if (words.empty()) words = {"--help"};
    if (words == std::vector<std::string>{"version"}) words = {"--version"};
    if (words.size() > 1 && (words.front() == "--help" || words.front() == "-h")) words.front() = "help";
    const bool is_help = words.front() == "help";
    join(words, is_help ? 1 : 0);
    for (const HelpTopic& topic : topics_)
        if (is_help && words.size() == 2 && words.back() == topic.name) {
            std::cout << topic.text();
            return std::nullopt;
        }
    if (is_help && (words.size() == 1 || (words.size() == 2 && !words.back().starts_with("-")))) {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    std::optional<Command> command;
    if (const std::string& name = words.front(); !name.starts_with("-") && name != "help") command = add_options(name);
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    try {
        app_->parse(words);
        const CLI::App* const chosen = app_->get_subcommands().front();
        if (chosen == help_->app) return print_help(), std::nullopt;
        command->texts = given_texts(*chosen);
        return command;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) throw refusal(*app_, error);
        app_->exit(error);
        return {};
    }
}

}  // namespace fstiff::cli
