#pragma once

#include "contact/surface_model.h"
#include "fem/case/layer_condenser.h"
#include "fem/finite_strain/strained_model.h"
#include "fem/settings.h"
#include "tests/verification/fem/rig.h"

namespace tricontact::fem {

/// The rig on a neo-Hookean layer.
inline contact::Case strained_case(double size, double nu = .5) {
    contact::Case c = layer_case(size, nu);
    c.law = contact::Case::Law::neo_hookean;
    return c;
}

/// The same layer by linear elasticity and at finite strains: what differs is no mesh.
struct BothModels {
    explicit BothModels(const contact::Case& c)
        : layer(LayerCondenser(c, {}).make(make_mesh(c, {}))) {
        linear = std::make_unique<contact::SurfaceModel>(
            "fem", layer, c.make_indenter(), c.friction.law(), c.of<fem::Settings>().tolerance,
            c.contact);
        strained = std::make_unique<StrainedModel>(
            StrainedModel::Setup{.layer = layer,
                                 .indenter = c.make_indenter(),
                                 .rolling_radius = c.indenter.radius,
                                 .friction = c.friction.law(),
                                 .tolerance = of_fem_tolerance * c.of<fem::Settings>().tolerance,
                                 .c01_ratio = {c.c01_ratio.value_or(0), c.c01_ratio.value_or(0)},
                                 .relaxation = {}});
    }
    std::shared_ptr<const CondensedCompliance> layer;
    std::unique_ptr<contact::Model> linear, strained;
};

/// What a bulk that is no longer linear changes, over the linear.
inline double change(double strained, double linear) {
    return strained / linear - 1;
}

}  // namespace tricontact::fem
