# SPDX-License-Identifier: BSD-3-Clause
# tools/check_snippets.cmake on small documents in WORK: it accepts what is true and refuses what is not.
cmake_minimum_required(VERSION 3.25)

function(check right text)
    file(WRITE ${WORK}/document.md "${text}")
    execute_process(
        COMMAND ${CMAKE_COMMAND} -D DOCUMENT=${WORK}/document.md -D COMPILER=${COMPILER} -D FLAGS=${FLAGS}
                "-DEIGEN=${EIGEN}" -D COMMAND=${COMMAND} -D WORK=${WORK}
                -P ${CMAKE_CURRENT_LIST_DIR}/../../tools/check_snippets.cmake
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(right AND NOT result EQUAL 0)
        message(FATAL_ERROR "refused: ${text}\n${output}")
    elseif(NOT right AND result EQUAL 0)
        message(FATAL_ERROR "accepted: ${text}\n${output}")
    endif()
endfunction()

set(program "#include <cstdio>\nint main() { int a[] = {1, 2}; std::puts(a[1] == 2 ? \"[2];\" : \"\"); }\n")
check(TRUE "Words.\n\n```cpp\n${program}```\nIt prints\n```text\n[2];\n```\n")
check(FALSE "```cpp\n${program}```\n```text\n[3];\n```\n")
check(FALSE "```cpp\nint main() { return 1; }\n```\n")
check(FALSE "```cpp\nint main( { return 0; }\n```\n")
check(TRUE "```cpp\n#include <fstiff/core/version.hpp>\nconst int v = FSTIFF_VERSION_MAJOR;\n```\n")
check(FALSE "```cpp\nconst int v = FSTIFF_VERSION_MAJOR;\n```\n")
check(TRUE "```console check\n$ echo a; echo b\na\nb\n$ printf '1\\n2\\n3\\n4\\n'\n1\n...\n4\n```\n")
check(FALSE "```console check\n$ echo a\nb\n```\n")
check(FALSE "```console check\n$ echo a\n```\n")
check(FALSE "```console check\n$ printf '1\\n2\\n3\\n'\n1\n...\n4\n```\n")
check(FALSE "```console check\n$ printf '1\\n2\\n3\\n'\n2\n...\n3\n```\n")
check(TRUE "```console check\n$ printf 'a 1\\na 2 [;]\\n\\nb 3\\n'\n...\na 2 ...\n\nb ...\n```\n")
check(FALSE "```console check\n$ printf 'a 1\\na 2\\n'\na 1 ...\na 3 ...\n```\n")
check(FALSE "```console check\n$ printf 'a\\nb\\n'\na\n```\n")
check(FALSE "```console check\n$ printf 'a\\n'\na\n...\nb\n```\n")
check(FALSE "```console check\n$ false\n```\n")
check(TRUE "```console check fails\n$ false\n```\n")
check(FALSE "```console check fails\n$ true\n```\n")
check(FALSE "```cpp\nint main() {}\n")
