# SPDX-License-Identifier: BSD-3-Clause
# fstiff::hdf5, where the C library of HDF5 is found: fstiff sweep then writes .h5. Defines FSTIFF_HAS_HDF5 for those who
# link it.
if(NOT TARGET fstiff::hdf5)
    find_path(FSTIFF_HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial hdf5)  # Debian keeps serial and MPI apart
    find_library(FSTIFF_HDF5_LIBRARY NAMES hdf5_serial hdf5)
    mark_as_advanced(FSTIFF_HDF5_INCLUDE FSTIFF_HDF5_LIBRARY)
    if(FSTIFF_HDF5_INCLUDE AND FSTIFF_HDF5_LIBRARY)
        add_library(fstiff::hdf5 INTERFACE IMPORTED GLOBAL)
        target_link_libraries(fstiff::hdf5 INTERFACE ${FSTIFF_HDF5_LIBRARY})
        target_include_directories(fstiff::hdf5 SYSTEM INTERFACE ${FSTIFF_HDF5_INCLUDE})
        target_compile_definitions(fstiff::hdf5 INTERFACE FSTIFF_HAS_HDF5)
    else()
        message(STATUS "HDF5 is not found: fstiff sweep writes JSON Lines alone")
    endif()
endif()
