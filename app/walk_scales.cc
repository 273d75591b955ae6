#include "app/walk_scales.h"

#include <fmt/format.h>

#include "dynamics/stable_step.h"

namespace tricontact::app {

std::string walk_scales_text(const dynamics::WalkCase& c) {
    std::string text = "# What follows from it (Wetter (2016), chapter 4)\n";
    auto line = [&](const char* name, double value, const char* unit, const char* meaning) {
        text += fmt::format("# {:<8} = {:>12.6g} {:<4} {}\n", name, value, unit, meaning);
    };
    if (c.dimensional) {
        const dynamics::Kappas& k = c.machine.kappas;
        line("k_x", c.dimensional->tangential_stiffness, "N/m", "of a contact spot");
        line("k_z", c.dimensional->normal_stiffness, "N/m", "of a contact spot");
        line("tau", characteristic_time(*c.dimensional), "s", "sqrt(m/k_x), the unit of time");
        line("kappa1", k.kappa1, "-", "k_s/k_x");
        line("kappa2", k.kappa2, "-", "k_z/k_x");
        line("kappa3", k.kappa3, "-", "a/b");
        line("kappa4", k.kappa4, "-", "m g/(k_x b)");
        line("kappa5", k.kappa5, "-", "mu");
        line("kappa6", k.kappa6, "-", "(v_0/b) sqrt(m/k_x)");
        line("kappa7", k.kappa7, "-", "Theta/(m b^2)");
        line("kappa8", k.kappa8, "-", "h/a");
    }
    line("z_stat", static_displacement(c.machine), "-", "static displacement over b");
    line("mu_c", critical_friction(c.machine), "-", "tilts above, sliding steadily");
    line("dt_max", dynamics::stable_step(c.machine), "-", "stable limit of time.step");
    line("end", c.time.end, "-", "of the run, in units of sqrt(m/k_x)");
    return text;
}

}  // namespace tricontact::app
