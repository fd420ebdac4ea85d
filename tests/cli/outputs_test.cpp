// SPDX-License-Identifier: BSD-3-Clause
// Outputs are safe: no input is overwritten, no foreign file is replaced, and no file is left half written.
#include "cli/command.hpp"
#include "support/skip.hpp"

namespace outputs_test {

using namespace test;

namespace {

/// A profile of 512 points as text, and where it is.
std::string profile() {
    const Outcome made = run_fstiff("generate profile --points 512 --spacing '1 um' --hurst 0.5 --rms '1 um'");
    REQUIRE(made.status == 0);
    return made.out;
}

/// Runs \p arguments in \p folder and checks that the command ends with \p status and one sentence that holds \p parts,
/// and that no file is new or changed.
void check_harmless(const Folder& folder, const std::string& arguments, int status,
                    const std::vector<std::string>& parts) {
    const std::string list = "cd '" + (folder / "") + "' && find . | sort && find . -type f | sort | xargs cat | cksum";
    const std::string before = shell(list).out;
    const Outcome outcome = shell("cd '" + (folder / "") + "' && fstiff " + arguments);
    check_refusal(outcome, arguments, status, parts);
    CHECK(shell(list).out == before);
}

std::string scene_from(const std::string& file) {
    std::string text = read(FSTIFF_SCENES "/sand_blasted_fine.toml");
    const auto begin = text.find("[surface]"), end = text.find("[material.upper]");
    return replaced(text, text.substr(begin, end - begin), "[surface]\nfrom = \"" + file + "\"\n\n");
}

}  // namespace

TEST_CASE("No command writes over a file that it reads") {
    const Folder folder;
    folder.write("d.csv", profile());
    folder.write("scene.toml", scene_from("d.csv"));
    folder.write("trace.plot.csv", profile());
    folder.write("from.toml", scene_from("trace.plot.csv"));
    folder.write("page.svg", read(FSTIFF_SCENES "/sand_blasted_fine.toml"));
    folder.write("k.csv", "pressure [MPa],stiffness [GPa/um]\n1,0.004\n10,0.03\n100,0.2\n");
    std::filesystem::create_symlink("d.csv", folder / "link.csv");
    std::filesystem::create_hard_link(folder / "d.csv", folder / "hard.csv");
    const std::string input = "is an input of this command";
    check_harmless(folder, "measure --show fit d.csv -o d.csv", 3, {"d.csv", input});
    check_harmless(folder, "measure --show fit d.csv -o ./../$(basename $(pwd))/d.csv", 3, {"d.csv", input});
    check_harmless(folder, "measure --show fit d.csv -o link.csv", 3, {"d.csv", input});
    check_harmless(folder, "measure --show fit link.csv -o hard.csv", 3, {"hard.csv", input});
    check_harmless(folder, "measure --show fit - -o d.csv < d.csv", 3, {"d.csv", input});
    check_harmless(folder, "measure d.csv -o d.csv", 3, {"d.csv", input});
    check_harmless(folder, "run scene.toml -o scene.toml", 3, {"scene.toml", input});
    check_harmless(folder, "run scene.toml -o d.csv", 3, {"d.csv", input});
    check_harmless(folder, "run --surface d.csv -o d.csv", 3, {"d.csv", input});
    check_harmless(folder, "run page.svg --plot page.svg", 3, {"page.svg", input});
    check_harmless(folder, "identify --measured k.csv --fit sigma --law hertz -o k.csv", 3, {"k.csv", input});
}

TEST_CASE("A file next to a picture is replaced only if fstiff made it") {
    const Folder folder;
    folder.write("trace.csv", profile());
    // the case of the review: the numbers of the trace were replaced by those of its picture
    const std::string run = "cd '" + (folder / "") + "' && fstiff run --surface trace.csv --plot trace.svg >/dev/null";
    REQUIRE(shell(run).status == 0);
    CHECK(read(folder / "trace.csv") == profile());
    CHECK(read(folder / "trace.plot.csv").starts_with("# fstiff "));
    CHECK(folder.files() == 3);
    CHECK(shell(run).status == 0);  // its own files it replaces

    folder.write("trace.plot.csv", profile());  // of fstiff generate: no picture's numbers
    check_harmless(folder, "run --plot trace.svg", 3, {"trace.plot.csv", "not made by fstiff"});
    check_harmless(folder, "run --plot new.svg -o new.plot.csv", 3, {"new.plot.csv", "written twice"});
}

TEST_CASE("A file that may not grow further is reported with its reason, and the old one stays") {
    const Folder folder;
    folder.write("out.csv", "old\n");
    // 4 or 8 KiB; a build that measures its coverage must not write its counts under that limit
    const std::string go = "cd '" + (folder / "") + "' && export LLVM_PROFILE_FILE=/dev/null && ulimit -f 8 && fstiff ";
    const Outcome text =
        shell(go + "generate profile --points 4096 --spacing '1 um' --hurst 0.5 --rms '1 um' -o out.csv --force");
    INFO(text.err);
    CHECK(text.status == 3);
    CHECK(lines(text.err).size() == 1);
    CHECK(contains(text.err, "out.csv: cannot be written: File too large"));
    CHECK(read(folder / "out.csv") == "old\n");
    const Outcome picture = shell(go + "run --plot new.svg");
    CHECK(picture.status == 3);
    CHECK(contains(picture.err, "File too large"));
    CHECK(folder.files() == 1);  // neither a picture nor what was begun of it
    const Outcome output = shell(go + "run --format json > all.json");
    CHECK(output.status == 3);
    CHECK(contains(output.err, "standard output cannot be written: File too large"));
}

TEST_CASE("A full disk is reported with its reason, and no part of the file is left") {
    const Folder folder;
    const std::string disk = folder / "disk";
    std::filesystem::create_directory(disk);
    // a file system of its own for one command, as nobody but root or a name space may mount it
    const std::string mounted =
        "unshare -rm sh -c \"mount -t tmpfs -o size=16k none '" + disk + "' && cd '" + disk + "' && ";
    if (shell(mounted + "true\"").status != 0) SKIP_CASE("no file system can be mounted here");
    const Outcome outcome =
        shell(mounted + "'" FSTIFF_COMMAND "' run --format json -o all.json; echo status \\$?; ls -A\"");
    INFO(outcome.out << outcome.err);
    CHECK(contains(outcome.err, "all.json: cannot be written: No space left on device"));
    CHECK(outcome.out == "status 3\n");
    if (!std::filesystem::exists("/dev/full")) return;
    const Outcome full = run_fstiff("run > /dev/full");
    CHECK(full.status == 3);
    CHECK(contains(full.err, "standard output cannot be written: No space left on device"));
}

TEST_CASE("A write-protected output stays, and is refused with its reason") {
    const Folder folder;
    std::filesystem::copy_file(FSTIFF_COMMAND, folder / "command");  // where everybody reaches it
    folder.write("old.txt", "old\n");
    const std::string as = "cd '" + (folder / "") +
                           "' && chmod 555 . command && chmod 444 old.txt && $(test $(id -u) = 0 && " +
                           "echo setpriv --reuid 65534 --regid 65534 --clear-groups) ./command ";
    const auto refused = [&](const std::string& arguments, const std::string& sentence) {
        const Outcome outcome = shell(as + arguments);
        INFO(arguments << "\n" << outcome.err);
        CHECK(outcome.status == 3);
        CHECK(contains(outcome.err, sentence));
    };
    if (shell(as + "--version").status == 0) {
        refused("run -o old.txt", "old.txt: cannot be written: Permission denied");
        refused("run -o new.txt", "new.txt: cannot be written: Permission denied");
    } else {
        leave_out("nobody but root can run the command here");
    }
    CHECK(read(folder / "old.txt") == "old\n");
    CHECK(folder.files() == 2);
    shell("chmod 755 '" + (folder / "") + "'");
}

TEST_CASE("An empty argument is refused, as of a script whose variable is not set") {
    const Folder folder;
    for (const char* arguments :
         {"run ''", "run -o ''", "run --plot ''", "run --plot=", "run --surface ''", "measure --show fit ''",
          "measure --units '' d.csv", "identify --measured '' --fit sigma", "generate '' --spacing '1 um'", "''"})
        check_harmless(folder, arguments, 2, {"is empty"});
}

TEST_CASE("A seed is a whole number of 64 bits that is not negative") {
    const std::string make = "generate profile --points 16 --spacing '1 um' --hurst 0.5 --rms '1 um' --seed ";
    const std::string allowed = "from 0 to 18446744073709551615";
    for (const char* seed : {"-1", "18446744073709551616", "1e3", "1.5", "\"seven\""})
        check_refused(make + seed, 2, {"--seed = " + std::string(seed), allowed});
    for (const std::string command : {"measure --show fit x", "measure x", "measure --show islands x"})
        check_refused(command + " --seed -1", 2, {"--seed = -1", allowed});
    const Outcome greatest = run_fstiff(make + "18446744073709551615");
    CHECK(greatest.status == 0);
    CHECK(contains(greatest.out, "seed 18446744073709551615"));
    CHECK(greatest.out != run_fstiff(make + "0").out);
}

TEST_CASE("The output - is standard output") {
    const Folder folder;
    folder.write("d.csv", profile());
    folder.write("grid.toml", read(FSTIFF_SCENES "/../examples/sweeps/grid.toml"));
    const std::string in = "cd '" + (folder / "") + "' && fstiff ";
    for (const char* command : {"run", "measure --show fit d.csv", "measure d.csv", "measure --show spectrum d.csv",
                                "formats", "export --to abaqus", "sweep grid.toml --rows 7:9",
                                "generate profile --points 64 --spacing '1 um' --hurst 0.5 --rms '1 um'"}) {
        const Outcome plain = shell(in + command), dash = shell(in + command + " -o -");
        INFO(command << "\n" << dash.err);
        CHECK(plain.status % 4 == 0);
        CHECK(dash.status == plain.status);
        CHECK(!dash.out.empty());
        CHECK(dash.out == plain.out);
    }
    CHECK(folder.files() == 2);
    REQUIRE(shell(in + "run -o ./-").status == 0);  // a file of that name
    CHECK(read(folder / "-") == shell(in + "run").out);
}

TEST_CASE("An output is written through symbolic links, dangling ones too, and refused where they lead in a circle") {
    const Folder folder;
    std::filesystem::create_directory(folder / "data");
    std::filesystem::create_symlink("data/target.txt", folder / "one");
    std::filesystem::create_symlink("one", folder / "two");
    std::filesystem::create_symlink("nowhere/target.txt", folder / "astray");
    std::filesystem::create_symlink("round", folder / "circle");
    std::filesystem::create_symlink("circle", folder / "round");
    const std::string in = "cd '" + (folder / "") + "' && fstiff ";
    const std::string document = shell("fstiff formats").out;
    for (const char* kind : {"dangling", "leads to a file"}) {
        INFO(kind);
        CHECK(shell(in + "formats -o two").status == 0);
        CHECK(std::filesystem::is_symlink(folder / "two"));
        CHECK(std::filesystem::is_symlink(folder / "one"));
        CHECK(read(folder / "data/target.txt") == document);
    }
    check_harmless(folder, "formats -o astray", 3, {"astray: cannot be written", "the folder must exist"});
    check_harmless(folder, "formats -o circle", 3, {"circle: cannot be written: Too many levels of symbolic links"});
    std::filesystem::remove(folder / "data/target.txt");
    check_harmless(folder, "run --plot data/new.svg -o data/new.svg", 3, {"written twice"});
    std::filesystem::create_symlink("data/new.svg", folder / "picture.svg");
    check_harmless(folder, "run --plot picture.svg -o data/new.svg", 3, {"written twice"});
}

TEST_CASE("Control characters of names are printed nowhere", "[more]") {
    const Folder folder;
    const std::string name =
        "a\x1b[31m\x7f\xc2\x9b"
        "2J\n\xff"
        "b";  // escape, delete, the C1 of CSI, a line end, no UTF-8
    const std::string profile_file = folder.write(name + ".csv", profile());
    const std::string scene = folder.write(name + ".toml", scene_from("x.csv"));
    folder.write("x.csv", profile());
    const auto has_controls = [](const std::string& text) {
        return text.find('\x1b') != std::string::npos || text.find('\x7f') != std::string::npos ||
               text.find("\xc2\x9b") != std::string::npos || text.find('\xff') != std::string::npos;
    };
    const std::string picture = folder / "k.svg";
    for (const std::string& command :
         {"measure --show fit '" + profile_file + "'", "measure --format table '" + profile_file + "'",
          "measure --show spectrum '" + profile_file + "'", "run --surface '" + profile_file + "'",
          "run '" + scene + "' --plot '" + picture + "'", "run '" + scene + "' --full",
          "export --to abaqus '" + scene + "'", "measure '" + profile_file + "'", "run '" + scene + "' --format json",
          "truth '" + profile_file + "'", "run '" + folder / (name + "none") + "'"}) {
        const Outcome outcome = test::run_fstiff(command);
        INFO(command << "\n" << outcome.err);
        CHECK((outcome.status % 4 == 0 || outcome.status == 3));
        CHECK_FALSE(has_controls(outcome.out));
        CHECK_FALSE(has_controls(outcome.err));
        for (const std::string& line : lines(outcome.out + outcome.err)) {
            INFO(line);
            CHECK(
                !line.starts_with("\xEF\xBF\xBD"
                                  "b"));  // no line begins within the name
        }
    }
    CHECK_FALSE(has_controls(read(picture)));
    CHECK_FALSE(has_controls(read(folder / "k.plot.csv")));
    const std::string json = test::run_fstiff("measure '" + profile_file + "'").out;  // the name stays what it is
    CHECK(contains(json, "\\u001b[31m\\u007f\\u009b2J\\n"));
}

}  // namespace outputs_test
