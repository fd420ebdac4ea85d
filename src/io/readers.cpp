// SPDX-License-Identifier: BSD-3-Clause
#include "io/readers.hpp"

#include "io/lines.hpp"

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

void check_options(SurfaceFormat format, const SurfaceOptions& options, const std::string& name) {
    const std::string useful = " " + std::string(reader_of(format).options) + " ";
    const std::pair<std::string_view, bool> given[] = {
        {"units", !options.units.empty()},     {"spacing", options.spacing.has_value()},
        {"column", options.column != 0},       {"x-column", options.x_column != 0},
        {"dx", options.dx.has_value()},        {"dy", options.dy.has_value()},
        {"width", options.width.has_value()},  {"height", options.height.has_value()},
        {"missing", !options.missing.empty()}, {"thousands", !options.thousands.empty()},
        {"resample", options.resample},        {"channel", !options.channel.empty()},
        {"grid", options.grid.has_value()},    {"x3p-increment", options.x3p_increment != X3pIncrement::apply}};
    for (const auto& [option, is_given] : given)
        if (is_given && useful.find(" " + std::string(option) + " ") == std::string::npos)
            refuse_file(name, {"is read as ", name_of(format), ", which has no use for ", option,
                               "; must not be given, or ", options.names.format, " must be another"});
}

}  // namespace detail

SurfaceFormat form_of_first_bytes(std::string_view bytes) {
    for (const detail::Reader* reader : detail::readers())
        if (reader->begins && reader->begins(bytes)) return reader->format;
    return SurfaceFormat::automatic;
}

}  // namespace fstiff::inline v0_1::io
