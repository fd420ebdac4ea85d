// SPDX-License-Identifier: BSD-3-Clause
// fstiff._core: what the Python package takes from fstiff::scene. The package itself is what people call.
#include "module.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/version.hpp>

namespace fstiff::python {

ProgressHook until_interrupted() {
    return [](std::string_view, std::size_t, std::size_t) {
        const nb::gil_scoped_acquire held;
        if (PyErr_CheckSignals() != 0) throw nb::python_error();
    };
}

}  // namespace fstiff::python

NB_MODULE(_core, m) {
    using namespace fstiff::python;
    m.doc() = "Compiled part of fstiff; use the package.";
    m.attr("version") = FSTIFF_VERSION_TEXT;
    // fstiff::domain_error is a std::domain_error, which nanobind raises as ValueError.
    nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
        try {
            std::rethrow_exception(thrown);
        } catch (const fstiff::file_error& error) {
            const nb::object type = nb::module_::import_("fstiff._errors").attr("FileError");
            PyErr_SetString(type.ptr(), error.what());
        }
    });
    add_contacts(m);
    add_integrals(m);
    add_scenes(m);
    add_surfaces(m);
    add_answers(m);
    add_sweeps(m);
}
