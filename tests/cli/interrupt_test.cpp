// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

using namespace test;

namespace {

/// Starts the command with standard error on \p error_to; standard output goes nowhere.
pid_t start(const std::vector<std::string>& arguments, int error_to) {
    const pid_t child = fork();
    if (child != 0) return child;
    setenv("TERM", "xterm", 1);
    const int nothing = open("/dev/null", O_WRONLY);
    dup2(nothing, STDOUT_FILENO);
    dup2(error_to, STDERR_FILENO);
    std::signal(SIGINT, SIG_DFL);
    std::vector<char*> words{const_cast<char*>(FSTIFF_COMMAND)};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    execv(FSTIFF_COMMAND, words.data());
    _exit(127);
}

}  // namespace

TEST_CASE("Ctrl-C during long work ends the command and leaves no file") {
    const Folder folder;
    std::string scene = read(FSTIFF_SCENES "/sand_blasted_fine.toml");
    scene = replaced(scene, "[material.upper]", "errors = { rms_height = \"0.08 um\" }\n\n[material.upper]") +
            "\n[uncertainty]\nsamples = 100000\n";
    const std::string file = folder.write("scene.toml", scene);
    const int nothing = open("/dev/null", O_WRONLY);
    const pid_t child = start({"run", file, "-o", folder / "table"}, nothing);
    close(nothing);
    usleep(200000);  // into the work, which takes minutes; earlier or later makes no difference to what is checked
    kill(child, SIGINT);
    int code = 0;
    waitpid(child, &code, 0);
    CHECK(WIFSIGNALED(code));
    CHECK(WTERMSIG(code) == SIGINT);
    CHECK(folder.files() == 1);
}

TEST_CASE("Ctrl-C while a file is written leaves nothing of it") {
    const Folder folder;
    const int nothing = open("/dev/null", O_WRONLY);
    const std::string file = folder / "map.sdf";
    const pid_t child = start({"generate", "map", "--format", "sdf", "--hurst", "0.8", "--rms", "1 um", "--points",
                               "2048", "--spacing", "1 um", "-o", file},
                              nothing);
    close(nothing);
    // the file that is being written stands beside the one it will become
    bool seen = false, ended = false;
    int code = 0;
    while (!seen && !ended) {
        for (const auto& entry : std::filesystem::directory_iterator(folder / "."))
            seen = seen || contains(entry.path().filename().string(), ".partial-");
        ended = waitpid(child, &code, WNOHANG) == child;
    }
    if (!ended) {
        kill(child, SIGINT);
        waitpid(child, &code, 0);
    }
    INFO("seen " << seen << ", code " << code);
    if (!seen) WARN("the command was done before it could be interrupted");
    for (const auto& entry : std::filesystem::directory_iterator(folder / "."))
        CHECK_FALSE(contains(entry.path().filename().string(), ".partial-"));
    if (seen && WIFSIGNALED(code)) {
        CHECK(WTERMSIG(code) == SIGINT);
        CHECK(folder.files() == 0);
    }
}
