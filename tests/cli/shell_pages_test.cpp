// SPDX-License-Identifier: BSD-3-Clause
// Manual pages and the completion of shells. Truth: what --help prints, and the programs that read them.
#include "cli/command.hpp"
#include "support/skip.hpp"

#include <algorithm>
#include <regex>

namespace shell_pages_test {

namespace {

bool installed(const std::string& program) { return test::shell("command -v " + program).status == 0; }

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern, std::regex::multiline);
    std::vector<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
        found.push_back((*at)[1].str());
    return found;
}

/// Names of the commands, as --help lists them; and with the older ones, which it does not list.
std::vector<std::string> listed_commands() {
    const std::string help = test::run_fstiff("--help").out;
    const auto begin = help.find("\nCompute:\n"), end = help.find("\nExit codes:", begin);
    const auto names = matches(help.substr(begin, end - begin), "^  ([a-z]+) ");
    REQUIRE(names.size() >= 10);
    return names;
}
std::vector<std::string> commands() {
    std::vector<std::string> names = listed_commands();
    for (const char* shown : {"fit", "islands", "spectrum"}) names.push_back("measure --show " + std::string(shown));
    return names;
}

struct ShownOption {
    std::vector<std::string> names, choices;
};

/// Options of a command, as --help lists them.
std::vector<ShownOption> options(const std::string& command) {
    std::vector<ShownOption> shown;
    for (const std::string& line : matches(test::run_fstiff(command + " --help").out, "^  (-.*)$")) {
        ShownOption option;
        option.names = matches(line.substr(0, line.find(' ')), "(-{1,2}[a-z][a-z0-9-]*)");
        if (const auto brace = line.find(":{"); brace != std::string::npos)
            option.choices = matches(line.substr(brace + 2, line.find('}') - brace - 2), "([^,]+)");
        shown.push_back(option);
    }
    REQUIRE(shown.size() >= 1);
    return shown;
}

/// Of measure --show fit "measure-fit".
std::string page_name(const std::string& command) {
    return std::regex_replace(std::regex_replace(command, std::regex(" --show "), "-"), std::regex(" --"), "-");
}

/// \p page as a reader sees it, given that in roff \- is a dash and \fB begins bold letters.
std::string plain(std::string page) {
    page = std::regex_replace(page, std::regex(R"(\\f[BIR])"), "");
    page = std::regex_replace(page, std::regex(R"(\\-)"), "-");
    page = std::regex_replace(page, std::regex(R"(\\:)"), "");
    page = std::regex_replace(page, std::regex(R"(\\e)"), "\\");
    page = std::regex_replace(page, std::regex(R"(\\\(aq)"), "'");
    return std::regex_replace(page, std::regex(R"(\\\(ha)"), "^");
}

}  // namespace

TEST_CASE("the manual page of every command has every option, word and example of --help") {
    std::size_t found = 0;
    for (const std::string& command : commands()) {
        const auto page = test::run_fstiff("help " + command + " --man");
        INFO("fstiff help " << command << " --man\n" << page.out << page.err);
        REQUIRE(page.status == 0);
        CHECK(page.out.starts_with(".TH FSTIFF\\-"));
        const std::string text = plain(page.out);
        CHECK(test::contains(text, "fstiff-" + page_name(command) + " - "));
        for (const ShownOption& option : options(command)) {
            std::string tag, words;
            for (const std::string& name : option.names) tag += (tag.empty() ? "\n.TP\n" : ",") + name;
            for (const std::string& word : option.choices) words += (words.empty() ? ":{" : ",") + word;
            CHECK(test::contains(text, tag));
            CHECK(test::contains(text, words));
            ++found;
        }
        const std::string help = test::run_fstiff("help " + command).out;
        CHECK(test::contains(text, ".SH EXAMPLE\n.EX\n" + help.substr(help.rfind("Example:\n") + 9)));
    }
    CHECK(found > 150);

    const std::string program = plain(test::run_fstiff("help --man").out);
    for (const std::string& command : commands())
        CHECK(test::contains(program, "fstiff-" + page_name(command) + "(1)"));
    CHECK(test::contains(program, "  area                     m^2, cm^2"));
    CHECK(test::contains(program, "\nExit codes: 0 done"));
    for (const std::string wrong : {"help nonsense --man", "help --man nonsense", "help --completion ksh"}) {
        const auto refused = test::run_fstiff(wrong);
        INFO(wrong << ": " << refused.err);
        CHECK(refused.status == 2);
        CHECK(refused.out.empty());
        CHECK(test::lines(refused.err).size() == 1);
    }
}

TEST_CASE("man and mandoc find nothing wrong in the manual pages") {
    if (!installed("man") && !installed("mandoc")) SKIP_CASE("neither man nor mandoc is installed");
    const test::Folder folder;
    std::vector<std::string> pages{""};
    for (const std::string& command : commands()) pages.push_back(command + " ");
    for (const std::string& page : pages) {
        const std::string file = folder.write("page.1", test::run_fstiff("help " + page + "--man").out);
        INFO("page " << page);
        if (installed("man")) {
            const auto man = test::shell("LC_ALL=C.UTF-8 man --warnings -l '" + file + "' 2>&1 >/dev/null");
            CHECK(man.status == 0);
            CHECK(man.out.empty());
        }
        if (installed("mandoc")) {  // a date would change the pages of one version from day to day
            const auto lint = test::shell("mandoc -T lint -W warning '" + file + "' | grep -v 'missing date'");
            CHECK(lint.out.empty());
        }
    }
    // and it does find what is wrong
    if (installed("mandoc"))
        CHECK(test::contains(
            test::shell("mandoc -T lint -W warning '" + folder.write("bad.1", ".TH A 1\n.PP\n.XX\n") + "'").out, "XX"));
}

TEST_CASE("bash completes every command, option and word") {
    if (!installed("bash")) SKIP_CASE("bash is not installed");
    const test::Folder folder;
    const std::string script = folder.write("completion", test::run_fstiff("help --completion bash").out);
    std::string asked;  // one line of bash for each place to complete at, all answered by one bash
    std::vector<std::vector<std::string>> wanted;
    const auto ask = [&](const std::string& words, int place, const std::vector<std::string>& offered) {
        asked += "COMP_WORDS=(fstiff " + words + "); COMP_CWORD=" + std::to_string(place) +
                 "; _fstiff; echo \"${COMPREPLY[@]}\"\n";
        wanted.push_back(offered);
    };
    ask("''", 1, listed_commands());
    ask("mea", 1, {"measure"});
    ask("--v", 1, {"--version"});
    std::vector<std::string> of_help{"materials", "processes", "units"};
    for (const std::string& name : listed_commands()) of_help.push_back(name);
    ask("help ''", 2, of_help);
    ask("help --completion b", 3, {"bash"});
    ask("generate ''", 2, {"wm", "profile", "map"});
    ask("run --full ''", 3, {});
    ask("run --formt ''", 3, {});
    ask("run --format = ''", 4, {"table", "csv", "json"});
    ask("run --format =", 3, {"table", "csv", "json"});
    ask("measure --show fit x.csv --seed ''", 6, {});
    ask("measure --show ''", 3, {"fit", "islands", "spectrum"});
    ask("measure x.csv --show fit --conv", 5, {"--convention"});
    ask("measure --show = islands --neigh", 5, {"--neighbours"});
    for (const std::string& command : commands()) {
        std::vector<std::string> all;
        const int place = 2 + static_cast<int>(std::count(command.begin(), command.end(), ' '));
        for (const ShownOption& option : options(command)) {
            all.insert(all.end(), option.names.begin(), option.names.end());
            if (!option.choices.empty()) ask(command + " " + option.names.back() + " ''", place + 1, option.choices);
        }
        ask(command + " -", place, all);
        std::erase_if(all, [](const std::string& name) { return !name.starts_with("--"); });
        ask(command + " x --", place + 1, all);
    }
    const auto answer =
        test::shell("bash --norc", "fstiff() { '" FSTIFF_COMMAND "' \"$@\"; }\nsource '" + script + "'\n" + asked);
    INFO(answer.err);
    CHECK(answer.err.empty());
    const auto answers = test::lines(answer.out);
    REQUIRE(answers.size() == wanted.size());
    CHECK(wanted.size() > 60);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        INFO("line " << i + 1 << " of\n" << asked << "\nsays " << answers[i]);
        auto offered = matches(answers[i], "(\\S+)");
        // an option that begins another one's name brings that, too
        if (wanted[i].size() == 1 && wanted[i][0].starts_with("--") && offered.size() > 1)
            std::erase_if(offered, [&](const std::string& word) { return word != wanted[i][0]; });
        CHECK(offered == wanted[i]);
    }
}

}  // namespace shell_pages_test
