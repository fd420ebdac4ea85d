// SPDX-License-Identifier: BSD-3-Clause
// fstiff reproduce: the tables, figures and conclusions of the paper, from its own parameters.
#include "commands/commands.hpp"
#include "commands/paper.hpp"
#include "picture/page.hpp"

#include <fstiff/core/version.hpp>

#include <filesystem>
#include <memory>
#include <sstream>

namespace fstiff::cli {

extern const char* const errata_page;  // docs/errata.md

namespace reproduce_command {
namespace {

using namespace paper;

struct Options {
    OutputOptions output;
    std::string folder;
};

constexpr const char* remark =
    "The discussion adds that a smoother surface has the larger D; Table 2 has the largest D, 1.70, on the roughest "
    "one.";

/// The headings of the page of errata.
std::vector<std::string> errata() {
    std::vector<std::string> titles;
    std::istringstream page(errata_page);
    for (std::string line; std::getline(page, line);)
        if (line.starts_with("### ")) titles.push_back(line.substr(4));
    return titles;
}

Rows surface_rows() {
    Rows rows = Rows::under({{"name", "surface"},
                             {"rms_height_m", "σ [µm]", 1e6},
                             {"peak_radius_m", "R [µm]", 1e6},
                             {"peak_density_per_m2", "D_p [1/mm²]", 1e-6},
                             {"max_peak_height_m", "R_p [µm]", 1e6},
                             {"fractal_dimension", "D"},
                             {"fractal_roughness_m", "G [nm]", 1e9}});
    for (const auto& [name, figure, s, fractal] : surfaces)
        rows.add_row({name, s.rms_height, s.peak_radius, s.peak_density, s.max_peak_height, fractal.dimension,
                      fractal.roughness});
    return rows;
}

/// Numbers for all conclusions, or for the one of \p number.
Rows finding_rows(const Reproduction& all, int number = 0) {
    Rows rows = Rows::under({{.key = "conclusion", .shown = "conclusion", .json = false},
                             {"surface", "surface"},
                             {"key"},
                             {"quantity", "quantity"},
                             {"least", "least", 1, 4},
                             {"greatest", "greatest", 1, 4},
                             {.key = "result", .json = false}});
    for (const Finding& f : all.findings) {
        const auto& [key, text, conclusion] = f.words();
        if (number == 0 || number == conclusion)
            rows.add_row({conclusion, f.surface, key, text, f.range.low, f.range.high,
                          all.conclusions[static_cast<std::size_t>(conclusion - 1)].result});
    }
    return rows;
}

std::string page(const Reproduction& all) {
    Page page("The paper reproduced");
    page.paragraph(
        "R. Buczkowski, M. Kleiber, G. Starzyński, Normal contact stiffness of fractal rough surfaces, Arch. Mech. 66 "
        "(2014). Computed by fstiff " FSTIFF_VERSION_TEXT " from Tables 1 and 2. " +
        std::string(no_points));
    page.heading("Tables 1 and 2");
    page.table(surface_rows().table());
    page.paragraph("E₁ = E₂ = 205 GPa, ν = 0.3, Y = 400 MPa, A₀ = 195 mm².");
    page.heading("Conclusions");
    TextRows rows{{"conclusion", "the paper", "result", "numbers"}};
    for (const Conclusion& c : all.conclusions)
        rows.push_back({std::to_string(c.number), c.paper, c.result, c.because});
    page.table(rows);
    page.paragraph(remark);
    page.heading("Numbers for the conclusions");
    page.table(finding_rows(all).table());
    page.heading("Figures");
    for (const Picture& picture : all.pictures) page.figure(picture.figure, picture.caption);
    page.heading("Generated surfaces against the paper");
    page.table(all.generated.table());
    page.heading("Errata");
    page.paragraph("Differences between fstiff and the printed paper; errata.md next to this page has the details.");
    page.list(errata());
    return page.str();
}

std::string table(const Reproduction& all, const std::vector<std::string>& files) {
    std::string text = "fstiff " FSTIFF_VERSION_TEXT
                       ": Buczkowski, Kleiber, Starzyński, Arch. Mech. 66 (2014), reproduced\n\nTables 1 and 2\n" +
                       surface_rows().text() + "\nNumbers for the conclusions\n" + finding_rows(all).text() +
                       "\nGenerated surfaces\n" + all.generated.text() + "\n";
    for (const Conclusion& c : all.conclusions)
        text += "conclusion " + std::to_string(c.number) + ": " + c.paper + "\n  result: " + c.result + "\n  " +
                c.because + "\n";
    text += std::string(remark) + "\n\n" + no_points + "\n\nErrata (in full in errata.md)\n";
    for (const std::string& title : errata()) text += "  " + title + "\n";
    text += "\nFiles\n";
    for (const std::string& file : files) text += "  " + file + "\n";
    return text;
}

std::string json(const Reproduction& all, const std::vector<std::string>& files) {
    Json document = json_document("reproduce");
    document["reference"] = "Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014)";
    document["experimental_points"] = no_points;
    document["remark"] = remark;
    surface_rows().append_to(document["surfaces"]);
    document["youngs_modulus_Pa"] = steel.youngs_modulus;
    document["poisson_ratio"] = steel.poisson_ratio;
    document["nominal_area_m2"] = nominal_area;
    document["seed"] = seed;
    Json& conclusions = document["conclusions"] = Json::array();
    for (const Conclusion& c : all.conclusions) {
        Json numbers;
        finding_rows(all, c.number).append_to(numbers);
        conclusions.push_back({{"number", c.number},
                               {"paper", c.paper},
                               {"result", c.result},
                               {"because", c.because},
                               {"numbers", numbers}});
    }
    all.generated.append_to(document["generated"]);
    document["errata"] = errata();
    document["files"] = files;
    return document.str();
}

Report execute(const Options& options) {
    refuse_standard_output(options.folder, "a folder");
    const std::filesystem::path folder = path_of(options.folder);
    const std::string errata = name_of_path(folder / "errata.md"), index = name_of_path(folder / "index.html");
    require_own(errata);
    require_own(index);
    for (const char* name : {"fig2", "fig4", "fig6", "fig7", "fig8", "fig9"})
        for (const std::string& file : PictureFiles(name_of_path(folder / name) + ".svg").all()) require_own(file);
    const Reproduction all = reproduce();
    std::vector<OutputFile> written;
    for (const Picture& picture : all.pictures)
        for (OutputFile& file : figure_files(picture.figure, name_of_path(folder / (picture.name + ".svg"))))
            written.push_back(std::move(file));
    written.push_back({errata, std::string(page_mark) + errata_page});
    written.push_back({index, page_mark + page(all)});
    deliver(written, options.folder);
    std::vector<std::string> files;
    for (const OutputFile& file : written) files.push_back(file.name);
    const Format format = options.output.format;
    return {format == Format::table ? table(all, files)
            : format == Format::csv ? finding_rows(all).csv()
                                    : json(all, files),
            {},
            success};
}

}  // namespace
}  // namespace reproduce_command

Command add_reproduce(Arguments& command) {
    using namespace reproduce_command;
    auto options = std::make_shared<Options>();
    command.option(
        "-o,--output", options->folder,
        {.help = "folder for the figures and index.html; made when missing", .required = true, .type = "FOLDER"});
    add_format_option(command, options->output);
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
