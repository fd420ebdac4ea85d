// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"
#include "support/skip.hpp"

#include <nlohmann/json.hpp>

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
    return {width: box.width, height: box.height, panels: frames.length,
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
    const Outcome outcome = fstiff("report '" + scene + "' -o '" + folder / "out" + "'");
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
    const Csv run(fstiff("run '" + scene + "' --format csv").out);
    const double stiffness = run.number(10, "stiffness_Pa_per_m") / 1e15;
    char shown[32];
    std::snprintf(shown, sizeof shown, "%.5g", stiffness);
    CHECK(contains(page, "<td>" + std::string(shown) + "</td>"));

    const Json seen = rendered(page);
    if (seen.is_null()) return;
    INFO(seen.dump(1));
    REQUIRE(seen.at("figures").size() == 2);
    const Json &k = seen["figures"][0], &others = seen["figures"][1];
    CHECK(k["width"].get<double>() > 500);
    CHECK(k["height"].get<double>() > 600);
    CHECK(k["panels"] == 3);     // K, R, shear R
    CHECK(k["lines"] >= 5 * 3);  // five curves in each, and p/(0.48 sigma)
    CHECK(k["bands"] == 5 * 3);
    CHECK(k["windows"] == 1);
    CHECK(others["panels"] == 3);
    CHECK(others["lines"] == 5 * 3);
    CHECK(seen["wide"].get<double>() <= 1280);
}

TEST_CASE("The report of a measured profile shows it, its bearing curve and its structure function") {
    const Folder folder;
    REQUIRE(fstiff("generate profile --points 8192 --spacing \"0.5 um\" --hurst 0.5 --rms \"1 um\" --longest \"1 mm\" "
                   "--shortest \"4 um\" -o '" +
                   folder / "profile.csv" + "'")
                .status == 0);
    const Outcome outcome = fstiff("report --surface '" + folder / "profile.csv" + "' -o '" + folder / "out" + "'");
    INFO(outcome.err);
    REQUIRE((outcome.status == 0 || outcome.status == 4));
    const std::string page = read(folder / "out/report.html");
    check_self_contained(page);
    CHECK(contains(page, shell("sha256sum '" + folder / "profile.csv" + "'").out.substr(0, 64)));
    const Json seen = rendered(page);
    if (seen.is_null()) return;
    INFO(seen.dump(1));
    REQUIRE(seen.at("figures").size() == 4);
    CHECK(seen["figures"][0]["panels"] == 2);
    CHECK(seen["figures"][0]["lines"] == 2);
    CHECK(seen["figures"][1]["points"] > 20);
    CHECK(seen["figures"][1]["lines"] == 1);
    CHECK(seen["figures"][1]["windows"] == 1);
    CHECK(seen["figures"][2]["bands"].get<int>() > 0);
}

TEST_CASE("The report of a measured map shows it in colours") {
    const Folder folder;
    REQUIRE(
        fstiff("generate map --points 200 --rows 160 --spacing \"1 um\" --hurst 0.6 --rms \"1 um\" --shortest \"8 um\" "
               "--format sdf -o '" +
               folder / "map.sdf" + "'")
            .status == 0);
    const Outcome outcome = fstiff("report --surface '" + folder / "map.sdf" + "' -o '" + folder / "out" + "'");
    INFO(outcome.err);
    REQUIRE((outcome.status == 0 || outcome.status == 4));
    const std::string page = read(folder / "out/report.html");
    check_self_contained(page);
    const Json seen = rendered(page);
    if (seen.is_null()) return;
    INFO(seen.dump(1));
    REQUIRE(seen.at("figures").size() == 5);
    CHECK(seen["figures"][0]["images"] == 2);
    REQUIRE(seen["sizes"].size() == 2);
    CHECK(seen["sizes"][0] == 200 * 160);
    CHECK(seen["sizes"][1] == 255);
    CHECK(seen["figures"][1]["windows"].get<int>() >= 1);
    CHECK(seen["figures"][2]["lines"] == 1);  // islands
}

TEST_CASE("report refuses what run refuses, and leaves no folder then") {
    const Folder folder;
    const Outcome bad = fstiff("report '" + folder.write("bad.toml", "x = 1") + "' -o '" + folder / "out" + "'");
    CHECK(bad.status == 3);
    CHECK(lines(bad.err).size() == 1);
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
    CHECK(fstiff("report").status == 2);
}
