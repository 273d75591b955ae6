#pragma once

#include <cmath>
#include <memory>

#include "contact/load_path.h"
#include "mdr/model.h"
#include "mdr/settings.h"

namespace tricontact::mdr_test {

/// The sphere rig of the thesis (table 5.1.1) as a paraboloid: no scale is 1.
inline contact::Case sphere_rig(double w, double f, int springs, int steps_per_quarter) {
    contact::Case c;
    c.indenter.radius = 40e-3;
    c.indenter.material = contact::Material{206e9, 0.3};
    c.substrate = {5.2e6, 0.5};
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = f;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = w;
    c.rolling->steps_per_quarter = steps_per_quarter;
    c.of<mdr::Settings>().springs = springs;
    return c;
}

/// Presses and loads a case, then rolls period by period.
class Roller {
  public:
    explicit Roller(const contact::Case& c) : model_(mdr::make_model(c)) {
        model_->advance(contact::press_step(c));
        scales_ = model_->scales();
        path_ = contact::make_load_path(c, scales_.normal_force, scales_.contact_radius);
        model_->start_limit();
        for (const auto& step : path_.loading) shift_ = model_->advance(step).shift[0];
        tangential_ratio_ = *c.load.tangential_ratio;
    }

    /// Rolls `n` periods.
    Roller& roll(int n) {
        for (int period = 0; period < n; ++period) {
            const double before = shift_;
            dissipation_ = 0;
            for (const auto& step : path_.period) {
                const auto record = model_->advance(step);
                shift_ = record.shift[0];
                dissipation_ += record.dissipation;
            }
            increment_ = shift_ - before;
        }
        return *this;
    }

    double shift_ratio() const { return shift_ / scales_.unit_shift; }
    /// Increment of the last period over U_max.
    double increment_ratio() const { return increment_ / scales_.unit_shift; }
    /// Dissipation of the last period over mu F_N U_max, taken without mu.
    double dissipation_ratio() const {
        return dissipation_ / (scales_.normal_force * scales_.unit_shift);
    }
    /// kappa = (1 - f - (1 - u)^(3/2))/(w u) of the model's own w, f, u.
    double mapping() const {
        const double u = shift_ratio(), w = path_.amplitude / scales_.contact_radius;
        return (1 - tangential_ratio_ - std::pow(1 - u, 1.5)) / (w * u);
    }
    contact::Model& model() { return *model_; }
    const contact::Scales& scales() const { return scales_; }
    const contact::LoadPath& path() const { return path_; }

  private:
    std::unique_ptr<contact::Model> model_;
    contact::Scales scales_;
    contact::LoadPath path_;
    double tangential_ratio_ = 0, shift_ = 0, increment_ = 0, dissipation_ = 0;
};

}  // namespace tricontact::mdr_test
