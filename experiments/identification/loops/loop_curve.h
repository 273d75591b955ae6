#pragma once

#include <vector>

namespace tricontact::experiments {

/// Force over shift of a contact under one normal force, loaded once along the surface, with the
/// rig's spring in series: U = U_c(F) + F/k_rig. Springs beside each other that slip at bounds of
/// their own obey Masing's rule, and so do they with a spring in series: in a steady cycle each
/// branch is this curve at twice its size.
class LoopCurve {
  public:
    /// Force F_lim [N] at which all slides, k_rig's reciprocal [m/N], and shifts U_c [m] of the
    /// contact at the forces force_at(F_lim, t) of t = 0, 1/n, ..., 1.
    LoopCurve(double limit, double rig_compliance, std::vector<double> contact_shifts);

    /// F_lim (1 - (1 - t)^(3/2)): of Mindlin's contact U_c is in proportion to t, of others
    /// smooth.
    static double force_at(double limit, double t);

    struct Point {
        double force = 0;  ///< [N]
        double slope = 0;  ///< dF/dU [N/m]
    };
    /// Odd in the shift [m]. `friction`: what the contact carries over what it was made for, by
    /// which force and shift grow alike.
    Point at(double shift, double friction) const;

    double limit() const { return limit_; }
    double rig_compliance() const { return rig_compliance_; }
    /// U at which all slides, for friction 1 [m].
    double sliding_shift() const;
    /// Frictional work of a steady cycle with this amplitude of the shift [J].
    double energy(double amplitude, double friction) const;

  private:
    double place_of(double shift) const;  // t, below sliding
    double place_from(double start, double shift) const;
    void tabulate();
    double contact_shift(double t) const;
    double contact_slope(double t) const;

    double limit_, rig_compliance_;
    std::vector<double> shifts_, slopes_;  // U_c and dU_c/dt at the nodes
    /// Force, and its difference by one node, at equal steps of w, w^2 = 1 - U/U_slide, in which
    /// the curve is smooth up to sliding.
    std::vector<Point> table_;
};

}  // namespace tricontact::experiments
