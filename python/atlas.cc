#include "atlas/atlas.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>

#include "atlas/atlas_file.h"
#include "atlas/shipped.h"
#include "io/case/case_keys.h"
#include "python/bindings.h"

namespace tricontact::python {

namespace py = pybind11;
using atlas::Atlas;
using atlas::Axis;

namespace {

using Coordinates = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<std::string> quantities_of(const Atlas& atlas) {
    std::vector<std::string> keys;
    for (const atlas::Map& map : atlas.maps) keys.emplace_back(map.quantity->key);
    return keys;
}

const atlas::Map& map_of(const Atlas& atlas, const std::string& quantity) {
    for (const atlas::Map& map : atlas.maps)
        if (quantity == map.quantity->key) return map;
    throw py::value_error("atlas " + atlas.name + " has no quantity " + quantity);
}

/// Throws OutsideDomain for the first point without a value.
void refuse_unsaid(const Atlas& atlas, const atlas::Map& map, std::span<const double> points,
                   const atlas::Values& found) {
    const auto unsaid = std::ranges::find_if(found.values, [](double v) { return std::isnan(v); });
    if (unsaid == found.values.end()) return;
    const std::size_t n_axes = atlas.axes.size();
    const auto place = static_cast<std::size_t>(unsaid - found.values.begin());
    atlas::Reader reader(atlas);
    reader.go_to(points.subspan(place * n_axes, n_axes));
    atlas::said(atlas, map, reader.read(map));
}

/// Values and errors at points, a row of coordinates each. Outside of the domain NaN, or the
/// refusal of the first such point.
py::tuple read(const Atlas& atlas, const std::string& quantity, const Coordinates& points,
               bool refuse) {
    constexpr std::size_t at_once = 100'000;  // some hundred milliseconds between two signals
    const atlas::Map& map = map_of(atlas, quantity);
    const std::size_t n_axes = atlas.axes.size();
    const std::span all(points.data(), static_cast<std::size_t>(points.size()));
    py::array_t<double> values(points.size() / static_cast<py::ssize_t>(n_axes));
    py::array_t<double> errors(values.size());
    double *value = values.mutable_data(), *error = errors.mutable_data();
    {
        const py::gil_scoped_release free_the_lock;
        SignalCheck check_signals;
        for (std::size_t i = 0; i < all.size(); i += at_once * n_axes) {
            const auto part = all.subspan(i, std::min(at_once * n_axes, all.size() - i));
            const atlas::Values found = atlas::read_all(atlas, map, part);
            if (refuse) refuse_unsaid(atlas, map, part, found);
            value = std::ranges::copy(found.values, value).out;
            error = std::ranges::copy(found.errors, error).out;
            check_signals();
        }
    }
    return py::make_tuple(values, errors);
}

void add_axis(py::module_& module) {
    py::class_<Axis>(module, "Axis", "A coordinate of an atlas: a key of case files.")
        .def_readonly("key", &Axis::key, "\"rolling.amplitude_ratio\"")
        .def_property_readonly(
            "name", [](const Axis& axis) { return axis.key.substr(axis.key.rfind('.') + 1); },
            "Its last word, by which Atlas.evaluate knows it: \"amplitude_ratio\"")
        .def_property_readonly(
            "unit",
            [](const Axis& axis) {
                return std::string(io::si_unit(io::find_key(axis.key)->dimension));
            },
            "SI unit: \"1\" of ratios, \"rad\" of angles")
        .def_property_readonly(
            "range", [](const Axis& axis) { return std::pair(axis.from, axis.to); },
            "Least and largest value, in that unit")
        .def("__repr__", [](const Axis& axis) { return "<Axis " + axis.key + '>'; });
}

}  // namespace

void add_atlas(py::module_& module) {
    add_axis(module);
    py::class_<Atlas>(module, "AtlasMaps", "What tricontact.atlas.Atlas reads.")
        .def_readonly("name", &Atlas::name)
        .def_readonly("title", &Atlas::title)
        .def_readonly("model", &Atlas::model)
        .def_readonly("study", &Atlas::study)
        .def_readonly("version", &Atlas::version)
        .def_readonly("points", &Atlas::n_points)
        .def_readonly("axes", &Atlas::axes)
        .def_property_readonly("quantities", quantities_of)
        .def("read", read, py::arg("quantity"), py::arg("points"), py::arg("refuse"));
    module.def("_atlas_names", [] {
        const auto names = atlas::shipped_names();
        return std::vector<std::string>(names.begin(), names.end());
    });
    module.def("_shipped_atlas", atlas::shipped, py::arg("name"),
               py::return_value_policy::reference);
    module.def("_read_atlas", atlas::read_atlas, py::arg("path"));
}

}  // namespace tricontact::python
