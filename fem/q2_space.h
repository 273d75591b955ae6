#pragma once

#include <array>
#include <memory>
#include <vector>

#include "meshes/hex_mesh.h"

namespace dealii {
template <int dim, int spacedim>
class Triangulation;
}

namespace tricontact::fem {

/// Makes an empty triangulation (serial or distributed) out of a mesh: cell i is hexahedron i,
/// possibly turned. Boundary ids are those of `meshes::Boundary` plus 1, 0 for faces without a
/// name; material ids are regions.
void triangulate(const meshes::HexMesh& mesh, dealii::Triangulation<3, 3>& triangulation);

/// Refuses a boundary face with id `boundary_id` about `centre` [m] if that is no name: throws
/// contact::InputError.
void require_name(unsigned boundary_id, const std::array<double, 3>& centre);

/// Triquadratic nodes of a hexahedron in VTK's order, by position 0, 1, 2 along each axis.
extern const std::array<std::array<int, 3>, 27> node_positions;

/// The nodes of a mesh of triquadratic hexahedra, numbered without gaps, and integration over its
/// elements and boundary faces. All that the layer takes from deal.II.
class Q2Space {
  public:
    struct Face {
        std::array<int, 9> nodes;  ///< corners (cyclic), edges, centre; outward by the right hand
        meshes::Boundary boundary;
    };

    /// Throws contact::InputError for a mesh whose boundary faces are not all named.
    explicit Q2Space(const meshes::HexMesh& mesh);
    ~Q2Space();

    std::vector<std::array<double, 3>> nodes;  ///< [m]
    std::vector<std::array<int, 27>> cells;    ///< VTK's order
    std::vector<meshes::Region> regions;       ///< per cell
    std::vector<Face> faces;                   ///< on the boundary

    /// Integrals over a face of the products of its shape functions [m^2], in its nodes' order.
    std::array<std::array<double, 9>, 9> face_mass(std::size_t face) const;

  private:
    friend class ElementValues;
    void add_face(std::size_t cell, int face);
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Shape functions of one element after another at the points of a Gauss rule, numbered with x
/// fastest.
class ElementValues {
  public:
    using Gradients = std::array<std::array<double, 3>, 27>;

    /// `n` Gauss points along each axis.
    ElementValues(const Q2Space& space, int n);
    ~ElementValues();

    void reinit(std::size_t cell);
    std::vector<double> weights;                ///< times the Jacobian [m^3]
    std::vector<std::array<double, 3>> points;  ///< [m]
    std::vector<Gradients> gradients;           ///< of the shape functions [1/m]

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace tricontact::fem
