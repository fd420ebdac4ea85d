// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The command line. CLI11 parses it, which arguments.cpp alone includes.

#include "document/output.hpp"

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

/// The options of a command; they write into the targets, which must live as long as the program parses.
class Arguments {
public:
    explicit Arguments(CLI::App& app) : app_(&app) {}

    /// \p target: a text, a list of texts, an int, a whole number that is not negative, a double, or an optional one.
    template <class Target>
    Option option(const std::string& name, Target& target, const std::string& help);
    /// \p take is called with what was given.
    Option option(const std::string& name, const std::function<void(const std::string&)>& take,
                  const std::string& help);
    /// One of the words of \p Enum.
    template <parts::NamedEnum Enum>
    Option option(const std::string& name, Enum& target, const std::string& help) {
        return word<Enum>(name, target, help);
    }
    template <parts::NamedEnum Enum>
    Option option(const std::string& name, std::optional<Enum>& target, const std::string& help) {
        return word<Enum>(name, target, help);
    }
    /// A quantity that keeps its text.
    template <std::constructible_from<std::string> Quantity>
    Option option(const std::string& name, Quantity& target, const std::string& help) {
        const std::function<void(const std::string&)> take = [&target](const std::string& text) { target = text; };
        return option(name, take, help);
    }
    void flag(const std::string& name, bool& target, const std::string& help);

private:
    template <parts::NamedEnum Enum, class Target>
    Option word(const std::string& name, Target& target, const std::string& help) {
        const std::function<void(const std::string&)> take = [&target](const std::string& word) {
            target = *parts::find_named<Enum>(word);
        };
        return option(name, take, help).one_of(parts::choices<Enum>());
    }

    CLI::App* app_;
};

/// What a command does once its options are parsed, and where its document goes.
struct Command {
    const OutputOptions* output;
    std::function<Report()> execute;
    std::vector<std::string> texts{};  ///< values of options that may be names of files
};

/// A command.
struct CommandRow {
    const char* name;             ///< a word; further ones are an option of this word that makes another command of it
    const char* group;            ///< its heading in --help; empty: it is not listed
    const char* summary;          ///< its line there
    const char *notes, *example;  ///< below its options
    Command (*add)(Arguments&);   ///< adds its options
};
/// A name of former times, and the sentence that gives the call which took its place.
struct OldName {
    std::string_view name, now;
};

/// The command line of the program, all of its commands; the options of the one that is called.
class Program {
public:
    Program(const std::string& name, const std::string& version, const std::string& description,
            const std::string& footer, std::span<const CommandRow> commands, std::span<const OldName> old_names);
    ~Program();
    /// The command that was asked for; none after --help, help, no argument at all (the help too), --version, -V and
    /// version, which print.
    /// \throws Usage in one sentence that names the help to look at; for an argument that is empty, too, as one of a
    /// script whose variable is not set.
    [[nodiscard]] std::optional<Command> parse(std::vector<std::string> words);

private:
    struct Help;
    void add_help();
    /// Joins the words from \p first on that name a command, as measure --show fit does.
    void join(std::vector<std::string>& words, std::size_t first) const;
    /// Adds the options of the command \p name. \throws Usage where it is none.
    [[nodiscard]] Command add_options(const std::string& name);
    /// The manual page or the script of completion that was asked for.
    void print_help();

    std::unique_ptr<CLI::App> app_;
    std::unique_ptr<Help> help_;
    std::string version_;
    std::span<const CommandRow> commands_;
    std::span<const OldName> old_names_;
};

}  // namespace fstiff::cli
