# SPDX-License-Identifier: BSD-3-Clause
# The functions of fstiff/answer.hpp, which the headers alone declare: each target that links fstiff::fstiff compiles them once,
# but where fstiff::double has them, or the property FSTIFF_IMPLEMENTATION of the target is OFF.
function(fstiff_add_implementation target)
    set(has_double "$<IN_LIST:FSTIFF_COMPILED,$<TARGET_PROPERTY:COMPILE_DEFINITIONS>>")
    set(is_off "$<STREQUAL:$<TARGET_PROPERTY:FSTIFF_IMPLEMENTATION>,OFF>")
    set_property(TARGET ${target} APPEND PROPERTY INTERFACE_SOURCES
                 "$<$<NOT:$<OR:${has_double},${is_off}>>:${CMAKE_CURRENT_FUNCTION_LIST_DIR}/fstiff-implementation.cpp>")
endfunction()
