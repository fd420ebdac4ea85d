// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads profiles of ISO 5436-2 (.smd, "softgauge") and of its elder relative that Mahr and Taylor Hobson write (.prf).
///
/// Both are text in records. Those of .smd end at the character ETX (3), and their fields are parted by NUL bytes or
/// blanks; those of .prf end at a line EOR. The first record names the file, the form PRF (a profile), and two axes:
///
///     CX I 8000 mm 1.0e0 D 5.0e-4        axis, kind, points, unit, scale, type of the numbers, and of I the increment
///     CZ A 8000 um 1.0e0 D
///
/// kinds being I (equal increments) of x and A (absolute) of z in .smd, and M of both in .prf, whose spacing is in
/// the second record as "SPACING CX 5.0e-4". The third record has a height a line, the fourth of .smd a sum over all
/// bytes.
///
///     z = number * scale * unit of CZ,        dx = increment * scale * unit of CX
///
/// The sum is compared modulo 65535 and modulo 65536, for descriptions differ; one that fits neither is warned of.
/// Lines MAP of .prf other than those of a straight gauge (MAP 1 CZ CZ 1 1, MAP 2 CZ CX 1 0) are not applied, with a
/// warning.
///
/// Reference   ISO 5436-2:2012, as the public help of NPL (softgauges, "Data File Format") and open programs that read
///             or write it lay it out; not compared with files of the instruments themselves
/// Units       m
/// Valid       16 heights at least, that vary; files up to 2^31 bytes, lines up to 2^20 characters
/// Accuracy    number times scale times unit: two roundings (tests/io/smd_test.cpp)

#include "io/readers.hpp"

#include "io/lines.hpp"

#include <fstiff/io/units.hpp>

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Content of the records.
struct SmdHeader {
    bool prf{};           // the elder form
    std::string version;  // of .smd, "ISO 5436-2:2012"; printable characters only
    std::string x_unit, z_unit;
    std::string stylus_radius;  // as the file states it; empty where it does not
    double resolution{};        // step in which the heights are counted or printed [m]
    bool sum_stated{}, sum_agrees{};
    bool mapped{};  // lines MAP that are not applied
};

/// Fields between blanks or NUL bytes.
std::vector<std::string_view> smd_fields(std::string_view line) {
    std::vector<std::string_view> fields;
    const std::string_view blanks(" \t\r\0", 4);
    while (true) {
        const std::size_t begin = line.find_first_not_of(blanks);
        if (begin == std::string_view::npos) return fields;
        line.remove_prefix(begin);
        const std::size_t end = (std::min)(line.find_first_of(blanks), line.size());
        fields.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

/// Whether \p bytes begin with "1 2", a line that ends with PRF, and the axis CX.
bool is_prf(std::string_view bytes) {
    std::vector<std::string_view> fields[3];
    for (auto& one : fields) {
        const std::size_t end = bytes.substr(0, 1024).find('\n');
        if (end == std::string_view::npos) return false;
        one = smd_fields(bytes.substr(0, end));
        bytes.remove_prefix(end + 1);
    }
    return fields[0].size() == 2 && is_digit(fields[0][0].front()) && is_digit(fields[0][1].front()) &&
           !fields[1].empty() && fields[1].back() == "PRF" && !fields[2].empty() && fields[2].front() == "CX";
}

bool is_smd(std::string_view bytes) { return bytes.starts_with("ISO 5436") || is_prf(bytes); }

Record record_of(const SmdHeader& file, const RawMap& map) {
    Record record;
    record.note("form",
                file.prf ? "profile in records (.prf)" : "profile of ISO 5436-2 (.smd), \"" + file.version + "\"");
    record.note("units", "x in " + file.x_unit + ", heights in " + file.z_unit + ", from the axes CX and CZ");
    record.note("spacing", std::string("from ") + (file.prf ? "SPACING CX" : "the increment of CX"));
    record.say_points_of_profile(map);
    if (!file.stylus_radius.empty()) record.note("stylus radius", file.stylus_radius + " in the file, not used");
    if (file.sum_stated) record.note("check sum", file.sum_agrees ? "agrees" : "does not agree");
    if (file.sum_stated && !file.sum_agrees)
        record.warnings.push_back(
            "the check sum of the file does not agree with its bytes, which may have been changed since");
    if (file.mapped)
        record.warnings.push_back(
            "the file states a correction of its gauge (lines MAP), which was not applied to the heights");
    record.resolution = file.resolution;
    return record;
}

class SmdReader {
public:
    SmdReader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

    Reading read() {
        if (!is_smd(bytes_))
            refuse_file(name_,
                        {"does not begin as a profile of ISO 5436-2; must begin with ISO 5436, or as .prf with a "
                         "line that ends with PRF and the axis CX"});
        header_.prf = !bytes_.starts_with("ISO 5436");
        find_records();
        axes();
        remarks();
        RawMap map;
        map.rows = 1;
        map.dx = map.dy = spacing();
        map.heights = heights();
        map.columns = map.heights.size();
        fstiff::detail::located({.file = name_}, [&] { validate_map(map, 16); });
        if (!header_.prf) compare_sum();
        Record record = record_of(header_, map);
        return {std::move(map), std::move(record)};
    }

private:
    struct Axis {
        std::size_t line{};
        std::string_view kind, type, increment;
        std::size_t points{};
        std::string unit;
        double scale = 1;  // number to metres
    };

    /// The lines of every record; those that are blank are left out.
    void find_records() {
        constexpr std::size_t longest = std::size_t(1) << 20;
        std::string_view rest = bytes_;
        records_.emplace_back();
        for (std::size_t number = 1; !rest.empty(); ++number) {
            const std::size_t end = (std::min)(rest.find('\n'), rest.size());
            if (end > longest) refuse_line(name_, number, {"is longer than 2^20 characters; must be shorter"});
            std::string_view line = rest.substr(0, end);
            rest.remove_prefix((std::min)(end + 1, rest.size()));
            const bool last = line.find('\x1A') != std::string_view::npos;
            line = line.substr(0, line.find('\x1A'));
            for (std::size_t ends = 0; (ends = line.find('\3')) != std::string_view::npos;) {
                add({line.substr(0, ends), number});
                line.remove_prefix(ends + 1);
                end_record(bytes_.size() - rest.size());
            }
            if (header_.prf && trimmed(line) == "EOR")
                end_record(0);
            else
                add({line, number});
            if (last || records_.size() > 5) break;  // the heights and their sum are read
        }
        if (records_.size() < 4)
            refuse_file(name_, {"holds ", records_.size() - 1,
                                " whole records; must hold at least 3: the axes, remarks "
                                "and the heights, each of which ends at ",
                                (header_.prf ? "a line EOR" : "the character ETX")});
    }
    void add(const Line& line) {
        if (!smd_fields(line.text).empty()) records_.back().push_back(line);
    }
    void end_record(std::size_t bytes) {
        if (records_.size() == 3) heights_end_ = bytes;
        records_.emplace_back();
    }

    void axes() {
        const std::vector<Line>& lines = records_[0];
        if (!header_.prf) {
            const std::string_view first = lines.front().text;
            header_.version = printable(trimmed(first.substr(0, first.find('\0'))), 40);
            const auto form = lines.size() < 2 ? std::vector<std::string_view>() : smd_fields(lines[1].text);
            if (form.empty() || form.front() != "PRF")
                refuse_file(name_, {"states the form ", shown_cell(form.empty() ? "" : form.front()),
                                    " after its first line; must be PRF, a profile"});
        }
        for (const Line& line : lines) {
            const auto fields = smd_fields(line.text);
            if (fields.front() == "CY")
                refuse_line(name_, line.number, {"states an axis CY; must be a profile, of CX and CZ"});
            if (fields.front() == "CX") set(x_, fields, line.number);
            if (fields.front() == "CZ") set(z_, fields, line.number);
        }
        for (const auto& [axis, called] : {std::pair{&x_, "CX"}, {&z_, "CZ"}})
            if (axis->line == 0)
                refuse_file(name_, {"states no axis ", called, " in its first record; must state CX and CZ"});
        const std::string_view kind_of_x = header_.prf ? "M" : "I", kind_of_z = header_.prf ? "M" : "A";
        for (const auto& [axis, kind] : {std::pair{&x_, kind_of_x}, {&z_, kind_of_z}})
            if (axis->kind != kind)
                refuse_line(name_, axis->line,
                            {"states an axis of the kind ", shown_cell(axis->kind), "; must be ", kind});
        if (x_.points != z_.points)
            refuse_line(name_, z_.line, {"states ", z_.points, " points where CX has ", x_.points, "; must agree"});
        header_.x_unit = x_.unit;
        header_.z_unit = z_.unit;
    }

    /// CX I 8000 mm 1.0e0 D 5.0e-4
    void set(Axis& axis, const std::vector<std::string_view>& fields, std::size_t line) {
        if (axis.line != 0) refuse_line(name_, line, {"states ", fields[0], " again; must be stated once"});
        if (fields.size() < 6)
            refuse_line(name_, line,
                        {"has ", fields.size(), " fields; must have axis, kind, points, unit, scale and type"});
        axis.line = line;
        axis.kind = fields[1];
        axis.type = fields[5];
        if (fields.size() > 6) axis.increment = fields[6];
        const double points = number(fields[2], line, "number of points");
        if (!(points >= 1 && points <= 4294967295.0 && points == std::floor(points)))
            refuse_line(name_, line, {shown_cell(fields[2]), " points; must be a whole number from 1 to 4294967295"});
        axis.points = static_cast<std::size_t>(points);
        axis.unit = lower_case(fields[3]);  // "MM"
        if (!is_unit(axis.unit, Dimension::length)) axis.unit = fields[3];
        if (!is_unit(axis.unit, Dimension::length))
            refuse_line(name_, line,
                        {shown_cell(fields[3]), " is not a unit of length; must be one of ",
                         accepted_units(Dimension::length)});
        axis.unit = printable(axis.unit, 16);
        const double scale = number(fields[4], line, "scale");
        if (!(scale > 0)) refuse_line(name_, line, {"scale ", shown_cell(fields[4]), "; must be greater than 0"});
        axis.scale = scale * unit_factor(axis.unit, Dimension::length);
        if (axis.type != "I" && axis.type != "L" && axis.type != "F" && axis.type != "D")
            refuse_line(name_, line, {"numbers of the type ", shown_cell(axis.type), "; must be I, L, F or D"});
    }

    double number(std::string_view cell, std::size_t line, const char* what) const {
        const auto found = number_in(cell, false);
        if (!found || !std::isfinite(*found))
            refuse_line(name_, line, {what, " ", shown_cell(cell), "; must be a finite decimal number"});
        return *found;
    }

    /// The second record: the spacing of .prf, its stylus, and what its gauge would have applied.
    void remarks() {
        for (const Line& line : records_[1]) {
            const auto fields = smd_fields(line.text);
            if (fields.front() == "STYLUS_RADIUS" && fields.size() == 3)
                header_.stylus_radius = printable(fields[1], 20) + " " + printable(lower_case(fields[2]), 8);
            if (!header_.prf) continue;
            if (fields.front() == "SPACING" && fields.size() >= 3 && fields[1] == "CX") {
                if (!x_.increment.empty())
                    refuse_line(name_, line.number, {"states the spacing of CX again; must be stated once"});
                x_.increment = fields[2];
                spacing_line_ = line.number;
            }
            if (fields.front() != "MAP") continue;
            const auto value = [&](std::size_t i) {
                return i < fields.size() ? number_in(fields[i], false) : std::nullopt;
            };
            const bool straight = fields.size() == 6 && fields[2] == "CZ" && value(4) == 1.0 &&
                                  ((value(1) == 1.0 && fields[3] == "CZ" && value(5) == 1.0) ||
                                   (value(1) == 2.0 && fields[3] == "CX" && value(5) == 0.0));
            header_.mapped = header_.mapped || !straight;
        }
    }

    double spacing() {
        const std::size_t line = spacing_line_ != 0 ? spacing_line_ : x_.line;
        if (x_.increment.empty())
            refuse_line(name_, line,
                        {header_.prf ? "states an axis without a spacing; must have a line SPACING CX"
                                     : "states no increment; must have one after the type"});
        const double step = number(x_.increment, line, "increment") * x_.scale;
        if (!(step > 0) || !std::isfinite(step))
            refuse_line(name_, line, {"increment ", shown_cell(x_.increment), "; must be greater than 0"});
        return step;
    }

    std::vector<double> heights() {
        const std::vector<Line>& lines = records_[2];
        if (lines.size() != z_.points)
            refuse_file(name_, {"states ", z_.points, " points, but holds ", lines.size(), "; must hold all"});
        std::vector<double> values;
        values.reserve(lines.size());
        PrintedDigits printed;
        for (const Line& line : lines) {
            const auto fields = smd_fields(line.text);
            if (fields.size() != 1)
                refuse_line(name_, line.number, {"holds ", fields.size(), " numbers; must hold one height"});
            if (is_missing_word(fields[0])) {
                values.push_back(std::numeric_limits<double>::quiet_NaN());
                continue;
            }
            const double value = number(fields[0], line.number, "height");
            printed.add(fields[0], value);
            values.push_back(value * z_.scale);
        }
        const bool counted = z_.type == "I" || z_.type == "L";
        header_.resolution = (counted ? 1 : printed.resolution()) * z_.scale;
        return values;
    }

    /// The sum over the bytes of the first three records, with the end of their last line.
    void compare_sum() {
        if (records_.size() < 5 || records_[3].size() != 1) return;
        const auto stated = number_in(trimmed(records_[3].front().text), false);
        if (!stated) return;
        std::uint64_t sum = 0;
        for (const char c : bytes_.substr(0, heights_end_)) sum += static_cast<unsigned char>(c);
        header_.sum_stated = true;
        header_.sum_agrees = *stated == static_cast<double>(sum % 65535) || *stated == static_cast<double>(sum % 65536);
    }

    std::string_view bytes_;
    std::string name_;
    std::vector<std::vector<Line>> records_;
    std::size_t heights_end_ = 0, spacing_line_ = 0;
    Axis x_, z_;
    SmdHeader header_;
};

}  // namespace

extern constexpr Reader smd_reader{.format = SurfaceFormat::smd,
                                   .endings = ".smd .prf",
                                   .holds = "profile of ISO 5436-2, and the older form of Mahr and Taylor Hobson",
                                   .recognised = "its first line, ISO 5436, or its second, which ends with PRF",
                                   .begins = is_smd,
                                   .read = read_by<SmdReader>};

}  // namespace fstiff::inline v0_1::io::detail
