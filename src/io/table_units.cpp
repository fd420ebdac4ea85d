// SPDX-License-Identifier: BSD-3-Clause
#include "io/table_units.hpp"

#include "io/given_lengths.hpp"
#include "io/height_sense.hpp"
#include "io/unit_table.hpp"
#include "io/zygo_xyz.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

std::string line(std::size_t number) { return "line " + std::to_string(number); }

bool is_length(const HeaderEntry* entry) { return entry && is_unit(entry->value, Dimension::length); }

bool is_conversion(const HeaderEntry& entry) { return entry.key.starts_with("height conversion factor"); }

double factor_of(std::string_view unit) { return unit_factor(unit, Dimension::length); }

/// "UNIT,nm": how messages call units of which some are known.
std::string pair_of_units(const std::string& lateral, const std::string& heights) {
    const auto text = [](const std::string& unit) { return unit.empty() ? "UNIT" : printable(unit, 16); };
    return "\"" + text(lateral) + "," + text(heights) + "\"";
}

/// A column whose unit is sought.
struct Column {
    Role role{};
    std::string what;                    // for messages
    std::size_t number{};                // counted from 0
    ColumnTitle title;                   // an empty one of a matrix
    LengthUnit& unit;                    // to be found
    std::string from{};                  // its source
    bool by_title = false;               // it is
    const HeaderEntry* entry = nullptr;  // of the header, which states a unit
};

class UnitFinder {
public:
    UnitFinder(const TextTable& table, const SurfaceOptions& options, const std::string& name, Record& record)
        : table_(table), options_(options), name_(name), record_(record) {}

    Units find() {
        take_options();
        if (table_.form == SurfaceFormat::triples && table_.is_zygo()) return of_zygo();
        if (table_.axes) find_unit_of_axes();
        list_columns();
        for (const Column& column : columns_) check_title(column);
        if (table_.form != SurfaceFormat::matrix) find_units_of_titles();
        refuse_header_of_no_length();
        given_.empty() ? take_stated() : take_given();
        if (text_of_heights_.empty()) scale_heights();
        for (const std::string& source : sources_) units_.from += (units_.from.empty() ? "" : " and ") + source;
        const auto in = [](const LengthUnit& unit) { return " in " + printable(unit.name, 16); };
        if (table_.form == SurfaceFormat::triples)
            units_.text =
                table_.counts_pixels ? "x and y count pixels, " : "x" + in(units_.x) + ", y" + in(units_.y) + ", ";
        units_.text += "heights in " + text_of_heights_;
        if (is_profile_ && columns_.size() > 1) units_.text += ", positions" + in(units_.x);
        return std::move(units_);
    }

private:
    void take_options() {
        given_ =
            is_profile_
                ? given_units(options_.units, 2, name_, "one unit, or two such as \"um,nm\" (positions, heights)")
                : given_units(options_.units, 3, name_, "one unit, or \"um,nm\" (x and y, heights), or \"um,um,nm\"");
        if (given_.size() > 1) units_.lateral = given_.front();
    }

    /// Zygo's x and y are pixels; its heights are in um unless a program was set otherwise.
    Units of_zygo() {
        const double pixel = zygo_pixel(table_.numbers.lines, name_);
        const std::string unit = given_.empty() ? "um" : std::string(given_.back());
        if (given_.empty())
            record_.warnings.push_back(
                "Zygo XYZ states no unit of its heights, which are taken for um; another must be " +
                given_as(options_.names, "units", "\"nm\""));
        return {.heights = {unit, factor_of(unit)},
                .x = {"pixels", pixel},
                .y = {"pixels", pixel},
                .lateral = units_.lateral,
                .text = "x and y in pixels of " + number_text(pixel) + " m, heights in " + printable(unit, 16),
                .from = given_.empty() ? "line 8" : "line 8 and options"};
    }

    /// Numbers of points need none, nor does a matrix whose size is stated.
    void find_unit_of_axes() {
        const MatrixAxes& axes = *table_.axes;
        const std::string stated = axes.stated.size() == 1 ? axes.stated.front() : "";
        if (axes.counted && axes.stated.empty() && units_.lateral.empty()) return;
        const bool is_given = !units_.lateral.empty() || (stated.empty() && !given_.empty());
        const std::string unit = is_given ? std::string(given_.front()) : stated;
        if (!unit.empty()) units_.x = {unit, factor_of(unit)};
        warn_of_unit(stated, units_.x, line(axes.line), "the axes");
        if (unit.empty() && !gives_size(options_) && !stated_grid(table_.entries, "", name_).has_size())
            refuse_line(name_, axes.line,
                        {"holds positions, whose unit is ",
                         axes.stated.empty() ? "not stated" : "stated twice, with two values", "; must be ",
                         given_as(options_.names, "units", asked_units(table_, name_)), " (positions, heights)"});
    }

    void list_columns() {
        const auto add = [&](Role role, const std::string& what, LengthUnit& unit) {
            const auto c = table_.column(role);
            if (!c) return;
            const bool titled = table_.form != SurfaceFormat::matrix;
            columns_.push_back({role, what, *c, titled ? table_.titles[*c] : ColumnTitle(), unit});
        };
        add(Role::heights, "the heights", units_.heights);
        if (table_.counts_pixels || (is_profile_ && options_.spacing)) return;
        add(Role::x, is_profile_ ? "the positions" : "x", units_.x);
        add(Role::y, "y", units_.y);
    }

    /// Refuses a title with a unit of no length, or with a factor where no unit is given; else warns of it.
    void check_title(const Column& column) {
        const ColumnTitle& title = column.title;
        if (!title.no_length.empty())
            refuse_file(name_, {"has a column ", column.number + 1, " in ", shown_cell(title.no_length),
                                ", which is of no length; must be a column in a unit of length"});
        const bool factor = has_factor(title.text, column.role == Role::heights);
        if (factor && given_.empty())
            refuse_line(
                name_, title.line,
                {"states ", shown_cell(title.text), " for ", column.what,
                 ", which is not understood: its factor may be in the numbers; must be ",
                 given_as(options_.names, "units", "\"UNIT\""), ", in which the numbers are, such as \"10 nm\""});
        if (factor)
            warn(line(title.line) + ", which states " + printable(title.text, 40));
        else if (!given_.empty() && title.unread.starts_with('['))
            warn(line(title.line) + ", which states " + std::string(title.unread));
    }

    /// Where columns have titles, the unit of the header may be about another one.
    void refuse_header_of_no_length() const {
        const auto& entries = table_.entries;
        const bool is_converted = may_be_converted() && (std::any_of(entries.begin(), entries.end(), is_conversion) ||
                                                         (given_.empty() && find_entry(entries, "bit2nm")));
        if (!is_converted && !(is_profile_ && is_titled(table_.titles))) refuse_no_length(entries, name_);
    }

    /// Whether the header may state what the numbers are to be multiplied by: of maps without titles.
    bool may_be_converted() const {
        return !is_profile_ && columns_.size() == 1 && columns_.front().title.unit.empty();
    }

    /// Finds the units of titles in one line for all columns that need one; else each column's own.
    void find_units_of_titles() {
        FreeColumns free(table_.numbers.columns, table_.numbers.dialect.separator != ' ');
        for (const Role role : {Role::index, Role::words, Role::unused})
            for (const std::size_t c : table_.columns(role)) free[c] = true;
        for (const Column& column : columns_) free[column.number] = false;
        if (std::count(free.begin(), free.end(), true) == 0) free.clear();
        const TitleUnits above = title_units(table_.numbers, table_.numbers.columns, free);
        for (Column& column : columns_) {
            if (!above.units.empty()) column.title.unit = above.units[column.number];
            column.from = above.units.empty() ? line(column.title.line) : above.from;
            column.by_title = !column.title.unit.empty();
        }
    }

    void set(Column& column, std::string_view unit, const std::string& from, double factor) {
        column.unit = {std::string(unit), factor};
        column.from = from;
        if (std::find(sources_.begin(), sources_.end(), from) == sources_.end()) sources_.push_back(from);
    }

    void warn(const std::string& stated) {
        record_.warnings.push_back(contradiction(options_.names, "units", shown_cell(options_.units), stated));
    }

    void warn_of_unit(std::string_view stated, const LengthUnit& used, const std::string& from,
                      const std::string& what) {
        if (!stated.empty() && !used.name.empty() && factor_of(stated) != used.factor)
            warn(from + ", which states " + printable(stated, 16) + " for " + what);
    }

    void take_given() {
        for (Column& column : columns_) {
            const std::string from = column.from;
            const std::string_view unit = column.role == Role::heights                   ? given_.back()
                                          : column.role == Role::y && given_.size() == 3 ? given_[1]
                                                                                         : given_.front();
            set(column, unit, "options", factor_of(unit));
            warn_of_unit(column.title.unit, column.unit, from, column.what);
        }
        if (!columns_.front().by_title) warn_of_header(columns_.front());
    }

    /// Warns of the first unit or factor of the heights that the header states otherwise.
    void warn_of_header(const Column& heights) {
        for (const HeaderEntry& entry : table_.entries) {
            if (is_conversion(entry))
                return warn(line(entry.line) + ", which states a height conversion factor of " +
                            printable(entry.value, 24));
            if (is_height_unit_key(entry.key) && is_length(&entry) && factor_of(entry.value) != heights.unit.factor)
                return warn_of_unit(entry.value, heights.unit, line(entry.line), heights.what);
        }
    }

    void take_stated() {
        for (Column& column : columns_)
            if (column.by_title)
                set(column, column.title.unit, column.from, factor_of(column.title.unit));
            else if (column.title.unread.empty())
                take_header(column);
        for (const Column& column : columns_) require_unit(column);
        for (const Column& column : columns_)
            if (column.by_title) refuse_other_unit(column);
    }

    void take_header(Column& column) {
        const StatedHeightUnit stated =
            column.role == Role::heights
                ? stated_height_unit(table_.entries, name_)
                : StatedHeightUnit{.unit = stated_axis_unit(table_.entries, column.role == Role::y)};
        column.entry = stated.unit;
        if (stated.factor && may_be_converted()) return take_conversion(column, *stated.factor);
        if (is_length(column.entry))
            set(column, column.entry->value, line(column.entry->line), factor_of(column.entry->value));
        if (const HeaderEntry* const count = find_entry(table_.entries, "bit2nm"); count && may_be_converted())
            take_counts(column, *count);
    }

    /// "height conversion factor (-> m)=2.9e-8", or "... = 29 nm".
    void take_conversion(Column& heights, const HeaderEntry& entry) {
        const LeadingNumber number = leading_number(entry.value);
        std::string_view to = trimmed(std::string_view(entry.value).substr(number.length));
        const std::size_t arrow = entry.key.find("->");
        if (to.empty() && arrow != std::string::npos) {
            to = std::string_view(entry.key).substr(arrow + 2);
            to = trimmed(to.substr(0, to.find(')')));
        }
        if (number.status != NumberStatus::ok || !(number.value > 0) || !is_unit(to, Dimension::length))
            refuse_line(name_, entry.line,
                        {shown_cell(entry.value),
                         " is not a height conversion factor; must be a positive number with a "
                         "unit of length, such as \"(-> m)=2.9e-8\""});
        const double factor = number.value * factor_of(to);
        if (is_length(heights.entry) && !(std::abs(factor - factor_of(heights.entry->value)) <= 1e-6 * factor))
            refuse_line(name_, entry.line,
                        {"states a height conversion factor, line ", heights.entry->line,
                         " a unit of length that disagrees; must agree, or units be given"});
        set(heights, heights.entry ? printable(heights.entry->value, 16) : "units", line(entry.line), factor);
        text_of_heights_ = heights.unit.name + " of " + number_text(factor) + " m";
    }

    /// "Bit2nm = 0.5" of SPIP: nanometres of a count, where no unit is stated.
    void take_counts(Column& heights, const HeaderEntry& entry) {
        const auto number = number_in(entry.value, false);
        if (!number || !(*number > 0) || !std::isfinite(*number))
            refuse_line(name_, entry.line, {"Bit2nm ", shown_cell(entry.value), "; must be a number greater than 0"});
        if (!heights.unit.name.empty() && *number != 1)
            refuse_line(
                name_, entry.line,
                {"states Bit2nm ", *number, ", line ", heights.entry->line, " the unit ", shown_cell(heights.unit.name),
                 ": heights may be in either; must be ", given_as(options_.names, "units", "\"nm\"")});
        if (!heights.unit.name.empty()) return;
        set(heights, "counts", line(entry.line), *number * 1e-9);
        text_of_heights_ = "counts of " + number_text(*number) + " nm";
    }

    /// How messages call the units that are to be given: those that are known by their names.
    std::string asked() const {
        if (columns_.size() > 1) return pair_of_units(columns_[1].unit.name, columns_[0].unit.name);
        return lacks_unit_of_length() ? pair_of_units("", "") : "\"UNIT\"";
    }
    /// Whether the header of a map states a length without a unit, which the options may give.
    bool lacks_unit_of_length() const {
        return !is_profile_ && !stated_grid(table_.entries, "", name_).without_unit.empty();
    }

    void require_unit(const Column& column) const {
        if (!column.unit.name.empty()) return;
        const std::string each = lacks_unit_of_length() ? " (lengths, heights), each "
                                 : columns_.size() == 1 ? ", "
                                 : is_profile_          ? " (positions, heights), each "
                                                        : " (x and y, heights), each ";
        const std::string must = "must be " + given_as(options_.names, "units", asked()) + each + "one of " +
                                 accepted_units(Dimension::length);
        const auto refuse = [&](std::size_t number, std::string_view unit) {
            refuse_line(
                name_, number,
                {"states the unit ", shown_cell(unit), " for ", column.what, ", which is not understood; ", must});
        };
        if (!column.title.unread.empty()) refuse(column.title.line, column.title.unread);
        if (column.entry) refuse(column.entry->line, column.entry->value);
        refuse_file(name_, {"states no unit of ", column.what, " and none is given; ", must,
                            is_profile_ ? hint_of_mitutoyo(table_.numbers) : ""});
    }

    /// Refuses a unit of the header that is another than that of the title.
    void refuse_other_unit(const Column& column) const {
        const HeaderEntry* const axis = stated_axis_unit(table_.entries, column.role == Role::y);
        for (const HeaderEntry& entry : table_.entries) {
            const bool is_about = column.role == Role::heights ? is_height_unit_key(entry.key) : &entry == axis;
            if (!is_about || !is_length(&entry)) continue;
            // "Unit" alone may be that of the positions
            const bool agrees = std::any_of(columns_.begin(), columns_.end(), [&](const Column& other) {
                const bool may_be_meant = column.role == Role::heights && other.role != Role::heights;
                return (&other == &column || may_be_meant) && other.unit.factor == factor_of(entry.value);
            });
            if (!agrees)
                refuse_line(
                    name_, entry.line,
                    {"states ", printable(entry.value, 16), ", and ", column.from, " ", printable(column.unit.name, 16),
                     " for ", column.what, "; must be one unit, or ", given_as(options_.names, "units", asked())});
        }
    }

    /// Multiplies the unit of the heights by the factor that the header states. Refuses one that may be in the numbers
    /// or not; where a unit is given, warns of it.
    void scale_heights() {
        const double scale = given_.empty() ? require_scale(table_.entries, name_, options_.names) : 1;
        if (const HeaderEntry* const entry = stated_scale(table_.entries).entry; entry && !given_.empty())
            warn(shown_line(*entry));
        units_.heights.factor *= scale;
        text_of_heights_ = (scale == 1 ? "" : number_text(scale) + " ") + printable(units_.heights.name, 16);
    }

    const TextTable& table_;
    const SurfaceOptions& options_;
    const std::string& name_;
    Record& record_;
    const bool is_profile_ = table_.form == SurfaceFormat::profile;
    std::vector<std::string_view> given_{};
    std::vector<Column> columns_{};  // that of the heights first
    Units units_{};
    std::vector<std::string> sources_{};
    std::string text_of_heights_{};  // for the record
};

}  // namespace

Units units_of(const TextTable& table, const SurfaceOptions& options, const std::string& name, Record& record) {
    return UnitFinder(table, options, name, record).find();
}

std::string asked_units(const TextTable& table, const std::string& name) {
    const HeaderEntry* const unit = stated_height_unit(table.entries, name).unit;
    return pair_of_units("", is_length(unit) ? unit->value : "");
}

std::string hint_of_mitutoyo(const NumberTable& table) {
    if (table.counted < 2 || table.columns != 1) return "";
    const auto length = number_in(table.lines[table.counted - 2].text, false);
    if (!length || !(*length > 0)) return "";
    const std::string step = number_text(*length / static_cast<double>(table.rows()));
    return "; Mitutoyo writes the length in mm and the number of points above heights in um, which would be " +
           table.names.prefix + "units" + table.names.equals + "um and " + table.names.prefix + "spacing" +
           table.names.equals + "\"" + step + " mm\"";
}

}  // namespace fstiff::inline v0_1::io::detail
