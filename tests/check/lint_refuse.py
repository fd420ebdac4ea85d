#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""tools/lint.py and tests/check/links.py on small trees: they accept a good one, and name what is wrong with each bad one.

    tests/check/lint_refuse.py --compiler g++"""
import argparse
import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
sys.path[:0] = [str(TOOLS), str(TOOLS.parent / "tests/check")]
import lint  # noqa: E402
import links  # noqa: E402

lint.API_NAMES = 4

ROWS = "".join(f"| {folder} | what it is for | x |\n" for folder in (*lint.above(lint.PUBLIC), *lint.above(lint.PRIVATE)))
TREE = {
    "tools/lint.py": "# which fstiff.hpp names\n",
    "tests/check/lint_refuse.py": "# docs/none.md\n",
    "include/fstiff/core/config.hpp": "[[gnu::cold]] void refuse();\n",
    "include/fstiff/core/error.hpp": "#include <string>\n#include <fstiff/core/config.hpp>\n",
    "include/fstiff/answer/answer_inline.hpp": "",
    "include/fstiff/math/root.hpp": "#include <Eigen/Core>\n#include <fstiff/core/error.hpp>\n",
    "include/fstiff/io/text.hpp": "#include <fstiff/math/root.hpp>\n",
    "src/io/text.hpp": "#include <fstiff/io/text.hpp>\n#include <zlib.h>\n",
    "src/sweep/a.cpp": "#include \"io/text.hpp\"\n",
    "src/cli/input/a.hpp": "#include \"document/a.hpp\"\n",
    "src/cli/document/a.hpp": "\n",
    "docs/architecture.md": "before\n| folder | what it is for | begin with |\n|---|---|---|\n" + ROWS + "after; with a semicolon\n",
}
WRITTEN = {  # by --update, in its order
    "include/fstiff/fstiff.hpp": "#include <fstiff/core/config.hpp>\n#include <fstiff/core/error.hpp>\n"
                                 "#include <fstiff/math/root.hpp>\n",
    "include/fstiff/io.hpp": "#include <fstiff/io/text.hpp>\n",
}
GLOSSARY = "# Glossary\n\n| word | meaning | symbol, unit | in the code | source |\n|---|---|---|---|---|\n"
LOAD = "| load | What presses. | p, \\|Pa\\| | `State::load`, `State` | book; page 3 |\n"
STATE = """// depth
struct State : Base {
    double load;  ///< area
    const char* text = "volume";
};
struct Other {
    double moment[2];
};
struct Short { int one; };
int free_standing(int);
"""
PROGRAM = '```cpp\n#include <cstdio>\nint main() { int a[] = {1, 2}; std::puts(a[1] == 2 ? "[2];" : ""); }\n```\n'

# What is expected of the complaint, "" where there is to be none; then names and texts of files put into the tree.
LAYERS = [
    ("", "notes.txt", "nothing that matters\n"),
    ("core may include only core", "include/fstiff/core/error.hpp", "#include <fstiff/math/root.hpp>\n"),
    ("profile may include only", "include/fstiff/profile/a.hpp", "#include <fstiff/topography/b.hpp>\n#include <x>\n"),
    ("<fstiff/core/none.hpp> does not exist", "include/fstiff/math/root.hpp", "#include <fstiff/core/none.hpp>\n"),
    ("must name the header in angle brackets", "include/fstiff/math/root.hpp", '#include "../core/error.hpp"\n'),
    ("only the standard library and Eigen", "include/fstiff/math/root.hpp", "#  include <gsl/gsl_math.h>\n"),
    ("only the standard library and Eigen", "include/fstiff/math/root.hpp", "#include <math.h>\n"),
    ("only the standard library and Eigen", "include/fstiff/math/root.hpp", "#include <scene/scene.hpp>\n"),
    ("needs a threads library", "include/fstiff/math/root.hpp", "#include <future>\n"),
    ("must be ASCII", "include/fstiff/math/root.hpp", '// µm\n#include <Eigen/Core>\nauto unit = "µm";\n'),
    ("attributes of one compiler", "include/fstiff/math/root.hpp", "[[gnu::cold]] void refuse();\n"),
    ("must be <layer>/<name>.hpp", "include/fstiff/misc/thing.hpp", "\n"),
    ("must be <layer>/<name>.hpp", "include/fstiff/math/thing.h", "\n"),
    ("fstiff.hpp: does not list", "include/fstiff/core/more.hpp", "\n"),
    ("io.hpp: does not list", "include/fstiff/io/more.hpp", "\n"),
    ("must have rows '| folder |", "docs/architecture.md", ROWS.replace("| math | what it is for | x |\n", "")),
    ("must have rows '| folder |", "docs/architecture.md", ROWS.replace("| math | what it is for | x |", "| math |  | x |")),
    ("must have rows '| folder |", "docs/architecture.md", "| sweep | first | x |\n" + ROWS),
    ("src/io may include only io", "src/io/text.hpp", '#include "sweep/a.hpp"\n', "src/sweep/a.hpp", ""),
    ("src/io may include only io", "src/io/text.hpp", "#  include <sweep/a.hpp>\n", "src/sweep/a.hpp", ""),
    ("src/c may include only io, document, request, instances, surface, scene, actions, c", "src/c/a.cpp",
     '#include "sweep/a.hpp"\n', "src/sweep/a.hpp", ""),
    ("src/cli/input may include", "src/cli/input/a.hpp", '#include "picture/a.hpp"\n', "src/cli/picture/a.hpp", ""),
    ("none.hpp is neither in src nor in src/cli", "src/io/text.hpp", '#include "io/none.hpp"\n'),
    ("must stand in one of src/io", "src/other/a.cpp", "\n"),
    ("src/cli/document may include only", "src/cli/document/a.hpp", "#include \"input/a.hpp\"\n"),
    ("", "docs/more.md", "[](../include/fstiff/math/root.hpp), math/root `f`, io/text.hpp; docs/*.md, and/or, 1/2\n"),
    ("'math/none' does not exist", "docs/more.md", "| math/none | nothing |\n"),
    ("'docs/none.md' does not exist", "include/fstiff/math/root.hpp", "/// docs/none.md\n#include <Eigen/Core>\n"),
    ("'docs/none' does not exist", "python/fstiff/more.py", '"""docs/none says why."""\n'),
    ("'tests/math/root_test.cpp' does not exist", "docs/more.md", "Test: tests/math/root_test.cpp.\n"),
    ("python/fstiff/a.py: 'docs/none.md' does not exist", "python/fstiff/a.py", '"""See docs/none.md; [1]."""\n'),
    ("'tests/math/root_test.cpp' does not exist", "src/scene/a.cpp", "// (tests/math/root_test.cpp)\n"),
    ("'math/none.hpp' does not exist", "src/scene/a.cpp", "// see math/none.hpp\n"),
    ("", "src/scene/a.cpp", "// docs/architecture.md, math/root.hpp, include/fstiff/io/text.hpp, scene/none.hpp\n"),
    ("'include/fstiff/core/none.hpp' does not exist", "README.md", "in include/fstiff/core/none.hpp\n"),
    ("", "README.md", "docs/../../shared/some.txt\n"),  # a clone alone has none of these
    ("'docs/../../shared/some.txt' does not exist", "README.md", "docs/../../shared/some.txt\n", "../shared/a", "\n"),
]
WORDS = [
    ("", f"{GLOSSARY}{LOAD}| moment | What turns. | | `Other::moment`, `Short::one`, `free_standing` | |\n\n"
         "| not | but |\n| a | `b` |\n"),
    ("`depth` does not exist", f"{GLOSSARY}| depth | In a comment. | | `depth` | |\n"),
    ("`volume` does not exist", f"{GLOSSARY}| volume | In a text. | | `volume` | |\n"),
    ("`loa` does not exist", f"{GLOSSARY}| part | Of a word. | | `loa` | |\n"),
    ("`Other::load` does not exist", f"{GLOSSARY}| load | Of another. | | `Other::load` | |\n"),
    ("`Short::load` does not exist", f"{GLOSSARY}| load | Of another. | | `Short::load` | |\n"),
    ("`None::load` does not exist", f"{GLOSSARY}| load | Of none. | | `None::load` | |\n"),
    ("`at(x)` is not a name", f"{GLOSSARY}| load | A call. | | `at(x)` | |\n"),
    ("must have five cells", f"{GLOSSARY}| load | Four cells. | | `State` |\n"),
    ("must have a word and a sentence", f"{GLOSSARY}| load | no sentence | | `State` | |\n"),
    ("must have a word and a sentence", f"{GLOSSARY}| | No word. | | `State` | |\n"),
    ("'load' has two rows", GLOSSARY + LOAD + LOAD),
    ("holds no table", "# Glossary\n"),
]
SIXTY = """namespace a {
int f();
}
struct A {
    template <class T>
    requires (N<T> > 2)
    T operator()(T x) const noexcept(true) {
""" + 56 * "//\n" + "{}}\n};\n"
INCLUDED = ("docs/a.md", "```cpp\n#include <fstiff/a.hpp>\n```\n", "include/fstiff/a.hpp")
SIZES = [
    ("", "src/io/a.cpp", 400 * "\n"),
    ("src/io/a.cpp: has 401 lines, more than 400", "src/io/a.cpp", 401 * "\n"),
    ("include/a.h: has 401 lines, more than 400", "include/a.h", 401 * "\n"),
    ("src/io/a.cpp Long: has 62 lines, more than 60", "src/io/a.cpp",
     '// long {\nclass Long {\n    Long(int i)\n        : a_{i}, b_{"}"} {\n' + 59 * "        f('}');\n" + "    }\n};\n"),
    ("", "src/io/a.cpp", SIXTY),
    ("", "src/io/a.cpp", "alignas(64) const int table[] = {\n" + 100 * "    1,\n" + "};\n"),
    ("", "src/io/a.cpp", 'extern "C" {\n' + 100 * "int f(int);\n" + "}\n"),
    ("", "src/io/a.cpp", "enum class A : int {\n" + 100 * "\n" + "};\nint f(A a = {}) { return {}; }\n"),
    ("", "src/io/a.cpp", "namespace {\n" + 100 * "\n" + "int f(A a) { return {}; }\n}\n"),
    ("src/io/a.cpp operator(): has 61 lines, more than 60", "src/io/a.cpp", SIXTY.replace("//", "//\n//", 1)),
    ("src/io/a.cpp f: has 61 lines, more than 60", "src/io/a.cpp",
     "#define B {\nnamespace a {}\nvoid f(char c = '{') {\n  const auto g = R\"x(}\")x\";\n" + 57 * "/* {\n" + "*/ g({1});\n}\n"),
    ("its braces do not match", "src/io/a.cpp", "namespace a {\n"),
    ("include/a.h head: has 16 lines, more than 15", "include/a.h", "#pragma once\n/// \\file\n" + 15 * "///\n"),
    ("", "include/a.h", "/// \\file\n" + 14 * "/// a\n" + "\n" + 20 * "/// b\n"),
    ("", *INCLUDED, "/// \\file\n" + 39 * "/// a\n"),
    ("include/fstiff/a.hpp head: has 41 lines, more than 40", *INCLUDED, "/// \\file\n" + 40 * "/// a\n"),
]
SLOW = ("CONTRIBUTING.md", "## Slow words\n\n| pattern | write |\n|---|---|\n| `beside` | \"with\" |\n| `stands?` | \"is\" |\n")
PROSE = [(expected, *SLOW, name, text) for expected, name, text in (
    ("docs/a.md:2: 'Beside': write \"with\"", "docs/a.md", "Words\nBeside\n"),
    ("", "docs/a.md", "Outside, `beside` [b](beside.md) besides.\n```\nbeside\n```\n"),
    ("include/a.h:2: 'stand': write \"is\"", "include/a.h", "int beside;\n// they stand\n"),
    ("src/io/a.cpp:3: 'beside'", "src/io/a.cpp", "/* a\n\nbeside */\n"),
    ("src/io/a.cpp:1: 'beside'", "src/io/a.cpp", 'refuse("a is beside b");\n'),
    ("", "src/io/a.cpp", 'beside(beside_b, "io/beside", stands());\n'),
    ("", "tests/io/a.cpp", 'TEST_CASE("What stands") {}\n'),
    ("", "tests/io/a.cpp", 'CHECK(a == "beside b");\n'),
    ("python/a.py:1: 'beside'", "python/a.py", '"""It is beside."""\n'),
    ("tools/a.py:2: 'beside'", "tools/a.py", "b = 1\n# beside it\n"),
    ("include/a.h:1: a comment above 120 columns", "include/a.h", "//" + 60 * " a" + "\n"),
    ("", "include/a.h", "//" + 59 * " a" + "\n" + 'f("' + 130 * "a" + '");\n'))]
PROSE.append(("holds no table of slow words", "CONTRIBUTING.md", "## Slow words\n"))
SNIPPETS = [
    ("", f"Words.\n\n{PROGRAM}It prints\n```text\n[2];\n```\n"),
    ("", f"{PROGRAM}```toml\n[3]\n```\n```text\n[2];\n```\n"),
    ("the document shows\n[3];", f"{PROGRAM}```text\n[3];\n```\n"),
    ("", f"{PROGRAM}```text\n[2];\n```\nof\n```text\nanother\n```\n"),
    ("snippet_1' ends with 1", "```cpp\nint main() { return 1; }\n```\n"),
    ("snippet_1' ends with 1", "```cpp\nint main( { return 0; }\n```\n"),
    ("", "```cpp\n#include <fstiff/core/version.hpp>\nconst int v = FSTIFF_VERSION_MAJOR;\n```\n"),
    ("snippet_1' ends with 1", "```cpp\nconst int v = FSTIFF_VERSION_MAJOR;\n```\n"),
    ("", "```console check\n$ echo a; echo b\na\nb\n$ printf '1\\n2\\n3\\n4\\n'\n1\n...\n4\n```\n"),
    ("'echo a' prints", "```console check\n$ echo a\nb\n```\n"),
    ("'echo a' prints", "```console check\n$ echo a\n```\n"),
    ("prints", "```console check\n$ printf '1\\n2\\n3\\n'\n1\n...\n4\n```\n"),
    ("prints", "```console check\n$ printf '1\\n2\\n3\\n'\n2\n...\n3\n```\n"),
    ("", "```console check\n$ printf 'a 1\\na 2 [;]\\n\\nb 3\\n'\n...\na 2 ...\n\nb ...\n```\n"),
    ("prints", "```console check\n$ printf 'a 1\\na 2\\n'\na 1 ...\na 3 ...\n```\n"),
    ("prints", "```console check\n$ printf 'a\\nb\\n'\na\n```\n"),
    ("prints", "```console check\n$ printf 'a\\n'\na\n...\nb\n```\n"),
    ("'false' ends with 1", "```console check\n$ false\n```\n"),
    ("", "```console check fails\n$ false\n```\n"),
    ("", "```console check fails\n$ echo a; echo b >&2; false\na\nb\n```\n"),
    ("'true' ends with 0", "```console check fails\n$ true\n```\n"),
    ("must begin with '$ '", "```console check\necho a\n```\n"),
    ("", '```console check\n$ test -n "$PREFIX" && ! test -e "$PREFIX" && mkdir "$PREFIX"\n```\n'),
    ("", "```console check\n$ from_the_path\nfound\n```\n"),
    ("", "```cpp\n#include <only_here>\n```\n"),
    ("a block is not closed", "```cpp\nint main() {}\n"),
]
QUOTED = "# Of 3 things\n\nThere are 7:\n```toml\narea = 12\n```\n```console check\n$ echo 0.914 2.5e+05\n0.914 2.5e+05\n```\n"
SNIPPETS += [(expected, QUOTED + prose) for expected, prose in (
    ("", "K is 0.91, h 250,000 on 12.\n"),
    ("line 12: no block of the section has 0.92: mend it", "K\nis 0.92.\n"),
    ("has 0.9141:", "K is 0.9141.\n"),
    ("has 9:", "| K | 9 % |\n"),
    ("has 7:", "![K of 7 faces](a.svg)\n"),
    ("", "1. `0.92` of C20, mm² [a](b9.md)\n\n       0.92\n"),
    ("", "K falls by 9 %. <!-- 9 = 100*(1 - 0.914) -->\n"),
    ("8 = 100*(1 - 0.914): is 8.6", "K falls by 8 %. <!-- 8 = 100*(1 - 0.914) -->\n"),
    ("9 = 100*(1 - 0.911): no block has 0.911", "K falls by 9 %. <!-- 9 = 100*(1 - 0.911) -->\n"),
    ("9 = 1/0: is no expression", "K falls by 9 %. <!-- 9 = 1/0 -->\n"),
    ("9 = nine: is no expression", "K falls by 9 %. <!-- 9 = nine -->\n"),
    ("", "On 0.05 mm²: 4.57e-2. <!-- 0.05: as in\na.toml; 4.57e-2 = 0.914*0.05 -->\n"),
    ("9: in a comment, and not in the text", "K falls. <!-- 9: as in a.toml -->\n"),
    ("", "<!-- other numbers -->\nK is 0.92.\n"),
    ("", "# B\nK is 0.92.\n"),
    ("", "# B\nK is 0.91, 9 % less. <!-- 0.91 = 0.914; 9 = 100*(1 - 0.91) -->\n"),
    ("0.92 = 0.914: is 0.914", "# B\nK is 0.92. <!-- 0.92 = 0.914 -->\n"),
    ("0.91: in a comment", "# B\nK is 0.92. <!-- 0.91 = 0.914 -->\n"),
    ("has 12", "# B\nK is 12. <!-- 12 = 12 -->\n"))]
SNIPPETS.append(("line 9: no block of the section has 3", f"{PROGRAM}```text\n[2];\n```\n\n3\n"))
COUNT = "$ printf 'one 1\\nx\\ntwo 2\\nthree 33\\n'\n"
UPDATES = [(f"```{kind}\n{code}{before}```\nafter\n", f"```{kind}\n{code}{after}```\nafter\n") for kind, code, before, after in (
    ("console check", "$ echo '  a'\n", "b\n", "  a\n"),
    ("console check", "$ echo a\n", "", "a\n"),
    ("console check", "$ true\n", "b\n\n", ""),
    ("console check fails", "$ echo a; false\n", "b\n", "a\n"),
    ("console check", f"$ echo a\na\n{COUNT}", "one 0\n...\nthree 20\n", "one 1\n...\nthree 33\n"),
    ("console check", COUNT, "...\ntwo 1\n...\n", "...\ntwo 2\n...\n"),
    ("console check", COUNT, "...\ntwo 1\ny\nthree 2\n", "...\ntwo 2\nthree 33\n"),
    ("console check", COUNT, "one 2\n...\nthree ...\n", "one 1\n...\nthree ...\n"),
    ("console check", COUNT, "one 1\n...\nthree 33\n", "one 1\n...\nthree 33\n"))]
UPDATES += [(f"{PROGRAM}```text\n{before}```\n", f"{PROGRAM}```text\n[2];\n```\n") for before in ("", "[3];\n", "a\nb\n")]
LINKS = [
    ("", "docs/a.md", "# A, `b` (c)\n## A [b](a.md)\n## A b\n```\n# No\n[](none.md)\n```\n[](#a-b-c) [](a.md#a-b) [x](#a-b-1) `[](none.md)`\n"
         "[x](https://none) [x](../src/io/text.hpp#L1) ![](../src)\n"),
    ("docs/a.md:2: none.md: there is no such file", "docs/a.md", "# A\n[](none.md)\n"),
    ("docs/a.md:1: #b: there is no such heading", "docs/a.md", "[](#b)\n# A\n"),
    ("README.md:1: docs/a.md#no: there is no such heading", "docs/a.md", "# A\n```\n# No\n```\n", "README.md", "[x][1] [y](docs/a.md#no)\n"),
    ("../../some: there is no such file", "docs/a.md", "[x](../../some)\n", "../some", "\n"),
    ("../src/io/text.hpp#x: only headings", "docs/a.md", "[x](../src/io/text.hpp#x)\n"),
]


def complaints(run):
    """What a check complains of, as one text."""
    with contextlib.redirect_stdout(io.StringIO()):
        try:
            return "\n".join(run())
        except ValueError as error:
            return str(error)


def expect(expected, complaint, case):
    if (expected not in complaint) if expected else complaint:
        sys.exit(f"{case[:300]}:\n'{expected or 'no complaint'}' expected, and this came:\n{complaint}")


def write(root, files):
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text, encoding="utf-8", newline="\n")


def on_trees(check, cases):
    for expected, *files in cases:
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder, "project")
            write(root, TREE)
            complaints(lambda: lint.layers(root, update=True))
            for name, text in WRITTEN.items():
                written = (root / name).read_text(encoding="utf-8")
                expect(text, written if text.startswith("before") else written.split("\n\n")[1], name)
            write(root, dict(zip(files[::2], files[1::2])))
            expect(expected, complaints(lambda: check(root)), f"{check.__name__} of {files}")


def on_documents(compiler, flags, eigen):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder, "project")
        write(root, {"bin/from_the_path": "#!/bin/sh\necho found\n", "eigen/only_here": ""})
        version = pathlib.Path("include/fstiff/core/version.hpp")
        write(root, {version: (TOOLS.parent / version).read_text(encoding="utf-8")})
        (root / "bin/from_the_path").chmod(0o755)
        options = argparse.Namespace(compiler=compiler, flags=flags, double=None, eigen=f"{eigen};{root / 'eigen'}",
                                     work=root / "work", command=root / "bin/fstiff", update=False)

        def on(text, expected):
            write(root, {"document.md": text})
            expect(expected, complaints(lambda: lint.Snippets(root, root / "document.md", options).check()), text)
        for expected, text in SNIPPETS:
            on(text, expected)
        on("```console check\n$ cat ../shared/none\n```\n", "")
        write(root, {"../shared/some": "words\n"})
        on("```console check\n$ cat ../shared/some\nwords\n```\n", "")
        on("```console check\n$ cat ../shared/none\n```\n", "'cat ../shared/none' ends with 1")
        options.update = True
        for before, after in UPDATES:
            on(before, "")
            if (written := (root / "document.md").read_text(encoding="utf-8")) != after:
                sys.exit(f"{before}\nis written as\n{written}")
        on("```console check\n$ false\na\n```\n", "'false' ends with 1")
        options.compiler = ""
        on("```cpp\nint main( { return 0; }\n```\n```text\na\n```\n", "")


API = """// SPDX
namespace fstiff { inline namespace v1_2 {
namespace parts {
struct Step {};
}  // namespace parts
/// A law. Long.
template <class T>
class Law { int f() const { return 1; } };
/// Its load.
template <class T>
[[nodiscard]] std::pair<T, T> load(const Law<T>& law, int n = {}) { return {}; }
template <class T>
int Law<T>::g() { return 2; }
/// Whether it is one.
template <class T>
concept IsLaw = requires(T t) { t.f(); } && true;
/// Least.
template <class T> inline constexpr T least{1};
}}  // namespace fstiff
"""
VERSION = ("include/fstiff/core/version.hpp", "#define FSTIFF_VERSION_MAJOR 1\n#define FSTIFF_VERSION_MINOR 2\n")
LISTED = ("<!-- api -->\n\n| header | names |\n|---|---|\n| law/law | `Law` A law.<br>`load` Its load.<br>`IsLaw` Whether it is one.<br>"
          "`least` Least. |\n\n<!-- /api -->\n")
LAW = ("docs/api.md", LISTED, "include/fstiff/law/law.hpp")
PAGE = ("README.md", "`Law`, `load`, `IsLaw<T>`, `least`, `one`\n")
APIS = [("", *VERSION, *PAGE, *LAW, API),
        ("Law is in fstiff, not in fstiff::v1_2", *VERSION, *PAGE, *LAW, API.replace("inline namespace v1_2 {", "").replace("}}", "}")),
        ("does not list", *VERSION, *PAGE, "docs/api.md", LISTED.replace("`IsLaw` Whether it is one.<br>", ""), LAW[2], API),
        ("load is public and has no comment", *VERSION, *PAGE, *LAW, API.replace("/// Its load.\n", "")),
        ("load: its comment begins with the parameter law", *VERSION, *PAGE, *LAW, API.replace("/// Its load", "/// \\p law, pressed")),
        ("load is public, and neither a page", *VERSION, "README.md", "Law IsLaw least\n", *LAW, API),
        ("have 5 names, more than 4", *VERSION, *PAGE, *LAW, API.replace("}}  // namespace", "/// One.\nint one();\n}}  // namespace"))]


def as_command(expected_code, expected, *arguments):
    done = subprocess.run([sys.executable, TOOLS / "lint.py", *arguments], capture_output=True, encoding="utf-8")
    if done.returncode != expected_code or expected not in done.stdout + done.stderr:
        sys.exit(f"{arguments}: {expected_code} and '{expected}' expected: {done}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--flags", default="")
    parser.add_argument("--eigen", default="/usr/include/eigen3")
    options = parser.parse_args()
    on_trees(lint.layers, LAYERS)
    on_trees(lint.glossary, [(expected, "docs/glossary.md", text, "include/fstiff/state.hpp", STATE)
                             for expected, text in WORDS])
    on_trees(lint.sizes, SIZES)
    on_trees(lint.words, PROSE)
    on_trees(lint.api, APIS)
    on_trees(links.problems, LINKS)
    on_documents(options.compiler, options.flags, options.eigen)
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        write(root, {"docs/glossary.md": GLOSSARY + LOAD, "include/fstiff/state.hpp": STATE})
        as_command(0, "1 words, 2 names", "--root", root, "glossary")
        write(root, {"docs/glossary.md": GLOSSARY})
        as_command(1, "holds no table", "--root", root, "glossary")
        as_command(1, "fstiff.hpp", "--root", root, "layers")
        snippets = ("--root", root, "snippets", root / "README.md", "--work", root / "work")
        write(root, {"README.md": "```text\nwords\n```\n```console check\n$ true\n```\n"})
        as_command(0, "1 of 2 blocks", *snippets)
        write(root, {"README.md": "```console check\n$ false\n```\n"})
        as_command(1, "'false' ends with 1", *snippets)


if __name__ == "__main__":
    main()
