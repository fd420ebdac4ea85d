// SPDX-License-Identifier: BSD-3-Clause
// Compiled for the processor of this machine, linked with fstiff::io, which was compiled for any: arrays of Eigen are
// set aside and freed in another way by each, so that none may be handed over.
#include <fstiff/io.hpp>

#include <sstream>
#include <vector>

using namespace fstiff;

int main() {
    std::vector<HeightMap<double>> all;
    for (int rows = 2; rows < 40; ++rows) {
        HeightMap<double> map;
        map.heights = HeightMap<double>::Array::Random(rows, 3);
        map.dx = map.dy = 1e-6;
        for (const bool binary : {true, false}) {
            std::stringstream file;
            io::write_sdf(file, map, {.binary = binary});
            all.push_back(io::read_surface(file, "a map").map());
            if (!(all.back().heights == map.heights).all()) return 1;
        }
        std::stringstream text;
        io::write_csv(text, map);
        map = io::read_surface(text, "a map").map();  // freed here, what was there and what was read
        if (!(all.back().heights == map.heights).all()) return 1;
    }
    return 0;
}
