#include "app/rig_growth.h"

#include <cmath>

#include "atlas/prediction.h"
#include "comparisons/quantities/quantities.h"
#include "contact/models/model_kind.h"

namespace tricontact::app {

using contact::Case;

Case sphere_on_layer(const experiments::Rig& rig) {
    Case c;
    c.indenter.radius = rig["R"].value;
    c.substrate = {rig["E_2"].value, rig["nu_2"].value};
    c.layer.thickness = rig["b"].value;
    c.friction.coefficient = rig["mu"].value;
    c.load.normal_force = rig["F_N"].value;
    c.load.tangential_ratio = experiments::coupling_tangential_ratio;
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

std::optional<experiments::Growth> rolled_growth(const experiments::Rig& rig) {
    namespace quantities = comparisons::quantities;
    const double amplitude = experiments::smallest_rolling_amplitude(rig);
    Case c = sphere_on_layer(rig);
    c.rolling.emplace();
    c.rolling->amplitude = amplitude;
    if (rig.has("alpha")) c.rolling->angle = rig["alpha"].value;
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
    return experiments::Growth{amplitude, load->value.value, *on_half_space, *on_layer};
}

}  // namespace tricontact::app
