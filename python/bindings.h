#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/history.h"
#include "contact/surface.h"

namespace tricontact::python {

// Parts of the module tricontact._core, one per file.
void add_case(pybind11::module_& module);
void add_surface(pybind11::module_& module);
void add_history(pybind11::module_& module);
void add_run(pybind11::module_& module);
void add_roll(pybind11::module_& module);
void add_theory(pybind11::module_& module);
void add_walk(pybind11::module_& module);

/// A dictionary as the text of a TOML file: its dictionaries are tables. Throws
/// pybind11::type_error for values that TOML has not.
std::string toml_text(const pybind11::dict& values);
/// A value as it stands behind a key in TOML. Throws pybind11::type_error.
std::string toml_value(const pybind11::handle& value);

/// What json.loads makes of a text.
pybind11::object from_json(const std::string& text);

/// The case with these models, if any, instead of its own, checked as a case file that names them.
contact::Case with_models(const contact::Case& c,
                          const std::optional<std::vector<std::string>>& models);
/// As asked for, or all cores. Throws pybind11::value_error.
int thread_count(std::optional<int> threads);

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
