#include "mdr/spring_memory.h"

#include <algorithm>
#include <cmath>

namespace tricontact::mdr {

namespace {

// (1 - mean)/x with mean = (1 - exp(-x))/x, x >= 0: 1/2 at x = 0. The series leaves less than
// rounding below 0.05, the direct form loses three digits there and fewer beyond.
double drift(double x) {
    constexpr double series_below = 0.05;
    if (std::isinf(x)) return 0;
    if (x >= series_below) return (x + std::expm1(-x)) / (x * x);
    double term = 0.5, sum = 0;
    for (int n = 3; n <= 11; ++n) {
        sum += term;
        term *= -x / n;
    }
    return sum;
}

}  // namespace

// A branch strains by e = h/ratio, de/dt = change/duration - e/time. With x = duration/time, m the
// mean of exp(-t/time) over the step and r = change/x:
//   e(t) = (e - r) exp(-t/time) + r,   mean e = e m + change (1 - m)/x,
//   1/time ∫ e^2 dt = e^2 (1 - exp(-2x))/2 + e change x m^2 + change^2 [(1 - m)/x - m^2/2].
void SpringMemory::Branch::set_step(double duration) {
    const double x = duration / time, lost = -std::expm1(-x);
    const contact::RelaxationStep step({{{ratio, time}}, {}}, duration);
    decay = step.decay.front();
    gain = step.gain.front();
    mean_h = gain / ratio;
    mean_u = ratio * drift(x);
    dissipated_hh = -std::expm1(-2 * x) / 2 / ratio;
    dissipated_hu = lost * mean_h;
    dissipated_uu = mean_u - ratio * mean_h * mean_h / 2;
}

SpringMemory::SpringMemory(const contact::Relaxation& relaxation, int n_springs) {
    const std::vector<double> at_rest(n_springs, 0.0);
    for (const auto& [ratio, time] : relaxation.branches)
        branches_.push_back({.ratio = ratio, .time = time, .h = at_rest});
    deflection_ = free_ = change_ = mean_ = law_ = at_rest;
}

void SpringMemory::forget() {
    for (auto* field : {&deflection_, &free_}) std::fill(field->begin(), field->end(), 0);
    for (Branch& branch : branches_) std::fill(branch.h.begin(), branch.h.end(), 0);
}

void SpringMemory::grow(int n) {
    auto pad = [n](std::vector<double>& values) {
        values.insert(values.begin(), n, 0);
        values.insert(values.end(), n, 0);
    };
    for (auto* field : {&deflection_, &free_, &change_, &mean_, &law_}) pad(*field);
    for (Branch& branch : branches_) pad(branch.h);
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
    double stored = 0, work = 0, mean_force = 0, law_error = 0;
#pragma omp simd reduction(+ : stored)
    for (int i = window.first; i < window.last; ++i) {
        const double before = u[i];
        u[i] = free[i] + softness * f[i];
        change[i] = u[i] - before;
        mean[i] = (u[i] + before) / 2;
        law[i] = u[i];
        stored += u[i] * u[i] / 2;
    }
    for (Branch& branch : branches_) advance(branch, window, sums);
#pragma omp simd reduction(+ : work, mean_force) reduction(max : law_error)
    for (int i = window.first; i < window.last; ++i) {
        work += mean[i] * change[i];
        mean_force += mean[i];
        law_error = std::max(law_error, std::abs(law[i] - f[i]));
    }
    sums.stored += stored;
    sums.work = work;
    sums.mean_force = mean_force;
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
    double stored = 0, dissipated = 0;
#pragma omp simd reduction(+ : stored, dissipated)
    for (int i = window.first; i < window.last; ++i) {
        const double before = h[i], driven = change[i];
        dissipated += hh * before * before + hu * before * driven + uu * driven * driven;
        mean[i] += mean_h * before + mean_u * driven;
        h[i] = decay * before + gain * driven;
        law[i] += h[i];
        stored += over * h[i] * h[i];
    }
    sums.stored += stored;
    sums.dissipated += dissipated;
}

}  // namespace tricontact::mdr
