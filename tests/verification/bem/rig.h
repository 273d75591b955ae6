#pragma once

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/run.h"

namespace tricontact::bem {

/// The rig of table 5.1.1 on 0.2 mm cells, by turning points unless changed.
inline contact::Case rig_case(double w, double tangential_ratio, int periods) {
    contact::Case c;
    c.indenter.radius = 0.04;
    c.indenter.material = contact::Material{206e9, 0.3};
    c.substrate = {5.2e6, 0.5};
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = tangential_ratio;
    c.rolling = contact::Case::Rolling{};
    c.rolling->amplitude_ratio = w;
    c.rolling->periods = periods;
    c.rolling->steps = contact::Case::Steps::turning_points;
    c.of<contact::Cells>().spacing = 2e-4;
    return c;
}

inline contact::History run_bem(const contact::Case& c) {
    const auto model = make_model(c, 1);
    return contact::run(c, *model);
}

inline double static_ratio(const contact::History& h) {
    return h.static_shift / h.scales.unit_shift;
}
inline double final_ratio(const contact::History& h) {
    return h.shift_per_period.back() / h.scales.unit_shift;
}
/// Du of the last period over U_max.
inline double increment_ratio(const contact::History& h) {
    const auto& u = h.shift_per_period;
    return (u.back() - u[u.size() - 2]) / h.scales.unit_shift;
}

}  // namespace tricontact::bem
