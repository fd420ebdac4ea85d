// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"
#include "support/skip.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace report_test {

using namespace test;
using Json = nlohmann::json;

namespace {

/// Put into a copy of the report, which itself has no script: what the browser has made of every figure.
constexpr const char* measuring = R"(<script>
const figures = [...document.querySelectorAll("figure > svg")].map(picture => {
    const box = picture.getBoundingClientRect();
    const frames = [...picture.querySelectorAll("rect.frame")].map(f => f.getBoundingClientRect());
    const inside = path => frames.some(f => {
        const b = path.getBoundingClientRect();
        return b.left < f.right && b.right > f.left && b.top < f.bottom && b.bottom > f.top;
    });
    const drawn = path => path.getTotalLength() > 20 && getComputedStyle(path).stroke != "none" && inside(path);
    return {width: box.width, height: box.height, bottom: box.bottom, panels: frames.length,
            lines: [...picture.querySelectorAll(":scope > svg path.line")].filter(drawn).length,
            bands: [...picture.querySelectorAll(":scope > svg path.band")].filter(inside).length,
            windows: [...picture.querySelectorAll(":scope > svg rect.window")].filter(w => w.getBBox().width > 1 && w.getBBox().height > 1).length,
            points: picture.querySelectorAll(":scope > svg g circle").length,
            images: picture.querySelectorAll("image").length};
});
const images = [...document.querySelectorAll("image")].map(async image => {
    const copy = new Image();
    copy.src = image.getAttribute("href");
    await copy.decode();
    return copy.naturalWidth * copy.naturalHeight;
});
Promise.all(images).then(sizes => {
    const answer = document.createElement("pre");
    answer.id = "measured";
    answer.textContent = JSON.stringify({figures, sizes, rows: document.querySelectorAll("tr").length,
                                         result: document.querySelector(".result").getBoundingClientRect().bottom,
                                         wide: document.documentElement.scrollWidth, title: document.title});
    document.body.append(answer);
});
</script>)";

/// What a headless Chromium without a network makes of \p page; null, and the case skipped, where there is no Chromium.
Json rendered(const std::string& page) {
    if (shell("command -v chromium").status != 0) {
        leave_out("there is no chromium (Debian package chromium): the look of the report is not tested");
        return nullptr;
    }
    const Folder folder;
    const std::string file = folder.write("page.html", replaced(page, "</body>", measuring + std::string("</body>")));
    const Outcome outcome = shell(
        "chromium --headless --no-sandbox --disable-gpu --host-resolver-rules='MAP * ~NOTFOUND' "
        "--window-size=1280,1000 "
        "--virtual-time-budget=5000 --user-data-dir='" +
        folder / "profile" + "' --dump-dom 'file://" + file + "'");
    INFO(outcome.err);
    const std::string open = "<pre id=\"measured\">";
    const auto from = outcome.out.find(open);
    REQUIRE(from != std::string::npos);
    const auto begin = from + open.size();
    return Json::parse(outcome.out.substr(begin, outcome.out.find("</pre>", begin) - begin));
}

void check_self_contained(const std::string& page) {
    for (const char* outside : {"<script", "<link", "src=", "@import", "url(", "href=\"http"}) {
        INFO(outside);
        CHECK_FALSE(contains(page, outside));
    }
}

const std::string waves =
    "\n[ultrasound]\nfrequency = \"7 MHz\"\n"
    "upper = { density = \"7850 kg/m^3\", velocity = \"5900 m/s\", shear_velocity = \"3200 m/s\" }\n";

}  // namespace

TEST_CASE("The report of given parameters shows stiffness, reflection, area, contacts and separation") {
    const Folder folder;
    std::string text = read(FSTIFF_SCENES "/sand_blasted_fine.toml");
    text = replaced(text, "[material.upper]", "errors = { rms_height = \"0.08 um\" }\n\n[material.upper]") + waves;
    const std::string scene = folder.write("scene.toml", text);
    const Outcome outcome = run_fstiff("report '" + scene + "' -o '" + folder / "out" + "'");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(contains(outcome.out, folder / "out/report.html"));
    const std::string page = read(folder / "out/report.html");
    check_self_contained(page);
    const std::string sum = shell("sha256sum '" + scene + "'").out.substr(0, 64);
    for (const std::string& part :
         {sum, std::string("surface.rms_height"), std::string("0.832 um"), std::string("plasticity index"),
          std::string("p* = p/(E g_rms)"), std::string("mean contact pressure"), std::string("σ R D_p"),
          std::string("(3.14), (4.9)"), std::string("computed by fstiff ")}) {
        INFO(part);
        CHECK(contains(page, part));
    }
    // the numbers are those of run
    const Csv run(run_fstiff("run '" + scene + "' --format csv").out);
    const double stiffness = run.number(10, "stiffness_Pa_per_m") / 1e12;
    char shown[32];
    std::snprintf(shown, sizeof shown, "%.5g", stiffness);
    CHECK(contains(page, "<td>" + std::string(shown) + "</td>"));

    const Json seen = rendered(page);
    if (seen.is_null()) return;
    INFO(seen.dump(1));
    REQUIRE(seen.at("figures").size() == 6);  // K, R, shear R; area, contacts, separation
    const Json& k = seen["figures"][0];
    CHECK(k["width"].get<double>() > 400);
    CHECK(k["height"].get<double>() > 400);
    CHECK(k["lines"] == 1 + 5 + 1);  // the answer, five laws and p/(0.48 sigma)
    CHECK(k["windows"] == 1);
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(seen["figures"][i]["panels"] == 1);
        CHECK(seen["figures"][i]["lines"] >= (i < 3 ? 6 : 5));
        CHECK(seen["figures"][i]["bands"] == (i < 3 ? 6 : 0));
    }
    CHECK(seen["wide"].get<double>() <= 1280);
    // the answer is on the first screen: the picture, and the result next to it
    CHECK(k["bottom"].get<double>() < 1000);
    CHECK(seen["result"].get<double>() < 1000);
}

TEST_CASE("The report shows the conductances that a scene asks for, with the band of K") {
    const Folder folder;
    const std::string scene = folder.write("heat.toml",
                                           "material.upper = { name = \"steel\", hardness = \"infinite\" }\n"
                                           "material.lower = { name = \"aluminium\", hardness = \"infinite\" }\n"
                                           "[surface]\nSq = \"0.8 um\"\nSdq = 0.1\n[contact]\n"
                                           "pressures = [\"1 MPa\", \"10 MPa\"]\n[gap]\nmedium = \"helium\"\n");
    REQUIRE(run_fstiff("report '" + scene + "' -o '" + folder / "out" + "'").status == 0);
    const std::string page = read(folder / "out/report.html");
    // what run prints of the same scene, in the form of the page
    const Csv rows(run_fstiff("run '" + scene + "' --format csv").out);
    const auto shown = [&](const char* column) {
        const double value = rows.number(0, column), step = std::pow(10, std::floor(std::log10(value)) - 2);
        return std::to_string(std::lround(std::round(value / step) * step));
    };
    CHECK(contains(page, shown("thermal_conductance_W_per_m2K") + " (" + shown("thermal_conductance_p05_W_per_m2K") +
                             " to " + shown("thermal_conductance_p95_W_per_m2K") + ")"));
    CHECK(contains(page, "h of the gap [W/(m² K)]"));
    CHECK_FALSE(contains(page, "the lower is assumed to be as the upper"));
    const Json seen = rendered(page);
    if (seen.is_null()) return;
    REQUIRE(seen.at("figures").size() == 5);  // K, h, area, contacts, separation
    CHECK(seen["figures"][1]["bands"] == 1);
}

TEST_CASE("The report of a measured profile shows it, its bearing curve and its structure function") {
    const Folder folder;
    REQUIRE(
        run_fstiff("generate profile --points 8192 --spacing \"0.5 um\" --hurst 0.5 --rms \"1 um\" --longest \"1 mm\" "
                   "--shortest \"4 um\" -o '" +
                   folder / "profile.csv" + "'")
            .status == 0);
    const Outcome outcome = run_fstiff("report --surface '" + folder / "profile.csv" + "' -o '" + folder / "out" + "'");
    INFO(outcome.err);
    REQUIRE((outcome.status == 0 || outcome.status == 4));
    const std::string page = read(folder / "out/report.html");
    check_self_contained(page);
    CHECK(contains(page, shell("sha256sum '" + folder / "profile.csv" + "'").out.substr(0, 64)));
    const Json seen = rendered(page);
    if (seen.is_null()) return;
    INFO(seen.dump(1));
    // K, area, separation; profile, bearing curve, structure function, λs, λc
    REQUIRE(seen.at("figures").size() == 3 + 5);
    CHECK(seen["figures"][0]["bands"].get<int>() > 0);
    CHECK(seen["figures"][3]["lines"] == 1);
    CHECK(seen["figures"][4]["lines"] == 1);
    CHECK(seen["figures"][5]["points"] > 20);
    CHECK(seen["figures"][5]["lines"] == 1);
    CHECK(seen["figures"][5]["windows"] == 1);
    CHECK(seen["figures"][6]["lines"].get<int>() >= 5);  // K, sigma, gradient, R, D_p with other cut-offs
    CHECK(contains(page, "Influence of the cut-offs"));
    CHECK(contains(page, "Structure function of second differences"));
    CHECK(contains(page, "share of peaks counted, which differs where heights are not Gaussian"));
    CHECK_FALSE(contains(page, "<th></th>"));
}

TEST_CASE("The report of a measured map shows it in colours") {
    const Folder folder;
    REQUIRE(
        run_fstiff(
            "generate map --points 200 --rows 160 --spacing \"1 um\" --hurst 0.6 --rms \"1 um\" --shortest \"8 um\" "
            "--format sdf -o '" +
            folder / "map.sdf" + "'")
            .status == 0);
    const Outcome outcome = run_fstiff("report --surface '" + folder / "map.sdf" + "' -o '" + folder / "out" + "'");
    INFO(outcome.err);
    REQUIRE((outcome.status == 0 || outcome.status == 4));
    const std::string page = read(folder / "out/report.html");
    check_self_contained(page);
    // the windows of the fits along x and y have the colours of their curves
    CHECK(contains(page, "class=\"window fc0 c0\""));
    CHECK(contains(page, "class=\"window fc1 c1\""));
    // the pair that was chosen is in both pictures of the islands, as fstiff measure --show islands gives it
    const Csv islands(run_fstiff("measure --show islands '" + folder / "map.sdf" + "' --format csv").out);
    std::size_t most = 0;
    for (std::size_t i = 0; i < islands.size(); ++i)
        if (islands.number(i, "density_per_m2") > islands.number(most, "density_per_m2")) most = i;
    char level[80];
    std::snprintf(level, sizeof level, "level chosen: %.3g %%, R = %.3g µm", 100 * islands.number(most, "bearing_area"),
                  islands.number(most, "radius_m") * 1e6);
    INFO(level);
    CHECK(contains(page, level));
    const Json seen = rendered(page);
    if (seen.is_null()) return;
    INFO(seen.dump(1));
    REQUIRE(seen.at("figures").size() == 3 + 7);  // map, bearing curve, structure, islands and their radius; λs, λc
    CHECK(seen["figures"][3]["images"] == 2);
    REQUIRE(seen["sizes"].size() == 2);
    CHECK(seen["sizes"][0] == 200 * 160);
    CHECK(seen["sizes"][1] == 255);
    CHECK(seen["figures"][5]["windows"].get<int>() >= 1);
    CHECK(seen["figures"][6]["lines"] == 1);
}

TEST_CASE("report -o FILE.html writes that file, whether its folder exists or not, and -o FOLDER its report.html") {
    const Folder folder;
    for (const char* place : {"page.html", "new/deep/page.html"}) {
        const Outcome outcome = run_fstiff("report -o '" + folder / place + "'");
        CHECK(outcome.status == 0);
        CHECK(contains(outcome.out, folder / place));
        REQUIRE(std::filesystem::is_regular_file(folder / place));
        CHECK(contains(read(folder / place), "<!doctype html>"));
        CHECK(run_fstiff("report -o '" + folder / place + "'").status == 0);  // over itself
    }
    REQUIRE(run_fstiff("report -o '" + folder / "new" + "'").status == 0);
    CHECK(std::filesystem::is_regular_file(folder / "new/report.html"));
    const std::string foreign = folder.write("mine.html", "<p>mine</p>");
    CHECK(run_fstiff("report -o '" + foreign + "'").status == 3);
    CHECK(read(foreign) == "<p>mine</p>");
}

TEST_CASE("The report has the hardness, and is amber where a K is lost") {
    const Folder folder;
    const auto page = [&](const std::string& upper, const std::string& contact, int status) {
        const std::string scene = folder.write("s.toml",
                                               "[surface]\nSq = \"0.8 um\"\nSdq = 0.1\n[material.upper]\nname = "
                                               "\"steel\"\n" +
                                                   upper + "[contact]\n" + contact);
        CHECK(run_fstiff("report '" + scene + "' -o '" + folder / "s.html" + "'").status == status);
        return read(folder / "s.html");
    };
    const std::string soft = "hardness = \"20 MPa\"\n", warned = "class=\"result warned\"";
    const std::string lost = page(soft, "laws = [\"hertz\"]\npressures = [\"25 MPa\"]\n", 4);
    for (const char* part : {"hardness 20 MPa", "class=\"result warned\"", "Result: doubtful", "The answer has no K"})
        CHECK(contains(lost, part));
    const std::string partly = page(soft, "pressures = [\"1 MPa\", \"25 MPa\"]\n", 4);
    CHECK(contains(partly, "o K at 25 MPa: at the hardness, 20 MPa"));
    CHECK(contains(partly, warned));
    const std::string open = page("", "pressures = [\"1 MPa\"]\n", 0);
    CHECK_FALSE(contains(open, warned));
    CHECK(contains(open, "hardness 2.6 GPa (1.2 GPa to 9.5 GPa), of steel (assumed)"));
    CHECK(contains(page("hardness = \"infinite\"\n", "pressures = [\"1 MPa\"]\n", 0), ", never yields"));
    const std::string sound = page("hardness = \"2 GPa\"\n", "pressures = [\"1 MPa\"]\n", 0);
    CHECK_FALSE(contains(sound, warned));
    CHECK(contains(sound, "the other face is smooth"));
}

TEST_CASE("report refuses what run refuses, and leaves no folder then") {
    const Folder folder;
    const Outcome bad = run_fstiff("report '" + folder.write("bad.toml", "x = 1") + "' -o '" + folder / "out" + "'");
    CHECK(bad.status == 3);
    CHECK(lines(bad.err).size() == 1);
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
    CHECK(run_fstiff("report").status == 2);
}

TEST_CASE("The report begins with the answer and names the assumed material") {
    const Folder folder;
    REQUIRE(run_fstiff("report -o '" + folder / "builtin" + "'").status == 0);
    const std::string page = read(folder / "builtin/report.html");
    CHECK(contains(page,
                   "Material assumed, not given: steel of the built-in scene, E = 205 GPa, ν = 0.3 of both bodies"));
    const auto before_inputs = [&](const std::string& text) { return page.find(text) < page.find("<h2>Inputs</h2>"); };
    for (const char* part : {"rms height σ = 0.832 µm", "<td>0.1 MPa</td>", "<td>100 MPa</td>", "90 % band",
                             "Not in the band: ", "Assumed: rms gradient 0.15 (", "<figure>"}) {
        INFO(part);
        CHECK(before_inputs(part));
    }
    // K at 10 MPa is that of run, in the unit of the table
    const Csv run(run_fstiff("run --format csv").out);
    char shown[32];
    std::snprintf(shown, sizeof shown, "<td>%.3g</td>", run.number(20, "stiffness_Pa_per_m") / 1e12);
    CHECK(before_inputs(shown));
    CHECK(before_inputs("<th>K/A0 [MPa/µm]</th>"));  // the numbers of the table are between 1 and 1000
    CHECK(before_inputs("K/A₀ [MPa/µm]</text>"));    // and the picture next to it has the same unit
    CHECK(before_inputs("<li>The peaks yield"));
    CHECK(before_inputs("class=\"brief\">The peaks yield"));  // the explanation in the picture
    const std::string scene = folder.write("scene.toml", replaced(read(FSTIFF_SCENES "/../docs/stiffness.toml"),
                                                                  "[material.lower]\nyoungs_modulus = "
                                                                  "\"205 GPa\"",
                                                                  "[material.lower]\nyoungs_modulus = \"70 GPa\""));
    REQUIRE(run_fstiff("report '" + scene + "' -o '" + folder / "own" + "'").status == 0);
    const std::string own = read(folder / "own/report.html");
    CHECK(contains(own, "Material: E = 205 GPa, ν = 0.3 on E = 70 GPa, ν = 0.3, hardness "));
    CHECK_FALSE(contains(own, "Material assumed"));
    CHECK(contains(own, "<td>0.86"));  // K with its band in brackets
    CHECK(contains(own, " to "));
}

TEST_CASE("The printed report of a measured surface begins with its answer and has few pages") {
    if (shell("command -v chromium").status != 0 || shell("command -v pdftotext").status != 0)
        SKIP_CASE("there is no chromium or no pdftotext (Debian packages chromium, poppler-utils): nothing is printed");
    const Folder folder;
    const std::string how =
        " --points 128 --spacing '1 um' --hurst 0.7 --rms '0.5 um' --shortest '6 um' --longest '60 um'";
    REQUIRE(run_fstiff("generate map" + how + " -o '" + folder / "map.txt" + "'").status == 0);
    REQUIRE(
        run_fstiff("generate profile --points 8192 --spacing '0.5 um' --hurst 0.5 --rms '1 um' --longest '1 mm' -o '" +
                   folder / "trace.txt" + "'")
            .status == 0);
    const std::string upper = "[surface.upper]\nfrom = \"map.txt\"\n", lower = "[surface.lower]\nfrom = \"map.txt\"\n",
                      steel = "youngs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n";
    const std::string two =
        folder.write("two.toml", upper + lower + "[material.upper]\n" + steel + "[material.lower]\n" + steel +
                                     "[contact]\npressures = [\"1 MPa\", \"1 GPa\"]\n");
    for (const std::string& surface :
         {"--surface '" + folder / "map.txt" + "'", "--surface '" + folder / "trace.txt" + "'", "'" + two + "'"}) {
        INFO(surface);
        REQUIRE(run_fstiff("report " + surface + " -o '" + folder / "out" + "'").status % 4 == 0);
        const std::string pdf = folder / "out.pdf";
        REQUIRE(shell("chromium --headless --no-sandbox --disable-gpu --host-resolver-rules='MAP * ~NOTFOUND' "
                      "--virtual-time-budget=5000 --user-data-dir='" +
                      folder / "profile" + "' --no-pdf-header-footer --print-to-pdf='" + pdf + "' 'file://" +
                      folder / "out/report.html" + "'")
                    .status == 0);
        const std::string first = shell("pdftotext -l 1 '" + pdf + "' -").out,
                          all = shell("pdftotext '" + pdf + "' -").out;
        for (const char* part : {"Surface measured from", "K/A₀ [", "Result: "}) {
            INFO(part);
            CHECK(contains(first, part));
        }
        const auto pages = std::count(all.begin(), all.end(), '\f');
        CHECK(pages >= 2);
        CHECK(pages <= 6);
    }
}

TEST_CASE("A report gives no sentence three times") {
    const Folder folder;
    // too few lags for D: the reason is among the warnings and under the surface
    REQUIRE(run_fstiff("generate profile --points 400 --spacing '1 um' --hurst 0.8 --rms '1 um' --shortest '40 um' "
                       "--longest '60 um' -o '" +
                       folder / "trace.txt" + "'")
                .status == 0);
    REQUIRE(run_fstiff("report --surface '" + folder / "trace.txt" + "' -o '" + folder / "out" + "'").status % 4 == 0);
    const std::string page = read(folder / "out/report.html"), start = "No D and G: ";
    const auto at = page.find(start);
    REQUIRE(at != std::string::npos);
    const std::string reason = page.substr(at + start.size(), 30);
    std::size_t times = 0;
    for (auto found = page.find(reason); found != std::string::npos; found = page.find(reason, found + 1)) ++times;
    INFO(reason);
    CHECK(times <= 2);
}

TEST_CASE("The report fits a telephone and is printed on few pages") {
    if (shell("command -v chromium").status != 0)
        SKIP_CASE("there is no chromium: the look of the report is not tested");
    const Folder folder;
    REQUIRE(run_fstiff("report '" FSTIFF_SCENES "/../docs/stiffness.toml' -o '" + folder / "out" + "'").status == 0);
    const std::string file = folder / "out/report.html",
                      start =
                          "chromium --headless --no-sandbox --disable-gpu "
                          "--host-resolver-rules='MAP * ~NOTFOUND' --virtual-time-budget=5000 --user-data-dir='" +
                          folder / "profile" + "' ";
    REQUIRE(shell(start + "--no-pdf-header-footer --print-to-pdf='" + folder / "out.pdf" + "' 'file://" + file + "'")
                .status == 0);
    std::size_t pages = 0;
    const std::string pdf = read(folder / "out.pdf");
    for (auto at = pdf.find("/Type /Page\n"); at != std::string::npos; at = pdf.find("/Type /Page\n", at + 1)) ++pages;
    CHECK(pages >= 1);
    CHECK(pages <= 4);

    // headless windows are not narrower than 500: a frame of 390 is
    std::string inside = read(file);
    for (const auto& [from, to] : {std::pair("&", "&amp;"), std::pair("\"", "&quot;")})
        for (auto at = inside.find(from); at != std::string::npos; at = inside.find(from, at + std::string(to).size()))
            inside.replace(at, 1, to);
    const std::string phone =
        folder.write("phone.html",
                     "<!doctype html><iframe width=390 height=844 frameborder=0 srcdoc=\"" + inside +
                         "\"></iframe><pre id=answer></pre><script>onload = () => { const page = "
                         "document.querySelector('iframe').contentDocument; answer.textContent = 'wide ' + "
                         "page.documentElement.scrollWidth + ' text ' + Math.min(...[...page.querySelectorAll('.fstiff "
                         "text')].map(t => t.getBoundingClientRect().height)); }</script>");
    const Outcome seen = shell(start + "--dump-dom 'file://" + phone + "'");
    const auto at = seen.out.find("wide ", seen.out.find("id=\"answer\""));
    REQUIRE(at != std::string::npos);
    INFO(seen.out.substr(at, 60));
    CHECK(std::stod(seen.out.substr(at + 5)) <= 390);
    CHECK(std::stod(seen.out.substr(seen.out.find("text ", at) + 5)) > 9);  // readable: the lines of text are 9 high
}

}  // namespace report_test
