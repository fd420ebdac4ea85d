// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads maps and profiles of contact.engineering (.nc) in the classic form of NetCDF.
///
/// "CDF" and 1, 2 or 5, then dimensions, attributes and variables, the most significant byte first; a count is of 4
/// bytes, of 8 in form 5. Of the file are used
///
///     heights    variable over (x, y), or over (x): float32, float64 or integers, in its attribute unit
///     x, y       variables with the attributes length, the size of the map, and unit; all units are the same
///     mask       variable as heights, whose numbers other than 0 mark missing points
///
///     dx = length of x / points of x
///
/// NaN and the attribute _FillValue of heights are missing points too. Rows are the index y.
///
/// Reference   The NetCDF Classic Format Specification (Unidata); names as in SurfaceTopography 1.27.1 (MIT licence)
/// Units       map in m
/// Valid       2 points a side at least, or one profile; heights that vary; no records; at most 100000
///             entries; NetCDF 4, which is HDF5, and profiles of unequal steps are refused
/// Accuracy    number times unit, rounded once (tests/io/netcdf_test.cpp)

#include "io/readers.hpp"

#include "io/file_bytes.hpp"

#include <map>

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Numbers or text in the file, of one of the types 1 to 11.
struct NcValues {
    std::uint64_t type{}, count{}, place{};
};

/// A variable of the file, by its name.
struct NcVariable {
    std::vector<std::string> over;  // names of its dimensions
    std::map<std::string, NcValues> attributes;
    NcValues values;
};

/// Bytes of a number of \p type; 0 where there is no such type.
std::size_t nc_size(std::uint64_t type) {
    static constexpr std::size_t sizes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    return type < 12 ? sizes[type] : 0;
}

/// The header of a file, read from its front to its end.
class NcHeader {
public:
    explicit NcHeader(const FileBytes& file) : file_(file) {
        form_ = file.number(3, 1, "the header");
        take(form_ == 5 ? 8 : 4);  // of records, all ones where it is not known
        each(10, "dimensions", [&] {
            const std::string name = text();
            dimensions_.emplace_back(name, count());
        });
        attributes();
        each(11, "variables", [&] {
            const std::string name = text();
            variables_.emplace(name, variable());
        });
    }

    const NcVariable* find(const std::string& name) const {
        const auto found = variables_.find(name);
        return found == variables_.end() ? nullptr : &found->second;
    }
    std::uint64_t length_of(const std::string& dimension) const {
        for (const auto& [name, length] : dimensions_)
            if (name == dimension) return length;
        return 0;
    }

private:
    std::uint64_t take(std::size_t size) {
        place_ += size;
        return file_.number(place_ - size, size, "the header");
    }
    /// A count of what each takes a byte of the file at least.
    std::uint64_t count() {
        const std::uint64_t value = take(form_ == 5 ? 8 : 4);
        if (value > most_bytes)
            refuse_file(file_.name(), {"has a count of ", value, " in its header; must be below 2^31"});
        return value;
    }
    /// Past \p size bytes and what fills them up to a multiple of 4.
    std::string_view skip(std::uint64_t size) {
        const std::string_view bytes = file_.at(place_, size, "the header");
        place_ += (size + 3) / 4 * 4;
        return bytes;
    }
    std::string text() { return std::string(skip(count())); }

    template <class Use>
    void each(std::uint64_t tag, const char* what, const Use& use) {
        const std::uint64_t found = take(4), many = count();
        if (found != tag && (found != 0 || many != 0))
            refuse_file(file_.name(),
                        {"has a tag ", found, " before its ", what, "; must be ", tag, ", or 0 for none"});
        for (std::uint64_t i = 0; i < many; ++i) {
            if (++entries_ > 100000) refuse_file(file_.name(), {"has more than 100000 entries; must have fewer"});
            use();
        }
    }
    NcValues values() {
        const NcValues found{take(4), 0, 0};
        if (nc_size(found.type) == 0)
            refuse_field(file_.name(), "type of a number", std::to_string(found.type), "between 1 and 11");
        return found;
    }
    std::map<std::string, NcValues> attributes() {
        std::map<std::string, NcValues> all;
        each(12, "attributes", [&] {
            const std::string name = text();
            NcValues found = values();
            found.count = count();
            found.place = place_;
            skip(found.count * nc_size(found.type));
            all.emplace(name, found);
        });
        return all;
    }
    NcVariable variable() {
        NcVariable found;
        found.values.count = 1;
        for (std::uint64_t left = count(); left > 0; --left) {
            const std::uint64_t index = count();
            if (index >= dimensions_.size())
                refuse_field(file_.name(), "dimension of a variable", std::to_string(index), "one of those before it");
            found.over.push_back(dimensions_[static_cast<std::size_t>(index)].first);
        }
        found.attributes = attributes();
        found.values.type = values().type;
        take(form_ == 5 ? 8 : 4);  // its bytes, which also follow from its dimensions
        found.values.place = take(form_ == 1 ? 4 : 8);
        return found;
    }

    const FileBytes& file_;
    std::uint64_t form_{}, place_ = 4, entries_ = 0;
    std::vector<std::pair<std::string, std::uint64_t>> dimensions_;
    std::map<std::string, NcVariable> variables_;
};

class NetcdfReader {
public:
    explicit NetcdfReader(const FileBytes& file) : file_(file), header_(file) {}

    Reading read() {
        const NcVariable& heights = require("heights");
        const bool map = heights.over.size() == 2;
        const bool turned = map && heights.over[0] == "y";
        if (!(heights.over == std::vector<std::string>{"x"} || heights.over == std::vector<std::string>{"x", "y"} ||
              heights.over == std::vector<std::string>{"y", "x"}))
            refuse_file(file_.name(), {"has heights that are not over x and y, or x; must be of equal steps"});
        const double unit = unit_of("heights", heights);
        RawMap found;
        columns_ = header_.length_of("x");
        rows_ = map ? header_.length_of("y") : 1;
        const auto place = [&](std::size_t i) {
            return turned || !map ? i : i % found.rows * found.columns + i / found.rows;
        };
        const auto stored = numbers(heights);
        allocate(found, static_cast<std::size_t>(rows_), static_cast<std::size_t>(columns_));
        const double fill = heights.attributes.count("_FillValue")
                                ? number_at(heights.attributes.at("_FillValue"), "_FillValue")
                                : missing;
        for (std::size_t i = 0; i < found.heights.size(); ++i) {
            const double z = number(stored, heights.values.type, i);
            set_height(found, place(i), z == fill ? missing : z * unit);
        }
        if (const NcVariable* const mask = header_.find("mask")) {
            if (mask->over != heights.over) refuse_file(file_.name(), {"has a mask that is not over what heights are"});
            const auto marks = numbers(*mask);
            for (std::size_t i = 0; i < found.heights.size(); ++i)
                if (number(marks, mask->values.type, i) != 0) found.heights[place(i)] = missing;
        }
        const double dx = step("x", columns_);
        set_spacings(found, dx, map ? step("y", rows_) : dx, file_.name());
        Record record = record_of(found, heights);
        return {std::move(found), std::move(record)};
    }

private:
    static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

    const NcVariable& require(const std::string& name) const {
        const NcVariable* const found = header_.find(name);
        if (!found)
            refuse_file(file_.name(),
                        {"has no variable ", name, "; must be a surface as contact.engineering writes it"});
        return *found;
    }
    /// All bytes of \p variable, which is over as many points as the map has.
    std::string_view numbers(const NcVariable& variable) const {
        return stored_heights(file_, {variable.values.place, nc_size(variable.values.type), columns_, rows_, 0});
    }
    static double number(std::string_view bytes, std::uint64_t type, std::size_t index) {
        const std::size_t size = nc_size(type);
        const bool is_unsigned = type == 2 || (type >= 7 && type != 10);
        return value_at(bytes.substr(index * size, size), type == 5 || type == 6 ? 'f' : is_unsigned ? 'u' : 'i', true);
    }
    double number_at(const NcValues& values, const std::string& name) const {
        if (values.count != 1 || values.type == 2) refuse_field(file_.name(), name, "no number", "one number");
        return number(file_.at(values.place, nc_size(values.type), name), values.type, 0);
    }
    /// Value of the unit of \p variable [m]; that of x where it has none.
    double unit_of(const std::string& name, const NcVariable& variable) {
        const auto found = variable.attributes.find("unit");
        if (found == variable.attributes.end() && name != "x") return unit_of("x", require("x"));
        const bool stated = found != variable.attributes.end() && found->second.type == 2;
        const std::string_view unit =
            stated ? file_.words(found->second.place, found->second.count, "unit of " + name) : std::string_view();
        const double factor = require_length_unit(file_.name(), "unit of " + name, unit);
        units_ += (units_.empty() ? "" : ", ") + name + " in " + printable(unit, 16);
        return factor;
    }
    double step(const std::string& name, std::uint64_t points) {
        const NcVariable& variable = require(name);
        const auto found = variable.attributes.find("length");
        if (found == variable.attributes.end())
            refuse_file(file_.name(), {"has no length of ", name, "; must state the size of the map"});
        const double length = require_step(file_.name(), "length of " + name, number_at(found->second, "length"));
        return length * unit_of(name, variable) / static_cast<double>(points);
    }

    Record record_of(const RawMap& map, const NcVariable& heights) const {
        static constexpr const char* types[] = {"",        "int8",  "text",   "int16",  "int32", "float32",
                                                "float64", "uint8", "uint16", "uint32", "int64", "uint64"};
        Record record;
        record.note("form",
                    std::string("NetCDF of contact.engineering, heights of ") + types[heights.values.type % 12]);
        record.note("units", units_);
        record.note("spacing", map.rows == 1 ? "length of x over its points" : "lengths of x and y over their points");
        record.note_points(map, header_.find("mask") ? ", from a mask" : "");
        return record;
    }

    const FileBytes& file_;
    NcHeader header_;
    std::uint64_t columns_{}, rows_{};
    std::string units_;
};

bool is_netcdf(std::string_view bytes) {
    return bytes.size() > 3 && bytes.starts_with("CDF") && (bytes[3] == 1 || bytes[3] == 2 || bytes[3] == 5);
}

Reading read_netcdf(std::string_view bytes, const std::string& name, const SurfaceOptions&) {
    const FileBytes file(bytes, name, true);
    if (!is_netcdf(bytes))
        refuse_file(file.name(), {"does not begin as a classic NetCDF file; must begin with CDF and 1, 2 or 5"});
    return NetcdfReader(file).read();
}

}  // namespace

extern constexpr Reader netcdf_reader{.format = SurfaceFormat::netcdf,
                                      .endings = ".nc",
                                      .holds = "surface of contact.engineering, classic NetCDF",
                                      .recognised = "its first bytes, CDF",
                                      .begins = is_netcdf,
                                      .read = read_netcdf};

}  // namespace fstiff::inline v0_1::io::detail
