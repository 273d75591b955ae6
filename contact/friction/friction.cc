#include "contact/friction/friction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"

namespace tricontact::contact {

namespace {

class Coulomb final : public FrictionLaw {
  public:
    explicit Coulomb(double coefficient) : mu_(coefficient) {}
    void bounds(const Points& points, std::span<double> bound) const override {
        for (std::size_t i = 0; i < bound.size(); ++i) bound[i] = mu_ * points.pressure[i];
    }
    std::optional<double> coulomb() const override { return mu_; }

  private:
    double mu_;  // [-]
};

class PressureLaw final : public FrictionLaw {
  public:
    explicit PressureLaw(const Friction& friction)
        : strength_(friction.shear_strength.value_or(0)),
          exponent_(friction.pressure_exponent.value_or(1)),
          cap_(friction.yield ? friction.yield->stress
                              : friction.strength_limit.value_or(infinity)),
          factor_(friction.coefficient.value_or(0) *
                  (exponent_ == 1 ? 1 : std::pow(*friction.reference_pressure, 1 - exponent_))) {}

    void bounds(const Points& points, std::span<double> bound) const override {
        const double* const pressure = points.pressure.data();
        if (exponent_ == 1 || factor_ == 0) {
            for (std::size_t i = 0; i < bound.size(); ++i)
                bound[i] = pressure[i] > 0 ? std::min(strength_ + factor_ * pressure[i], cap_) : 0.;
            return;
        }
        for (std::size_t i = 0; i < bound.size(); ++i)
            bound[i] = pressure[i] > 0
                           ? std::min(strength_ + factor_ * std::pow(pressure[i], exponent_), cap_)
                           : 0.;
    }

  private:
    double strength_, exponent_, cap_;
    double factor_;  // mu p_r^(1-n)
};

class WeakeningLaw final : public FrictionLaw {
  public:
    WeakeningLaw(double at_rest, const FrictionWeakening& weakening)
        : at_rest_(at_rest), weakening_(weakening) {}

    void bounds(const Points& points, std::span<double> bound) const override {
        for (std::size_t i = 0; i < bound.size(); ++i)
            bound[i] = coefficient(points.way.empty() ? 0 : points.way[i]) * points.pressure[i];
    }
    bool remembers() const override { return true; }
    bool weakens() const override { return true; }
    double healed(double) const override { return 0; }
    double work(double pressure, double from, double to, double slip) const override {
        const double left = weakening_.integral(to) - weakening_.integral(from);
        return pressure * (at_rest_ * slip - weakening_.drop * (slip - left));
    }

  private:
    double coefficient(double way) const {
        return at_rest_ - weakening_.drop * (1 - weakening_.left(way));
    }

    double at_rest_;
    FrictionWeakening weakening_;
};

/// Of a layer that flows before the surfaces slip, by its material's way. Without a way: the most
/// that it comes to carry, which is that of the surfaces where it hardens.
class YieldingLaw final : public FrictionLaw {
  public:
    YieldingLaw(std::shared_ptr<const FrictionLaw> surfaces, const InterfaceYield& yield)
        : surfaces_(std::move(surfaces)), yield_(yield) {}

    void bounds(const Points& points, std::span<double> bound) const override {
        surfaces_->bounds({points.pressure, points.x, points.y}, bound);
        if (points.way.empty() && yield_.hardening > 0) return;
        for (std::size_t i = 0; i < bound.size(); ++i)
            bound[i] = std::min(bound[i], strength(points.way.empty() ? 0 : points.way[i]));
    }
    bool remembers() const override { return true; }
    double hardening() const override { return std::max(0., yield_.hardening); }
    bool weakens() const override { return yield_.hardening < 0; }
    /// What slips over a layer that is stronger than friction, or has become so, does not change
    /// it.
    double way(double before, double slip, double pressure) const override {
        return before + flow(before, slip, surfaces_->bound(pressure));
    }
    double work(double pressure, double from, double to, double slip) const override {
        if (yield_.hardening > 0) {
            const double friction = surfaces_->bound(pressure);
            const double start = strength(from), end = strength(to);
            // Steep hardening tells the flow better than the slip: what it carries has it all.
            const bool slides = end >= friction * (1 - 1e-9);
            const double flows = slides ? std::min(slip, to - from) : slip;
            return flows * std::min(friction, (start + end) / 2) + (slip - flows) * friction;
        }
        const double flows = to - from;
        const double carries = std::clamp(-yield_.stress / yield_.hardening - from, 0., flows);
        return carries * strength(from + carries / 2) + (slip - flows) * surfaces_->bound(pressure);
    }

  private:
    double strength(double way) const {
        return std::max(0., yield_.stress + yield_.hardening * way);
    }
    /// Of a slip, what the layer takes [m].
    double flow(double way, double slip, double friction) const {
        if (!(strength(way) < friction)) return 0;
        if (yield_.hardening < 0) return slip;
        return std::min(slip, (friction - yield_.stress) / yield_.hardening - way);
    }

    std::shared_ptr<const FrictionLaw> surfaces_;
    InterfaceYield yield_;
};

/// The bound of another law times what a map has where the point lies.
class MappedLaw final : public FrictionLaw {
  public:
    MappedLaw(std::shared_ptr<const FrictionLaw> law, std::shared_ptr<const FrictionMap> map)
        : law_(std::move(law)), map_(std::move(map)) {}

    void bounds(const Points& points, std::span<double> bound) const override {
        law_->bounds(points, bound);
        for (std::size_t i = 0; i < points.x.size(); ++i)
            if (bound[i] > 0) bound[i] *= map_->at(points.x[i], points.y[i]);
    }

  private:
    std::shared_ptr<const FrictionLaw> law_;
    std::shared_ptr<const FrictionMap> map_;
};

std::string pressure_text(double pressure) {
    return pressure >= 1e6   ? fmt::format("{:.4g} MPa", pressure / 1e6)
           : pressure >= 1e3 ? fmt::format("{:.4g} kPa", pressure / 1e3)
                             : fmt::format("{:.4g} Pa", pressure);
}

}  // namespace

std::shared_ptr<const FrictionLaw> Friction::law() const {
    if (map) {
        Friction all_over = *this;
        all_over.map = nullptr;
        return std::make_shared<MappedLaw>(all_over.law(), map);
    }
    if (weakening) return std::make_shared<WeakeningLaw>(*coefficient, *weakening);
    if (yield && yield->hardening != 0) {
        Friction surfaces = *this;
        surfaces.yield.reset();
        return std::make_shared<YieldingLaw>(surfaces.law(), *yield);
    }
    if (is_coulomb_at_rest()) return std::make_shared<Coulomb>(coefficient.value_or(0));
    return std::make_shared<PressureLaw>(*this);
}

std::string Friction::formula() const {
    std::string text;
    if (shear_strength) text = pressure_text(*shear_strength);
    if (coefficient) {
        if (!text.empty()) text += " + ";
        text += pressure_exponent.value_or(1) == 1
                    ? fmt::format("{:.4g} p", *coefficient)
                    : fmt::format("{0:.4g} {1} (p/{1})^{2:.4g}", *coefficient,
                                  pressure_text(*reference_pressure), *pressure_exponent);
    }
    if (rate) text += " at rest, " + rate->fall();
    if (temperature)
        text += fmt::format(" cold, {:.4g} p from {:.4g} °C on",
                            coefficient.value_or(0) + temperature->change, temperature->to);
    if (weakening)
        text += fmt::format(
            " at rest, falling by {:.4g} p over a slip of {:.4g} µm, {}", weakening->drop,
            weakening->length * 1e6,
            weakening->law == FrictionWeakening::Law::linear ? "linearly" : "exponentially");
    if (strength_limit) text += fmt::format(", at most {}", pressure_text(*strength_limit));
    if (yield)
        text += fmt::format(
            ", at most {}{} that the layer between carries", pressure_text(yield->stress),
            yield->hardening == 0
                ? std::string()
                : fmt::format(" {} {:.4g} MPa/mm of its flow", yield->hardening > 0 ? "+" : "-",
                              std::abs(yield->hardening) * 1e-9));
    if (map) text = fmt::format("({}) times a map", text);
    return text;
}

}  // namespace tricontact::contact
