// SPDX-License-Identifier: BSD-3-Clause
// fstiff help materials, processes and units: what a scene may name, from the tables of the library.
#include "commands/commands.hpp"
#include "document/rows.hpp"

#include <fstiff/asperity/named_materials.hpp>
#include <fstiff/io/units.hpp>
#include <fstiff/surface/process_prior.hpp>

#include <algorithm>
#include <string>

namespace fstiff::cli {
namespace {

using document::Cell;

/// "  label: text" in lines of at most 110 characters.
std::string entry(std::string_view label, std::string_view text) {
    std::string lines;
    for (const std::string& line : document::wrapped(text, 106 - document::shown_width(label)))
        lines += lines.empty() ? "  " + std::string(label) + ": " + line + "\n" : "      " + line + "\n";
    return lines;
}

/// A number that is 0 where it is not known.
Cell known(double value) { return value > 0 ? Cell(value) : Cell(); }

std::string materials() {
    const auto& all = detail::named_materials;
    document::Rows rows;
    rows.add({"", "name"}, all, &NamedMaterial::name);
    rows.add({"", "E [GPa]", 1e-9, 4}, all, [](const NamedMaterial& m) { return m.elastic.youngs_modulus; });
    rows.add({"", "nu", 1, 3}, all, [](const NamedMaterial& m) { return m.elastic.poisson_ratio; });
    rows.add({"", "H [GPa]", 1e-9, 3}, all, [](const NamedMaterial& m) { return m.hardness().middle; });
    rows.add({"", "from", 1e-9, 3}, all, [](const NamedMaterial& m) { return m.hardness().low; });
    rows.add({"", "to", 1e-9, 3}, all, [](const NamedMaterial& m) { return m.hardness().high; });
    rows.add({"", "k [W/(m K)]", 1, 3}, all, [](const NamedMaterial& m) { return known(m.thermal_conductivity); });
    rows.add({"", "el. [MS/m]", 1e-6, 3}, all, [](const NamedMaterial& m) { return known(m.electrical_conductivity); });
    rows.add({"", "c [m/s]", 1, 4}, all, [](const NamedMaterial& m) { return known(m.wave_speeds().first); });
    rows.add({"", "z [MRayl]", 1e-6, 3}, all,
             [](const NamedMaterial& m) { return known(m.density * m.wave_speeds().first); });
    std::string text =
        "Materials by name, for [material] of a scene and --material of fstiff ultrasound. Keys of a section\n"
        "[material.upper] with name = \"C45\" replace single numbers.\n" +
        rows.text() +
        "E, nu: elastic constants; H: hardness of a machined face with its 90 % range; k and el.: conductivity of "
        "heat\n"
        "and current; c, z: speed and impedance of longitudinal waves, by E, nu and density where none was "
        "measured.\n\n"
        "Sources of E and nu, of the speeds, of the conductivities, of the hardness; other names:\n";
    for (const NamedMaterial& material : all) {
        std::string line(material.source), names;
        for (const char c : material.other_names.substr(std::min<std::size_t>(1, material.other_names.size())))
            names += c == ' ' ? std::string(", ") : std::string(1, c);
        if (names.size() > 2) line += "; also " + names.substr(0, names.size() - 2);
        text += entry(material.name, line);
    }
    return text +
           "[K] Kaye, Laby 1995; [C] CRC Handbook 2016; [S] Selfridge 1985; [B] Boston Piezo-Optics 2010; [D] "
           "inaparts.com;\n"
           "[f] 5, 50 and 95 % over the states of a family; [s] data sheet of a supplier; [m] MatWeb; [d] of the "
           "tensile\n"
           "strength; [r] remembered. A row without them has those of its family.\n";
}

std::string processes() {
    const auto& all = detail::process_priors;
    const auto range = [](const PriorRange& prior) {
        return document::rounded(prior.middle, 3) + " (" + document::rounded(prior.low, 3) + " to " +
               document::rounded(prior.high, 3) + ")";
    };
    document::Rows rows;
    rows.add({"", "process"}, all, [](const detail::ProcessPrior& p) { return Cell(name_of(p.process)); });
    rows.add({"", "lay"}, all, [](const detail::ProcessPrior& p) { return Cell(p.has_lay ? "yes" : "no"); });
    rows.add({"", "Ra/Rq"}, all, [&](const auto& p) { return Cell(range(p.mean_over_rms)); });
    rows.add({"", "rms gradient at 1 µm"}, all, [&](const auto& p) { return Cell(range(p.slope)); });
    rows.add({"", "alpha"}, all, [&](const auto& p) { return Cell(range(p.alpha)); });
    rows.add({"", "skewness"}, all, [&](const auto& p) { return Cell(range(p.skewness)); });
    std::string text =
        "Processes of a surface: what a drawing leaves open, with the range of nine in ten surfaces. Give what was\n"
        "measured: it replaces the range.\n" +
        rows.text() + "The gradient grows with the root of the rms height.\n\nOther words for them:\n";
    for (const detail::ProcessWords& row : detail::process_words) {
        std::string words;
        for (const char c : row.words) words += c == ',' ? std::string(", ") : std::string(1, c);
        text += entry(name_of(row.process), words);
    }
    return text;
}

std::string units() {
    std::string text = "Units, after a number and in quotation marks, such as \"0.5 um\" or \"0.5 µm\":";
    for (const auto& [dimension, name] : enum_names<io::Dimension>)
        text += "\n  " + std::string(name) + std::string(25 - name.size(), ' ') + io::accepted_units(dimension);
    return text + "\n";
}

constexpr HelpTopic topics[] = {
    {"materials", materials, false}, {"processes", processes, false}, {"units", units, true}};

}  // namespace

std::span<const HelpTopic> help_topics() { return topics; }

}  // namespace fstiff::cli
