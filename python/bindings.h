#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <string>

namespace tricontact::python {

// Parts of the module tricontact._core, one per file.
void add_atlas(pybind11::module_& module);
void add_benchmark(pybind11::module_& module);
void add_command(pybind11::module_& module);
void add_case(pybind11::module_& module);
void add_surface(pybind11::module_& module);
void add_history(pybind11::module_& module);
void add_run(pybind11::module_& module);
void add_roll(pybind11::module_& module);
void add_theory(pybind11::module_& module);
void add_walk(pybind11::module_& module);

/// The class of a contact pressed without friction.
template <class Scales>
void add_scales(pybind11::module_& module, const char* name, const char* text) {
    pybind11::class_<Scales>(module, name, text)
        .def_readonly("contact_radius", &Scales::contact_radius, "a [m]")
        .def_readonly("indentation", &Scales::indentation, "d [m]")
        .def_readonly("normal_force", &Scales::normal_force, "F_N [N]")
        .def_readonly("peak_pressure", &Scales::peak_pressure, "p0 [Pa]")
        .def_readonly("unit_shift", &Scales::unit_shift, "U_max [m]");
}

/// What a function of tricontact._toml, in Python, makes of values.
template <class Result, class Values>
Result toml(const char* function, const Values& values) {
    return pybind11::module_::import("tricontact._toml")
        .attr(function)(values)
        .template cast<Result>();
}

/// Throws KeyError that names what there is.
template <class Names>
[[noreturn]] void refuse_key(const std::string& what, const std::string& key, const Names& names) {
    std::string there;
    for (const auto& name : names) there.append(there.empty() ? "" : ", ").append(name);
    throw pybind11::key_error("no " + what + ' ' + key + "; there are " +
                              (there.empty() ? "none" : there));
}

/// Classes whose objects are made here alone: Python gets TypeError where it makes one by itself,
/// also by __new__, which would leave it without its content.
void forbid_construction(const pybind11::module_& module);

/// What a module of the package, in Python, has by this name.
inline pybind11::object in_python(const char* module, const char* name) {
    return pybind11::module_::import((std::string("tricontact.") + module).c_str()).attr(name);
}

/// A method that is written there, as a function of the object.
inline auto passed_on(const char* module, const char* name) {
    return [module, name](const pybind11::object& self, const pybind11::args& args,
                          const pybind11::kwargs& kwargs) {
        return in_python(module, name)(self, *args, **kwargs);
    };
}

/// What json.loads makes of a text.
pybind11::object from_json(const std::string& text);

/// Lets Ctrl-C and other signals through while C++ computes without Python's lock. Asks only so
/// often that other threads, which then hold the lock, do not delay the computation.
class SignalCheck {
  public:
    /// Throws pybind11::error_already_set (KeyboardInterrupt), whether the lock is held or not.
    void operator()();

  private:
    std::chrono::steady_clock::time_point next_{};
};

}  // namespace tricontact::python
