#include "contact/substrates/partly_relaxing_substrate.h"

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "contact/compensated_sum.h"

namespace tricontact::contact {

namespace {

/// The Moebius map that takes [1, range] to [k, 1] and (-infinity, 0] to [-1, -k].
struct Symmetric {
    explicit Symmetric(double range)
        : k(1 / std::pow(std::sqrt(range) + std::sqrt(range - 1), 2)), range_(range) {}
    double back(double z) const { return 2 * range_ * (k + z) / ((1 + k) * (1 + z)); }
    double k;

  private:
    double range_;
};

/// The n points in [k, 1] whose product of (z - z_j)/(z + z_j) is least.
std::vector<double> zolotarev_points(int n, double k) {
    const double other = std::sqrt((1 - k) * (1 + k));
    const double quarter = boost::math::ellint_1(other);
    std::vector<double> points;
    for (int j = n; j >= 1; --j)
        points.push_back(boost::math::jacobi_dn(other, (2 * j - 1) * quarter / (2 * n)));
    return points;
}

/// The largest such product, which is that at 1, once for the nodes and once for the poles.
double error_of(const std::vector<double>& points) {
    double product = 1;
    for (const double z : points) product *= (1 - z) / (1 + z);
    return product * product;
}

// For real moduli; in time it becomes up to ten times as large, the contact solvers' tolerance.
constexpr double interpolation_error = 1e-8;

void add(SurfaceField& sum, double factor, const SurfaceField& field) {
    for (int d = 0; d < 3; ++d) {
        double* const to = components(sum)[d]->data();
        const double* const from = components(field)[d]->data();
        for (std::size_t i = 0; i < field.down.size(); ++i) to[i] += factor * from[i];
    }
}

SurfaceField displaced(const Compliance& compliance, const SurfaceField& t, bool coupled) {
    const std::size_t n = t.down.size();
    SurfaceField u(n), other(n);
    compliance.tangential(t.in_surface, u.in_surface);
    compliance.normal(t.down, u.down);
    if (!coupled) return u;
    compliance.tangential_from_normal(t.down, other.in_surface);
    compliance.normal_from_tangential(t.in_surface, other.down);
    add(u, 1, other);
    return u;
}

}  // namespace

StieltjesInterpolation::StieltjesInterpolation(double least_range, double most_error)
    : range(least_range), error(most_error) {
    if (!(range > 1) || !std::isfinite(range) || !(error > 0))
        throw std::logic_error("Stieltjes interpolation: range and error");
    int n = 1;
    while (error_of(zolotarev_points(n, Symmetric(range).k)) > error) ++n;
    // As wide as so many points allow: close nodes would have large weights of either sign.
    for (double wider = range; error_of(zolotarev_points(n, Symmetric(wider).k)) <= error;
         wider = 1 + 1.1 * (wider - 1))
        range = wider;
    const Symmetric map(range);
    const std::vector<double> points = zolotarev_points(n, map.k);
    error = error_of(points);
    for (const double z : points) {
        nodes.push_back(map.back(z));
        poles.push_back(-map.back(-z));
    }
    // Inverse of Cauchy's matrix 1/(x_j + a_m), row m.
    weights.resize(size() * size());
    for (std::size_t m = 0; m < size(); ++m)
        for (std::size_t j = 0; j < size(); ++j) {
            double w = nodes[j] + poles[m];
            for (std::size_t k = 0; k < size(); ++k) {
                if (k != m) w *= (nodes[j] + poles[k]) / (poles[k] - poles[m]);
                if (k != j) w *= (nodes[k] + poles[m]) / (nodes[k] - nodes[j]);
            }
            weights[m * size() + j] = w;
        }
}

StieltjesInterpolation interpolation_of(const Relaxation& relaxation) {
    // A range is needed even where rounding leaves none.
    return StieltjesInterpolation(std::max(relaxation.instantaneous_ratio(), 1 + 1e-9),
                                  interpolation_error);
}

PartlyRelaxingSubstrate::PartlyRelaxingSubstrate(Parts parts, StieltjesInterpolation interpolation,
                                                 Relaxation relaxation, bool coupled, Sum sum)
    : parts_(std::move(parts)),
      interpolation_(std::move(interpolation)),
      relaxation_(std::move(relaxation)),
      coupled_(coupled),
      sum_(std::move(sum)),
      n_(parts_.front()->points().size()),
      step_(parts_, coupled),
      relaxed_(parts_, coupled) {
    set_weights(relaxed_, interpolation_.shares(1));
    for (const double pole : interpolation_.poles)
        modes_.push_back({Retardation(relaxation_, pole), {}, {}});
    forget();
}

/// Of the parts, or of their sum alone.
void PartlyRelaxingSubstrate::set_weights(CombinedCompliance& compliance,
                                          const std::vector<double>& weights) const {
    if (sum_) compliance = CombinedCompliance({sum_(weights)}, coupled_);
    compliance.set_weights(sum_ ? std::vector<double>{1} : weights);
}

void PartlyRelaxingSubstrate::forget() {
    offset_ = traction_ = displacement_ = SurfaceField(n_);
    for (Mode& mode : modes_) {
        mode.displacement = SurfaceField(n_);
        mode.branches.assign(mode.creep.branches.size(), {SurfaceField(n_), SurfaceField(n_)});
    }
}

bool PartlyRelaxingSubstrate::begin(double duration, const SurfaceField& t, const SurfaceField& u) {
    duration_ = duration;
    traction_ = t;
    displacement_ = u;
    offset_ = SurfaceField(n_);
    std::vector<double> weights(parts_.size());
    for (std::size_t m = 0; m < modes_.size(); ++m) {
        const Mode& mode = modes_[m];
        double of_step = mode.creep.relaxed;
        for (std::size_t b = 0; b < mode.branches.size(); ++b) {
            const auto [compliance, time] = mode.creep.branches[b];
            const double mean = StepIntegrals(duration / time).mean;
            of_step -= compliance * mean;
            add(offset_, compliance * std::exp(-duration / time), mode.branches[b].displacement);
            add(offset_, -compliance * mean, mode.displacement);
        }
        for (std::size_t j = 0; j < parts_.size(); ++j)
            weights[j] += interpolation_.weight(m, j) * of_step;
    }
    if (weights == weights_) return false;
    set_weights(step_, weights);
    weights_ = std::move(weights);
    return true;
}

std::vector<SurfaceField*> PartlyRelaxingSubstrate::memory() {
    std::vector<SurfaceField*> fields;
    for (Mode& mode : modes_) {
        fields.push_back(&mode.displacement);
        for (Branch& branch : mode.branches)
            fields.insert(fields.end(), {&branch.traction, &branch.displacement});
    }
    return fields;
}

/// X_m t for each mode. They are sums of either sign, whose rounding goes with the magnitudes.
std::vector<SurfaceField> PartlyRelaxingSubstrate::modal_displacements(const SurfaceField& t,
                                                                       double& magnitude) const {
    std::vector<SurfaceField> modal(modes_.size(), SurfaceField(n_));
    for (std::size_t j = 0; j < parts_.size(); ++j) {
        const SurfaceField part = displaced(*parts_[j], t, step_.is_coupled());
        const double energy = largest_energy(part, t);
        for (std::size_t m = 0; m < modes_.size(); ++m) {
            const double weight = interpolation_.weight(m, j);
            add(modal[m], weight, part);
            magnitude += std::abs(weight) * modes_[m].creep.relaxed * energy;
        }
    }
    return modal;
}

/// What these displacements and the tractions of the step could at most exchange [J].
double PartlyRelaxingSubstrate::largest_energy(const SurfaceField& u, const SurfaceField& t) const {
    const auto& area = step_.points().area;
    double sum = 0;
    for (int d = 0; d < 3; ++d) {
        const double *const t0 = components(traction_)[d]->data(),
                            *const t1 = components(t)[d]->data(),
                            *const by_u = components(u)[d]->data();
        for (std::size_t i = 0; i < n_; ++i)
            sum += area[i] * (std::abs(t0[i]) + std::abs(t1[i])) * std::abs(by_u[i]);
    }
    return sum;
}

/// Of the energies' sums only what the branches add to those of t and u.
Substrate::Energies PartlyRelaxingSubstrate::end(const SurfaceField& t, const SurfaceField& u) {
    const auto& area = step_.points().area;
    Energies energies;
    CompensatedSum all_stored, all_work;
    // Partial integration of the work: the displacement's mean over the step is known.
    for (int d = 0; d < 3; ++d) {
        const auto &t0 = *components(traction_)[d], &u0 = *components(displacement_)[d];
        const auto &t1 = *components(t)[d], &u1 = *components(u)[d];
        for (std::size_t i = 0; i < n_; ++i) {
            all_stored.add(area[i] / 2 * t1[i] * u1[i]);
            all_work.add(area[i] * (t1[i] * u1[i] - t0[i] * u0[i]));
            energies.magnitude +=
                area[i] * (std::abs(t0[i]) + std::abs(t1[i])) * (std::abs(u0[i]) + std::abs(u1[i]));
        }
    }
    energies.stored = all_stored.value();
    energies.work = all_work.value();
    const std::vector<SurfaceField> now = modal_displacements(t, energies.magnitude);
    for (std::size_t m = 0; m < modes_.size(); ++m) advance(modes_[m], now[m], t, energies);
    return energies;
}

void PartlyRelaxingSubstrate::advance(Mode& mode, const SurfaceField& now, const SurfaceField& t,
                                      Energies& energies) {
    CompensatedSum all_stored, all_dissipated, all_work, all_magnitude;
    for (int d = 0; d < 3; ++d)
        for_each_block(0, static_cast<int>(n_), [&](int begin, int end) {
            const Energies of_block = advance(mode, d, begin, end, now, t);
            all_stored.add(of_block.stored);
            all_dissipated.add(of_block.dissipated);
            all_work.add(of_block.work);
            all_magnitude.add(of_block.magnitude);
        });
    mode.displacement = now;
    energies.stored += all_stored.value();
    energies.dissipated += all_dissipated.value();
    energies.work += all_work.value();
    energies.magnitude += all_magnitude.value();
}

/// The branches of a component d on the points [begin, end), whose energies are what is returned.
Substrate::Energies PartlyRelaxingSubstrate::advance(Mode& mode, int d, int begin, int end,
                                                     const SurfaceField& now,
                                                     const SurfaceField& t) const {
    const double *const area = step_.points().area.data(),
                        *const t0 = components(traction_)[d]->data(),
                        *const t1 = components(t)[d]->data(),
                        *const x_t0 = components(std::as_const(mode.displacement))[d]->data(),
                        *const x_t1 = components(now)[d]->data();
    Energies sum;
    for (int i = begin; i < end; ++i) {
        sum.work -= area[i] * (t1[i] - t0[i]) * mode.creep.relaxed * (x_t0[i] + x_t1[i]) / 2;
        sum.magnitude +=
            area[i] * (std::abs(t0[i]) + std::abs(t1[i])) * (std::abs(x_t0[i]) + std::abs(x_t1[i]));
    }
    for (std::size_t b = 0; b < mode.branches.size(); ++b) {
        const auto [compliance, time] = mode.creep.branches[b];
        const StepIntegrals s(duration_ / time);
        const double decay = std::exp(-duration_ / time);
        double* const e = components(mode.branches[b].traction)[d]->data();
        double* const x_e = components(mode.branches[b].displacement)[d]->data();
        for (int i = begin; i < end; ++i) {
            const double w = t1[i] - t0[i], x_w = x_t1[i] - x_t0[i], force = area[i] * compliance;
            sum.dissipated +=
                force * (e[i] * x_e[i] * s.ee + (e[i] * x_w + w * x_e[i]) * s.ew + w * x_w * s.ww);
            sum.work += force * w * (x_e[i] * s.mean + x_w * s.drift);
            e[i] = decay * e[i] + s.mean * w;
            x_e[i] = decay * x_e[i] + s.mean * x_w;
            sum.stored -= force / 2 * (t1[i] - e[i]) * x_e[i];
            sum.magnitude += force * (std::abs(t0[i]) + std::abs(t1[i])) * std::abs(x_e[i]);
        }
    }
    return sum;
}

}  // namespace tricontact::contact
