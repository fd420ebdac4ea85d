// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using Document = std::unique_ptr<fstiff_document, void (*)(fstiff_document*)>;

Document run(const std::string& scene) {
    fstiff_document* made = nullptr;
    if (fstiff_run(scene.data(), scene.size(), "scene", nullptr, &made) != FSTIFF_OK)
        throw std::runtime_error(fstiff_last_message());
    return {made, fstiff_document_free};
}

std::vector<double> numbers(const Document& from, const std::string& key) {
    std::size_t count = 0;
    fstiff_document_numbers(from.get(), ("answer.*." + key).c_str(), nullptr, 0, &count);
    std::vector<double> values(count);
    fstiff_document_numbers(from.get(), ("answer.*." + key).c_str(), values.data(), count, &count);
    return values;
}

int main() {
    const Document answer =
        run("material.upper = \"steel\"\n"
            "surface = { rms_height = \"0.8 um\", rms_gradient = 0.1 }\n"
            "contact.pressures = [\"1 MPa\", \"10 MPa\"]\n");
    const auto p = numbers(answer, "pressure_Pa"), K = numbers(answer, "stiffness_Pa_per_m"),
               low = numbers(answer, "stiffness_p05_Pa_per_m"), high = numbers(answer, "stiffness_p95_Pa_per_m");
    for (std::size_t i = 0; i < p.size(); ++i)
        std::printf("%g Pa: %.3g (%.2g to %.2g) Pa/m\n", p[i], K[i], low[i], high[i]);
}
