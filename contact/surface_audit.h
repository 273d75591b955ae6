#pragma once

#include <array>
#include <vector>

#include "contact/compliances/compliance.h"
#include "contact/history.h"
#include "contact/load_path.h"
#include "contact/solvers/normal_solver.h"
#include "contact/surface.h"

namespace tricontact::contact {

/// Allowed error of a force balance, over the force.
constexpr double exact_force = 1e-9;

/// Of what holds but for rounding.
constexpr double rounding_allowed = 1e-12;

/// p >= 0, gap >= 0, p gap = 0, force prescribed: from the fields, not from the solver's word.
void audit_normal(const NormalSolution& solution, const NormalControl& control,
                  const std::vector<double>& area, double tolerance, Audit& audit,
                  int n_threads = 1);

struct TangentialFacts {
    const std::vector<double>& bound;  ///< see FrictionLaw [Pa]
    const std::vector<double>& area;   ///< [m^2]
    const TangentialField& traction;   ///< on the substrate [Pa]
    const TangentialField& slip;       ///< indenter over substrate in this step [m]
    const std::vector<ContactState>& contact_state;
    std::array<TangentialControl, 2> control;
    double length;                             ///< what slips are compared with [m], mu d
    double excess_allowed = rounding_allowed;  ///< of traction above the bound, over its mean
    int n_threads = 1;
};
/// Friction bound, no slip where it sticks, slip along the traction where it slips, forces.
void audit_tangential(const TangentialFacts& facts, double tolerance, Audit& audit);

}  // namespace tricontact::contact
