#include "theory/adhesive/dugdale_contacts.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "contact/base/root.h"
#include "theory/line_load.h"

namespace tricontact::theory {

namespace {

using State = AdhesiveCurve::State;
using std::numbers::pi;

constexpr int points_of_ring = 24;

class DugdaleRing {
  public:
    DugdaleRing(AdhesiveCurve::Family family, std::function<double(double)> profile, double modulus,
                const DugdaleTension& tension)
        : family_(std::move(family)),
          profile_(std::move(profile)),
          modulus_(modulus),
          tension_(tension) {}

    State at(double place) const {
        const auto opens = [&](double a) {
            return opening(a, place - a, touching_depth(a, place - a)) - tension_.distance;
        };
        if (opens(0) <= 0) {
            // The gap at c falls by what the bodies approach.
            const double d = touching_depth(0, place);
            return state(place, 0, place, d + opens(0));
        }
        const double a = contact::bracketed_root(opens, 0, place / 2);
        return state(place, a, place - a, touching_depth(a, place - a));
    }

  private:
    /// l where q is continuous at a: at a = 0 that of bodies which meet at a point.
    double detached(double a, double c) const {
        return 2 * tension_.strength * std::sqrt(c * c - a * a) / modulus_;
    }
    double touching_depth(double a, double c) const { return profile_(a) - detached(a, c); }

    /// int_a^c f(x) (c^2 - x^2)^(-1/2) dx, x = c sin t.
    template <class F>
    double over_ring(double a, double c, const F& f) const {
        const QuadratureRule& rule = gauss_legendre(points_of_ring);
        const double first = std::asin(a / c), length = pi / 2 - first;
        double sum = 0;
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const double t = first + length * rule.points[i];
            sum += rule.weights[i] * f(c * std::sin(t), c * std::cos(t));
        }
        return length * sum;
    }

    double opening(double a, double c, double d) const {
        return 2 / pi * over_ring(a, c, [&](double x, double) { return profile_(x) - d; }) -
               4 * tension_.strength / (pi * modulus_) * (c - a);
    }

    State state(double place, double a, double c, double d) const {
        const double pull = tension_.strength, l = detached(a, c);
        State s{.place = place, .radius = a, .reach = c, .indentation = d, .detached = l};
        if (a > 0) {
            const DiscContact disc = family_(a);
            s.force = disc.force - disc.stiffness * l;
            s.energy = disc.energy - l * (disc.force - disc.stiffness * l / 2);
        }
        s.force -= 2 * pull * (c * c * std::acos(a / c) - a * std::sqrt(c * c - a * a));
        s.energy += 4 * pull * pull / modulus_ * (2 * c * c * c / 3 - c * c * a + a * a * a / 3);
        // sigma_0 times the gap over the ring: by springs as the work of a uniform pressure.
        const double gaps = over_ring(a, c, [&](double x, double root) {
            return root * root * (profile_(x) - d - 2 * pull * root / modulus_);
        });
        s.attraction = pull * (4 * gaps - tension_.distance * pi * c * c);
        return s;
    }

    AdhesiveCurve::Family family_;
    std::function<double(double)> profile_;
    double modulus_;
    DugdaleTension tension_;
};

}  // namespace

AdhesiveCurve::Branch dugdale_contacts(AdhesiveCurve::Family family,
                                       std::function<double(double)> profile, double modulus,
                                       const DugdaleTension& tension) {
    return [ring = DugdaleRing(std::move(family), std::move(profile), modulus, tension)](
               double place) { return ring.at(place); };
}

}  // namespace tricontact::theory
