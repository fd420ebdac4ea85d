// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/grid.hpp"

#include "document/file.hpp"
#include "sweep/template.hpp"

#include <fstiff/core/version.hpp>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

namespace fstiff::sweep {
namespace {

using io::Dimension;
using scene::Section;
using scene::Source;

constexpr std::uint64_t most_scenes = std::uint64_t(1) << 53;  // whole numbers that JSON readers keep
constexpr std::array<std::string_view, 3> kinds{"normal", "lognormal", "uniform"};

/// What a count must be; 1e18 is none of TOML's whole numbers.
std::string whole_number_from(std::uint64_t least) {
    return "must be a whole number from " + std::to_string(least) + " to " + std::to_string(most_scenes) +
           ", written without a point and an exponent";
}

/// A swept quantity as it was found, with its place for the order of the axes.
struct Found {
    Axis axis;
    std::vector<Step> path;
    toml::array listed;
    toml::source_position begin;
};

/// A number of the grid: with a unit, or plain.
struct NumberWithUnit {
    double value;
    std::optional<Dimension> dimension;
    bool whole = false;
};

std::string path_text(const std::vector<Step>& path) {
    std::string text;
    for (const Step& step : path) {
        if (const auto* key = std::get_if<std::string>(&step)) {
            if (!text.empty()) text += '.';
            text += *key;
        } else {
            text += '[';
            text += std::to_string(std::get<std::size_t>(step));
            text += ']';
        }
    }
    return text;
}

/// Whether the value is a file or a word, which is not looked at for a number.
bool names_text(const std::vector<Step>& path) {
    const auto* key = std::get_if<std::string>(&path.back());
    return key && (*key == "from" || *key == "mask" || *key == "name");
}

/// What \p node says as a number, with a unit of any kind; none for other texts, lists, tables.
std::optional<NumberWithUnit> quantity_of(const toml::node& node) {
    if (node.is_number()) return NumberWithUnit{*node.value<double>(), {}, node.is_integer()};
    if (!node.is_string()) return std::nullopt;
    const std::string text = scene::written(node);
    for (const auto& [dimension, name] : names<Dimension>) {
        try {
            return NumberWithUnit{io::parse_quantity(text, dimension, ""), dimension};
        } catch (const domain_error&) {
        }
    }
    return std::nullopt;
}

/// Two quantities of one kind, such as the ends of a range.
std::pair<NumberWithUnit, NumberWithUnit> two_quantities(const Source& source, const toml::node& first, const toml::node& second,
                                             const std::string& first_key, const std::string& second_key) {
    const auto one = [&](const toml::node& node, const std::string& key) {
        const auto found = quantity_of(node);
        if (!found || !std::isfinite(found->value))
            source.refuse(node, key, "must be a finite number, or a text of a number and its unit such as \"0.8 um\"");
        return *found;
    };
    const auto a = one(first, first_key), b = one(second, second_key);
    if (a.dimension != b.dimension)
        source.refuse(second, second_key, "must be a quantity of the same kind as " + first_key);
    return {a, b};
}

std::string unit_of(const std::optional<Dimension>& dimension) {
    return dimension ? std::string(scene::si_unit(*dimension)) : "";
}

/// { from, to, count, spacing }
void read_range(Source& source, const toml::table& table, Found& found) {
    const std::string& key = found.axis.key;
    const Section section(source, table, key, {"from", "to", "count", "spacing"});
    const auto [from, to] =
        two_quantities(source, section.at("from"), section.at("to"), section.key("from"), section.key("to"));
    const toml::node& node = section.at("count");
    const auto* count = node.as_integer();
    if (!count || count->get() < 2 || static_cast<std::uint64_t>(count->get()) > most_scenes)
        source.refuse(node, section.key("count"), whole_number_from(2));
    constexpr std::array<std::string_view, 2> spacings{"log", "linear"};
    const bool log = section.find("spacing")
                         ? source.choice(*section.find("spacing"), section.key("spacing"), spacings) == 0
                         : key.starts_with("contact.pressures");
    if (!(from.value < to.value))
        source.refuse(section.at("to"), section.key("to"), "must be greater than " + section.key("from"));
    if (log && !(from.value > 0))
        source.refuse(section.at("from"), section.key("from"), "must be greater than 0 for spacing = \"log\"");
    found.axis.range = scene::Range{from.value, to.value, static_cast<std::uint64_t>(count->get()), log};
    found.axis.whole = from.whole && to.whole;
    found.axis.unit = unit_of(from.dimension);
}

/// { normal = [a, b] } and its like.
void read_distribution(Source& source, const toml::table& table, std::size_t kind, Found& found) {
    const Section section(source, table, found.axis.key, kinds);
    const std::string key = section.key(kinds[kind]);
    const toml::node& node = section.at(kinds[kind]);
    const auto* pair = node.as_array();
    const bool log = kind == 1;
    const std::string wanted =
        log         ? "must be a list of the median and the standard deviation of the logarithm, such as "
                      "[\"40 um\", 0.1], or of the mean and the standard deviation, such as [\"40 um\", \"4 um\"]"
        : kind == 0 ? "must be a list of the mean and the standard deviation, such as [\"5 um\", \"0.2 um\"]"
                    : "must be a list of the least and the greatest value, such as [\"4 um\", \"6 um\"]";
    if (table.size() != 1 || !pair || pair->size() != 2) source.refuse(node, key, wanted);
    const toml::node &first = (*pair)[0], &second = (*pair)[1];
    Distribution& drawn = found.axis.drawn.emplace();
    drawn.kind = static_cast<Distribution::Kind>(kind);
    if (log) {
        const auto middle = quantity_of(first), spread = quantity_of(second);
        if (!middle || !spread || !(middle->value > 0) || !(spread->value > 0)) source.refuse(node, key, wanted);
        drawn.a = middle->value, drawn.b = spread->value;
        if (!second.is_number()) {  // a mean and a standard deviation of the quantity itself
            if (spread->dimension != middle->dimension) source.refuse(node, key, wanted);
            const double relative = spread->value / middle->value;
            drawn.a = middle->value / std::sqrt(1 + relative * relative);
            drawn.b = std::sqrt(std::log1p(relative * relative));
        }
        found.axis.unit = unit_of(middle->dimension);
        return;
    }
    const auto [a, b] = two_quantities(source, first, second, key + "[0]", key + "[1]");
    drawn.a = a.value, drawn.b = b.value;
    found.axis.unit = unit_of(a.dimension);
    if (kind == 0 && !(b.value > 0)) source.refuse(second, key + "[1]", "must be greater than 0");
    if (kind == 2 && !(a.value < b.value)) source.refuse(second, key + "[1]", "must be greater than " + key + "[0]");
}

/// How a result shows a listed value that is no number.
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
    return scene::written(node);
}

void read_list(const Source& source, const toml::node& node, const std::string& key, Found& found) {
    const auto* list = node.as_array();
    if (!list || list->empty()) source.refuse(node, key, "must be a list of one value at least");
    found.listed = *list;
    std::optional<NumberWithUnit> first;
    if (!names_text(found.path)) first = quantity_of((*list)[0]);
    for (std::size_t i = 0; i < list->size(); ++i) {
        const toml::node& item = (*list)[i];
        if (!first) {
            found.axis.texts.push_back(shown(item));
            continue;
        }
        const auto one = quantity_of(item);
        if (!one || one->dimension != first->dimension)
            source.refuse(item, key + "[" + std::to_string(i) + "]",
                          "must be of the same kind as the first of the list");
        found.axis.numbers.push_back(one->value);
    }
    if (first) found.axis.unit = unit_of(first->dimension);
}

/// { from, to, count, spacing }; from alone is the file of a surface.
bool is_range(const toml::table& table) {
    return table.contains("count") || (table.contains("from") && table.contains("to"));
}

/// Finds what is swept in a scene.
class Finder {
public:
    explicit Finder(Source& source) : source_(source) {}

    void walk(const toml::node& node, const std::vector<Step>& path) {
        if (const auto* list = node.as_array()) {
            if (!takes_list(path))
                return found(node, path, [&](Found& one) { read_list(source_, node, one.axis.key, one); });
            for (std::size_t i = 0; i < list->size(); ++i) walk((*list)[i], joined(path, i));
            return;
        }
        const auto* table = node.as_table();
        if (!table) return;
        for (std::size_t kind = 0; kind < kinds.size(); ++kind)
            if (table->contains(kinds[kind]))
                return found(node, path, [&](Found& one) { read_distribution(source_, *table, kind, one); });
        if (table->contains("values")) {
            return found(node, path, [&](Found& one) {
                const Section section(source_, *table, one.axis.key, {"values"});
                read_list(source_, section.at("values"), section.key("values"), one);
            });
        }
        if (is_range(*table) && !takes_list(path))
            return found(node, path, [&](Found& one) { read_range(source_, *table, one); });
        for (const auto& [key, child] : *table) walk(child, joined(path, std::string(key.str())));
    }

    std::vector<Found> all;

private:
    static std::vector<Step> joined(std::vector<Step> path, Step step) {
        path.push_back(std::move(step));
        return path;
    }
    /// Whether the scene has a list here, so that one means many values of one scene.
    static bool takes_list(const std::vector<Step>& path) {
        static const std::set<std::string> lists{"surface.from",      "surface.upper.from",  "surface.lower.from",
                                                 "contact.pressures", "contact.separations", "contact.laws",
                                                 "contact.peaks",     "output.quantities"};
        return lists.contains(path_text(path));
    }
    template <class Read>
    void found(const toml::node& node, const std::vector<Step>& path, const Read& read) {
        if (path.size() < 2)
            source_.refuse(node, path_text(path), "cannot be swept; sweep the keys of a section of the scene");
        Found& one = all.emplace_back();
        one.path = path;
        one.axis.key = path_text(path);
        one.begin = node.source().begin;
        read(one);
    }

    Source& source_;
};

/// The node that \p path leads to.
toml::node& at(toml::table& root, const std::vector<Step>& path, std::size_t steps) {
    toml::node* node = &root;
    for (std::size_t i = 0; i < steps; ++i)
        if (const auto* key = std::get_if<std::string>(&path[i]))
            node = node->as_table()->get(*key);
        else
            node = node->as_array()->get(std::get<std::size_t>(path[i]));
    return *node;
}

/// Puts \p value where \p path leads.
template <class Node>
void put(toml::table& root, const std::vector<Step>& path, Node&& value) {
    toml::node& parent = at(root, path, path.size() - 1);
    if (const auto* key = std::get_if<std::string>(&path.back()))
        parent.as_table()->insert_or_assign(*key, std::forward<Node>(value));
    else
        parent.as_array()->replace(
            parent.as_array()->cbegin() + static_cast<std::ptrdiff_t>(std::get<std::size_t>(path.back())),
            std::forward<Node>(value));
}

/// [sweep]
void read_sweep(Source& source, const toml::table* table, Grid& grid) {
    static const toml::table none;
    const Section section(source, table ? *table : none, "sweep", {"mode", "samples", "seed", "tabulate"});
    const auto whole = [&](std::string_view name, std::uint64_t least, std::uint64_t otherwise) {
        const toml::node* node = section.find(name);
        if (!node) return otherwise;
        const auto* number = node->as_integer();
        if (!number || number->get() < static_cast<std::int64_t>(least) ||
            static_cast<std::uint64_t>(number->get()) > most_scenes)
            source.refuse(*node, section.key(name), whole_number_from(least));
        return static_cast<std::uint64_t>(number->get());
    };
    if (const toml::node* node = section.find("mode")) grid.mode = source.choice<Mode>(*node, section.key("mode"));
    bool draws = false;
    for (const Axis& axis : grid.axes) draws = draws || axis.drawn;
    if (section.find("samples") && !draws)
        source.refuse(*section.find("samples"), section.key("samples"),
                      "must stand beside a distribution, such as { normal = [\"5 um\", \"0.2 um\"] }");
    grid.samples = whole("samples", 1, draws ? 1000 : 1);
    grid.seed = whole("seed", 0, grid.seed);
    if (const toml::node* node = section.find("tabulate")) {
        if (!node->is_boolean()) source.refuse(*node, section.key("tabulate"), "must be true or false");
        grid.tabulate = node->as_boolean()->get();
    }
}

/// Scenes of the grid. \throws domain_error for too many, and for axes of unlike length in zip mode.
std::uint64_t count_scenes(const Source& source, const std::vector<Found>& found, const Grid& grid) {
    std::uint64_t size = 1, zipped = 0;
    const std::string* first = nullptr;
    const auto times = [&](std::uint64_t count) {
        if (size > most_scenes / count)
            throw domain_error(source.file + ": has more than 2^53 scenes; must have fewer");
        size *= count;
    };
    for (const Found& one : found) {
        const Axis& axis = one.axis;
        if (axis.drawn) continue;
        if (grid.mode == Mode::product) {
            times(axis.count());
        } else if (!first) {
            first = &axis.key;
            zipped = axis.count();
            times(zipped);
        } else if (axis.count() != zipped) {
            throw domain_error(source.file + ":" + std::to_string(one.begin.line) + ": " + axis.key + ": has " +
                               std::to_string(axis.count()) + " values; mode = \"zip\" must have as many as of " +
                               *first + ", " + std::to_string(zipped));
        }
    }
    times(grid.samples);
    return size;
}

/// Appends the sha256 of \p file to \p text, and of the files of a folder.
void add_hash(std::string& text, const std::filesystem::path& file) {
    const auto hash = [](const auto& one) { return scene::sha256(scene::read_all(one.string())) + "\n"; };
    if (!std::filesystem::is_directory(file)) return void(text += hash(file));
    std::set<std::filesystem::path> inside;
    for (const auto& entry : std::filesystem::directory_iterator(file))
        if (entry.is_regular_file()) inside.insert(entry.path());
    for (const auto& one : inside)
        text += one.filename().string() + " " + hash(one);
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
        const std::filesystem::path file = scene::written(node), beside(source.file);
        if (file == "-")
            throw domain_error(source.at(node) + ": is standard input, which only one scene can read; must be a file");
        files.push_back((beside.parent_path() / file).string());
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
        if (axis.range)
            value.number = axis.range->at(value.place);
        else if (!axis.numbers.empty())
            value.number = axis.numbers[value.place];
    }
}

toml::table table_of(const Grid& grid, const std::vector<Value>& values) {
    toml::table root = grid.form->root;
    for (std::size_t i = 0; i < grid.axes.size(); ++i) {
        const Axis& axis = grid.axes[i];
        const auto& path = grid.form->paths[i];
        const double number = values[i].number;
        if (!grid.form->listed[i].empty())
            grid.form->listed[i][values[i].place].visit([&](const auto& node) { put(root, path, node); });
        else if (!axis.unit.empty())
            put(root, path, scene::shortest(number) + " " + axis.unit);
        else if (axis.whole && number == std::round(number))
            put(root, path, static_cast<std::int64_t>(number));
        else
            put(root, path, number);
    }
    return root;
}

Grid read_grid(const std::string& text, const std::string& file) {
    Source source{file, {}};
    toml::table root = scene::parse_toml(text, file);
    Finder finder(source);
    const toml::node* sweep = root.get("sweep");
    if (sweep && !sweep->is_table()) source.refuse(*sweep, "sweep", "must be a section of keys");
    for (const auto& [key, node] : root)
        if (key.str() != "sweep") finder.walk(node, {std::string(key.str())});
    std::sort(finder.all.begin(), finder.all.end(), [](const Found& a, const Found& b) { return a.begin < b.begin; });

    Grid grid;
    grid.file = file;
    auto form = std::make_shared<Template>();
    std::uint32_t input = 0;
    for (Found& one : finder.all) {
        if (one.axis.drawn) one.axis.input = input++;
        grid.axes.push_back(one.axis);
        form->paths.push_back(std::move(one.path));
        form->listed.push_back(std::move(one.listed));
    }
    read_sweep(source, sweep ? sweep->as_table() : nullptr, grid);
    grid.size = count_scenes(source, finder.all, grid);
    std::string hashed = "fstiff sweep " FSTIFF_VERSION "\n" + scene::sha256(text) + "\n";
    if (const toml::node* surface = root.get("surface")) add_files(source, *surface, false, grid.files);
    for (const std::string& named : grid.files) add_hash(hashed, named);
    grid.hash = scene::sha256(hashed);
    root.erase("sweep");
    form->root = std::move(root);
    grid.form = std::move(form);
    return grid;
}

}  // namespace fstiff::sweep
