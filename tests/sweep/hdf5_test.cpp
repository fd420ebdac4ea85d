// SPDX-License-Identifier: BSD-3-Clause
// An HDF5 file of results has the numbers of the lines, bit for bit.
#include "cli/command.hpp"
#include "support/skip.hpp"

#ifdef FSTIFF_HAS_HDF5
#include <hdf5.h>

#include <cmath>
#endif

namespace hdf5_test {

#ifdef FSTIFF_HAS_HDF5
using namespace test;

namespace {

/// The numbers behind "key": in every line; NaN for null and for a line without it.
std::vector<double> numbers(const std::string& text, const std::string& key) {
    std::vector<double> all;
    for (const std::string& line : lines(text)) {
        const auto at = line.find("\"" + key + "\":");
        const std::string value = at == std::string::npos ? "null" : line.substr(at + key.size() + 3);
        all.push_back(value.starts_with("null") ? std::nan("") : std::stod(value));
    }
    return all;
}

std::vector<double> stored(const std::string& file, const std::string& key, std::size_t size) {
    const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t set = H5Dopen2(opened, key.c_str(), H5P_DEFAULT);
    std::vector<double> all(size);
    const hid_t space = H5Dget_space(set);
    CHECK(H5Sget_simple_extent_npoints(space) == static_cast<hssize_t>(size));
    CHECK(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) >= 0);
    H5Sclose(space);
    H5Dclose(set);
    H5Fclose(opened);
    return all;
}

}  // namespace

TEST_CASE("An HDF5 file of results has the numbers of the lines, bit for bit") {
    const Folder folder;
    const std::string file = folder.write(
        "grid.toml",
        "[surface]\nrms_height = \"0.8 um\"\npeak_radius = [\"20 um\", \"40 um\"]\npeak_density = \"500 /mm^2\"\n"
        "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
        "[contact]\nlaws = [\"hertz\", \"greenwood_williamson\"]\npeaks = [ { theta = 1, r = 0.5 } ]\n"
        "pressures = [ { values = [\"1 MPa\", \"1e20 MPa\", \"2 MPa\"] } ]\n");
    const Outcome outcome = test::run_fstiff("sweep '" + file + "' -o '" + folder / "out.h5" + "'");
    INFO(outcome.err);
    REQUIRE(outcome.status == 4);  // of the great pressure
    const std::string text = read(folder / "out.h5.jsonl");
    const std::size_t size = lines(text).size();
    REQUIRE(size == 2 * 2 * 2 + 2);
    for (const char* key : {"index", "surface.peak_radius", "theta", "pressure_Pa", "stiffness_Pa_per_m"}) {
        const auto wanted = numbers(text, key), found = stored(folder / "out.h5", key, size);
        for (std::size_t i = 0; i < size; ++i) {
            INFO(key << " " << i);
            CHECK((std::isnan(wanted[i]) ? std::isnan(found[i]) : wanted[i] == found[i]));
        }
    }
    const hid_t opened = H5Fopen((folder / "out.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t law = H5Dopen2(opened, "law", H5P_DEFAULT), type = H5Dget_type(law);
    const std::size_t width = H5Tget_size(type);
    std::string names(size * width, '\0');
    CHECK(H5Dread(law, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, names.data()) >= 0);
    CHECK(std::string(names.c_str()) == "hertz");
    CHECK(names.substr(width, width) == "greenwood_williamson");
    H5Tclose(type);
    H5Dclose(law);
    H5Fclose(opened);

    for (const char* i : {"1", "2"})
        static_cast<void>(test::run_fstiff("sweep '" + file + "' --shard " + i + "/2 -o '" + folder / "part-{shard}.jsonl'"));
    REQUIRE(
        test::run_fstiff("merge '" + folder / "part-1.jsonl' '" + folder / "part-2.jsonl' -o '" + folder / "all.h5'").status ==
        4);
    CHECK(read(folder / "all.h5.jsonl") == text);
    CHECK(stored(folder / "all.h5", "stiffness_Pa_per_m", size)[0] == numbers(text, "stiffness_Pa_per_m")[0]);
}
#else
TEST_CASE("An HDF5 file of results is refused in words") {
    const test::Folder folder;
    const auto outcome = test::run_fstiff("sweep none.toml -o '" + folder / "out.h5" + "'");
    CHECK(outcome.status == 2);
    CHECK(test::contains(outcome.err, "was built without HDF5; write .jsonl"));
    SKIP_CASE("HDF5 is not here");
}
#endif

TEST_CASE("Parquet is refused with what to do instead") {
    const test::Folder folder;
    const auto outcome = test::run_fstiff("sweep none.toml -o '" + folder / "out.parquet" + "'");
    CHECK(outcome.status == 2);
    CHECK(test::contains(outcome.err, "convert it with pyarrow"));
    const auto table = test::run_fstiff("sweep none.toml -o '" + folder / "out.csv" + "'");
    CHECK(table.status == 2);
    CHECK(test::contains(table.err, "must end in .jsonl or .h5"));
}

}  // namespace hdf5_test
