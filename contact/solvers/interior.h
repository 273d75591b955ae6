#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

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

    bool is_grid() const { return !axes[0].empty(); }
    std::size_t size() const { return stress.size(); }
    std::array<double, 3> position(std::size_t i) const;
};

/// sqrt(3 J2) [Pa] of XX YY ZZ XY YZ XZ.
double von_mises(const std::array<double, 6>& stress);
/// -(XX + YY + ZZ)/3 [Pa], compression positive.
double mean_pressure(const std::array<double, 6>& stress);

}  // namespace tricontact::contact
