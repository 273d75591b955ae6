#include "mdr/spring_memory.h"

#include <algorithm>
#include <cmath>

#include "contact/base/compensated_sum.h"

namespace tricontact::mdr {

// A branch strains by e = h/ratio, de/dt = change/duration - e/time. With x = duration/time, m the
// mean of exp(-t/time) over the step and r = change/x:
//   e(t) = (e - r) exp(-t/time) + r,   mean e = e m + change (1 - m)/x,
//   1/time ∫ e^2 dt = e^2 (1 - exp(-2x))/2 + e change x m^2 + change^2 [(1 - m)/x - m^2/2].
void SpringMemory::Branch::set_step(double duration) {
    const contact::StepIntegrals integrals(duration / time);
    const contact::RelaxationStep step({{{ratio, time}}, {}}, duration);
    decay = step.decay.front();
    gain = step.gain.front();
    mean_h = gain / ratio;
    mean_u = ratio * integrals.drift;
    dissipated_hh = integrals.ee / ratio;
    dissipated_hu = 2 * integrals.ew;
    dissipated_uu = ratio * integrals.ww;
}

SpringMemory::SpringMemory(const contact::Relaxation& relaxation, int n_springs) {
    const std::vector<double> at_rest(n_springs, 0.0);
    for (const auto& [ratio, time] : relaxation.branches)
        branches_.push_back({.ratio = ratio, .time = time, .h = at_rest});
    deflection_ = free_ = change_ = mean_ = law_ = at_rest;
}

void SpringMemory::begin(double duration, const Window& window) {
    stiffness_ = 1;
    for (Branch& branch : branches_) {
        branch.set_step(duration);
        stiffness_ += branch.gain;
    }
    const double* const u = deflection_.data();
    double* const free = free_.data();
    const double kept = (stiffness_ - 1) / stiffness_;
#pragma omp simd
    for (int i = window.first; i < window.last; ++i) free[i] = kept * u[i];
    for (const Branch& branch : branches_) {
        const double factor = branch.decay / stiffness_;
        const double* const h = branch.h.data();
#pragma omp simd
        for (int i = window.first; i < window.last; ++i) free[i] -= factor * h[i];
    }
}

SpringMemory::Sums SpringMemory::end(const Window& window, const std::vector<double>& force) {
    Sums sums;
    const double* const f = force.data();
    const double* const free = free_.data();
    double* const u = deflection_.data();
    double* const change = change_.data();
    double* const mean = mean_.data();
    double* const law = law_.data();
    const double softness = 1 / stiffness_;
    contact::CompensatedSum all_stored, all_work, all_turnover, all_mean_force;
    contact::for_each_block(window.first, window.last, [&](int begin, int end) {
        double stored = 0;
#pragma omp simd reduction(+ : stored)
        for (int i = begin; i < end; ++i) {
            const double before = u[i];
            u[i] = free[i] + softness * f[i];
            change[i] = u[i] - before;
            mean[i] = (u[i] + before) / 2;
            law[i] = u[i];
            stored += u[i] * u[i] / 2;
        }
        all_stored.add(stored);
    });
    for (Branch& branch : branches_) advance(branch, window, sums);
    double law_error = 0;
    contact::for_each_block(window.first, window.last, [&](int begin, int end) {
        double work = 0, turnover = 0, mean_force = 0;
#pragma omp simd reduction(+ : work, turnover, mean_force) reduction(max : law_error)
        for (int i = begin; i < end; ++i) {
            work += mean[i] * change[i];
            turnover += std::abs(mean[i] * change[i]);
            mean_force += mean[i];
            law_error = std::max(law_error, std::abs(law[i] - f[i]));
        }
        all_work.add(work);
        all_turnover.add(turnover);
        all_mean_force.add(mean_force);
    });
    sums.stored += all_stored.value();
    sums.work = all_work.value();
    sums.turnover = all_turnover.value();
    sums.mean_force = all_mean_force.value();
    sums.law_error = law_error;
    return sums;
}

void SpringMemory::advance(Branch& branch, const Window& window, Sums& sums) {
    const double decay = branch.decay, gain = branch.gain;
    const double mean_h = branch.mean_h, mean_u = branch.mean_u, over = 1 / (2 * branch.ratio);
    const double hh = branch.dissipated_hh, hu = branch.dissipated_hu, uu = branch.dissipated_uu;
    const double* const change = change_.data();
    double* const h = branch.h.data();
    double* const mean = mean_.data();
    double* const law = law_.data();
    contact::CompensatedSum all_stored, all_dissipated;
    contact::for_each_block(window.first, window.last, [&](int begin, int end) {
        double stored = 0, dissipated = 0;
#pragma omp simd reduction(+ : stored, dissipated)
        for (int i = begin; i < end; ++i) {
            const double before = h[i], driven = change[i];
            dissipated += hh * before * before + hu * before * driven + uu * driven * driven;
            mean[i] += mean_h * before + mean_u * driven;
            h[i] = decay * before + gain * driven;
            law[i] += h[i];
            stored += over * h[i] * h[i];
        }
        all_stored.add(stored);
        all_dissipated.add(dissipated);
    });
    sums.stored += all_stored.value();
    sums.dissipated += all_dissipated.value();
}

}  // namespace tricontact::mdr
