// SPDX-License-Identifier: BSD-3-Clause
#include "input/arguments.hpp"

#include "document/output.hpp"

#include <CLI/CLI.hpp>

namespace fstiff::cli {
namespace {

template <class Target>
Option add(CLI::App& app, const std::string& name, Target& target, const std::string& help) {
    return Option(app.add_option(name, target, help));
}

}  // namespace

Option& Option::required() {
    option_->required();
    return *this;
}
Option& Option::type_name(const std::string& name) {
    option_->type_name(name);
    return *this;
}
Option& Option::one_of(std::span<const std::string_view> values) {
    option_->check(CLI::IsMember(std::vector<std::string>(values.begin(), values.end())));
    return *this;
}
Option& Option::one_of(std::initializer_list<const char*> values) {
    return one_of(std::vector<std::string_view>(values.begin(), values.end()));
}
Option& Option::one_of(std::initializer_list<int> values) {
    option_->check(CLI::IsMember(values));
    return *this;
}
Option& Option::between(int least, int greatest) {
    option_->check(CLI::Range(least, greatest));
    return *this;
}
Option& Option::between(unsigned long least, unsigned long greatest) {
    option_->check(CLI::Range(least, greatest));
    return *this;
}
Option& Option::delimiter(char separator) {
    option_->delimiter(separator);
    return *this;
}
Option& Option::show_default() {
    option_->capture_default_str();
    return *this;
}

Arguments::Arguments(CLI::App& program, const std::string& name, const std::string& description)
    : app_(program.add_subcommand(name, description)) {}

Option Arguments::option(const std::string& name, std::string& target, const std::string& help) {
    return add(*app_, name, target, help);
}
Option Arguments::option(const std::string& name, std::vector<std::string>& target, const std::string& help) {
    return add(*app_, name, target, help);
}
Option Arguments::option(const std::string& name, int& target, const std::string& help) {
    return add(*app_, name, target, help);
}
Option Arguments::option(const std::string& name, unsigned long& target, const std::string& help) {
    return add(*app_, name, target, help);
}
Option Arguments::option(const std::string& name, unsigned long long& target, const std::string& help) {
    return add(*app_, name, target, help);
}
Option Arguments::option(const std::string& name, double& target, const std::string& help) {
    return add(*app_, name, target, help);
}
Option Arguments::option(const std::string& name, std::optional<double>& target, const std::string& help) {
    return add(*app_, name, target, help);
}
Option Arguments::option(const std::string& name, const std::function<void(const std::string&)>& take,
                         const std::string& help) {
    return Option(app_->add_option_function<std::string>(name, take, help));
}
void Arguments::flag(const std::string& name, bool& target, const std::string& help) {
    app_->add_flag(name, target, help);
}
void Arguments::footer(const std::string& text) { app_->footer(text); }

Program::Program(const std::string& name, const std::string& version, const std::string& description,
                 const std::string& footer)
    : app_(std::make_unique<CLI::App>(description, name)) {
    app_->set_version_flag("--version", version);
    app_->require_subcommand(1);
    app_->footer(footer);
}
Program::~Program() = default;

const CLI::App* Program::parse(int argc, char** argv) {
    try {
        app_->parse(argc, argv);
        return app_->get_subcommands().front();
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            app_->exit(error);
            return nullptr;
        }
        const auto chosen = app_->get_subcommands();
        const std::string program = app_->get_name();
        if (!chosen.empty())
            throw Usage(std::string(error.what()) + "; see " + program + " " + chosen.front()->get_name() + " --help");
        if (app_->remaining().empty()) throw Usage(std::string(error.what()) + "; see " + program + " --help");
        std::string names;
        for (const CLI::App* command : app_->get_subcommands({}))
            names += (names.empty() ? "" : ", ") + command->get_name();
        throw Usage(app_->remaining().front() + ": is no subcommand or option; must be one of " + names + "; see " +
                    program + " --help");
    }
}

}  // namespace fstiff::cli
