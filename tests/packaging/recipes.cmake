# SPDX-License-Identifier: BSD-3-Clause
# recipes.py, with the Python of VENV where there is one: the linters of recipes may be installed there.
cmake_minimum_required(VERSION 3.25)
if(EXISTS ${VENV}/bin/python)
    set(PYTHON ${VENV}/bin/python)
endif()
execute_process(COMMAND ${PYTHON} ${SOURCE}/tests/packaging/recipes.py ${SOURCE} COMMAND_ERROR_IS_FATAL ANY)
