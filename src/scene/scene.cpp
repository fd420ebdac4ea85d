// SPDX-License-Identifier: BSD-3-Clause
#include "scene/scene.hpp"

#include "scene/file.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/io/quantity.hpp>
#include <fstiff/surface/fractal.hpp>

// toml++ 3.3 asserts, or assumes in an optimised build, what some malformed texts break. Its assertions are made to throw
// in every build; no other file includes toml++.
namespace fstiff::scene {
struct BrokenToml {};
constexpr void expect_toml(bool whole) {
    if (!whole) throw BrokenToml{};
}
}  // namespace fstiff::scene
#undef NDEBUG
#define TOML_ASSERT(expression) fstiff::scene::expect_toml(static_cast<bool>(expression))
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <string_view>

namespace fstiff::scene {
namespace {

using io::Dimension;

std::string_view si_unit(Dimension dimension) {
    switch (dimension) {
        case Dimension::length:
            return "m";
        case Dimension::area:
            return "m^2";
        case Dimension::inverse_area:
            return "1/m^2";
        case Dimension::pressure:
            return "Pa";
        case Dimension::angle:
            return "rad";
        case Dimension::frequency:
            return "Hz";
        case Dimension::velocity:
            return "m/s";
        case Dimension::density:
            return "kg/m^3";
        case Dimension::impedance:
            return "kg/(m^2 s)";
        default:
            return "";
    }
}

/// A quantity as an example of how to write one.
std::string_view example(Dimension dimension) {
    switch (dimension) {
        case Dimension::area:
            return "195 mm^2";
        case Dimension::inverse_area:
            return "500 /mm^2";
        case Dimension::pressure:
            return "10 MPa";
        case Dimension::frequency:
            return "7 MHz";
        case Dimension::velocity:
            return "5900 m/s";
        case Dimension::density:
            return "7850 kg/m^3";
        case Dimension::impedance:
            return "46 MRayl";
        default:
            return "0.8 um";
    }
}

/// The text of a value for messages and for the echo of the inputs.
std::string written(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* number = node.as_floating_point())
        return std::isfinite(number->get()) ? shortest(number->get()) : std::isnan(number->get()) ? "nan" : "inf";
    if (const auto* number = node.as_integer()) return std::to_string(number->get());
    if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
    if (node.is_array()) return node.as_array()->empty() ? "[]" : "[...]";
    if (node.is_table()) return "{...}";
    return "a date or a time";
}

/// What all parts of one scene share: where it stands for messages, and the record of its inputs.
struct Source {
    std::string file;
    std::vector<Input> inputs;
    bool builtin = false;  ///< the scene is the built-in one, whose laws nobody chose

    std::string at(const toml::node& node) const {
        const auto line = node.source().begin.line;
        return line > 0 ? file + ":" + std::to_string(line) : file;
    }
    [[noreturn]] void refuse(const toml::node& node, const std::string& key, const std::string& reason) const {
        const std::string value = node.is_string() ? "\"" + written(node) + "\"" : written(node);
        throw domain_error(at(node) + ": " + key + " = " + value + ": " + reason);
    }
    Place place(const toml::node& node, std::string key = "") const {
        return {.file = file, .line = node.source().begin.line, .key = std::move(key), .before_line = ":"};
    }
    /// Runs a check or a reader of the library; what it throws gets the place.
    template <class Call>
    auto located(const toml::node& node, const Call& call) const {
        return fstiff::located(place(node), call);
    }
    void record(std::string key, std::string text, std::optional<double> value = {}, std::string_view unit = {}) {
        inputs.push_back({std::move(key), std::move(text), value, std::string(unit)});
    }

    double quantity(const toml::node& node, const std::string& key, Dimension dimension) {
        if (node.is_number())
            refuse(node, key,
                   "a number without a unit; write it as a text such as \"" + std::string(example(dimension)) + "\"");
        if (!node.is_string()) refuse(node, key, "must be a text such as \"" + std::string(example(dimension)) + "\"");
        const double value = located(node, [&] { return io::parse_quantity(written(node), dimension, key); });
        record(key, written(node), value, si_unit(dimension));
        return value;
    }
    double positive(const toml::node& node, const std::string& key, Dimension dimension) {
        const double value = quantity(node, key, dimension);
        if (!(value > 0) || !std::isfinite(value)) refuse(node, key, "must be finite and greater than 0");
        return value;
    }
    double number(const toml::node& node, const std::string& key) {
        if (!node.is_number()) refuse(node, key, "must be a plain number");
        const double value = *node.value<double>();
        if (!std::isfinite(value)) refuse(node, key, "must be a finite number");
        record(key, written(node), value);
        return value;
    }
    std::string text(const toml::node& node, const std::string& key) {
        if (!node.is_string()) refuse(node, key, "must be a text in quotation marks");
        record(key, written(node));
        return written(node);
    }
    /// One of the words of \p Enum.
    template <NamedEnum Enum>
    Enum choice(const toml::node& node, const std::string& key) {
        return names<Enum>[choice(node, key, fstiff::choices<Enum>())].value;
    }
    /// One of \p allowed, by its place in that list.
    std::size_t choice(const toml::node& node, const std::string& key, std::span<const std::string_view> allowed) {
        const auto found = std::find(allowed.begin(), allowed.end(), node.is_string() ? written(node) : "");
        if (found == allowed.end()) refuse(node, key, "must be one of " + list_of(allowed));
        record(key, written(node));
        return static_cast<std::size_t>(found - allowed.begin());
    }
    /// A non-empty list of choices, none twice.
    std::vector<std::size_t> choices(const toml::node& node, const std::string& key,
                                     std::span<const std::string_view> allowed) {
        if (!node.is_array() || node.as_array()->empty())
            refuse(node, key, "must be a list of one or more of " + list_of(allowed));
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0; i < node.as_array()->size(); ++i) {
            const toml::node& item = (*node.as_array())[i];
            const std::string item_key = key + "[" + std::to_string(i) + "]";
            chosen.push_back(choice(item, item_key, allowed));
            if (std::count(chosen.begin(), chosen.end(), chosen.back()) > 1)
                refuse(item, item_key, "is there twice; each may be named once");
        }
        return chosen;
    }
};

/// A table of the scene with the path of its keys; a key outside \p valid is refused with the list of them.
class Section {
public:
    Section(Source& source, const toml::table& table, std::string path, std::initializer_list<std::string_view> valid)
        : Section(source, table, std::move(path), std::span(valid.begin(), valid.size())) {}
    Section(Source& source, const toml::table& table, std::string path, std::span<const std::string_view> valid)
        : source_(source), table_(table), path_(std::move(path)) {
        for (const auto& [key, node] : table)
            if (std::find(valid.begin(), valid.end(), key.str()) == valid.end())
                throw domain_error(source.at(node) + ": " + this->key(key.str()) + ": unknown key; valid keys" +
                                   (path_.empty() ? "" : " of " + path_) + " are " + list_of(valid));
    }
    std::string key(std::string_view name) const { return (path_.empty() ? "" : path_ + ".") + std::string(name); }
    /// The place of the section itself, for messages.
    const toml::node& node() const { return table_; }
    const toml::node* find(std::string_view name) const { return table_.get(name); }
    const toml::node& at(std::string_view name, const std::string& why = "is missing; the scene needs it") const {
        if (const auto* found = find(name)) return *found;
        throw domain_error((path_.empty() ? source_.file : source_.at(table_)) + ": " + key(name) + ": " + why);
    }
    const toml::table& subtable(std::string_view name) const {
        const toml::node& found = at(name, "is missing; the scene needs this section");
        if (!found.is_table()) source_.refuse(found, key(name), "must be a section of keys");
        return *found.as_table();
    }

    double positive(std::string_view name, Dimension dimension) const {
        return source_.positive(at(name), key(name), dimension);
    }
    std::optional<double> optional_positive(std::string_view name, Dimension dimension) const {
        return find(name) ? std::optional(positive(name, dimension)) : std::nullopt;
    }

private:
    Source& source_;
    const toml::table& table_;
    std::string path_;
};

/// What decides which body is the softer one.
struct Strength {
    std::optional<double> yield, hardness;
    double poisson = 0;
    /// Hardness, given or by Tabor's factor; infinite where nothing is known.
    [[nodiscard]] double resistance() const {
        return hardness ? *hardness : yield ? 2.8 * *yield : std::numeric_limits<double>::infinity();
    }
};

Material<double> read_material(Source& source, const Section& body, Strength& strength) {
    Material<double> material{};
    material.youngs_modulus = body.positive("youngs_modulus", Dimension::pressure);
    const toml::node& nu = body.at("poisson_ratio");
    material.poisson_ratio = source.number(nu, body.key("poisson_ratio"));
    try {
        (void)effective_modulus(material, material);
    } catch (const domain_error& error) {
        throw error.with_parameter(body.key(error.parameter())).with_place(source.place(nu));
    }
    strength = {body.optional_positive("yield_strength", Dimension::pressure),
                body.optional_positive("hardness", Dimension::pressure), material.poisson_ratio};
    return material;
}

void read_materials(Source& source, const toml::table& table, Scene& scene) {
    const Section material(source, table, "material", {"upper", "lower"});
    const std::initializer_list<std::string_view> keys{"youngs_modulus", "poisson_ratio", "yield_strength", "hardness"};
    std::array<Strength, 2> of;
    const auto read = [&](const char* name, Strength& strength) {
        return read_material(source, Section(source, material.subtable(name), "material." + std::string(name), keys),
                             strength);
    };
    scene.upper = read("upper", of[0]);
    scene.lower = material.find("lower") ? read("lower", of[1]) : scene.upper;
    if (!material.find("lower")) of[1] = of[0];
    const Strength& softer = of[of[1].resistance() < of[0].resistance() ? 1 : 0];
    scene.softer_poisson = softer.poisson;
    scene.hardness = softer.hardness;
    for (const Strength& one : of)
        if (one.yield)
            scene.yield_strength = scene.yield_strength ? std::min(*scene.yield_strength, *one.yield) : *one.yield;
    if (!material.find("lower")) source.record("material.lower", "as material.upper (default)");
}

/// The impedances of a body, of longitudinal waves and, where it is known, of shear waves.
struct Body {
    double impedance = 0;
    std::optional<double> shear_impedance;
};

/// \p name, or the product of density and \p velocity; none: neither is there.
std::optional<double> read_impedance(Source& source, const Section& body, std::string_view name,
                                     std::string_view velocity, std::optional<double> density) {
    if (body.find(name)) {
        if (body.find(velocity))
            throw domain_error(source.at(*body.find(velocity)) + ": " + body.key(velocity) +
                               ": must not stand beside " + body.key(name) + "; give one of the two");
        return body.positive(name, Dimension::impedance);
    }
    const auto speed = body.optional_positive(velocity, Dimension::velocity);
    if (!speed) return std::nullopt;
    const std::string why = "is missing; " + body.key(velocity) + " needs it";
    if (!density) static_cast<void>(body.at("density", why));
    const double product = *density * *speed;
    if (!(product > 0) || !std::isfinite(product))
        source.refuse(*body.find(velocity), body.key(velocity),
                      "must make an impedance density * velocity in the range of double precision");
    return product;
}

Body read_body(Source& source, const Section& body) {
    const auto density = body.optional_positive("density", Dimension::density);
    const auto impedance = read_impedance(source, body, "impedance", "velocity", density);
    if (!impedance)
        throw domain_error(source.at(body.node()) + ": " + body.key("impedance") +
                           ": is missing; the scene needs it, or " + body.key("density") + " and " +
                           body.key("velocity"));
    return {*impedance, read_impedance(source, body, "shear_impedance", "shear_velocity", density)};
}

void read_ultrasound(Source& source, const toml::table& table, Scene& scene) {
    const Section section(source, table, "ultrasound", {"frequency", "upper", "lower"});
    const std::initializer_list<std::string_view> keys{"impedance", "density", "velocity", "shear_impedance",
                                                       "shear_velocity"};
    Waves waves;
    waves.frequency = section.positive("frequency", Dimension::frequency);
    if (!std::isfinite(waves.angular()) || waves.angular() == 0)
        source.refuse(section.at("frequency"), section.key("frequency"), "must be in the range of double precision");
    const Body upper = read_body(source, Section(source, section.subtable("upper"), "ultrasound.upper", keys));
    Body lower = upper;
    if (section.find("lower")) {
        lower = read_body(source, Section(source, section.subtable("lower"), "ultrasound.lower", keys));
        if (upper.shear_impedance.has_value() != lower.shear_impedance.has_value())
            throw domain_error(source.at(table) + ": ultrasound." + (upper.shear_impedance ? "lower" : "upper") +
                               ".shear_impedance: is missing; shear waves need that of both sides");
    } else {
        source.record("ultrasound.lower", "as ultrasound.upper (default)");
    }
    waves.longitudinal = {upper.impedance, lower.impedance};
    if (upper.shear_impedance) waves.shear = {*upper.shear_impedance, *lower.shear_impedance};
    scene.ultrasound = waves;
}

/// Measures or reads the file that surface.from or --surface names; messages begin with \p place.
MeasuredSurface measured_from(const MeasureOptions& options, bool defaults, const Place& place,
                              const ProgressHook& progress) {
    return located(place, [&] {
        const std::string bytes = read_all(options.input.file);
        if (!is_measured_document(bytes)) return measure_surface(options, bytes, progress);
        if (!defaults)
            throw domain_error(display_name(options.input.file) +
                               ": is the JSON of fstiff measure, measured already; must stand without keys of reading");
        return read_measured_document(bytes, display_name(options.input.file));
    });
}

/// The keys beside surface.from that say how the file is read.
constexpr std::array<std::string_view, 24> reading_keys{
    "format",        "units",    "spacing",  "column",     "dx",         "dy",     "width",   "height",
    "detrend",       "cutoff",   "peaks",    "tip_radius", "resolution", "window", "missing", "resample",
    "x3p_increment", "lambda_s", "lambda_c", "filter",     "crop",       "mask",   "spikes",  "fill"};

MeasuredSurface read_from(Source& source, const Section& surface, const ProgressHook& progress) {
    const toml::node& from = surface.at("from");
    MeasureOptions options;
    std::filesystem::path path = source.text(from, surface.key("from"));
    if (path.empty()) source.refuse(from, surface.key("from"), "must name a file");
    const std::filesystem::path scene(source.file);
    if (path != "-" && path.is_relative() && scene.has_parent_path()) path = scene.parent_path() / path;
    options.input.file = path.string();
    const std::array<std::string*, reading_keys.size()> into{&options.input.format,
                                                             &options.input.units,
                                                             &options.input.spacing,
                                                             nullptr,
                                                             &options.input.dx,
                                                             &options.input.dy,
                                                             &options.input.width,
                                                             &options.input.height,
                                                             &options.input.detrend,
                                                             &options.input.cutoff,
                                                             nullptr,
                                                             &options.input.tip_radius,
                                                             &options.input.resolution,
                                                             &options.window,
                                                             nullptr,
                                                             nullptr,
                                                             &options.input.x3p_increment,
                                                             &options.input.lambda_s,
                                                             &options.input.lambda_c,
                                                             nullptr,
                                                             &options.input.crop,
                                                             nullptr,
                                                             nullptr,
                                                             nullptr};
    bool defaults = true;
    for (std::size_t i = 0; i < reading_keys.size(); ++i) {
        const toml::node* node = surface.find(reading_keys[i]);
        if (!node) continue;
        defaults = false;
        const std::string key = surface.key(reading_keys[i]);
        if (into[i]) {
            *into[i] = source.text(*node, key);
        } else if (reading_keys[i] == "peaks") {
            options.peaks = source.choice<PeakSource>(*node, key);
        } else if (reading_keys[i] == "filter") {
            options.input.filter = source.choice<scene::CutOffFilter>(*node, key);
        } else if (reading_keys[i] == "missing") {  // missing = -9999 or missing = "-9999"
            if (!node->is_number() && !node->is_string()) source.refuse(*node, key, "must be a number or a text");
            options.input.missing = written(*node);
            source.record(key, written(*node));
        } else if (reading_keys[i] == "resample" || reading_keys[i] == "fill") {
            if (!node->is_boolean()) source.refuse(*node, key, "must be true or false");
            (reading_keys[i] == "fill" ? options.input.fill : options.input.resample) = node->as_boolean()->get();
            source.record(key, written(*node));
        } else if (reading_keys[i] == "mask") {
            std::filesystem::path mask = source.text(*node, key);
            if (mask.is_relative() && scene.has_parent_path()) mask = scene.parent_path() / mask;
            options.input.mask = mask.string();
        } else if (reading_keys[i] == "spikes") {
            const auto number = node->value<double>();
            if (!number || !(*number >= 3 && *number <= 1000))
                source.refuse(*node, key, "must be a number from 3 to 1000");
            options.input.spikes = *number;
            source.record(key, written(*node), *number);
        } else {
            const auto* column = node->as_integer();
            if (!column || column->get() < 1 || column->get() > 1000000)
                source.refuse(*node, key, "must be a whole number from 1 to 1000000");
            options.input.column = static_cast<int>(column->get());
            source.record(key, written(*node), static_cast<double>(column->get()));
        }
    }
    return measured_from(options, defaults, source.place(from, surface.key("from")), progress);
}

/// Fills the scene with what was measured.
void take_measured(Source& source, Scene& scene) {
    const MeasuredSurface& measured = *scene.measured;
    const auto& p = measured.parameters;
    const auto value = [&](Parameter which) { return p.value[index_of(which)]; };
    const auto known = [&](Parameter which) { return p.known[index_of(which)]; };
    scene.uncertain = p;
    scene.surface = {value(Parameter::rms_height), value(Parameter::peak_radius), value(Parameter::peak_density),
                     measured.max_peak_height.value};
    if (known(Parameter::fractal_dimension)) scene.fractal_dimension = value(Parameter::fractal_dimension);
    if (measured.fractal_roughness) scene.fractal_roughness = measured.fractal_roughness->value;
    if (measured.heights) {
        scene.rms_gradient = measured.heights->rms_gradient.value;
        scene.alpha = measured.heights->moments.bandwidth();
    }
    scene.map = measured.of_map;
    if (known(Parameter::r) && known(Parameter::theta)) {
        scene.r = value(Parameter::r);
        scene.theta = value(Parameter::theta);
    }
    for (const ParameterLine& line : parameter_lines(measured))
        source.record("surface." + line.name + " (measured)", shortest(line.measured.value), line.measured.value,
                      line.unit == "/m^2"    ? "1/m^2"
                      : line.name == "theta" ? "rad"
                                             : line.unit);
}

double read_angle(Source& source, const toml::node& node, const std::string& key) {
    if (node.is_string()) {
        const double angle = source.located(node, [&] { return io::parse_angle(written(node), key); });
        source.record(key, written(node), angle, "rad");
        return angle;
    }
    if (!node.is_number())
        source.refuse(node, key, "must be a number of radians or a text such as \"pi/4\" or \"45 deg\"");
    const double angle = source.number(node, key);
    source.inputs.back().unit = "rad";
    return angle;
}

/// One parameter of [surface], or of surface.errors.
double read_parameter(Source& source, const Section& section, const ParameterRow& row, const toml::node& node,
                      bool zero_too = false) {
    const std::string key = section.key(row.key);
    if (row.unit.empty()) return source.number(node, key);
    for (const Dimension dimension : {Dimension::length, Dimension::inverse_area})
        if (row.unit == si_unit(dimension))
            return zero_too ? source.quantity(node, key, dimension) : source.positive(node, key, dimension);
    return read_angle(source, node, key);
}

/// rms_gradient, alpha and hurst, as they are written; what was measured stays where they are not.
void read_spectrum(Source& source, const Section& surface, Scene& scene) {
    const auto read = [&](std::string_view name, std::optional<double>& into, double low, double high,
                          const char* range) {
        const toml::node* node = surface.find(name);
        if (!node) return;
        into = source.number(*node, surface.key(name));
        if (!(*into > low && *into <= high)) source.refuse(*node, surface.key(name), range);
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    read("rms_gradient", scene.rms_gradient, 0, infinity, "must be greater than 0");
    read("alpha", scene.alpha, 1.5, infinity, "must be greater than 1.5, which every isotropic surface exceeds");
    read("hurst", scene.hurst, 0, 1, "must be greater than 0 and at most 1");
}

void read_surface(Source& source, const toml::table& table, Scene& scene, const ProgressHook& progress) {
    const auto all = std::span(parameter_table).first<surface_parameter_count>();
    const std::initializer_list<std::string_view> written_keys{"from",
                                                               "rms_height",
                                                               "peak_radius",
                                                               "peak_density",
                                                               "max_peak_height",
                                                               "fractal_dimension",
                                                               "fractal_roughness",
                                                               "r",
                                                               "theta",
                                                               "rms_gradient",
                                                               "alpha",
                                                               "hurst",
                                                               "errors"};
    std::vector<std::string_view> valid(written_keys);
    if (table.contains("from")) valid.insert(valid.end(), reading_keys.begin(), reading_keys.end());
    const Section surface(source, table, "surface", valid);
    if (surface.find("from")) {
        scene.measured = read_from(source, surface, progress);
        take_measured(source, scene);
    }
    read_spectrum(source, surface, scene);
    for (const std::string_view key : {"rms_height", "peak_radius", "peak_density", "rms_gradient", "alpha", "hurst"})
        if (scene.map && surface.find(key)) scene.spectrum_of_map = false;  // numbers written by hand replace the map's
    UncertainSurface<double>& uncertain = scene.uncertain;
    for (const ParameterRow& row : all) {
        const std::size_t i = index_of(row.parameter);
        // R and D_p follow from the moments where these are complete
        const bool follows = row.parameter > Parameter::rms_height && scene.rms_gradient && scene.alpha;
        const bool needed = !scene.measured && row.parameter <= Parameter::peak_density && !follows;
        const toml::node* node = needed ? &surface.at(row.key) : surface.find(row.key);
        if (!node) {
            if (!scene.measured && row.parameter <= Parameter::peak_density) {
                const auto moments = moments_of_gradient(uncertain.value[index_of(Parameter::rms_height)],
                                                         *scene.rms_gradient, *scene.alpha);
                const double value =
                    row.parameter == Parameter::peak_radius ? peak_radius_of(moments) : peak_density_of(moments);
                uncertain.set(row.parameter, {value, 0});
                source.record(surface.key(row.key), "of rms_height, rms_gradient and alpha (default)", value,
                              row.parameter == Parameter::peak_radius ? "m" : "1/m^2");
            }
            continue;
        }
        uncertain.set(row.parameter, {read_parameter(source, surface, row, *node), 0});
        if (!parameter_in_range(row.parameter, uncertain.value[i]))
            source.refuse(*node, surface.key(row.key), "must be " + row.range());
        for (std::size_t j = 0; j < surface_parameter_count; ++j)  // written by hand: independent of what was measured
            uncertain.correlation[i][j] = uncertain.correlation[j][i] = i == j ? 1 : 0;
    }
    if (const auto* errors = surface.find("errors")) {
        if (!errors->is_table()) source.refuse(*errors, surface.key("errors"), "must be a table of standard errors");
        constexpr auto keys = choices<Parameter>();
        const Section section(source, *errors->as_table(), surface.key("errors"),
                              std::span(keys).first<surface_parameter_count>());
        for (const ParameterRow& row : all) {
            const std::size_t i = index_of(row.parameter);
            const toml::node* node = section.find(row.key);
            if (!node) continue;
            const std::string key = section.key(row.key);
            if (!uncertain.known[i])
                source.refuse(*node, key, "has no value beside it; must stand beside surface." + std::string(row.key));
            uncertain.error[i] = read_parameter(source, section, row, *node, true);
            if (!(uncertain.error[i] >= 0 && std::isfinite(uncertain.error[i])))
                source.refuse(*node, key, "must be finite and not negative");
        }
    }
    const auto value = [&](Parameter which) -> std::optional<double> {
        const std::size_t i = index_of(which);
        return uncertain.known[i] ? std::optional(uncertain.value[i]) : std::nullopt;
    };
    scene.surface.rms_height = *value(Parameter::rms_height);
    scene.surface.peak_radius = *value(Parameter::peak_radius);
    scene.surface.peak_density = *value(Parameter::peak_density);
    if (const auto highest = surface.optional_positive("max_peak_height", Dimension::length))
        scene.surface.max_peak_height = *highest;
    scene.fractal_dimension = value(Parameter::fractal_dimension);
    if (const auto roughness = surface.optional_positive("fractal_roughness", Dimension::length))
        scene.fractal_roughness = *roughness;
    scene.r = value(Parameter::r);
    scene.theta = value(Parameter::theta);
    if (scene.r.has_value() != scene.theta.has_value())
        throw domain_error(source.at(table) + ": " + surface.key(scene.r ? "theta" : "r") +
                           ": is missing; surface.r and surface.theta stand side by side");
}

/// A list of quantities, or { from, to, count, spacing }. Pressures are positive; separations may have either sign.
std::vector<double> read_points(Source& source, const toml::node& node, const std::string& key, Dimension dimension) {
    const bool pressures = dimension == Dimension::pressure;
    const auto one = [&](const toml::node& item, const std::string& item_key) {
        return pressures ? source.positive(item, item_key, dimension) : source.quantity(item, item_key, dimension);
    };
    if (const auto* list = node.as_array()) {
        if (list->empty()) source.refuse(node, key, "is an empty list; at least one value is needed");
        std::vector<double> points;
        for (std::size_t i = 0; i < list->size(); ++i)
            points.push_back(one((*list)[i], key + "[" + std::to_string(i) + "]"));
        return points;
    }
    if (!node.is_table())
        source.refuse(node, key, "must be a list of quantities or a table { from, to, count, spacing }");

    constexpr long long most = 100000;
    constexpr std::array<std::string_view, 2> spacings{"log", "linear"};
    const Section range(source, *node.as_table(), key, {"from", "to", "count", "spacing"});
    const double from = one(range.at("from"), range.key("from"));
    const double to = one(range.at("to"), range.key("to"));
    const toml::node& count_node = range.at("count");
    const auto* count = count_node.as_integer();
    if (!count || count->get() < 2 || count->get() > most)
        source.refuse(count_node, range.key("count"), "must be a whole number from 2 to " + std::to_string(most));
    source.record(range.key("count"), written(count_node), static_cast<double>(count->get()));
    if (!(from < to)) source.refuse(range.at("to"), range.key("to"), "must be greater than " + range.key("from"));
    const bool log =
        range.find("spacing") ? source.choice(*range.find("spacing"), range.key("spacing"), spacings) == 0 : pressures;
    if (!range.find("spacing")) source.record(range.key("spacing"), std::string(spacings[log ? 0 : 1]) + " (default)");
    if (log && !(from > 0))
        source.refuse(range.at("from"), range.key("from"), "must be greater than 0 for spacing = \"log\"");

    std::vector<double> points;
    const auto last = static_cast<double>(count->get() - 1);
    for (double i = 0; i <= last; ++i) {
        const double share = i / last;
        points.push_back(log ? std::exp((1 - share) * std::log(from) + share * std::log(to))
                             : (1 - share) * from + share * to);
    }
    points.front() = from;
    points.back() = to;
    return points;
}

/// The peak density of [surface].
Peaks peaks_of_surface(const Scene& scene, const Place& where) {
    return {*scene.theta, scene.r, true, where, "surface."};
}

Peaks read_one_peaks(Source& source, const toml::node& node, const std::string& path, const Scene& scene) {
    if (node.is_string() && written(node) == "surface") {
        if (!scene.r)
            source.refuse(node, path,
                          "needs surface.r and surface.theta" +
                              (scene.measured ? ", which were not found: " + scene.measured->peaks_refusal : ""));
        source.record(path, "surface");
        return peaks_of_surface(scene, source.place(node));
    }
    if (!node.is_table())
        source.refuse(node, path, "must be a table such as { theta = \"pi/4\", r = \"exponential\" }, or \"surface\"");
    const Section section(source, *node.as_table(), path, {"theta", "r"});
    Peaks peaks;
    peaks.where = source.place(node);
    peaks.key = path + ".";

    peaks.theta = read_angle(source, section.at("theta"), section.key("theta"));
    const toml::node& r = section.at("r");
    if (r.is_string() && written(r) == "exponential")
        source.record(section.key("r"), written(r));
    else if (!r.is_number())
        source.refuse(r, section.key("r"), "must be a number or \"exponential\"");
    else
        peaks.r = source.number(r, section.key("r"));
    return peaks;
}

void read_interaction(Source& source, const Section& contact, Scene& scene) {
    const toml::node* node = contact.find("interaction");
    const std::string key = contact.key("interaction");
    const std::string allowed =
        "must be \"none\" or a table such as { reading = \"effective_separation\", length = \"nominal\" }";
    if (!node) return source.record(key, "none (default)");
    if (node->is_string()) {
        if (written(*node) != "none") source.refuse(*node, key, allowed);
        return source.record(key, "none");
    }
    if (!node->is_table()) source.refuse(*node, key, allowed);
    const Section table(source, *node->as_table(), key, {"reading", "length"});
    scene.reading = source.choice<InteractionReading>(table.at("reading"), table.key("reading"));

    const toml::node* length = table.find("length");
    const std::string text = length && length->is_string() ? written(*length) : length ? "" : "nominal";
    if (const auto by = find_named<InteractionLength>(text)) {
        scene.length = *by;
        source.record(table.key("length"), length ? text : "nominal (default)");
    } else {
        scene.length = InteractionLength::given;
        scene.given_length = source.positive(*length, table.key("length"), Dimension::length);
    }
    if (scene.reading != InteractionReading::none && scene.length == InteractionLength::nominal && !scene.nominal_area)
        throw domain_error(source.at(*node) + ": " + contact.key("nominal_area") +
                           ": is missing; interaction length \"nominal\" is its square root");
}

/// What the section contact.<law> says, in the order of Law::options.
std::vector<double> read_law_options(Source& source, const Section& contact, const Law& law) {
    std::vector<double> values;
    if (law.options.empty()) return values;
    std::vector<std::string_view> keys;
    for (const LawOption& option : law.options) keys.push_back(option.key);
    static const toml::table none;
    const Section section(source, contact.find(law.name) ? contact.subtable(law.name) : none, contact.key(law.name),
                          keys);
    for (const LawOption& option : law.options) {
        const toml::node* node = option.otherwise ? section.find(option.key) : &section.at(option.key);
        values.push_back(!node              ? *option.otherwise
                         : option.dimension ? section.positive(option.key, *option.dimension)
                                            : source.number(*node, section.key(option.key)));
        if (!node) source.record(section.key(option.key), shortest(values.back()) + " (default)", values.back());
    }
    return values;
}

/// Why \p law cannot be computed of \p scene; empty where it can.
std::string refusal_of(const Law& law, const Scene& scene) {
    if (law.needs_map && !scene.map)
        return "needs a map: surface.from, or --surface, must name the file of one (the JSON of fstiff measure holds "
               "its "
               "numbers alone)";
    if (law.name == "summits" && scene.map->summits.summits.empty())
        return "needs summits: no point of the map stands above its eight neighbours";
    if (law.name == "boundary_elements" && std::min(scene.map->map->rows(), scene.map->map->columns()) < 16)
        return "needs a map of at least 16 points a side";
    if (law.needs_map && scene.map->map->present() != scene.map->map->size() && law.name == "boundary_elements")
        return "needs a map without missing points; " +
               std::to_string(scene.map->map->size() - scene.map->map->present()) + " are missing";
    if (law.needs_spectrum)
        if (const std::string why = no_spectrum(scene); !why.empty()) return "needs a spectrum: " + why;
    if (law.needs_hardness && !scene.hardness && !scene.yield_strength)
        return "needs material.upper.hardness or material.upper.yield_strength (hardness = 2.8 times it)";
    if (law.needs_yield && !scene.yield_strength) return "needs material.upper.yield_strength";
    return "";
}

void read_laws(Source& source, const Section& contact, Scene& scene, bool replaced) {
    std::vector<const Law*> chosen;
    if (const auto* node = contact.find("laws")) {
        const auto names = law_names();
        for (const auto i : source.choices(*node, contact.key("laws"), names)) chosen.push_back(&laws()[i]);
    } else {
        if (scene.fractal_dimension) chosen.push_back(find_law("fractal"));
        chosen.insert(chosen.end(), {find_law("hertz"), find_law("greenwood_williamson")});
        source.record(contact.key("laws"), scene.fractal_dimension ? "fractal, hertz, greenwood_williamson (default)"
                                                                   : "hertz, greenwood_williamson (default)");
    }
    const auto lacks = [&](const Law* law) { return law->needs_dimension && !scene.fractal_dimension; };
    if (scene.measured && (source.builtin || !contact.find("laws")) &&
        !std::count(chosen.begin(), chosen.end(), find_law("hybrid"))) {
        if (const std::string why = no_spectrum(scene); why.empty())
            chosen.insert(chosen.begin(), find_law("hybrid"));
        else
            scene.warnings.push_back("law hybrid is not computed: " + why);
    }
    if (replaced && !std::all_of(chosen.begin(), chosen.end(), lacks)) {
        if (std::erase_if(chosen, lacks) > 0) scene.warnings.push_back("no fractal law is computed, for want of D");
    }
    for (const Law* law : chosen) {
        if (lacks(law))
            throw domain_error(source.at(*contact.find("laws")) + ": surface.fractal_dimension: is missing; law \"" +
                               std::string(law->name) + "\" needs it" +
                               (scene.measured && !scene.measured->fractal_refusal.empty()
                                    ? "; it was not found: " + scene.measured->fractal_refusal
                                    : ""));
        if (const std::string why = refusal_of(*law, scene); !why.empty())
            throw domain_error((contact.find("laws") ? source.at(*contact.find("laws")) : source.file) + ": " +
                               contact.key("laws") + ": \"" + std::string(law->name) + "\" " + why);
        scene.laws.push_back({law, read_law_options(source, contact, *law)});
    }
}

void read_peaks(Source& source, const Section& contact, Scene& scene, bool replaced) {
    const toml::node* peaks = contact.find("peaks");
    if (scene.r && (replaced || !peaks)) {
        scene.peaks.push_back(peaks_of_surface(scene, {.file = source.file}));
        source.record(contact.key("peaks"), replaced ? "surface (--surface)" : "surface (default)");
    } else if (peaks) {
        if (peaks->is_string())
            scene.peaks.push_back(read_one_peaks(source, *peaks, contact.key("peaks"), scene));
        else if (!peaks->is_array() || peaks->as_array()->empty())
            source.refuse(*peaks, contact.key("peaks"),
                          "must be \"surface\" or a list of tables such as { theta = \"pi/4\", r = \"exponential\" }");
        else
            for (std::size_t i = 0; i < peaks->as_array()->size(); ++i)
                scene.peaks.push_back(read_one_peaks(source, (*peaks->as_array())[i],
                                                     contact.key("peaks") + "[" + std::to_string(i) + "]", scene));
    } else {
        for (const char* theta : {"pi/4", "pi/3"})
            scene.peaks.push_back(
                {io::parse_angle(theta, "theta"), std::nullopt, false, {.file = source.file}, "contact.peaks."});
        source.record(contact.key("peaks"), "theta = pi/4 and pi/3, r = exponential (default)");
    }
}

void read_contact(Source& source, const toml::table& table, Scene& scene, bool replaced) {
    std::vector<std::string_view> keys{"nominal_area", "pressures", "separations", "laws", "peaks", "interaction"};
    for (const Law& law : laws())
        if (!law.options.empty()) keys.push_back(law.name);
    const Section contact(source, table, "contact", keys);
    scene.nominal_area = contact.optional_positive("nominal_area", Dimension::area);

    const toml::node* pressures = contact.find("pressures");
    const toml::node* separations = contact.find("separations");
    if (pressures && separations)
        throw domain_error(source.at(*separations) + ": " + contact.key("separations") +
                           ": must not stand beside contact.pressures; give one of the two");
    scene.at_separations = separations != nullptr;
    const std::string key = contact.key(separations ? "separations" : "pressures");
    if (separations)
        scene.points = read_points(source, *separations, key, Dimension::length);
    else if (pressures)
        scene.points = read_points(source, *pressures, key, Dimension::pressure);
    else
        contact.at("pressures", "is missing; the scene needs contact.pressures or contact.separations");
    scene.points_where = source.at(separations ? *separations : *pressures) + ": " + key + ": ";

    read_laws(source, contact, scene, replaced);
    read_peaks(source, contact, scene, replaced);
    read_interaction(source, contact, scene);
}

void read_output(Source& source, const toml::table* table, Scene& scene) {
    constexpr std::array<std::string_view, 8> names{"stiffness",        "separation",           "real_area",
                                                    "contacts",         "tangential_stiffness", "reflection",
                                                    "shear_reflection", "loading_stiffness"};
    const std::array<bool*, 8> flags{&scene.stiffness,        &scene.separation,           &scene.real_area,
                                     &scene.contacts,         &scene.tangential_stiffness, &scene.reflection,
                                     &scene.shear_reflection, &scene.loading_stiffness};
    static const toml::table none;
    const Section output(source, table ? *table : none, "output", {"quantities"});
    const bool shear = scene.ultrasound && scene.ultrasound->shear;
    if (const auto* quantities = output.find("quantities")) {
        const std::string key = output.key("quantities");
        for (const auto i : source.choices(*quantities, key, names)) *flags[i] = true;
        if ((scene.reflection || scene.shear_reflection) && !scene.ultrasound)
            throw domain_error(source.at(*quantities) + ": " + key + ": needs the section ultrasound for " +
                               (scene.reflection ? "\"reflection\"" : "\"shear_reflection\""));
        if (scene.shear_reflection && !shear)
            throw domain_error(source.at(*quantities) + ": " + key +
                               ": needs ultrasound.upper.shear_impedance or shear_velocity for \"shear_reflection\"");
    } else {
        const std::size_t count = shear ? 7 : scene.ultrasound ? 6 : 4;
        std::string text;
        for (std::size_t i = 0; i < count; ++i) {
            *flags[i] = true;
            text += (i ? ", " : "") + std::string(names[i]);
        }
        source.record(output.key("quantities"), text + " (default)");
    }
}

void read_uncertainty(Source& source, const toml::table& table, Scene& scene) {
    const Section section(source, table, "uncertainty", {"samples", "seed"});
    const auto whole = [&](std::string_view name, long long most) -> std::optional<long long> {
        const toml::node* node = section.find(name);
        if (!node) return std::nullopt;
        const auto* number = node->as_integer();
        if (!number || number->get() < 0 || number->get() > most)
            source.refuse(*node, section.key(name), "must be a whole number from 0 to " + std::to_string(most));
        source.record(section.key(name), written(*node), static_cast<double>(number->get()));
        return number->get();
    };
    if (const auto samples = whole("samples", 100000)) {
        if (*samples > 0 && *samples < 20)
            source.refuse(*section.find("samples"), section.key("samples"), "must be 0 for no band, or at least 20");
        scene.samples = static_cast<int>(*samples);
    }
    if (const auto seed = whole("seed", (1LL << 53) - 1)) scene.seed = static_cast<std::uint64_t>(*seed);
}

void read_persson(Source& source, const toml::table& table, Scene& scene) {
    const Section section(source, table, "persson", {"gamma", "spectrum"});
    if (const toml::node* node = section.find("gamma")) {
        scene.gamma = source.number(*node, section.key("gamma"));
        if (!(scene.gamma > 0 && scene.gamma <= 1))
            source.refuse(*node, section.key("gamma"), "must be greater than 0 and at most 1");
    }
    if (const toml::node* node = section.find("spectrum")) {
        constexpr std::array<std::string_view, 2> sources{"map", "moments"};
        scene.spectrum_of_map = source.choice(*node, section.key("spectrum"), sources) == 0;
        if (scene.spectrum_of_map && !scene.map)
            source.refuse(*node, section.key("spectrum"),
                          "needs a map: surface.from, or --surface, must name the file of one");
    }
}

void read_elements(Source& source, const toml::table& table, Scene& scene) {
    const Section section(source, table, "boundary_elements", {"points", "edges", "hardness"});
    if (const toml::node* node = section.find("points")) {
        const auto* points = node->as_integer();
        if (!points || points->get() < 16 || points->get() > 4096)
            source.refuse(*node, section.key("points"), "must be a whole number from 16 to 4096");
        scene.elements.points = points->get();
        source.record(section.key("points"), written(*node), static_cast<double>(points->get()));
    }
    if (const toml::node* node = section.find("edges"))
        scene.elements.edges = source.choice<Edges>(*node, section.key("edges"));
    scene.elements.hardness = section.optional_positive("hardness", Dimension::pressure).value_or(0);
}

/// TOML allows characters beyond ASCII in quotation marks and comments only; elsewhere toml++ 3.3 runs into undefined
/// behaviour on some of them, so that a forgotten quotation mark before a µ is told here.
void refuse_bare_unicode(std::string_view text, const std::string& file) {
    std::size_t line = 1;
    std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    const auto step = [&] { line += text[i++] == '\n' ? 1 : 0; };
    while (i < text.size()) {
        const char c = text[i];
        if (c == '#') {
            while (i < text.size() && text[i] != '\n') ++i;
        } else if (c == '"' || c == '\'') {
            const std::string_view mark =
                text.substr(i, 3) == std::string(3, c) ? text.substr(i, 3) : text.substr(i, 1);
            i += mark.size();
            while (i < text.size() && text.substr(i, mark.size()) != mark && (mark.size() == 3 || text[i] != '\n')) {
                if (c == '"' && text[i] == '\\' && i + 1 < text.size()) step();
                step();
            }
            if (i < text.size() && text[i] == c) i += mark.size();
        } else if (static_cast<unsigned char>(c) >= 0x80) {
            throw domain_error(
                file + ":" + std::to_string(line) +
                ": is no TOML: a character beyond ASCII stands outside quotation marks; it must stand inside");
        } else {
            step();
        }
    }
}

/// The line at which toml++ trips over \p text: that of the shortest beginning of the text that breaks it too.
std::size_t breaking_line(std::string_view text) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') ends.push_back(i + 1);
    const auto broken = std::partition_point(ends.begin(), ends.end(), [text](std::size_t end) {
        try {
            static_cast<void>(toml::parse(text.substr(0, end)));
        } catch (const BrokenToml&) {
            return false;
        } catch (const toml::parse_error&) {  // a table or a text cut short
        }
        return true;
    });
    return static_cast<std::size_t>(broken - ends.begin()) + 1;
}

toml::table parse_toml(const std::string& text, const std::string& file) {
    constexpr std::size_t most = std::size_t(1) << 20;
    if (text.size() > most)
        throw domain_error(file + ": has " + std::to_string(text.size()) + " bytes; must be at most 1 MiB");
    const auto refuse = [&](std::size_t line, const std::string& reason) {
        return domain_error(file + ":" + std::to_string(line) + ": is no TOML: " + reason);
    };
    if (text.find('\0') != std::string::npos)
        throw domain_error(file + ": is binary, or UTF-16 (it holds NUL bytes); must be TOML, a text in UTF-8");
    refuse_bare_unicode(text, file);
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw refuse(error.source().begin.line, std::string(error.description()));
    } catch (const BrokenToml&) {
        throw refuse(breaking_line(text), "a character that nothing may begin with");
    }
}

}  // namespace

PeakDistribution<double> peak_density(const Peaks& peaks) {
    try {
        return peaks.r ? PeakDistribution<double>(*peaks.r, peaks.theta)
                       : PeakDistribution<double>::exponential(peaks.theta);
    } catch (const domain_error& error) {
        throw error.with_parameter(peaks.key + std::string(error.parameter())).with_place(peaks.where);
    }
}

SpectralMoments<double> spectral_moments(const Scene& scene) {
    const Roughness<double>& of = scene.surface;
    SpectralMoments<double> moments = moments_of_peaks(of.rms_height, of.peak_radius, of.peak_density);
    if (scene.rms_gradient && scene.alpha) return moments_of_gradient(of.rms_height, *scene.rms_gradient, *scene.alpha);
    if (scene.rms_gradient) moments.m2 = *scene.rms_gradient * *scene.rms_gradient / 2;
    if (scene.alpha) moments.m2 = of.rms_height * std::sqrt(moments.m4 / *scene.alpha);
    return moments;
}

double hurst_exponent(const Scene& scene) {
    return scene.hurst ? *scene.hurst : scene.fractal_dimension ? 2 - *scene.fractal_dimension : 0.8;
}

std::string no_spectrum(const Scene& scene) {
    if (scene.map && scene.spectrum_of_map)
        return scene.map->spectrum.shells.empty()   ? "points of the map are missing, or it has fewer than 4 a side"
               : scene.map->summits.summits.empty() ? "no point of the map stands above its eight neighbours"
                                                    : "";
    const double alpha = spectral_moments(scene).bandwidth();
    if (alpha > 1.5) return "";
    return "rms_height, R and D_p make alpha = m0 m4/m2^2 = " + rounded(alpha, 3) +
           ", and every isotropic surface has more than 1.5; must be told surface.rms_gradient";
}

Scene read_scene(const std::string& text, const SceneSource& from) {
    const std::string &file = from.name, &surface = from.surface;
    Source source{file, {}, text == builtin_scene};
    const toml::table root = parse_toml(text, file);
    Scene scene;
    scene.file = file;
    scene.sha256 = sha256(text);

    const Section top(source, root, "",
                      {"name", "surface", "material", "contact", "persson", "boundary_elements", "ultrasound",
                       "uncertainty", "output"});
    if (const auto* name = top.find("name"))
        scene.name = source.text(*name, "name");
    else
        scene.name = std::filesystem::path(file).stem().string();
    if (surface.empty()) {
        read_surface(source, top.subtable("surface"), scene, from.progress);
    } else {
        MeasureOptions options;
        options.input.file = surface;
        options.input.prefix = "fstiff measure --";  // has the options that run has not
        options.input.format_name = "fstiff measure --input-format";
        scene.measured = measured_from(options, true, {.key = "--surface"}, from.progress);
        source.record("surface.from", display_name(surface) + " (--surface)");
        scene.name =
            std::filesystem::path(scene.measured->file).filename().string();  // no longer what the scene was named for
        take_measured(source, scene);
    }
    if (scene.measured) scene.warnings = scene.measured->warnings;
    if (top.find("uncertainty")) read_uncertainty(source, top.subtable("uncertainty"), scene);
    read_materials(source, top.subtable("material"), scene);
    if (top.find("persson")) read_persson(source, top.subtable("persson"), scene);
    if (top.find("boundary_elements")) read_elements(source, top.subtable("boundary_elements"), scene);
    read_contact(source, top.subtable("contact"), scene, !surface.empty());
    if (top.find("ultrasound")) read_ultrasound(source, top.subtable("ultrasound"), scene);
    read_output(source, top.find("output") ? &top.subtable("output") : nullptr, scene);
    scene.inputs = std::move(source.inputs);
    return scene;
}

}  // namespace fstiff::scene
