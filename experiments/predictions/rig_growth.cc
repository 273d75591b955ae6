#include "experiments/predictions/rig_growth.h"

#include <cmath>

#include "atlas/prediction.h"
#include "comparisons/quantities/quantities.h"
#include "contact/models/model_kind.h"

namespace tricontact::experiments {

contact::Case sphere_on_layer(const Rig& rig) {
    contact::Case c;
    c.indenter.radius = rig.c.indenter.radius;
    c.substrate = rig.c.substrate;
    c.layer.thickness = rig.c.layer.thickness;
    c.friction = rig.c.friction;
    c.load.normal_force = rig.c.load.normal_force;
    c.load.tangential_ratio = coupling_tangential_ratio;
    return c;
}

namespace {

/// U_sd/U_stat with its standard error; empty where the maps do not reach.
std::optional<statistics::Estimate> growth_of(const atlas::Prediction& p) {
    namespace quantities = comparisons::quantities;
    const auto* at_rest = p.find(quantities::static_shift_ratio);
    const auto* settled = p.find(quantities::settled_shift_ratio);
    if (!at_rest || !settled) return {};
    const double growth = settled->value.value / at_rest->value.value;
    return statistics::Estimate{
        growth, growth * std::hypot(settled->value.standard_error() / settled->value.value,
                                    at_rest->value.standard_error() / at_rest->value.value)};
}

}  // namespace

std::optional<Growth> rolled_growth(const Rig& rig) {
    namespace quantities = comparisons::quantities;
    const double amplitude = smallest_rolling_amplitude(rig);
    contact::Case c = sphere_on_layer(rig);
    c.rolling.emplace();
    c.rolling->amplitude = amplitude;
    if (rig.c.rolling) c.rolling->angle = rig.c.rolling->angle;
    c.load.tangential_ratio.reset();
    c.load.limit_fraction = .5;
    const atlas::Prediction layer = atlas::predict(c, contact::models::bem_layer);
    const auto* load = layer.find(quantities::tangential_ratio);
    if (!load) return {};
    c.load.set_tangential_ratio(load->value.value);
    c.layer = {};
    c.contact.coupling = false;
    const auto on_layer = growth_of(layer),
               on_half_space = growth_of(atlas::predict(c, contact::models::bem));
    if (!on_layer || !on_half_space) return {};
    return Growth{amplitude, load->value.value, *on_half_space, *on_layer};
}

}  // namespace tricontact::experiments
