// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The files of an X3P archive, within limits. Needs libzip.
///
/// Names in the archive are compared, never used as paths. Sizes are compared with the limits before anything is
/// inflated. The CRC of the archive is verified.

#include "io/lines.hpp"

#include <fstiff/io/surface_file.hpp>

#include <zip.h>

#include <cstdint>
#include <memory>
#include <utility>

namespace fstiff::inline v0_1::io {

namespace detail {

/// A zip archive in memory.
class ZipArchive {
public:
    ZipArchive(std::string_view bytes, std::string name, const X3pLimits& limits)
        : bytes_(bytes), name_(std::move(name)), limits_(limits) {
        zip_error_t error;
        zip_error_init(&error);
        if (zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error)) {
            archive_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
            if (!archive_) zip_source_free(source);
        }
        zip_error_fini(&error);
        if (!archive_) refuse_file(name_, {"is no zip archive, or a damaged one; must be a whole X3P file"});
        const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
        if (count > limits_.files) refuse_file(name_, {"holds ", count, " files; must be at most ", limits_.files});
        for (zip_int64_t i = 0; i < count; ++i) {
            const char* const entry = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), ZIP_FL_ENC_RAW);
            names_.emplace_back(entry ? entry : "");
        }
    }

    const std::vector<std::string>& names() const { return names_; }

    /// The one file called \p entry; none when there is none.
    std::optional<std::size_t> find(std::string_view entry) const {
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (names_[i] != entry) continue;
            if (found) refuse_file(name_, {"holds two files ", shown_cell(entry), "; must hold one"});
            found = i;
        }
        return found;
    }

    /// Size of file \p index once inflated, which is within the limits.
    std::size_t size(std::size_t index) const {
        zip_stat_t stat;
        zip_stat_init(&stat);
        constexpr zip_uint64_t needed = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_ENCRYPTION_METHOD;
        if (zip_stat_index(archive_.get(), index, 0, &stat) != 0 || (stat.valid & needed) != needed)
            refuse_file(name_, {shown_cell(names_[index]), " has no readable entry; must be a whole X3P file"});
        if (stat.encryption_method != ZIP_EM_NONE)
            refuse_file(name_, {shown_cell(names_[index]), " is encrypted; must not be"});
        if (stat.comp_size > bytes_.size())
            refuse_file(name_, {shown_cell(names_[index]), " declares ", stat.comp_size,
                                " deflated bytes, more than the file has; must be a whole X3P file"});
        if (stat.size > limits_.bytes)
            refuse_file(name_, {shown_cell(names_[index]), " would inflate to ", stat.size, " bytes; must be at most ",
                                limits_.bytes});
        if (stat.size > (std::uint64_t(1) << 20) && stat.size / limits_.ratio > stat.comp_size)
            refuse_file(name_, {shown_cell(names_[index]), " would inflate from ", stat.comp_size, " to ", stat.size,
                                " bytes; must be at most ", limits_.ratio, " times as many"});
        return static_cast<std::size_t>(stat.size);
    }

    std::string content(std::size_t index) const {
        std::string text(size(index), '\0');
        struct Close {
            void operator()(zip_file_t* file) const { zip_fclose(file); }
        };
        const std::unique_ptr<zip_file_t, Close> file(zip_fopen_index(archive_.get(), index, 0));
        if (!file) refuse_file(name_, {shown_cell(names_[index]), " cannot be inflated; must be deflated or stored"});
        std::size_t done = 0;
        while (done < text.size()) {
            const zip_int64_t got = zip_fread(file.get(), text.data() + done, text.size() - done);
            if (got <= 0) break;
            done += static_cast<std::size_t>(got);
        }
        char beyond = 0;  // reading to the end makes libzip compare the CRC
        if (done < text.size() || zip_fread(file.get(), &beyond, 1) != 0)
            refuse_file(name_, {shown_cell(names_[index]), " is damaged; must be a whole X3P file"});
        return text;
    }

private:
    struct Discard {
        void operator()(zip_t* archive) const { zip_discard(archive); }
    };
    std::string_view bytes_;
    std::string name_;
    X3pLimits limits_;
    std::unique_ptr<zip_t, Discard> archive_;
    std::vector<std::string> names_;
};

}  // namespace detail

}  // namespace fstiff::inline v0_1::io
