# SPDX-License-Identifier: BSD-3-Clause
# Installs component cli of BUILD under PREFIX and checks that every command has its manual page, as the installed command
# prints it, and that bash finds its completion.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} --component cli COMMAND_ERROR_IS_FATAL ANY)

function(same file)
    execute_process(COMMAND ${PREFIX}/bin/fstiff help ${ARGN} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
    file(READ ${PREFIX}/share/${file} installed)
    if(NOT installed STREQUAL printed OR printed STREQUAL "")
        message(FATAL_ERROR "share/${file} is not what fstiff help ${ARGN} prints")
    endif()
endfunction()

execute_process(COMMAND ${PREFIX}/bin/fstiff help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "^.*\nCompute:\n(.*)\nUnits.*$" "\n\\1" listed "${help}")
string(REGEX MATCHALL "\n  [a-z]+" commands "${listed}")
list(TRANSFORM commands STRIP)
list(APPEND commands "measure --show fit" "measure --show islands" "measure --show peaks" "measure --show spectrum"
     "sweep --merge")
list(LENGTH commands count)
if(count LESS 16)
    message(FATAL_ERROR "commands found: ${commands}")
endif()
same(man/man1/fstiff.1 --man)
foreach(command IN LISTS commands)
    string(REGEX REPLACE " (--show )?(--)?" "-" page "${command}")
    separate_arguments(words UNIX_COMMAND "${command}")
    same(man/man1/fstiff-${page}.1 ${words} --man)
endforeach()
file(GLOB pages ${PREFIX}/share/man/man1/*)
list(LENGTH pages found)
math(EXPR wanted "${count} + 1")
if(NOT found EQUAL wanted)
    message(FATAL_ERROR "${found} manual pages, not ${wanted}")
endif()
same(bash-completion/completions/fstiff --completion bash)
