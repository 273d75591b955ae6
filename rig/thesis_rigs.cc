#include "rig/thesis_rigs.h"

#include <algorithm>
#include <cmath>

namespace tricontact::rig {

namespace {

using contact::RollingRig;

struct ThesisRig {
    RollingRig::Shape shape;
    double radius, thickness, young, friction_coefficient, normal_force;  // SI
};

constexpr ThesisRig thesis_rigs[] = {
    {RollingRig::Shape::sphere, 40e-3, 8e-3, 5.2e6, 0.57, 21.1},     // table 5.1.1
    {RollingRig::Shape::sphere, 40e-3, 8e-3, 4.35e6, 0.93, 21.19},   // table 5.1.2
    {RollingRig::Shape::cylinder, 40e-3, 5e-3, 3.6e6, 0.79, 32.3}};  // table 5.1.3

bool same(const contact::Uncertain& given, double value) {
    return std::abs(given.value / value - 1) < 1e-9;  // rounding of units
}

}  // namespace

bool is_thesis_rig(const RollingRig& rig) {
    return std::ranges::any_of(thesis_rigs, [&](const ThesisRig& one) {
        return rig.roller.shape == one.shape && same(rig.roller.radius, one.radius) &&
               same(rig.substrate.thickness, one.thickness) &&
               same(rig.substrate.young, one.young) &&
               same(rig.friction_coefficient, one.friction_coefficient) &&
               same(rig.normal_force, one.normal_force);
    });
}

}  // namespace tricontact::rig
