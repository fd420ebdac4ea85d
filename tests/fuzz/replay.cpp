// SPDX-License-Identifier: BSD-3-Clause
// Gives every file of a folder to a fuzz target, and every file cut short: the corpus without a fuzzer.
//     replay TARGET FOLDER
// All targets are compiled here together, because they share most of the readers.
#define LLVMFuzzerTestOneInput fuzz_al3d
#include "al3d_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_gsf
#include "gsf_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_gwy
#include "gwy_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_map_text
#include "map_text_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_metropro
#include "metropro_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_netcdf
#include "netcdf_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_npy
#include "npy_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_opd
#include "opd_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_opdx
#include "opdx_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_plu
#include "plu_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_profile_text
#include "profile_text_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_sdf
#include "sdf_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_smd
#include "smd_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_stl
#include "stl_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_sur
#include "sur_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_vk4
#include "vk4_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#ifdef FSTIFF_HAS_X3P
#define LLVMFuzzerTestOneInput fuzz_plux
#include "plux_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzz_x3p
#include "x3p_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#endif

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <vector>

namespace {

const std::map<std::string, int (*)(const std::uint8_t*, std::size_t)> targets{
    {"al3d", fuzz_al3d},
    {"gsf", fuzz_gsf},
    {"gwy", fuzz_gwy},
    {"map_text", fuzz_map_text},
    {"metropro", fuzz_metropro},
    {"netcdf", fuzz_netcdf},
    {"npy", fuzz_npy},
    {"opd", fuzz_opd},
    {"opdx", fuzz_opdx},
    {"plu", fuzz_plu},
    {"profile_text", fuzz_profile_text},
    {"sdf", fuzz_sdf},
    {"smd", fuzz_smd},
    {"stl", fuzz_stl},
    {"sur", fuzz_sur},
    {"vk4", fuzz_vk4},
#ifdef FSTIFF_HAS_X3P
    {"plux", fuzz_plux},
    {"x3p", fuzz_x3p},
#endif
};

}  // namespace

int main(int count, char** arguments) {
    if (count != 3) return 2;
    const auto target = targets.at(arguments[1]);
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(arguments[2])) {
        std::ifstream input(entry.path(), std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(input), {}};
        const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
        for (std::size_t size = bytes.size() > 512 ? bytes.size() - 512 : 0; size <= bytes.size(); ++size)
            target(data, size);
        ++files;
    }
    std::printf("%zu files\n", files);
    return files == 0 ? 1 : 0;  // an empty corpus proves nothing
}
