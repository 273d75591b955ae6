#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <string>

#include "app/benchmark/benchmark_case.h"
#include "python/bindings.h"

namespace tricontact::python {

namespace py = pybind11;
using benchmarks::Reference;
using benchmarks::ReferenceValue;
using benchmarks::SurfaceValues;
using contact::Case;

namespace {

using Numbers = py::array_t<double, py::array::forcecast>;

Reference make_reference(const Case& c, int threads) {
    if (threads < 1) throw py::value_error("threads: must be at least 1");
    const py::gil_scoped_release free_the_lock;
    SignalCheck check_signals;
    return app::reference_of_case(c, threads, [&](const std::string&) { check_signals(); });
}

py::dict in_parts(const ReferenceValue& value) {
    py::dict parts;
    parts["value"] = value.value;
    parts["bar"] = value.bar();
    parts["grid"] = value.grid;
    parts["model"] = value.model;
    parts["domain"] = value.domain;
    parts["source"] = value.source;
    return parts;
}

py::dict in_parts(const std::map<std::string, ReferenceValue>& values) {
    py::dict all;
    for (const auto& [key, value] : values) all[py::str(key)] = in_parts(value);
    return all;
}

py::dict effects(const Reference& reference) {
    py::dict all;
    const auto add = [&all](const char* name, const std::optional<ReferenceValue>& value) {
        if (value) all[name] = in_parts(*value);
    };
    add("normal_compliance", reference.effects.normal_compliance);
    add("tangential_compliance", reference.effects.tangential_compliance);
    add("displaced_surface", reference.effects.displaced_surface);
    return all;
}

const char* geometry(const Reference& reference) {
    constexpr const char* names[] = {"axisymmetric", "plane", "spatial"};
    return names[static_cast<int>(reference.geometry)];
}

using At = SurfaceValues (benchmarks::ReferenceFields::*)(double, double) const;

/// Components of the fields, or of their bars, at points: one as an array of their shape, several
/// along a last axis.
template <std::size_t n>
auto components(At at, const std::array<double SurfaceValues::*, n>& members) {
    return [at, members](const Reference& reference, const Numbers& x, const Numbers& y) {
        py::list columns;
        for (const auto member : members)
            columns.append(py::vectorize([&](double at_x, double at_y) {
                return (*reference.fields.*at)(at_x, at_y).*member;
            })(x, y));
        if (n == 1) return py::object(columns[0]);
        return py::object(
            py::module_::import("numpy").attr("stack")(columns, py::arg("axis") = -1));
    };
}

py::object mean_pressure(const Reference& reference, const Numbers& x, const Numbers& y,
                         const Numbers& area) {
    return py::vectorize([&](double at_x, double at_y, double over) {
        return benchmarks::mean_values(*reference.fields, at_x, at_y, over).pressure;
    })(x, y, area);
}

py::object load_within(const Reference& reference, const Numbers& r) {
    return py::vectorize([&](double at) { return reference.fields->load_within(at); })(r);
}

}  // namespace

void add_benchmark(py::module_& module) {
    constexpr At value = &benchmarks::ReferenceFields::at,
                 bar = &benchmarks::ReferenceFields::bar_at;
    const auto x = py::arg("x");
    const auto y = py::arg("y") = 0.;
    py::class_<Reference> kind(module, "BenchmarkReference",
                               "The best that is known of the end of a case's path.");
    kind.def_property_readonly(
            "values", [](const Reference& r) { return in_parts(r.values); },
            "Of each quantity value, bar and its parts, source; SI units.")
        .def_property_readonly("effects", effects,
                               "What small changes of the interface do, to first order.")
        .def_property_readonly("geometry", geometry, "\"axisymmetric\", \"plane\" or \"spatial\".")
        .def_readonly("contact_radius", &Reference::contact_radius, "a [m]")
        .def_readonly("prescribed", &Reference::prescribed, "Quantities that the case prescribes.")
        .def_readonly("models", &Reference::models, "That stand behind it.")
        .def_readonly("remarks", &Reference::remarks, "What it leaves out.")
        .def_readonly("digest", &Reference::digest, "Of the case.")
        .def("mean_pressure", mean_pressure, py::arg("x"), py::arg("y"), py::arg("area"),
             "p [Pa], mean over squares of the given areas [m^2] about points [m].")
        .def("load_within", load_within, py::arg("r"), "Force within the distance r [N].");
    const auto add_field = [&](const char* name, const auto& members, const char* text) {
        kind.def(name, components(value, members), x, y, text);
        kind.def((std::string(name) + "_bar").c_str(), components(bar, members), x, y,
                 "Half widths of the same.");
    };
    add_field("pressure", std::array{&SurfaceValues::pressure},
              "p [Pa] at points, compression > 0.");
    add_field("traction", std::array{&SurfaceValues::traction_x, &SurfaceValues::traction_y},
              "t_x, t_y [Pa] on the elastic body, along the last axis.");
    add_field("displacement",
              std::array{&SurfaceValues::displacement_x, &SurfaceValues::displacement_y,
                         &SurfaceValues::displacement_z},
              "u_x, u_y, u_z [m], z into the body, along the last axis; NaN: not known.");
    module.def("_reference", make_reference, py::arg("case"), py::arg("threads"));
}

}  // namespace tricontact::python
