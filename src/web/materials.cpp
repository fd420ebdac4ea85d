// SPDX-License-Identifier: BSD-3-Clause
// The names of materials that the page offers, one a line; bundle.py runs it.
#include <fstiff/asperity/named_materials.hpp>

#include <cstdio>

int main() {
    for (const auto& material : fstiff::detail::named_materials) std::puts(material.name.data());
}
