// SPDX-License-Identifier: BSD-3-Clause
#include "input/output_options.hpp"

namespace fstiff::cli {

void add_format_option(Arguments& arguments, OutputOptions& options, document::Format initial) {
    options.format = initial;
    options.for_people = initial != document::Format::table;
    const request::Field field{.help = "table, csv or json; default " + std::string(name_of(initial)) +
                                       (options.for_people ? ", and table on a terminal" : ""),
                               .type = "FORMAT"};
    constexpr auto words = detail::choices<document::Format>();
    arguments.add("--format", field,
                  {"",
                   {words.begin(), words.end()},
                   "",
                   &options,
                   [](const request::Value& value, void* member, const std::string& key, const request::Field& range) {
                       auto& output = *static_cast<OutputOptions*>(member);
                       request::put(value, output.format, key, range);
                       output.for_people = false;
                   }});
}

void add_output_options(Arguments& arguments, OutputOptions& options, document::Format initial) {
    add_format_option(arguments, options, initial);
    add_output_option(arguments, options);
}

void add_output_option(Arguments& arguments, OutputOptions& options) {
    arguments.option("-o,--output", options.file,
                     {.help = "write to FILE instead of standard output, which - is", .type = "FILE"});
}

}  // namespace fstiff::cli
