// SPDX-License-Identifier: BSD-3-Clause
// fstiff formats: the files that are read.
#include "commands/commands.hpp"
#include "io/readers.hpp"

#include <memory>

namespace fstiff::cli {
namespace formats_command {
namespace {

/// A file that some command reads.
struct Row {
    std::string_view name;  ///< as --input-format names it, for a surface
    std::string_view endings, holds, recognised, asked;
};

constexpr Row other_files[] = {
    {"scene", ".toml", "TOML, as run --example prints it", "an argument of run, identify and report", "nothing"},
    {"surface", ".json", "the JSON of measure", "an argument of --surface, or surface.from in a scene", "nothing"},
    {"curve", ".csv", "text: pressure, and stiffness or reflection, with their errors if they are known",
     "an argument of identify --measured or ultrasound --reflection", "the columns and units in its first line"}};

document::Document formats() {
    document::Document document("formats", 15);
    document.title("files that are read");
    std::vector<Row> rows;
    for (const io::detail::Reader* reader : io::detail::readers())
        rows.push_back({name_of(reader->format), reader->endings, reader->holds, reader->recognised, reader->asks_for});
    rows.insert(rows.end(), std::begin(other_files), std::end(other_files));
    for (const Row& row : rows) {
        document.line("\n" + std::string(row.name) + "  (" + std::string(row.endings) + ")");
        document.line("holds", row.holds);
        document.line("recognised by", row.recognised);
        document.line("needs", row.asked);
    }
    document.line(
        "\nThe first " + std::to_string(io::detail::readers().size()) +
        " are profiles and maps, for measure, truth and run --surface. The name of a file\n"
        "is not used; --input-format overrides what was recognised. Text may be UTF-8, UTF-16 with a byte\n"
        "order mark, or of an 8-bit code page. Export files of other instruments from their own program, or convert\n"
        "them to X3P by a line of Python (docs/formats.md).");
    document::Rows table;
    table.add({"name"}, rows, &Row::name);
    table.add({"endings"}, rows, &Row::endings);
    table.add({"holds"}, rows, &Row::holds);
    table.add({"recognised_by"}, rows, &Row::recognised);
    table.add({"asks_for"}, rows, &Row::asked);
    document.table(std::move(table), {.key = "formats", .as_list = true});
    document.has_warnings = false;
    return document;
}

}  // namespace
}  // namespace formats_command

Command add_formats(Arguments& command) {
    using namespace formats_command;
    auto options = std::make_shared<OutputOptions>();
    add_output_options(command, *options);
    return {options.get(), [options] { return report(formats(), options->format); }};
}

}  // namespace fstiff::cli
