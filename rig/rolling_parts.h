#pragma once

#include <span>
#include <string>
#include <vector>

#include "rig/check_rig.h"

namespace tricontact::rig {

/// A quantity of the contact, by both theories: of values in the order of `hertz_given` and of
/// `layer_given`, of a cylinder with L behind.
struct ComparedQuantity {
    const char *name, *symbol, *formula, *source, *unit;
    double (*half_space)(const std::vector<double>&);
    double (*layer)(const std::vector<double>&);
};
struct LayerTheory {
    const char *formula, *source;
};
/// Either with a cylinder's L behind.
std::vector<Given> contact_given(const contact::RollingRig& rig, std::vector<Given> given);
/// Of both shapes: the thesis' rule for b/D_c, and both theories of all that is compared.
Assumption half_space_assumption(const contact::RollingRig& rig, Calculation thickness_ratio,
                                 std::span<const ComparedQuantity> compared,
                                 const LayerTheory& theory, std::string consequence);

// The assumptions of a rolling rig, one function each.

Assumption quasi_static_drive(const contact::RollingRig& rig);
Assumption ideal_rolling(const contact::RollingRig& rig);
Assumption half_space(const contact::RollingRig& rig);
Assumption half_space_of_line(const contact::RollingRig& rig);
Assumption long_cylinder(const contact::RollingRig& rig);
Assumption elastic_substrate(const contact::RollingRig& rig);
Assumption uncoupled(const contact::RollingRig& rig, const StaticShift& static_shift);
Assumption fitted_constants(const contact::RollingRig& rig);

}  // namespace tricontact::rig
