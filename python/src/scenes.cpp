// SPDX-License-Identifier: BSD-3-Clause
// Scenes: their curves as columns, their contacts, their laws for other programs, and parameters of measured curves.
#include "given.hpp"

#include "actions/explanation.hpp"
#include "actions/export.hpp"
#include "actions/identify.hpp"
#include "actions/measure.hpp"
#include "actions/one_contact.hpp"
#include "actions/run.hpp"
#include "actions/ultrasound.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace fstiff::python {

using scene::Scene;

namespace {

Scene scene_of_text(const std::string& text, const std::string& name, const std::string& surface,
                    const surface::MeasuredSurface* measured) {
    const nb::gil_scoped_release free;
    return scene::read_scene(text,
                             {.name = name, .surface = surface, .progress = until_interrupted(), .measured = measured});
}

Scene scene_of_file(const std::string& file, const std::string& surface, const surface::MeasuredSurface* measured) {
    const nb::gil_scoped_release free;
    return scene::read_scene(document::read_all(file, document::longest_scene), {.name = document::display_name(file),
                                                                                 .surface = surface,
                                                                                 .progress = until_interrupted(),
                                                                                 .measured = measured});
}

/// The columns of the CSV, of all curves one below the other: numbers as an array, texts as a list.
nb::list columns_of(const actions::Answered& answered) {
    const auto& scene = *answered.scene;
    struct Column {
        std::string key;
        std::vector<std::string> words;
        std::vector<double> numbers;
    };
    std::vector<Column> all;
    for (const AnswerCurve& curve : answered.curves()) {
        const document::Rows rows = actions::point_rows(scene, curve, answered.has_band());
        std::size_t place = 0;
        for (const document::Rows::Column& column : rows.columns()) {
            if (!column.heading.csv || column.heading.key.empty()) continue;
            if (place == all.size()) all.push_back({column.heading.key, {}, {}});
            Column& to = all[place++];
            if (to.key != column.heading.key) throw std::logic_error("curves of unlike columns");
            for (const document::Cell& cell : column.cells) {
                if (cell.kind == document::Cell::Kind::text) to.words.push_back(cell.words);
                to.numbers.push_back(cell.kind == document::Cell::Kind::real ? cell.number
                                     : cell.kind == document::Cell::Kind::count
                                         ? static_cast<double>(cell.whole)
                                         : std::numeric_limits<double>::quiet_NaN());
            }
        }
    }
    nb::list columns;
    for (const Column& column : all)
        if (column.words.empty())
            columns.append(nb::make_tuple(column.key, NewArray(column.numbers).take()));
        else
            columns.append(nb::make_tuple(column.key, column.words));
    return columns;
}

nb::dict run(const Scene& scene) {
    const actions::Answered answered = [&] {
        const nb::gil_scoped_release free;
        return actions::compute(scene, until_interrupted());
    }();
    nb::list curves;
    for (const AnswerCurve& curve : answered.curves())
        curves.append(nb::make_tuple(actions::laws_of(curve), curve.theta, curve.r, actions::count_of(curve)));
    nb::dict bands;  // of a column: those of the ends of its band
    for (const scene::NumberOf& column : scene.columns(answered.has_band()))
        if (column.part == "_p05")
            bands[column.quantity->key().c_str()] = nb::make_tuple(column.key(), column.quantity->key("_p95"));
    nb::dict all;
    all["columns"] = columns_of(answered);
    all["bands"] = bands;
    all["curves"] = curves;
    all["warnings"] = answered.warnings;
    nb::list lines;
    for (const actions::InputLine& line : input_lines(answered)) lines.append(nb::make_tuple(line.label, line.parts));
    all["input_lines"] = lines;
    nb::list checks;
    const auto add_checks = [&](const std::string& of, const std::vector<Check<double>>& made) {
        for (const auto& check : made)
            checks.append(nb::make_tuple(of, std::string(name_of(check.concern)), check.least, check.greatest,
                                         check.limit, check.holds()));
    };
    add_checks("surface", actions::surface_checks(scene.joint));
    for (const AnswerCurve& curve : answered.curves()) add_checks(actions::title(curve), curve.checks);
    all["checks"] = checks;
    all["answer_table"] = answered.has_answer() ? answer_table(answered) : document::TextRows();
    all["document"] = run_document(answered).str();
    all["best"] = scene.best;
    all["effective_modulus"] = scene.joint.effective_modulus;
    all["doubtful"] = answered.doubtful;
    LawColumns of_laws;
    of_laws.put(answered.answer);
    all["of_laws"] = of_laws.take(1);
    return all;
}

/// Every measured face: its name, and the document of fstiff measure.
nb::list measured_of(const Scene& scene) {
    nb::list faces;
    for (const auto& [name, face, file] : scene.measured_files())
        for (const auto& surface : scene.measured)
            if (surface.get() == file)
                faces.append(nb::make_tuple(std::string(name),
                                            found(actions::document_of(surface::MeasureOptions(), surface), surface)));
    return faces;
}

actions::OneContact contact(const Scene& scene, const std::string& law, std::size_t peaks) {
    const nb::gil_scoped_release free;
    std::size_t place = 0;
    Scene of = scene;
    if (!law.empty()) {
        of.laws = scene.offered_laws();
        std::vector<std::string_view> names;
        for (const detail::Law* law : of.laws) names.push_back(law->name);
        while (place < names.size() && names[place] != law) ++place;
        if (place == names.size())
            throw domain_error("law = \"" + law + "\": must be one of the scene's: " + document::list_of(names));
    }
    return actions::make_contact(std::move(of), place, peaks, until_interrupted());
}

actions::MeasuredCurve curve(const std::optional<In>& pressures, const In& values, const std::optional<In>& errors,
                             bool is_reflection, const std::optional<In>& frequencies) {
    const auto list = [](const std::optional<In>& numbers) {
        return numbers ? numbers_of(*numbers) : std::span<const double>();
    };
    return actions::curve_of_numbers(list(pressures), numbers_of(values), list(errors), is_reflection, "measured",
                                     list(frequencies));
}

Found identified(const Scene& scene, const nb::dict& options, const std::optional<actions::MeasuredCurve>& curve) {
    const auto how = request_of<actions::IdentifyRequest>(options);
    const nb::gil_scoped_release free;
    return found(document_of(scene, identify_scene(scene, how, curve)));
}

Found ultrasound(const nb::dict& options, const std::optional<actions::MeasuredCurve>& curve) {
    const auto how = request_of<actions::ReflectionRequest>(options);
    const nb::gil_scoped_release free;
    return found(document_of(how, curve));
}

/// The text of the file, warnings, and whether they are ones to doubt the law.
nb::tuple exported(const Scene& scene, const nb::dict& options) {
    auto how = request_of<actions::ExportRequest>(options);
    how.progress = until_interrupted();
    const document::Document document = [&] {
        const nb::gil_scoped_release free;
        return document_of(scene, how);
    }();
    return nb::make_tuple(document.file(), document.warnings, document.doubtful);
}

document::ShownUnit unit_of(const In& values, std::string_view si) {
    std::vector<double> sizes;
    for (const double value : numbers_of(values))
        if (std::isfinite(value)) sizes.push_back(std::abs(value));
    return sizes.empty() ? document::shown_unit(0.0, si) : document::shown_unit(sizes, si);
}

/// How the tables of the command call a column of \p values, with its unit, and the factor from SI.
nb::tuple heading(const std::string& key, const In& values) {
    for (const AnswerQuantity& quantity : answer_quantities())
        if (quantity.key() == key) {
            const document::ShownUnit unit = unit_of(values, quantity.unit);
            return nb::make_tuple(unit.heading(quantity.symbol), unit.factor);
        }
    return nb::make_tuple(key, 1.);
}

}  // namespace

void add_scenes(nb::module_& m) {
    nb::class_<Scene>(m, "Scene", "A scene; see fstiff.Scene.")
        .def_static("of_text", &scene_of_text, nb::arg("text"), nb::arg("name"), nb::arg("surface"),
                    nb::arg("measured").none())
        .def_static("of_file", &scene_of_file, nb::arg("file"), nb::arg("surface"), nb::arg("measured").none())
        .def("run", &run)
        .def("finer", [](const Scene& scene) { return actions::with_finer_points(scene); })
        .def("measured", &measured_of)
        .def("contact", &contact, nb::arg("law"), nb::arg("peaks"))
        .def_prop_ro("name", [](const Scene& scene) { return scene.name; })
        .def_prop_ro("laws",
                     [](const Scene& scene) {
                         std::vector<std::string> names;
                         for (const detail::Law* law : scene.laws) names.emplace_back(law->name);
                         return names;
                     })
        .def_prop_ro("at_separations", [](const Scene& scene) { return scene.at_separations; })
        .def_prop_ro(
            "points", [](const Scene& scene) { return NewArray(scene.points).take(); }, nb::rv_policy::automatic);
    nb::class_<actions::MeasuredCurve>(m, "Curve", "A measured curve of stiffnesses or reflections.");
    m.def("curve", &curve, nb::arg("pressures").none(), nb::arg("values"), nb::arg("errors").none(),
          nb::arg("is_reflection"), nb::arg("frequencies").none());
    m.def("identify", &identified, nb::arg("scene"), nb::arg("options"), nb::arg("curve").none());
    m.def("ultrasound", &ultrasound, nb::arg("options"), nb::arg("curve").none());
    m.def("export", &exported, nb::arg("scene"), nb::arg("options"));
    nb::list quantities;
    for (const AnswerQuantity& each : answer_quantities())
        quantities.append(nb::make_tuple(std::string(each.word), each.key(), std::string(each.title)));
    m.attr("quantities") = quantities;
    m.def("heading", &heading, nb::arg("key"), nb::arg("values"));
    m.def(
        "shown_unit",
        [](const In& values, const std::string& si) {
            const document::ShownUnit unit = unit_of(values, si);
            return nb::make_tuple(std::string(unit.name), unit.factor);
        },
        nb::arg("values"), nb::arg("si"));
    m.def(
        "with_unit",
        [](double value, const std::string& si, int digits, double error) {
            return document::with_unit(value, si, digits, error);
        },
        nb::arg("value"), nb::arg("si"), nb::arg("digits"), nb::arg("error"));
    m.attr("builtin_scene") = std::string(scene::builtin_scene);
}

}  // namespace fstiff::python
