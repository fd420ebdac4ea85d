// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// One HTML page with its pictures inside: opens without a network, a script or another file.

#include "picture/plot.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff::cli {

/// A sentence that begins with a capital, unless it begins with a symbol or a name of the program.
inline std::string sentence_case(std::string text) {
    std::size_t letters = 0;
    while (letters < text.size() && text[letters] >= 'a' && text[letters] <= 'z') ++letters;
    if (letters > 1 && letters < text.size() && std::string_view(" ,:").find(text[letters]) != std::string_view::npos)
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

class Page {
public:
    explicit Page(std::string title) : title_(std::move(title)) {}
    void heading(std::string_view text) { body_ += "<h2>" + escaped(text) + "</h2>\n"; }
    void paragraph(std::string_view text) { body_ += "<p>" + escaped(text) + "</p>\n"; }
    void list(const std::vector<std::string>& items) {
        if (items.empty()) return;
        body_ += "<ul>\n";
        for (const auto& item : items) body_ += "<li>" + escaped(sentence_case(item)) + "</li>\n";
        body_ += "</ul>\n";
    }
    /// A part of the page, such as <div class="answer">, until end("div").
    void begin(std::string_view tag) { body_ += "<" + std::string(tag) + ">\n"; }
    void end(std::string_view tag) { body_ += "</" + std::string(tag) + ">\n"; }
    /// Content that is shown and printed when it is open; until end("details").
    void begin_details(std::string_view summary) { body_ += "<details><summary>" + escaped(summary) + "</summary>\n"; }
    void figure(const Figure& figure, std::string_view caption) {
        body_ += "<figure>\n" + svg(figure);
        if (!caption.empty()) body_ += "<figcaption>" + escaped(caption) + "</figcaption>\n";
        body_ += "</figure>\n";
    }
    /// The first row is the header.
    void table(const TextRows& rows) {
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
               "Sans',sans-serif;max-width:70rem;margin:1.5rem auto;padding:0 "
               "1rem;color:#1d1d1f;background:#ffffff;overflow-wrap:anywhere}\n"
               "table{border-collapse:collapse;font-size:13px;overflow-wrap:normal}th,td{border:1px solid "
               "#c9c9d0;padding:.25rem .6rem;text-align:left;vertical-align:top}th{background:#f2f2f5}"
               ".wide{overflow-x:auto;margin:.8rem 0}\n"
               "figure{margin:1rem 0}figcaption{font-size:13px}svg{max-width:100%;height:auto}\n"
               "h1{margin:.5rem 0;font-size:1.6rem}h2{margin-top:2rem;border-bottom:1px solid #c9c9d0}\n"
               ".result{border-left:4px solid #1b7f54;padding-left:.8rem}.result.warned{border-color:#b06000}"
               ".result li{margin:.2rem 0}summary{cursor:pointer;font-weight:600}\n"
               "@media screen and (min-width:60rem){.answer,.pair{display:grid;grid-template-columns:1fr 1fr;gap:0 "
               "1.5rem}}\n.answer>div,.pair>*{min-width:0}.answer>div>:first-child,.answer figure{margin-top:0}\n"
               "@media screen and (max-width:40rem){body{margin:.5rem auto;padding:0 .7rem}.fstiff text{font-size:16px "
               "!important}td,th{padding:.2rem .35rem}}\n"
               "@media screen and (prefers-color-scheme:dark){body{color:#ececf1;background:#16161a}"
               "th{background:#26262c}th,td,h2{border-color:#3a3a42}}\n"
               "@page{size:A4;margin:11mm}@media print{body{font-size:9.5pt;line-height:1.3;margin:0;padding:0;"
               "max-width:none}table{font-size:8pt}th,td{padding:.1rem .35rem}figure,tr,li{break-inside:avoid}"
               "figcaption{font-size:8pt}h1{font-size:1.4rem}h2{margin-top:.6rem;break-after:avoid}p,ul{margin:.3rem "
               "0}.wide{margin:.4rem 0}"
               "figure{margin:.4rem 0}figure svg{max-height:80mm;width:auto}.pair figure svg{max-height:47mm}"
               ".pair{display:grid;grid-template-columns:1fr 1fr;gap:0 1rem}}\n</style></head>\n<body>\n<h1>" +
               escaped(title_) + "</h1>\n" + body_ + "</body></html>\n";
    }

private:
    std::string title_, body_;
};

}  // namespace fstiff::cli
