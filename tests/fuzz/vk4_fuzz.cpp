// SPDX-License-Identifier: BSD-3-Clause
// Maps of Keyence. Damaged archives seldom get past their check sums: that of a .vk6 is taken for its Vk4File here.
#include "io/vk4.hpp"

#include "fuzz.hpp"

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    const auto unzip = [](std::string_view archive, const std::string&, std::string_view) {
        return std::string(archive);
    };
    fuzz::returns([&] { fuzz::check(io::read_vk4(bytes, "file", unzip)); });
    return 0;
}
