#pragma once

#include "comparisons/quantities/quantity.h"

/// The quantities that studies and reports ask for by name. One that only files, tables and plots
/// show needs no name here.
namespace tricontact::comparisons::quantities {

extern const Quantity normal_force, indentation, contact_radius, peak_pressure, unit_shift,
    tangential_ratio, amplitude, amplitude_ratio;  // contact.cc
/// Of theory and of a layer's comparison, not of every run.
extern const Quantity normal_stiffness, tangential_stiffness, coupled_tangential_stiffness,
    shift_of_rolling;
extern const Quantity border_force_share;  // of height maps, contact.cc
// Of a pin in a hole, contact.cc.
extern const Quantity contact_half_angle, conforming_peak, clearance_ratio;
// Of a body between unlike plates, contact.cc.
extern const Quantity upper_indentation, upper_contact_radius, upper_peak_pressure;
extern const Quantity static_shift, static_shift_ratio, final_shift, final_shift_ratio,
    settled_shift, settled_shift_ratio, settled_shift_error_ratio, shift_increment,
    shift_increment_ratio, shift_ratio_per_period, state, periods;                 // shift.cc
extern const Quantity limit_tangential_ratio, limit_amplitude_ratio, stick_ratio;  // limit.cc
extern const Quantity kappa, eta;                                                  // mapping.cc
extern const Quantity dissipation, dissipation_ratio_per_period, path_work,
    path_force;  // dissipation.cc
extern const Quantity loop_force, loop_shift, loop_secant_stiffness, loop_tangent_stiffness,
    loop_aperture, sliding_ratio, slip_regime, path_regime, regime_changes_at, loop_stick_radius,
    gross_slip_shift, drive_shift, drive_secant_stiffness, drive_sliding_ratio;  // loop.cc
extern const Quantity released_energy, steps_of_other_states, pull_off_force,    // jumps.cc
    pull_off_radius, pull_off_indentation, last_indentation;
extern const Quantity frequency, storage_modulus, loss_modulus;  // relaxation.cc
extern const Quantity largest_stretch, largest_shear;            // strain.cc
extern const Quantity end_normal_force, end_indentation, contact_area, stick_area, slip_area,
    stored_energy,
    friction_energy;  // end_of_run.cc
extern const Quantity strength_normal_force, strength_tangential_force, strength_bulk_stress,
    yield_factor, first_yield_force, trailing_stress;  // strength/
extern const Quantity steps, wall_time;                // cost.cc

/// The declarations of each file.
using List = std::vector<const Quantity*>;
List of_contact(), of_shift(), of_limit(), of_mapping(), of_dissipation(), of_loop(), of_jumps(),
    of_relaxation(), of_roller(), of_subsurface(), of_strength(), of_strain(), of_end_of_run(),
    of_cost();

}  // namespace tricontact::comparisons::quantities
