# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=sh
# Sourced by check-libcxx and check-aarch64, after setup.sh: tests of some folders, built without CMake for another standard
# library or another processor. Catch2 is compiled with them, from its single header (Debian 12: package catch2), because the
# library that a distribution ships belongs to its own compiler and standard library.
#
# Set before: compiler, flags, link, run (in front of a program, may be empty), gsl (yes or no), build (a folder), folders.
# FLAGS adds flags, JOBS says how many compilers run at once, CATCH names the folder that holds catch2/catch.hpp.

# shellcheck disable=SC2154 # set where this is sourced
tests_elsewhere() {
    catch=${CATCH:-/usr/include}/catch2
    if [ ! -f "$catch/catch.hpp" ]; then
        echo "There is no $catch/catch.hpp, the single header of Catch2 2.13: set CATCH to the folder that holds catch2/catch.hpp" >&2
        exit 1
    fi
    mkdir -p "$build/include"
    ln -sfn "$catch" "$build/include/catch2" # alone: /usr/include is not for another processor
    printf '#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n' >"$build/catch_main.cpp"
    printf '#include <fstiff/fstiff.hpp>\nint main() {}\n' >"$build/umbrella.cpp"

    # the readers of files, but for what needs other libraries
    for source in "$root"/src/io/*.cpp; do
        case $source in */x3p.cpp | */inflate.cpp) ;; *) printf '#include "%s"\n' "$source" ;; esac
    done >"$build/fstiff_io.cpp"

    all="$flags -std=c++20 -O1 -Wall -Wextra -I$root/include -I$root/src -I$root/tests -isystem $build/include -isystem /usr/include/eigen3"
    all="$all -DFSTIFF_TEST_DATA=\\\"$root/tests/data\\\" -DFSTIFF_SCENES=\\\"$root/data\\\""
    all="$all -DFSTIFF_SURFACES=\\\"${SURFACES:-$root/../shared/surfaces}\\\" ${FLAGS:-}"
    {
        printf 'rule compile\n  command = %s %s -MMD -MF $out.d -c $in -o $out\n  description = compile $out\n  depfile = $out.d\n  deps = gcc\n' "$compiler" "$all"
        printf 'rule link\n  command = %s %s $in %s -o $out\n  description = link $out\n' "$compiler" "$flags" "$link"
        printf 'build catch_main.o: compile catch_main.cpp\nbuild umbrella.o: compile umbrella.cpp\nbuild umbrella: link umbrella.o\nbuild fstiff_io.o: compile fstiff_io.cpp\n'
        for folder in $folders; do
            objects=
            for source in "$root/tests/$folder"/*_test.cpp; do
                [ -f "$source" ] || { echo "There are no tests in tests/$folder" >&2 && exit 1; }
                if [ "$gsl" = no ] && grep -q '<gsl/' "$source"; then
                    echo "Left out, it needs GSL: tests/$folder/$(basename "$source")" >&2
                    continue
                fi
                case $source in */io/x3p_test.cpp | */io/inflate_test.cpp)
                    echo "Left out, it needs libraries built for the same: tests/$folder/$(basename "$source")" >&2
                    continue
                    ;;
                esac
                object=$folder/$(basename "$source" .cpp).o
                printf 'build %s: compile %s\n' "$object" "$source"
                objects="$objects $object"
            done
            printf 'build test_%s: link catch_main.o fstiff_io.o%s\n' "$folder" "$objects"
        done
    } >"$build/build.ninja.new"
    mv "$build/build.ninja.new" "$build/build.ninja"

    ninja -C "$build" -j "${JOBS:-$(nproc)}" >&2
    $run "$build/umbrella"
    failed=
    for folder in $folders; do
        echo "tests/$folder"
        $run "$build/test_$folder" '~[long]~[.]' || failed="$failed $folder"
    done
    [ -z "$failed" ] || { echo "Failed:$failed" >&2 && exit 1; }
}
