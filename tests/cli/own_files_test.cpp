// SPDX-License-Identifier: BSD-3-Clause
// The files that an output replaces: those that fstiff made, in every form that it prints, and no other one.
#include "cli/command.hpp"

#include <filesystem>

namespace own_files_test {

using namespace test;

namespace {

/// Runs fstiff \p arguments in \p folder.
Outcome in(const Folder& folder, const std::string& arguments) {
    return shell("cd '" + (folder / "") + "' && fstiff " + arguments);
}

/// A folder with a trace, a map, a curve and a scene of fstiff.
void fill(const Folder& folder) {
    const std::string points = " --spacing '1 um' --hurst 0.7 --rms '1 um' ";
    REQUIRE(in(folder, "generate profile --points 512" + points + "-o p.csv").status == 0);
    REQUIRE(in(folder, "generate map --points 64 --shortest '4 um' --longest '16 um'" + points + "-o m.csv").status ==
            0);
    folder.write("r.csv", "pressure [MPa],reflection,error\n1,0.9,0.01\n3,0.8,0.01\n10,0.6,0.01\n");
    folder.write(
        "s.toml",
        "[surface]\nrms_height = \"0.8 um\"\nrms_gradient = 0.12\n[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\n");
    folder.write("ball.toml",
                 "[surface]\nrms_height = \"0.8 um\"\n[contact]\nball_radius = \"10 mm\"\nforce = \"10 N\"\n"
                 "[uncertainty]\nsamples = 0\n");
}

}  // namespace

TEST_CASE("An output over a foreign file ends with exit code 3, and the file is kept") {
    const Folder folder;
    fill(folder);
    const std::string trace = "x [um],z [um]\n0,0.000\n1,0.820\n2,1.640\n3,0.440\n";
    folder.write("trace.csv", trace);
    folder.write("thesis.txt", "my thesis\n");
    folder.write("drawing.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n");
    std::filesystem::create_symlink("thesis.txt", folder / "link.txt");
    std::filesystem::create_directory(folder / "folder.svg");
    for (const auto& [arguments, name] :
         {std::pair("run s.toml -o trace.csv", "trace.csv"),
          std::pair("run s.toml --format csv -o trace.csv", "trace.csv"),
          std::pair("measure p.csv -o thesis.txt", "thesis.txt"), std::pair("measure p.csv -o link.txt", "link.txt"),
          std::pair("run s.toml --plot drawing.svg", "drawing.svg"),
          std::pair("run --example -o thesis.txt", "thesis.txt"), std::pair("formats -o thesis.txt", "thesis.txt"),
          std::pair("export s.toml --to abaqus -o trace.csv", "trace.csv"),
          std::pair("generate profile --points 64 --spacing '1 um' --hurst 0.7 --rms '1 um' -o thesis.txt",
                    "thesis.txt")}) {
        const Outcome outcome = in(folder, arguments);
        check_refusal(outcome, arguments, 3, {name, "was not made by fstiff", "--force"});
    }
    check_refusal(in(folder, "run s.toml --plot folder.svg"), "--plot folder.svg", 3, {"is a folder"});
    CHECK(read(folder / "trace.csv") == trace);
    CHECK(read(folder / "thesis.txt") == "my thesis\n");
    CHECK(read(folder / "drawing.svg") == "<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n");
}

TEST_CASE("The option --force replaces a foreign file, and no input") {
    const Folder folder;
    fill(folder);
    folder.write("thesis.txt", "my thesis\n");
    folder.write("drawing.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n");
    folder.write("drawing.plot.csv", "1,2\n");
    CHECK(in(folder, "run s.toml -o thesis.txt --force --plot drawing.svg").status == 0);
    CHECK(read(folder / "thesis.txt").starts_with("fstiff 0."));
    CHECK(contains(read(folder / "drawing.svg"), "class=\"fstiff\""));
    CHECK(read(folder / "drawing.plot.csv").starts_with("# fstiff "));
    check_refusal(in(folder, "run s.toml -o s.toml --force"), "-o s.toml", 3, {"s.toml", "is an input"});
}

TEST_CASE("An empty file, a new one and a pipe are written") {
    const Folder folder;
    fill(folder);
    folder.write("empty.txt", "");
    std::filesystem::create_symlink("target.txt", folder / "dangling.txt");
    CHECK(in(folder, "run s.toml -o empty.txt").status == 0);
    CHECK(in(folder, "run s.toml -o dangling.txt").status == 0);
    CHECK(read(folder / "target.txt") == read(folder / "empty.txt"));
    CHECK(in(folder, "run s.toml -o /dev/null").status == 0);
    CHECK(in(folder, "run s.toml -o /dev/stdout | cat").out == read(folder / "empty.txt"));
}

TEST_CASE("Every form of an output replaces an earlier output of any command", "[more]") {
    const Folder folder;
    fill(folder);
    std::vector<std::string> calls{
        "run --example",
        "run --example paper",
        "generate profile --points 64 --spacing '1 um' --hurst 0.7 --rms '1 um'",
        "generate wm --points 64 --spacing '1 um' --dimension 1.5 --roughness '1 nm'",
        "generate profile --points 64 --spacing '1 um' --hurst 0.7 --rms '1 um' --format sdf",
        "generate map --points 16 --spacing '1 um' --hurst 0.7 --rms '1 um' --format sdf-text",
        "generate map --points 16 --spacing '1 um' --hurst 0.7 --rms '1 um'"};
    for (const char* to : {"law", "calculix", "abaqus", "moose", "comsol"})
        calls.push_back("export s.toml --tolerance 5% --to " + std::string(to));
    for (const char* format : {"table", "csv", "json"})
        for (const char* call :
             {"run s.toml", "run ball.toml", "measure p.csv", "measure p.csv r2.csv", "measure m.csv",
              "measure p.csv --scales", "measure --show fit p.csv", "measure --show islands m.csv",
              "measure --show spectrum p.csv", "measure --show spectrum m.csv",
              "measure --show spectrum m.csv --of acf", "truth m.csv --pressures 10MPa", "formats",
              "identify --measured k.csv --law hertz --fit sigma",
              "ultrasound --frequency 7MHz --impedance 46MRayl --stiffness 1GPa/um",
              "ultrasound --frequency 7MHz --impedance 46MRayl --reflection 0.5",
              "ultrasound --reflection r.csv --frequency 7MHz --impedance 46MRayl",
              "ultrasound --reflection f.csv --material steel"})
            calls.push_back(call + std::string(" --format ") + format);
    folder.write("f.csv", "f [MHz],R\n2,0.7\n5,0.92\n10,0.98\n");
    folder.write("k.csv",
                 "pressure [MPa],stiffness [GPa/um],error [GPa/um]\n1,0.015,0.002\n3,0.042,0.006\n10,0.12,0.02\n");
    REQUIRE(in(folder, "generate profile --points 512 --seed 7 --spacing '1 um' --hurst 0.7 --rms '1 um' -o r2.csv")
                .status == 0);
    for (const std::string& call : calls) {  // over the output before, and over its own
        Outcome outcome = in(folder, call + " -o out");
        INFO(call << "\n" << outcome.err << read(folder / "out").substr(0, 300));
        CHECK(outcome.status % 4 == 0);
        CHECK(std::filesystem::file_size(folder / "out") > 0);
        outcome = in(folder, call + " -o out");
        CHECK(outcome.status % 4 == 0);
    }
    for (int time = 0; time < 2; ++time) CHECK(in(folder, "run s.toml --plot picture.svg").status == 0);
}

TEST_CASE("A file that only looks like an output is kept") {
    const Folder folder;
    fill(folder);
    const std::string example = run_fstiff("run --example").out;
    for (const std::string& text :
         {std::string("fstiff is what the thesis is about\n"), std::string("fstiff 0.1.0 has these faults:\n"),
          std::string("# fstiff scene of the flange\n[surface]\n"),
          std::string("{\n  \"name\": \"fstiff_version\"\n}\n"), std::string("{ \"version\": 1 }\n"),
          std::string("pressure_Pa,stiffness_Pa_per_m\n1e6,1.5e12\n"),
          std::string("parameter,value,error,unit\nrms_height,8e-07,1e-07,m\n"), std::string("pressure,K\n1,2\n"),
          example + "# my own\n", replaced(example, "flanged joint", "flange"),
          std::string("{\"index\":0,\"law\":\"hertz\"}\n"),
          std::string("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"mine\"></svg>\n"), std::string("\n"),
          std::string("aISO-1.0\r\nManufacID = other\r\n"), std::string("bISO-1.0Zygo      "),
          std::string("\0\1", 2)}) {
        folder.write("kept", text);
        check_refusal(in(folder, "run s.toml -o kept"), text, 3, {"kept", "not made by fstiff"});
        CHECK(read(folder / "kept") == text);
    }
}

}  // namespace own_files_test
