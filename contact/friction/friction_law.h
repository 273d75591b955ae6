#pragma once

#include <optional>
#include <span>

namespace tricontact::contact {

/// What friction carries along the surface at most: at each point of a contact, and in all. Models,
/// audits and reports ask this alone; where a formula holds for Coulomb's law only, it asks
/// coulomb().
class FrictionLaw {
  public:
    /// What a point's bound may depend on, a value per point.
    struct Points {
        std::span<const double> pressure;  ///< on the true area [Pa]
        std::span<const double> x = {},
                                y = {};  ///< on the substrate [m]; empty: it is the same all over
        /// Of what remembers(): the way that it has slipped [m]; empty: that of the largest bound.
        std::span<const double> way = {};
    };
    /// The contact as a whole.
    struct Total {
        double normal_force;  ///< F_N [N]
        double bound;         ///< of the points, summed over their areas [N]
    };

    virtual ~FrictionLaw() = default;

    /// Largest traction of each point [Pa], 0 where nothing presses.
    virtual void bounds(const Points& points, std::span<double> bound) const = 0;
    /// mu [-] of a bound mu p; empty: another law.
    virtual std::optional<double> coulomb() const { return std::nullopt; }

    /// Whether a bound depends on the way that its point has slipped.
    virtual bool remembers() const { return false; }
    /// By how much bounds rise with the way [Pa/m], from what they are at rest to what they are
    /// after an infinite one; and whether any falls with it.
    virtual double hardening() const { return 0; }
    virtual bool weakens() const { return false; }
    /// The way after a point at this pressure has slipped by `slip` more [m], and what is left of
    /// it when the point sticks again.
    virtual double way(double before, double slip, double pressure) const {
        static_cast<void>(pressure);
        return before + slip;
    }
    virtual double healed(double way) const { return way; }
    /// Frictional work per area of a point that slips by `slip`, from a way to another [J/m^2].
    virtual double work(double pressure, double from, double to, double slip) const {
        static_cast<void>(from);
        static_cast<void>(to);
        return bound(pressure) * slip;
    }

    double bound(double pressure) const {
        double bound = 0;
        bounds({{&pressure, 1}}, {&bound, 1});
        return bound;
    }
    /// Bound over pressure, at a pressure > 0 [-].
    double ratio_at(double pressure) const {
        const auto mu = coulomb();
        return mu ? *mu : bound(pressure) / pressure;
    }
    /// `share` of the force [N] at which the contact slides as a whole.
    double limit(const Total& total, double share = 1) const {
        const auto mu = coulomb();
        return mu ? share * *mu * total.normal_force : share * total.bound;
    }
    /// Part of the limit of `all` that `some` of it carries [-].
    double share(const Total& some, const Total& all) const {
        return coulomb() ? some.normal_force / all.normal_force : some.bound / all.bound;
    }
    /// Bound over pressure, in the mean of the contact [-].
    double ratio(const Total& total) const {
        const auto mu = coulomb();
        return mu ? *mu : total.bound / total.normal_force;
    }
};

}  // namespace tricontact::contact
