// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

using namespace test;

namespace {

/// A scene whose band takes some seconds.
std::string long_scene(int samples) {
    std::string text = read(FSTIFF_SCENES "/sand_blasted_fine.toml");
    text = replaced(text, "[material.upper]", "errors = { rms_height = \"0.08 um\" }\n\n[material.upper]");
    return text + "\n[uncertainty]\nsamples = " + std::to_string(samples) + "\n";
}

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

TEST_CASE("A band of many samples shows a bar on a terminal and nothing in a pipe") {
    const Folder folder;
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) {
        WARN("there are no pseudo-terminals: skipped");
        return;
    }
    const int far_end = open(ptsname(terminal), O_RDWR | O_NOCTTY);
    REQUIRE(far_end >= 0);
    const std::string scene = folder.write("scene.toml", long_scene(100000));
    const pid_t child = start({"run", scene}, far_end);
    close(far_end);
    // until the bar is there, or the work is done without one
    std::string shown;
    char bytes[4096];
    while (!contains(shown, " left")) {
        const auto count = ::read(terminal, bytes, sizeof bytes);
        if (count <= 0) break;
        shown.append(bytes, static_cast<std::size_t>(count));
    }
    kill(child, SIGINT);
    int code = 0;
    waitpid(child, &code, 0);
    close(terminal);
    INFO(shown);
    CHECK(contains(shown, "band of 100000 surfaces ["));
    CHECK(contains(shown, " left"));
    CHECK(WIFSIGNALED(code));
    CHECK(WTERMSIG(code) == SIGINT);

    const Outcome piped = fstiff("run '" + folder.write("short.toml", long_scene(2000)) + "'");
    CHECK(piped.status == 0);
    CHECK(piped.err.empty());
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
