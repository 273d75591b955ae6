#include "contact/substrates/partly_relaxing_substrate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "contact/base/compensated_sum.h"
#include "contact/compliances/wide_vectors.h"
#include "contact/substrates/block_sums.h"

namespace tricontact::contact {

namespace {

/// Of a sum of fields.
struct Share {
    double factor;
    const SurfaceField* field;
};

TRICONTACT_WIDEST_VECTORS
void add(double* sum, double factor, const double* field, int n) {
    for (int i = 0; i < n; ++i) sum[i] += factor * field[i];
}

void add(SurfaceField& sum, double factor, const SurfaceField& field) {
    for (int d = 0; d < 3; ++d)
        add(components(sum)[d]->data(), factor, components(field)[d]->data(),
            static_cast<int>(field.down.size()));
}

/// Block by block, each of which stays in the cache.
void set_to_sum(const std::vector<Share>& shares, SurfaceField& sum) {
    for (int d = 0; d < 3; ++d) {
        double* const to = components(sum)[d]->data();
        for_each_block(0, static_cast<int>(sum.down.size()), [&](int begin, int end) {
            std::fill(to + begin, to + end, 0.);
            for (const auto& [factor, field] : shares)
                add(to + begin, factor, components(*field)[d]->data() + begin, end - begin);
        });
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
    for (Retardation& creep : interpolation_.creep(relaxation_))
        modes_.push_back({std::move(creep), {}, {}});
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
    std::vector<double> weights(parts_.size());
    std::vector<Share> shares;
    for (std::size_t m = 0; m < modes_.size(); ++m) {
        const Mode& mode = modes_[m];
        double of_step = mode.creep.relaxed, recovered = 0;
        for (std::size_t b = 0; b < mode.branches.size(); ++b) {
            const auto [compliance, time] = mode.creep.branches[b];
            const double mean = StepIntegrals(duration / time).mean;
            of_step -= compliance * mean;
            recovered += compliance * mean;
            shares.push_back(
                {compliance * std::exp(-duration / time), &mode.branches[b].displacement});
        }
        shares.push_back({-recovered, &mode.displacement});
        for (std::size_t j = 0; j < parts_.size(); ++j)
            weights[j] += interpolation_.weight(m, j) * of_step;
    }
    set_to_sum(shares, offset_);
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
void PartlyRelaxingSubstrate::update_modal(const SurfaceField& t, const LoadedField& loaded,
                                           double& magnitude) {
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
            energy += relaxed * largest_energy(modal[m], loaded);
            for (std::size_t j = 0; j < n_modes; ++j)
                all_weights += relaxed * std::abs(interpolation_.weight(m, j));
        }
        magnitude += all_weights * energy;
        return;
    }
    modal.assign(n_modes, SurfaceField(n_));
    for (std::size_t j = 0; j < parts_.size(); ++j) {
        const SurfaceField part = displaced(*parts_[j], t, step_.is_coupled());
        const double energy = largest_energy(part, loaded);
        for (std::size_t m = 0; m < n_modes; ++m) {
            const double weight = interpolation_.weight(m, j);
            add(modal[m], weight, part);
            magnitude += std::abs(weight) * modes_[m].creep.relaxed * energy;
        }
    }
}

/// What these displacements and the tractions of the step could at most exchange [J].
double PartlyRelaxingSubstrate::largest_energy(const SurfaceField& u, const LoadedField& loaded) {
    double sum = 0;
    for (int d = 0; d < 3; ++d) {
        const Loaded& at = loaded[d];
        const double* const by_u = components(u)[d]->data() + at.first;
        sum += block_sums<1>(at.size(), [&](Sums<1>& sums, int k) {
            sums[0] += at.magnitude[k] * std::abs(by_u[k]);
        })[0];
    }
    return sum;
}

/// Of the energies' sums only what the branches add to those of t and u.
Substrate::Energies PartlyRelaxingSubstrate::end(const SurfaceField& t, const SurfaceField& u) {
    Energies energies;
    LoadedField loaded;
    // Partial integration of the work: the displacement's mean over the step is known.
    for (int d = 0; d < 3; ++d) {
        const Loaded& at = loaded[d] = loaded_points(d, t);
        const double *const u0 = components(*displacement_)[d]->data() + at.first,
                            *const u1 = components(u)[d]->data() + at.first;
        const auto [stored, work, magnitude] =
            block_sums<3>(at.size(), [&](Sums<3>& sums, int k) {
                const double before = u0[k], after = u1[k];
                sums[0] += at.force[k] / 2 * after;
                sums[1] += at.force[k] * after - (at.force[k] - at.force_change[k]) * before;
                sums[2] += at.magnitude[k] * (std::abs(before) + std::abs(after));
            }).values;
        energies.stored += stored;
        energies.work += work;
        energies.magnitude += magnitude;
    }
    update_modal(t, loaded, energies.magnitude);
    for (int d = 0; d < 3; ++d)
        for (std::size_t m = 0; m < modes_.size(); ++m)
            advance(modes_[m], d, *components(modal_displacements_[m])[d], loaded[d], energies);
    return energies;
}

PartlyRelaxingSubstrate::Loaded PartlyRelaxingSubstrate::loaded_points(
    int d, const SurfaceField& t) const {
    const auto &t0 = *components(*traction_)[d], &t1 = *components(t)[d];
    const double* const area = step_.points().area.data();
    const auto carries = [&](std::size_t i) { return t0[i] != 0 || t1[i] != 0; };
    Loaded loaded;
    std::size_t last = n_;
    while (last > 0 && !carries(last - 1)) --last;
    while (loaded.first < last && !carries(loaded.first)) ++loaded.first;
    for (auto* field : {&loaded.change, &loaded.force_change, &loaded.force, &loaded.magnitude})
        field->resize(last - loaded.first);
    for (std::size_t k = 0, i = loaded.first; i < last; ++k, ++i) {
        loaded.change[k] = t1[i] - t0[i];
        loaded.force_change[k] = area[i] * (t1[i] - t0[i]);
        loaded.force[k] = area[i] * t1[i];
        loaded.magnitude[k] = area[i] * (std::abs(t0[i]) + std::abs(t1[i]));
    }
    return loaded;
}

namespace {

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

/// A branch's w X e, w X w, t1 X e after the step, and what the latter could at most be, over n
/// points.
TRICONTACT_WIDEST_VECTORS
Sums<4> loaded_block(const double* force_change, const double* force, const double* magnitude,
                     const double* x_w, double decay, double mean, int n, const double* x_e) {
    using Numbers = Vector<double>;
    constexpr int width = static_cast<int>(lanes<double>);
    std::array<Numbers, 4> sums{};
    int i = 0;
    for (; i + width <= n; i += width) {
        const auto before = Numbers::load(x_e + i).lanes, change = Numbers::load(x_w + i).lanes;
        const auto after = before * decay + change * mean;
        const auto w = Numbers::load(force_change + i).lanes;
        sums[0].lanes += w * before;
        sums[1].lanes += w * change;
        sums[2].lanes += Numbers::load(force + i).lanes * after;
        sums[3].lanes += Numbers::load(magnitude + i).lanes * (after < 0 ? -after : after);
    }
    Sums<4> total{};
    for (std::size_t j = 0; j < 4; ++j)
        for (int lane = 0; lane < width; ++lane) total[j] += sums[j].lanes[lane];
    for (; i < n; ++i) {
        const double after = x_e[i] * decay + x_w[i] * mean;
        total[0] += force_change[i] * x_e[i];
        total[1] += force_change[i] * x_w[i];
        total[2] += force[i] * after;
        total[3] += magnitude[i] * std::abs(after);
    }
    return total;
}

}  // namespace

/// A component d of a mode, whose displacement becomes `now`, which gets what it was.
void PartlyRelaxingSubstrate::advance(Mode& mode, int d, std::vector<double>& now,
                                      const Loaded& loaded, Energies& energies) {
    auto& displacement = *components(mode.displacement)[d];
    const auto [work, magnitude] =
        block_sums<2>(loaded.size(), [&](Sums<2>& sums, int k) {
            const std::size_t i = loaded.first + k;
            sums[0] += loaded.force_change[k] * mode.creep.relaxed * (displacement[i] + now[i]) / 2;
            sums[1] += loaded.magnitude[k] * (std::abs(displacement[i]) + std::abs(now[i]));
        }).values;
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
    std::array<CompensatedSum, 4> of_loaded;
    for_each_block(0, static_cast<int>(loaded.size()), [&](int begin, int end) {
        const std::size_t first = loaded.first + begin;
        const Sums<4> sums = loaded_block(
            loaded.force_change.data() + begin, loaded.force.data() + begin,
            loaded.magnitude.data() + begin, x_w + first, decay, mean, end - begin, x_e + first);
        for (std::size_t j = 0; j < 4; ++j) of_loaded[j].add(sums[j]);
    });
    const double w_x_e = of_loaded[0].value(), w_x_w = of_loaded[1].value();
    CompensatedSum all;
    for_each_block(0, static_cast<int>(n_), [&](int begin, int end) {
        all.add(creep_block(areas + begin, x_w + begin, decay, mean, end - begin, e + begin,
                            x_e + begin));
    });
    add(e + loaded.first, mean, loaded.change.data(), static_cast<int>(loaded.size()));
    const double old = all.value();
    const double now = decay * decay * old + 2 * decay * mean * w_x_e + mean * mean * w_x_w;
    Energies energies;
    energies.dissipated = creep.compliance * (old * s.ee + 2 * w_x_e * s.ew + w_x_w * s.ww);
    energies.work = creep.compliance * (w_x_e * mean + w_x_w * s.drift);
    energies.stored = creep.compliance / 2 * (now - of_loaded[2].value());
    energies.magnitude = creep.compliance * of_loaded[3].value();
    return energies;
}

}  // namespace tricontact::contact
