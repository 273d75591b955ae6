#pragma once

#include <span>
#include <vector>

namespace tricontact::mdr {

/// Equally spaced points on a line.
struct PointRow {
    double first = 0, spacing = 0;  ///< [m]

    double position(int i) const { return first + i * spacing; }
    /// Value at x [m], linear between the points, zero outside of the row.
    double interpolate(std::span<const double> values, double x) const;
    /// Even part of the values about `centre` [m], at the distance x [m].
    double even(std::span<const double> values, double centre, double x) const;
};

/// The even part, about a centre, of a line load that is positive in the contact: what a
/// back-transformation takes for an axisymmetric pressure.
struct EvenLoad {
    std::vector<double> positions;  ///< distances from the centre [m]: 0, ..., a
    std::vector<double> values;     ///< [N/m], 0 at a

    /// a [m], where the load vanishes: mean of both sides, each extrapolated as a parabola about
    /// the centre through its last two points.
    double half_width() const { return positions.back(); }
    /// Pressure at the centre [Pa], -1/pi ∫_0^a q'(x)/x dx, q linear in x^2 between the positions.
    double centre_pressure() const;
};

/// At most `most_pieces` + 1 positions, at whole spacings. Some point must carry load; a single one
/// is taken for a contact one spacing wide.
EvenLoad even_load(const PointRow& row, std::span<const double> load, double centre,
                   int most_pieces);

}  // namespace tricontact::mdr
