#include "contact/surface_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/base/error.h"
#include "contact/solvers/contact_region.h"

namespace tricontact::contact {

namespace {

/// What a step's work of friction is known by, point by point.
struct StepSlip {
    const ContactSolution& now;
    const StepStart& before;
    const std::vector<double>& bound_before;
    const std::vector<ContactState>& state;
    const TangentialField& slip;
};

/// Pressed without friction: what its points carry is not what they could, had they to. Told by the
/// bounds, which a resumed state has as well; the step that made it is not kept.
bool slid_freely(const ContactSolution& s) {
    const auto is_positive = [](double x) { return x > 0; };
    return s.normal && std::ranges::any_of(s.normal->pressure, is_positive) &&
           std::ranges::none_of(s.bound, is_positive);
}

/// Frictional work per area [J/m^2] of a step whose loads change in proportion: a point slips under
/// the mean of its bounds where slip begins and at the end, F_N's change being of the second order
/// then. What has passed of the step when slip begins is what the surface moves along, over all
/// that the indenter moves; none where the point was at its bound. Empty without `bound_before`:
/// the end values are all that is known.
std::vector<double> work_between(const StepSlip& step, const Blocks& points) {
    std::vector<double> work(step.bound_before.size());
    const auto &u = step.now.displacement.in_surface, &old = step.before.displacement.in_surface;
    points.for_points([&](std::size_t i) {
        const Vector2 told = told_slip(step.state[i], step.slip.at(i));
        const double length = norm(told), before = step.bound_before[i], after = step.now.bound[i];
        if (!(length > 0)) return;
        work[i] = dot(step.now.tangential.traction.at(i), told);
        if (!(after > 0)) return;
        const bool was_there =
            dot(step.before.traction.in_surface.at(i), told) >= before * length * (1 - 1e-9);
        const double way = dot(told + u.at(i) - old.at(i), told) / length;
        const double share = was_there || !(way > length) ? 0 : 1 - length / way;
        work[i] *= (std::lerp(before, after, share) + after) / (2 * after);
    });
    return work;
}

}  // namespace

SurfaceModel::SurfaceModel(std::string name, const Substrate& substrate,
                           std::shared_ptr<const Indenter> indenter,
                           std::shared_ptr<const FrictionLaw> friction, double tolerance,
                           const Case::Contact& options)
    : name_(std::move(name)),
      substrate_(substrate.fresh(options.coupling)),
      indenter_(std::move(indenter)),
      friction_(std::move(friction)),
      tolerance_(tolerance),
      options_(options) {
    make_solver();
    release();
}

SurfaceModel::SurfaceModel(std::string name, std::shared_ptr<const Compliance> compliance,
                           std::shared_ptr<const Indenter> indenter,
                           std::shared_ptr<const FrictionLaw> friction, double tolerance,
                           const Case::Contact& options)
    : SurfaceModel(std::move(name), ElasticSubstrate(std::move(compliance)), std::move(indenter),
                   std::move(friction), tolerance, options) {}

void SurfaceModel::make_solver() {
    solver_.emplace(name_, *substrate_, *indenter_, friction_, tolerance_, options_);
    if (attracted_)
        solver_->attract((attracted_->by_cell
                              ? attraction_by_cell(points(), attracted_->law, attracted_->modulus)
                              : attraction_on(points(), attracted_->law, attracted_->modulus)));
}

void SurfaceModel::attract(const AttractionLaw& law, double modulus, bool by_cell) {
    attracted_ = {law, modulus, by_cell};
    make_solver();
    release();
}

std::unique_ptr<Model> SurfaceModel::sibling(const Case::Contact& options) const {
    auto other = std::make_unique<SurfaceModel>(name_, *substrate_, indenter_, friction_,
                                                tolerance_, options);
    other->set_larger_grid(larger_grid_);
    if (attracted_) other->attract(attracted_->law, attracted_->modulus, attracted_->by_cell);
    return other;
}

void SurfaceModel::enlarge(const ContactAtEdge& reached) {
    if (!larger_grid_) throw reached;
    substrate_ = larger_grid_(reached)->fresh(options_.coupling);
    make_solver();
    audit_ = {};
    release();
}

void SurfaceModel::release() {
    const std::size_t n = points().size();
    solver_->release();
    slip_ = TangentialField(n, substrate_->compliance().n_threads());
    contact_state_.assign(n, ContactState::open);
    for (auto* kept : {&least_pressure_, &least_share_, &slip_path_, &friction_work_, &work_})
        kept->clear();
    energy_ = material_dissipation_ = rotation_ = released_ = 0;
    bulk_ = {};
    hardest_ = not_pressed;
    substrate_->forget();
}

StepRecord SurfaceModel::roll(const LoadStep& step, double rotation) {
    check_rolls_on(name_, points());
    StepStart before = {
        solver_->tractions(), now().displacement, now().shift, rotation, centre_of(step), true};
    advect(points(), before.traction);
    advect(points(), before.displacement);
    substrate_->advect();
    return take(step, before);
}

StepRecord SurfaceModel::take(const LoadStep& step, const StepStart& before) {
    if (points().mirrored && (step.tangential[1].value != 0 || step.rotation != 0))
        throw std::logic_error(name_ + ": half of a contact takes no load across its symmetry");
    const bool between = step.in_proportion && !friction_->remembers() && !slid_freely(now());
    const std::vector<double> bound_before = between ? now().bound : std::vector<double>();
    phase_ = step.recurs ? step.phase : 0;
    rotation_ += before.rotation;
    bulk_ = step.bulk;
    solver_->solve(step, before);
    const NormalSolution& normal = *now().normal;
    const bool by_cell = attracted_ && attracted_->by_cell;
    if (reaches_edge(points(), by_cell             ? normal.share
                               : normal.attracts() ? normal.tension
                                                   : normal.pressure))
        throw ContactAtEdge(fmt::format(
            "{}: the contact reaches the edge of the meshed contact patch at phase {:.4g}", name_,
            step.phase));
    if (attracted_ && step.normal.value > hardest_.value) hardest_ = step.normal;
    update_slip(before);
    if (friction_->remembers())
        update_memory(before);
    else
        work_ = work_between({now(), before, bound_before, contact_state_, slip_},
                             blocks(bound_before.size()));
    blocks(slip_path_.size()).for_points([&](std::size_t i) {
        slip_path_[i] += norm(slip(i));
        friction_work_[i] += friction_work(i);
    });
    solver_->keep_start(phase_);
    audit_step(step, before.advected);
    blocks(least_pressure_.size()).for_points([&](std::size_t i) {
        least_pressure_[i] = std::min(least_pressure_[i], now().normal->pressure[i]);
    });
    for (std::size_t i = 0; i < least_share_.size(); ++i)
        least_share_[i] = std::min(least_share_[i], now().normal->share[i]);
    return record(step);
}

void SurfaceModel::update_slip(const StepStart& before) {
    const ContactSolution& s = now();
    const double unit = std::max(s.shift_factor, 1.) * solver_->friction_ratio() * s.normal->length;
    const Vector2 moved = s.shift - before.shift;
    const TangentialField &u = s.displacement.in_surface, &old = before.displacement.in_surface;
    blocks(s.bound.size()).for_points([&](std::size_t i) {
        if (!s.normal->touches(i) && !(s.bound[i] > 0)) {
            slip_.set(i, {0, 0});
            contact_state_[i] = ContactState::open;
            return;
        }
        slip_.set(i, moved + solver_->uneven_shift(before, i) - (u.at(i) - old.at(i)) -
                         solver_->before_touch(i));
        // On the bound without having moved is stick; 10 tolerances: the solver's noise.
        const bool moves = std::hypot(slip_.x[i], slip_.y[i]) > 10 * tolerance_ * unit;
        const bool at_bound = norm(s.tangential.traction.at(i)) >= s.bound[i] * (1 - 1e-9);
        contact_state_[i] = at_bound && moves ? ContactState::slip : ContactState::stick;
    });
}

/// Work by the law itself, which end values know as well as steps are short. What the tractions,
/// on the straight way from their last values, do more than that is set free: in a jump. What
/// hardens is known by its tractions, and compared with what its slip makes of it.
void SurfaceModel::update_memory(const StepStart& before) {
    const ContactSolution& s = now();
    const bool hardens = friction_->hardening() > 0;
    std::vector<double> way = s.way, by_slip = before.way;
    work_.assign(way.size(), 0);
    released_ = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        const double pressure = s.normal->pressure[i];
        if (!hardens) way[i] = friction_->healed(before.way[i]);
        if (!(pressure > 0)) continue;
        const Vector2 told = slip(i);
        const double length = norm(told);
        if (!(length > 0)) continue;
        by_slip[i] = friction_->way(before.way[i], length, pressure);
        if (!hardens) way[i] = by_slip[i];
        work_[i] = friction_->work(pressure, before.way[i], way[i], length);
        const Vector2 mean = .5 * (before.traction.in_surface.at(i) + s.tangential.traction.at(i));
        released_ += points().area[i] * (dot(mean, told) - work_[i]);
    }
    std::vector<double> bound(way.size());
    friction_->bounds({s.normal->pressure, points().x, points().y, by_slip}, bound);
    double misfit = 0, area = 0;
    for (std::size_t i = 0; i < bound.size(); ++i) {
        if (s.normal->pressure[i] > 0) area += points().area[i];
        if (contact_state_[i] == ContactState::slip && s.bound[i] > 0)
            misfit = std::max(misfit, std::abs(bound[i] - s.bound[i]));
    }
    // Slips are known to the tolerance times the contact's compliance.
    const double compliance =
        std::max(s.shift_factor, 1.) * s.normal->length * area / s.normal->force;
    if (misfit > 0)
        audit_.record("friction_follows_slip",
                      misfit / (1 + friction_->hardening() * compliance) * area / s.total_bound,
                      10 * tolerance_);
    solver_->remember(std::move(way));
}

double SurfaceModel::limit_tangential_ratio() const {
    const auto& area = points().area;
    std::vector<double> bound(least_pressure_.size());
    bounds_on_shares(*friction_, {least_pressure_, points().x, points().y}, least_share_, bound);
    const auto least = blocks(bound.size()).sum_points<Sums<2>>([&](Sums<2>& sum, std::size_t i) {
        sum[0] += area[i] * least_pressure_[i];
        sum[1] += area[i] * bound[i];
    });
    return friction_->share({least[0], least[1]}, limit_start_);
}

std::unique_ptr<const Interior> SurfaceModel::interior() {
    auto inside = substrate_->interior(solver_->tractions());
    if (inside && bulk_.stress[0] != 0) inside = with_bulk(*inside, bulk_);
    if (!inside || !inside->base_reaction) return inside;
    double applied = inside->applied_force();
    if (attracted_) applied += 2 * now().normal->pull;  // what presses and pulls may cancel
    audit_.record("interior_equilibrium", inside->missing_force() / applied,
                  substrate_->compliance().allowed_missing_reaction());
    return inside;
}

}  // namespace tricontact::contact
