#include <cmath>
#include <functional>
#include <optional>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/contact_share.h"
#include "contact/solvers/coupling.h"
#include "contact/solvers/edge_chatter.h"
#include "contact/solvers/normal_solver.h"
#include "contact/solvers/staggered_iteration.h"
#include "contact/surface.h"
#include "contact/surface_audit.h"
#include "rolling/rate_friction.h"
#include "rolling/run.h"
#include "rolling/steady_normal.h"
#include "rolling/steady_solver.h"
#include "rolling/stick_inverse.h"
#include "rolling/temperatures.h"

namespace tricontact::rolling {

namespace {

using contact::TangentialField;

/// Presses against heights [m], from the pressures of a similar problem.
using SolveNormal = std::function<contact::NormalSolution(
    const std::vector<double>& height, const contact::NormalControl&, const std::vector<double>&)>;

class StaggeredIteration {
  public:
    StaggeredIteration(const contact::Compliance& compliance, const RollingProblem& problem,
                       SolveNormal normal_solver)
        : compliance_(compliance),
          points_(compliance.points()),
          problem_(problem),
          drive_(problem.drive),
          coupling_(compliance, *problem.indenter, {.coupling = problem.coupling}),
          normal_solver_(std::move(normal_solver)),
          stick_inverse_(compliance) {
        steady_.traction = TangentialField(points_.size());
        if (const contact::Surface* other = problem_.other_state) {
            normal_.pressure = other->normal_traction;
            steady_.traction.x = other->tangential_traction_x;
            steady_.traction.y = other->tangential_traction_y;
            other_ = steady_;
        }
        coupling_.place({});
    }

    void run() {
        if (coupling_.is_decoupled()) {
            solve_normal(coupling_.bare_height());
            solve_tangential();
            return;
        }
        chatter_.begin(contact::jumps_at_edge(*problem_.friction) ? points_.size() : 0);
        const auto both = [&](const std::vector<double>& height, double) {
            solve_normal(height);
            solve_tangential();
            coupling_.update_lowering(steady_.traction);
            // What an iteration changed under the indenter is how far the pressures are off.
            contact::StaggeredIterate now{total(coupling_.bare_height(), coupling_.lowering()), 0};
            for (std::size_t i = 0; i < height.size(); ++i)
                if (normal_.pressure[i] > 0)
                    now.residual =
                        contact::larger(now.residual, std::abs(now.height[i] - height[i]));
            gap_residual_ = now.residual /= normal_.length;
            return now;
        };
        contact::stagger({"steady rolling", "", problem_.tolerance, 0}, coupling_.bare_height(),
                         both);
    }

    contact::Surface surface() const {
        contact::Surface s;
        s.n_x = points_.n_x;
        s.n_y = points_.n_y;
        s.first = points_.first;
        s.spacing = points_.spacing;
        s.normal_traction = normal_.pressure;
        s.tangential_traction_x = steady_.traction.x;
        s.tangential_traction_y = steady_.traction.y;
        s.friction_bound = bound_;
        s.displacement_x = total(steady_.displacement.x, coupling_.displacement().x);
        s.displacement_y = total(steady_.displacement.y, coupling_.displacement().y);
        s.displacement_z = total(normal_.displacement, coupling_.lowering());
        s.slip_x = steady_.slip.x;
        s.slip_y = steady_.slip.y;
        s.gap = total(coupling_.bare_height(), s.displacement_z);
        for (double& gap : s.gap) gap -= normal_.indentation;
        s.dissipation.assign(points_.size(), 0);
        s.contact_state.assign(points_.size(), contact::ContactState::open);
        classify(s);
        return s;
    }

    RollingState state(const contact::Surface& s) const {
        RollingState state = state_of(s, *problem_.indenter);
        state.distance = contact::infinity;
        state.creepage = steady_.creepage;
        state.indentation = normal_.indentation;
        state.iterations = iterations_;
        state.residual =
            std::max({normal_.residual, gap_residual_, steady_.residual, steady_.force_residual});
        return state;
    }

    contact::Audit audit(const SteadyRolling& result) const {
        contact::Audit audit;
        std::array<contact::TangentialControl, 2> control;
        for (int d = 0; d < 2; ++d)
            control[d] = {problem_.drive.creepage[d] ? contact::TangentialControl::Kind::shift
                                                     : contact::TangentialControl::Kind::force,
                          drive_.force[d]};
        contact::audit_normal(normal_, problem_.normal, points_.area, problem_.tolerance, audit);
        if (problem_.rate || problem_.friction_temperature)
            audit.record(problem_.rate ? "friction_follows_slip" : "friction_follows_temperature",
                         rate_residual_, problem_.tolerance);
        if (!coupling_.is_decoupled())
            audit.record("normal_and_tangential_agree", gap_residual_, problem_.tolerance);
        contact::audit_tangential({.bound = bound_,
                                   .area = points_.area,
                                   .traction = steady_.traction,
                                   .slip = steady_.slip,
                                   .contact_state = result.surface.contact_state,
                                   .control = control,
                                   .length = sliding_creepage(result.state.half_length)},
                                  problem_.tolerance, audit);
        return audit;
    }

  private:
    static std::vector<double> total(std::vector<double> a, const std::vector<double>& b) {
        for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
        return a;
    }

    void solve_normal(const std::vector<double>& height) {
        normal_ = normal_solver_(height, problem_.normal, normal_.pressure);
        iterations_ += normal_.iterations;
        if (contact::reaches_edge(points_, normal_.pressure))
            throw contact::ContactAtEdge(
                "steady rolling: the contact reaches the edge of the grid");
    }

    void solve_tangential() {
        bound_.resize(points_.size());
        problem_.friction->bounds({normal_.pressure}, bound_);
        if (chatter_.is_watched())
            for (std::size_t i = 0; i < bound_.size(); ++i)
                if (chatter_.lets_go(i, normal_.pressure[i] > 0)) bound_[i] = 0;
        coupling_.update_displacement(normal_.pressure);
        if (drive_.force_ratio)
            drive_.force[0] = problem_.friction->limit(total_friction(), *drive_.force_ratio);
        const double half_length = contact::counted_radius(points_, normal_.pressure);
        const SteadyProblem problem{bound_,
                                    coupling_.displacement(),
                                    drive_,
                                    problem_.indenter->lowest_point(),
                                    sliding_creepage(half_length),
                                    &stick_inverse_};
        if (problem_.rate || problem_.friction_temperature)
            solve_rated(problem);
        else
            solve_steady(compliance_, problem, {problem_.tolerance}, steady_);
        iterations_ += steady_.iterations;
    }

    /// What friction has left of itself goes on from one iteration to the next.
    void solve_rated(const SteadyProblem& problem) {
        const auto mu = problem_.friction->coulomb();
        const bool by_heat = problem_.friction_temperature.has_value();
        if (!mu || (by_heat && (problem_.rate || !problem_.heat)))
            throw contact::InputError(
                "rolling: friction that changes with slip or temperature is Coulomb's at rest, and "
                "by one of both; temperatures need heat");
        ChangingFriction friction =
            by_heat ? friction_by_temperature(points_, *problem_.friction_temperature,
                                              *problem_.heat, *mu, problem_.speed, bound_)
                    : friction_by_rate(points_, *problem_.rate, *mu, problem_.speed);
        if (!by_heat && problem_.slip_start == SlipStart::slow) {
            if (!slip_alone_) slip_alone_ = slip_alone(compliance_);
            friction.slip_alone = *slip_alone_;
        }
        rate_residual_ =
            solve_steady_rated(compliance_, problem, friction, problem_.slip_start,
                               problem_.tolerance, steady_, left_, other_ ? &*other_ : nullptr);
        for (std::size_t i = 0; i < bound_.size(); ++i) bound_[i] *= left_[i];
    }

    contact::FrictionLaw::Total total_friction() const {
        double bound = 0;
        for (std::size_t i = 0; i < bound_.size(); ++i) bound += points_.area[i] * bound_[i];
        return {normal_.force, bound};
    }

    /// mu d over the half length [-]: about the creepage of full sliding.
    double sliding_creepage(double half_length) const {
        return problem_.friction->ratio(total_friction()) * normal_.length / half_length;
    }

    /// Dissipation and zones, from tractions and slip.
    void classify(contact::Surface& s) const {
        using contact::ContactState;
        const double still =
            10 * problem_.tolerance * sliding_creepage(state_of(s, *problem_.indenter).half_length);
        for (std::size_t i = 0; i < s.size(); ++i) {
            const contact::Vector2 t = {s.tangential_traction_x[i], s.tangential_traction_y[i]};
            const contact::Vector2 slip = {s.slip_x[i], s.slip_y[i]};
            // On the bound without sliding is stick.
            const bool slips =
                contact::norm(t) >= bound_[i] * (1 - 1e-9) && contact::norm(slip) > still;
            s.contact_state[i] = !(s.normal_traction[i] > 0) ? ContactState::open
                                 : slips                     ? ContactState::slip
                                                             : ContactState::stick;
            const contact::Vector2 told = contact::told_slip(s.contact_state[i], slip);
            s.slip_x[i] = told[0];
            s.slip_y[i] = told[1];
            s.dissipation[i] = contact::frictional_work(s.contact_state[i], t, told);
        }
    }

    const contact::Compliance& compliance_;
    const contact::ContactPoints& points_;
    const RollingProblem& problem_;
    Drive drive_;  // its forces are those of the present F_N
    contact::Coupling coupling_;
    SolveNormal normal_solver_;
    StickInverse stick_inverse_;
    contact::NormalSolution normal_;
    std::vector<double> bound_;
    contact::EdgeChatter chatter_;
    SteadySolution steady_;
    std::optional<SteadySolution> other_;  // tractions alone
    std::vector<double> left_;             // of friction by its rate, see solve_steady_rated
    std::optional<double> slip_alone_;     // once for all iterations
    double rate_residual_ = 0;
    double gap_residual_ = 0;
    int iterations_ = 0;
};

SteadyRolling solved(const contact::Compliance& compliance, const RollingProblem& problem,
                     SolveNormal normal_solver) {
    contact::check_rolls_on("steady rolling", compliance.points());
    StaggeredIteration iteration(compliance, problem, std::move(normal_solver));
    iteration.run();
    SteadyRolling result;
    result.surface = iteration.surface();
    result.state = iteration.state(result.surface);
    result.audit = iteration.audit(result);
    if (problem.heat) {
        result.temperatures = surface_temperatures(result.surface, *problem.heat, problem.speed);
        result.state.temperature = highest_temperature(result.surface, *result.temperatures);
    }
    return result;
}

/// Work of the tractions on what flows through the contact, per rolled way [J/m]: what the material
/// does not give back. The mean of differences ahead and back is exactly zero of elastic bodies.
double work_on_material(const contact::Surface& s) {
    const auto n = static_cast<std::ptrdiff_t>(s.size());
    double sum = 0;
    for (const auto& [t, u] : {std::pair{&s.tangential_traction_x, &s.displacement_x},
                               std::pair{&s.tangential_traction_y, &s.displacement_y},
                               std::pair{&s.normal_traction, &s.displacement_z}})
        for (std::ptrdiff_t i = 1; i + 1 < n; ++i) sum += (*t)[i] * ((*u)[i - 1] - (*u)[i + 1]) / 2;
    return sum * s.spacing[1];
}

}  // namespace

SteadyRolling steady_rolling(const contact::Compliance& compliance, const RollingProblem& problem) {
    const contact::NormalSolver solver(compliance, 0.1 * problem.tolerance);
    return solved(compliance, problem,
                  [&](const auto& height, const auto& control, const auto& start) {
                      return solver.solve(height, control, start);
                  });
}

SteadyRolling steady_rolling(const contact::SteadyCompliance& compliance,
                             const RollingProblem& problem) {
    const SteadyNormalSolver solver(compliance, 0.1 * problem.tolerance);
    SteadyRolling result = solved(compliance, problem,
                                  [&](const auto& height, const auto& control, const auto& start) {
                                      return solver.solve(height, control, start);
                                  });
    result.state.material_dissipation = work_on_material(result.surface);
    return result;
}

}  // namespace tricontact::rolling
