# SPDX-License-Identifier: BSD-3-Clause
# GUARD on copies of BASELINE in WORK that are better than the truth in one cell: it names the row and what got worse.
cmake_minimum_required(VERSION 3.25)

# check(expected from to): BASELINE with the first match of `from` replaced by `to`; `expected` is a part of the complaint.
function(check expected from to)
    file(READ ${BASELINE} text)
    string(REGEX REPLACE "${from}" "${to}" changed "${text}")
    if(changed STREQUAL text)
        message(FATAL_ERROR "the baseline has no '${from}'")
    endif()
    file(WRITE ${WORK}/baseline.csv "${changed}")
    execute_process(COMMAND ${GUARD} ${WORK}/baseline.csv RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    string(FIND "${output}" "${expected}" position)
    if(result EQUAL 0 OR position EQUAL -1)
        message(FATAL_ERROR "'${from}' made '${to}': '${expected}' expected, result ${result}: ${output}")
    endif()
endfunction()

set(row "integrals/fstiff/four/hard/1e-12")
check("${row}: " "(${row}),[0-9]+" "\\1,1000")
check("evaluations of the integrand, the baseline has 1000" "(${row}),[0-9]+" "\\1,1000")
check("more than four times the 1e-17 of the baseline" "(integrals/fstiff/four/plain/1e-06,[0-9]+),[^,]+" "\\1,1e-17")
check("law/compile: " "(law/compile,.*),[0-9]+\n" "\\1,0\n")
check("${row}: is not in the baseline" "${row}[^\n]*\n" "")
check("old/row: is in the baseline and is not computed any more" "(law/compile[^\n]*\n)" "\\1old/row,1,1,1,1\n")
check("cannot read the row" "(law/compile[^\n]*\n)" "\\1old/row,many\n")
check("is not a baseline" "^row" "line")
