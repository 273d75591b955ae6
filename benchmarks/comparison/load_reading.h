#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/contact_reach.h"

namespace tricontact::benchmarks {

/// What the numbers of a normal load are.
struct LoadReading {
    bool is_force = false;  ///< nodal forces instead of tractions
    double unit = 1;        ///< [Pa] or [N]
    std::string unit_name;  ///< "MPa"
    double share = 1;       ///< of the whole contact that sums of nodal forces are
    std::string share_name = {};
    double sign = 1;             ///< -1: tension is positive in the file
    double resultant_ratio = 0;  ///< of the whole contact over the reference's force
    double peak_ratio = 0;       ///< of the largest pressure
};

/// Points of a mesh with the areas that they stand for in the modelled part [m^2]: `weights` sum to
/// an integral, `lumped` are positive.
struct WeightedField {
    const LaidOutField* laid_out = nullptr;
    std::vector<double> x, y;             ///< [m], as in the file
    std::vector<double> low, high;        ///< of profiles [m]
    std::vector<double> weights, lumped;  ///< [m^2], [m] of plane contacts
    Faces faces;
};

/// Positions in metres, and areas: from a column, faces, or the points themselves.
WeightedField weighted_field(const LaidOutField& field, const ContactReach& reach);

/// Kind, unit, share and sign, over all meshes together: the resultant and the largest pressure
/// have to be those of the reference, as nearly as any reading makes them. `forces`: given
/// resultants [N or as written], which a share has to explain, too. Throws contact::InputError
/// where two readings do equally well (with both), or none comes near.
LoadReading load_reading(const std::vector<WeightedField>& fields, const ContactReach& reach,
                         const Reference& reference);

/// What a resultant in a file is of the whole contact's.
struct ForceReading {
    double factor = 1;  ///< whole in N over the number as given
    double share = 1;   ///< whole over the part that was modelled
    std::string text;   ///< "N, of a sector of 2 degrees"
    double ratio = 1;   ///< of the whole to what it is compared with
    bool is_plain = true;
};

/// From the force that the field carries, if there is one, and the reference's. Throws
/// contact::InputError where no unit and share come near.
ForceReading force_reading(const Total& total, const std::string& what, double reference_force,
                           std::optional<double> field_force, const ContactReach& reach,
                           Geometry geometry);

}  // namespace tricontact::benchmarks
