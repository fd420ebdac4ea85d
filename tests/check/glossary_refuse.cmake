# SPDX-License-Identifier: BSD-3-Clause
# tools/check_glossary.cmake on a small tree in WORK: it accepts a good glossary, and names what is wrong with each bad one.
cmake_minimum_required(VERSION 3.25)
set(script ${CMAKE_CURRENT_LIST_DIR}/../../tools/check_glossary.cmake)

set(head "# Glossary\n\n| word | meaning | symbol, unit | in the code | source |\n|---|---|---|---|---|\n")
set(good "| load | What presses. | p, \\|Pa\\| | `State::load`, `State` | book; page 3 |\n")

# check(expected text): `text` as the glossary; `expected` is "" or a part of the complaint.
function(check expected text)
    file(REMOVE_RECURSE ${WORK})
    file(WRITE ${WORK}/include/fstiff/state.hpp
         "// depth\nstruct State : Base {\n    double load;  ///< area\n    const char* text = \"volume\";\n};\n"
         "struct Other {\n    double moment[2];\n};\nstruct Short { int one; };\nint free_standing(int);\n")
    file(WRITE ${WORK}/docs/glossary.md "${text}")
    execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${WORK} -P ${script}
                    RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE complaint)
    string(FIND "${complaint}" "${expected}" position)
    if(expected STREQUAL "" AND NOT result EQUAL 0)
        message(FATAL_ERROR "refused a good glossary: ${complaint}")
    elseif(NOT expected STREQUAL "" AND (result EQUAL 0 OR position EQUAL -1))
        message(FATAL_ERROR "'${text}': '${expected}' expected, result ${result}: ${complaint}")
    endif()
endfunction()

check("" "${head}${good}| moment | What turns. | | `Other::moment`, `Short::one`, `free_standing` | |\n\n| not | but |\n| a | `b` |\n")
check("`depth` does not exist" "${head}| depth | In a comment. | | `depth` | |\n")
check("`volume` does not exist" "${head}| volume | In a text. | | `volume` | |\n")
check("`loa` does not exist" "${head}| part | Of a word. | | `loa` | |\n")
check("`Other::load` does not exist" "${head}| load | Of another. | | `Other::load` | |\n")
check("`Short::load` does not exist" "${head}| load | Of another. | | `Short::load` | |\n")
check("`None::load` does not exist" "${head}| load | Of none. | | `None::load` | |\n")
check("`at(x)` is no name" "${head}| load | A call. | | `at(x)` | |\n")
check("must have five cells" "${head}| load | Four cells. | | `State` |\n")
check("must have a word and a sentence" "${head}| load | no sentence | | `State` | |\n")
check("'load' has two rows" "${head}${good}${good}")
check("holds no table" "# Glossary\n")
