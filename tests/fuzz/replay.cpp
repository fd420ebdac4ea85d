// SPDX-License-Identifier: BSD-3-Clause
// Gives every file of the named folders to a fuzz target, and every file cut short: the corpus without a fuzzer.
#include "fuzz.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

int main(int count, char** folders) {
    std::size_t files = 0;
    for (int i = 1; i < count; ++i)
        for (const auto& entry : std::filesystem::directory_iterator(folders[i])) {
            std::ifstream input(entry.path(), std::ios::binary);
            const std::vector<char> bytes{std::istreambuf_iterator<char>(input), {}};
            const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
            for (std::size_t size = bytes.size() > 512 ? bytes.size() - 512 : 0; size <= bytes.size(); ++size)
                LLVMFuzzerTestOneInput(data, size);
            ++files;
        }
    std::printf("%zu files\n", files);
    return files == 0 ? 1 : 0;  // an empty corpus proves nothing
}
