// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The options of a request as the package was given them, a dict; the heights; and the document that answers.
#include "module.hpp"

#include "document/document.hpp"
#include "surface/measured_surface.hpp"
#include "surface/request.hpp"
#include "surface/surface_file.hpp"
#include "surface/surface_option_table.hpp"

#include <concepts>
#include <memory>
#include <optional>

namespace fstiff::python {

/// The lengths of the option \p key: of a number [m], a text, or a sequence of them.
/// \throws domain_error for any other \p value.
scene::Lengths lengths_of(const nb::handle& value, const std::string& key);

/// The options as the package was given them. take() leaves alone what is not there.
class Given {
public:
    explicit Given(const nb::dict& options) : options_(options) {}
    [[nodiscard]] bool has(const std::string& key) const { return options_.contains(key.c_str()); }
    template <class T>
    void take(const char* key, T& to) const {
        if (options_.contains(key) && !nb::try_cast<T>(options_[key], to)) refuse(key);
    }
    template <parts::NamedEnum Enum>
    void take(const char* key, Enum& to) const {
        std::string text;
        take(key, text);
        if (!text.empty()) to = parse<Enum>(text, key);
    }
    template <parts::NamedEnum Enum>
    void take(const char* key, std::optional<Enum>& to) const {
        if (options_.contains(key)) take(key, to.emplace());
    }
    void take(const char* key, std::optional<double>& to) const {
        if (options_.contains(key)) take(key, to.emplace());
    }
    void take(const char* key, scene::Lengths& to) const {
        if (options_.contains(key)) to = lengths_of(options_[key], key);
    }
    /// A number in SI, or a text with its unit.
    void take(const char* key, scene::Amount& to) const {
        double number = 0;
        std::string text;
        if (!options_.contains(key)) return;
        if (nb::try_cast(options_[key], number))
            to = number;
        else
            take(key, text), to = text;
    }
    template <std::integral Count>
    requires(!std::same_as<Count, bool>) void take(const char* key, Count& to) const {
        if (!options_.contains(key)) return;
        long long given = 0;
        if (!nb::try_cast<long long>(options_[key], given)) refuse(key);
        if constexpr (std::unsigned_integral<Count>)
            require(given >= 0 && given < 1LL << 53, key, given, "from 0 to 2^53 - 1");
        to = static_cast<Count>(given);
        if (static_cast<long long>(to) != given) refuse(key);
    }
    /// The same of an option, in its range.
    void take(const std::string& key, auto& to, const scene::OptionTraits& of) const {
        if (!has(key)) return;
        take(key.c_str(), to);
        of.check(key, to);
    }

private:
    [[noreturn]] void refuse(const char* key) const {
        throw domain_error(std::string(key) + " = " + nb::cast<std::string>(nb::repr(options_[key])).substr(0, 40) +
                           ": is of a wrong type");
    }

    const nb::dict& options_;
};

scene::SurfaceOptions surface_options(const Given& given);

/// All options of a request but those of its surface.
template <class Request>
Request request_of(const Given& given) {
    Request request;
    request.each_option([&](const std::string& key, auto& to, const std::string&, const scene::OptionTraits& of = {}) {
        given.take(key, to, of);
    });
    return request;
}

/// A document as the command prints it, and whether the command would call it doubtful.
struct Found {
    std::string json;
    bool doubtful = false;
    std::shared_ptr<const scene::MeasuredSurface> measured{};
};

inline Found found(const scene::Document& document, std::shared_ptr<const scene::MeasuredSurface> measured = {}) {
    return {document.values().str(), document.doubtful, std::move(measured)};
}

}  // namespace fstiff::python
