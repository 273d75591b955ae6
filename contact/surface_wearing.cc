#include "contact/surface_wearing.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/mirrored_surface.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"

namespace tricontact::contact {

namespace {

/// The compliance of the bodies with springs of their own at the points, in series.
class GivingCompliance final : public Compliance {
  public:
    /// `give` [m/Pa] >= 0.
    GivingCompliance(const Compliance& bodies, std::vector<double> give)
        : bodies_(bodies), give_(std::move(give)) {}

    const ContactPoints& points() const override { return bodies_.points(); }
    int n_threads() const override { return bodies_.n_threads(); }
    bool is_coupled() const override { return false; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        bodies_.normal(p, u_z);
        for (std::size_t i = 0; i < p.size(); ++i) u_z[i] += give_[i] * p[i];
    }
    void tangential(const TangentialField& t, TangentialField& u) const override {
        bodies_.tangential(t, u);
    }
    double local_tangential() const override { return bodies_.local_tangential(); }
    void precondition_tangential(const TangentialField& r, TangentialField& z) const override {
        bodies_.precondition_tangential(r, z);
    }

  private:
    const Compliance& bodies_;
    std::vector<double> give_;
};

}  // namespace

/// Sums over the steps of a cycle.
struct SurfaceWearing::Slipped {
    explicit Slipped(std::size_t n) : worn(n), path(n), told(n), touched(n) {}
    std::vector<double> worn;  // sum of p |s| [N/m] or of the work [J/m^2]
    std::vector<double> path;  // sum of |s| [m]
    std::vector<double> told;  // the same of points that touch and slip [m]
    std::vector<char> touched;
    double work = 0, by_means = 0;  // [J]; of `worn` by mean pressures, over all [N m]
    double force[2] = {infinity, -infinity}, shift[2] = {infinity, -infinity};  // least, most
    void cover(const StepRecord& record) {
        force[0] = std::min(force[0], record.tangential_force[0]);
        force[1] = std::max(force[1], record.tangential_force[0]);
        shift[0] = std::min(shift[0], record.shift[0]);
        shift[1] = std::max(shift[1], record.shift[0]);
    }
};

bool WearProblem::rolls() const {
    return std::any_of(steps.begin() + static_cast<std::ptrdiff_t>(n_before), steps.end(),
                       [&](const LoadStep& step) { return step.offset != steps.back().offset; });
}

bool WearProblem::presses() const {
    return std::any_of(steps.begin() + static_cast<std::ptrdiff_t>(n_before) - 1, steps.end(),
                       [&](const LoadStep& step) { return step.normal != steps.back().normal; });
}

SurfaceWearing::SurfaceWearing(SurfaceModel& model, WearProblem problem)
    : model_(model),
      problem_(std::move(problem)),
      by_steps_(problem_.rolls() || (problem_.presses() && !model.is_coupled())) {
    if (problem_.rolls() && model_.is_coupled())
        throw InputError("[wear]: " + model_.name() +
                         ": wear by rolling is computed of contact without coupling; set "
                         "contact.coupling = false, or leave out the offsets");
}

void SurfaceWearing::require_sound() const {
    for (const auto& check : model_.audit().checks())
        if (!check.passed())
            throw NotConverged(model_.name() + ": a solution of the wearing contact fails its " +
                               check.name);
}

void SurfaceWearing::add_step(const LoadStep& step, Slipped& sums) {
    const std::vector<double> pressure = model_.now().normal->pressure;
    const TangentialField before = model_.now().displacement.in_surface;
    const Vector2 shift = model_.now().shift;
    const StepRecord record = driven().advance(step);
    require_sound();
    const ContactSolution& now = model_.now();
    const bool by_work = problem_.law.energy_coefficient.has_value();
    Part part{.step = step};
    if (by_steps_) {
        part.slip.assign(pressure.size(), 0);
        part.rate = part.slip;
        part.pressure = now.normal->pressure;
    }
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        const double p = now.normal->pressure[i], area = model_.points().area[i];
        if (!(p > 0)) {
            // Of use to jumps alone: what the point would slip if it touched.
            const double would =
                norm(now.shift - shift - (now.displacement.in_surface.at(i) - before.at(i)));
            sums.path[i] += would;
            if (by_steps_) part.slip[i] = would;
            continue;
        }
        sums.touched[i] = 1;
        const double slip = norm(model_.slip(i)), work = model_.friction_work(i);
        sums.path[i] += slip;
        sums.told[i] += slip;
        sums.worn[i] += by_work ? work : p * slip;
        if (by_steps_) {
            part.slip[i] = slip;
            part.rate[i] = wear_factor() * (by_work ? work : p * slip);
        }
        const double mean = (p + pressure[i]) / 2;
        sums.by_means += area * (by_work ? work * mean / p : mean * slip);
        sums.work += area * work;
    }
    sums.cover(record);
    if (by_steps_) recent_.back().steps.push_back(std::move(part));
}

double SurfaceWearing::wear_factor() const {
    const Wear& law = problem_.law;
    return law.energy_coefficient ? *law.energy_coefficient : *law.coefficient;
}

WornCycle SurfaceWearing::cycle(const std::vector<double>& worn) {
    constexpr std::size_t most_recent = 2;
    if (by_steps_) {
        recent_.push_back({.worn = worn});
        if (recent_.size() > most_recent) recent_.pop_front();
    }
    model_.solver_->wear(worn);
    driven().release();
    const std::size_t n = model_.points().size();
    Slipped sums(n);
    StepRecord record;
    for (std::size_t k = 0; k < problem_.n_before; ++k)
        record = driven().advance(problem_.steps[k]);
    require_sound();
    sums.cover(record);
    const LoadStep& last = problem_.steps.back();
    const bool has_limit =
        problem_.rolls() && !problem_.presses() && last.normal.kind == NormalControl::Kind::force;
    if (has_limit) model_.start_limit();
    for (std::size_t k = problem_.n_before; k < problem_.steps.size(); ++k)
        add_step(problem_.steps[k], sums);

    const ContactSolution& now = model_.now();
    const double factor = wear_factor();
    WornCycle found;
    found.rate = std::move(sums.worn);
    found.slip_path = std::move(sums.path);
    for (std::size_t i = 0; i < n; ++i) {
        const double area = model_.points().area[i];
        found.rate[i] *= factor;
        found.volume += area * found.rate[i];
        if (!sums.touched[i]) continue;
        found.contact_area += area;
        if (sums.told[i] == 0) found.stick_area += area;
    }
    found.volume_by_means = factor * sums.by_means;
    found.work = sums.work;
    found.normal_force = now.normal->force;
    found.indentation = now.normal->indentation;
    found.force_amplitude = (sums.force[1] - sums.force[0]) / 2;
    found.shift_amplitude = (sums.shift[1] - sums.shift[0]) / 2;
    found.pressure = now.normal->pressure;
    if (has_limit) found.shakedown_limit = model_.limit_tangential_ratio();
    if (model_.is_coupled()) {
        std::vector<double> height = heights_at(last.offset);
        for (std::size_t i = 0; i < n; ++i) height[i] += worn[i];
        found.pressure = NormalSolver(model_.substrate_->compliance(), .1 * model_.tolerance_)
                             .solve(height, last.normal, found.pressure)
                             .pressure;
    }
    return found;
}

std::vector<double> SurfaceWearing::heights_at(const Vector2& offset) const {
    return heights_over(model_.points(), *model_.indenter_, offset,
                        model_.substrate_->compliance().n_threads());
}

void SurfaceWearing::enlarge(const ContactAtEdge& reached) {
    model_.enlarge(reached);
    heights_.clear();
    recent_.clear();
}

/// Of the profile `worn`, whose cycle may have been kept by another process.
const std::vector<SurfaceWearing::Part>& SurfaceWearing::steps_of(const std::vector<double>& worn) {
    auto found = std::ranges::find(recent_, worn, &RolledCycle::worn);
    if (found == recent_.end()) {
        cycle(worn);
        found = recent_.end() - 1;
    }
    return found->steps;
}

std::vector<double> SurfaceWearing::jump(const std::vector<double>& worn, const WornCycle& now,
                                         double n) {
    const auto& area = model_.points().area;
    // kappa of dh = kappa p ds.
    const auto kappa_of = [&](const Part& part) {
        double rate = 0, pressing = 0;
        for (std::size_t i = 0; i < worn.size(); ++i) {
            rate += area[i] * part.rate[i];
            pressing += area[i] * part.slip[i] * part.pressure[i];
        }
        return rate > 0 ? rate / pressing : 0.;
    };
    const std::vector<Part> parts =
        by_steps_
            ? steps_of(worn)
            : std::vector<Part>{{problem_.steps.back(), now.slip_path, now.rate, now.pressure}};
    std::vector<double> after = worn;
    for (const Part& part : parts)
        if (const double kappa = kappa_of(part); kappa > 0) after = worn_by(after, part, kappa, n);
    return after;
}

/// By `n` cycles of one part of a cycle, implicit in its pressure.
std::vector<double> SurfaceWearing::worn_by(const std::vector<double>& worn, const Part& part,
                                            double kappa, double n) {
    const bool is_last = part.step.offset == problem_.steps.back().offset;
    if (is_last && heights_.empty()) heights_ = heights_at(part.step.offset);
    std::vector<double> give(worn.size()), rest(worn.size());
    std::vector<double> height = is_last ? heights_ : heights_at(part.step.offset);
    for (std::size_t i = 0; i < worn.size(); ++i) {
        give[i] = n * kappa * part.slip[i];
        rest[i] = n * part.rate[i] - give[i] * part.pressure[i];
        height[i] += worn[i] + rest[i];
    }
    const GivingCompliance giving(model_.substrate_->compliance(), give);
    const NormalSolution pressed =
        NormalSolver(giving, .1 * model_.tolerance_).solve(height, part.step.normal, part.pressure);
    if (reaches_edge(model_.points(), pressed.pressure))
        throw ContactAtEdge(model_.name() +
                            ": the worn contact reaches the edge of the meshed contact patch");
    std::vector<double> after = worn;
    for (std::size_t i = 0; i < worn.size(); ++i)
        after[i] += std::max(0., rest[i] + give[i] * pressed.pressure[i]);
    return after;
}

std::vector<double> SurfaceWearing::on_surface(const std::vector<double>& field) const {
    const ContactPoints& points = model_.points();
    if (!points.mirrored || (points.n_x == 0 && points.quads.empty())) return field;
    if (points.quads.empty()) return mirrored_rows(field, points.n_x, false);
    Surface half;
    half.layout = Surface::Layout::nodes;
    half.n_x = points.n_x;
    half.n_y = points.n_y;
    half.first = points.first;
    half.spacing = points.spacing;
    half.node_x = points.x;
    half.node_y = points.y;
    half.quads = points.quads;
    half.normal_traction = field;
    return mirrored(std::move(half)).normal_traction;
}

/// The points of the row next to y = 0; of two, the lower one.
std::vector<std::size_t> SurfaceWearing::line() const {
    const ContactPoints& points = model_.points();
    double nearest = infinity;
    for (const double y : points.y) nearest = std::min(nearest, std::abs(y));
    const double room = 1e-6 * std::sqrt(*std::ranges::max_element(points.area));
    double row = infinity;
    for (const double y : points.y)
        if (std::abs(y) <= nearest + room) row = std::min(row, y);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::abs(points.y[i] - row) <= room) found.push_back(i);
    std::ranges::sort(found, {}, [&](std::size_t i) { return points.x[i]; });
    return found;
}

void refuse_wear(const Case& c) {
    throw InputError("wear.cycles = " + std::to_string(c.of<Wear>().cycles) +
                     ": only `tricontact run` repeats a path and wears the surfaces; take that, or "
                     "leave out [wear]");
}

std::unique_ptr<WearingContact> SurfaceModel::wearing(const WearProblem& problem) {
    return std::make_unique<SurfaceWearing>(*this, problem);
}

}  // namespace tricontact::contact
