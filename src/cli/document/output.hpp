// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Result of a subcommand and its output: one document, with numbers that are independent of the locale and never NaN.

#include "document/document.hpp"
#include "document/file.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::cli {

/// Exit codes of the command.
enum Status : int { success = 0, internal_error = 1, usage_error = 2, input_error = 3, doubtful_result = 4 };

/// Options that do not fit together: exit code 2.
class Usage : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct OutputOptions {
    document::Format format = document::Format::table;
    bool for_people = false;  ///< on a terminal the table, unless a format is given
    std::string file;         ///< as it was given; empty: standard output
    bool force = false;       ///< the file is replaced whoever made it

    /// The file to write; empty for standard output, which "-" is too.
    [[nodiscard]] std::string target() const;
    /// How the document is written there.
    [[nodiscard]] document::Format chosen() const;
};

/// The one document of a subcommand, its diagnostics (on standard error), and how it ended.
struct Report {
    std::string document;
    std::vector<std::string> diagnostics;
    Status status = success;
};

/// What of \p document goes where in this form: the warnings are in its table, else on standard error.
[[nodiscard]] Report report(const document::Document& document, document::Format format);
/// Puts a line about each of \p files before the other diagnostics.
void say_written(Report& report, const std::vector<std::string>& files);

/// A file to write, and what goes into it.
struct OutputFile {
    std::string name, text;
};

/// Files that are written next to their targets, and take their names when all are complete. Until then, and where this
/// ends before, by an exception or Ctrl-C, what was there remains. A pipe or a device is written as it is.
class OutputFiles {
public:
    /// \throws file_error, as all functions here, naming the file that cannot be written and the reason of the system.
    explicit OutputFiles(const std::vector<std::string>& names);
    OutputFiles(const OutputFiles&) = delete;
    OutputFiles& operator=(const OutputFiles&) = delete;
    ~OutputFiles();
    /// Appends \p text to the file of that \p number.
    void write(std::size_t number, std::string_view text);
    void finish();

private:
    OutputFiles();
    struct Open;
    std::vector<Open> files_;
};

/// Writes \p document to \p file, or to standard output when \p file is empty.
/// \throws file_error as below, domain_error for standard output, with the reason that the system gives.
void deliver(const std::string& document, const std::string& file);
/// Writes all of \p files or none. \throws file_error as OutputFiles.
void deliver(const std::vector<OutputFile>& files);

/// Inputs that the command line names: files, as far as they exist.
void name_inputs(std::vector<std::string> texts);
/// Before anything is read: this process is going to write \p file, which is none of the inputs, whatever the names
/// that lead to it. \throws file_error where it is one, or was to be written before.
void keep_for_output(const std::string& file);
/// For a file that an input names. \throws file_error where it is kept for the output.
void require_no_output(const std::string& input);
/// Before a long computation. \throws file_error where the folder of \p file is not there, or \p file is a folder or
/// protected from writing.
void require_writable(const std::string& file);

}  // namespace fstiff::cli
