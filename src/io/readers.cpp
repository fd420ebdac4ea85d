// SPDX-License-Identifier: BSD-3-Clause
#include "io/readers.hpp"

#include <algorithm>
#include <array>

namespace fstiff::inline v0_1::io {

namespace detail {

extern const Reader profile_reader, triples_reader, matrix_reader, sdf_reader, x3p_reader, npy_reader, gsf_reader,
    gwy_reader, sur_reader, smd_reader, metropro_reader, vk4_reader, opd_reader, al3d_reader, plu_reader, plux_reader,
    netcdf_reader, opdx_reader, zygo_reader, surfer_reader, mat_reader, ply_reader, obj_reader;

namespace {

constexpr std::array all_readers{&profile_reader,  &triples_reader, &matrix_reader, &sdf_reader,  &x3p_reader,
                                 &npy_reader,      &gsf_reader,     &gwy_reader,    &sur_reader,  &smd_reader,
                                 &metropro_reader, &vk4_reader,     &opd_reader,    &al3d_reader, &plu_reader,
                                 &plux_reader,     &netcdf_reader,  &opdx_reader,   &zygo_reader, &surfer_reader,
                                 &mat_reader,      &ply_reader,     &obj_reader};
static_assert(all_readers.size() + 1 == enum_names<SurfaceFormat>.size(), "every form but automatic has a row");

}  // namespace

std::span<const Reader* const> readers() { return all_readers; }

const Reader& reader_of(SurfaceFormat format) {
    return **std::find_if(all_readers.begin(), all_readers.end(),
                          [&](const Reader* reader) { return reader->format == format; });
}

}  // namespace detail

SurfaceFormat form_of_first_bytes(std::string_view bytes) {
    for (const detail::Reader* reader : detail::readers())
        if (reader->begins && reader->begins(bytes)) return reader->format;
    return SurfaceFormat::automatic;
}

}  // namespace fstiff::inline v0_1::io
