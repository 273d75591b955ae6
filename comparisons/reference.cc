#include "comparisons/reference.h"

#include "theory/cattaneo_mindlin.h"
#include "theory/oscillating_rolling.h"

namespace tricontact::comparisons {

bool constant_loads(const contact::Case& c) {
    return c.load.normal_amplitude_ratio == 0 && c.load.tangential_amplitude_ratio == 0;
}

bool in_unit_range(double ratio) {
    return ratio >= 0 && ratio <= 1;
}

double tangential_ratio(const contact::History& history) {
    return history.friction_limit > 0 ? history.tangential_force / history.friction_limit : 0;
}

double amplitude_ratio(const contact::History& history) {
    return history.amplitude / history.scales.contact_radius;
}

Reference reference(const contact::Case& c) {
    Reference r;
    r.hertz = contact::half_space_scales(c);
    const double friction_limit = c.friction_coefficient * r.hertz.normal_force;
    r.tangential_ratio = c.load.tangential_ratio
                             ? *c.load.tangential_ratio
                             : c.load.tangential_force.value_or(0) / friction_limit;
    const double f = r.tangential_ratio;
    if (!in_unit_range(f)) return r;
    r.static_shift_ratio = theory::static_shift_ratio(f);
    if (!c.rolling) return r;
    r.amplitude_ratio =
        contact::rolling_amplitude(*c.rolling, r.hertz.contact_radius) / r.hertz.contact_radius;
    const double w = r.amplitude_ratio;
    if (!constant_loads(c) || !in_unit_range(w)) return r;
    r.limit_tangential_ratio = theory::shakedown_limit(w);
    r.limit_amplitude_ratio = theory::amplitude_limit(f);
    r.shakedown_shift_ratio = theory::settled_shift_ratio(w, f);
    return r;
}

}  // namespace tricontact::comparisons
