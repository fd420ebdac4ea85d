// SPDX-License-Identifier: BSD-3-Clause
// Files after an interruption. The signal comes at a known place of the work, whatever the speed of the machine.
#include "cli/command.hpp"
#include "support/skip.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/ptrace.h>
#endif

#include <csignal>
#include <cstdlib>

namespace interrupt_test {

using namespace test;

namespace {

/// Starts the command with standard error on \p error_to; standard output goes nowhere. \p before runs in its process.
template <class Before>
pid_t start(const std::vector<std::string>& arguments, int error_to, const Before& before) {
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
    before();
    execv(FSTIFF_COMMAND, words.data());
    _exit(127);
}

bool has_partial(const std::string& folder) {
    if (!std::filesystem::exists(folder)) return false;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (contains(entry.path().filename().string(), ".partial-")) return true;
    return false;
}

}  // namespace

TEST_CASE("Ctrl-C during long work ends the command and leaves no file") {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) SKIP_CASE("there are no terminals here");
    const Folder folder;
    std::string scene = read(FSTIFF_SCENES "/sand_blasted_fine.toml");
    scene = replaced(scene, "[material.upper]", "errors = { rms_height = \"0.08 um\" }\n\n[material.upper]") +
            "\n[uncertainty]\nsamples = 100000\n";  // minutes
    const std::string file = folder.write("scene.toml", scene);
    const int error_to = open(ptsname(terminal), O_RDWR | O_NOCTTY);
    REQUIRE(error_to >= 0);
    const pid_t child = start({"run", file, "-o", folder / "table"}, error_to, [] {});
    close(error_to);
    char first = 0;
    REQUIRE(::read(terminal, &first, 1) == 1);  // the bar: the work has begun
    CHECK(first == '\r');
    kill(child, SIGINT);
    int code = 0;
    waitpid(child, &code, 0);
    close(terminal);
    CHECK(WIFSIGNALED(code));
    CHECK(WTERMSIG(code) == SIGINT);
    CHECK(folder.files() == 1);
}

#ifdef __linux__
namespace {

/// Sends Ctrl-C when the first incomplete file is in \p watched.
void interrupt_while_writing(const std::vector<std::string>& arguments, const std::string& watched) {
    const int nothing = open("/dev/null", O_WRONLY);
    const pid_t child = start(arguments, nothing, [] {
        if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(126);
    });
    close(nothing);
    // From system call to system call, until the temporary file is there next to its target.
    int code = 0;
    bool seen = false;
    while (!seen && waitpid(child, &code, 0) == child && WIFSTOPPED(code)) {
        seen = has_partial(watched);
        if (seen) kill(child, SIGINT);  // it is stopped: the signal waits for it
        ptrace(seen ? PTRACE_DETACH : PTRACE_SYSCALL, child, nullptr, nullptr);
    }
    if (seen) waitpid(child, &code, 0);
    if (WIFEXITED(code) && WEXITSTATUS(code) == 126) SKIP_CASE("no process may follow another here (ptrace)");
    REQUIRE(seen);
    REQUIRE(WIFSIGNALED(code));
    CHECK(WTERMSIG(code) == SIGINT);
}

}  // namespace

TEST_CASE("Ctrl-C while a file is written leaves no part of it") {
    const Folder folder;
    interrupt_while_writing({"generate", "map", "--format", "sdf", "--hurst", "0.8", "--rms", "1 um", "--points", "256",
                             "--spacing", "1 um", "-o", folder / "map.sdf"},
                            folder / ".");
    CHECK(folder.files() == 0);
}

TEST_CASE("Ctrl-C while a picture is written leaves no part of it") {
    const Folder folder;
    interrupt_while_writing({"run", "--plot", folder / "k.svg"}, folder / ".");
    CHECK(folder.files() == 0);
}
#endif

}  // namespace interrupt_test
