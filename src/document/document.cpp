// SPDX-License-Identifier: BSD-3-Clause
#include "document/document.hpp"

#include "document/file.hpp"

#include <fstiff/core/version.hpp>

#include <algorithm>
#include <memory>
#include <utility>

namespace fstiff::document {

Document Document::of_file(std::function<std::string()> file) {
    Document document("");
    document.json = {};
    document.has_warnings = false;
    document.file = std::move(file);
    return document;
}

void Document::title(std::string_view what) { line("fstiff " FSTIFF_VERSION_TEXT ": " + std::string(what)); }

void Document::line(std::string text) {
    text_.emplace_back([text = std::move(text) + "\n"] { return text; });
}

void Document::line(std::string_view label, std::string_view sentence) {
    const std::size_t width = std::max(label_width_, shown_width(label));
    line("  " + std::string(label) + std::string(width - shown_width(label), ' ') + std::string(sentence));
}

void Document::facts(std::string_view label, const std::vector<Fact>& facts, std::string_view key) {
    std::string sentence;
    for (const Fact& fact : facts) {
        (key.empty() ? json : json[key])[fact.key] = fact.value.json();
        if (key.empty()) facts_.repeat({fact.key}, fact.value, 1);
        if (fact.before) sentence += fact.before + fact.value.text(fact.factor, fact.digits) + fact.after;
    }
    if (!sentence.empty()) label.empty() ? line("  " + sentence) : line(label, sentence);
}

void Document::table(Rows rows, const TableOptions& options) {
    const auto table = std::make_shared<const Rows>(std::move(rows));
    text([table, options] {
        constexpr std::size_t most = 24;
        const std::size_t step = options.thinned.empty() ? 1 : (table->size() + most - 1) / most;
        std::string text =
            table->text([&](std::size_t i) { return i % step == 0 || (options.shown && options.shown(i)); });
        if (step > 1)
            text += "  every " + std::to_string(step) + ". of " + std::to_string(table->size()) + " " +
                    std::string(options.thinned) + "; all with --format csv\n";
        return text;
    });
    csv_.emplace_back([table, options](bool with_header) { return table->csv(with_header, options.csv); });
    if (options.key.empty()) return;
    values([table, options](Json& to) {
        if (options.as_list)
            table->append_to(to[options.key] = Json::array());
        else
            to[options.key] = table->arrays();
    });
}

void Document::csv(std::function<Rows()> rows) {
    csv_.emplace_back([rows = std::move(rows)](bool with_header) { return rows().csv(with_header); });
}

void Document::csv_alone(std::function<Rows()> rows) {
    csv_.clear();
    csv(std::move(rows));
}

std::string Document::text() const {
    std::string text;
    for (const auto& part : text_) text += printable(part(), "\n");
    for (const std::string& warning : warnings)
        for (const std::string& line : wrapped("warning: " + printable(warning), 100)) text += line + "\n";
    return text;
}

std::string Document::csv() const {
    if (file) return file();
    std::string text;
    for (const auto& part : csv_) text += part(text.empty());
    return printable(csv_.empty() ? facts_.csv() : text, "\n");
}

Json Document::values() const {
    Json printed = json;
    for (const auto& part : values_) part(printed);
    if (has_warnings) printed["warnings"] = warnings;
    return printed;
}

std::string Document::str(Format format) const {
    return format == Format::table ? text() : format == Format::csv ? csv() : values().str();
}

}  // namespace fstiff::document
