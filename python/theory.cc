#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <limits>

#include "comparisons/half_space/layer.h"
#include "contact/base/error.h"
#include "python/bindings.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/creep_law.h"
#include "theory/hertz.h"
#include "theory/layer/elastic_layer.h"
#include "theory/rolling/kalker.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::python {

namespace py = pybind11;
using contact::Case;
using contact::HalfSpaceScales;
using theory::LayerContact;

namespace {

using Numbers = py::array_t<double, py::array::forcecast>;

double settled_shift_ratio(double w, double f, double kappa) {
    return theory::settled_shift_ratio(w, f, kappa)
        .value_or(std::numeric_limits<double>::quiet_NaN());
}

/// A function of an object and one number, for arrays of numbers.
template <class T>
auto over_numbers(double (*function)(const T&, double)) {
    return [function](const T& object, const Numbers& x) {
        return py::vectorize([&](double value) { return function(object, value); })(x);
    };
}

LayerContact layer_contact(const Case& c) {
    if (!c.layer.thickness)
        throw contact::InputError(
            "substrate.thickness: missing: without it there is no layer; give one");
    const auto contact = comparisons::exact_layer_contact(c);
    if (!contact)
        throw contact::InputError("no exact theory: " + comparisons::why_no_exact_theory(c));
    return *contact;
}

void add_half_space(py::module_& m) {
    m.def("hertz_pressure", over_numbers(theory::hertz_pressure), py::arg("scales"), py::arg("r"),
          "Pressure p(r) [Pa] of Hertz' contact. Johnson (1985), eq. 3.39.");
    m.def("hertz_surface_displacement", over_numbers(theory::hertz_surface_displacement),
          py::arg("scales"), py::arg("r"),
          "Displacement u_z(r) [m] of the surface. Johnson (1985), eq. 3.41a, 3.42a.");
    m.def("stick_radius_ratio", py::vectorize(theory::stick_radius_ratio), py::arg("f"),
          "c/a of Cattaneo and Mindlin at f = F_T/(mu F_N). Johnson (1985), eq. 7.40.");
    m.def("cattaneo_mindlin_traction", py::vectorize(theory::cattaneo_mindlin_traction),
          py::arg("rho"), py::arg("f"), "tau/(mu p0) at rho = r/a. Johnson (1985), section 7.2d.");
    m.def("static_shift_ratio", py::vectorize(theory::static_shift_ratio), py::arg("f"),
          "U/U_max after F_T: 1 - (1 - f)^(2/3). Johnson (1985), eq. 7.42b.");
}

void add_rolling(py::module_& m) {
    const auto kappa = py::arg("kappa") = theory::mdr_mapping;
    m.def("settled_shift_ratio", py::vectorize(settled_shift_ratio), py::arg("w"), py::arg("f"),
          kappa,
          "U_sd/U_max after shakedown, w = W/a; NaN where it ratchets. Wetter (2016), 3.2.16.");
    m.def("mapping_parameter", py::vectorize(theory::mapping_parameter), py::arg("w"), py::arg("f"),
          py::arg("u"), "kappa of a settled shift u. Wetter (2016), 3.2.16.");
    m.def("shakedown_limit",
          py::vectorize(py::overload_cast<double, double>(theory::shakedown_limit)), py::arg("w"),
          kappa, "Largest f that shakes down. Wetter (2016), 3.2.17.");
    m.def("amplitude_limit",
          py::vectorize(py::overload_cast<double, double>(theory::amplitude_limit)), py::arg("f"),
          kappa, "Largest w that shakes down.");
    m.def("mdr_threshold_slope", py::vectorize(theory::mdr_threshold_slope), py::arg("f"),
          "Slope of the shift per period over w just beyond the limit.");
    m.def("mdr_shakedown_traction", py::vectorize(theory::mdr_shakedown_traction), py::arg("rho"),
          py::arg("w"), py::arg("u"), "tau/(mu p0) at rho = r/a after shakedown.");
}

void add_creep(py::module_& m) {
    m.def("carter_creepage_ratio", py::vectorize(theory::carter_creepage_ratio), py::arg("f"),
          "xi R/(mu a) of rolling cylinders: 1 - sqrt(1 - f). Johnson (1985), eq. 8.48.");
    m.def("carter_force_ratio", py::vectorize(theory::carter_force_ratio),
          py::arg("creepage_ratio"), "Its inverse, f of xi R/(mu a); 1 where all slides.");
    m.def("carter_stick_ratio", py::vectorize(theory::carter_stick_ratio), py::arg("f"),
          "Half width c/a of the stick zone. Johnson (1985), eq. 8.46.");
    m.def("carter_traction", py::vectorize(theory::carter_traction), py::arg("x"), py::arg("f"),
          "tau/(mu p0) at x/a. Johnson (1985), eq. 8.45.");
    using theory::KalkerCoefficients;
    py::class_<KalkerCoefficients>(m, "KalkerCoefficients", "Of Kalker's linear theory.")
        .def_readonly("longitudinal", &KalkerCoefficients::longitudinal, "C11")
        .def_readonly("lateral", &KalkerCoefficients::lateral, "C22")
        .def_readonly("spin", &KalkerCoefficients::spin, "C23 = -C32")
        .def_readonly("moment", &KalkerCoefficients::moment, "C33");
    m.def("kalker_coefficients", theory::kalker_coefficients, py::arg("axes_ratio"),
          py::arg("poisson"), "For half axes a along the rolling over b across. Kalker's table.");
}

void add_layer(py::module_& m) {
    using Function = double (*)(const LayerContact&, double);
    py::class_<LayerContact>(m, "LayerContact",
                             "Exact frictionless contact of a rigid body with an elastic layer.")
        .def_readonly("contact_radius", &LayerContact::contact_radius, "a [m]")
        .def_readonly("indentation", &LayerContact::indentation, "d [m]")
        .def_readonly("normal_force", &LayerContact::normal_force, "F_N [N]")
        .def_readonly("normal_stiffness", &LayerContact::normal_stiffness, "dF_N/dd [N/m]")
        .def_readonly("centre_pressure", &LayerContact::centre_pressure, "p(0) [Pa]")
        .def_readonly("unit_shift", &LayerContact::unit_shift,
                      "U_max/mu [m]; None on a frictionless base.")
        .def("pressure", over_numbers<LayerContact>([](const LayerContact& contact, double r) {
                 return contact.pressure(r);
             }),
             py::arg("r"), "p(r) [Pa]")
        .def("shakedown_limit", over_numbers(static_cast<Function>(theory::shakedown_limit)),
             py::arg("w"), "Largest F_T/(mu F_N) that shakes down at w = W/a, uncoupled.")
        .def("amplitude_limit", over_numbers(static_cast<Function>(theory::amplitude_limit)),
             py::arg("f"), "Largest w that shakes down at f = F_T/(mu F_N), uncoupled.");
    m.def("layer_contact", layer_contact, py::arg("case"),
          "The layer of a case pressed by its indenter.\n\n"
          "Raises InputError where the theory does not cover the case.");
}

}  // namespace

void add_theory(py::module_& module) {
    add_half_space(module);
    add_rolling(module);
    add_creep(module);
    add_layer(module);
}

}  // namespace tricontact::python
