// SPDX-License-Identifier: BSD-3-Clause
// Manual pages in roff, made of the text that --help prints.
#include "input/arguments.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace fstiff::cli {
namespace {

/// \p text as roff prints it, letter by letter; a line must not begin with what roff takes for a command, and a list
/// without blanks may be broken after each comma.
std::string roff(const std::string& text) {
    static constexpr std::string_view letters = "\\-^~`'", names[] = {"e", "-", "(ha", "(ti", "(ga", "(aq"};
    std::string out = text.starts_with('.') ? "\\&" : "";
    for (const char c : text) {
        if (const auto place = letters.find(c); place != std::string_view::npos)
            out += '\\' + std::string(names[place]);
        else
            out += c;
        if (c == ',' && text.find('{') != std::string::npos) out += "\\:";
    }
    return out;
}

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
    return text;
}

/// "Options:", "Measured K:", and what else is one word or two.
bool is_heading(const std::string& line) {
    return line.ends_with(':') && !line.starts_with(' ') && std::count(line.begin(), line.end(), ' ') <= 1;
}

/// "  --tag VALUE   help", or the rest of the help.
std::string entry(const std::string& line) {
    if (line[2] == ' ') return roff(line.substr(line.find_first_not_of(' '))) + "\n";
    const std::size_t end = std::min(line.find("  ", 2), line.size());
    const std::size_t help = std::min(line.find_first_not_of(' ', end), line.size());
    return ".TP\n\\fB" + roff(line.substr(2, end - 2)) + "\\fR\n" +
           (help < line.size() ? roff(line.substr(help)) + "\n" : "");
}

}  // namespace

std::string manual_page(const std::string& name, const std::string& version, const std::string& help,
                        const std::vector<std::string>& also) {
    std::istringstream lines(help);
    std::string about, usage, body, line;
    std::getline(lines, about);
    std::getline(lines, usage);
    if (about.ends_with('.')) about.pop_back();
    bool listed = false, headed = true, kept = false;  // in a list of options, below a heading, among lines set in
    const auto keep = [&](bool now) {
        if (now != kept) body += now ? ".EX\n" : ".EE\n";
        kept = now;
    };
    while (std::getline(lines, line)) {
        const bool heading = is_heading(line);
        keep(!heading && !listed && line.starts_with("  "));
        if (heading) {
            body += ".SH " + upper(line.substr(0, line.size() - 1)) + "\n";
            listed = line != "Example:";
            headed = true;
        } else if (line.empty()) {
            listed = headed = false;
        } else if (listed) {
            body += entry(line);
        } else {
            body += (headed ? "" : ".SH NOTES\n") + roff(line) + "\n";
            headed = true;
        }
    }
    keep(false);
    body += ".SH SEE ALSO\n";
    for (const std::string& page : also)
        body += "\\fB" + roff(page) + "\\fR(1)" + (&page == &also.back() ? "\n" : ",\n");
    return ".TH " + roff(upper(name)) + " 1 \"\" \"" + version + "\" \"Manual of fstiff\"\n.ad l\n.SH NAME\n" +
           roff(name) + " \\- " + roff(about) + "\n.SH SYNOPSIS\n" + roff(usage.substr(usage.find(' ') + 1)) + "\n" +
           body;
}

}  // namespace fstiff::cli
