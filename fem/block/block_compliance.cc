#include "fem/block/block_compliance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fem/block/inside_solver.h"
#include "fem/dense_compliance.h"
#include "fem/discretisation.h"

namespace tricontact::fem {

namespace {

using contact::SurfaceField;
using contact::TangentialField;

}  // namespace

BlockCompliance::BlockCompliance(std::shared_ptr<const LayerProblem> problem, const BlockGrid& grid,
                                 double tolerance, int n_threads)
    : problem_(std::move(problem)),
      solver_(grid, n_threads),
      surface_([&] {
          const Q2Space space(problem_->mesh);
          return contact_surface(space);
      }()),
      mass_(surface_.mass),
      tolerance_(tolerance) {
    const double top = grid.axes[2].planes.back();
    for (std::size_t i = 0; i < points().size(); ++i)
        node_.push_back(grid.nearest_node({points().x[i], points().y[i], top}));
}

/// z of the elements points out of the substrate. A mirrored block carries half of the forces.
std::vector<double> BlockCompliance::forces_of(const SurfaceField& t) const {
    const std::size_t n = solver_.mixed().n_nodes();
    std::vector<double> forces(solver_.mixed().size());
    for (std::size_t i = 0; i < node_.size(); ++i) {
        const double area = points().area[i] * modelled_part(points());
        forces[node_[i]] = area * t.in_surface.x[i];
        forces[n + node_[i]] = area * t.in_surface.y[i];
        forces[2 * n + node_[i]] = -area * t.down[i];
    }
    return forces;
}

SurfaceField BlockCompliance::solve(const SurfaceField& t, std::vector<double>& start) const {
    forces_ = forces_of(t);
    n_iterations_ += solver_.solve(forces_, tolerance_, start);
    ++n_solutions_;
    SurfaceField u(node_.size());
    const std::size_t n = solver_.mixed().n_nodes();
    for (std::size_t i = 0; i < node_.size(); ++i) {
        u.in_surface.x[i] = start[node_[i]];
        u.in_surface.y[i] = start[n + node_[i]];
        u.down[i] = -start[2 * n + node_[i]];
    }
    return u;
}

SurfaceField BlockCompliance::displacement(const SurfaceField& t) const {
    return solve(t, state_);
}

double BlockCompliance::missing_reaction() const {
    const std::size_t n = solver_.mixed().n_nodes();
    const auto held = solver_.mixed().held_forces(state_);
    double missing = 0, applied = 0;
    for (int d = 0; d < 3; ++d) {
        double force = 0;
        for (std::size_t i = 0; i < n; ++i) force += forces_[d * n + i];
        if (d == 1 && points().mirrored) continue;  // both halves cancel
        missing = std::hypot(missing, force + held[d]);
        applied = std::hypot(applied, force);
    }
    return missing / applied;
}

void BlockCompliance::normal(std::span<const double> p, std::span<double> u_z) const {
    const std::size_t n = points().size();
    const auto u = solve({TangentialField(n), {p.begin(), p.end()}}, of_product_);
    std::ranges::copy(u.down, u_z.begin());
}
void BlockCompliance::tangential(const TangentialField& t, TangentialField& u) const {
    u = solve({t, std::vector<double>(points().size())}, of_product_).in_surface;
}
void BlockCompliance::tangential_from_normal(std::span<const double> p, TangentialField& u) const {
    const std::size_t n = points().size();
    u = solve({TangentialField(n), {p.begin(), p.end()}}, of_product_).in_surface;
}
void BlockCompliance::normal_from_tangential(const TangentialField& t,
                                             std::span<double> u_z) const {
    const auto u = solve({t, std::vector<double>(points().size())}, of_product_);
    std::ranges::copy(u.down, u_z.begin());
}

double BlockCompliance::local_tangential() const {
    throw std::logic_error("BlockCompliance: contact is solved with LatticeCompliance");
}
void BlockCompliance::precondition_tangential(const TangentialField&, TangentialField&) const {
    throw std::logic_error("BlockCompliance: contact is solved with LatticeCompliance");
}

std::unique_ptr<const contact::Interior> BlockCompliance::interior(std::span<const double> p,
                                                                   const TangentialField& t) const {
    const SurfaceField traction{t, {p.begin(), p.end()}};
    solve(traction, state_);
    const Discretisation discretisation(*problem_);
    const std::vector<std::size_t> places = places_in_block(discretisation, grid());
    std::vector<double> force;
    for (const std::size_t at : places) force.push_back(forces_[at]);
    return std::make_unique<contact::Interior>(discretisation.interior(
        state_in_block(solver_.mixed(), state_, places, elements_in_block(discretisation, grid())),
        force));
}

}  // namespace tricontact::fem
