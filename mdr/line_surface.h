#pragma once

#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "contact/friction/friction_law.h"
#include "contact/surface.h"

namespace tricontact::mdr {

/// Traction [Pa] at the radius r >= 0 [m] of the axisymmetric state whose line load is q:
///   p(r) = -1/pi ∫_r^a q'(x)/sqrt(x^2 - r^2) dx, Popov and Hess (2015), eq. 3.37,
/// for an even q [N/m] given at the increasing `positions` [m], the first of them 0, linear in
/// between, zero beyond the last. Each linear piece is integrated exactly (acosh); in the first
/// one q is even, hence taken as a parabola without slope at 0, which keeps p(0) finite.
/// `slopes`: of the pieces [N/m^2]. Throws std::domain_error for unequal lengths.
double back_transform(std::span<const double> slopes, std::span<const double> weights);
/// Of the pieces of a line load [N/m]. Throws std::domain_error for unequal lengths.
std::vector<double> slopes_of(std::span<const double> positions, std::span<const double> line_load);
/// The weights at the radius r for the slopes of the pieces [-], one fewer than positions. Throws
/// std::domain_error for fewer than two positions.
std::vector<double> abel_weights(std::span<const double> positions, double r);

/// The same, kept as long as the positions stay: a contact that rolls to and fro comes back to the
/// same radii. At most 16 MB.
class KeptAbelWeights {
  public:
    const std::vector<double>& at(std::span<const double> positions, double r);

  private:
    std::vector<double> positions_;
    std::unordered_map<double, std::vector<double>> of_radius_;
};

/// Equally spaced points on a line.
struct PointRow {
    double first = 0, spacing = 0;  ///< [m]

    double position(int i) const { return first + i * spacing; }
    /// Value at x [m], linear between the points, zero outside of the row.
    double interpolate(std::span<const double> values, double x) const;
    /// Even part of the values about `centre` [m], at the distance x [m].
    double even(std::span<const double> values, double centre, double x) const {
        return (interpolate(values, centre + x) + interpolate(values, centre - x)) / 2;
    }
};

/// The first and the last point that carry a load > 0; none: last < first.
struct LoadSpan {
    int first, last;
};
LoadSpan load_span(std::span<const double> load);

/// Where a line load vanishes on either side, distances from `centre` [m]: each extrapolated as a
/// parabola about the centre through the last two points. Some point must carry load; a single one
/// is taken for a contact one spacing wide.
struct LoadEnds {
    double before, beyond;
};
LoadEnds load_ends(const PointRow& row, std::span<const double> load, double centre);

/// The even part, about a centre, of a line load that is positive in the contact: what a
/// back-transformation takes for an axisymmetric pressure.
struct EvenLoad {
    std::vector<double> positions;  ///< distances from the centre [m]: 0, ..., a
    std::vector<double> values;     ///< [N/m], 0 at a

    /// a [m], where the load vanishes: mean of both sides, see load_ends().
    double half_width() const { return positions.back(); }
    /// Pressure at the centre [Pa], -1/pi ∫_0^a q'(x)/x dx, q linear in x^2 between the positions.
    double centre_pressure() const;
};

/// At most `most_pieces` + 1 positions, at whole spacings. Some point must carry load.
EvenLoad even_load(const PointRow& row, std::span<const double> load, double centre,
                   int most_pieces);

/// A picture needs no more points; their transforms cost points times pieces.
inline constexpr int most_surface_points = 500, most_surface_pieces = 250;

/// Even line loads [N/m] on 0 = x_0 < x_1 < ... < a, both 0 at a, for the back-transformation.
struct EvenLoads {
    std::vector<double> positions, normal, tangential;
};

/// The even parts of the loads on a row about the indenter's position [m].
EvenLoads even_loads(const PointRow& row, std::span<const double> normal,
                     std::span<const double> tangential, double position);

/// Line layout of the `n` points of a row, thinned out, under an indenter at `position` [m];
/// tractions are transformed back. `show(i, k, surface)` sets what springs or elements show, one
/// value each: state, displacements, gap, slip and line loads at point k, the i-th of the row.
///
/// `slip_path` and `friction_work` stay empty, since springs are no points of the surface and have
/// no area: before rolling, a point at r slips by 2/pi ∫_0^r s(x)/sqrt(r^2 - x^2) dx of the
/// springs' slips s, a mean over parts of either sign (Popov and Hess 2015), from which no sum of
/// |s| gives its path; once the contact has rolled, no radius belongs to a spring.
///
/// `kept`: from the surfaces before, where their positions may be the same.
using ShowPoint = std::function<void(int i, int k, contact::Surface& surface)>;
contact::Surface make_line_surface(const PointRow& row, int n, double position,
                                   const contact::FrictionLaw& friction, const EvenLoads& loads,
                                   const ShowPoint& show, KeptAbelWeights* kept = nullptr);

}  // namespace tricontact::mdr
