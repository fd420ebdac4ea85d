# SPDX-License-Identifier: BSD-3-Clause
# ruff finds nothing in the Python files (pyproject.toml); it may lie in the venv of the test of the Python package.
cmake_minimum_required(VERSION 3.25)
find_program(ruff ruff HINTS ${VENV}/bin)
if(NOT ruff)
    message("SKIPPED: there is no ruff (pip install ruff)")
    return()
endif()
execute_process(COMMAND ${ruff} check --no-cache --quiet ${SOURCE} COMMAND_ERROR_IS_FATAL ANY)
