// SPDX-License-Identifier: BSD-3-Clause
// Input that is no file: pipes are read while a program writes them; what would make the command wait is refused.
#include "command.hpp"

#include <filesystem>

namespace waiting_input_test {

using test::Outcome;
using test::shell;

namespace {

const std::string scene =
    "[surface]\nSq = \"0.8 um\"\nSdq = 0.15\n[material]\nupper = \"steel\"\n[contact]\npressures = [\"10 MPa\"]\n";

}  // namespace

TEST_CASE("A pipe that no program writes is refused, as a scene and as a surface") {
    const test::Folder folder;
    const std::string pipe = folder / "pipe", in = "mkfifo '" + pipe + "'\n";
    for (const std::string& command :
         {"run '" + pipe + "'", "measure '" + pipe + "' --units um", "run --surface '" + pipe + "'",
          "sweep '" + pipe + "' -o '" + folder / "r.jsonl" + "'"}) {
        const Outcome outcome = shell("rm -f '" + pipe + "'\n" + in + "fstiff " + command);
        test::check_refusal(outcome, command, 3, {pipe, "is a pipe that no program writes"});
    }
    const std::string map =
        folder.write("scene.toml", "[surface]\nfrom = \"pipe\"\n[contact]\npressures = [\"1 MPa\"]\n");
    test::check_refusal(shell("fstiff run '" + map + "'"), map, 3, {"is a pipe that no program writes"});
}

TEST_CASE("A pipe that a program writes is read, early, late and in parts, and so is standard input") {
    const test::Folder folder;
    const std::string file = folder.write("scene.toml", scene), pipe = folder / "pipe";
    const auto whole = shell("fstiff run '" + file + "' --format csv");
    REQUIRE(whole.status == 0);
    for (const std::string& script :
         {"cat '" + file + "' | fstiff run - --format csv", "cat '" + file + "' | fstiff run /dev/stdin --format csv",
          "fstiff run /dev/stdin --format csv < '" + file + "'",
          "(sleep 1; head -n 2 '" + file + "'; sleep 1; tail -n +3 '" + file +
              "') | fstiff run /dev/stdin --format csv",
          "mkfifo '" + pipe + "'; cat '" + file + "' > '" + pipe + "' & sleep 0.3; fstiff run '" + pipe +
              "' --format csv",
          "(sleep 0.7; cat '" + file + "' > '" + pipe + "') & fstiff run '" + pipe + "' --format csv",
          "(sleep 0.2; exec 3> '" + pipe + "'; sleep 3; cat '" + file + "' >&3) & fstiff run '" + pipe +
              "' --format csv"}) {
        INFO(script);
        const Outcome outcome = shell(script);
        CHECK(outcome.status == 0);
        CHECK(outcome.out == whole.out);
    }
    if (shell("command -v bash >/dev/null").status == 0)
        CHECK(shell("bash -c \"'" FSTIFF_COMMAND "' run <(sleep 0.5; cat '" + file + "') --format csv\"").out ==
              whole.out);
}

TEST_CASE("Devices, logs of the system and text without an end are refused") {
    for (const char* file : {"/proc/kmsg", "/dev/kmsg", "/dev/zero", "/dev/null", "/dev/urandom", "/dev/tty", "/dev"}) {
        if (!std::filesystem::exists(file)) continue;
        for (const std::string command : {"run ", "measure ", "run --surface "}) {
            if (std::string(file) == "/dev" && command != "run ") continue;  // a folder of surfaces is one
            const Outcome outcome = shell("timeout 20 setsid '" FSTIFF_COMMAND "' " + command + file + " < /dev/null");
            test::check_refusal(outcome, command + file, 3, {file});
        }
    }
    test::check_refusal(shell("yes | fstiff run -"), "yes", 3, {"standard input", "must be at most 1 MiB"});
}

TEST_CASE("Names of files turn no line round, and begin no formula of a spreadsheet") {
    const test::Folder folder;
    const std::string map = "=1+1|cmd.csv", turned = "a\u202Evsc.csv";
    std::string text = "x [um],z [um]\n";
    for (int i = 0; i < 400; ++i) text += std::to_string(i) + "," + std::to_string((i * 7919) % 101 / 100.0) + "\n";
    folder.write(map, text), folder.write(turned, text);
    const std::string in = "cd '" + (folder / "") + "' && ";
    const std::string csv = shell(in + "fstiff measure '" + map + "' '" + map + "' --format csv").out;
    CHECK_FALSE(test::contains("\n" + csv, "\n="));
    CHECK_FALSE(test::contains(csv, ",="));
    for (const std::string command : {"measure --format table '", "run --surface '"})
        CHECK_FALSE(test::contains(shell(in + "fstiff " + command + turned + "'").out, "\u202E"));
}

}  // namespace waiting_input_test
