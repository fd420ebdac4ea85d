// SPDX-License-Identifier: BSD-3-Clause
// What happens to a sweep that is killed, whose disk is full, or whose file another one writes: nothing is lost or
// doubled.
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

/// Runs \p runs sweeps, each killed again and again until it comes to its end.
void check_killed_sweeps(unsigned runs) {
    const Folder folder;
    const std::string file = folder.write("grid.toml", grid(10000));
    REQUIRE(run_fstiff("sweep '" + file + "' -o '" + folder / "serial" + "'").status == 0);
    const std::string serial = read(folder / "serial");
    unsigned killed = 0, went_on = 0;
    for (unsigned seed = 1; seed <= runs; ++seed) {
        std::mt19937 random(seed);
        const std::string out = folder / ("out" + std::to_string(seed));
        const std::vector<std::string> sweep{"sweep", file, "-o", out, "--threads", std::to_string(1 + seed % 3)};
        std::uintmax_t before = 0;
        for (int attempt = 1;; ++attempt) {
            const pid_t child = start(sweep);
            // later and later, so that a slow machine comes to an end too
            std::this_thread::sleep_for(std::chrono::microseconds(random() % 60000) * (1 + attempt / 10));
            kill(child, SIGKILL);
            int code = 0;
            REQUIRE(waitpid(child, &code, 0) == child);
            if (WIFEXITED(code)) {
                CHECK(WEXITSTATUS(code) == 0);
                break;
            }
            ++killed;
            std::error_code none;
            const std::uintmax_t size = std::filesystem::exists(out) ? std::filesystem::file_size(out, none) : 0;
            if (before > 0 && size > before) ++went_on;
            before = size;
        }
        INFO("seed " << seed);
        CHECK(read(out) == serial);
        CHECK(read(out + ".sweep") == read(folder / "serial.sweep"));
        CHECK(!std::filesystem::exists(out + ".sweep.partial"));
        std::filesystem::remove(out);
    }
    CHECK(killed >= runs);
    CHECK(went_on > 0);  // some of them from results of a run before
}

}  // namespace

TEST_CASE("A sweep that SIGKILL ends at a random moment goes on to the same bytes, in 3 runs", "[more]") {
    check_killed_sweeps(3);
}
TEST_CASE("A sweep that SIGKILL ends at a random moment goes on to the same bytes, in 40 runs", "[long]") {
    check_killed_sweeps(40);
}

TEST_CASE("A full disk ends a sweep with its reason, and the next one goes on after the written lines") {
    const Folder folder;
    const std::string file = folder.write("grid.toml", grid(5000)), out = folder / "out";
    const std::string sweep = "fstiff sweep '" + file + "' -o '" + out + "'";
    REQUIRE(run_fstiff("sweep '" + file + "' -o '" + folder / "serial" + "'").status == 0);
    const std::string serial = read(folder / "serial");
    REQUIRE(serial.size() > 3'000'000);
    const Outcome full = shell("ulimit -f 4000; " + sweep);  // blocks of 512 bytes: 2 MB
    INFO(full.err);
    CHECK(full.status == 3);
    CHECK(contains(full.err, "cannot be written: File too large"));
    const std::string part = read(out);
    CHECK(part.size() > 1'000'000);
    CHECK(part.back() == '\n');
    CHECK(serial.starts_with(part));
    CHECK(contains(read(out + ".sweep"), "\"finished\": false"));
    CHECK(shell(sweep).status == 0);
    CHECK(read(out) == serial);
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
        std::filesystem::remove(out + ".sweep");
        const Outcome outcome =
            shell("ulimit " + std::string(limits) + " && fstiff sweep '" + file + "' -o '" + out + "' --threads 64");
        INFO(limits << "\n" << outcome.err);
        CHECK(outcome.status == 0);
        CHECK(contains(outcome.err, " of 64 threads ran; the system has no room for more"));
        CHECK(read(out) == read(folder / "serial"));
    }
}

TEST_CASE("Two sweeps cannot write one file at the same time") {
    const Folder folder;
    const std::string file = folder.write("grid.toml", grid(100'000'000)), out = folder / "out";
    const pid_t first = start({"sweep", file, "-o", out, "--shard", "1/2"});
    for (int i = 0; i < 1000 && !std::filesystem::exists(out + ".sweep"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    for (const char* shard : {"1/2", "2/2"}) {
        const Outcome second = run_fstiff("sweep '" + file + "' -o '" + out + "' --shard " + shard);
        CHECK(second.status == 3);
        CHECK(contains(second.err, "is being written by another process; give every shard a file of its own"));
    }
    kill(first, SIGKILL);
    waitpid(first, nullptr, 0);
    const Outcome other = run_fstiff("sweep '" + file + "' -o '" + out + "' --shard 2/2");
    CHECK(other.status == 3);
    CHECK(contains(other.err, "holds the results of shard 1/2, not 2/2"));
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

TEST_CASE("Results whose lines were damaged go on where they are whole") {
    const Folder folder;
    const std::string sweep = "sweep '" + folder.write("grid.toml", grid(3)) + "' -o '" + folder / "out" + "'";
    REQUIRE(run_fstiff(sweep).status == 0);
    const std::string whole = read(folder / "out"), known = read(folder / "out.sweep");
    std::string damaged = whole;
    damaged.replace(whole.find('\n') + 60, 8, "????????");
    folder.write("out", damaged);
    folder.write("out.sweep", replaced(known, "\"finished\": true", "\"finished\": false"));
    const Outcome again = run_fstiff(sweep);
    CHECK(again.status == 0);
    CHECK(contains(again.err, std::to_string(whole.size()) + " bytes at the end of"));
    CHECK(contains(again.err, "are computed again"));
    CHECK(read(folder / "out") == whole);
}

}  // namespace sweep_faults_test
