// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The options of a request as the package was given them, a dict; the heights; and the document that answers.
#include "module.hpp"

#include "document/document.hpp"
#include "request/values.hpp"
#include "surface/measured_surface.hpp"
#include "surface/surface_file.hpp"
#include "surface/surface_option_table.hpp"

#include <memory>

namespace fstiff::python {

/// A value of an option.
request::Value value_of(const nb::handle& value);
/// The options as the package was given them, without those that are None.
request::Values values_of(const nb::dict& options);

/// A request with the options of its fields, and of its surface.
template <class Request>
Request request_of(const nb::dict& options) {
    request::Values values = values_of(options);
    Request request;
    values.fill(request);
    if constexpr (requires { request.surface; })
        values.fill(request.surface);
    else if constexpr (requires { request.input; })
        values.fill(request.input);
    return request;
}

/// A document as the command prints it, and whether the command would call it doubtful.
struct Found {
    std::string json;
    bool doubtful = false;
    std::shared_ptr<const surface::MeasuredSurface> measured{};
};

inline Found found(const document::Document& document, std::shared_ptr<const surface::MeasuredSurface> measured = {}) {
    return {document.values().str(), document.doubtful, std::move(measured)};
}

}  // namespace fstiff::python
