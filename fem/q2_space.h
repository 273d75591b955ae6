#pragma once

#include <array>
#include <memory>
#include <vector>

#include "meshes/hex_mesh.h"

namespace tricontact::fem {

class ElementValues;
class Q2Space;

/// Triquadratic nodes of a hexahedron in VTK's order, by position 0, 1, 2 along each axis.
extern const std::array<std::array<int, 3>, 27> node_positions;
inline constexpr int centre_of_cell = 26;  ///< among them; no other hexahedron has that node

/// Numbers within a hexahedron of the nine nodes of its lower or upper face across `axis`: corners
/// counter-clockwise seen from outside, edges, centre.
std::array<int, 9> nodes_on_face(int axis, bool upper);

/// Integration over one element after another by a Gauss rule.
class ElementRule {
  public:
    virtual ~ElementRule() = default;
    virtual void reinit(std::size_t cell, ElementValues& values) = 0;
};

/// The elements of a mesh.
class Q2Elements {
  public:
    virtual ~Q2Elements() = default;
    virtual std::array<std::array<double, 9>, 9> face_mass(std::size_t face) const = 0;
    /// `n` Gauss points along each axis.
    virtual std::unique_ptr<ElementRule> rule(int n) const = 0;
};

/// The elements of any `mesh`; nodes, cells, regions and faces go to `space`. Of the library that
/// links deal.II (fem/deal_ii/); the program's module loads that when a mesh first asks for it.
/// Throws contact::InputError for a mesh whose boundary faces are not all named.
std::unique_ptr<const Q2Elements> q2_elements(const meshes::HexMesh& mesh, Q2Space& space);

/// Which elements of a mesh to take: those of deal.II, or those of brick_elements.h where they will
/// do. Their integrals differ by rounding, which K/G = 1e6 makes 1e-10 of a condensed layer.
enum class Elements { any, bricks_if_all_are };

/// The nodes of a mesh of triquadratic hexahedra, numbered without gaps, and integration over its
/// elements and boundary faces.
class Q2Space {
  public:
    struct Face {
        std::array<int, 9> nodes;  ///< corners (cyclic), edges, centre; outward by the right hand
        meshes::Boundary boundary;
    };

    /// Throws contact::InputError for a mesh whose boundary faces are not all named.
    explicit Q2Space(const meshes::HexMesh& mesh, Elements elements = Elements::any);

    std::vector<std::array<double, 3>> nodes;  ///< [m]
    std::vector<std::array<int, 27>> cells;    ///< VTK's order
    std::vector<meshes::Region> regions;       ///< per cell
    std::vector<Face> faces;                   ///< on the boundary

    /// Integrals over a face of the products of its shape functions [m^2], in its nodes' order.
    std::array<std::array<double, 9>, 9> face_mass(std::size_t face) const {
        return elements_->face_mass(face);
    }

  private:
    friend class ElementValues;
    std::unique_ptr<const Q2Elements> elements_;
};

/// Shape functions of one element after another at the points of a Gauss rule, numbered with x
/// fastest.
class ElementValues {
  public:
    using Gradients = std::array<std::array<double, 3>, 27>;

    /// `n` Gauss points along each axis.
    ElementValues(const Q2Space& space, int n)
        : points(n * n * n), gradients(points.size()), rule_(space.elements_->rule(n)) {}

    void reinit(std::size_t cell) { rule_->reinit(cell, *this); }
    std::vector<double> weights;                ///< times the Jacobian [m^3]
    std::vector<std::array<double, 3>> points;  ///< [m]
    std::vector<Gradients> gradients;           ///< of the shape functions [1/m]

  private:
    std::unique_ptr<ElementRule> rule_;
};

}  // namespace tricontact::fem
