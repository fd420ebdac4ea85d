# SPDX-License-Identifier: BSD-3-Clause
# Target site: the pages of docs/ and the reference of include/ as HTML, by Doxygen, any warning an error. Where Doxygen is
# missing the target reports this and fails.
find_program(FSTIFF_DOXYGEN doxygen)
set(fstiff_site ${PROJECT_BINARY_DIR}/site)
if(FSTIFF_DOXYGEN)
    set(fstiff_pages ${PROJECT_SOURCE_DIR}/docs/README.md)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${fstiff_pages})
    file(READ ${fstiff_pages} fstiff_links)
    string(REGEX MATCHALL "\\([a-z_-]+\\.md\\)" fstiff_links "${fstiff_links}")
    foreach(link IN LISTS fstiff_links)
        string(REGEX REPLACE "[()]" "" link ${link})
        string(APPEND fstiff_pages " \\\n    ${PROJECT_SOURCE_DIR}/docs/${link}")
    endforeach()
    configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${fstiff_site}/Doxyfile @ONLY)
    add_custom_target(
        site
        COMMAND ${CMAKE_COMMAND} -E rm -rf ${fstiff_site}/html
        COMMAND ${FSTIFF_DOXYGEN} ${fstiff_site}/Doxyfile
        COMMAND ${CMAKE_COMMAND} -E echo "${fstiff_site}/html/index.html"
        COMMENT "The site, by Doxygen"
        VERBATIM)
else()
    add_custom_target(
        site
        COMMAND ${CMAKE_COMMAND} -E echo "The site needs Doxygen (Debian: apt install doxygen). Install it and configure again."
        COMMAND ${CMAKE_COMMAND} -E false
        VERBATIM)
endif()
