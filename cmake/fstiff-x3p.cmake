# SPDX-License-Identifier: BSD-3-Clause
# fstiff::x3p, where libzip and pugixml are found: what src/io/x3p.cpp needs. Defines FSTIFF_HAS_X3P for those who link it.
if(NOT TARGET fstiff::x3p)
    # by file: the package file that Debian ships for libzip fails unless its tools are installed too
    find_path(FSTIFF_LIBZIP_INCLUDE zip.h)
    find_library(FSTIFF_LIBZIP_LIBRARY zip)
    find_path(FSTIFF_PUGIXML_INCLUDE pugixml.hpp)
    find_library(FSTIFF_PUGIXML_LIBRARY pugixml)
    mark_as_advanced(FSTIFF_LIBZIP_INCLUDE FSTIFF_LIBZIP_LIBRARY FSTIFF_PUGIXML_INCLUDE FSTIFF_PUGIXML_LIBRARY)
    if(FSTIFF_LIBZIP_INCLUDE AND FSTIFF_LIBZIP_LIBRARY AND FSTIFF_PUGIXML_INCLUDE AND FSTIFF_PUGIXML_LIBRARY)
        add_library(fstiff::x3p INTERFACE IMPORTED)
        target_link_libraries(
            fstiff::x3p INTERFACE fstiff::fstiff ${FSTIFF_LIBZIP_LIBRARY} ${FSTIFF_PUGIXML_LIBRARY})
        target_include_directories(
            fstiff::x3p SYSTEM INTERFACE ${FSTIFF_LIBZIP_INCLUDE} ${FSTIFF_PUGIXML_INCLUDE})
        target_compile_definitions(fstiff::x3p INTERFACE FSTIFF_HAS_X3P)
    endif()
endif()
