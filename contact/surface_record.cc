// What a surface model notes about each step: the record and the audit.

#include <algorithm>
#include <cmath>

#include "contact/surface_audit.h"
#include "contact/surface_model.h"

namespace tricontact::contact {

StepRecord SurfaceModel::record(const LoadStep& step) const {
    const auto& area = compliance_->points().area;
    const bool mirrored = compliance_->points().mirrored;
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
        r.dissipation += area[i] * (t.x[i] * slip_.x[i] + t.y[i] * slip_.y[i]);
        switch (contact_state_[i]) {
            case ContactState::open:
                r.open_area += area[i];
                break;
            case ContactState::stick:
                r.stick_area += area[i];
                break;
            case ContactState::slip:
                r.slip_area += area[i];
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

void SurfaceModel::audit_step(const LoadStep& step, const Before& before) {
    const ContactPoints& points = compliance_->points();
    const auto& p = normal_->pressure;
    const auto& t = tangential_.traction;
    const double energy_before = energy_;
    update_energy(before);
    if (normal_->force == 0) return;  // withdrawn: nothing to compare errors with
    // Parts that inclined tractions carry follow the rest to the tolerance of the turns.
    const double force_allowed = coupling_.deformed() ? 10 * tolerance_ : exact_force;
    NormalControl normal = step.normal;
    if (normal.kind == NormalControl::Kind::force) normal.value -= coupling_.normal_force(t);
    audit_normal(*normal_, normal, points.area, tolerance_, audit_, force_allowed);
    if (is_coupled()) audit_.record("normal_and_tangential_agree", gap_residual_, tolerance_);
    const auto missing = compliance_->missing_reaction(coupling_.downward_traction(p, t),
                                                       coupling_.surface_traction(p, t));
    if (missing)
        audit_.record("base_reaction",
                      std::hypot((*missing)[0], (*missing)[1], (*missing)[2]) / normal_->force,
                      compliance_->allowed_missing_reaction());

    if (step.friction) {
        std::array<TangentialControl, 2> tangential = step.tangential;
        const Vector2 by_pressure = coupling_.tangential_force(p);
        for (int d = 0; d < 2; ++d) tangential[d].value -= by_pressure[d];
        if (points.mirrored) tangential[1].kind = TangentialControl::Kind::shift;
        audit_tangential({.bound = bound_,
                          .area = points.area,
                          .traction = t,
                          .slip = slip_,
                          .contact_state = contact_state_,
                          .control = tangential,
                          .length = friction_coefficient_ * normal_->indentation},
                         tolerance_, audit_, force_allowed);
    }
    audit_stored_energy(before, energy_before, force_allowed);
}

/// Stored and dissipated energy of the substrate, and the mean tractions by which forces work in
/// the step: by the trapezoidal rule where nothing relaxes, exact for a self-adjoint linear
/// compliance.
void SurfaceModel::update_energy(const Before& before) {
    const auto& area = compliance_->points().area;
    const SurfaceField t{coupling_.surface_traction(normal_->pressure, tangential_.traction),
                         coupling_.downward_traction(normal_->pressure, tangential_.traction)};
    if (!memory_.absent()) {
        const auto energies = memory_.end(t, {displacement_, displacement_z_}, area);
        energy_ = energies.stored;
        material_dissipation_ = energies.dissipated;
        mean_traction_ = memory_.mean_traction();
        return;
    }
    energy_ = 0;
    for (std::size_t i = 0; i < area.size(); ++i) {
        energy_ += area[i] / 2 *
                   (t.down[i] * displacement_z_[i] + t.in_surface.x[i] * displacement_.x[i] +
                    t.in_surface.y[i] * displacement_.y[i]);
        mean_traction_.in_surface.x[i] = (before.surface_traction.x[i] + t.in_surface.x[i]) / 2;
        mean_traction_.in_surface.y[i] = (before.surface_traction.y[i] + t.in_surface.y[i]) / 2;
        mean_traction_.down[i] = (before.downward_traction[i] + t.down[i]) / 2;
    }
}

void SurfaceModel::audit_stored_energy(const Before& before, double energy_before, double allowed) {
    const auto& area = compliance_->points().area;
    double normal_work = 0;
    for (std::size_t i = 0; i < area.size(); ++i)
        normal_work +=
            area[i] * mean_traction_.down[i] * (displacement_z_[i] - before.displacement_z[i]);
    audit_energy({.area = area,
                  .mean_traction = mean_traction_.in_surface,
                  .displacement_before = before.displacement,
                  .displacement = displacement_,
                  .shift_increment = {shift_[0] - before.shift[0], shift_[1] - before.shift[1]},
                  .normal_work = normal_work,
                  .energy_change = energy_ - energy_before + material_dissipation_,
                  .unit = friction_coefficient_ * friction_coefficient_ * normal_->force *
                          normal_->indentation},
                 audit_, allowed);
}

}  // namespace tricontact::contact
