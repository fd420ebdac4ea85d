// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/hdf5.hpp"

#include "scene/file.hpp"
#include "sweep/results_file.hpp"
#include "sweep/rows.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#ifdef FSTIFF_HAS_HDF5
#include <hdf5.h>
#endif

namespace fstiff::sweep {

bool is_hdf5(const std::string& file) { return file.ends_with(".h5") || file.ends_with(".hdf5"); }

std::string lines_file(const std::string& output) { return is_hdf5(output) ? output + ".jsonl" : output; }

void require_form(const std::string& output) {
    if (output.ends_with(".parquet"))
        throw scene::option_error(output +
                                  ": Parquet is not written; write .jsonl and convert it with pyarrow, or write .h5");
    for (const char* other : {".csv", ".tsv", ".txt", ".nc", ".npy", ".xlsx"})
        if (output.ends_with(other))
            throw scene::option_error(output + ": results are lines of JSON or HDF5; must end in .jsonl or .h5");
#ifndef FSTIFF_HAS_HDF5
    if (is_hdf5(output)) throw scene::option_error(output + ": this fstiff was built without HDF5; write .jsonl");
#endif
}

#ifdef FSTIFF_HAS_HDF5
namespace {

constexpr std::size_t rows_of_chunk = 65536;

/// A handle of HDF5, closed at its end.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
        if (id < 0) throw file_error("HDF5", "cannot be written");  // the file is named by who calls
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { close_(id_); }
    operator hid_t() const { return id_; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

void check(herr_t status) {
    if (status < 0) throw file_error("HDF5", "cannot be written");
}

/// What stands in a text between its quotation marks. Only json_text wrote it.
std::string plain(std::string_view quoted) {
    std::string text;
    for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
        if (quoted[i] == '\\' && quoted[++i] == 'u') {
            text += static_cast<char>(std::stoi(std::string(quoted.substr(i + 1, 4)), nullptr, 16));
            i += 4;
        } else {
            text += quoted[i];
        }
    }
    return text;
}

/// One key of all lines.
struct Column {
    std::string key;
    bool is_text = false;
    std::size_t width = 1;  ///< bytes of the longest text
    std::vector<double> numbers{};
    std::vector<std::uint64_t> whole{};  ///< of the index
    std::string texts{};
    hid_t set = -1;
};

class Writer {
public:
    Writer(const std::string& lines, const std::string& output) : lines_(lines), output_(output) {}

    void write() {
        find_columns();
        const Handle file(H5Fcreate(output_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
        std::vector<std::unique_ptr<Handle>> sets;
        for (Column& column : columns_) {
            sets.push_back(make(file, column));
            column.set = *sets.back();
        }
        fill();
        describe(file);
        check(H5Fflush(file, H5F_SCOPE_GLOBAL));
    }

private:
    void find_columns() {
        for_each_line(lines_, [&](std::string_view line, std::uint64_t) {
            ++rows_;
            for_each_field(line, [&](std::string_view key, std::string_view value) {
                const auto [at, is_new] = places_.try_emplace(std::string(key), columns_.size());
                if (is_new) columns_.push_back({std::string(key)});
                Column& column = columns_[at->second];
                column.is_text = column.is_text || value.starts_with('"');
                if (value.starts_with('"')) column.width = std::max(column.width, plain(value).size());
            });
            return true;
        });
    }
    [[nodiscard]] static Handle type_of(const Column& column) {
        if (!column.is_text) return {H5Tcopy(column.key == "index" ? H5T_NATIVE_UINT64 : H5T_NATIVE_DOUBLE), H5Tclose};
        const hid_t type = H5Tcopy(H5T_C_S1);
        check(H5Tset_size(type, column.width));
        check(H5Tset_strpad(type, H5T_STR_NULLPAD));
        check(H5Tset_cset(type, H5T_CSET_UTF8));
        return {type, H5Tclose};
    }
    std::unique_ptr<Handle> make(hid_t file, const Column& column) const {
        const hsize_t size = rows_, chunk = std::clamp<hsize_t>(rows_, 1, rows_of_chunk);
        const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
        const Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        check(H5Pset_chunk(how, 1, &chunk));
        if (H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0) {
            check(H5Pset_shuffle(how));
            check(H5Pset_deflate(how, 4));
        }
        const Handle type = type_of(column);
        return std::make_unique<Handle>(
            H5Dcreate2(file, column.key.c_str(), type, space, H5P_DEFAULT, how, H5P_DEFAULT), H5Dclose);
    }
    void fill() {
        std::size_t in_chunk = 0;
        std::uint64_t done = 0;
        const auto put = [&] {
            for (Column& column : columns_) put_rows(column, done, in_chunk);
            done += in_chunk;
            in_chunk = 0;
        };
        for_each_line(lines_, [&](std::string_view line, std::uint64_t) {
            for (Column& column : columns_) {
                if (column.is_text)
                    column.texts.append(column.width, '\0');
                else if (column.key == "index")
                    column.whole.push_back(0);
                else
                    column.numbers.push_back(std::numeric_limits<double>::quiet_NaN());
            }
            for_each_field(line, [&](std::string_view key, std::string_view value) {
                Column& column = columns_[places_.find(key)->second];
                if (column.is_text) {
                    const std::string text = plain(value);
                    if (value.starts_with('"')) column.texts.replace(in_chunk * column.width, text.size(), text);
                } else if (column.key == "index") {
                    column.whole.back() = std::stoull(std::string(value));
                } else if (value != "null") {
                    read_decimal(value.data(), value.data() + value.size(), column.numbers.back());
                }
            });
            if (++in_chunk == rows_of_chunk) put();
            return true;
        });
        if (in_chunk > 0) put();
    }
    static void put_rows(Column& column, hsize_t from, hsize_t count) {
        const Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
        const Handle space(H5Dget_space(column.set), H5Sclose);
        check(H5Sselect_hyperslab(space, H5S_SELECT_SET, &from, nullptr, &count, nullptr));
        const void* data = column.is_text          ? static_cast<const void*>(column.texts.data())
                           : column.key == "index" ? static_cast<const void*>(column.whole.data())
                                                   : static_cast<const void*>(column.numbers.data());
        const Handle type = type_of(column);
        check(H5Dwrite(column.set, type, memory, space, H5P_DEFAULT, data));
        column.texts.clear();
        column.whole.clear();
        column.numbers.clear();
    }
    void describe(hid_t file) const {
        const Description of = read_description(lines_);
        const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
        for (const auto& [name, text] : {std::pair("grid", of.grid), std::pair("hash", of.hash)}) {
            const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
            check(H5Tset_size(type, std::max<std::size_t>(text.size(), 1)));
            check(H5Tset_cset(type, H5T_CSET_UTF8));
            const Handle attribute(H5Acreate2(file, name, type, scalar, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
            check(H5Awrite(attribute, type, text.c_str()));
        }
        for (const auto& [name, count] : {std::pair("scenes", of.scenes), std::pair("failed", of.failed)}) {
            const Handle attribute(H5Acreate2(file, name, H5T_NATIVE_UINT64, scalar, H5P_DEFAULT, H5P_DEFAULT),
                                   H5Aclose);
            check(H5Awrite(attribute, H5T_NATIVE_UINT64, &count));
        }
    }

    const std::string &lines_, &output_;
    std::vector<Column> columns_;
    std::map<std::string, std::size_t, std::less<>> places_;
    hsize_t rows_ = 0;
};

}  // namespace

void write_hdf5(const std::string& lines, const std::string& output) {
    const std::string target = scene::output_target(output).string(), partial = target + ".partial";
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are told here, not by the library
    try {
        Writer(lines, partial).write();
    } catch (const file_error& error) {
        std::remove(partial.c_str());
        if (error.file() == "HDF5") throw file_error(output, std::string(error.reason()));
        throw;
    }
    if (std::rename(partial.c_str(), target.c_str()) != 0) throw file_error(output, "cannot be written");
}
#else
void write_hdf5(const std::string&, const std::string& output) { require_form(output); }
#endif

}  // namespace fstiff::sweep
