#pragma once

#include <array>
#include <cmath>

namespace tricontact::contact {

/// What is prescribed normal to the surface.
struct NormalControl {
    enum class Kind { force, indentation };
    Kind kind = Kind::force;
    double value = 0;  ///< F_N [N], compression positive, or d [m]

    bool operator==(const NormalControl&) const = default;
};

/// What is prescribed in one tangential direction.
struct TangentialControl {
    enum class Kind { force, shift, ratio };
    Kind kind = Kind::force;
    /// Force on the substrate [N], rigid shift of the indenter [m], or force on the substrate over
    /// mu F_N of the same step [-], which coupled contact under a prescribed depth has to find.
    double value = 0;

    bool operator==(const TangentialControl&) const = default;
};

/// Magnitude of the tangential forces that are prescribed, by x and y [N].
inline double prescribed_force(const std::array<TangentialControl, 2>& controls) {
    double force = 0;
    for (const TangentialControl& control : controls)
        if (control.kind == TangentialControl::Kind::force)
            force = std::hypot(force, control.value);
    return force;
}

}  // namespace tricontact::contact
