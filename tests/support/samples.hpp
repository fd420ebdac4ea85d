// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The files of tools/make_surface_samples.py: their contents, and changes by a test.
#include "io/readers.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/files.hpp"
#include "support/stored_archive.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace test {

/// The file \p name, such as "opd/map.opd".
inline std::string sample(const std::string& name) { return read(FSTIFF_TEST_DATA "/../fuzz/corpus/" + name); }

/// \p value as \p size bytes, the most significant first.
inline std::string big(std::int64_t value, std::size_t size) {
    const std::string bytes = little(value, size);
    return {bytes.rbegin(), bytes.rend()};
}
/// The bytes of \p number in memory, or in the other order where it is \p big.
template <class T>
std::string bytes_of(T number, bool big = false) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &number, sizeof(T));  // the tests run on little-endian machines
    if (big) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}
inline std::string little(float value) { return little(std::bit_cast<std::int32_t>(value), 4); }
inline std::string big(float value) { return big(std::bit_cast<std::int32_t>(value), 4); }

/// A map with a missing point, a subnormal, a negative zero and the greatest number.
inline fstiff::HeightMap<double> rough_map() {
    fstiff::HeightMap<double> map;
    map.heights.resize(7, 5);
    for (Eigen::Index i = 0; i < map.size(); ++i)
        map.heights.data()[i] = 1e-6 * std::sin(1.7 * static_cast<double>(i * i)) / 3;
    map.heights(2, 3) = std::numeric_limits<double>::quiet_NaN();
    map.heights(4, 4) = 0x1p-1074;
    map.heights(0, 1) = -0.0;
    map.heights(0, 2) = std::numeric_limits<double>::max();
    map.dx = 1e-6 / 3;
    map.dy = 2e-6 / 7;
    return map;
}

/// \p bytes with \p field at \p place.
inline std::string put(std::string bytes, std::size_t place, const std::string& field) {
    return bytes.replace(place, field.size(), field);
}

/// The reader of a form, with the options of a file that states too little.
struct FormReader {
    fstiff::io::SurfaceFormat format;
    fstiff::io::SurfaceOptions options{};

    fstiff::io::Reading operator()(const std::string& bytes) const { return (*this)(bytes, options); }
    fstiff::io::Reading operator()(const std::string& bytes, const fstiff::io::SurfaceOptions& given) const {
        return fstiff::io::detail::reader_of(format).read(bytes, "file", given);
    }
    [[nodiscard]] bool begins(const std::string& bytes) const {
        return fstiff::io::detail::reader_of(format).begins(bytes);
    }
};

/// The reader of any file.
struct FileReader {
    fstiff::io::Surface operator()(const std::string& bytes, const fstiff::io::SurfaceOptions& options = {}) const {
        return fstiff::io::read_surface(bytes, "file", options);
    }
};

/// The refusals of a reader.
template <class Reader>
class RefusalOf {
public:
    explicit RefusalOf(Reader reader) : reader_(std::move(reader)) {}
    std::string operator()(const std::string& bytes) const {
        return refusal([&] { (void)reader_(bytes); });
    }
    std::string operator()(const std::string& bytes, const fstiff::io::SurfaceOptions& options) const {
        return refusal([&] { (void)reader_(bytes, options); });
    }

private:
    Reader reader_;
};

/// \p found holds the heights of a sample times \p unit: a map whose \p missing points are row 1, column 2 and row 0,
/// column 3, or a profile of its first row.
inline void check_sample(const fstiff::io::Reading& found, double dx, double dy, double unit, std::size_t missing) {
    const auto& map = found.map;
    const bool is_map = map.rows == 3 && map.columns == 4;
    REQUIRE((is_map || (map.rows == 1 && map.columns == 20)));
    CHECK(ulps(map.dx, dx) <= 1);
    CHECK(ulps(map.dy, dy) <= 1);
    CHECK(found.record.missing == missing);
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        const std::size_t row = i / map.columns, column = i % map.columns;
        CAPTURE(row, column);
        if ((missing > 0 && row == 1 && column == 2) || (missing > 1 && row == 0 && column == 3))
            CHECK(std::isnan(map.heights[i]));
        else
            CHECK(ulps(map.heights[i], static_cast<double>(10 * row + column * column) * unit) <= 2);
    }
    CHECK(found.record.warnings.empty());
}

}  // namespace test
