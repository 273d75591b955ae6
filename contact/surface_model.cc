#include "contact/surface_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/error.h"
#include "contact/placement.h"
#include "contact/solvers/fixed_point.h"
#include "contact/solvers/largest.h"
#include "contact/solvers/moving_frame.h"

namespace tricontact::contact {

namespace {
// Normal solutions are kept while they fit: a period comes back to the same offsets again and
// again.
constexpr std::size_t normal_cache_bytes = std::size_t{1} << 28;
}  // namespace

SurfaceModel::SurfaceModel(std::string name, const Substrate& substrate,
                           std::shared_ptr<const Indenter> indenter, double friction_coefficient,
                           double tolerance, const Case::Contact& options)
    : name_(std::move(name)),
      substrate_(substrate.fresh(options.coupling)),
      indenter_(std::move(indenter)),
      friction_coefficient_(friction_coefficient),
      tolerance_(tolerance),
      options_(options),
      coupling_(substrate_->compliance(), *indenter_, options) {
    make_solvers();
    release();
}

SurfaceModel::SurfaceModel(std::string name, std::shared_ptr<const Compliance> compliance,
                           std::shared_ptr<const Indenter> indenter, double friction_coefficient,
                           double tolerance, const Case::Contact& options)
    : SurfaceModel(std::move(name), ElasticSubstrate(std::move(compliance)), std::move(indenter),
                   friction_coefficient, tolerance, options) {}

void SurfaceModel::make_solvers() {
    normal_solver_.emplace(substrate_->compliance(), 0.1 * tolerance_);
    // Where friction lowers the surface, its errors come back in the gap, mu times those over mu p.
    const double finer = coupling_.absent() ? 1 : std::min(1., .1 / friction_coefficient_);
    tangential_solver_.emplace(substrate_->compliance(), finer * tolerance_);
}

std::unique_ptr<Model> SurfaceModel::sibling(const Case::Contact& options) const {
    auto other = std::make_unique<SurfaceModel>(name_, *substrate_, indenter_,
                                                friction_coefficient_, tolerance_, options);
    other->set_larger_grid(larger_grid_);
    return other;
}

void SurfaceModel::enlarge(const ContactAtEdge& reached) {
    if (!larger_grid_) throw reached;
    substrate_ = larger_grid_(reached)->fresh(options_.coupling);
    coupling_ = Coupling(substrate_->compliance(), *indenter_, options_);
    make_solvers();
    normal_cache_.clear();
    audit_ = {};
    release();
}

void SurfaceModel::release() {
    const std::size_t n = points().size();
    offset_ = shift_ = {};
    starts_.clear();
    normal_ = std::make_shared<NormalSolution>(
        NormalSolution{.pressure = std::vector<double>(n), .displacement = std::vector<double>(n)});
    bound_.assign(n, 0);
    tangential_ = {};
    tangential_.traction = tangential_.displacement = displacement_ = slip_ = TangentialField(n);
    displacement_z_.assign(n, 0);
    contact_state_.assign(n, ContactState::open);
    for (auto* kept : {&least_pressure_, &slip_path_, &friction_work_}) kept->clear();
    energy_ = material_dissipation_ = shift_factor_ = 0;
    substrate_->forget();
}

StepRecord SurfaceModel::advance(const LoadStep& step) {
    return take(step, {tractions(), displacements(), shift_});
}

StepRecord SurfaceModel::roll(const LoadStep& step, double turn) {
    check_rolls_on(name_, points());
    Before before = {tractions(), displacements(), shift_, turn, true};
    carry(points(), before.traction);
    carry(points(), before.displacement);
    substrate_->carry();
    return take(step, before);
}

StepRecord SurfaceModel::take(const LoadStep& step, const Before& before) {
    normal_iterations_ = tangential_iterations_ = 0;
    phase_ = step.phase;
    offset_ = step.offset;
    if (substrate_->begin(step.duration, before.traction, before.displacement)) make_solvers();
    if (coupling_.absent())
        solve_uncoupled(step, before);
    else
        solve_coupled(step, before);
    if (reaches_edge(points(), normal_->pressure))
        throw ContactAtEdge(fmt::format(
            "{}: the contact reaches the edge of the meshed contact patch at phase {:.4g}", name_,
            step.phase));
    update_totals();
    update_slip(before);
    for (std::size_t i = 0; i < slip_path_.size(); ++i) {
        slip_path_[i] += norm(slip(i));
        friction_work_[i] += friction_work(i);
    }
    keep_start();
    audit_step(step, before.carried);
    for (std::size_t i = 0; i < least_pressure_.size(); ++i)
        least_pressure_[i] = std::min(least_pressure_[i], normal_->pressure[i]);
    return record(step);
}

/// Shift of the indenter at a point by its turn [m].
Vector2 SurfaceModel::rigid_turn(const Before& before, std::size_t i) const {
    if (before.turn == 0) return {};
    const double ahead = spin_point * points().spacing[0];
    return {-before.turn * (points().y[i] - offset_[1]),
            before.turn * (points().x[i] + ahead - offset_[0])};
}

SurfaceField SurfaceModel::tractions() const {
    const auto& p = normal_->pressure;
    const auto& t = tangential_.traction;
    return {coupling_.surface_traction(p, t), coupling_.downward_traction(p, t)};
}

void SurfaceModel::solve_uncoupled(const LoadStep& step, const Before& before) {
    reuse_or_solve_normal(step);
    tangential_.shift_increment = {};
    if (step.friction)
        solve_tangential(step, before);
    else
        slide_freely(step);
}

/// Turns begin where the same phase ended one period ago, if there was one.
void SurfaceModel::recall_start() {
    tangential_.shift_increment = {};
    const PeriodStarts::Start* start = starts_.find(phase_);
    if (!start || !(start->normal->force > 0)) return;
    normal_ = start->normal;
    tangential_.traction = start->traction;
    tangential_.shift_increment = start->shift_increment;
}

void SurfaceModel::keep_start() {
    if (!coupling_.absent())
        starts_.keep(phase_, {normal_, tangential_.traction, tangential_.shift_increment});
}

/// Turns of normal and tangential contact; the geometry of a displaced surface follows behind.
void SurfaceModel::solve_coupled(const LoadStep& step, const Before& before) {
    recall_start();
    auto height_now = [&] {
        coupling_.place({offset_, shift_, displacement_});
        coupling_.update_height(normal_->pressure, tangential_.traction);
        return effective_height();
    };
    std::vector<double> height = height_now();
    FixedPoint turns;
    for (int turn = 1; turn <= FixedPoint::max_turns; ++turn) {
        NormalControl control = step.normal;
        if (control.kind == NormalControl::Kind::force)
            control.value -= coupling_.normal_force(tangential_.traction);
        solve_normal(control, height);
        coupling_.update_displacement(normal_->pressure, tangential_.traction);
        if (step.friction)
            solve_tangential(step, before);
        else
            slide_freely(step);
        update_totals();

        // What the turn changed under the indenter is how far the pressures are from right.
        const std::vector<double> now = height_now();
        double change = 0;
        for (std::size_t i = 0; i < height.size(); ++i)
            if (normal_->pressure[i] > 0) change = larger(change, std::abs(now[i] - height[i]));
        gap_residual_ = change / (substrate_->stiffness() * normal_->length);
        if (gap_residual_ <= tolerance_) return;
        height = turns.next(height, now, gap_residual_);
    }
    throw NotConverged(fmt::format(
        "{}: normal and tangential contact do not agree at phase {:.4g}: the gap still changes by "
        "{:.2e} of the indentation after {} turns (tolerance {:.1e})",
        name_, step.phase, gap_residual_, FixedPoint::max_turns, tolerance_));
}

void SurfaceModel::reuse_or_solve_normal(const LoadStep& step) {
    const Key key{step.offset, step.normal.kind, step.normal.value};
    if (substrate_->relaxes()) {  // the same position is not the same problem
        coupling_.place({offset_, shift_, displacement_});
        coupling_.update_height(normal_->pressure, tangential_.traction);
        solve_normal(step.normal, effective_height());
        return;
    }
    if (const auto it = normal_cache_.find(key); it != normal_cache_.end()) {
        normal_ = it->second;
        return;
    }
    coupling_.place({offset_, shift_, displacement_});
    coupling_.update_height(normal_->pressure, tangential_.traction);
    solve_normal(step.normal, effective_height());
    const std::size_t bytes = 2 * sizeof(double) * bound_.size();
    if ((normal_cache_.size() + 1) * bytes <= normal_cache_bytes) normal_cache_[key] = normal_;
}

/// coupling_.height() for the effective displacements.
std::vector<double> SurfaceModel::effective_height() const {
    std::vector<double> height = coupling_.height();
    if (!substrate_->relaxes()) return height;
    for (std::size_t i = 0; i < height.size(); ++i)
        height[i] = substrate_->stiffness() * coupling_.bare_height()[i] + coupling_.lowering()[i] -
                    substrate_->offset().down[i];
    return height;
}

/// Presses against `height`, starting from the last pressures.
void SurfaceModel::solve_normal(NormalControl control, const std::vector<double>& height) {
    const bool warm = normal_->force > 0 && control.kind == NormalControl::Kind::force;
    if (control.kind == NormalControl::Kind::indentation) control.value *= substrate_->stiffness();
    NormalSolution solution =
        normal_solver_->solve(height, control, warm ? normal_->pressure : std::vector<double>{});
    solution.indentation /= substrate_->stiffness();
    solution.length /= substrate_->stiffness();
    normal_ = std::make_shared<const NormalSolution>(std::move(solution));
    normal_iterations_ += normal_->iterations;
}

/// What is prescribed of a step, ratios as the forces that they are at the present F_N.
std::array<TangentialControl, 2> SurfaceModel::forces_and_shifts(const LoadStep& step) const {
    std::array<TangentialControl, 2> control = step.tangential;
    for (TangentialControl& one : control)
        if (one.kind == TangentialControl::Kind::ratio)
            one = {TangentialControl::Kind::force,
                   one.value * friction_coefficient_ *
                       (normal_->force + coupling_.normal_force(tangential_.traction))};
    return control;
}

void SurfaceModel::solve_tangential(const LoadStep& step, const Before& before) {
    for (std::size_t i = 0; i < bound_.size(); ++i)
        bound_[i] = friction_coefficient_ * normal_->pressure[i];
    std::array<TangentialControl, 2> control = forces_and_shifts(step);
    const Vector2 by_pressure = coupling_.tangential_force(normal_->pressure);
    const double stiffness = substrate_->stiffness();
    for (int d = 0; d < 2; ++d)
        control[d].value = control[d].kind == TangentialControl::Kind::shift
                               ? stiffness * (control[d].value - before.shift[d])
                               : control[d].value - by_pressure[d];
    // Both halves of a mirrored contact push against each other: nothing moves it across.
    if (points().mirrored) control[1] = {TangentialControl::Kind::shift, 0};

    TangentialField relative = before.displacement.in_surface;
    const TangentialField& other = coupling_.displacement();
    double contact_area = 0;
    for (std::size_t i = 0; i < bound_.size(); ++i) {
        if (substrate_->relaxes()) {
            relative.x[i] = stiffness * relative.x[i] + substrate_->offset().in_surface.x[i];
            relative.y[i] = stiffness * relative.y[i] + substrate_->offset().in_surface.y[i];
        }
        const Vector2 turned = rigid_turn(before, i);
        relative.x[i] += stiffness * turned[0] - other.x[i];
        relative.y[i] += stiffness * turned[1] - other.y[i];
        if (bound_[i] > 0) contact_area += points().area[i];
    }
    if (shift_factor_ == 0) find_shift_factor();
    const double contact_compliance =
        shift_factor_ * stiffness * normal_->length * contact_area / normal_->force;
    for (double& increment : tangential_.shift_increment) increment *= stiffness;
    tangential_solver_->solve({bound_, relative, control, contact_compliance}, tangential_);
    tangential_iterations_ += tangential_.iterations;
    for (int d = 0; d < 2; ++d) {
        tangential_.shift_increment[d] /= stiffness;
        shift_[d] = before.shift[d] + tangential_.shift_increment[d];
    }
}

/// Tangential displacements are about mu d under the tractions of sliding, and compared with that:
/// on a half-space their mean is below that at the centre, mu d E*/G*, and E*/G* = (2 - nu)/(2 (1 -
/// nu)) at most 3/2. A thin incompressible layer is softer along than that, and one that glides on
/// its ground is like a membrane, a thousand times as soft: there mu d would ask for more than the
/// solver's tolerance of the tractions gives.
void SurfaceModel::find_shift_factor() {
    constexpr double of_half_spaces = 1.5;
    TangentialField sliding(bound_.size()), displacement(bound_.size());
    sliding.x = bound_;
    substrate_->compliance().tangential(sliding, displacement);
    double work = 0, force = 0;
    for (std::size_t i = 0; i < bound_.size(); ++i) {
        work += points().area[i] * bound_[i] * displacement.x[i];
        force += points().area[i] * bound_[i];
    }
    const double mean = work / force;
    const double across = friction_coefficient_ * substrate_->stiffness() * normal_->length;
    shift_factor_ = mean > of_half_spaces * across ? mean / across : 1;
}

/// Without friction no tangential traction is left, and only a prescribed shift moves the indenter.
void SurfaceModel::slide_freely(const LoadStep& step) {
    const std::size_t n = bound_.size();
    const Vector2 before = shift_;
    tangential_ = {};
    tangential_.traction = tangential_.displacement = TangentialField(n);
    bound_.assign(n, 0);
    for (int d = 0; d < 2; ++d)
        if (step.tangential[d].kind == TangentialControl::Kind::shift)
            shift_[d] = step.tangential[d].value;
    for (int d = 0; d < 2; ++d) tangential_.shift_increment[d] = shift_[d] - before[d];
}

/// The displacements by all tractions of the present solution.
void SurfaceModel::update_totals() {
    displacement_ = tangential_.displacement;
    displacement_z_ = normal_->displacement;
    if (!coupling_.absent()) {
        const TangentialField& other = coupling_.displacement();
        for (std::size_t i = 0; i < bound_.size(); ++i) {
            displacement_.x[i] += other.x[i];
            displacement_.y[i] += other.y[i];
            displacement_z_[i] += coupling_.lowering()[i];
        }
    }
    if (!substrate_->relaxes()) return;
    const SurfaceField& offset = substrate_->offset();
    for (std::size_t i = 0; i < bound_.size(); ++i) {
        displacement_.x[i] =
            (displacement_.x[i] - offset.in_surface.x[i]) / substrate_->stiffness();
        displacement_.y[i] =
            (displacement_.y[i] - offset.in_surface.y[i]) / substrate_->stiffness();
        displacement_z_[i] = (displacement_z_[i] - offset.down[i]) / substrate_->stiffness();
    }
}

void SurfaceModel::update_slip(const Before& before) {
    const double unit = std::max(shift_factor_, 1.) * friction_coefficient_ * normal_->length;
    const Vector2 moved = {shift_[0] - before.shift[0], shift_[1] - before.shift[1]};
    for (std::size_t i = 0; i < bound_.size(); ++i) {
        const Vector2 t = {tangential_.traction.x[i], tangential_.traction.y[i]};
        const Vector2 turned = rigid_turn(before, i);
        slip_.x[i] =
            moved[0] + turned[0] - (displacement_.x[i] - before.displacement.in_surface.x[i]);
        slip_.y[i] =
            moved[1] + turned[1] - (displacement_.y[i] - before.displacement.in_surface.y[i]);
        if (!(normal_->pressure[i] > 0)) {
            slip_.x[i] = slip_.y[i] = 0;
            contact_state_[i] = ContactState::open;
            continue;
        }
        // On the bound without having moved is stick; 10 tolerances: the solver's noise.
        const bool moves = std::hypot(slip_.x[i], slip_.y[i]) > 10 * tolerance_ * unit;
        const bool at_bound = norm(t) >= bound_[i] * (1 - 1e-9);
        contact_state_[i] = at_bound && moves ? ContactState::slip : ContactState::stick;
    }
}

void SurfaceModel::start_period() {
    slip_path_.assign(bound_.size(), 0);
    friction_work_ = slip_path_;
}

void SurfaceModel::start_limit() {
    least_pressure_ = normal_->pressure;
    least_pressure_force_ = normal_->force;
}

double SurfaceModel::limit_tangential_ratio() const {
    const auto& area = points().area;
    double sum = 0;
    for (std::size_t i = 0; i < least_pressure_.size(); ++i) sum += area[i] * least_pressure_[i];
    return sum / least_pressure_force_;
}

std::unique_ptr<const Interior> SurfaceModel::interior() {
    auto inside = substrate_->interior(tractions());
    if (!inside || !inside->base_reaction) return inside;
    double missing = 0, applied = 0;
    for (int d = 0; d < 3; ++d) {
        missing = std::hypot(missing, inside->applied[d] + (*inside->base_reaction)[d]);
        applied = std::hypot(applied, inside->applied[d]);
    }
    audit_.record("interior_equilibrium", missing / applied,
                  substrate_->compliance().allowed_missing_reaction());
    return inside;
}

}  // namespace tricontact::contact
