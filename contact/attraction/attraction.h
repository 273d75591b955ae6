#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/attraction/attraction_law.h"
#include "contact/compliances/compliance.h"

namespace tricontact::contact {

/// Integral of (1 - x^2)^2 from 0 to 1.
inline constexpr double smooth_work = 8. / 15;

/// Tension that surfaces exert on each other over the gap g between them, as the points of a
/// surface feel it.
struct Attraction {
    double strength = 0;  ///< sigma_0 [Pa]
    double distance = 0;  ///< of the law [m]
    bool decays = false;  ///< sigma_0 exp(-g/distance), else sigma_0 up to the distance
    /// sigma_0 was chosen for the points, in place of range 0: sigma_0 (1 - (g/distance)^2)^2.
    bool is_short_ranged = false;
    /// Range 0 by cells that let go one by one under sigma_0, see CellAdhesion; `distance` is w
    /// over it.
    bool is_by_cell = false;

    /// w [J/m^2].
    double work() const { return strength * distance * (is_short_ranged ? smooth_work : 1); }
    /// Tension of a point whose surface has gaps from g - width/2 to g + width/2 [Pa].
    double tension(double gap, double width) const;
    /// Energy of the same, 0 far away, -w in contact [J/m^2].
    double energy(double gap, double width) const;
};

/// Side of a point's surface [m]; of a contact of revolution by its radius 8/3 of the distance of
/// nodes.
double point_distance(const ContactPoints& points);

/// In points, of the zone beside the contact in which a tension acts that stands for range 0.
inline constexpr double points_without_range = 3;

/// The least of a range above 0.
inline constexpr double least_points_of_range = 2;

/// Of a law on these points, `modulus` E* of the pair [Pa]. Without a range sigma_0 is such
/// that the tension acts over `wide` points beside the contact. Throws InputError where it acts
/// over fewer than two.
Attraction attraction_on(const ContactPoints& points, const AttractionLaw& law, double modulus,
                         double wide = points_without_range);

/// Of a law without a range on the square cells of a half-space, that let go one by one. Throws
/// InputError of other laws and points.
Attraction attraction_by_cell(const ContactPoints& points, const AttractionLaw& law,
                              double modulus);

/// By how much the gap differs across the surface of each point. A tension that ends at a gap ends
/// within a point's surface: counted by whole points the edge of the tension would be as rough as
/// they are.
class GapWidths {
  public:
    /// On a grid.
    explicit GapWidths(const ContactPoints& points) : points_(points) {}

    /// Per point [m]; `gap` may be infinite.
    void of(std::span<const double> gap, std::span<double> width) const;

  private:
    double at(std::span<const double> gap, int i, int j) const;

    const ContactPoints& points_;
};

}  // namespace tricontact::contact
