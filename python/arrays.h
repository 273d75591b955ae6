#pragma once

#include <pybind11/numpy.h>

#include <vector>

namespace tricontact::python {

/// Numbers that `owner` has, seen as a NumPy array without a copy: it keeps the owner alive, and
/// cannot be written to. `strides` in bytes.
template <class T>
pybind11::array view(const T* data, std::vector<pybind11::ssize_t> shape,
                     std::vector<pybind11::ssize_t> strides, pybind11::handle owner) {
    pybind11::array array(pybind11::dtype::of<T>(), std::move(shape), std::move(strides), data,
                          owner);
    array.attr("setflags")(pybind11::arg("write") = false);
    return array;
}

/// The same of a vector.
inline pybind11::array view(const std::vector<double>& values, pybind11::handle owner) {
    return view(values.data(), {static_cast<pybind11::ssize_t>(values.size())}, {sizeof(double)},
                owner);
}

}  // namespace tricontact::python
