# SPDX-License-Identifier: BSD-3-Clause
# The functions of fstiff/answer.hpp, which the headers alone declare: each target that links fstiff::fstiff compiles them once,
# unless its property FSTIFF_IMPLEMENTATION is OFF; with fstiff::double the file is empty.
function(fstiff_add_implementation target)
    set(property $<TARGET_PROPERTY:FSTIFF_IMPLEMENTATION>)
    set(is_off $<AND:$<NOT:$<STREQUAL:${property},>>,$<NOT:$<BOOL:${property}>>>)
    set(file ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/fstiff-implementation.cpp)
    set_source_files_properties(${file} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    set_property(TARGET ${target} APPEND PROPERTY INTERFACE_SOURCES $<BUILD_INTERFACE:$<$<NOT:${is_off}>:${file}>>)
endfunction()
