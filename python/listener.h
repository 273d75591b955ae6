#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <ostream>
#include <string>

#include "runs/options.h"

namespace tricontact::python {

/// Hands a command's lines and counts to Python, whose lock is taken for each. What these functions
/// raise ends the command. All have to live as long as it.
inline std::shared_ptr<const runs::Listener> listener_of(std::ostream& out,
                                                         const pybind11::object& say,
                                                         const pybind11::object& progress) {
    return std::make_shared<runs::Listener>(
        runs::Listener{.out = &out,
                       .say =
                           [&](const std::string& line) {
                               const pybind11::gil_scoped_acquire lock;
                               say(line);
                           },
                       .progress =
                           [&](const std::string& what, int done, int total) {
                               const pybind11::gil_scoped_acquire lock;
                               progress(what, done, total);
                           }});
}

}  // namespace tricontact::python
