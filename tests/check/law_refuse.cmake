# SPDX-License-Identifier: BSD-3-Clause
# A law that misses a member is refused with a message that names it.
#   cmake -D COMPILER=... -D EIGEN=... -D INCLUDE=... -D WORK=... -P law_refuse.cmake
file(MAKE_DIRECTORY ${WORK})
set(source "#include <fstiff/contact/rough_contact.hpp>\n")
foreach(missing load stiffness area)
    set(members "")
    foreach(member load stiffness area)
        if(NOT member STREQUAL missing)
            string(APPEND members "    auto ${member}(const auto& omega, double) const { return omega; }\n")
        endif()
    endforeach()
    string(APPEND source "struct Without_${missing} {
${members}};
auto contact_without_${missing}() {
    return fstiff::RoughContact(fstiff::Roughness<double>{1e-6, 1e-5, 1e9}, fstiff::PeakDistribution<double>(0.5, 1),
                                Without_${missing}{}, 1e11);
}
")
endforeach()
file(WRITE ${WORK}/laws.cpp "${source}")
execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -I${INCLUDE} -isystem ${EIGEN} ${WORK}/laws.cpp
                RESULT_VARIABLE code ERROR_VARIABLE said)
foreach(missing load stiffness area)  # a law that is taken has no message
    if(code EQUAL 0 OR NOT said MATCHES "no member ${missing}\\(omega, radius\\)")
        message(FATAL_ERROR "the message does not name ${missing}:\n${said}")
    endif()
endforeach()
