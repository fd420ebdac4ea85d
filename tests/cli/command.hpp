// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Runs the command as a process: FSTIFF_COMMAND is its path, FSTIFF_SCENES the folder of the scenes, both set by CMake.
#include "support/catch.hpp"
#include "support/csv.hpp"
#include "support/files.hpp"

#include <sys/wait.h>
#include <cstdlib>
#include <string>
#include <vector>

namespace test {

struct Outcome {
    int status;  ///< exit code; 1000 and more: ended by a signal
    std::string out, err;
};

/// Runs \p script, in which `fstiff` is the command under test, with \p input on standard input.
inline Outcome shell(const std::string& script, const std::string& input = "") {
    const Folder folder;
    folder.write("in", input);
    const std::string whole = "fstiff() { '" FSTIFF_COMMAND "' \"$@\"; }\n" + script + "\n";
    folder.write("script", whole);
    const int code = std::system(("timeout 300 sh '" + folder / "script" + "' <'" + folder / "in" + "' >'" +
                                  folder / "out" + "' 2>'" + folder / "err" + "'")
                                     .c_str());
    return {WIFEXITED(code) ? WEXITSTATUS(code) : 1000 + WTERMSIG(code), read(folder / "out"), read(folder / "err")};
}

inline Outcome run_fstiff(const std::string& arguments, const std::string& input = "") {
    return shell("fstiff " + arguments, input);
}

/// \p text with its lines as one, as sentences are that a table wraps.
inline std::string as_one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// Checks that \p outcome of \p arguments is a refusal: the exit code, one sentence with every one of \p parts on
/// standard error, no document.
inline void check_refusal(const Outcome& outcome, const std::string& arguments, int status,
                          const std::vector<std::string>& parts) {
    INFO("fstiff " << arguments << "\nstandard error: " << outcome.err);
    CHECK(outcome.status == status);
    CHECK(outcome.out.empty());
    CHECK(lines(outcome.err).size() == 1);
    for (const std::string& part : parts) {
        INFO("expected: " << part);
        CHECK(contains(outcome.err, part));
    }
}

/// Checks that the command refuses, as above, and writes no file where the output should have gone.
inline void check_refused(const std::string& arguments, int status, const std::vector<std::string>& parts,
                          const std::string& input = "") {
    const Folder folder;
    const Outcome outcome = run_fstiff(arguments + " --output '" + folder / "result" + "'", input);
    check_refusal(outcome, arguments, status, parts);
    CHECK(folder.files() == 0);
}

}  // namespace test
