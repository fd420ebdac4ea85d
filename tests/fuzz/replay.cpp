// SPDX-License-Identifier: BSD-3-Clause
// Reads every file of a folder as a form, and every file cut short: the corpus without a fuzzer.
//     replay FORM FOLDER
#include "fuzz.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

int main(int count, char** arguments) {
    if (count != 3) return 2;
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(arguments[2])) {
        std::ifstream input(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(input), {}};
        for (std::size_t size = bytes.size() > 512 ? bytes.size() - 512 : 0; size <= bytes.size(); ++size)
            fuzz(arguments[1], bytes.substr(0, size));
        ++files;
    }
    std::printf("%zu files\n", files);
    return files == 0 ? 1 : 0;  // an empty corpus proves nothing
}
