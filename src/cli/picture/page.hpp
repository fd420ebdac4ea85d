// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// One HTML page with its pictures inside: opens without a network, a script or a file beside it.

#include "picture/plot.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff::cli {

class Page {
public:
    explicit Page(std::string title) : title_(std::move(title)) {}
    void heading(std::string_view text) { body_ += "<h2>" + escaped(text) + "</h2>\n"; }
    void paragraph(std::string_view text) { body_ += "<p>" + escaped(text) + "</p>\n"; }
    void list(const std::vector<std::string>& items) {
        body_ += "<ul>\n";
        for (const auto& item : items) body_ += "<li>" + escaped(item) + "</li>\n";
        body_ += "</ul>\n";
    }
    void figure(const Figure& figure, std::string_view caption) {
        body_ += "<figure>\n" + svg(figure);
        if (!caption.empty()) body_ += "<figcaption>" + escaped(caption) + "</figcaption>\n";
        body_ += "</figure>\n";
    }
    /// The first row is the header.
    void table(const std::vector<std::vector<std::string>>& rows) {
        body_ += "<div class=\"wide\"><table>\n";
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::string cell = i == 0 ? "th" : "td";
            body_ += "<tr>";
            for (const auto& text : rows[i]) body_ += "<" + cell + ">" + escaped(text) + "</" + cell + ">";
            body_ += "</tr>\n";
        }
        body_ += "</table></div>\n";
    }
    std::string str() const {
        return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
               "content=\"width=device-width\"><title>" +
               escaped(title_) +
               "</title>\n<style>\n:root{color-scheme:light dark}\nbody{font:15px/1.5 system-ui,'DejaVu "
               "Sans',sans-serif;"
               "max-width:62rem;margin:1.5rem auto;padding:0 1rem;color:#1d1d1f;background:#ffffff}\n"
               "table{border-collapse:collapse;font-size:13px}th,td{border:1px solid #c9c9d0;padding:.25rem .6rem;"
               "text-align:left;vertical-align:top}th{background:#f2f2f5}.wide{overflow-x:auto;margin:.8rem 0}\n"
               "figure{margin:1rem 0}figcaption{font-size:13px}svg{max-width:100%;height:auto}\n"
               "h2{margin-top:2rem;border-bottom:1px solid #c9c9d0}\n"
               "@media screen and (prefers-color-scheme:dark){body{color:#ececf1;background:#16161a}"
               "th{background:#26262c}th,td,h2{border-color:#3a3a42}}\n"
               "@media print{figure,table{break-inside:avoid}}\n</style></head>\n<body>\n<h1>" +
               escaped(title_) + "</h1>\n" + body_ + "</body></html>\n";
    }

private:
    std::string title_, body_;
};

}  // namespace fstiff::cli
