// SPDX-License-Identifier: BSD-3-Clause
// The benchmark program: bench/README.md describes the rows.
#include "row.hpp"

int main(int argc, char** argv) {
    benchmark::AddCustomContext("compiler", FSTIFF_BENCH_COMPILER);
    benchmark::AddCustomContext("flags", FSTIFF_BENCH_FLAGS);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return bench::refused_rows() == 0 ? 0 : 1;
}
