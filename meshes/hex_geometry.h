#pragma once

#include <array>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

using Point = std::array<double, 3>;

Point difference(const Point& a, const Point& b);
Point cross(const Point& a, const Point& b);
double dot(const Point& a, const Point& b);
double distance(const Point& a, const Point& b);

/// Local corners of the six faces, counter-clockwise from outside: bottom, top, then around.
constexpr std::array<std::array<int, 4>, 6> hex_faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Local corners of the twelve edges.
constexpr std::array<std::array<int, 2>, 12> hex_edges{{{0, 1},
                                                        {1, 2},
                                                        {2, 3},
                                                        {3, 0},
                                                        {4, 5},
                                                        {5, 6},
                                                        {6, 7},
                                                        {7, 4},
                                                        {0, 4},
                                                        {1, 5},
                                                        {2, 6},
                                                        {3, 7}}};

/// Per corner the three that share an edge with it, right-handed in a valid element.
constexpr std::array<std::array<int, 3>, 8> hex_neighbours{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};

/// Corners of a hexahedron [m].
std::array<Point, 8> corners_of(const HexMesh& mesh, const std::array<int, 8>& hex);

/// Least Jacobian determinant [m^3] of the map from the unit cube, over corners, mid-edges,
/// mid-faces and centre. The determinant is quadratic in each coordinate, so these 27 values
/// determine it. NaN if a corner is.
double least_jacobian(const std::array<Point, 8>& corners);

/// Mean of the nodes [m].
Point centre_of(const HexMesh& mesh, const std::array<int, 8>& hex);
Point centre_of(const HexMesh& mesh, const std::array<int, 4>& face);

/// Whether the point lies on the quadrilateral or within `tolerance` [m] of it.
bool covers(const std::array<Point, 4>& quadrilateral, const Point& point, double tolerance);

}  // namespace tricontact::meshes
