#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "contact/base/bulk_state.h"
#include "contact/base/vector2.h"

namespace tricontact::contact {

/// State inside an elastic body, z out of the substrate, at the points of 27-node hexahedra or of a
/// rectilinear grid.
struct Interior {
    std::vector<std::array<double, 3>> points;  ///< of elements [m]; empty on a grid
    std::vector<std::array<int, 27>> hexes;     ///< VTK's order of a triquadratic hexahedron
    std::vector<std::uint8_t> region;           ///< per hexahedron: 0 layer, 1 layer below
    /// Of a grid: coordinates [m], increasing; points are their products, x fastest, then y.
    std::array<std::vector<double>, 3> axes;
    std::vector<std::array<double, 3>> displacement;  ///< per point [m]
    std::vector<std::array<double, 6>>
        stress;                          ///< per point, XX YY ZZ XY YZ XZ [Pa], mean of cells
    std::vector<double> energy_density;  ///< per hexahedron [J/m^3]

    // Of the whole body; of both halves of a mirrored one.
    double strain_energy = 0;         ///< [J]
    std::array<double, 3> applied{};  ///< force on the surface [N]
    /// Force of the ground (and held sides) [N], where it was computed.
    std::optional<std::array<double, 3>> base_reaction;

    double missing_force() const;  ///< |applied + base_reaction| [N]; the latter is there
    double applied_force() const;  ///< |applied| [N]

    bool is_grid() const { return !axes[0].empty(); }
    std::size_t size() const { return stress.size(); }
    std::array<double, 3> position(std::size_t i) const;
};

/// sqrt(3 J2) [Pa] of XX YY ZZ XY YZ XZ.
double von_mises(const std::array<double, 6>& stress);
/// -(XX + YY + ZZ)/3 [Pa], compression positive.
double mean_pressure(const std::array<double, 6>& stress);

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
    std::size_t axis() const {
        const auto nearer = [](double a, double b) { return std::abs(a) < std::abs(b); };
        return std::min_element(x.begin(), x.end(), nearer) - x.begin();
    }
    const std::array<double, 6>& at(std::size_t i_x, std::size_t i_z) const {
        return stress[i_z * x.size() + i_x];
    }
};

/// Together with a uniform stress in all of the body.
std::unique_ptr<const Interior> with_bulk(const Interior& interior, const BulkState& bulk);

/// Of the fields inside under an indenter at `offset` [m].
Subsurface subsurface_of(const Interior& interior, double phase, const Vector2& offset);

}  // namespace tricontact::contact
