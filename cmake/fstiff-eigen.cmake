# SPDX-License-Identifier: BSD-3-Clause
# Which Eigen fstiff takes: 3.4 to 5. Checked by hand, in the build and in the installed package: the version file of Eigen
# accepts its own major version alone, and that of Eigen 3.4.0 accepts no ranges. An Eigen3::Eigen that a project defines
# itself has no version, and is taken as it is. Sets fstiff_eigen_problem, empty when all is well.
set(fstiff_eigen_problem "")
if(Eigen3_VERSION AND (Eigen3_VERSION VERSION_LESS 3.4 OR Eigen3_VERSION VERSION_GREATER_EQUAL 6))
    set(fstiff_eigen_problem
        "Eigen3 ${Eigen3_VERSION} in ${Eigen3_DIR}: fstiff needs 3.4 or later, below 6 (Eigen3_DIR names another one)")
endif()
