# SPDX-License-Identifier: BSD-3-Clause
# Writes the manual pages (INTO/man/man1) and the completion of bash (INTO/completion/...) that COMMAND prints.
cmake_minimum_required(VERSION 3.25)

function(keep file)
    execute_process(COMMAND ${COMMAND} help ${ARGN} OUTPUT_FILE ${INTO}/${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${INTO})
foreach(folder man/man1 completion/bash-completion/completions)
    file(MAKE_DIRECTORY ${INTO}/${folder})
endforeach()
keep(man/man1/fstiff.1 --man)
keep(completion/bash-completion/completions/fstiff --completion bash)

# The commands are those that fstiff(1) lists at its end.
file(STRINGS ${INTO}/man/man1/fstiff.1 pages REGEX "^.fBfstiff.-[a-z]")
foreach(page IN LISTS pages)
    string(REGEX REPLACE "^.fBfstiff.-(.*).fR.*$" "\\1" name "${page}")
    string(REPLACE "\\-" "-" name "${name}")
    # fstiff-measure-fit is measure --show fit
    string(REGEX REPLACE "^measure-" "measure;--show;" command "${name}")
    keep(man/man1/fstiff-${name}.1 ${command} --man)
endforeach()
