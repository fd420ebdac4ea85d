// SPDX-License-Identifier: BSD-3-Clause
// Measured surfaces, from files and from arrays, and what is found of them: the JSON documents of the command.
#include "given.hpp"

#include "actions/fractal.hpp"
#include "actions/generate.hpp"
#include "actions/islands.hpp"
#include "actions/measure.hpp"
#include "actions/scales.hpp"
#include "actions/spectrum.hpp"
#include "actions/truth.hpp"
#include "request/words.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>

#include <fstiff/io/quantities.hpp>
#include <fstiff/peaks/single_radius.hpp>

#include <optional>
#include <stdexcept>
#include <variant>

namespace fstiff::python {

using surface::MeasuredSurface;

request::Value value_of(const nb::handle& value) {
    using Kind = request::Value::Kind;
    request::Value given{.kind = Kind::other, .written = nb::cast<std::string>(nb::repr(value)).substr(0, 40)};
    long long whole = 0;
    bool truth = false;
    std::string text;
    if (nb::isinstance<nb::bool_>(value) && nb::try_cast(value, truth)) {
        given.kind = Kind::truth, given.number = truth;
    } else if (nb::try_cast(value, text)) {
        given.kind = Kind::text, given.written = text;
    } else if (nb::try_cast(value, whole)) {
        given.kind = Kind::integer, given.number = static_cast<double>(whole);
    } else if (nb::try_cast(value, given.number)) {
        given.kind = Kind::real;
    } else if (nb::isinstance<nb::sequence>(value)) {
        given.kind = Kind::list;
        for (const nb::handle item : value) given.items.push_back(value_of(item));
    }
    return given;
}

request::Values values_of(const nb::dict& options) {
    request::Values values;
    for (const auto [key, value] : options) {
        if (!value.is_none()) values.add(nb::cast<std::string>(key), value_of(value));
    }
    return values;
}

namespace {

/// Heights of the caller [m].
struct Heights {
    std::optional<In> array;   ///< none: a file
    double dx = 0, dy = 0;     ///< [m]
    std::string name, origin;  ///< in messages, and where they come from
};

/// The heights, copied; none: those of the file of \p options. Without the GIL.
std::optional<surface::SurfaceInput> input_of(const surface::SurfaceOptions& options, const Heights& heights) {
    if (!heights.array) return std::nullopt;
    const In& array = *heights.array;
    if (array.ndim() == 1) {
        const auto numbers = numbers_of(array);
        return surface_of_heights(options, Profile<double>{{numbers.begin(), numbers.end()}, heights.dx},
                                  heights.origin);
    }
    if (array.ndim() != 2)
        throw domain_error("heights have " + std::to_string(array.ndim()) +
                           " dimensions: must have 1 (a profile) or 2 (a map)");
    using Array = HeightMap<double>::Array;
    return surface_of_heights(
        options,
        HeightMap<double>{Eigen::Map<const Array>(array.data(), static_cast<Eigen::Index>(array.shape(0)),
                                                  static_cast<Eigen::Index>(array.shape(1))),
                          heights.dx, heights.dy},
        heights.origin);
}

/// Measures files, or what files called so \p contain, or \p arrays.
Found measure(const nb::dict& options, const std::vector<std::string>& files, const std::vector<nb::bytes>& contents,
              const std::vector<Heights>& arrays) {
    std::vector<std::string> bytes;
    for (const nb::bytes& one : contents) bytes.emplace_back(one.c_str(), one.size());
    auto how = request_of<surface::MeasureOptions>(options);
    const nb::gil_scoped_release free;
    const auto measure = [&](surface::MeasureOptions of, std::size_t i) {
        of.input.file = arrays[i].name;
        return measure_surface(of, *input_of(of.input, arrays[i]), until_interrupted());
    };
    const auto surface = std::make_shared<const MeasuredSurface>(
        !arrays.empty() ? measure_parts(how, arrays.size(), measure, "array")
                        : measure_files(how, files, until_interrupted(), bytes));
    return found(actions::document_of(how, surface), surface);
}

/// Heights, dx and dy (0 of a profile).
nb::tuple arrays_of(const Profile<double>& profile) {
    return nb::make_tuple(NewArray(profile.heights).take(), profile.spacing, 0.);
}
nb::tuple arrays_of(const HeightMap<double>& map) {
    const std::size_t rows = static_cast<std::size_t>(map.rows()), columns = static_cast<std::size_t>(map.columns());
    return nb::make_tuple(NewArray({map.heights.data(), rows * columns}, {rows, columns}).take(), map.dx, map.dy);
}
nb::tuple arrays_of(const io::ProfileOrMap& surface) {
    return std::visit([](const auto& one) { return arrays_of(one); }, surface);
}

/// What pictures of a measured surface show: the heights without their form, the structure functions of second
/// differences with what is fitted to them, and the islands of a map.
nb::dict views(const MeasuredSurface& surface) {
    nb::dict all;
    const auto array = [](const std::vector<double>& values) { return NewArray(values).take(); };
    const auto add_fit = [&](const char* along, const FractalFit<double>& fit) {
        nb::dict one;
        one["lag_m"] = array(fit.second_differences.lag), one["value_m2"] = array(fit.second_differences.value);
        one["fitted_lag_m"] = array(fit.fitted.lag), one["fitted_value_m2"] = array(fit.fitted.value);
        one["window_m"] = nb::make_tuple(fit.window.from, fit.window.to);
        one["fractal_dimension"] = nb::make_tuple(fit.fractal.dimension, fit.dimension_error);
        all[along] = one;
    };
    if (surface.found.profile) {
        const Profile<double>& profile = surface.found.profile->profile;
        all["heights"] = arrays_of(profile);
        if (surface.found.profile_fit) add_fit("fit", *surface.found.profile_fit);
    } else if (surface.found.map) {
        const HeightMap<double>& map = surface.found.map->map;
        all["heights"] = arrays_of(map);
        if (surface.found.map_fit && surface.found.map_fit->x) add_fit("fit along x", *surface.found.map_fit->x);
        if (surface.found.map_fit && surface.found.map_fit->y) add_fit("fit along y", *surface.found.map_fit->y);
        if (surface.found.islands) {
            const IslandCurve<double>& curve = surface.found.islands->curve;
            nb::dict islands;
            islands["bearing_area"] = array(curve.bearing_area);
            islands["density_per_m2"] = array(curve.density), islands["radius_m"] = array(curve.radius);
            islands["representative"] = curve.representative();
            all["islands"] = islands;
        }
    }
    return all;
}

/// The document of fstiff measure --scales, of a surface measured of \p heights or of its file.
Found scales(const std::shared_ptr<const MeasuredSurface>& surface, const Heights& heights, double pressure,
             double modulus) {
    if (!surface->how) throw domain_error(surface->file + ": must be measured from one file or array");
    detail::require_positive("pressure", pressure);
    detail::require_positive("effective_modulus", modulus);
    const nb::gil_scoped_release free;
    const actions::ScalesOptions how{pressure, modulus, until_interrupted()};
    const auto input = input_of(surface->how->input, heights);
    return found(document_of(*surface->how, surface,
                             scales_of(*surface, input ? *input : read_surface_input(surface->how->input), how), how));
}

/// The answer to a request about heights, or about numbers if there are none.
template <class Request>
Found answered(const nb::dict& options, const std::optional<Heights>& heights) {
    auto request = request_of<Request>(options);
    if constexpr (requires { request.progress; }) request.progress = until_interrupted();
    const nb::gil_scoped_release free;
    return found(document_of(request, heights ? input_of(request.surface, *heights) : std::nullopt));
}

Found truth(const nb::dict& options, const Heights& heights, const In& pressures, double modulus) {
    auto request = request_of<actions::TruthRequest>(options);
    request.progress = until_interrupted();
    request.modulus = modulus;
    request.pressures.assign(numbers_of(pressures).begin(), numbers_of(pressures).end());
    values_of(options).read("hardness", request.hardness);
    const nb::gil_scoped_release free;
    return found(document_of(request, input_of(request.surface, heights)));
}

/// Heights, dx and dy, and how they were made.
nb::tuple generated(const nb::dict& options) {
    const auto how = request_of<actions::GenerateRequest>(options);
    const actions::Generated made = [&] {
        const nb::gil_scoped_release free;
        return generate(how);
    }();
    return nb::make_tuple(arrays_of(made.surface), made.origin());
}

/// Heights, dx and dy, what was decided, and warnings.
nb::tuple read(const nb::dict& options) {
    surface::SurfaceOptions how;
    values_of(options).fill(how);
    const surface::SurfaceInput input = [&] {
        const nb::gil_scoped_release free;
        return read_surface_input(how);
    }();
    const io::SurfaceRecord& record = input.surface.record;
    return nb::make_tuple(arrays_of(input.surface.data), record.sentences(), record.warnings);
}

}  // namespace

void add_surfaces(nb::module_& m) {
    nb::class_<MeasuredSurface>(m, "Measured", "What was measured, for scenes and contacts.")
        .def("views", &views)
        .def("parts", [](const std::shared_ptr<const MeasuredSurface>& surface) {  // of a pooled one
            std::vector<std::shared_ptr<const MeasuredSurface>> parts;
            for (const MeasuredSurface& part : surface->parts) parts.emplace_back(surface, &part);
            return parts;
        });
    nb::class_<Heights>(m, "Heights", "Where the heights are.")
        .def(
            "__init__",
            [](Heights* self, std::optional<In> array, double dx, double dy, std::string name, std::string origin) {
                new (self) Heights{std::move(array), dx, dy, std::move(name), std::move(origin)};
            },
            nb::arg("array").none(), nb::arg("dx"), nb::arg("dy"), nb::arg("name"), nb::arg("origin"));
    nb::class_<Found>(m, "Found", "A document of the command.")
        .def_ro("json", &Found::json)
        .def_ro("doubtful", &Found::doubtful)
        .def_ro("measured", &Found::measured);
    m.def("scales", &scales, nb::arg("measured"), nb::arg("heights"), nb::arg("pressure"), nb::arg("modulus"));
    m.def("measure", &measure, nb::arg("options"), nb::arg("files"), nb::arg("contents"), nb::arg("arrays"));
    m.def("without_folders", &surface::without_folders, nb::arg("names"));
    m.def("fit", &answered<actions::FractalOptions>, nb::arg("options"), nb::arg("heights"));
    m.def("islands", &answered<actions::IslandsRequest>, nb::arg("options"), nb::arg("heights"));
    m.def("spectrum", &answered<actions::SpectrumRequest>, nb::arg("options"), nb::arg("heights"));
    m.def("generate", &generated, nb::arg("options"));
    m.def("truth", &truth, nb::arg("options"), nb::arg("heights"), nb::arg("pressures"), nb::arg("modulus"));
    m.def(
        "parse_length",
        [](const nb::handle& value, const std::string& name) {
            request::Amount length;
            request::put(value_of(value), length, name, {});
            return surface::parse_length(length, name);
        },
        nb::arg("value"), nb::arg("name"));
    m.def(
        "parse_quantity",
        [](const std::string& text, const std::string& unit, const std::string& name) {
            if (unit == "rad") return io::parse_angle(text, name);
            if (name.ends_with("mean_height") || name.ends_with("Ra"))
                if (const auto of_grade = request::mean_height_of_grade(text)) return *of_grade;
            for (const auto& [dimension, _] : enum_names<io::Dimension>)
                if (request::si_unit(dimension) == unit) return io::parse_quantity(text, dimension, name);
            throw std::logic_error("no kind of quantity has the unit " + unit);
        },
        nb::arg("text"), nb::arg("unit"), nb::arg("name"));
    m.def("surface_options", [] {  // the keys of the table, and whether they are of files alone
        nb::dict keys;
        for (const surface::SurfaceOptionRow& row : surface::surface_option_table())
            keys[row.key.data()] = row.is_of_file();
        return keys;
    });
    m.def("read", &read, nb::arg("options"));
}

}  // namespace fstiff::python
