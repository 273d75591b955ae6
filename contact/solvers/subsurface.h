#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/solvers/interior.h"
#include "contact/vector2.h"

namespace tricontact::contact {

/// What is kept of the inside of the substrate in one state: where von Mises' stress is largest,
/// and a section across the contact. z out of the substrate, 0 at its surface.
struct Subsurface {
    double phase = 0;                       ///< rolling periods since the start
    double peak_von_mises = 0;              ///< largest at any point [Pa]
    std::array<double, 3> peak_position{};  ///< of that point, from the indenter's centre [m]
    /// The plane of points nearest to y of the indenter: coordinates from its centre [m],
    /// increasing, and stresses, x fastest. Empty where its points form no grid.
    std::vector<double> x, z;
    std::vector<std::array<double, 6>> stress;  ///< XX YY ZZ XY YZ XZ [Pa]

    /// Index of the points below the indenter's centre: the x nearest to it.
    std::size_t axis() const;
    const std::array<double, 6>& at(std::size_t i_x, std::size_t i_z) const {
        return stress[i_z * x.size() + i_x];
    }
};

/// Of the fields inside under an indenter at `offset` [m].
Subsurface subsurface_of(const Interior& interior, double phase, const Vector2& offset);

}  // namespace tricontact::contact
