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
          cap_(friction.strength_limit.value_or(infinity)),
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
    if (strength_limit) text += fmt::format(", at most {}", pressure_text(*strength_limit));
    if (map) text = fmt::format("({}) times a map", text);
    return text;
}

}  // namespace tricontact::contact
