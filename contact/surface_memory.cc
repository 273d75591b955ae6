#include "contact/surface_memory.h"

#include <array>
#include <cmath>

namespace tricontact::contact {

namespace {

template <class Field>
auto components(Field& field) {
    return std::array{&field.in_surface.x, &field.in_surface.y, &field.down};
}

SurfaceField zeros(std::size_t n) {
    return {TangentialField(n), std::vector<double>(n)};
}

/// Integrals over a step of duration x tau of the dashpot's strain, which starts at e and is driven
/// by w in all: dissipation/g = <e, e> ee + 2 <e, w> ew + <w, w> ww; mean strain = e mean + w
/// drift.
struct StepIntegrals {
    explicit StepIntegrals(double x) {
        if (x < small) {
            ee = x - x * x + 2 * x * x * x / 3;
            ew = x / 2 - x * x / 2 + 7 * x * x * x / 24;
            ww = x / 3 - x * x / 4 + 7 * x * x * x / 60;
            mean = 1 - x / 2 + x * x / 6;
            drift = 1. / 2 - x / 6 + x * x / 24;
            return;
        }
        const double once = -std::expm1(-x);
        ee = -std::expm1(-2 * x) / 2;
        ew = (once - ee) / x;
        ww = std::isinf(x) ? 0 : (ee - 2 * once + x) / (x * x);
        mean = once / x;
        drift = (1 - mean) / x;
    }
    /// Below, the series' next terms are 1e-13 of their first, above, cancellation costs no more.
    static constexpr double small = 1e-4;
    double ee, ew, ww, mean, drift;
};

}  // namespace

SurfaceMemory::SurfaceMemory(std::optional<Relaxation> relaxation, std::size_t n_points)
    : relaxation_(std::move(relaxation)), n_(n_points) {
    if (relaxation_) check(*relaxation_);
    forget();
}

void SurfaceMemory::forget() {
    if (absent()) return;
    relaxed_ = offset_ = mean_ = before_ = zeros(n_);
    branches_.assign(relaxation_->branches.size(), {zeros(n_), zeros(n_)});
}

void SurfaceMemory::begin(double duration, const SurfaceField& u) {
    if (absent()) return;
    const RelaxationStep step(*relaxation_, duration);
    duration_ = duration;
    decay_ = step.decay;
    gain_ = step.gain;
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
}

SurfaceMemory::Energies SurfaceMemory::end(const SurfaceField& t, const SurfaceField& u,
                                           const std::vector<double>& area) {
    Energies energies;
    std::vector<StepIntegrals> integrals;
    for (const auto& branch : relaxation_->branches)
        integrals.emplace_back(duration_ / branch.time);
    for (int d = 0; d < 3; ++d)
        for (std::size_t i = 0; i < n_; ++i) {
            auto& relaxed = (*components(relaxed_)[d])[i];
            auto& mean = (*components(mean_)[d])[i];
            const double displacement = (*components(u)[d])[i];
            const double change = displacement - (*components(before_)[d])[i];
            // t = stiffness K u_new + sum (decay_i K h_i - gain_i K u_old)
            double remembered = 0;
            for (std::size_t b = 0; b < branches_.size(); ++b)
                remembered +=
                    decay_[b] * (*components(branches_[b].traction)[d])[i] - gain_[b] * relaxed;
            const double next = ((*components(t)[d])[i] - remembered) / stiffness_;
            const double driven = next - relaxed;
            mean = (relaxed + next) / 2;
            relaxed = next;
            double stored = next * displacement, dissipated = 0;
            for (std::size_t b = 0; b < branches_.size(); ++b) {
                const double ratio = relaxation_->branches[b].ratio;
                const StepIntegrals& s = integrals[b];
                auto& h = (*components(branches_[b].displacement)[d])[i];
                auto& k_h = (*components(branches_[b].traction)[d])[i];
                dissipated += k_h * h / ratio * s.ee + (k_h * change + driven * h) * s.ew +
                              ratio * driven * change * s.ww;
                mean += k_h * s.mean + ratio * driven * s.drift;
                h = decay_[b] * h + gain_[b] * change;
                k_h = decay_[b] * k_h + gain_[b] * driven;
                stored += k_h * h / ratio;
            }
            energies.stored += area[i] / 2 * stored;
            energies.dissipated += area[i] * dissipated;
        }
    return energies;
}

void SurfaceMemory::write(StateWriter& out) const {
    if (absent()) return;
    auto add = [&](const SurfaceField& field) {
        for (const auto* component : components(field)) out.add(*component);
    };
    add(relaxed_);
    for (const Branch& branch : branches_) {
        add(branch.displacement);
        add(branch.traction);
    }
}

void SurfaceMemory::read(StateReader& in) {
    if (absent()) return;
    auto get = [&](SurfaceField& field) {
        for (auto* component : components(field)) in.get(*component);
    };
    get(relaxed_);
    for (Branch& branch : branches_) {
        get(branch.displacement);
        get(branch.traction);
    }
}

}  // namespace tricontact::contact
