#pragma once

#include <memory>

#include "contact/base/error.h"
#include "contact/solvers/control.h"
#include "experiments/identification/loop_values.h"
#include "mdr/layer_model.h"
#include "tests/random/loops/driven_loop.h"

namespace tricontact {

/// A rigid ball on a bonded layer, with a spring in series, driven step by step on mdr-layer's
/// springs, which stick or slip and which the layer couples. The contact's shift is prescribed: the
/// drive's follows from the force.
class LayerLoopRig {
  public:
    static constexpr const char* model = "layer";
    // Over the force of sliding; below it the length of the elements would show.
    static constexpr Bounds noise{.01, .04};
    double young = 0, friction = 0, rig_stiffness = 0, normal_force = 0;

    void draw(Random& random) {
        case_.models = {"mdr-layer"};
        case_.indenter.radius = log_between(random, 5e-3, 60e-3);
        young = log_between(random, 1e6, 20e6);
        case_.substrate = {young, between(random, {.3, .5})};
        friction = between(random, {.15, 1});
        case_.indenter.shape = contact::Case::Shape::paraboloid;
        case_.friction = {.coefficient = friction};
        const double radius = case_.indenter.radius * between(random, {.02, .06});
        normal_force = 4. / 3 * young / (1 - case_.substrate.poisson * case_.substrate.poisson) *
                       radius * radius * radius / case_.indenter.radius;
        case_.layer.thickness = 2 * radius * log_between(random, .5, 5);
        rig_stiffness = contact::infinity;
        rig_stiffness = log_between(random, .4, 6) * curve().at(1e-4 * sliding_shift(), 1).slope;
    }
    const contact::Case& as_case() const { return case_; }
    /// Of the contact alone [m].
    double sliding_shift() const { return curve().sliding_shift(); }

    void start(double amplitude) { make(amplitude, friction); }

    DrivenLoop cycle(double amplitude, double mu) {
        if (mu != friction_now_) make(amplitude, mu);
        DrivenLoop loop{.truth = {.friction = mu}};
        double largest_force = 0;
        for (int i = 1; i <= n_rows; ++i) {
            const double shift = amplitude * std::cos(2 * std::numbers::pi * i / n_rows);
            const contact::StepRecord step = move(shift);
            const double force = step.tangential_force[0];
            loop.shifts.push_back(shift + force / rig_stiffness);
            loop.forces.push_back(force);
            loop.truth.energy += step.dissipation;
            loop.truth.slides = loop.truth.slides || step.stick_area == 0;
            largest_force = std::max(largest_force, std::abs(force));
        }
        loop.truth.ratio = loop.truth.energy / (4 * largest_force * amplitude);
        return loop;
    }

  private:
    static constexpr int elements = 120;  // per radius

    experiments::LoopCurve curve() const {
        experiments::IdentifiedRig rig{.as_case = case_};
        rig.loops_on_layer = true;
        return experiments::loop_curve(rig, normal_force);
    }
    contact::StepRecord move(double shift) {
        contact::LoadStep step;
        step.normal = {contact::NormalControl::Kind::force, normal_force};
        step.tangential[0] = {contact::TangentialControl::Kind::shift, shift};
        return model_->advance(step);
    }
    /// At a first reversal: that of springs which slip one way does not depend on the steps.
    void make(double amplitude, double mu) {
        contact::Case c = case_;
        c.load.normal_force = normal_force;
        c.load.tangential_ratio = 0;
        c.friction = {.coefficient = mu};
        friction_now_ = mu;
        model_ = mdr::make_layer_model(c, elements);
        move(amplitude);
    }

    contact::Case case_;
    std::unique_ptr<contact::Model> model_;
    double friction_now_ = 0;
};

}  // namespace tricontact
