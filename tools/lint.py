#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of sources and documents that no compiler makes. Each prints its complaints, and then ends with 1.

    tools/lint.py layers             who includes whom, umbrella headers, rows of docs/architecture.md, names of files
    tools/lint.py layers --update    writes the umbrella headers
    tools/lint.py glossary           the names and rows of docs/glossary.md
    tools/lint.py words [FILE ...]   no prose has a word of the last table of CONTRIBUTING.md; comments have 120 columns
    tools/lint.py api                docs/api.md lists the public names; --update writes it
    tools/lint.py sizes              lines of files, of functions and of heads of headers
    tools/lint.py snippets README.md --command build/release/bin/fstiff
                                     what documents show is what comes out; --update writes it

tests/check/lint_refuse.py has a case for every rule."""
import argparse
import concurrent.futures
import difflib
import glob
import math
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

# layers: a folder includes itself and the levels before its own; folders on one level never include each other.
PUBLIC = ("core", "math", "surface", "profile topography", "halfspace", "synthetic", "asperity", "peaks", "contact",
          "tabulated", "wave", "measure", "identify", "answer", "double", "io")
PRIVATE = ("io", "document", "request", "instances", "surface", "scene", "actions", "sweep c web", "cli/document", "cli/input", "cli/picture", "cli/commands", "cli")
OPT_IN = re.compile("answer/(?!(answer|any_contact|causes|checks|chosen_law|concern|joint|law_choice|law_errors|law_names)[.])")  # not in fstiff.hpp
OF_THREADS = "barrier condition_variable future latch semaphore shared_mutex stop_token thread".split()
INCLUDE = re.compile(r"^[ \t]*#[ \t]*include.*", re.M)

# sizes, in lines: of a file, of a function, and of the comment that opens a header, which is longer where a page includes the header.
FILE_LINES, FUNCTION_LINES, HEAD_LINES, PAGE_HEAD_LINES = 400, 60, 15, 40


def read(path):
    return path.read_text(encoding="utf-8")


def sources(root, *folders):
    """Headers and sources below the folders, by their names from root on."""
    found = (path for folder in folders for path in (root / folder).rglob("*") if path.suffix in (".h", ".hpp", ".cpp"))
    return {path.relative_to(root).as_posix(): path for path in sorted(found)}


def above(levels):
    """By folder, in their order, what it may include."""
    allowed, before = {}, []
    for level in levels:
        allowed |= {folder: [*before, folder] for folder in level.split()}
        before += level.split()
    return allowed


def public_include(root, line, allowed):
    """What is wrong with a line of a public header that includes another."""
    if not (name := re.search(r"<([^<>]+)>", line)):
        return f"'{line}': must name the header in angle brackets, from fstiff/ on"
    name = name[1]
    if inner := re.match(r"fstiff/([^/]+)/", name):
        if inner[1] not in allowed:
            return f"<{name}>: {allowed[-1]} may include only {', '.join(allowed)}"
        return None if (root / "include" / name).exists() else f"<{name}> does not exist"
    if not re.fullmatch(r"[a-z_]+|(unsupported/)?Eigen/[A-Za-z]+", name):
        return f"<{name}>: public headers use only the standard library and Eigen"
    return f"<{name}>: needs a threads library, which the target does not link" if name in OF_THREADS else None


def public_headers(root, problems):
    """The headers by folder."""
    allowed = above(PUBLIC)
    headers = {folder: [] for folder in allowed}
    include = root / "include/fstiff"
    for path in sorted(path for path in include.rglob("*") if path.is_file()):
        name = path.relative_to(include).as_posix()
        folder = name.split("/")[0]
        if name in ("fstiff.hpp", "io.hpp", "answer.hpp", "answer_inline.hpp", "implementation.hpp"):
            continue
        if folder not in allowed or not re.fullmatch(r"\w+/[a-z0-9_]+\.hpp", name):
            problems.append(f"{name}: must be <layer>/<name>.hpp, where <layer> is one of {', '.join(allowed)}")
            continue
        headers[folder].append(name)
        text = read(path)
        for line in INCLUDE.findall(re.sub(r"(?s)#ifdef FSTIFF_COMPILED\b.*?#endif", "", text)):  # what fstiff::double has compiled
            if problem := public_include(root, line, allowed[folder]):
                problems.append(f"{name}: {problem}")
        code = re.sub("//.*", "", text)
        if line := re.search(r"^.*[^\n\t -~].*", code, re.M):
            problems.append(f"{name}: '{line[0]}': must be ASCII, which no compiler reads in a code page")
        if (found := re.search("(gnu|clang|msvc)::", code)) and name != "core/config.hpp":
            problems.append(f"{name}: {found[0]}: attributes of one compiler must stand in core/config.hpp")
    return headers


def private_sources(root, problems):
    """The folders of src include only what they may."""
    allowed = above(PRIVATE)
    for name, path in sources(root, "src").items():
        folder = name[len("src/"):].rpartition("/")[0]
        if folder not in allowed:
            problems.append(f"{name}: must stand in one of src/{', src/'.join(allowed)}")
            continue
        for line in INCLUDE.findall(read(path)):
            quoted = re.search(r'(["<])([^">]+)[">]', line)
            places = [base for base in ("src", "src/cli") if (root / base / quoted[2]).is_file()]
            if not places:
                problems += [f"{name}: {quoted[2]} is neither in src nor in src/cli"] if quoted[1] == '"' else []
                continue
            other = f"{places[0]}/{quoted[2]}"[len("src/"):].rpartition("/")[0]
            if other not in allowed[folder]:
                problems.append(f"{name}: {quoted[2]}: src/{folder} may include only {', '.join(allowed[folder])}")


def umbrellas(headers):
    """fstiff.hpp and io.hpp as they should be."""
    head = "// SPDX-License-Identifier: BSD-3-Clause\n#pragma once\n/// \\file\n/// "
    texts = {"fstiff.hpp": "Everything above the readers and writers of files (io.hpp) and the opt-in adapters, "
                           "layer by layer.\n/// Written by tools/lint.py.\n\n// clang-format off\n",
             "io.hpp": "The readers and writers of files: all of io. They are compiled: link fstiff::io. "
                       "Written by tools/lint.py.\n\n"}
    for folder, names in headers.items():
        texts["io.hpp" if folder == "io" else "fstiff.hpp"] += "".join(
            f"#include <fstiff/{name}>\n" for name in names if folder != "double" and not OPT_IN.match(name))
    return {name: head + text for name, text in texts.items()}


def layers(root, update=False):
    problems = []
    headers = public_headers(root, problems)
    private_sources(root, problems)
    for name, new in umbrellas(headers).items():
        path = root / "include/fstiff" / name
        if update:
            path.write_text(new, encoding="utf-8", newline="\n")
        elif read(path) != new:
            problems.append(f"include/fstiff/{name}: does not list the public headers: run tools/lint.py layers --update")
    folders = [*above(PUBLIC), *above(PRIVATE)]
    rows = re.findall(r"^\| ([a-z/]+) \| [^|\n]*[a-zA-Z][^|\n]* \| [^|\n]+ \|$", read(root / "docs/architecture.md"), re.M)
    if [row for row in rows if row in folders] != folders:
        problems.append(f"docs/architecture.md: must have rows '| folder | what it is for | begin with |' of {', '.join(folders)}, in this order")
    return problems + missing_files(root)


def places(name, in_code):
    """Patterns of the places of a file that a document or, with its ending, a comment names so; none where it names no file of the project."""
    if in_code and not name.endswith((".md", ".hpp", ".h", ".cpp", ".csv", ".cmake", ".c", ".py", ".f90", ".toml", ".f32")):
        return []
    if rooted := re.match(rf"(?:\.\.?/)?((?:include/fstiff|src|tests|bench|docs|tools{'' if in_code else '|data'})/.*)", name):
        return [rooted[1]] + [f"python/{rooted[1]}"] * in_code
    if layer := re.fullmatch(rf"(?:fstiff/)?((?:{'|'.join(above(PUBLIC))})/[a-z0-9_]+)(\.[hc]pp)?", name):
        return [layer[1].join(place) for place in (("include/fstiff/", ".hpp"), ("src/", ".hpp"), ("tests/", ".cpp"))] + [
            f"{base}/{name.removeprefix('fstiff/')}" for base in ("include/fstiff", "src", "tests", "tests/support")] * in_code
    return []


def missing_files(root):
    """What documents, headers and the Python package name, and comments with an ending, exists."""
    documents = [path for pattern in ("README.md", "docs/*.md", "include/fstiff/*/*.hpp", "python/fstiff/*.py")
                 for path in root.glob(pattern)]
    code = [path for folder in "include src python bench examples tests tools fortran".split()
            for path in (root / folder).rglob("*")
            if path.suffix in (".hpp", ".h", ".cpp", ".in", ".c", ".py", ".pyi", ".f90")
            and path.name != "lint_refuse.py"]  # which invents names
    problems = []
    absent = [] if (root / "../shared").exists() else ["../shared/"]  # measured files that a clone alone does not have
    for paths, letters, in_code in ((documents, "[\\w.*/-]", False), (code, "[\\w./-]", True)):
        for path in sorted(paths):
            text = re.sub(r"(?ms)^```diff$.*?^```$", "", read(path))  # a patch names what it adds
            for name in {name.rstrip("./-"): None for name in re.findall(f"{letters}*/{letters}*", text, re.A)}:
                if any(folder in name for folder in absent):
                    continue
                if (patterns := places(name, in_code)) and not any(glob.glob(str(root / where)) for where in patterns):
                    problems.append(f"{path.relative_to(root).as_posix()}: '{name}' does not exist")
    return problems


def glossary(root):
    """Every row has a word and a sentence; every name is in the code of a header, Owner::name in the type Owner."""
    code = "\n".join(re.sub(r'"[^"\n]*"', "", re.sub("//.*", "", read(path)))
                     for path in sorted((root / "include/fstiff").rglob("*.hpp")))

    names_of_code = set(re.findall(r"\w+", code))

    def exists(owner, member):
        body = rf"^(?:struct|class|enum class|enum) {owner}(?: [^;\n]*)?{{(?:.*}}.*$|(?s:.*?)^}})"
        return member in (re.findall(r"\w+", "\n".join(re.findall(body, code, re.M))) if owner else names_of_code)

    problems, words, count, table = [], [], 0, False
    for line in read(root / "docs/glossary.md").splitlines():
        table = line.startswith("| word | meaning |") or table and line.startswith("|")
        if not table or line.startswith(("| word | meaning |", "|---")):
            continue
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(cells) != 5:
            problems.append(f"'{line}': must have five cells")
            continue
        word, meaning, _, names, _ = cells
        if not word or not meaning.endswith("."):
            problems.append(f"'{line}': must have a word and a sentence")
        if word in words:
            problems.append(f"'{word}' has two rows")
        words.append(word)
        for name in re.findall("`([^`]*)`", names):
            count += 1
            if not (parts := re.fullmatch(r"(?:(\w+)::)?(\w+)", name)):
                problems.append(f"'{word}': `{name}` is not a name, nor Owner::name")
            elif not exists(*parts.groups()):
                problems.append(f"'{word}': `{name}` does not exist in include/fstiff")
    print(f"{len(words)} words, {count} names of the code")
    return [f"docs/glossary.md: {problem}" for problem in problems + ["holds no table of words"] * (not words)]


PROSE = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "docs/*.md", "paper/*.md", "include/**/*.h*", "src/**/*.[hc]pp",
         "python/**/*.py", "python/**/*.cpp", "tools/*.py", "tests/**/*.[hc]pp", "bench/**/*.[hc]pp", "examples/**/*.[hc]pp",
         "CMakeLists.txt", "*[!d]/CMakeLists.txt", "src/*/CMakeLists.txt", "tests/*/CMakeLists.txt", "cmake/*.cmake", "tests/**/*.cmake")
COMMENT = re.compile(r"""//[^\n]*|/\*.*?\*/|(?:^[ \t]*|(?<=  ))\#[ ][^\n]*|\"{3}.*?\"{3}|"(?:\\.|[^"\\\n])*\"""", re.S | re.M)
NO_PROSE = re.compile(r"^```.*?^```$|`[^`\n]+`|\]\([^)]*\)|^(?: {4,}|\t)[^\n]*$", re.S | re.M)  # of a document


def prose(path, name):
    """Offset and text of each piece of prose: of code the comments and the messages, of tests and programs the comments."""
    text = read(path)
    if path.suffix == ".md":
        yield 0, NO_PROSE.sub(lambda code: re.sub(r"[^\n]", " ", code[0]), text)
        return
    for found in COMMENT.finditer(text):
        if found[0][0] == '"' and found[0][:3] != '"""' and name.startswith(("tests/", "bench/", "examples/", "tools/")):
            continue
        yield found.start(), re.sub(r"`[^`\n]+`|\\p \w+|\b\w+\(\)?|\w*[_/]\w*", lambda code: " " * len(code[0]), found[0])


def words(root, files=()):
    """No slow word of CONTRIBUTING.md in the prose of the project, and no line of a comment above 120 columns."""
    rows = re.findall(r"^\| `([^`]+)` \| (.+?) \|$", read(root / "CONTRIBUTING.md").partition("## Slow words")[2], re.M)
    if not rows:
        return ["CONTRIBUTING.md: holds no table of slow words"]
    slow = re.compile(r"\b(?:" + "|".join(f"(?P<w{i}>{row[0]})" for i, row in enumerate(rows)) + r")\b", re.I)
    problems, count = [], 0
    names = sorted({path.relative_to(root).as_posix() for pattern in PROSE for path in root.glob(pattern)})
    for name in names:
        if files and not name.startswith(tuple(files)):
            continue
        count, text = count + 1, read(root / name)
        lines = text.split("\n")
        for start, piece in prose(root / name, name):
            first = text.count("\n", 0, start)
            if text.startswith(("//", "/*"), start):
                problems += [f"{name}:{first + i + 1}: a comment above 120 columns" for i in range(piece.count("\n") + 1)
                             if len(lines[first + i]) > 120]
            for found in slow.finditer(piece):
                line = first + piece.count("\n", 0, found.start()) + 1
                problems.append(f"{name}:{line}: '{found[0]}': write {rows[int(found.lastgroup[1:])][1]}")
    print(f"{len(rows)} slow words, {count} files")
    return problems


NO_CODE = re.compile(r'''//[^\n]* | /\*.*?\*/ | R"([^(\s]*)\(.*?\)\1" | "(?:\\.|[^"\\\n])*"
                         | (?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+' | ^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*
                         | \b(?:alignas|requires|noexcept|explicit)\s*\([^()]*\)''', re.S | re.M | re.X)
SCOPE = re.compile(r"\b(namespace|struct|class|union|enum|extern)\b[^()=]*$")  # before its brace


def functions(code):
    """Name and lines of each function, from its declaration to its last brace. Outside of functions a brace
    opens a namespace or a type, a function, or an initialiser, after which the declaration goes on."""
    start = depth = 0
    for mark in re.finditer("[{};]", code):
        head = code[start:mark.end()]
        if depth or mark[0] == "{" and not SCOPE.search(head[:-1]):
            depth += {"{": 1, "}": -1, ";": 0}[mark[0]]
            if depth or re.compile(r"\s*[,{().]").match(code, mark.end()):
                continue
            if name := re.match(r"[^{]*?(operator\s*\W+?|[\w:~]+)\s*\(", head):
                yield name[1], head.strip().count("\n") + 1
        start = mark.end()


def included_by_pages(root):
    """The headers that README and docs include."""
    pages = [root / "README.md", *root.glob("docs/*.md")]
    return {f"include/{name}" for page in pages if page.exists() for name in re.findall(r"^#include <(fstiff/[^>]+)>", read(page), re.M)}


def sizes(root):
    problems, lines, long, heads, long_heads, pages = [], {}, {}, {}, {}, included_by_pages(root)
    for name, path in sources(root, "include", "src").items():
        text = read(path)
        lines[name] = text.count("\n")
        head = re.search(r"^/// \\file\n(?:///.*\n)*", text, re.M)
        if head and name.startswith("include/"):
            (long_heads if name in pages else heads)[f"{name} head"] = head[0].count("\n")
        code = NO_CODE.sub(lambda found: "\n" * found[0].count("\n"), text)
        if code.count("{") != code.count("}"):
            problems.append(f"{name}: its braces do not match, so that no function can be counted")
        for function, size in functions(code):
            key = f"{name} {function}"
            long[key] = max(size, long.get(key, 0))
    print(f"{len(lines)} files, {len(long)} functions")
    return problems + [f"{name}: has {size} lines, more than {limit}"
                       for sizes, limit in ((lines, FILE_LINES), (long, FUNCTION_LINES), (heads, HEAD_LINES), (long_heads, PAGE_HEAD_LINES))
                       for name, size in sizes.items() if size > limit]


API_NAMES = 251  # of namespaces fstiff and fstiff::io, at most


def declarations(text):
    """Namespace, name, comment and code of each declaration of a header."""
    code = NO_CODE.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)
    spaces, start, depth = [], 0, 0
    for mark in re.finditer("[{};]", code):
        head = code[start:mark.end()]
        if not depth and mark[0] != ";" and (edge := re.search(r"\bnamespace ([\w: ]+?)\s*{$|^\s*}$", head)):
            spaces = [*spaces, edge[1]] if edge[1] else spaces[:-1]
        else:
            depth += {"{": 1, "}": -1, ";": 0}[mark[0]]
            if depth or mark[0] == "}" and re.compile(r"\s*[,;{().&|]").match(code, mark.end()):
                continue
            comment = re.findall(r"^ *///(?!<) ?(.*)", text[start:start + len(head) - len(head.lstrip())], re.M)
            head = re.split("[{;]", re.sub(r"\[\[.*?\]\]", "", head), maxsplit=1)[0]
            while head != (shorter := re.sub("<[^<>]*>", "", head)):
                head = shorter
            name = (re.search(r"\b(?:struct|class|concept|using)\s+(\w+)\s*(?:=|:|$|final)", head)
                    or re.search(r"([\w:]+)\s*(?:[(=\[]|\s*$)", head))
            forward = re.fullmatch(r"\s*(?:template\s*)?(?:struct|class)\s+\w+\s*", head) and mark[0] == ";" and "{" not in code[start:mark.end()]
            if name and not forward and not re.search(r"\boperator\b|^\s*template <>", code[start:mark.end()].split("(")[0]) and not re.search("::|^static_assert$", name[1]):
                yield "::".join(spaces), name[1], " ".join(comment), code[start:mark.end()]
        start = mark.end()


def unmet(root, codes):
    """The public names that no page or example has, nor the declaration of a name that one has."""
    pages = (path for pattern in ("README.md", "docs/*.md", "examples/**/*.cpp") for path in root.glob(pattern) if path.name != "api.md")
    words = set(re.findall(r"\w+", "\n".join(map(read, pages))))
    rest, reached = set(codes) - words, set(codes) & words
    while reached:
        reached = set(re.findall(r"\w+", "\n".join(codes[name] for name in reached))) & rest
        rest -= reached
    return sorted(rest)


def api(root, update=False):
    """docs/api.md lists what is in namespaces fstiff and fstiff::io by header, with the first sentence about each."""
    found, codes, problems = {}, {}, []
    version = dict(re.findall(r"FSTIFF_VERSION_(\w+) (\d+)", read(root / "include/fstiff/core/version.hpp")))
    home = f"fstiff::v{version['MAJOR']}_{version['MINOR']}"
    for path in sorted((root / "include/fstiff").glob("[!d]*/*.hpp")):
        header = path.relative_to(root / "include/fstiff").as_posix()
        for space, name, comment, code in declarations(read(path)):
            if space and not space.startswith(home):
                problems.append(f"{header}: {name} is in {space}, not in {home}")
            elif space in (home, f"{home}::io"):
                key = (header, "io::" * space.endswith("::io") + name)
                key = next((known for known in found if known[1] == key[1]), key)
                found[key] = found.get(key) or re.sub(r"\\p ", "", re.split(r"(?<=[.])(?: |$)", comment, maxsplit=1)[0]).replace("|", "\\|")
                codes[name] = codes.get(name, "") + code
    for (header, name), meaning in found.items():
        first = re.match(r"\w*", meaning)[0]
        if first and re.search(rf"[\w>&*] {first} *[,)>=]", codes[name.removeprefix("io::")]):
            problems.append(f"{header}: {name}: its comment begins with the parameter {first}: say what it is first")
    problems += [f"{header}: {name} is public and has no comment" for (header, name), meaning in found.items() if not meaning]
    problems += [f"{name} is public, and neither a page nor an example leads to it: put it into detail, or describe it" for name in unmet(root, codes)]
    if len(found) > API_NAMES:
        problems.append(f"namespaces fstiff and fstiff::io have {len(found)} names, more than {API_NAMES}: put what is a step into math or detail")
    headers = {}
    for (header, name), meaning in found.items():
        headers.setdefault(header.removesuffix(".hpp"), []).append(f"`{name}` {meaning}")
    table = "\n| header | names |\n|---|---|\n" + "".join(f"| {header} | {'<br>'.join(names)} |\n" for header, names in headers.items()) + "\n"
    document = root / "docs/api.md"
    old = read(document)
    new = re.sub(r"(?s)(<!-- api -->\n).*?(?=<!-- /api -->)", lambda mark: mark[1] + table, old)
    if update:
        document.write_text(new, encoding="utf-8", newline="\n")
    elif new != old:
        problems.append("docs/api.md: does not list the public names: run tools/lint.py api --update")
    print(f"{len(found)} public names in {len(headers)} headers, at most {API_NAMES}")
    return problems


def lines(text):
    """The lines of a text, without blanks at their ends and blank lines at its own."""
    return [line.rstrip() for line in re.sub(r"\A\s*\n", "", text.rstrip()).split("\n")]


def same(expected, actual):
    """Whether actual is what a document shows; a line "..." matches any lines, " ..." for the rest of a line."""
    pattern = "".join(r"(?:.*\n)*?" if line == "..." else
                      re.escape(line[:-4]) + ".*\n" if line.endswith(" ...") else re.escape(line + "\n")
                      for line in lines(expected))
    return re.fullmatch(pattern, "".join(line + "\n" for line in lines(actual)))


def renewed(expected, actual):
    """What a document shows of actual, with lines and rests of lines left out where expected leaves them out: the lines between two "..."
    are found by their first and their last one."""
    def closest(line, begin):
        def likeness(i):
            return difflib.SequenceMatcher(None, *(re.sub(r"\d", "0", text) for text in (line, new[i]))).ratio()
        return max(range(begin, len(new)), key=likeness, default=begin)
    new, shown, begin = lines(actual), [], 0
    parts = [part.split("\n")[1:-1] for part in re.split(r"(?<=\n)\.\.\.(?=\n)", "\n".join(["", *lines(expected), ""]))]
    for number, part in enumerate(parts):
        first = closest(part[0], begin) if number and part else begin
        last = first if not part else len(new) if number + 1 == len(parts) else closest(part[-1], first) + 1
        for line in part:
            if line.endswith(" ..."):
                i = closest(line[:-4], first)
                new[i] = new[i][:len(line) - 4].rstrip() + " ..."
        shown += ["..."] * (number > 0) + new[first:last]
        begin = last
    return "\n".join(shown)


def blocks(text):
    """Line, kind and body of each block between lines of ```."""
    kind, body = None, []
    for number, line in enumerate(text.split("\n")):
        if not line.startswith("```"):
            body = [] if kind is None else [*body, line]
        elif kind is None:
            kind, body = line[3:], []
        else:
            yield number - len(body), kind, "\n".join(body)
            kind = None
    if kind is not None:
        raise ValueError("a block is not closed")


NUMBER = re.compile(r"(?<![\w.])(?:[0-9]{1,3}(?:,[0-9]{3})+|[0-9]+)(?:\.[0-9]+)?(?:e[-+]?[0-9]+)?(?!\w)")
CONSTANT = re.compile(r"[0-9]|10*|0\.0*1|1e[-+]?[0-9]+")  # digits and powers of ten
FORMULA = re.compile(rf"(?:{NUMBER.pattern}|sqrt|log|exp|pi|[-+*/() ])+")


def value(number):
    return float(number.replace(",", ""))


def rounds(number, values):
    """Whether number is one of the values to its last digit."""
    digits, _, exponent = number.replace(",", "").partition("e")
    unit = 10.0 ** (int(exponent or 0) - len(digits.partition(".")[2]))
    return any(abs(value(number) - other) <= 0.5000001 * unit for other in values)


def refuted(number, formula, known):
    """Why the number is not the value of the formula of known numbers; None where it is."""
    if missing := [part for part in NUMBER.findall(formula) if not CONSTANT.fullmatch(part) and not rounds(part, known)]:
        return f"no block has {', '.join(missing)}"
    try:
        result = eval(formula, {"__builtins__": {}}, vars(math)) if FORMULA.fullmatch(formula) else None
    except (ArithmeticError, SyntaxError, TypeError):
        result = None
    if not isinstance(result, (int, float)):
        return "is no expression of numbers, + - * / ** ( ), sqrt, log, exp and pi"
    return None if rounds(number, [result]) else f"is {result:.6g}"


def quotations(text):
    """Complaints about the numbers in the prose after a block of output, to the next heading or <!-- other numbers -->. Each is in a block
    of its section, rounded or not, or in a comment, which has its source or how it follows from the blocks:

        <!-- 0.36 = 1e3/(5.61e10*0.05*1e-6); 0.05: the area in relay.toml -->

    In a section without output the comments alone are compared, with all output of the document."""
    def blank(code):
        return re.sub(r"[^\n]", " ", code[0])
    plain = NO_PROSE.sub(blank, text).split("\n")
    headings = [0, *(i for i, line in enumerate(plain) if line.startswith("#")), len(plain)]
    every, before = [], None
    for line, kind, body in blocks(text):
        every.append((line, body, kind.startswith("console check") or kind == "text" and before in ("cpp", "c", "python")))
        before = kind
    for begin, end in zip(headings, headings[1:]):
        shown = [block for block in every if begin <= block[0] < end]
        first = next((line for line, _, output in shown if output), None)
        quotable = [body for _, body, output in (shown if first else every) if first or output]
        prose = "\n".join(plain[first or begin:end]).partition("<!-- other numbers -->")[0]
        notes = [note for comment in re.findall(r"<!--(.*?)-->", prose, re.S) for note in re.split(r";\s+", comment.strip())]
        sources, formulas = (dict(found.groups() for note in notes if (found := re.fullmatch(f"({NUMBER.pattern}){mark}(.+)", note, re.S)))
                             for mark in (": ", " = "))
        known = {value(number) for body in quotable for number in NUMBER.findall(body)} | {*map(value, sources)}
        for number, formula in formulas.items():
            if why := refuted(number, formula, known.union(value(other) for other in formulas if other != number)):
                yield f"{number} = {formula}: {why}"
        prose = re.sub(r"(?m)^ *[0-9]+[.] ", blank, re.sub(r"<!--.*?-->", blank, prose, flags=re.S))
        quoted = {number[0]: (first or begin) + prose.count("\n", 0, number.start()) + 1 for number in NUMBER.finditer(prose)}
        for number, line in quoted.items():
            if first and number not in formulas and not rounds(number, known):
                yield (f"line {line}: no block of the section has {number}: mend it, or add <!-- {number} = EXPRESSION --> or "
                       f"<!-- {number}: SOURCE -->")
        if unused := {*formulas, *sources} - {*quoted, *NUMBER.findall(" ".join(formulas.values()))}:
            yield f"{', '.join(sorted(unused))}: in a comment, and not in the text"


class Snippets:
    """The blocks of one document, or of the comments of a header, run from root:

        ```cpp              a program, compiled and run (without a main(): compiled); the ```text block after it is
                            what it prints
        ```console check    lines "$ command" run by sh, each followed by what it prints; "check fails": they must fail

    The numbers of the prose after them are those of quotations().
    A command that reads ../shared is passed over where that folder is absent. PREFIX names a folder to install into."""

    def __init__(self, root, document, options):
        self.root, self.document, self.problems, self.update = root, document, [], options.update
        self.work = (pathlib.Path(options.work) / re.sub(r"\W", "_", document.name)).resolve()
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)
        self.environment = os.environ | {"PREFIX": str(self.work / "prefix")}
        if options.command:
            folder = pathlib.Path(options.command).resolve().parent
            self.environment["PATH"] = f"{folder}{os.pathsep}{os.environ['PATH']}"
        self.compiler = [options.compiler, "-std=c++20", *shlex.split(options.flags), f"-I{root / 'include'}"]
        self.compiler += [flag for folder in options.eigen.split(";") for flag in ("-isystem", folder)]
        self.compiler += [f"-D{one}" for one in options.definitions.split(",")] if options.double else []
        self.libraries = [options.double] * bool(options.double)
        # Declares what the library has compiled; after the program, which must include by itself what it uses. Where no map is
        # prepared, it would take longer than it spares.
        self.after = "#include <fstiff/double/contacts.hpp>\n" * bool(options.double)

    def run(self, command, shown, fails=False):
        """What the command prints, errors among it; None where it ends as it should not."""
        done = subprocess.run(command, cwd=self.root, env=self.environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", errors="replace")
        if (done.returncode != 0) == fails:
            return done.stdout
        self.problems.append(f"'{shown}' ends with {done.returncode}:\n{done.stdout}")
        return None

    def compare(self, shown, expected, actual):
        """What the document is to show."""
        if actual is None or same(expected, actual):
            return expected
        if self.update and same(new := renewed(expected, actual), actual):
            return new
        self.problems.append(f"'{shown}' prints\n{actual}\nand the document shows\n{expected}")
        return expected

    def compile(self, name, body):
        """The program; None of what has no main() or is refused, and without a compiler."""
        if not self.compiler[0]:
            return None
        source, program = self.work / f"{name}.cpp", self.work / name
        source.write_text(f"{body}\n{self.after * ('measure/prepare.hpp' in body)}", encoding="utf-8")
        if "main(" not in body:
            self.run([*self.compiler, "-fsyntax-only", source], name)
        elif self.run([*self.compiler, source, *self.libraries, "-o", program], name) is not None:
            return program
        return None

    def console(self, body, fails):
        """The block that the document is to show."""
        if not body.startswith("$ "):
            self.problems.append(f"a console block must begin with '$ ': {body}")
            return body
        sessions = []
        for session in body[2:].split("\n$ "):
            command, _, expected = session.partition("\n")
            if "../shared/" in command and not (self.root / "../shared").exists():
                print(f"passed over, there is no ../shared: {command}")
            elif (new := self.compare(command, expected, self.run(["sh", "-c", command], command, fails))) != expected:
                session = command + "\n" * bool(new) + new
            sessions.append(f"$ {session}")
        return "\n".join(sessions)

    def check(self):
        checked = count = 0
        printed = None  # by a program, and shown by no ```text block yet
        edits, whole = [], read(self.document)
        mark = "/// " * (self.document.suffix == ".hpp")
        text = re.sub("(?m)^/// ?", "", whole) if mark else whole
        found = list(enumerate(blocks(text), 1))
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as compilers:  # what takes longest is done at once
            programs = {count: compilers.submit(self.compile, f"snippet_{count}", body)
                        for count, (_, kind, body) in found if kind == "cpp"}
        for count, (line, kind, body) in found:
            new = body
            if kind == "cpp":
                program = programs[count].result()
                printed = program and self.run([program], program.name)
            elif kind == "text" and printed is not None:
                new, printed = self.compare(f"program {count}", body, printed), None
            elif kind in ("console check", "console check fails"):
                new, printed = self.console(body, kind.endswith("fails")), None
            else:
                continue
            checked += 1
            edits += [(line, body, new)] * (new != body)
        shown = whole.split("\n")
        for line, body, new in reversed(edits):
            shown[line:line + body.count("\n") + bool(body)] = [(mark + one).rstrip() if mark else one for one in new.split("\n")]
        if edits:
            self.document.write_text("\n".join(shown), encoding="utf-8", newline="\n")
        if not mark:
            self.problems += quotations("\n".join(shown))
        print(f"{self.document}: {checked} of {count} blocks checked, {len(edits)} written")
        return [f"{self.document}: {problem}" for problem in self.problems]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[1],
                        help="folder of the project")
    checks = parser.add_subparsers(dest="check", required=True)
    checks.add_parser("layers").add_argument("--update", action="store_true")
    checks.add_parser("glossary")
    checks.add_parser("words").add_argument("files", nargs="*", help="names, or how they begin")
    checks.add_parser("sizes")
    checks.add_parser("api").add_argument("--update", action="store_true")
    snippet = checks.add_parser("snippets")
    snippet.add_argument("documents", nargs="+", type=pathlib.Path)
    snippet.add_argument("--update", action="store_true", help="write what is printed into the documents")
    snippet.add_argument("--compiler", default="g++", help="'' passes over the programs")
    snippet.add_argument("--flags", default="", help="of the compiler")
    snippet.add_argument("--eigen", default="/usr/include/eigen3", help="include folders, divided by semicolons")
    snippet.add_argument("--command", help="bin/fstiff")
    snippet.add_argument("--double", help="the library fstiff::double, which the programs link")
    snippet.add_argument("--definitions", help="of its target",
                         default="FSTIFF_COMPILED,EIGEN_MAX_ALIGN_BYTES=64,EIGEN_MAX_STATIC_ALIGN_BYTES=16")
    snippet.add_argument("--work", default="build/snippets", help="folder for what is compiled")
    options = parser.parse_args()
    root = options.root.resolve()
    try:
        if options.check in ("layers", "api"):
            problems = {"layers": layers, "api": api}[options.check](root, options.update)
        elif options.check == "words":
            problems = words(root, options.files)
        elif options.check == "snippets":
            problems = [problem for document in options.documents for problem in Snippets(root, document, options).check()]
        else:
            problems = {"glossary": glossary, "sizes": sizes}[options.check](root)
    except (OSError, ValueError) as error:
        problems = [str(error)]
    if problems:
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
