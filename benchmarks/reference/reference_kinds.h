#pragma once

#include <memory>

#include "benchmarks/reference/reference.h"
#include "benchmarks/reference/tabled_fields.h"
#include "contact/solvers/control.h"

namespace tricontact::benchmarks {

/// Throws contact::InputError that names the assumption of all references that the case does not
/// meet.
void check_has_reference(const contact::Case& c);

/// What presses the contact at the end of its path.
contact::NormalControl final_normal(const contact::Case& c);
/// The case pressed by `control` alone: no path, no rolling, no tangential load, no coupling.
contact::Case pressed_alone(contact::Case c, const contact::NormalControl& control);

/// Friction and motions leave no tangential traction: what presses at the end decides all.
bool is_frictionless(const contact::Case& c);
/// The normal contact does not depend on friction: no coupling, or no friction.
bool is_uncoupled(const contact::Case& c);
/// Friction would change the pressing, did the case not leave coupling out.
bool would_couple(contact::Case c);
/// A rigid body of revolution on one layer with a rigid ground, or any on a half-space.
bool has_exact_radial_contact(const contact::Case& c);

/// A cylinder on a half-space or, a rigid one, on one layer with a rigid ground.
bool has_exact_line_contact(const contact::Case& c);

/// A cylinder that rolls on over an uncoupled half-space, driven along the rolling without sliding
/// as a whole.
bool has_carter(const contact::Case& c);
/// Fills a reference of that, Carter's (1926) closed form.
void refer_carter(Reference& reference);

/// Fills a reference of frictionless contact of a body of revolution.
void refer_radial(Reference& reference, const contact::ModelRunner& runner);
/// The same of a cylinder, plane strain.
void refer_line(Reference& reference, const contact::ModelRunner& runner);
/// An indenter of a finite size, or a hole: no half-space stands for it.
bool has_finite_body(const contact::Case& c);
/// Fills a reference of bodies of a finite size, pressed or, in plane strain with friction, pulled:
/// finite elements of their section on three meshes. Throws contact::InputError where they roll.
void refer_section(Reference& reference, const contact::ModelRunner& runner);
/// Of all else, by boundary elements on three grids.
void refer_computed(Reference& reference, const contact::ModelRunner& runner);

/// What presses an uncoupled contact, exactly: values in place of the computed ones, the bars of
/// models from the differences; fields, whose tractions are those of `shearing`; effects.
void take_radial_pressing(Reference& reference,
                          const std::shared_ptr<const TabledFields>& shearing);
void take_line_pressing(Reference& reference, const std::shared_ptr<const TabledFields>& shearing);

/// The closed form of a tangential load applied once to uncoupled half-spaces: values where it is
/// exact, else a remark with its difference.
void take_closed_shearing(Reference& reference);
/// The same of a twist about the body's axis.
void take_closed_twist(Reference& reference);

/// What sides at the distances that the case gives change: as bars of the domain.
void add_sides_of_case(Reference& reference);

/// Terms of the second order of displaced kinematics over the first, per slope of the profile at
/// the contact's edge: what runs on the displaced surface differ by (0.8 to 2 at slopes of 0.04 to
/// 0.11).
inline constexpr double second_order_of_slope = 2.2;

/// Derivative of a function from its values at -2, -1, 1 and 2 steps of this length; the bar is
/// what both central differences differ by.
ReferenceValue central_difference(double step, double minus_2, double minus_1, double plus_1,
                                  double plus_2);

}  // namespace tricontact::benchmarks
