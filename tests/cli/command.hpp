// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Runs the command as a process: FSTIFF_COMMAND is its path, FSTIFF_SCENES the folder of the scenes, both set by CMake.
#include "support/catch.hpp"
#include "support/csv.hpp"

#include <sys/wait.h>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

/// A folder of its own for every test case, gone at its end.
class Folder {
public:
    Folder()
        : path_(std::filesystem::temp_directory_path() / ("fstiff-test-" + std::to_string(std::random_device{}()) +
                                                          "-" + std::to_string(std::random_device{}()))) {
        std::filesystem::create_directory(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(*this / name, std::ios::binary) << bytes;
        return *this / name;
    }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator()));
    }

private:
    std::filesystem::path path_;
};

inline std::string read(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("no file " + file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

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
    const int code = std::system(("timeout 60 sh '" + folder / "script" + "' <'" + folder / "in" + "' >'" +
                                  folder / "out" + "' 2>'" + folder / "err" + "'")
                                     .c_str());
    return {WIFEXITED(code) ? WEXITSTATUS(code) : 1000 + WTERMSIG(code), read(folder / "out"), read(folder / "err")};
}

inline Outcome run_fstiff(const std::string& arguments, const std::string& input = "") {
    return shell("fstiff " + arguments, input);
}

inline std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto found = text.find(from);
    if (found == std::string::npos) throw std::runtime_error("the text holds no " + from);
    return text.replace(found, from.size(), to);
}

/// Checks that the command refuses: the exit code, one sentence with every one of \p parts on standard error, no document,
/// and no file where the output should have gone. \p arguments are tried with and without --output.
inline void check_refused(const std::string& arguments, int status, const std::vector<std::string>& parts,
                          const std::string& input = "") {
    const Folder folder;
    for (const std::string& output : {std::string(), " --output '" + folder / "result" + "'"}) {
        const Outcome outcome = run_fstiff(arguments + output, input);
        INFO("fstiff " << arguments << output << "\nstandard error: " << outcome.err);
        CHECK(outcome.status == status);
        CHECK(outcome.out.empty());
        CHECK(lines(outcome.err).size() == 1);
        for (const std::string& part : parts) {
            INFO("expected: " << part);
            CHECK(contains(outcome.err, part));
        }
    }
    CHECK(folder.files() == 0);
}

}  // namespace test
