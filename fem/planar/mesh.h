#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "fem/planar/node_line.h"

// Sections of bodies in the plane x, z: those of cylinders (x across their axis), or of bodies of
// revolution (x the distance from the axis). z points out of the substrate, whose surface is z = 0;
// the body that presses lies above it, its lowest point in the origin.

namespace tricontact::fem::planar {

using Point = std::array<double, 2>;  ///< x, z [m]

/// What an edge of a section belongs to.
enum class Boundary : std::uint8_t { free, contact, support, symmetry };

/// Biquadratic quadrilaterals: corners anticlockwise, middles of the edges from the first to the
/// second corner on, centre (VTK's order). Curved edges have their middles on the curve.
struct Mesh {
    struct Edge {
        std::array<int, 3> nodes;  ///< ends and middle
        Boundary boundary;
    };
    std::vector<Point> nodes;
    std::vector<std::array<int, 9>> cells;
    std::vector<Edge> edges;  ///< of the boundary, those with a name other than free
};

/// Part of a section with four sides, as a structured grid. The sides are curves over [0, 1]:
/// south and north run with u, west and east with v; they meet in the corners.
struct Block {
    using Curve = std::function<Point(double)>;
    NodeLine u, v;  ///< nodes, from 0 to 1
    Curve south, east, north, west;
    /// Of the sides in this order. A side that is `contact` is so in its first `n_contact`
    /// elements, and free beyond.
    std::array<Boundary, 4> boundaries{};
    int n_contact = 0;
};

/// Straight side.
Block::Curve line_between(const Point& from, const Point& to);
/// Arc about a centre, from one angle to another, measured from the downward direction towards +x
/// [rad].
Block::Curve arc(const Point& centre, double radius, double from, double to);

/// The grids of all blocks, joined where their nodes meet: the inside of each by transfinite
/// interpolation (Gordon and Hall 1973).
Mesh join(const std::vector<Block>& blocks);

/// The section with its mirror image in x = 0, whose symmetry plane is then inside.
Mesh with_mirror_image(const Mesh& half);

/// The section with z reversed: what presses lies below.
Mesh upside_down(const Mesh& section);

}  // namespace tricontact::fem::planar
