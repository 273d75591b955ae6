#pragma once

#include <array>
#include <vector>

#include "fem/planar/body.h"

namespace tricontact::fem::planar {

/// Unknowns of a section: those of the interior first, both directions of a node together; then of
/// the nodes of the contact surface, along x of all, then along z.
struct SectionUnknowns {
    std::vector<std::array<int, 2>> of_node;  ///< -1: held
    std::vector<int> node_of_unknown;
    int n_interior = 0;
};

/// Nodes of the contact surface in the order of their coordinate.
struct SectionSurface {
    std::vector<int> nodes;
    std::vector<double> along;
    std::vector<std::array<int, 3>> edges;
};

/// Throws contact::InputError if no edge of the mesh touches.
SectionSurface surface_of(const BodyProblem& problem);
SectionUnknowns number_unknowns(const BodyProblem& problem, const SectionSurface& surface);

/// Directions at this coordinate: along the surface, and into the substrate.
std::array<Point, 2> frame_at(const BodyProblem& problem, double along);

}  // namespace tricontact::fem::planar
