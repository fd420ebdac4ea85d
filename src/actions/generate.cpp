// SPDX-License-Identifier: BSD-3-Clause
#include "actions/generate.hpp"

#include <fstiff/double/surfaces.hpp>
#include "document/file.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/io/write.hpp>
#include <fstiff/synthetic/weierstrass_mandelbrot.hpp>

#include <algorithm>
#include <memory>
#include <sstream>

namespace fstiff::actions {
namespace {

/// Refuses the options that the kind has no use for, and those that it misses.
void check_options(const GenerateRequest& request) {
    const bool wm = request.kind == GeneratedKind::wm, map = request.kind == GeneratedKind::map;
    const std::string kind = "generate " + std::string(name_of(request.kind));
    const auto only = [&](bool given, bool wanted, std::string_view key, bool needed) {
        const std::string name = surface::option_name(request.prefix, key);
        if (given && !wanted) throw document::option_error(name + " is not for " + kind + "; must not be given");
        if (!given && wanted && needed) throw document::option_error(kind + " needs " + name);
    };
    only(!request.spacing.empty(), true, "spacing", true);
    only(request.dimension.has_value(), wm, "dimension", true);
    only(!request.roughness.empty(), wm, "roughness", true);
    only(request.gamma != 1.5, wm, "gamma", false);
    only(request.hurst.has_value(), !wm, "hurst", true);
    only(!request.rms.empty(), !wm, "rms", true);
    only(request.long_waves != LongWaves::plateau, !wm, "long_waves", false);
    only(request.rows != 0, map, "rows", false);
}

/// \p request with the numbers of points that it leaves to the kind. \throws domain_error for too few or too many.
GenerateRequest with_points(GenerateRequest request) {
    const bool map = request.kind == GeneratedKind::map;
    if (request.points == 0) request.points = map ? 256 : 4096;
    check_options(request);
    if (request.rows == 0) request.rows = map ? request.points : 1;
    constexpr std::size_t most = GenerateRequest::max_points;
    if (request.points > most || request.rows > most / request.points)
        throw domain_error("points = " + std::to_string(request.points) + " x " + std::to_string(request.rows) +
                           ": must be at most 2^22 (4194304) in all");
    return request;
}

std::string in_metres(double value) { return document::shortest(value) + " m"; }

/// The lengths of \p request in metres.
struct WaveRange {
    double spacing, longest, shortest;
};

Generated weierstrass_mandelbrot(const GenerateRequest& request, const WaveRange& waves) {
    const Fractal<double> fractal{
        *request.dimension,
        surface::parse_length(request.roughness, surface::option_name(request.prefix, "roughness"))};
    const WeierstrassMandelbrot<double> wm(fractal, {.longest_wavelength = waves.longest,
                                                     .shortest_wavelength = waves.shortest,
                                                     .gamma = request.gamma,
                                                     .seed = request.seed});
    // each point is a sum over all waves
    if (request.points > (std::size_t(1) << 30) / wm.terms())
        throw domain_error("points times waves = " + std::to_string(request.points) + " x " +
                           std::to_string(wm.terms()) + ": must be at most 2^30");
    return {wm.sample(request.points, waves.spacing),
            {{"D", document::shortest(fractal.dimension)},
             {"G", in_metres(fractal.roughness)},
             {"gamma", document::shortest(request.gamma)},
             {"waves", std::to_string(wm.terms())}}};
}

Generated self_affine(const GenerateRequest& request, const WaveRange& waves) {
    SelfAffineOptions<double> wanted_waves;
    wanted_waves.hurst = *request.hurst;
    wanted_waves.rms = surface::parse_length(request.rms, surface::option_name(request.prefix, "rms"));
    wanted_waves.longest_wavelength = waves.longest;
    wanted_waves.shortest_wavelength = waves.shortest;
    wanted_waves.long_waves = request.long_waves;
    wanted_waves.seed = request.seed;
    Generated generated{.surface = {},
                        .parameters = {{"H", document::shortest(wanted_waves.hurst)},
                                       {"rms", in_metres(wanted_waves.rms)},
                                       {"beyond the longest wave", std::string(name_of(wanted_waves.long_waves))}}};
    if (request.kind == GeneratedKind::map)
        generated.surface = self_affine_map(wanted_waves, request.points, request.rows, waves.spacing, waves.spacing);
    else
        generated.surface = self_affine_profile(wanted_waves, request.points, waves.spacing);
    return generated;
}

document::Json arrays_of(const io::ProfileOrMap& surface) {
    if (const auto* profile = std::get_if<Profile<double>>(&surface))
        return {{"heights_m", profile->heights}, {"columns", profile->size()}, {"rows", 1}, {"dx_m", profile->spacing}};
    const auto& map = std::get<HeightMap<double>>(surface);
    return {{"heights_m", std::vector<double>(map.heights.data(), map.heights.data() + map.size())},
            {"columns", map.columns()},
            {"rows", map.rows()},
            {"dx_m", map.dx},
            {"dy_m", map.dy}};
}

}  // namespace

std::string Generated::origin() const {
    std::string line;
    for (const auto& [name, value] : parameters) line += (line.empty() ? "" : ", ") + name + " " + value;
    return "made by fstiff " FSTIFF_VERSION_TEXT " generate (" + line + ")";
}

Generated generate(const GenerateRequest& given) {
    const GenerateRequest request = with_points(given);
    const auto length = [&](const request::Amount& amount, const char* key, double otherwise) {
        return amount.empty() ? otherwise : surface::parse_length(amount, surface::option_name(request.prefix, key));
    };
    const double spacing = length(request.spacing, "spacing", 0);
    const double side = static_cast<double>(std::max(request.points, request.rows)) * spacing;
    const WaveRange waves{spacing, length(request.longest, "longest", side),
                          length(request.shortest, "shortest", 2 * spacing)};
    Generated generated =
        request.kind == GeneratedKind::wm ? weierstrass_mandelbrot(request, waves) : self_affine(request, waves);
    generated.parameters.insert(generated.parameters.begin(), {"kind", std::string(name_of(request.kind))});
    generated.parameters.insert(generated.parameters.end(), {{"longest wave", in_metres(waves.longest)},
                                                             {"shortest wave", in_metres(waves.shortest)},
                                                             {"seed", std::to_string(request.seed)}});
    return generated;
}

std::string file_of(const Generated& generated, GeneratedForm form) {
    std::ostringstream stream;
    if (form == GeneratedForm::csv) stream << "# " << generated.origin() << "\n";
    std::visit(
        [&](const auto& surface) {
            if (form == GeneratedForm::csv)
                io::write_csv(stream, surface);
            else
                io::write_sdf(stream, surface, {.binary = form == GeneratedForm::sdf});
        },
        generated.surface);
    return std::move(stream).str();
}

document::Document document_of(const GenerateRequest& request) {
    const auto generated = std::make_shared<const Generated>(generate(request));
    document::Document document =
        document::Document::of_file([=, form = request.format] { return file_of(*generated, form); });
    if (request.format != GeneratedForm::csv) document.notes = {generated->origin()};  // the file has no room for it
    document.values([=](document::Json& to) { to = arrays_of(generated->surface); });
    return document;
}

}  // namespace fstiff::actions
