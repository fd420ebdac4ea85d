# SPDX-License-Identifier: BSD-3-Clause
# fstiff::zlib, where zlib is found: what src/io/inflate.cpp needs. Defines FSTIFF_HAS_ZLIB for those who link it.
if(NOT TARGET fstiff::zlib)
    find_path(FSTIFF_ZLIB_INCLUDE zlib.h)
    find_library(FSTIFF_ZLIB_LIBRARY NAMES z zlib)
    mark_as_advanced(FSTIFF_ZLIB_INCLUDE FSTIFF_ZLIB_LIBRARY)
    if(FSTIFF_ZLIB_INCLUDE AND FSTIFF_ZLIB_LIBRARY)
        add_library(fstiff::zlib INTERFACE IMPORTED)
        target_link_libraries(fstiff::zlib INTERFACE fstiff::fstiff ${FSTIFF_ZLIB_LIBRARY})
        target_include_directories(fstiff::zlib SYSTEM INTERFACE ${FSTIFF_ZLIB_INCLUDE})
        target_compile_definitions(fstiff::zlib INTERFACE FSTIFF_HAS_ZLIB)
    endif()
endif()
