#pragma once

#include <Eigen/Dense>
#include <vector>

#include "contact/case.h"
#include "theory/springs/abel_elements.h"
#include "theory/springs/abel_layer.h"

namespace tricontact::theory {

/// p/k_n + u = d - r^2/(2 R) with radii over a, heights over a^2/R, g over E* a^2/R and the force
/// over E* a^3/R: a function of E*/(k_n a).
struct UnitPress {
    Eigen::VectorXd g;
    double force = 0, indentation = 0;
};
/// `layer`: of the body, if it is one.
UnitPress unit_press(const AbelElements& on, double softness,
                     const LayerCorrection* layer = nullptr);

/// What is pressed: a half-space, or a layer and the radius of the contact over its thickness.
struct PressedBody {
    AbelLayer* layer = nullptr;
    double ratio = 0;
};

/// Shifts over forces under a law, each of a radius of stick from 0 to the contact's.
struct SprungCurve {
    std::vector<double> forces, shifts;
};

/// F_T/a^2 [Pa] and U [m] of a contact pressed by F_N/a^2 = `mean` [Pa]. `softness`: E*/(k_n a);
/// `springs`, `bodies`: 1/k_t and a/G* [m/Pa].
SprungCurve sprung_curve(const contact::Friction& friction, double softness, double mean,
                         double springs, double bodies, const PressedBody& body = {});

/// Coulomb's, F_T/(mu F_N) and U G* a/(mu F_N), by the softness E*/(k_n a) and G*/(k_t a) [-], 0:
/// rigid. Interpolated between curves that are computed when first needed: 1e-5 of the shift.
SprungCurve coulomb_sprung_curve(double softness, double tangential_softness);
/// A shear strength's, F_T/(tau_0 a^2) and U G*/(tau_0 a), which the pressure has no part in.
SprungCurve strength_sprung_curve(double tangential_softness);

}  // namespace tricontact::theory
