// What a surface model notes about each step: the record and the audit.

#include <algorithm>
#include <cmath>

#include "contact/surface_audit.h"
#include "contact/surface_model.h"

namespace tricontact::contact {

namespace {
constexpr double product_rounding = 1e-13;
}  // namespace

StepRecord SurfaceModel::record(const LoadStep& step) const {
    const auto& area = points().area;
    const bool mirrored = points().mirrored;
    const auto& p = normal_->pressure;
    const auto& t = tangential_.traction;
    StepRecord r;
    r.phase = step.phase;
    r.offset = step.offset;
    r.indentation = normal_->indentation;
    r.shift = shift_;
    r.normal_force = coupling_.normal_force(t);
    r.tangential_force = coupling_.tangential_force(p);
    for (std::size_t i = 0; i < bound_.size(); ++i) {
        r.normal_force += area[i] * p[i];
        r.tangential_force[0] += area[i] * t.x[i];
        if (!mirrored) r.tangential_force[1] += area[i] * t.y[i];
        switch (contact_state_[i]) {
            case ContactState::open:
                r.open_area += area[i];
                break;
            case ContactState::stick:
                r.stick_area += area[i];
                break;
            case ContactState::slip:
                r.slip_area += area[i];
                r.dissipation += area[i] * friction_work(i);
                break;
        }
    }
    r.material_dissipation = material_dissipation_;
    r.stored_energy = energy_;
    r.contact_area = r.stick_area + r.slip_area;
    r.normal_iterations = normal_iterations_;
    r.tangential_iterations = tangential_iterations_;
    r.normal_residual = std::max(normal_->residual, gap_residual_);
    r.tangential_residual = tangential_.residual;
    r.force_residual = tangential_.force_residual;
    if (step.normal.kind == NormalControl::Kind::force)
        r.force_residual = std::max(
            r.force_residual, std::abs(r.normal_force - step.normal.value) / step.normal.value);
    return r;
}

void SurfaceModel::audit_step(const LoadStep& step, bool carried) {
    const ContactPoints& points = this->points();
    const auto& p = normal_->pressure;
    const auto& t = tangential_.traction;
    const EnergyBalance energy = update_energy();
    if (normal_->force == 0) return;  // withdrawn: nothing to compare errors with
    // Parts that inclined tractions carry follow the rest to the tolerance of the turns.
    const double force_allowed = coupling_.deformed() ? 10 * tolerance_ : exact_force;
    NormalControl normal = step.normal;
    if (normal.kind == NormalControl::Kind::force) normal.value -= coupling_.normal_force(t);
    audit_normal(*normal_, normal, points.area, std::max(tolerance_, normal_->rounding), audit_,
                 force_allowed);
    if (is_coupled()) audit_.record("normal_and_tangential_agree", gap_residual_, tolerance_);
    const SurfaceField all = tractions();
    const auto missing = substrate_->compliance().missing_reaction(all.down, all.in_surface);
    if (missing)
        audit_.record("base_reaction",
                      std::hypot((*missing)[0], (*missing)[1], (*missing)[2]) / normal_->force,
                      substrate_->compliance().allowed_missing_reaction());

    if (step.friction) {
        std::array<TangentialControl, 2> tangential = forces_and_shifts(step);
        const Vector2 by_pressure = coupling_.tangential_force(p);
        for (int d = 0; d < 2; ++d) tangential[d].value -= by_pressure[d];
        if (points.mirrored) tangential[1].kind = TangentialControl::Kind::shift;
        audit_tangential({.bound = bound_,
                          .area = points.area,
                          .traction = t,
                          .slip = slip_,
                          .contact_state = contact_state_,
                          .control = tangential,
                          .length = shift_factor_ * friction_coefficient_ * normal_->length,
                          .inclined_force = coupling_.inclined_force(p)},
                         tolerance_, audit_, force_allowed);
    }
    // What relaxes takes energy out of a frame that leaves it behind.
    if (carried && substrate_->relaxes()) return;
    // The forces' work is that on the surface plus what friction dissipates, of the order mu^2 F d.
    // Rounding goes with all that is turned over, F d under whatever friction: a product of the
    // compliance adds up a thousand terms, each to half an epsilon, or more where they cancel.
    // A displaced surface meets the indenter to the tolerance of the turns, over d.
    const double factor = friction_coefficient_ * friction_coefficient_ + coupling_.deformed();
    const double by_friction = factor * normal_->force * normal_->length;
    const double by_rounding = std::max(product_rounding, normal_->rounding) * energy.magnitude;
    audit_.record("energy_balance",
                  std::abs(energy.missing) / (by_friction + by_rounding / force_allowed),
                  force_allowed);
}

/// Ends the step of the substrate.
SurfaceModel::EnergyBalance SurfaceModel::update_energy() {
    const double energy_before = energy_;
    const Substrate::Energies energies = substrate_->end(tractions(), displacements());
    energy_ = energies.stored;
    material_dissipation_ = energies.dissipated;
    return {energies.work - (energy_ - energy_before + material_dissipation_),
            energies.magnitude + std::abs(energy_before)};
}

}  // namespace tricontact::contact
