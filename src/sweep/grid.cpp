// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/grid.hpp"

#include "document/file.hpp"
#include "scene/readers.hpp"
#include "sweep/template.hpp"

#include <fstiff/io/quantities.hpp>

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <set>

namespace fstiff::sweep {
namespace {

using io::Dimension;
using request::Field;
using request::Section;
using request::Source;

constexpr std::uint64_t most_scenes = std::uint64_t(1) << 53;  // whole numbers that JSON readers keep
constexpr std::array<std::string_view, 3> kinds{"normal", "lognormal", "uniform"};

/// A swept quantity as it was found, with its place for the order of the axes.
struct Swept {
    Axis axis;
    toml::array listed;
    toml::source_position begin;
    std::optional<Dimension> dimension;  ///< of its numbers, where they are those of a joint or of its load
    bool loads = false;                  ///< they are pressures or forces
};

/// A number of the grid: with a unit, or plain.
struct NumberWithUnit {
    double value;
    std::optional<Dimension> dimension;
    bool whole = false;
};

/// Whether the value is a file or a word, which is not looked at for a number.
bool names_text(const std::string& key) {
    return key.ends_with(".from") || key.ends_with(".mask") || key.ends_with(".name");
}

/// A number of a joint or of its load, or a list of points.
struct Known {
    NumberFacts facts;
    bool is_list = false;
};

/// That of the key \p key of a scene, such as "surface.rms_height" or "contact.pressures"; null of others.
const Known* known_at(const std::string& key) {
    static const auto numbers = [] {
        std::map<std::string, Known> all;
        std::string section;
        bool is_list = false;
        const auto take = [&](std::string_view name, const auto&, const NumberFacts& facts) {
            std::vector<std::string_view> names;
            scene::add_keys(name, facts, names);
            for (const auto each : names) all.emplace(section + "." + std::string(each), Known{facts, is_list});
        };
        const auto add = [&](const char* to, const auto& owner) { section = to, each_field(owner, take); };
        for (const char* surface : {"surface", "surface.upper", "surface.lower"}) add(surface, JointFace());
        for (const char* body : {"material.upper", "material.lower"}) add(body, Body());
        add("friction", Friction()), add("ultrasound", UltrasonicWaves());
        add("gap", GapFilling<double>()), add("gap", Conduction());
        const detail::Load load;
        add("contact", Joint()), add("contact", load);
        is_list = true, detail::each_points(load, take);
        return all;
    }();
    const auto entry = numbers.find(key);
    return entry == numbers.end() ? nullptr : &entry->second;
}

/// \p node of \p swept as a number, with its unit or, where its dimension is not known, one of any kind; none for other
/// texts, lists, tables.
std::optional<NumberWithUnit> quantity_of(const Source& source, const toml::node& node, const std::string& key,
                                          const Swept& swept) {
    if (node.is_number()) {
        double value = 0;
        const auto number = request::value_of(node);
        source.located(node, [&] { request::put(number, value, key, {}); });
        return NumberWithUnit{value, {}, node.is_integer()};
    }
    if (!node.is_string()) return std::nullopt;
    const std::string text = request::written(node);
    for (const auto& [dimension, name] : enum_names<Dimension>) {
        if (swept.dimension && dimension != *swept.dimension) continue;
        try {
            return NumberWithUnit{io::parse_quantity(text, dimension, ""), dimension};
        } catch (const domain_error&) {
        }
    }
    return std::nullopt;
}

/// Two quantities of one kind, such as the ends of a range.
std::pair<NumberWithUnit, NumberWithUnit> two_quantities(const Source& source, const Swept& swept,
                                                         const toml::node& first, const toml::node& second,
                                                         const std::string& first_key, const std::string& second_key) {
    const auto finite = [&](const toml::node& node, const std::string& key) {
        const auto number = quantity_of(source, node, key, swept);
        if (!number && swept.dimension && node.is_string())
            source.located(node, [&] { return io::parse_quantity(request::written(node), *swept.dimension, key); });
        if (!number || !std::isfinite(number->value))
            source.refuse(node, key, "must be a finite number, or a text of a number and its unit such as \"0.8 um\"");
        return *number;
    };
    const auto a = finite(first, first_key), b = finite(second, second_key);
    if (a.dimension != b.dimension)
        source.refuse(second, second_key, "must be a quantity of the same kind as " + first_key);
    return {a, b};
}

std::string unit_of(const std::optional<Dimension>& dimension) {
    return dimension ? std::string(request::si_unit(*dimension)) : "";
}

/// { from, to, count, spacing }
void read_range(Source& source, const toml::table& table, Swept& swept) {
    const Section section(source, &table, swept.axis.key, scene::range_keys);
    const auto [from, to] =
        two_quantities(source, swept, section.at("from"), section.at("to"), section.key("from"), section.key("to"));
    swept.axis.range = scene::read_range(source, section, from.value, to.value, swept.loads, most_scenes);
    swept.axis.whole = from.whole && to.whole;
    swept.axis.unit = unit_of(from.dimension);
}

/// { normal = [a, b] } and its like.
void read_distribution(Source& source, const toml::table& table, std::size_t kind, Swept& swept) {
    const Section section(source, &table, swept.axis.key, kinds);
    const std::string key = section.key(kinds[kind]);
    const toml::node& node = section.at(kinds[kind]);
    const auto* pair = node.as_array();
    const bool log = kind == 1;
    const std::string allowed =
        log         ? "must be a list of the median and the standard deviation of the logarithm, such as "
                      "[\"40 um\", 0.1], or of the mean and the standard deviation, such as [\"40 um\", \"4 um\"]"
        : kind == 0 ? "must be a list of the mean and the standard deviation, such as [\"5 um\", \"0.2 um\"]"
                    : "must be a list of the lowest and the highest value, such as [\"4 um\", \"6 um\"]";
    if (table.size() != 1 || !pair || pair->size() != 2) source.refuse(node, key, allowed);
    const toml::node &first = (*pair)[0], &second = (*pair)[1];
    Distribution& drawn = swept.axis.drawn.emplace();
    drawn.kind = static_cast<Distribution::Kind>(kind);
    if (log) {
        const auto middle = quantity_of(source, first, key, swept), spread = quantity_of(source, second, key, swept);
        if (!middle || !spread || !(middle->value > 0) || !(spread->value > 0)) source.refuse(node, key, allowed);
        drawn.a = middle->value, drawn.b = spread->value;
        if (!second.is_number()) {  // a mean and a standard deviation of the quantity itself
            if (spread->dimension != middle->dimension) source.refuse(node, key, allowed);
            const double relative = spread->value / middle->value;
            drawn.a = middle->value / std::sqrt(1 + relative * relative);
            drawn.b = std::sqrt(std::log1p(relative * relative));
        }
        swept.axis.unit = unit_of(middle->dimension);
        return;
    }
    const auto [a, b] = two_quantities(source, swept, first, second, key + "[0]", key + "[1]");
    drawn.a = a.value, drawn.b = b.value;
    swept.axis.unit = unit_of(a.dimension);
    if (kind == 0 && !(b.value > 0)) source.refuse(second, key + "[1]", "must be greater than 0");
    if (kind == 2 && !(a.value < b.value)) source.refuse(second, key + "[1]", "must be greater than " + key + "[0]");
}

/// How a result shows a listed value that is not a number.
std::string shown(const toml::node& node) {
    if (const auto* list = node.as_array()) {
        std::string text;
        for (const toml::node& item : *list) text += (text.empty() ? "" : ", ") + shown(item);
        return "[" + text + "]";
    }
    if (const auto* table = node.as_table()) {
        std::string text;
        for (const auto& [key, item] : *table)
            text += (text.empty() ? "" : ", ") + std::string(key.str()) + " = " + shown(item);
        return "{" + text + "}";
    }
    return request::written(node);
}

void read_list(const Source& source, const toml::node& node, const std::string& key, Swept& swept) {
    const auto* list = node.as_array();
    if (!list || list->empty()) source.refuse(node, key, "must be a list of at least one value");
    swept.listed = *list;
    std::optional<NumberWithUnit> first;
    if (!names_text(swept.axis.key)) first = quantity_of(source, (*list)[0], key + "[0]", swept);
    for (std::size_t i = 0; i < list->size(); ++i) {
        const toml::node& item = (*list)[i];
        if (!first) {
            swept.axis.texts.push_back(shown(item));
            continue;
        }
        const std::string item_key = key + "[" + std::to_string(i) + "]";
        const auto number = quantity_of(source, item, item_key, swept);
        if (!number || number->dimension != first->dimension)
            source.refuse(item, item_key, "must be of the same kind as the first of the list");
        swept.axis.numbers.push_back(number->value);
    }
    if (first) swept.axis.unit = unit_of(first->dimension);
}

/// { from, to, count, spacing }; from alone is the file of a surface.
bool is_range(const toml::table& table) {
    return table.contains("count") || (table.contains("from") && table.contains("to"));
}

/// Finds what is swept in a scene.
class Finder {
public:
    Finder(Source& source, const toml::table& root) : source_(source), root_(root) {}

    void walk(const toml::node& node, const std::string& key) {
        if (const auto* list = node.as_array()) {
            if (!takes_list(key)) return add(node, key, [&](Swept& axis) { read_list(source_, node, key, axis); });
            for (std::size_t i = 0; i < list->size(); ++i) walk((*list)[i], key + "[" + std::to_string(i) + "]");
            return;
        }
        const auto* table = node.as_table();
        if (!table) return;
        for (std::size_t kind = 0; kind < kinds.size(); ++kind)
            if (table->contains(kinds[kind]))
                return add(node, key, [&](Swept& axis) { read_distribution(source_, *table, kind, axis); });
        if (table->contains("values")) {
            return add(node, key, [&](Swept& axis) {
                const Section section(source_, table, key, {"values"});
                read_list(source_, section.at("values"), section.key("values"), axis);
            });
        }
        if (is_range(*table) && !takes_list(key))
            return add(node, key, [&](Swept& axis) { read_range(source_, *table, axis); });
        for (const auto& [name, child] : *table) walk(child, key + "." + std::string(name.str()));
    }

    std::vector<Swept> axes;

private:
    /// Whether the scene has a list here, so that one means many values of one scene.
    static bool takes_list(const std::string& key) {
        static const std::set<std::string> lists{"surface.from", "surface.upper.from", "surface.lower.from",
                                                 "contact.laws", "contact.peaks",      "output.quantities"};
        const Known* known = known_at(key);
        return lists.contains(key) || (known && known->is_list);
    }
    template <class Read>
    void add(const toml::node& node, const std::string& key, const Read& read) {
        if (key.find('.') == std::string::npos || toml::at_path(root_, key).node() != &node)
            source_.refuse(node, key, "cannot be swept; sweep the keys of a section of the scene");
        Swept& swept = axes.emplace_back();
        swept.axis.key = key;
        swept.begin = node.source().begin;
        const std::size_t bracket = key.find('[');
        if (const Known* known = known_at(key.substr(0, bracket))) {
            swept.dimension = request::dimension_of(known->facts.unit);
            swept.loads = known->is_list && known->facts.low == 0;
            if (known->is_list && swept.dimension != Dimension::force)  // from which the points follow
                swept.axis.point = bracket == key.npos ? 0 : std::stoul(key.substr(bracket + 1));
        }
        read(swept);
    }

    Source& source_;
    const toml::table& root_;
};

/// [sweep]
void read_sweep(Source& source, const toml::table* table, Grid& grid) {
    bool draws = false;
    for (const Axis& axis : grid.axes) draws = draws || axis.drawn;
    grid.samples = draws ? 1000 : 1;
    const auto fields = [&](auto take) {
        take("mode", grid.mode, Field{});
        take("samples", grid.samples, Field{.low = 1, .high = most_scenes});
        take("seed", grid.seed, Field{});
    };
    const Section section(source, table, "sweep", request::keys_of(fields));
    section.read(fields);
    if (section.find("samples") && !draws)
        section.refuse("samples", "needs a distribution, such as { normal = [\"5 um\", \"0.2 um\"] }");
}

/// Scenes of the grid. \throws domain_error for too many, and for axes of unlike length in zip mode.
std::uint64_t count_scenes(const Source& source, const std::vector<Swept>& swept, const Grid& grid) {
    std::uint64_t size = 1;
    const Axis* first = nullptr;
    const auto times = [&](std::uint64_t count) {
        if (size > most_scenes / count)
            throw domain_error(source.file + ": has more than 2^53 scenes; must have fewer");
        size *= count;
    };
    for (const Swept& entry : swept) {
        const Axis& axis = entry.axis;
        if (axis.drawn) continue;
        if (grid.mode == Mode::product || !first)
            times(axis.count());
        else if (axis.count() != first->count())
            throw domain_error(source.file + ":" + std::to_string(entry.begin.line) + ": " + axis.key + ": has " +
                               std::to_string(axis.count()) + " values; mode = \"zip\" must have as many as of " +
                               first->key + ", " + std::to_string(first->count()));
        if (!first) first = &axis;
    }
    times(grid.samples);
    return size;
}

/// Appends the files that \p node names at the keys from and mask to \p files.
void add_files(const Source& source, const toml::node& node, bool is_file, std::vector<std::string>& files) {
    if (const auto* table = node.as_table()) {
        if (is_range(*table)) return;
        for (const auto& [key, child] : *table)
            add_files(source, child, key.str() == "from" || key.str() == "mask" || (is_file && key.str() == "values"),
                      files);
    } else if (const auto* list = node.as_array()) {
        for (const toml::node& item : *list) add_files(source, item, is_file, files);
    } else if (is_file && node.is_string()) {
        const std::string file = request::written(node);
        if (file == "-")
            throw domain_error(source.at(node) + ": is standard input, which only one scene can read; must be a file");
        files.push_back(document::name_of_path(document::path_of(source.file).parent_path() / document::path_of(file)));
    }
}

}  // namespace

void Grid::values(std::uint64_t index, std::vector<Value>& values) const {
    values.assign(axes.size(), {});
    std::uint64_t rest = index / samples;
    for (std::size_t i = axes.size(); i-- > 0;) {  // the last axis varies fastest
        const Axis& axis = axes[i];
        Value& value = values[i];
        if (axis.drawn) {
            value.number = axis.drawn->quantile(uniform_draw(seed, index, axis.input));
            continue;
        }
        value.place = mode == Mode::zip ? rest : rest % axis.count();
        if (mode == Mode::product) rest /= axis.count();
        value.number = axis.number_at(value.place);
    }
}

void Grid::require(const Rows& rows, const std::string& shown) const {
    if (rows.first >= rows.end || rows.end > size)
        throw document::option_error(shown + ", whole numbers with 0 <= FROM < TO <= " + std::to_string(size) +
                                     ", the scenes of " + file);
}

Grid read_grid(const std::string& text, const std::string& file, const Given& given) {
    Source source{file, {}};
    toml::table root = request::parse_toml(text, file);
    const toml::table added = request::parse_toml(given.text, file);
    for (const auto& [key, node] : added) put_at(root, std::string(key.str()), node, file);
    Finder finder(source, root);
    const toml::node* sweep = root.get("sweep");
    if (sweep && !sweep->is_table()) source.refuse(*sweep, "sweep", "must be a section of keys");
    for (const auto& [key, node] : root)
        if (key.str() != "sweep") finder.walk(node, std::string(key.str()));
    Grid grid;
    for (Swept& entry : finder.axes) {
        const std::string& key = entry.axis.key;
        const toml::node* node = added.get(key);
        if (!node) continue;
        grid.in_si.insert(key);
        entry.begin = node->source().begin;
        entry.begin.line += static_cast<toml::source_index>(text.size());  // after what the scene itself sweeps
        if (const auto numbers = given.numbers.find(key); numbers != given.numbers.end()) {
            entry.axis.numbers.insert(entry.axis.numbers.end(), numbers->second.begin(), numbers->second.end());
            entry.listed.clear();
        }
    }
    std::sort(finder.axes.begin(), finder.axes.end(), [](const Swept& a, const Swept& b) { return a.begin < b.begin; });

    grid.file = file;
    auto form = std::make_shared<Template>();
    std::uint32_t input = 0;
    for (Swept& entry : finder.axes) {
        if (entry.axis.drawn) entry.axis.input = input++;
        grid.axes.push_back(entry.axis);
        form->listed.push_back(std::move(entry.listed));
    }
    read_sweep(source, sweep ? sweep->as_table() : nullptr, grid);
    grid.size = count_scenes(source, finder.axes, grid);
    if (const toml::node* surface = root.get("surface")) add_files(source, *surface, false, grid.files);
    for (const std::string& named : grid.files)
        if (!std::filesystem::exists(document::path_of(named)))
            throw file_error(named, "no such file; the input must be an existing file");
    root.erase("sweep");
    form->root = std::move(root);
    grid.form = std::move(form);
    return grid;
}

}  // namespace fstiff::sweep
