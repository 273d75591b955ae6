// What a relaxing bed says about its state: audit, record, scales, surface.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/special_values.h"
#include "mdr/line_surface.h"
#include "mdr/relaxing_bed.h"
#include "mdr/tangential_step.h"

namespace tricontact::mdr {

using contact::ContactState;
using contact::LoadStep;
using contact::NormalControl;
using contact::TangentialControl;

namespace {

/// What the springs' work misses to be stored or dissipated in them, over the magnitudes of all
/// that is added up: each of the sums is right to contact::sum_rounding of its own.
double imbalance(const SpringMemory::Sums& sums, double stored_before) {
    const double used = sums.stored - stored_before + sums.dissipated;
    const double turned_over = sums.turnover + sums.stored + stored_before + sums.dissipated;
    return turned_over == 0 ? 0 : std::abs(sums.work - used) / turned_over;
}

}  // namespace

void RelaxingBed::audit_step(const LoadStep& step, const SlipSums& sums) {
    const double peak_bound = bound_ratio_ * depth_;
    audit_.record("spring_law",
                  std::max(pressing_.law_error, shearing_.law_error / bound_ratio_) / depth_,
                  rounding);
    audit_.record("friction_bound", sums.bound_excess / peak_bound, 0);
    audit_.record("slip_along_traction", -sums.lowest_work / (peak_bound * peak_bound), 0);
    if (step.normal.kind == NormalControl::Kind::force)
        audit_.record("normal_force", std::abs(normal_force_ / step.normal.value - 1), rounding);
    const TangentialControl& control = step.tangential[0];
    if (friction_ && n_contact_ > 0 && control.kind == TangentialControl::Kind::force)
        audit_.record(
            "tangential_force",
            std::abs(tangential_force_ - control.value) / (friction_coefficient_ * normal_force_),
            rounding);
    // The work on the springs is stored or dissipated in them; slip is the rest of the shift, and
    // friction takes the rest of its work.
    audit_.record("energy_balance",
                  contact::larger(imbalance(pressing_, stored_in_pressing_),
                                  imbalance(shearing_, stored_in_shearing_)),
                  rounding);
    stored_in_pressing_ = pressing_.stored;
    stored_in_shearing_ = shearing_.stored;
}

contact::StepRecord RelaxingBed::record(const LoadStep& step, const SlipSums& sums) const {
    const double dx = row_.spacing, dk_x = effective_shear_modulus_ * dx;
    auto disc = [dx](double n_springs) {
        return std::numbers::pi / 4 * n_springs * n_springs * dx * dx;
    };
    contact::StepRecord r;
    r.phase = step.phase;
    r.offset = step.offset;
    r.normal_force = normal_force_;
    r.tangential_force = {tangential_force_, 0};
    r.indentation = depth_;
    r.shift = {shift_, 0};
    r.dissipation = dk_x * tangential_.stiffness() * sums.dissipated;
    r.material_dissipation =
        effective_modulus_ * dx * pressing_.dissipated + dk_x * shearing_.dissipated;
    r.stored_energy = effective_modulus_ * dx * stored_in_pressing_ + dk_x * stored_in_shearing_;
    r.contact_area = disc(n_contact_);
    r.stick_area = disc(std::min(sums.n_stick, n_contact_));
    r.slip_area = r.contact_area - r.stick_area;
    r.open_area = disc(size()) - r.contact_area;
    if (step.normal.kind == NormalControl::Kind::force)
        r.normal_residual = std::abs(normal_force_ / step.normal.value - 1);
    r.force_residual = r.normal_residual;
    const TangentialControl& control = step.tangential[0];
    if (friction_ && n_contact_ > 0 && control.kind == TangentialControl::Kind::force)
        r.force_residual = std::max(r.force_residual, std::abs(tangential_force_ - control.value) /
                                                          (friction_coefficient_ * normal_force_));
    return r;
}

contact::Scales RelaxingBed::scales() const {
    std::vector<double> load(size());
    for (int i = 0; i < size(); ++i)
        load[i] = effective_modulus_ * normal_.stiffness() * pressed_[i];
    const EvenLoad even = even_load(row_, load, position_, size());
    return {.normal_force = normal_force_,
            .contact_radius = even.half_width(),
            .indentation = depth_,
            .peak_pressure = even.centre_pressure(),
            .unit_shift = bound_ratio_ * depth_};
}

contact::Surface RelaxingBed::surface() const {
    LineFields f{.row = row_, .position = position_, .friction_coefficient = friction_coefficient_};
    const double stiffness = normal_.stiffness();
    f.displacement_x = tangential_.deflection();
    f.displacement_z = normal_.deflection();
    for (int i = 0; i < size(); ++i) {
        const double x = std::abs(row_.position(i) - position_);
        const double gap =
            profile_->value(std::min(x, profile_->range())) + normal_.deflection()[i] - depth_;
        const contact::ContactState state = contact_state(i);
        f.normal_load.push_back(effective_modulus_ * stiffness * pressed_[i]);
        f.tangential_load.push_back(effective_shear_modulus_ * stiffness * sheared_[i]);
        f.gap.push_back(state == contact::ContactState::open ? std::max(gap, 0.) : 0.);
        f.slip_x.push_back(state == contact::ContactState::slip ? slip(i) : 0.);
    }
    f.contact_state = contact_states();
    return make_line_surface(f);
}

contact::ContactState RelaxingBed::contact_state(int spring) const {
    if (!(pressed_[spring] > 0)) return contact::ContactState::open;
    return std::abs(slip(spring)) > negligible_slip() ? contact::ContactState::slip
                                                      : contact::ContactState::stick;
}

std::vector<contact::ContactState> RelaxingBed::contact_states() const {
    std::vector<contact::ContactState> states;
    states.reserve(size());
    for (int i = 0; i < size(); ++i) states.push_back(contact_state(i));
    return states;
}

}  // namespace tricontact::mdr
