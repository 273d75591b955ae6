#include "contact/surface_audit.h"

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "contact/compliances/blocks.h"
#include "contact/compliances/point_sums.h"
#include "contact/surface_model.h"

// What a surface model notes about each step: the record and the audit.

namespace tricontact::contact {

namespace {

constexpr double product_rounding = 1e-13;
/// Of surfaces that attract each other: of the integral of the force on the way.
constexpr double exact_work = 1e-3;

struct NormalExtremes {
    double peak = 0, least = 0, force = 0;
    void add(double highest, double lowest, double part) {
        peak = larger(peak, highest);
        least = -larger(-least, -lowest);
        force += part;
    }
    NormalExtremes& operator+=(const NormalExtremes& other) {
        add(other.peak, other.least, other.force);
        return *this;
    }
};

/// What the points have in the worst case, and together.
struct TangentialExtremes {
    double total_bound = 0, contact_area = 0;
    double excess = 0, stick = 0, across = 0, backward = 0, largest_slip = 0;
    Vector2 force{};
    TangentialExtremes& operator+=(const TangentialExtremes& other) {
        total_bound += other.total_bound;
        contact_area += other.contact_area;
        excess = larger(excess, other.excess);
        stick = larger(stick, other.stick);
        across = larger(across, other.across);
        backward = larger(backward, other.backward);
        largest_slip = larger(largest_slip, other.largest_slip);
        force = force + other.force;
        return *this;
    }
};

}  // namespace

void audit_normal(const NormalSolution& solution, const NormalControl& control,
                  const std::vector<double>& area, double tolerance, Audit& audit, int n_threads) {
    const auto& p = solution.pressure;
    const auto [peak, least, force] =
        Blocks(p.size(), n_threads)
            .sum_points<NormalExtremes>(
                [&](NormalExtremes& all, std::size_t i) { all.add(p[i], p[i], area[i] * p[i]); });
    audit.record("pressure_nonnegative", -least / peak, 0);
    audit.record("gap_and_complementarity", solution.residual, tolerance);
    if (control.kind == NormalControl::Kind::force)
        audit.record("normal_force", std::abs(force - control.value) / control.value, exact_force);
}

void audit_tangential(const TangentialFacts& facts, double tolerance, Audit& audit) {
    const auto add = [&](TangentialExtremes& all, std::size_t i) {
        const Vector2 t = facts.traction.at(i), s = facts.slip.at(i);
        all.force = all.force + facts.area[i] * t;
        all.total_bound += facts.area[i] * facts.bound[i];
        all.excess = larger(all.excess, norm(t) - facts.bound[i]);
        if (facts.contact_state[i] == ContactState::open) return;
        all.contact_area += facts.area[i];
        all.largest_slip = larger(all.largest_slip, norm(s));
        if (facts.contact_state[i] == ContactState::stick) {
            all.stick = larger(all.stick, norm(s));
        } else if (facts.bound[i] > 0) {  // what carries nothing slips in any direction
            all.across = larger(all.across, std::abs(s[0] * t[1] - s[1] * t[0]) / norm(t));
            all.backward = larger(all.backward, -dot(s, t) / norm(t));
        }
    };
    const auto [total_bound, contact_area, excess, stick, across, backward, largest_slip, force] =
        Blocks(facts.bound.size(), facts.n_threads).sum_points<TangentialExtremes>(add);
    const double mean_bound = total_bound / contact_area;
    audit.record("friction_bound", excess / mean_bound, facts.excess_allowed);
    // `stick` counts points at the bound whose slip is below the threshold of the classification.
    audit.record("no_slip_where_stick", stick / facts.length, 10 * tolerance);
    // Directions of tractions are known to the tolerance: what slips across them is that part of
    // the slip. At small friction pressures move the surface by beta d, which may be much more than
    // mu d.
    audit.record("slip_along_traction",
                 larger(across, backward) / larger(facts.length, largest_slip), 10 * tolerance);
    for (int d = 0; d < 2; ++d)
        if (facts.control[d].kind == TangentialControl::Kind::force)
            audit.record("tangential_force",
                         std::abs(force[d] - facts.control[d].value) / total_bound, exact_force);
}

StepRecord SurfaceModel::record(const LoadStep& step) const {
    const auto& area = points().area;
    const bool mirrored = points().mirrored;
    const auto& p = now().normal->pressure;
    const auto& t = now().tangential.traction;
    const Vector2 centre = centre_of(step);
    StepRecord r;
    r.phase = step.phase;
    r.offset = step.offset;
    r.indentation = now().normal->indentation;
    r.shift = now().shift;
    r.rotation = rotation_;
    using Forces = Sums<5>;  // normal, tangential, torque; dissipation
    using Areas = Sums<3>;   // open, stick, slip
    const Blocks all = blocks(now().bound.size());
    const auto forces =
        all.sum_points<Forces>([&](Forces& sum, std::size_t i) {
               sum[0] += area[i] * p[i];
               sum[1] += area[i] * t.x[i];
               if (!mirrored) {
                   sum[2] += area[i] * t.y[i];
                   const Vector2 from = Vector2{points().x[i], points().y[i]} - centre;
                   sum[3] += area[i] * (from[0] * t.y[i] - from[1] * t.x[i]);
               }
               if (contact_state_[i] == ContactState::slip) sum[4] += area[i] * friction_work(i);
           })
            .values;
    r.normal_force = forces[0];
    r.tangential_force = {forces[1], forces[2]};
    r.torque = forces[3];
    r.dissipation = forces[4];
    const auto& share = now().normal->share;
    const auto areas = all.sum_points<Areas>([&](Areas& sum, std::size_t i) {
                              const auto state = static_cast<std::size_t>(contact_state_[i]);
                              if (share.empty()) {
                                  sum[state] += area[i];
                                  return;
                              }
                              sum[state] += share[i] * area[i];
                              sum[0] += (1 - share[i]) * area[i];
                          })
                           .values;
    r.open_area = areas[0];
    r.stick_area = areas[1];
    r.slip_area = areas[2];
    r.material_dissipation = material_dissipation_;
    r.stored_energy = energy_;
    r.released_energy = released_ + now().normal->released;
    r.may_differ = now().may_differ;
    r.contact_area = r.stick_area + r.slip_area;
    r.normal_iterations = now().normal_iterations;
    r.tangential_iterations = now().tangential_iterations;
    r.normal_residual = std::max(now().normal->residual, now().gap_residual);
    r.tangential_residual = now().tangential.residual;
    r.force_residual = now().tangential.force_residual;
    if (step.normal.kind == NormalControl::Kind::force)
        r.force_residual =
            std::max(r.force_residual, std::abs(r.normal_force - step.normal.value) /
                                           (step.normal.value + 2 * now().normal->pull));
    return r;
}

/// Tension by the law of the gap (or touch), no more of it than sigma_0, the force, the ground.
void SurfaceModel::audit_attracted(const LoadStep& step) {
    const NormalSolution& s = *now().normal;
    const auto& area = points().area;
    const double pull = 2 * s.pull;
    double most = 0, force = 0;
    for (std::size_t i = 0; i < s.pressure.size(); ++i) {
        most = larger(most, -s.pressure[i]);
        force += area[i] * s.pressure[i];
    }
    audit_.record("traction_follows_separation", s.residual, std::max(tolerance_, s.rounding));
    audit_.record("energy_balance", std::abs(s.unbalanced), exact_work);
    audit_.record("tension_at_most_sigma_0",
                  std::max(0., most / solver_->adhesive()->attraction().strength - 1),
                  rounding_allowed);
    if (step.normal.kind == NormalControl::Kind::force)
        audit_.record("normal_force",
                      std::abs(force - step.normal.value) / (std::abs(step.normal.value) + pull),
                      exact_force);
    const auto missing =
        substrate_->compliance().missing_reaction(s.pressure, now().tangential.traction);
    if (missing && pull > 0)
        audit_.record("base_reaction",
                      std::hypot((*missing)[0], (*missing)[1], (*missing)[2]) /
                          (pull + std::abs(force) + now().total_bound),
                      substrate_->compliance().allowed_missing_reaction());
}

void SurfaceModel::audit_step(const LoadStep& step, bool advected) {
    const ContactPoints& points = this->points();
    const EnergyBalance energy = update_energy();
    if (attracted_) {
        audit_attracted(step);
        if (!friction_->coulomb() && now().total_bound > 0) audit_friction(step);
        return;
    }
    if (now().normal->force == 0) return;  // withdrawn: nothing to compare errors with
    audit_normal(*now().normal, step.normal, points.area,
                 std::max(tolerance_, now().normal->rounding), audit_,
                 substrate_->compliance().n_threads());
    if (is_coupled()) audit_.record("normal_and_tangential_agree", now().gap_residual, tolerance_);
    const auto missing = substrate_->compliance().missing_reaction(now().normal->pressure,
                                                                   now().tangential.traction);
    if (missing)
        audit_.record("base_reaction",
                      std::hypot((*missing)[0], (*missing)[1], (*missing)[2]) / now().normal->force,
                      substrate_->compliance().allowed_missing_reaction());

    audit_friction(step);
    // What relaxes takes energy out of a frame that leaves it behind.
    if (advected && substrate_->relaxes()) return;
    // The forces' work is that on the surface plus what friction dissipates, of the order mu^2 F d.
    // Rounding goes with all that is turned over, F d under whatever friction: a product of the
    // compliance adds up a thousand terms, each to half an epsilon, or more where they cancel.
    const double mu = solver_->friction_ratio();
    const double by_friction = mu * mu * now().normal->force * now().normal->length;
    const double by_rounding =
        std::max(product_rounding, now().normal->rounding) * energy.magnitude;
    audit_.record("energy_balance",
                  std::abs(energy.missing) / (by_friction + by_rounding / exact_force),
                  exact_force);
}

void SurfaceModel::audit_friction(const LoadStep& step) {
    if (!step.friction) return;
    std::array<TangentialControl, 2> tangential = solver_->forces_and_shifts(step);
    if (points().mirrored) tangential[1].kind = TangentialControl::Kind::shift;
    audit_tangential(
        {.bound = now().bound,
         .area = points().area,
         .traction = now().tangential.traction,
         .slip = slip_,
         .contact_state = contact_state_,
         .control = tangential,
         .length = now().shift_factor * solver_->friction_ratio() * now().normal->length,
         .n_threads = substrate_->compliance().n_threads()},
        tolerance_, audit_);
}

/// Ends the step of the substrate.
SurfaceModel::EnergyBalance SurfaceModel::update_energy() {
    const double energy_before = energy_;
    const Substrate::Energies energies = substrate_->end(solver_->tractions(), now().displacement);
    energy_ = energies.stored;
    material_dissipation_ = energies.dissipated;
    return {energies.work - (energy_ - energy_before + material_dissipation_),
            energies.magnitude + std::abs(energy_before)};
}

}  // namespace tricontact::contact
