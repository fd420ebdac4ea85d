# SPDX-License-Identifier: BSD-3-Clause
# Packs the sources by cpack, and builds the consumer of ../consumer by FetchContent of that archive, checked by its hash.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
cmake_path(GET CMAKE_COMMAND PARENT_PATH bin)
execute_process(COMMAND ${bin}/cpack --config ${BUILD}/CPackSourceConfig.cmake -B ${WORK} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
set(archive ${WORK}/fstiff-${VERSION}-Source.tar.gz)
execute_process(COMMAND ${CMAKE_COMMAND} -E tar tf ${archive} OUTPUT_VARIABLE files COMMAND_ERROR_IS_FATAL ANY)
if(NOT files MATCHES "/include/fstiff/fstiff.hpp\n" OR files MATCHES "Source/(build|\\.git)/")
    message(FATAL_ERROR "the archive of the sources holds\n${files}")
endif()
file(SHA256 ${archive} hash)
execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/../consumer -B ${WORK}/build -G ${GENERATOR}
            -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG= -D FSTIFF_FETCH_URL=${archive}
            -D FSTIFF_FETCH_HASH=${hash}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/build/consumer COMMAND_ERROR_IS_FATAL ANY)
