#pragma once

#include <span>
#include <string>
#include <vector>

#include "contact/case.h"
#include "experiments/assumptions/calculation.h"
#include "experiments/assumptions/check_rig.h"
#include "experiments/assumptions/rolling_rig.h"
#include "theory/layer/elastic_layer.h"
#include "theory/line_contact.h"

// The contact of a rolling rig from its quantities, as several assumptions need it.
namespace tricontact::experiments {

/// R, F_N, E_1, nu_1, E_2, nu_2: what Hertz' contact follows from.
std::vector<Given> hertz_given(const RollingRig& rig);
/// R, F_N, b, E_2, nu_2 of the contact with the layer; the roller is rigid.
std::vector<Given> layer_given(const RollingRig& rig);
/// The same with one more behind.
std::vector<Given> with(std::vector<Given> given, Given one);
/// Either with a cylinder's L behind.
std::vector<Given> with_length(std::vector<Given> given, const RollingRig& rig);

/// Of values in the order of `hertz_given`, at mu = 1.
contact::HalfSpaceScales hertz_of(const std::vector<double>& x);
contact::MaterialPair materials_of(const std::vector<double>& x);
/// Hertz' half width [m] of values in the order of `with_length(hertz_given)`.
double line_half_width_of(const std::vector<double>& x);
/// Of values in the order of `layer_given`, with a length for the line.
theory::LayerContact layer_of(const std::vector<double>& x);
theory::LineContact layer_line_of(const std::vector<double>& x);

/// Half the size of Hertz' contact: radius of a sphere's, half width of a cylinder's [m].
double half_size(const RollingRig& rig);
/// The radius [m] that amplitude ratios of the rig refer to.
statistics::Uncertain reference_radius(const RollingRig& rig);
/// The layer's theory takes the roller as rigid: that is so where the roller has less than 1 % of
/// the compliance, a fifth of what counts as a difference here.
bool roller_is_rigid(const RollingRig& rig);
inline constexpr const char* theory_of_elastic_roller =
    "a theory of the layer under a roller that is not rigid beside it";
/// The printed value of this name, if the rig has it.
const PrintedValue* find_printed(const RollingRig& rig, const char* name);

/// Relative differences up to here count as none: the scatter of repeated runs of such rigs.
inline constexpr double accepted_difference = 0.05;
inline constexpr const char* accepted_reason = "below the scatter of repeated runs";

/// "3.12 %" of a share.
std::string percent_text(double share, int digits = 3);
/// "36.3 % below Hertz", of a quantity over Hertz'.
std::string beside_hertz(double ratio);

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
std::vector<Given> contact_given(const RollingRig& rig, std::vector<Given> given);
/// Of both shapes: the thesis' rule for b/D_c, and both theories of all that is compared.
Assumption half_space_assumption(const RollingRig& rig, Calculation thickness_ratio,
                                 std::span<const ComparedQuantity> compared,
                                 const LayerTheory& theory, std::string consequence);

// The assumptions of a rolling rig, one function each.

Assumption quasi_static_drive(const RollingRig& rig);
Assumption ideal_rolling(const RollingRig& rig);
Assumption half_space(const RollingRig& rig);
Assumption half_space_of_line(const RollingRig& rig);
Assumption long_cylinder(const RollingRig& rig);
Assumption elastic_substrate(const RollingRig& rig);
Assumption uncoupled(const RollingRig& rig, const StaticShift& static_shift);
Assumption fitted_constants(const RollingRig& rig);

/// Whether these are the data of one of the thesis' three rolling rigs (Wetter 2016, tables 5.1.1
/// to 5.1.3): shape, R, b, E_2, mu and F_N. Remarks on the thesis' text are made of no other.
bool is_thesis_rig(const RollingRig& rig);

}  // namespace tricontact::experiments
