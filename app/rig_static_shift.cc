#include "app/rig_static_shift.h"

#include <string>

#include "app/case_run.h"
#include "experiments/assumptions/check_rig.h"

namespace tricontact::app {

double static_shift(const experiments::RollingRig& rig, bool coupled) {
    constexpr const char* model_name = "bem-layer";
    contact::Case c;
    c.models = {model_name};
    c.indenter.radius = rig.roller.radius.value;
    c.substrate = {rig.substrate.young.value, rig.substrate.poisson.value};
    c.layer.thickness = rig.substrate.thickness.value;
    c.friction_coefficient = rig.friction_coefficient.value;
    c.load.normal_force = rig.normal_force.value;
    c.load.tangential_ratio = experiments::coupling_tangential_ratio;
    c.contact.coupling = coupled;
    c.bem.cells_per_radius = 22;
    return history_of(model_name, c, 1, [](const std::string&) {}).static_shift;
}

}  // namespace tricontact::app
