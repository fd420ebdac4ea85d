// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The command line. CLI11 parses it, which arguments.cpp alone includes.

#include <fstiff/core/names.hpp>

#include <concepts>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fstiff::cli {

/// Further properties of one option.
class Option {
public:
    explicit Option(CLI::Option* option) : option_(option) {}
    Option& required();
    Option& type_name(const std::string& name);
    Option& one_of(std::span<const std::string_view> values);
    Option& one_of(std::initializer_list<const char*> values);
    Option& one_of(std::initializer_list<int> values);
    Option& between(int least, int greatest);
    Option& between(double least, double greatest);
    Option& between(std::uint64_t least, std::uint64_t greatest);
    /// Several values in one argument, with \p separator between them.
    Option& delimiter(char separator);
    /// Shows the present value of the target as the default in the help.
    Option& show_default();

private:
    CLI::Option* option_;
};

/// A subcommand; options write into the targets, which must live as long as the program parses.
class Arguments {
public:
    Arguments(CLI::App& program, const std::string& name, const std::string& description);

    /// \p target: a text, a list of texts, an int, a whole number that is not negative, a double, or an optional one.
    template <class Target>
    Option option(const std::string& name, Target& target, const std::string& help);
    /// \p take is called with what was given.
    Option option(const std::string& name, const std::function<void(const std::string&)>& take,
                  const std::string& help);
    /// One of the words of \p Enum.
    template <parts::NamedEnum Enum>
    Option option(const std::string& name, Enum& target, const std::string& help) {
        const std::function<void(const std::string&)> take = [&target](const std::string& word) {
            target = *parts::find_named<Enum>(word);
        };
        return option(name, take, help).one_of(parts::choices<Enum>());
    }
    /// A quantity that keeps its text.
    template <std::constructible_from<std::string> Quantity>
    Option option(const std::string& name, Quantity& target, const std::string& help) {
        const std::function<void(const std::string&)> take = [&target](const std::string& text) { target = text; };
        return option(name, take, help);
    }
    void flag(const std::string& name, bool& target, const std::string& help);
    /// Below the list of options.
    void footer(const std::string& text);

    [[nodiscard]] CLI::App* app() const { return app_; }

private:
    CLI::App* app_;
};

/// Values of the options of \p command that take any text, except its outputs; files are among them.
[[nodiscard]] std::vector<std::string> given_texts(const CLI::App& command);

/// The command line of the program, all of its subcommands.
class Program {
public:
    Program(const std::string& name, const std::string& version, const std::string& description,
            const std::string& footer);
    ~Program();
    [[nodiscard]] CLI::App& app() { return *app_; }
    /// Puts \p command under the heading \p group of --help; empty: it is known and not listed.
    void list_under(CLI::App& command, const std::string& group);
    /// \p command with the words \p ways, which may be "--option" and its value, is the command \p to: its options and
    /// help.
    void forward(const std::string& command, const std::vector<std::string>& ways, const std::string& to);
    /// The subcommand that was asked for; null after --help, help, no argument at all (the help too), --version, -V and
    /// version, which print.
    /// \throws Usage in one sentence that names the help to look at; for an argument that is empty, too, as one of a
    /// script whose variable is not set.
    [[nodiscard]] const CLI::App* parse(std::vector<std::string> words);

private:
    struct Help;
    struct Forwarded {
        std::string command;
        std::vector<std::string> ways;
        std::string to;
    };
    void add_help();
    /// The words of the command line with forwarded commands in place of the others.
    void redirect(std::vector<std::string>& words) const;
    /// \throws Usage where \p word is not a command.
    void require_command(const std::string& word) const;
    /// The manual page or the script of completion that was asked for.
    void print_help() const;

    std::unique_ptr<CLI::App> app_;
    std::unique_ptr<Help> help_;
    std::string version_;
    std::vector<Forwarded> forwarded_;
};

}  // namespace fstiff::cli
