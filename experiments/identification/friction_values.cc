#include "experiments/identification/friction_values.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/half_space_scales.h"
#include "experiments/identification/layer_contact.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/hertz_under_law.h"
#include "theory/oscillating_cylinder.h"
#include "theory/springs/sprung_contact.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using Table = IdentificationInput::Table;

theory::HertzUnderLaw under_law(const Case& rig, double normal_force) {
    const contact::HalfSpaceScales hertz =
        contact::hertz_scales(rig.materials(), rig.indenter.radius, normal_force, 1);
    return {rig.friction, hertz.contact_radius, hertz.peak_pressure,
            rig.materials().effective_shear_modulus()};
}

theory::SprungContact on_springs(const Case& rig, double normal_force) {
    return {rig.friction,
            rig.interface,
            rig.indenter.radius,
            normal_force,
            rig.materials().effective_modulus(),
            rig.materials().effective_shear_modulus()};
}

// Below the limit the way to U_max goes with this power of the force's: Coulomb's and a strength's.
constexpr double power_of_sliding = 2. / 3;

/// Above what the law carries shifts go on rising.
template <typename Contact>
std::vector<double> shifts_of(const Contact& contact, const std::vector<double>& forces) {
    const double limit = contact.friction_limit();
    std::vector<double> shifts;
    for (const double force : forces)
        shifts.push_back(force <= limit ? contact.shift(force)
                                        : contact.unit_shift() *
                                              (1 + std::pow(force / limit - 1, power_of_sliding)));
    return shifts;
}

}  // namespace

std::vector<LoadedRows> rows_by_load(const Table& table, const Case& rig,
                                     const std::vector<double>& given) {
    std::map<double, LoadedRows> loads;
    for (std::size_t row = 0; row < given.size(); ++row) {
        const double force =
            table.normal_forces.empty() ? *rig.load.normal_force : table.normal_forces.at(row);
        LoadedRows& one = loads[force];
        one.normal_force = force;
        one.rows.push_back(row);
        one.given.push_back(given[row]);
    }
    std::vector<LoadedRows> all;
    for (auto& [force, one] : loads) all.push_back(std::move(one));
    return all;
}

std::vector<double> by_load(
    const Table& table, const Case& rig, const std::vector<double>& given,
    const std::function<std::vector<double>(const Case&, const std::vector<double>&)>& values) {
    if (table.normal_forces.empty()) return values(rig, given);
    std::vector<double> all(given.size());
    for (const LoadedRows& load : rows_by_load(table, rig, given)) {
        Case c = rig;
        c.load.normal_force = load.normal_force;
        const std::vector<double> of_load = values(c, load.given);
        if (of_load.empty()) return {};
        for (std::size_t i = 0; i < of_load.size(); ++i) all[load.rows[i]] = of_load[i];
    }
    return all;
}

std::vector<double> theory_shifts(bool on_layer, const Case& rig,
                                  const std::vector<double>& forces) {
    if (on_layer) return shifts_of(layer_contact(rig, *rig.load.normal_force), forces);
    if (rig.interface.is_elastic())
        return shifts_of(on_springs(rig, *rig.load.normal_force), forces);
    if (!rig.friction.is_coulomb())
        return shifts_of(under_law(rig, *rig.load.normal_force), forces);
    const contact::HalfSpaceScales hertz = contact::half_space_scales(rig);
    const double limit = rig.friction_coefficient() * hertz.normal_force;
    const double line_factor = rig.is_line_contact() ? contact::line_shift_factor(rig) : 0;
    std::vector<double> shifts;
    for (const double force : forces) {
        const double f = std::min(1., force / limit);  // rounding may make the largest reach it
        shifts.push_back(hertz.unit_shift * (rig.is_line_contact()
                                                 ? theory::line_static_shift_ratio(f, line_factor)
                                                 : theory::static_shift_ratio(f)));
    }
    return shifts;
}

std::vector<double> sliding_forces(bool on_layer, const Case& rig,
                                   const std::vector<double>& normal_forces) {
    std::vector<double> forces;
    for (const double force : normal_forces)
        forces.push_back(force <= 0                  ? 0
                         : rig.friction.is_coulomb() ? rig.friction_coefficient() * force
                         : on_layer                  ? layer_contact(rig, force).friction_limit()
                         : rig.interface.normal_stiffness ? on_springs(rig, force).friction_limit()
                                                          : under_law(rig, force).friction_limit());
    return forces;
}

Pressed half_space_press(const Case& rig, const contact::NormalControl& control) {
    if (rig.interface.normal_stiffness) {
        const theory::SprungPress press =
            theory::press_on_springs(rig.indenter.radius, rig.materials().effective_modulus(),
                                     *rig.interface.normal_stiffness, control);
        return {press.normal_force, press.contact_radius, press.indentation};
    }
    Case c = rig;
    // Scales of laws cost integrals, and nothing asks for them.
    c.friction = {.coefficient = 1};
    c.load.normal_force.reset();
    c.load.indentation.reset();
    (control.kind == contact::NormalControl::Kind::force ? c.load.normal_force
                                                         : c.load.indentation) = control.value;
    const contact::HalfSpaceScales hertz = contact::half_space_scales(c);
    return {hertz.normal_force, hertz.contact_radius, hertz.indentation};
}

}  // namespace tricontact::experiments
