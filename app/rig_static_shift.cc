#include "app/rig_static_shift.h"

#include <string>

#include "app/models.h"
#include "app/run_model.h"
#include "contact/run.h"
#include "rig/rolling.h"

namespace tricontact::app {

double static_shift(const contact::RollingRig& rig, bool coupled) {
    constexpr const char* model_name = "bem-layer";
    contact::Case c;
    c.models = {model_name};
    c.indenter.radius = rig.roller.radius.value;
    c.substrate = {rig.substrate.young.value, rig.substrate.poisson.value};
    c.layer.thickness = rig.substrate.thickness.value;
    c.friction_coefficient = rig.friction_coefficient.value;
    c.load.normal_force = rig.normal_force.value;
    c.load.tangential_ratio = rig::coupling_tangential_ratio;
    c.contact.coupling = coupled;
    c.bem.cells_per_radius = 22;
    const auto silent = [](const std::string&) {};
    const auto model = make_model(model_name, c, 1, silent);
    const contact::History history = contact::run(c, *model);
    require_sound(model->audit(), model_name);
    return history.static_shift;
}

}  // namespace tricontact::app
