#pragma once

#include <span>
#include <vector>

#include "contact/compliances/compliance.h"
#include "contact/friction/friction_law.h"

namespace tricontact::contact {

/// Whether a point carries something as soon as it touches, whatever small pressures are.
inline bool jumps_at_edge(const FrictionLaw& law) {
    return law.bound(1e-300) > .5 * law.bound(1e-200);
}

/// Which part of a point's surface is in contact. Points touch or do not; the edge of the contact
/// runs between them, and tells where by the gap beside it, which grows as d^(3/2) with the
/// distance d: its power 2/3 is a straight line that ends at the edge (Johnson 1985, eq. 4.43 and
/// what is left of it at d << a). A law of friction that jumps at the edge, as a shear strength
/// does, acts on these parts; counted by whole points, its sum would be as rough as the edge.
///
/// Cells of a grid are rectangles, nodes of a nine-node face have the parts whose areas are their
/// weights (Simpson's rule: 1/6, 2/3, 1/6 of each side).
class ContactShare {
  public:
    /// Whether `points` bound surfaces: a grid or element faces, a rigid interface, no period.
    static bool is_known(const ContactPoints& points);
    /// Of points that is_known().
    explicit ContactShare(const ContactPoints& points);

    /// Parts [-] in [0, 1], per point: 1 or 0 away from the edge, and where the gap beside it is no
    /// smooth function on the scale of the points. `gap` [m]: of the surface under the indenter,
    /// infinite where unknown.
    std::vector<double> of(std::span<const double> pressure, std::span<const double> gap) const;

  private:
    struct Neighbour {
        int point;
        double x, y;  // from the point in question, over the distance of neighbours [-]
    };
    /// What a neighbour that does not touch tells: -gap^(2/3), and its weight.
    struct Beside {
        double x, y, value, weight;
    };
    /// Where the contact is: inside + along_x x + along_y y > 0, lengths as those of Neighbour.
    struct Edge {
        double inside, along_x, along_y;
    };
    /// A parallelogram about `x`, `y` with the half sides u and v; its part of the point's surface.
    struct Piece {
        double x, y, part;
        Vector2 u, v;
    };

    void add_faces();
    void find_neighbours(int point, std::vector<Neighbour>& found) const;
    bool is_at_edge(std::span<const double> pressure, int point) const;
    static bool fit(const std::vector<Beside>& beside, bool is_line, Edge& edge);
    double part_inside(int point, const Edge& edge) const;

    ContactPoints points_;                    // of a grid of rows without positions and areas
    std::vector<double> unit_;                // distance of neighbours [m], per point
    std::vector<std::vector<Piece>> pieces_;  // of element faces; else cells of the grid
    std::vector<std::vector<int>> beside_, neighbours_;  // of points that form no grid
};

/// Bounds [Pa] of a law that jumps at the edge of the contact: what it jumps to times the share,
/// the rest of it as of whole points. `share` empty: as the law.
void bounds_on_shares(const FrictionLaw& law, const FrictionLaw::Points& points,
                      std::span<const double> share, std::span<double> bound);

}  // namespace tricontact::contact
