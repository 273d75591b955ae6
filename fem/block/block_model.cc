#include "fem/block/block_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/state_bytes.h"

// With C the block's compliance and L the lattice's, a step solves contact with u = L t + d for a
// given d, then d <- (C - L) t: a fixed point whose contraction is that of L^-1 (C - L), a few
// per cent. The next step begins with the last one's d.

namespace tricontact::fem {

namespace {

constexpr int most_corrections = 60;

}  // namespace

BlockModel::BlockModel(std::string name, BlockElasticity elasticity,
                       std::shared_ptr<const contact::Indenter> indenter,
                       std::shared_ptr<const contact::FrictionLaw> friction, double tolerance,
                       const contact::Case::Contact& options)
    : elasticity_(std::move(elasticity)),
      indenter_(std::move(indenter)),
      friction_(std::move(friction)),
      tolerance_(tolerance),
      correction_(std::make_shared<CorrectedSubstrate::Correction>()),
      linear_(std::move(name), CorrectedSubstrate(elasticity_, correction_), indenter_, friction_,
              tolerance, options) {}

std::unique_ptr<contact::Model> BlockModel::sibling(const contact::Case::Contact& options) const {
    if (!options.coupling) return nullptr;
    return std::make_unique<BlockModel>(name(), elasticity_, indenter_, friction_, tolerance_,
                                        options);
}

void BlockModel::release() {
    linear_.release();
    audit_ = {};
    worst_reaction_ = worst_mismatch_ = 0;
}

/// Largest change of a displacement over what it is compared with [-].
double BlockModel::update_correction(double indentation) {
    const contact::SurfaceField exact = elasticity_.block->displacement(correction_->traction);
    double change = 0;
    for (int d = 0; d < 3; ++d) {
        const auto &u = *components(exact)[d], &now = *components(correction_->displacement)[d];
        auto& to = *components(correction_->offset)[d];
        for (std::size_t i = 0; i < u.size(); ++i) {
            change = std::max(change, std::abs(u[i] - now[i]) / indentation);
            to[i] -= u[i] - now[i];
        }
    }
    return change;
}

contact::StepRecord BlockModel::advance(const contact::LoadStep& step) {
    const std::string before = linear_.write_state();
    const double stored = correction_->stored;
    double change = 0;
    for (int k = 0; k < most_corrections; ++k) {
        contact::StepRecord record = linear_.advance(step);
        const double last = change;
        change = update_correction(record.indentation);
        if (change <= tolerance_) {
            audit_step();
            return record;
        }
        if (k > 5 && change > 2 * last) break;
        linear_.read_state(before);
        correction_->stored = stored;
    }
    throw contact::NotConverged(
        fmt::format("{}: the block's displacements change by {:.1e} of the indentation after {} "
                    "corrections of the step at phase {:.4g}",
                    name(), change, most_corrections, step.phase));
}

/// What the lattice cannot audit: the ground's force by the block's solution, and that solution's
/// reciprocity by the energies of the step.
void BlockModel::audit_step() {
    worst_reaction_ = std::max(worst_reaction_, elasticity_.block->missing_reaction());
    worst_mismatch_ = std::max(worst_mismatch_, correction_->mismatch);
    audit_ = linear_.audit();
    audit_.record("base_reaction", worst_reaction_, tolerance_);
    audit_.record("work_is_stored", worst_mismatch_, tolerance_);
}

/// Written or read: all but the contact's own state.
template <class Archive, class Self>
void BlockModel::transfer_correction(Archive& archive, Self& m) {
    auto& correction = *m.correction_;
    for (auto* field : {&correction.offset, &correction.traction, &correction.displacement})
        for (auto* component : components(*field)) archive(*component);
    archive(correction.stored, correction.mismatch, m.worst_reaction_, m.worst_mismatch_,
            m.elasticity_.block->last_solution());
}

std::string BlockModel::write_state() const {
    contact::StateWriter out;
    out(linear_.write_state());
    transfer_correction(out, *this);
    audit_.write(out);
    return out.take();
}

void BlockModel::read_state(std::string_view bytes) {
    contact::StateReader in(bytes);
    std::string linear;
    in(linear);
    linear_.read_state(linear);
    transfer_correction(in, *this);
    audit_.read(in);
}

}  // namespace tricontact::fem
