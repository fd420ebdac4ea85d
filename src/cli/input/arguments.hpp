// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The command line. CLI11 parses it, which arguments.cpp alone includes.

#include "document/output.hpp"
#include "request/field.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/core/names.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace fstiff::cli {

/// The options of a command; they write into the targets, which must live as long as the program parses.
class Arguments {
public:
    explicit Arguments(CLI::App& app) : app_(&app) {}

    /// The option \p name, whose value goes to \p to; of a bool a flag.
    template <class Member>
    void option(const std::string& name, Member& to, const request::Field& field) {
        using request::Value;
        if constexpr (std::is_same_v<Member, bool>)
            flag(name, to, field.help);
        else
            add(name, field,
                {kind_of<Member>(), words_of<Member>(), default_of(to), &to,
                 [](const Value& value, void* member, const std::string& key, const request::Field& range) {
                     request::put(value, *static_cast<Member*>(member), key, range);
                 }});
    }
    /// Every field of \p owner, which are the targets.
    template <class Owner>
    void fields(Owner& owner) {
        owner.each_field([&](std::string_view key, auto& to, const request::Field& field) {
            option((field.positional ? "" : "--") + surface::with_dashes(key), to, field);
        });
    }
    /// The option \p name with one of \p words, or with none, where \p to is empty; not there: \p to has no value.
    void word_or_flag(const std::string& name, std::optional<std::string>& to, const std::vector<std::string>& words,
                      const std::string& help);
    /// The heading of the options that are added from now on; those before have that of CLI11.
    void group(std::string_view heading) { group_ = heading; }
    /// Where the value of an option goes. One function for each type, not for each option, keeps the program small.
    struct Target {
        const char* kind;                     ///< how the help calls the value, unless the field has a name for it
        std::vector<std::string_view> words;  ///< of an enum
        std::string initial;
        void* member;
        void (*put)(const request::Value& value, void* member, const std::string& key, const request::Field& field);
    };
    void add(const std::string& name, const request::Field& field, const Target& target);

private:
    template <class Member>
    static std::vector<std::string_view> words_of() {
        if constexpr (detail::NamedEnum<Member>) {
            constexpr auto words = detail::choices<Member>();
            return {words.begin(), words.end()};
        } else if constexpr (requires(Member member) { member.has_value(); }) {
            return words_of<typename Member::value_type>();
        } else {
            return {};
        }
    }
    template <class Member>
    static constexpr const char* kind_of() {
        if constexpr (requires(Member member) { member.has_value(); })
            return kind_of<typename Member::value_type>();
        else
            return std::is_same_v<Member, std::vector<std::string>> ? "TEXT ..."
                   : std::is_unsigned_v<Member>                     ? "UINT"
                   : std::is_integral_v<Member>                     ? "INT"
                   : std::is_floating_point_v<Member>               ? "FLOAT"
                                                                    : "TEXT";
    }
    template <class Member>
    static std::string default_of(const Member& value) {
        if constexpr (std::is_arithmetic_v<Member>)
            return std::to_string(value);
        else if constexpr (std::is_convertible_v<Member, std::string>)
            return value;
        else
            return {};
    }
    void flag(const std::string& name, bool& to, const std::string& help);

    CLI::App* app_;
    std::string group_ = "Options";
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
/// A table that `help` prints.
struct HelpTopic {
    const char* name;
    std::string (*text)();
    bool in_manual;  ///< in the manual page of the program too
};
/// A name of former times, and the sentence that gives the call which took its place.
struct OldName {
    std::string_view name, now;
};

/// The command line of the program, all of its commands; the options of the one that is called.
class Program {
public:
    Program(const std::string& name, const std::string& version, const std::string& description,
            const std::string& footer, std::span<const CommandRow> commands, std::span<const HelpTopic> topics,
            std::span<const OldName> old_names);
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
    std::span<const HelpTopic> topics_;
    std::span<const OldName> old_names_;
};

/// Page \p name of section 1 of the manual, in roff, with what \p help prints; \p also are the pages to see.
[[nodiscard]] std::string manual_page(const std::string& name, const std::string& version, const std::string& help,
                                      const std::vector<std::string>& also);

}  // namespace fstiff::cli
