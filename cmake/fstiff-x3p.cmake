# SPDX-License-Identifier: BSD-3-Clause
# fstiff::x3p, where zlib and pugixml are found: what src/io/x3p.cpp needs. Defines FSTIFF_HAS_X3P for those who link it.
include(${CMAKE_CURRENT_LIST_DIR}/fstiff-zlib.cmake)
if(TARGET fstiff::zlib AND NOT TARGET fstiff::x3p)
    find_path(FSTIFF_PUGIXML_INCLUDE pugixml.hpp)
    find_library(FSTIFF_PUGIXML_LIBRARY pugixml)
    mark_as_advanced(FSTIFF_PUGIXML_INCLUDE FSTIFF_PUGIXML_LIBRARY)
    if(FSTIFF_PUGIXML_INCLUDE AND FSTIFF_PUGIXML_LIBRARY)
        add_library(fstiff::x3p INTERFACE IMPORTED)
        target_link_libraries(fstiff::x3p INTERFACE fstiff::zlib ${FSTIFF_PUGIXML_LIBRARY})
        target_include_directories(fstiff::x3p SYSTEM INTERFACE ${FSTIFF_PUGIXML_INCLUDE})
        target_compile_definitions(fstiff::x3p INTERFACE FSTIFF_HAS_X3P)
    endif()
endif()
