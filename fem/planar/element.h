#pragma once

#include <array>

#include "fem/element.h"
#include "fem/planar/mesh.h"

// The element Q2/P1 of fem/element.h in two dimensions: nine nodes, whose edges may be curved, and
// the volumetric strain projected onto {1, x, z}.

namespace tricontact::fem::planar {

/// What a section stands for: a slice of unit length along y that cannot strain along y, or a body
/// of revolution about x = 0.
enum class Solid { plane_strain, of_revolution };

/// Extent normal to the section: 1 per metre, or the circumference 2 pi x [m].
double extent(Solid solid, double x);

/// Unknown of node i in direction a (0 x, 1 z): a * 9 + i.
inline constexpr int n_element_unknowns = 18;
using ElementNodes = std::array<Point, 9>;
/// [N/m], of plane strain per length along y [N/m^2].
using ElementStiffness = std::array<std::array<double, n_element_unknowns>, n_element_unknowns>;

/// int 2 G dev eps : dev eps + K (projected div u)^2; of a body of revolution with the hoop strain
/// u_x/x. Throws contact::InputError for an inverted element.
void element_stiffness(const ElementNodes& nodes, Solid solid, const Moduli& moduli,
                       ElementStiffness& k);

/// At the nodes of an element: normal stresses in x, z and across the section, and the shear xz
/// [Pa]; its energy, that of the stiffness, and its volume, of plane strain per length along y.
struct ElementState {
    std::array<std::array<double, 4>, 9> stress;
    double energy, volume;
};
/// Under displacements of its unknowns [m].
ElementState element_state(const ElementNodes& nodes, Solid solid, const Moduli& moduli,
                           const std::array<double, n_element_unknowns>& displacement);

}  // namespace tricontact::fem::planar
