#include "fem/finite_strain/strained_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/solvers/contact_region.h"

// Results of docs/explanation/models/finite-strain.md. A step that does not converge is taken in
// halves (`take`). The audit compares energies: the work of the forces is stored in springs and
// branches, or dissipated by friction and dashpots.

namespace tricontact::fem {

using contact::Case;
using contact::ContactState;
using contact::LoadStep;
using contact::NormalControl;
using contact::NotConverged;
using contact::TangentialControl;
using contact::TangentialField;
using contact::Vector2;

namespace {

constexpr int most_halvings = 6;
constexpr double branch_energy_error = .01;  ///< of a step, over the stored energy

double halfway(double a, double b) {
    return a + (b - a) / 2;
}

}  // namespace

StrainedModel::Solver::Solver(const Setup& s)
    : body(s.layer->corrected().discretisation, s.c01_ratio, s.relaxation),
      correction({s.layer->corrected().discretisation, body, s.layer->corrected().factor, *s.layer,
                  *s.indenter, s.rolling_radius, *s.friction, s.tolerance}) {}

StrainedModel::StrainedModel(Setup setup)
    : setup_(std::move(setup)), solver_(std::make_unique<Solver>(setup_)) {
    release();
}
StrainedModel::~StrainedModel() = default;

void StrainedModel::release() {
    now_ = solver_->correction.at_rest();
    memory_ = solver_->body.unstrained();
    const std::size_t n = points().size();
    forces_ = {};
    normal_force_ = energy_ = relaxed_energy_ = material_dissipation_ = 0;
    slip_ = TangentialField(n);
    work_.assign(n, 0);
    contact_state_.assign(n, ContactState::open);
    for (auto* kept : {&least_pressure_, &slip_path_, &friction_work_}) kept->clear();
}

std::unique_ptr<contact::Model> StrainedModel::sibling(const Case::Contact& options) const {
    return options.coupling ? std::make_unique<StrainedModel>(setup_) : nullptr;
}

void StrainedModel::enlarge(const contact::ContactAtEdge& reached) {
    if (!setup_.larger_layer) throw reached;
    solver_.reset();
    setup_.layer = setup_.larger_layer();
    solver_ = std::make_unique<Solver>(setup_);
    audit_ = {};
    release();
}

void StrainedModel::start_period() {
    slip_path_.assign(points().size(), 0);
    friction_work_ = slip_path_;
}

void StrainedModel::start_limit() {
    least_pressure_ = now_.pressure;
    limit_start_ = total_friction(solver_->correction.bounds(now_, frames()));
}

contact::StepRecord StrainedModel::advance(const LoadStep& step) {
    slip_ = TangentialField(points().size());
    work_.assign(points().size(), 0);
    iterations_ = 0;
    force_residual_ = displacement_residual_ = material_dissipation_ = 0;
    take(step, 0);
    for (std::size_t i = 0; i < slip_path_.size(); ++i) {
        slip_path_[i] += contact::norm(slip_.at(i));
        friction_work_[i] += work_[i];
    }
    for (std::size_t i = 0; i < least_pressure_.size(); ++i)
        least_pressure_[i] = std::min(least_pressure_[i], now_.pressure[i]);
    return record(step);
}

/// The step that would change nothing, controlled as `next` is.
LoadStep StrainedModel::present_step(const LoadStep& next) const {
    LoadStep now = next;
    now.offset = now_.pose.offset;
    now.normal.value =
        next.normal.kind == NormalControl::Kind::force ? normal_force_ : now_.pose.indentation;
    const double limit =
        setup_.friction->limit(total_friction(solver_->correction.bounds(now_, frames())));
    for (int d = 0; d < 2; ++d) {
        auto& [kind, value] = now.tangential[d];
        value = kind == TangentialControl::Kind::shift   ? now_.pose.shift[d]
                : kind == TangentialControl::Kind::force ? forces_[d]
                : limit > 0                              ? forces_[d] / limit
                                                         : value;
    }
    return now;
}

// Halving, six times at most. A step may fail to converge, or slide as a whole in an iterate though
// the solution does not: both are tried in halves. Half of a step is halfway in everything that it
// prescribes, force, indentation, shift and rolling alike, from the state as it is.
void StrainedModel::take(const LoadStep& step, int halvings) {
    const ContactedBody before = now_;
    try {
        const RelaxingStep relaxing = solver_->body.begin(memory_, step.duration);
        const auto report = solver_->correction.solve(step, relaxing, before, now_);
        end_step(step, before, relaxing, report);
        return;
    } catch (const NotConverged& e) {
        if (halvings == most_halvings)
            throw NotConverged(fmt::format("{}; 1/{} of the step to phase {:.4g} was tried",
                                           e.what(), 1 << halvings, step.phase));
    } catch (const contact::InputError&) {  // the contact slides, or an iterate's did
        if (halvings == most_halvings) throw;
    }
    now_ = before;
    const LoadStep from = present_step(step);
    LoadStep first = step;
    first.offset = {halfway(from.offset[0], step.offset[0]),
                    halfway(from.offset[1], step.offset[1])};
    first.normal.value = halfway(from.normal.value, step.normal.value);
    for (int d = 0; d < 2; ++d)
        first.tangential[d].value = halfway(from.tangential[d].value, step.tangential[d].value);
    first.duration = step.duration / 2;
    take(first, halvings + 1);
    LoadStep second = step;
    second.duration = step.duration / 2;
    take(second, halvings + 1);
}

ContactFrames StrainedModel::frames() const {
    return {*setup_.indenter, now_.position, now_.pose.lowest_point()};
}

void StrainedModel::end_step(const LoadStep& step, const ContactedBody& before,
                             const RelaxingStep& relaxing,
                             const DeferredCorrection::Report& report) {
    if (contact::reaches_edge(points(), now_.pressure))
        throw contact::ContactAtEdge(fmt::format(
            "fem: the contact reaches the edge of the meshed contact patch at phase {:.4g}",
            step.phase));
    iterations_ += report.iterations;
    force_residual_ = std::max(force_residual_, report.force_residual);
    displacement_residual_ = std::max(displacement_residual_, report.displacement_residual);
    const Vector3 forces = solver_->correction.forces(now_);
    forces_ = {forces[0], forces[1]};
    normal_force_ = forces[2];
    const ContactFrames present = frames();
    update_slip(before, present);
    audit_step(step, present, report);
    audit_energy(before, relaxing, report.energy);
}

contact::FrictionLaw::Total StrainedModel::total_friction(const std::vector<double>& bound) const {
    double sum = 0;
    for (std::size_t i = 0; i < bound.size(); ++i) sum += points().area[i] * bound[i];
    return {normal_force_, sum};
}

// Slip is computed from the two states again, not taken from the iteration, whose frames are those
// of the last iterate. A point slips if it is at the bound and has moved; both thresholds are ten
// times the tolerance of the solver, over mu d and over the mean bound.
void StrainedModel::update_slip(const ContactedBody& before, const ContactFrames& frames) {
    const StepSlip slip = solver_->correction.step_slip(before, now_.pose);
    const std::vector<double> bound = solver_->correction.bounds(now_, frames);
    const contact::FrictionLaw::Total total = total_friction(bound);
    double area = 0;
    for (std::size_t i = 0; i < points().size(); ++i)
        if (now_.pressure[i] > 0) area += points().area[i];
    // Tractions at the bound are known to the solver's tolerance of all, not of a small one's own.
    const double unknown = 10 * setup_.tolerance * total.bound / area;
    for (std::size_t i = 0; i < points().size(); ++i) {
        contact_state_[i] = ContactState::open;
        now_.slip.set(i, {0, 0});
        if (!(now_.pressure[i] > 0)) continue;
        const Vector2 s = slip.at(i, frames, now_.position[i]);
        now_.slip.set(i, s);
        // As SurfaceModel: on the bound without having moved is stick.
        const bool moves = contact::norm(s) > 10 * setup_.tolerance * compared_slip(total);
        const Vector2 t = now_.traction.at(i);
        const bool at_bound = contact::norm(t) >= bound[i] - unknown;
        contact_state_[i] = at_bound && moves ? ContactState::slip : ContactState::stick;
        const Vector2 told = contact::told_slip(contact_state_[i], s);
        slip_.set(i, slip_.at(i) + told);
        work_[i] += contact::dot(t, told);
    }
}

namespace {

/// Nodes of the Gauss quadrature of three points on [0, 1], and their weights.
constexpr std::array<std::array<double, 2>, 3> gauss{
    {{0.1127016653792583, 5. / 18}, {.5, 8. / 18}, {0.8872983346207417, 5. / 18}}};

}  // namespace

/// Work of the forces of nodes and volumes on the straight way from one state to the other [J].
double StrainedModel::work_of_springs(const StrainedState& from, const StrainedState& to) const {
    StrainedState way = from;
    StrainedBody::Response response;
    double work = 0;
    for (const auto& [at, weight] : gauss) {
        for (std::size_t i = 0; i < way.displacement.size(); ++i)
            way.displacement[i] =
                from.displacement[i] + at * (to.displacement[i] - from.displacement[i]);
        for (std::size_t c = 0; c < way.mean_stress.size(); ++c)
            for (int m = 0; m < 4; ++m)
                way.mean_stress[c][m] =
                    from.mean_stress[c][m] + at * (to.mean_stress[c][m] - from.mean_stress[c][m]);
        solver_->body.evaluate(way, response);
        double sum = 0;
        for (std::size_t i = 0; i < way.displacement.size(); ++i)
            sum += response.force[i] * (to.displacement[i] - from.displacement[i]);
        for (std::size_t c = 0; c < way.mean_stress.size(); ++c)
            for (int m = 0; m < 4; ++m)
                sum +=
                    response.excess_volume[c][m] * (to.mean_stress[c][m] - from.mean_stress[c][m]);
        work += weight * sum;
    }
    return work / modelled_part(points());
}

// Why two balances. Springs are elastic: the work that strains them is the change of their energy,
// up to the quadrature over the step, which is exact to rounding. Branches relax within the step,
// and their work is integrated with an error of the step in time: it says how short steps have to
// be, not whether the solution is right.
/// Of springs and of branches apart: the former hold to rounding, the latter but for the error of
/// the step in time.
void StrainedModel::audit_energy(const ContactedBody& before, const RelaxingStep& relaxing,
                                 double energy) {
    const double both_sides = 1 / modelled_part(points());
    const double stored = both_sides * energy;
    const StrainedState from = solver_->body.springs(before.body, memory_);
    const auto of_branches = solver_->body.finish(now_.body, relaxing, memory_);
    const StrainedState to = solver_->body.springs(now_.body, memory_);
    double relaxed = stored;
    if (!memory_.viscous.empty()) {
        StrainedBody::Response response;
        solver_->body.evaluate(to, response);
        relaxed = both_sides * response.energy;
    }
    const double magnitude = std::max(stored, energy_);
    if (magnitude > 0 && normal_force_ > 0) {  // withdrawn: nothing to compare errors with
        const double change = relaxed - relaxed_energy_;
        audit_.record("energy_balance", std::abs(work_of_springs(from, to) - change) / magnitude,
                      1e-6);
        if (!memory_.viscous.empty())
            audit_.record("branch_energy_balance",
                          std::abs(both_sides * (of_branches.work - of_branches.dissipated) -
                                   (stored - energy_ - change)) /
                              magnitude,
                          branch_energy_error);
    }
    material_dissipation_ += both_sides * of_branches.dissipated;
    energy_ = stored;
    relaxed_energy_ = relaxed;
}

double StrainedModel::limit_tangential_ratio() const {
    const auto& area = points().area;
    std::vector<double> bound(least_pressure_.size());
    setup_.friction->bounds({least_pressure_}, bound);
    contact::FrictionLaw::Total least{};
    for (std::size_t i = 0; i < bound.size(); ++i) {
        least.normal_force += area[i] * least_pressure_[i];
        least.bound += area[i] * bound[i];
    }
    return setup_.friction->share(least, limit_start_);
}

}  // namespace tricontact::fem
