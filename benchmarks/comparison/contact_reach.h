#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/surface_layout.h"

namespace tricontact::benchmarks {

/// Unit of length, and how much of the contact was modelled.
struct ContactReach {
    double unit = 1;  ///< [m]
    std::string unit_name = "m";
    int parts_x = 1, parts_y = 1;       ///< 2: half of the contact along this axis
    double ratio = 1;                   ///< of the field's reach to that of the reference
    double centre_x = 0, centre_y = 0;  ///< of the contact, in the file's unit
    int parts() const { return parts_x * parts_y; }
};

/// A field with its layout and its normal load, of any sign.
struct LaidOutField {
    const MeshField* field = nullptr;
    SurfaceLayout layout;
    const FieldColumn* normal = nullptr;
};

/// How far the reference's pressure reaches along x or y [m].
double reference_reach(const Reference& reference, bool along_y);

/// From the reach of all meshes together. Throws contact::InputError where no unit makes it the
/// reference's within half of it: message with the nearest.
ContactReach contact_reach(const std::vector<LaidOutField>& fields, const Reference& reference);

}  // namespace tricontact::benchmarks
