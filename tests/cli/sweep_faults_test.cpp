// SPDX-License-Identifier: BSD-3-Clause
// A sweep that is killed, or whose disk is full, leaves nothing half done.
#include "cli/command.hpp"
#include "support/skip.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace sweep_faults_test {

using namespace test;

namespace {

/// A grid of \p pressures scenes, some tenth of a second for 10000 of them.
std::string grid(int pressures) {
    return "[surface]\nrms_height = [\"0.5 um\", \"1 um\"]\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n"
           "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
           "[contact]\nlaws = [\"hertz\"]\npeaks = [ { theta = \"pi/3\", r = 0.5 } ]\n"
           "pressures = [ { from = \"0.1 MPa\", to = \"100 MPa\", count = " +
           std::to_string(pressures) + " } ]\n";
}

/// Starts the command, silent.
pid_t start(std::vector<std::string> arguments) {
    const pid_t child = fork();
    if (child != 0) return child;
    const int nothing = open("/dev/null", O_WRONLY);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    std::vector<char*> words{const_cast<char*>(FSTIFF_COMMAND)};
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    execv(FSTIFF_COMMAND, words.data());
    _exit(127);
}

/// Kills \p runs sweeps at random moments, each followed by one that comes to its end.
void check_killed_sweeps(unsigned runs) {
    const Folder folder;
    const std::string file = folder.write("grid.toml", grid(2000)), out = folder / "out";
    REQUIRE(run_fstiff("sweep '" + file + "' -o '" + out + "'").status == 0);
    const std::string whole = read(out), old = whole.substr(0, whole.find('\n') + 1);
    unsigned killed = 0;
    for (std::mt19937 random(1); killed < runs;) {
        const bool is_new = random() % 2 == 0;
        std::filesystem::remove(out);
        if (!is_new) folder.write("out", old);
        const std::vector<std::string> sweep{"sweep", file, "-o", out, "--threads", std::to_string(1 + random() % 3)};
        const pid_t child = start(sweep);
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 100000));
        kill(child, SIGKILL);
        int code = 0;
        REQUIRE(waitpid(child, &code, 0) == child);
        killed += WIFSIGNALED(code) ? 1 : 0;
        const bool is_complete = std::filesystem::exists(out) && read(out) == whole;
        if (!is_complete) CHECK((is_new ? !std::filesystem::exists(out) : read(out) == old));
        CHECK((is_complete || WIFSIGNALED(code)));
        CHECK(run_fstiff("sweep '" + file + "' -o '" + out + "'").status == 0);
        CHECK(read(out) == whole);
    }
}

}  // namespace

TEST_CASE("A sweep that SIGKILL ends leaves its file as it was, and the next one completes it, in 3 runs", "[more]") {
    check_killed_sweeps(3);
}
TEST_CASE("A sweep that SIGKILL ends leaves its file as it was, and the next one completes it, in 40 runs", "[long]") {
    check_killed_sweeps(40);
}

TEST_CASE("A full disk ends a sweep with its reason, and leaves no part of its file") {
    const Folder folder;
    const std::string sweep =
        "fstiff sweep '" + folder.write("grid.toml", grid(5000)) + "' -o '" + folder / "out" + "'";
    const Outcome full = shell("ulimit -f 4000; " + sweep);  // blocks of 512 bytes: 2 MB
    INFO(full.err);
    CHECK(full.status == 3);
    CHECK(contains(full.err, "out: cannot be written: File too large"));
    CHECK(folder.files() == 1);
}

TEST_CASE("Ctrl-C ends a sweep, and leaves no part of its file") {
    const Folder folder;
    const std::string file = folder.write("grid.toml", grid(100'000'000));
    const pid_t child = start({"sweep", file, "-o", folder / "out"});
    for (int i = 0; i < 1000 && folder.files() < 2; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(folder.files() == 2);
    kill(child, SIGINT);
    int code = 0;
    waitpid(child, &code, 0);
    CHECK(WIFSIGNALED(code));
    CHECK(folder.files() == 1);
}

TEST_CASE("A sweep without room for all threads goes on with fewer, and reports how many") {
    const Folder folder;
    const std::string file = folder.write("grid.toml", grid(500)), out = folder / "out";
    REQUIRE(run_fstiff("sweep '" + file + "' -o '" + folder / "serial" + "'").status == 0);
    if (shell("ulimit -s 4000000 && ulimit -v 100000 && fstiff --version").status != 0)
        SKIP_CASE("no program runs here with little memory, or the limits cannot be set");
    // each thread asks for a stack of the size of the limit on that of the process
    for (const char* limits : {"-s 4000000 && ulimit -v 2000000", "-s 400000 && ulimit -v 2000000", "-v 500000",
                               "-v 200000", "-v 140000", "-v 100000"}) {
        std::filesystem::remove(out);
        const Outcome outcome =
            shell("ulimit " + std::string(limits) + " && fstiff sweep '" + file + "' -o '" + out + "' --threads 64");
        INFO(limits << "\n" << outcome.err);
        CHECK(outcome.status == 0);
        CHECK(contains(outcome.err, " of 64 threads ran; the system has no room for more"));
        CHECK(read(out) == read(folder / "serial"));
    }
}

TEST_CASE("A table or a binary form is refused as the form of a sweep's results") {
    const test::Folder folder;
    for (const char* ending : {"parquet", "h5", "csv"}) {
        const auto outcome = test::run_fstiff("sweep none.toml -o '" + folder / "out." + ending + "'");
        INFO(ending);
        CHECK(outcome.status == 2);
        CHECK(test::contains(outcome.err, "results are lines of JSON, file.jsonl"));
    }
}

TEST_CASE("A sweep shows a bar with its rate and the time left on a terminal") {
    if (shell("script -qec true /dev/null").status != 0)
        SKIP_CASE("`script` makes no terminal here: the bar is not tested");
    const Folder folder;
    const std::string file = folder.write("grid.toml", grid(10000));
    const Outcome shown = shell("export TERM=vt100; script -qec \"'" FSTIFF_COMMAND "' sweep '" + file + "' -o '" +
                                folder / "out" + "'\" /dev/null");
    INFO(shown.out);
    CHECK(shown.status == 0);
    CHECK(contains(shown.out, "scenes ["));
    CHECK(contains(shown.out, "/s, "));
    CHECK(contains(shown.out, " s left"));
}

}  // namespace sweep_faults_test
