#pragma once

#include <cmath>

#include "contact/run.h"
#include "fem/case/model.h"
#include "fem/settings.h"
#include "tests/paths.h"
#include "theory/layer/elastic_layer.h"

namespace tricontact::fem {

/// The rig of table 5.1.1 on its layer of 8 mm, pressed only; the indenter rigid.
inline contact::Case layer_case(double size, double nu = .5) {
    contact::Case c;
    c.indenter.radius = 0.04;
    c.substrate = {5.2e6, nu};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_force = 0;
    c.of<fem::Settings>().size = size;
    c.of<fem::Settings>().cache = paths::layer_cache();
    return c;
}

inline std::unique_ptr<contact::Model> make_layer_model(const contact::Case& c) {
    return make_model(c, {});
}

/// Pressed without friction.
inline contact::StepRecord press(contact::Model& model, const contact::Case& c) {
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    return model.advance(step);
}

inline theory::LayerContact exact_contact(const contact::Case& c) {
    const auto base = c.layer.base == contact::Case::Base::bonded ? theory::LayerBase::bonded
                                                                  : theory::LayerBase::frictionless;
    return theory::solve_layer_contact({c.substrate, *c.layer.thickness, base},
                                       contact::Paraboloid(c.indenter.radius),
                                       contact::press_step(c).normal);
}

/// Observed order from the errors on two element sizes.
inline double order(double coarse_error, double fine_error, double ratio) {
    return std::log(std::abs(coarse_error / fine_error)) / std::log(ratio);
}

}  // namespace tricontact::fem
