#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contact/friction/friction_law.h"

namespace tricontact::contact {

/// What friction carries on a line of springs, of a contact of revolution whose points carry
/// tau(p): b(x) = 2 ∫_x^a tau r dr/sqrt(r^2 - x^2), Jaeger (1995), Ciavarella (1998). Radii are
/// r_k = a sqrt(1 - y_k^2), y_k = k/n: from the edge (k = 0) to the centre (k = n).
class RadialBound {
  public:
    /// n pieces; weights of one n are made once and shared. Of order n^-2.
    static std::shared_ptr<const RadialBound> of(int n);
    explicit RadialBound(int n);

    int pieces() const { return n_; }
    /// r_k/a.
    double radius(int k) const;
    /// p(r_k)/E* [-] of a half-space, 1/pi ∫_r^a g'(x)/sqrt(x^2 - r^2) dx, from the plane profile
    /// g(r_k) [m] and a [m]; exact where g is tip_slope x and a polynomial of first degree in
    /// x^2, else of the order n^-3/2. `tip_slope`: g'(0) [-] of a conical tip, where p is infinite:
    /// its value there is such that its piece carries what it should.
    std::vector<double> pressure(std::vector<double> profile, double a, double tip_slope = 0) const;
    /// The same [Pa] of a body's plane profile g and an E* [Pa].
    template <class Profile>
    std::vector<double> pressure_under(const Profile& g, double a, double tip_slope,
                                       double effective_modulus) const {
        std::vector<double> heights;
        for (int k = 0; k <= n_; ++k) heights.push_back(g(a * radius(k)));
        std::vector<double> p = pressure(std::move(heights), a, tip_slope);
        for (double& one : p) one *= effective_modulus;
        return p;
    }
    /// b(r_k) [N/m] of tau(r_k) [Pa], tau linear in y between them; the value at k = 0 is the limit
    /// from inside.
    std::vector<double> line(std::span<const double> bound, double a) const;
    /// The one value b(r_k)/a [Pa], of tau at the radii 0 to k.
    double line_at(int k, const double* bound) const;

  private:
    std::size_t row(int k) const { return static_cast<std::size_t>(k) * (k + 1) / 2; }

    int n_;
    std::vector<double> slope_weights_, bound_weights_;  // of the points 0..k of each row k
};

/// Value at a radius r, y = sqrt(1 - (r/a)^2) in [0, 1], of a table at the radii of RadialBound,
/// edge first; linear in y between them.
inline double at_depth_of_chord(const double* table, int pieces, double y) {
    const double place = y * pieces;
    const int k = std::min(static_cast<int>(place), pieces - 1);
    return table[k] + (place - k) * (table[k + 1] - table[k]);
}

/// tau [Pa] at pressures from the edge to the centre, the first of them 0: its limit from inside.
std::vector<double> bounds_inside(const FrictionLaw& law, std::vector<double> pressure);

}  // namespace tricontact::contact
