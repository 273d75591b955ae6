#include "theory/adhesive/dugdale_contacts.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "contact/base/gauss_legendre.h"
#include "contact/base/root.h"

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

    /// By the width c - a of the ring, which may be a tiny part of the contact.
    State at(double place) const {
        const auto opens = [&](double width) {
            const double a = (place - width) / 2;
            return opening(a, width, touching_depth(a, width)) - tension_.distance;
        };
        const double apart = opens(place);
        if (apart <= 0)  // the gap at c falls by what the bodies approach
            return state(place, 0, place, touching_depth(0, place) + apart);
        // Of a crack under K^2 = 2 E* w: pi/8 (K/sigma_0)^2.
        const double guess = pi / 4 * modulus_ * tension_.distance / tension_.strength;
        const double width = *contact::increasing_root(opens, guess, place);
        const double a = (place - width) / 2;
        return state(place, a, width, touching_depth(a, width));
    }

  private:
    static double root_of(double a, double width) { return std::sqrt(width * (2 * a + width)); }
    /// l where q is continuous at a: at a = 0 that of bodies which meet at a point.
    double detached(double a, double width) const {
        return 2 * tension_.strength * root_of(a, width) / modulus_;
    }
    double touching_depth(double a, double width) const { return profile_(a) - detached(a, width); }

    /// int_a^c f(x) (c^2 - x^2)^(-1/2) dx, x = c cos t.
    template <class F>
    double over_ring(double a, double width, const F& f) const {
        const contact::QuadratureRule& rule = contact::gauss_legendre(points_of_ring);
        const double length = std::atan2(root_of(a, width), a), c = a + width;
        double sum = 0;
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const double t = length * rule.points[i];
            sum += rule.weights[i] * f(c * std::cos(t), c * std::sin(t));
        }
        return length * sum;
    }

    double opening(double a, double width, double d) const {
        return 2 / pi * over_ring(a, width, [&](double x, double) { return profile_(x) - d; }) -
               4 * tension_.strength / (pi * modulus_) * width;
    }

    State state(double place, double a, double width, double d) const {
        const double pull = tension_.strength, l = detached(a, width), c = a + width,
                     angle = std::atan2(root_of(a, width), a);
        State s{.place = place, .radius = a, .reach = c, .indentation = d, .detached = l};
        if (a > 0) {
            const DiscContact disc = family_(a);
            s.force = disc.force - disc.stiffness * l;
            s.energy = disc.energy - l * (disc.force - disc.stiffness * l / 2);
        }
        s.force -= 2 * pull * (c * c * angle - a * root_of(a, width));
        s.energy += 4 * pull * pull / modulus_ * (2 * c * c * c / 3 - c * c * a + a * a * a / 3);
        // sigma_0 times the gap over the ring: by springs as the work of a uniform pressure.
        const double gaps = over_ring(a, width, [&](double x, double root) {
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
