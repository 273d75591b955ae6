#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tricontact::contact {

/// State inside an elastic body, z out of the substrate, on 27-node hexahedra.
struct Interior {
    std::vector<std::array<double, 3>> points;        ///< [m]
    std::vector<std::array<int, 27>> hexes;           ///< VTK's order of a triquadratic hexahedron
    std::vector<std::uint8_t> region;                 ///< per hexahedron: 0 layer, 1 layer below
    std::vector<std::array<double, 3>> displacement;  ///< per point [m]
    std::vector<std::array<double, 6>>
        stress;                          ///< per point, XX YY ZZ XY YZ XZ [Pa], mean of cells
    std::vector<double> energy_density;  ///< per hexahedron [J/m^3]

    // Of the whole body; of both halves of a mirrored one.
    double strain_energy = 0;               ///< [J]
    std::array<double, 3> applied{};        ///< force on the surface [N]
    std::array<double, 3> base_reaction{};  ///< force of the ground (and held sides) [N]
};

}  // namespace tricontact::contact
