#include "contact/substrates/partly_relaxing_substrate.h"

#include <algorithm>
#include <array>
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

/// By what couples normal and tangential.
void add_coupling(const Compliance& compliance, const SurfaceField& t, SurfaceField& u) {
    SurfaceField other(t.down.size());
    compliance.tangential_from_normal(t.down, other.in_surface);
    compliance.normal_from_tangential(t.in_surface, other.down);
    add(u, 1, other);
}

SurfaceField displaced(const Compliance& compliance, const SurfaceField& t, bool coupled) {
    SurfaceField u(t.down.size());
    compliance.tangential(t.in_surface, u.in_surface);
    compliance.normal(t.down, u.down);
    if (coupled) add_coupling(compliance, t, u);
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
    if (sum_) compliance = CombinedCompliance({sum_.of(weights)}, coupled_);
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
        double of_step = mode.creep.relaxed, recovered = 0;
        for (std::size_t b = 0; b < mode.branches.size(); ++b) {
            const auto [compliance, time] = mode.creep.branches[b];
            const double mean = StepIntegrals(duration / time).mean;
            of_step -= compliance * mean;
            recovered += compliance * mean;
            add(offset_, compliance * std::exp(-duration / time), mode.branches[b].displacement);
        }
        add(offset_, -recovered, mode.displacement);
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
                                                                       double& magnitude) {
    const std::size_t n_modes = modes_.size();
    std::vector<SurfaceField> modal;
    if (sum_) {
        for (std::size_t m = modal_.size(); m < n_modes; ++m) {
            const double* const row = interpolation_.weights.data() + m * n_modes;
            modal_.push_back(sum_.of({row, row + n_modes}));
        }
        // The nodes' bodies are stiffer than the relaxed one, sum relaxed_m X_m.
        double all_weights = 0, energy = 0;
        modal = sum_.displacements(modal_, t);
        for (std::size_t m = 0; m < n_modes; ++m) {
            if (step_.is_coupled()) add_coupling(*modal_[m], t, modal[m]);
            const double relaxed = modes_[m].creep.relaxed;
            energy += relaxed * largest_energy(modal[m], t);
            for (std::size_t j = 0; j < n_modes; ++j)
                all_weights += relaxed * std::abs(interpolation_.weight(m, j));
        }
        magnitude += all_weights * energy;
        return modal;
    }
    modal.assign(n_modes, SurfaceField(n_));
    for (std::size_t j = 0; j < parts_.size(); ++j) {
        const SurfaceField part = displaced(*parts_[j], t, step_.is_coupled());
        const double energy = largest_energy(part, t);
        for (std::size_t m = 0; m < n_modes; ++m) {
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
    for (int d = 0; d < 3; ++d) {
        const Loaded points = loaded(d, t);
        for (std::size_t m = 0; m < modes_.size(); ++m)
            advance(modes_[m], d, *components(now[m])[d], points, energies);
    }
    return energies;
}

PartlyRelaxingSubstrate::Loaded PartlyRelaxingSubstrate::loaded(int d,
                                                                const SurfaceField& t) const {
    const auto &t0 = *components(traction_)[d], &t1 = *components(t)[d];
    Loaded loaded;
    for (std::size_t i = 0; i < n_; ++i) {
        if (t0[i] == 0 && t1[i] == 0) continue;
        loaded.points.push_back(i);
        loaded.area.push_back(step_.points().area[i]);
        loaded.before.push_back(t0[i]);
        loaded.after.push_back(t1[i]);
        loaded.change.push_back(t1[i] - t0[i]);
    }
    return loaded;
}

namespace {

/// sum `term(k)` over k < n, see for_each_block().
template <class Term>
double block_sum(std::size_t n, Term term) {
    CompensatedSum all;
    for_each_block(0, static_cast<int>(n), [&](int begin, int end) {
        std::array<double, 4> sums{};  // which need not wait for each other
        int k = begin;
        for (; k + 4 <= end; k += 4)
            for (int lane = 0; lane < 4; ++lane) sums[lane] += term(k + lane);
        for (; k < end; ++k) sums[0] += term(k);
        all.add((sums[0] + sums[1]) + (sums[2] + sums[3]));
    });
    return all.value();
}

}  // namespace

/// A component d of a mode, whose displacement becomes `now`.
void PartlyRelaxingSubstrate::advance(Mode& mode, int d, const std::vector<double>& now,
                                      const Loaded& loaded, Energies& energies) const {
    auto& displacement = *components(mode.displacement)[d];
    const auto& points = loaded.points;
    const auto &area = loaded.area, &before = loaded.before, &after = loaded.after,
               &w = loaded.change;
    energies.work -= block_sum(points.size(), [&](int k) {
        const std::size_t i = points[k];
        return area[k] * w[k] * mode.creep.relaxed * (displacement[i] + now[i]) / 2;
    });
    energies.magnitude += block_sum(points.size(), [&](int k) {
        const std::size_t i = points[k];
        return area[k] * (std::abs(before[k]) + std::abs(after[k])) *
               (std::abs(displacement[i]) + std::abs(now[i]));
    });
    std::vector<double> change(n_);
    for (std::size_t i = 0; i < n_; ++i) change[i] = now[i] - displacement[i];
    displacement = now;
    for (std::size_t b = 0; b < mode.branches.size(); ++b) {
        const Energies own = advance(mode.branches[b], mode.creep.branches[b], d, change, loaded);
        energies.stored += own.stored;
        energies.dissipated += own.dissipated;
        energies.work += own.work;
        energies.magnitude += own.magnitude;
    }
}

/// The energies of a branch's component d, under a `change` of the displacement X t. With w = t1 -
/// t0, which is zero but where points are loaded, and X self-adjoint, the new e X e is made of e X
/// e, w X e and w X w: only the first is a sum over all points.
Substrate::Energies PartlyRelaxingSubstrate::advance(Branch& branch,
                                                     const Retardation::Branch& creep, int d,
                                                     const std::vector<double>& change,
                                                     const Loaded& loaded) const {
    const StepIntegrals s(duration_ / creep.time);
    const double decay = std::exp(-duration_ / creep.time);
    const double *const areas = step_.points().area.data(), *const x_w = change.data();
    double* const e = components(branch.traction)[d]->data();
    double* const x_e = components(branch.displacement)[d]->data();
    const auto& points = loaded.points;
    const auto &area = loaded.area, &before = loaded.before, &after = loaded.after,
               &w = loaded.change;
    const std::size_t n_loaded = points.size();
    auto over_loaded = [&](const std::vector<double>& t, const double* x) {
        return block_sum(n_loaded, [&](int k) { return area[k] * t[k] * x[points[k]]; });
    };
    const double old = block_sum(n_, [&](int i) { return areas[i] * e[i] * x_e[i]; });
    const double w_x_e = over_loaded(w, x_e), w_x_w = over_loaded(w, x_w);
    for (std::size_t i = 0; i < n_; ++i) {
        e[i] *= decay;
        x_e[i] = decay * x_e[i] + s.mean * x_w[i];
    }
    for (std::size_t k = 0; k < n_loaded; ++k) e[points[k]] += s.mean * w[k];
    const double now = decay * decay * old + 2 * decay * s.mean * w_x_e + s.mean * s.mean * w_x_w;
    Energies energies;
    energies.dissipated = creep.compliance * (old * s.ee + 2 * w_x_e * s.ew + w_x_w * s.ww);
    energies.work = creep.compliance * (w_x_e * s.mean + w_x_w * s.drift);
    energies.stored = creep.compliance / 2 * (now - over_loaded(after, x_e));
    energies.magnitude =
        creep.compliance * block_sum(n_loaded, [&](int k) {
            return area[k] * (std::abs(before[k]) + std::abs(after[k])) * std::abs(x_e[points[k]]);
        });
    return energies;
}

}  // namespace tricontact::contact
