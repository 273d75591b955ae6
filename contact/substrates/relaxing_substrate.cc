#include "contact/substrates/relaxing_substrate.h"

#include <cmath>

#include "contact/compensated_sum.h"
#include "contact/solvers/moving_frame.h"
#include "contact/step_integrals.h"

namespace tricontact::contact {

RelaxingSubstrate::RelaxingSubstrate(std::shared_ptr<const Compliance> relaxed,
                                     Relaxation relaxation)
    : compliance_(std::move(relaxed)),
      relaxation_(std::move(relaxation)),
      n_(compliance_->points().size()) {
    check(relaxation_);
    forget();
}

std::unique_ptr<Substrate> RelaxingSubstrate::fresh(bool) const {
    return std::make_unique<RelaxingSubstrate>(compliance_, relaxation_);
}

void RelaxingSubstrate::forget() {
    relaxed_ = offset_ = before_ = SurfaceField(n_);
    branches_.assign(relaxation_.branches.size(), {SurfaceField(n_), SurfaceField(n_)});
}

bool RelaxingSubstrate::begin(double duration, const SurfaceField&, const SurfaceField& u) {
    RelaxationStep step(relaxation_, duration);
    duration_ = duration;
    decay_ = std::move(step.decay);
    gain_ = std::move(step.gain);
    stiffness_ = step.stiffness;
    before_ = u;
    for (int d = 0; d < 3; ++d) {
        auto& offset = *components(offset_)[d];
        const auto& old = *components(u)[d];
        for (std::size_t i = 0; i < n_; ++i) {
            offset[i] = 0;
            for (std::size_t b = 0; b < branches_.size(); ++b)
                offset[i] +=
                    decay_[b] * (*components(branches_[b].displacement)[d])[i] - gain_[b] * old[i];
        }
    }
    return false;
}

void RelaxingSubstrate::carry() {
    const ContactPoints& grid = compliance_->points();
    contact::carry(grid, relaxed_);
    for (Branch& branch : branches_) {
        contact::carry(grid, branch.displacement);
        contact::carry(grid, branch.traction);
    }
}

Substrate::Energies RelaxingSubstrate::end(const SurfaceField& t, const SurfaceField& u) {
    const auto& area = compliance_->points().area;
    CompensatedSum all_stored, all_dissipated, all_work;
    Energies energies;
    std::vector<StepIntegrals> integrals;
    for (const auto& branch : relaxation_.branches) integrals.emplace_back(duration_ / branch.time);
    for (int d = 0; d < 3; ++d)
        for (std::size_t i = 0; i < n_; ++i) {
            auto& relaxed = (*components(relaxed_)[d])[i];
            const double displacement = (*components(u)[d])[i];
            const double before = (*components(before_)[d])[i];
            const double change = displacement - before;
            // t = stiffness K u_new + sum (decay_i K h_i - gain_i K u_old)
            double remembered = 0;
            for (std::size_t b = 0; b < branches_.size(); ++b)
                remembered +=
                    decay_[b] * (*components(branches_[b].traction)[d])[i] - gain_[b] * relaxed;
            const double next = ((*components(t)[d])[i] - remembered) / stiffness_;
            const double driven = next - relaxed;
            double mean = (relaxed + next) / 2;  // traction in the step
            double load = std::abs(relaxed) + std::abs(next);
            relaxed = next;
            double stored = next * displacement, dissipated = 0;
            for (std::size_t b = 0; b < branches_.size(); ++b) {
                const double ratio = relaxation_.branches[b].ratio;
                const StepIntegrals& s = integrals[b];
                auto& h = (*components(branches_[b].displacement)[d])[i];
                auto& k_h = (*components(branches_[b].traction)[d])[i];
                dissipated += k_h * h / ratio * s.ee + (k_h * change + driven * h) * s.ew +
                              ratio * driven * change * s.ww;
                mean += k_h * s.mean + ratio * driven * s.drift;
                load += std::abs(k_h);
                h = decay_[b] * h + gain_[b] * change;
                k_h = decay_[b] * k_h + gain_[b] * driven;
                stored += k_h * h / ratio;
            }
            all_stored.add(area[i] / 2 * stored);
            all_dissipated.add(area[i] * dissipated);
            all_work.add(area[i] * mean * change);
            energies.magnitude +=
                area[i] * (load * (std::abs(displacement) + std::abs(before)) + std::abs(stored));
        }
    energies.stored = all_stored.value();
    energies.dissipated = all_dissipated.value();
    energies.work = all_work.value();
    return energies;
}

/// Strains are those of the tractions K u; energies add up over springs and branches.
std::unique_ptr<const Interior> RelaxingSubstrate::interior(const SurfaceField& t) const {
    auto elastic = [&](const SurfaceField& field) {
        return compliance_->interior(field.down, field.in_surface);
    };
    const auto stressed = elastic(t);
    if (!stressed) return nullptr;
    const auto strained = elastic(relaxed_);
    auto inside = std::make_unique<Interior>(*stressed);
    inside->displacement = strained->displacement;
    inside->strain_energy = strained->strain_energy;
    inside->energy_density = strained->energy_density;
    for (std::size_t b = 0; b < branches_.size(); ++b) {
        const auto branch = elastic(branches_[b].traction);
        const double ratio = relaxation_.branches[b].ratio;
        inside->strain_energy += branch->strain_energy / ratio;
        for (std::size_t k = 0; k < inside->energy_density.size(); ++k)
            inside->energy_density[k] += branch->energy_density[k] / ratio;
    }
    return inside;
}

void RelaxingSubstrate::write(StateWriter& out) const {
    contact::write(relaxed_, out);
    for (const Branch& branch : branches_) {
        contact::write(branch.displacement, out);
        contact::write(branch.traction, out);
    }
}

void RelaxingSubstrate::read(StateReader& in) {
    contact::read(relaxed_, in);
    for (Branch& branch : branches_) {
        contact::read(branch.displacement, in);
        contact::read(branch.traction, in);
    }
}

}  // namespace tricontact::contact
