// SPDX-License-Identifier: BSD-3-Clause
#include "input/output_options.hpp"

namespace fstiff::cli {

void add_format_option(Arguments& arguments, OutputOptions& options, Format initial) {
    options.format = initial;
    options.for_people = initial != Format::table;
    const std::function<void(const std::string&)> take = [&options](const std::string& word) {
        options.format = *parts::find_named<Format>(word);
        options.for_people = false;
    };
    arguments
        .option("--format", take,
                "table, csv or json; default " + std::string(name_of(initial)) +
                    (options.for_people ? ", and table on a terminal" : ""))
        .one_of(parts::choices<Format>())
        .type_name("FORMAT");
}

void add_output_options(Arguments& arguments, OutputOptions& options, Format initial) {
    add_format_option(arguments, options, initial);
    add_output_option(arguments, options);
}

void add_output_option(Arguments& arguments, OutputOptions& options) {
    arguments.option("-o,--output", options.file, "write to FILE instead of standard output, which - is")
        .type_name("FILE");
}

}  // namespace fstiff::cli
