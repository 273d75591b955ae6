#pragma once

#include <span>

#include "contact/bodies/indenter.h"

namespace tricontact::contact {

/// A measured or drawn profile between its points: piecewise cubic, rising where they rise and with
/// a continuous slope but at the declared kinks (Fritsch and Butland 1984, SIAM J. Sci. Stat.
/// Comput. 5). The slope at the axis is zero unless there is a kink, the tip of a cone.
class ProfileCurve final : public AxisymmetricIndenter {
  public:
    struct Point {
        double radius;  ///< [m]
        double height;  ///< [m]
        bool kink;      ///< the slope jumps here
    };
    /// At least two points, the first at (0, 0), radii increasing, heights not falling but rising
    /// somewhere. Throws std::domain_error otherwise.
    explicit ProfileCurve(std::span<const Point> points);

    double profile(double r) const override;
    double profile_slope(double r) const override;
    /// The last point's: nothing is known beyond.
    double outer_radius() const override { return outer_radius_; }
    /// All points between the ends: the curvature jumps there.
    std::vector<double> kinks() const override;
    bool presses_like_a_ball() const override { return false; }
    double slope_moment(double x, int k) const override;

  private:
    /// h = height + slope t + square t^2 + cube t^3, t = r - begin.
    struct Piece {
        double begin, height, slope, square, cube;
    };
    static Piece piece(const Point& begin, const Point& end, double slope, double end_slope);
    void add_run(std::span<const Point> run, bool at_axis);
    const Piece& piece_at(double r) const;

    std::vector<Piece> pieces_;
    double outer_radius_;
};

}  // namespace tricontact::contact
