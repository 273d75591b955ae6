#include "rig/force_curves.h"

#include "rig/rolling_formulas.h"

namespace tricontact::rig {

ForceCurves force_curves(const contact::RollingRig& rig) {
    constexpr int n_points = 31;
    ForceCurves curves;
    curves.rig_force = rig.normal_force;
    curves.measured_diameter = rig.measured_contact_size;
    contact::RollingRig loaded = rig;
    for (int i = 0; i < n_points; ++i) {
        const double force = rig.normal_force.value * 1.5 * (i + 1) / n_points;
        loaded.normal_force = {force};
        const contact::HalfSpaceScales hertz = hertz_of(values_of(hertz_given(loaded)));
        const theory::LayerContact layer = layer_of(values_of(layer_given(loaded)));
        curves.force.push_back(force);
        curves.hertz_diameter.push_back(2 * hertz.contact_radius);
        curves.layer_diameter.push_back(2 * layer.contact_radius);
        curves.hertz_indentation.push_back(hertz.indentation);
        curves.layer_indentation.push_back(layer.indentation);
    }
    return curves;
}

}  // namespace tricontact::rig
