# SPDX-License-Identifier: BSD-3-Clause
# Target reference: the headers of include/ as HTML, by Doxygen, any warning an error. Where Doxygen is missing the target
# reports this and fails. tools/make_site.py makes the pages of docs/, and takes the reference in.
find_program(FSTIFF_DOXYGEN doxygen)
set(fstiff_reference ${PROJECT_BINARY_DIR}/reference)
if(FSTIFF_DOXYGEN)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${fstiff_reference}/Doxyfile @ONLY)
    add_custom_target(
        reference
        COMMAND ${CMAKE_COMMAND} -E rm -rf ${fstiff_reference}/html
        COMMAND ${FSTIFF_DOXYGEN} ${fstiff_reference}/Doxyfile
        COMMAND ${CMAKE_COMMAND} -E echo "${fstiff_reference}/html/index.html"
        COMMENT "The reference, by Doxygen"
        VERBATIM)
else()
    add_custom_target(
        reference
        COMMAND ${CMAKE_COMMAND} -E echo "The reference needs Doxygen (Debian: apt install doxygen). Install it and configure again."
        COMMAND ${CMAKE_COMMAND} -E false
        VERBATIM)
endif()
