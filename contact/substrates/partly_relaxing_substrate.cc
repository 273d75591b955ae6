#include "contact/substrates/partly_relaxing_substrate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "contact/compensated_sum.h"
#include "contact/solvers/wide_vectors.h"

namespace tricontact::contact {

namespace {

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
    offset_ = SurfaceField(n_);
    for (Mode& mode : modes_) {
        mode.displacement = SurfaceField(n_);
        mode.branches.assign(mode.creep.branches.size(), {SurfaceField(n_), SurfaceField(n_)});
    }
}

bool PartlyRelaxingSubstrate::begin(double duration, const SurfaceField& t, const SurfaceField& u) {
    duration_ = duration;
    traction_ = &t;
    displacement_ = &u;
    for (auto* component : components(offset_)) std::ranges::fill(*component, 0.);
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
void PartlyRelaxingSubstrate::update_modal(const SurfaceField& t, double& magnitude) {
    const std::size_t n_modes = modes_.size();
    auto& modal = modal_displacements_;
    if (sum_) {
        modal.resize(n_modes, SurfaceField(n_));
        for (std::size_t m = modal_.size(); m < n_modes; ++m) {
            const double* const row = interpolation_.weights.data() + m * n_modes;
            modal_.push_back(sum_.of({row, row + n_modes}));
        }
        // The nodes' bodies are stiffer than the relaxed one, sum relaxed_m X_m.
        double all_weights = 0, energy = 0;
        sum_.displacements(modal_, t, modal);
        for (std::size_t m = 0; m < n_modes; ++m) {
            if (step_.is_coupled()) add_coupling(*modal_[m], t, modal[m]);
            const double relaxed = modes_[m].creep.relaxed;
            energy += relaxed * largest_energy(modal[m], t);
            for (std::size_t j = 0; j < n_modes; ++j)
                all_weights += relaxed * std::abs(interpolation_.weight(m, j));
        }
        magnitude += all_weights * energy;
        return;
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
}

/// What these displacements and the tractions of the step could at most exchange [J].
double PartlyRelaxingSubstrate::largest_energy(const SurfaceField& u, const SurfaceField& t) const {
    const auto& area = step_.points().area;
    double sum = 0;
    for (int d = 0; d < 3; ++d) {
        const double *const t0 = components(*traction_)[d]->data(),
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
        const auto &t0 = *components(*traction_)[d], &u0 = *components(*displacement_)[d];
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
    update_modal(t, energies.magnitude);
    for (int d = 0; d < 3; ++d) {
        const Loaded points = loaded(d, t);
        for (std::size_t m = 0; m < modes_.size(); ++m)
            advance(modes_[m], d, *components(modal_displacements_[m])[d], points, energies);
    }
    return energies;
}

PartlyRelaxingSubstrate::Loaded PartlyRelaxingSubstrate::loaded(int d,
                                                                const SurfaceField& t) const {
    const auto &t0 = *components(*traction_)[d], &t1 = *components(t)[d];
    Loaded loaded;
    for (std::size_t i = 0; i < n_; ++i) {
        if (t0[i] == 0 && t1[i] == 0) continue;
        const double area = step_.points().area[i];
        loaded.points.push_back(i);
        loaded.change.push_back(t1[i] - t0[i]);
        loaded.force_change.push_back(area * (t1[i] - t0[i]));
        loaded.force.push_back(area * t1[i]);
        loaded.magnitude.push_back(area * (std::abs(t0[i]) + std::abs(t1[i])));
    }
    return loaded;
}

namespace {

template <std::size_t n>
using Terms = std::array<double, n>;

/// The sum of what `add(sums, k)` adds for begin <= k < end: in four parts, which need not wait for
/// each other.
template <std::size_t n, class Add>
Terms<n> lane_sums(int begin, int end, Add add) {
    std::array<Terms<n>, 4> sums{};
    int k = begin;
    for (; k + 4 <= end; k += 4)
#pragma GCC unroll 4
        for (int lane = 0; lane < 4; ++lane) add(sums[lane], k + lane);
    for (; k < end; ++k) add(sums[0], k);
    Terms<n> total;
    for (std::size_t j = 0; j < n; ++j)
        total[j] = (sums[0][j] + sums[1][j]) + (sums[2][j] + sums[3][j]);
    return total;
}

/// The same over all k < count, see for_each_block().
template <std::size_t n, class Add>
Terms<n> block_sums(std::size_t count, Add add) {
    std::array<CompensatedSum, n> all;
    for_each_block(0, static_cast<int>(count), [&](int begin, int end) {
        const Terms<n> sums = lane_sums<n>(begin, end, add);
        for (std::size_t j = 0; j < n; ++j) all[j].add(sums[j]);
    });
    Terms<n> values;
    for (std::size_t j = 0; j < n; ++j) values[j] = all[j].value();
    return values;
}

/// e <- decay e, x_e <- decay x_e + mean x_w of n points; the sum of area e x_e before.
TRICONTACT_WIDEST_VECTORS
double creep_block(const double* area, const double* x_w, double decay, double mean, int n,
                   double* e, double* x_e) {
    using Numbers = Vector<double>;
    constexpr int width = static_cast<int>(lanes<double>);
    Numbers sums{};
    int i = 0;
    for (; i + width <= n; i += width) {
        const auto old = Numbers::load(e + i).lanes, x_old = Numbers::load(x_e + i).lanes;
        sums.lanes += Numbers::load(area + i).lanes * old * x_old;
        Numbers{old * decay}.store(e + i);
        Numbers{x_old * decay + Numbers::load(x_w + i).lanes * mean}.store(x_e + i);
    }
    double sum = 0;
    for (int lane = 0; lane < width; ++lane) sum += sums.lanes[lane];
    for (; i < n; ++i) {
        sum += area[i] * e[i] * x_e[i];
        e[i] *= decay;
        x_e[i] = decay * x_e[i] + mean * x_w[i];
    }
    return sum;
}

}  // namespace

/// A component d of a mode, whose displacement becomes `now`, which gets what it was.
void PartlyRelaxingSubstrate::advance(Mode& mode, int d, std::vector<double>& now,
                                      const Loaded& loaded, Energies& energies) {
    auto& displacement = *components(mode.displacement)[d];
    const auto [work, magnitude] = block_sums<2>(loaded.points.size(), [&](Terms<2>& sums, int k) {
        const std::size_t i = loaded.points[k];
        sums[0] += loaded.force_change[k] * mode.creep.relaxed * (displacement[i] + now[i]) / 2;
        sums[1] += loaded.magnitude[k] * (std::abs(displacement[i]) + std::abs(now[i]));
    });
    energies.work -= work;
    energies.magnitude += magnitude;
    change_.resize(n_);
    for (std::size_t i = 0; i < n_; ++i) change_[i] = now[i] - displacement[i];
    std::swap(displacement, now);
    for (std::size_t b = 0; b < mode.branches.size(); ++b) {
        const Energies own = advance(mode.branches[b], mode.creep.branches[b], d, loaded);
        energies.stored += own.stored;
        energies.dissipated += own.dissipated;
        energies.work += own.work;
        energies.magnitude += own.magnitude;
    }
}

/// The energies of a branch's component d, under the change of the displacement X t. With w = t1 -
/// t0, which is zero but where points are loaded, and X self-adjoint, the new e X e is made of e X
/// e, w X e and w X w: only the first is a sum over all points.
Substrate::Energies PartlyRelaxingSubstrate::advance(Branch& branch,
                                                     const Retardation::Branch& creep, int d,
                                                     const Loaded& loaded) const {
    const StepIntegrals s(duration_ / creep.time);
    const double decay = std::exp(-duration_ / creep.time), mean = s.mean;
    const double *const areas = step_.points().area.data(), *const x_w = change_.data();
    double* const e = components(branch.traction)[d]->data();
    double* const x_e = components(branch.displacement)[d]->data();
    const std::size_t* const points = loaded.points.data();
    const auto [w_x_e, w_x_w, force_x_e, magnitude] =
        block_sums<4>(loaded.points.size(), [&](Terms<4>& sums, int k) {
            const double before = x_e[points[k]], change = x_w[points[k]];
            const double after = decay * before + mean * change;
            sums[0] += loaded.force_change[k] * before;
            sums[1] += loaded.force_change[k] * change;
            sums[2] += loaded.force[k] * after;
            sums[3] += loaded.magnitude[k] * std::abs(after);
        });
    CompensatedSum all;
    for_each_block(0, static_cast<int>(n_), [&](int begin, int end) {
        all.add(creep_block(areas + begin, x_w + begin, decay, mean, end - begin, e + begin,
                            x_e + begin));
    });
    for (std::size_t k = 0; k < loaded.points.size(); ++k) e[points[k]] += mean * loaded.change[k];
    const double old = all.value();
    const double now = decay * decay * old + 2 * decay * mean * w_x_e + mean * mean * w_x_w;
    Energies energies;
    energies.dissipated = creep.compliance * (old * s.ee + 2 * w_x_e * s.ew + w_x_w * s.ww);
    energies.work = creep.compliance * (w_x_e * mean + w_x_w * s.drift);
    energies.stored = creep.compliance / 2 * (now - force_x_e);
    energies.magnitude = creep.compliance * magnitude;
    return energies;
}

}  // namespace tricontact::contact
