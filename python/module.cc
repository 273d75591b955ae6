#include <nlohmann/json.hpp>

#include "contact/base/error.h"
#include "files/version.h"
#include "python/bindings.h"

namespace tricontact::python {

namespace py = pybind11;

py::object from_json(const std::string& text) {
    return py::module_::import("json").attr("loads")(text);
}

void SignalCheck::operator()() {
    constexpr auto interval = std::chrono::milliseconds(50);
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    next_ = std::chrono::steady_clock::now() + interval;
}

namespace {

PyObject* refuse_new(PyTypeObject* type, PyObject*, PyObject*) {
    PyErr_Format(PyExc_TypeError, "%s: objects of it come from functions of tricontact",
                 type->tp_name);
    return nullptr;
}

}  // namespace

void forbid_construction(const py::module_& module) {
    for (const auto& [name, item] : py::cast<py::dict>(module.attr("__dict__"))) {
        if (!PyType_Check(item.ptr()) || !py::hasattr(item, "__module__")) continue;
        auto* const type = reinterpret_cast<PyTypeObject*>(item.ptr());
        const bool is_exception =
            PyType_IsSubtype(type, reinterpret_cast<PyTypeObject*>(PyExc_BaseException)) != 0;
        if (!is_exception) type->tp_new = refuse_new;
    }
}

namespace {

template <class Error>
void add_error(py::module_& module, const char* name, PyObject* base, const char* text) {
    auto& error = py::register_exception<Error>(module, name, base);
    error.attr("__doc__") = text;
    error.attr("__module__") = "tricontact";
}

}  // namespace

}  // namespace tricontact::python

PYBIND11_MODULE(_core, module) {
    using namespace tricontact;
    namespace py = pybind11;
    module.doc() = "What tricontact has from C++.";
    module.attr("__version__") = files::version;
    python::add_error<contact::InputError>(
        module, "InputError", PyExc_ValueError,
        "Bad input: the text names place, value, rule and remedy.");
    python::add_error<contact::NotConverged>(
        module, "NotConverged", PyExc_RuntimeError,
        "A solver did not reach its tolerance; no number of it is given out.");
    python::add_command(module);
    python::add_case(module);
    python::add_surface(module);
    python::add_history(module);
    python::add_run(module);
    python::add_roll(module);
    python::add_theory(module);
    python::add_atlas(module);
    python::add_walk(module);
    python::add_benchmark(module);
    python::forbid_construction(module);
}
