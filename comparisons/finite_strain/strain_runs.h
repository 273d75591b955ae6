#pragma once

#include <array>
#include <optional>
#include <vector>

#include "comparisons/half_space/exact_deviation.h"
#include "comparisons/quantities/results.h"
#include "contact/case.h"

namespace tricontact::comparisons {

/// What finite elements know of a contact by the linear law and at finite strains alike.
inline constexpr std::array strain_quantities{
    &quantities::indentation,  &quantities::contact_radius, &quantities::peak_pressure,
    &quantities::static_shift, &quantities::settled_shift,  &quantities::shift_of_rolling};

/// A case whose law is in question.
struct StrainContact {
    contact::Case c;
    DeviationContact contact;  ///< f_T = 0: nothing is shifted
    double amplitude = 0;      ///< w = W/a of the layer that settles; 0: nothing rolls
    double elements = 5;       ///< in the contact radius

    /// The law beside the linear one: the case's, or neo-Hookean.
    contact::Case::Law law() const;
    /// a [m] of the linear layer, exact.
    double contact_radius(double normal_force, double thickness) const;
};

/// The contact of a case. Throws contact::InputError for a case that finite strains are not offered
/// for, or what comparisons::deviation_contact throws.
StrainContact strain_contact(const contact::Case& c, double elements);

/// One load, thickness and tangential force.
struct StrainPoint {
    double normal_force = 0;      ///< F_N [N]
    double thickness = 0;         ///< b [m]
    double tangential_ratio = 0;  ///< f_T [-]
    bool rolled = false;          ///< back and forth by turning points until it settles
    int level = 0;                ///< of refinement

    friend bool operator==(const StrainPoint&, const StrainPoint&) = default;
};

/// Of what rolling changes; all else is known from static runs.
bool is_rolled(const Quantity* q);

/// The case's own load, thickness and tangential force.
StrainPoint own_point(const StrainContact& contact, bool rolled);

/// The points that are computed: F_N/8, F_N/4, ..., 8 F_N by b/4, b/2, b, 2 b; then f_T from 0.15
/// to 0.9 at the case's load and thickness, its own point on a finer mesh, and if the case rolls
/// F_N/4 to 4 F_N rolled at its thickness, its own point on a finer mesh too.
std::vector<StrainPoint> strain_points(const StrainContact& contact);

/// The case of a point, by the linear law or at finite strains; its level only halves the steps of
/// pressing, elements are those of level 0. Both laws have elements of one size: a share of the
/// contact radius, at most a third of the thickness.
contact::Case strain_case(const StrainContact& contact, const StrainPoint& point, bool finite);

/// A point and what both laws gave.
struct StrainPair {
    StrainPoint point;
    ByQuantity<double> linear = {}, finite = {};  ///< undefined where a run failed

    /// Linear over finite strains, minus 1; empty where one of them is undefined.
    std::optional<double> deviation(const Quantity* q) const;
};

/// Those of `strain_quantities` that a run tells; empty if it failed.
ByQuantity<double> strain_values(const std::optional<Results>& results);

}  // namespace tricontact::comparisons
