#include "contact/model_on_rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "contact/base/error.h"
#include "contact/base/state_bytes.h"

namespace tricontact::contact {

namespace {

constexpr int most_trials = 100;
/// Of the accuracy of the model's steps: forces are no better known.
constexpr double least_accuracy = 1e-12;

double& control_value(LoadStep& step, std::size_t component) {
    return component == 0 ? step.normal.value : step.tangential[component - 1].value;
}

bool is_displacement(const LoadStep& step, std::size_t component) {
    return component == 0 ? step.normal.kind == NormalControl::Kind::indentation
                          : step.tangential[component - 1].kind == TangentialControl::Kind::shift;
}

}  // namespace

Vector2 RigStiffness::drive_shift(const StepRecord& step) const {
    return step.shift + tangential_compliance() * step.tangential_force;
}

double RigStiffness::drive_depth(const StepRecord& step) const {
    return step.indentation + normal_compliance() * step.normal_force;
}

/// For the displacements that are left for the contact in one step.
struct ModelOnRig::Search {
    ModelOnRig& rig;
    LoadStep step;
    std::vector<std::size_t> unknowns;
    Vector drive{}, tried{}, misfit{};
    StepRecord record;
    double allowed = 0;  // of the misfit [m]
    // Of one unknown: F does not fall, so that it lies no farther away than the misfit.
    double low = -infinity_, high = infinity_;

    static constexpr double infinity_ = std::numeric_limits<double>::infinity();

    void evaluate() {
        for (const std::size_t i : unknowns) control_value(step, i) = tried[i];
        record = rig.model_->advance(step);
        const Vector force{record.normal_force, record.tangential_force[0],
                           record.tangential_force[1]};
        double scale = 0;
        for (const std::size_t i : unknowns) {
            misfit[i] = tried[i] + rig.compliance_[i] * force[i] - drive[i];
            // Solvers know tangential forces to a share of friction's, also where they are 0.
            scale = std::max(scale, rig.compliance_[i] * record.normal_force);
            scale = std::max(scale, std::abs(tried[i]) + std::abs(rig.compliance_[i] * force[i]));
        }
        allowed = std::max(least_accuracy, rig.model_->step_accuracy()) * scale;
        if (unknowns.size() > 1) return;
        const std::size_t i = unknowns.front();
        low = std::max(low, misfit[i] > 0 ? tried[i] - misfit[i] : tried[i]);
        high = std::min(high, misfit[i] > 0 ? tried[i] : tried[i] - misfit[i]);
    }

    double worst(const Vector& of) const {
        double largest = 0;
        for (const std::size_t i : unknowns) largest = std::max(largest, std::abs(of[i]));
        return largest;
    }

    Vector followed(const Vector& change) const {
        Vector result{};
        for (const std::size_t i : unknowns)
            for (const std::size_t j : unknowns) result[i] += rig.share_[i][j] * change[j];
        return result;
    }

    /// Broyden (1965), the "good" update of the inverse: share (change of misfit) = change of z.
    void learn(const Vector& step_taken, const Vector& change) {
        const Vector expected = followed(change);
        double product = 0;
        for (const std::size_t i : unknowns) product += step_taken[i] * expected[i];
        if (product == 0) return;
        Vector row{};
        for (const std::size_t i : unknowns)
            for (const std::size_t j : unknowns) row[j] += step_taken[i] * rig.share_[i][j];
        for (const std::size_t i : unknowns)
            for (const std::size_t j : unknowns)
                rig.share_[i][j] += (step_taken[i] - expected[i]) * row[j] / product;
    }

    /// The next trial, from the best one so far.
    void propose(const Vector& from, const Vector& remaining, bool bisect) {
        const Vector change = followed(remaining);
        for (const std::size_t i : unknowns) tried[i] = from[i] - change[i];
        if (unknowns.size() == 1) {
            double& z = tried[unknowns.front()];
            if (bisect || !(z >= low && z <= high)) z = (low + high) / 2;
        }
        // A contact that is pressed has a depth.
        if (unknowns.front() == 0 && !(tried[0] > 0))
            tried[0] = (from[0] > 0 ? from[0] : drive[0]) / 4;
    }
};

ModelOnRig::ModelOnRig(std::unique_ptr<Model> model, const RigStiffness& rig)
    : model_(std::move(model)),
      rig_(rig),
      compliance_{rig.normal_compliance(), rig.tangential_compliance(),
                  rig.tangential_compliance()} {
    forget();
}

void ModelOnRig::forget() {
    contact_ = drive_ = {};
    share_ = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

StepRecord ModelOnRig::advance(const LoadStep& step) {
    Search search{.rig = *this, .step = step, .unknowns = {}, .record = {}};
    for (std::size_t i = 0; i < compliance_.size(); ++i)
        if (compliance_[i] > 0 && is_displacement(step, i)) {
            search.unknowns.push_back(i);
            search.drive[i] = control_value(search.step, i);
        }
    if (search.unknowns.empty()) return model_->advance(step);
    const std::string before = model_->write_state();
    Vector ahead{};
    for (const std::size_t i : search.unknowns) ahead[i] = drive_[i] - search.drive[i];
    search.propose(contact_, ahead, false);
    search.evaluate();
    Vector best = search.tried, remaining = search.misfit;
    bool bisect = false;
    for (int n = 1; search.worst(search.misfit) > search.allowed; ++n) {
        if (n == most_trials)
            throw NotConverged(fmt::format(
                "{}: at phase {:.4g} no displacement of the contact goes with that of the drive: "
                "{:.3g} m are left after {} trials, allowed {:.1g} m; a contact whose friction "
                "falls faster than the rig is stiff jumps",
                name(), step.phase, search.worst(search.misfit), n, search.allowed));
        model_->read_state(before);
        search.propose(best, remaining, bisect);
        search.evaluate();
        Vector taken{}, change{};
        for (const std::size_t i : search.unknowns) {
            taken[i] = search.tried[i] - best[i];
            change[i] = search.misfit[i] - remaining[i];
        }
        search.learn(taken, change);
        bisect = search.worst(search.misfit) > search.worst(remaining) / 2 && !bisect;
        if (search.worst(search.misfit) >= search.worst(remaining)) continue;
        best = search.tried;
        remaining = search.misfit;
    }
    contact_ = search.tried;
    drive_ = search.drive;
    return search.record;
}

void ModelOnRig::release() {
    model_->release();
    forget();
}

void ModelOnRig::enlarge(const ContactAtEdge& reached) {
    model_->enlarge(reached);
    forget();
}

std::string ModelOnRig::write_state() const {
    StateWriter out;
    out(contact_, drive_, share_, model_->write_state());
    return out.take();
}

void ModelOnRig::read_state(std::string_view bytes) {
    StateReader in(bytes);
    std::string rest;
    in(contact_, drive_, share_, rest);
    model_->read_state(rest);
}

std::unique_ptr<Model> ModelOnRig::sibling(const Case::Contact& options) const {
    auto other = model_->sibling(options);
    return other ? std::make_unique<ModelOnRig>(std::move(other), rig_) : nullptr;
}

std::unique_ptr<WearingContact> ModelOnRig::wearing(const WearProblem& problem) {
    auto* const wearable = dynamic_cast<Wearable*>(model_.get());
    if (!wearable || rig_.normal)
        throw InputError("[wear]: " + name() +
                         (wearable ? " behind a rig that yields along the "
                                     "normal has no jumps over cycles; omit "
                                     "rig.normal_stiffness"
                                   : " has no worn profile; take bem"));
    WearProblem behind = problem;
    behind.driven_by = this;
    behind.rig_compliance = rig_.tangential_compliance();
    return wearable->wearing(behind);
}

}  // namespace tricontact::contact
