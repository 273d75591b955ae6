#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.h"

namespace tricontact::benchmarks {

/// What the way in which a code enforces contact explains of a quantity's difference, to first
/// order (FirstOrderEffects), over the reference's value: normal penalty, elastic slip, gap on the
/// displaced surface, pressing in one step, the deck's block. Nothing that the submission does not
/// say. Bars: that of the reference's derivative, and what the first order leaves out: the square
/// of the change for penalties; two fifths of (a/R)^2 for the displaced surface, which GetFEM's
/// runs with and without it stay within at three depths. Peak pressure and contact radius: see
/// explained_pressing.h, also for `strain_of_area`.
std::vector<Explained> explained(const std::string& key, const Submission& submission,
                                 const Reference& reference, double strain_of_area = 0);

/// Slope h'(a) of the indenter at the contact's edge [-]: a/R of a paraboloid. The size of what
/// kinematics change.
double edge_slope(const Reference& reference);

/// What springs of a method [Pa/m] yield beyond those of the case's interface, 1/K - 1/k_n or 1/K_T
/// - 1/k_t [m/Pa]; 0 without any: a penalty that the case has is part of the problem.
double added_compliance(const std::optional<double>& stiffness,
                        const std::optional<double>& of_interface);

/// Change of the normal force by contact on the displaced surface, over the force; empty where it
/// is not known. Also for those who do not say how they do it.
std::optional<Explained> displaced_surface(const std::string& key, const Reference& reference);

}  // namespace tricontact::benchmarks
