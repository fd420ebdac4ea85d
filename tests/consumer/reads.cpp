// SPDX-License-Identifier: BSD-3-Clause
// A program that reads and writes files, by fstiff::io.
#include <fstiff/io.hpp>
#include <fstiff/io/quantities.hpp>

#include <sstream>

using namespace fstiff;

int main() {
    HeightMap<double> map;
    map.heights.resize(3, 4);
    for (int k = 0; k < 12; ++k) map.heights.data()[k] = 1e-9 * (k * k % 7);
    map.dx = io::parse_quantity("0.5 um", io::Dimension::length, "dx");
    map.dy = io::unit_factor("um", io::Dimension::length);
    std::stringstream sdf, csv;
    io::write_sdf(sdf, map);
    io::write_csv(csv, map);
    const io::Surface one = io::read_surface(sdf, "written.sdf"), other = io::read_surface(csv, "written.csv");
    bool right = one.record.format == io::SurfaceFormat::sdf && other.record.format == io::SurfaceFormat::matrix;
    for (const io::Surface* read : {&one, &other})
        right = right && !read->is_profile() && (read->map().heights == map.heights).all() &&
                read->map().dx == map.dx && read->map().dy == map.dy;
    try {
        (void)io::read_surface("PK\3\4", "damaged.x3p");
        right = false;
    } catch (const domain_error& error) {  // such as a damaged archive, or without zlib
        right = right && std::string(error.what()).starts_with("damaged.x3p: ");
    }
    return right ? 0 : 1;
}
