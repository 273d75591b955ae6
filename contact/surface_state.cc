// What a surface model says about its state: scales, surface, bytes.

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/base/state_bytes.h"
#include "contact/mirrored_surface.h"
#include "contact/solvers/contact_region.h"
#include "contact/surface.h"
#include "contact/surface_model.h"

namespace tricontact::contact {

namespace {

/// The largest tension changes by a third of a residual of displacements.
constexpr double pull_off_tolerance = 1e-5;

/// The first of the points at the least distance.
struct Nearest {
    std::size_t point = 0;
    double distance = infinity;
    Nearest& operator+=(const Nearest& other) {
        if (other.distance < distance) *this = other;
        return *this;
    }
};

/// Where the points of a surface are. Whether fields at them are of the half of it that has y >= 0:
/// a line of springs in the plane of symmetry is no grid and has no other side, nodes are mirrored
/// otherwise.
template <class AnySurface>
bool place(const ContactPoints& points, const Vector2& offset, AnySurface& s) {
    s.layout = points.quads.empty() ? Surface::Layout::grid : Surface::Layout::nodes;
    s.n_x = points.n_x;
    s.n_y = points.n_y;
    s.first = points.first;
    s.spacing = points.spacing;
    s.offset = offset;
    const bool is_half = points.mirrored && points.n_x > 0 && s.layout == Surface::Layout::grid;
    if (is_half) {
        s.first[1] = -(s.n_y - 1) * s.spacing[1];
        s.n_y = 2 * s.n_y - 1;
    }
    return is_half;
}

}  // namespace

Scales SurfaceModel::scales() const {
    const ContactPoints& points = this->points();
    const int n_threads = substrate_->compliance().n_threads();
    TangentialField sliding(now().bound.size(), n_threads);
    TangentialField displacement(now().bound.size(), n_threads);
    const Blocks all = blocks(now().bound.size());
    // A tension carries nothing along the surface.
    std::vector<double> pressed;
    if (attracted_) {
        pressed = now().normal->pressure;
        for (double& p : pressed) p = std::max(p, 0.);
    }
    const std::vector<double>& pressure = attracted_ ? pressed : now().normal->pressure;
    const double sliding_force =
        all.sum<double>([&](std::size_t, std::size_t begin, std::size_t end) {
            const std::size_t n = end - begin;
            const std::span<const double> share = now().normal->share;
            bounds_on_shares(
                *friction_,
                {std::span(pressure).subspan(begin, n), std::span(points.x).subspan(begin, n),
                 std::span(points.y).subspan(begin, n)},
                share.empty() ? share : share.subspan(begin, n),
                std::span(sliding.x).subspan(begin, n));
            double sum = 0;
            for (std::size_t i = begin; i < end; ++i) sum += points.area[i] * sliding.x[i];
            return sum;
        });
    substrate_->relaxed().tangential(sliding, displacement);
    const auto centre =
        all.sum_points<Nearest>([&](Nearest& nearest, std::size_t i) {
               nearest +=
                   {i, std::hypot(points.x[i] - now().offset[0], points.y[i] - now().offset[1])};
           })
            .point;
    return {.normal_force = now().normal->force,
            .contact_radius =
                now().normal->attracts() ? shared_radius(points, now().normal->share)
                : indenter_->presses_like_a_ball() && !points.on_springs && !points.is_whole_face
                    ? contact_radius(points, now().normal->pressure, now().offset)
                    : counted_radius(points, now().normal->pressure),
            .indentation = now().normal->indentation,
            .peak_pressure =
                *std::max_element(now().normal->pressure.begin(), now().normal->pressure.end()),
            .unit_shift = displacement.x[centre],
            .sliding_force = friction_->limit({now().normal->force, sliding_force})};
}

/// Pulls the contact off, from the hardest load on. Not of nominally flat bodies on a period, whose
/// many spots let go one after the other; not known, either, where the way there does not converge.
std::optional<PullOff> SurfaceModel::pull_off() const {
    if (!attracted_ || hardest_ == not_pressed || points().periodic) return {};
    try {
        return pulled_off();
    } catch (const InputError&) {  // it does not hold without a force that presses
    } catch (const NotConverged&) {
    }
    return {};
}

std::optional<PullOff> SurfaceModel::pulled_off() const {
    const auto solver = [&](double zone) {
        return AdhesiveNormal(name_, substrate_->compliance(),
                              attraction_on(points(), attracted_->law, attracted_->modulus, zone),
                              std::max(tolerance_, pull_off_tolerance));
    };
    const std::vector<double>& height = solver_->coupling().bare_height();
    if (attracted_->by_cell)
        return contact::pull_off(*solver_->adhesive(), points(), height, hardest_);
    if (!solver_->adhesive()->attraction().is_short_ranged)
        return contact::pull_off(solver(points_without_range), points(), height, hardest_);
    return pull_off_without_range(solver(narrow_zone), solver(wide_zone), points(), height,
                                  hardest_);
}

SurfaceModel::Told SurfaceModel::told() const {
    const NormalSolution& normal = *now().normal;
    const std::size_t n = now().bound.size();
    Told told;
    for (auto* field : {&told.gap, &told.slip_x, &told.slip_y, &told.dissipation})
        *field = large_field(n, substrate_->compliance().n_threads());
    const std::vector<double>& height = solver_->coupling().bare_height();
    const std::vector<double>& down = now().displacement.down;
    blocks(n).for_points([&](std::size_t i) {
        told.gap[i] = height[i] + down[i] - normal.indentation;
        const Vector2 slip = this->slip(i);
        told.slip_x[i] = slip[0];
        told.slip_y[i] = slip[1];
        told.dissipation[i] = friction_work(i);
    });
    if (normal.attracts()) told.separation_work = solver_->adhesive()->separation_work(told.gap);
    return told;
}

Surface SurfaceModel::surface() const {
    const ContactPoints& points = this->points();
    const ContactSolution& solution = now();
    const NormalSolution& normal = *solution.normal;
    const int n_threads = substrate_->compliance().n_threads();
    Surface s;
    const bool has_other_rows = place(points, solution.offset, s);
    const auto copy = [&](const std::vector<double>& field, bool is_odd = false) {
        return has_other_rows ? mirrored_rows(field, points.n_x, is_odd)
                              : large_copy(field, n_threads);
    };
    const auto take = [&](std::vector<double>& field, bool is_odd = false) {
        return has_other_rows ? mirrored_rows(field, points.n_x, is_odd) : std::move(field);
    };
    s.normal_traction = copy(normal.pressure);
    s.tangential_traction_x = copy(solution.tangential.traction.x);
    s.tangential_traction_y = copy(solution.tangential.traction.y, true);
    s.friction_bound = copy(solution.bound);
    s.displacement_x = copy(solution.displacement.in_surface.x);
    s.displacement_y = copy(solution.displacement.in_surface.y, true);
    s.displacement_z = copy(solution.displacement.down);
    if (normal.attracts()) s.tension = copy(normal.tension);
    Told told = this->told();
    s.gap = take(told.gap);
    s.slip_x = take(told.slip_x);
    s.slip_y = take(told.slip_y, true);
    s.dissipation = take(told.dissipation);
    s.separation_work = take(told.separation_work);
    if (has_other_rows) {
        s.slip_path = copy(slip_path_);
        s.friction_work = copy(friction_work_);
        s.contact_state = mirrored_rows(contact_state_, points.n_x);
        return s;
    }
    s.slip_path = slip_path_;
    s.friction_work = friction_work_;
    s.contact_state = contact_state_;
    if (s.layout == Surface::Layout::grid) return s;

    s.node_x = points.x;
    s.node_y = points.y;
    s.quads = points.quads;
    const Compliance& compliance = substrate_->compliance();
    s.normal_traction_consistent = compliance.consistent_traction(s.normal_traction, false);
    s.tangential_traction_x_consistent =
        compliance.consistent_traction(s.tangential_traction_x, false);
    s.tangential_traction_y_consistent =
        compliance.consistent_traction(s.tangential_traction_y, true);
    return points.mirrored ? mirrored(std::move(s)) : s;
}

bool SurfaceModel::show(const Look& look) const {
    if (!points().quads.empty()) return false;
    const ContactSolution& solution = now();
    const NormalSolution& normal = *solution.normal;
    const Told told = this->told();
    SurfaceView s;
    s.is_half = place(points(), solution.offset, s);
    s.normal_traction = normal.pressure;
    s.tangential_traction_x = solution.tangential.traction.x;
    s.tangential_traction_y = solution.tangential.traction.y;
    s.friction_bound = solution.bound;
    s.displacement_x = solution.displacement.in_surface.x;
    s.displacement_y = solution.displacement.in_surface.y;
    s.displacement_z = solution.displacement.down;
    if (normal.attracts()) s.tension = normal.tension;
    s.separation_work = told.separation_work;
    s.gap = told.gap;
    s.slip_x = told.slip_x;
    s.slip_y = told.slip_y;
    s.dissipation = told.dissipation;
    s.slip_path = slip_path_;
    s.friction_work = friction_work_;
    s.contact_state = contact_state_;
    look(s);
    return true;
}

std::vector<ContactState> SurfaceModel::contact_states() const {
    return points().mirrored ? mirrored(contact_state_, points()) : contact_state_;
}

namespace {

/// Writes or reads all that is kept of a solution.
template <class Archive, class Solution, class Normal>
void transfer_solution(Archive& archive, Solution& s, Normal& normal) {
    archive(s.offset, s.control.kind, s.control.value, s.shift, s.tangential.shift_increment,
            normal.pressure, normal.displacement, normal.share, normal.tension, normal.energy,
            normal.released, normal.pull, s.bound, s.way);
    for (auto* field :
         {&s.tangential.traction, &s.tangential.displacement, &s.displacement.in_surface})
        archive(field->x, field->y);
    archive(s.displacement.down, normal.indentation, normal.length, normal.force, normal.residual,
            normal.rounding, s.tangential.residual, s.tangential.force_residual, s.gap_residual,
            s.shift_factor);
}

}  // namespace

/// The same of all else.
template <class Archive, class Self>
void SurfaceModel::transfer_rest(Archive& archive, Self& m) {
    archive(m.slip_.x, m.slip_.y, m.least_pressure_, m.least_share_, m.slip_path_, m.friction_work_,
            m.phase_, m.rotation_, m.bulk_.stress, m.bulk_.strain, m.limit_start_, m.energy_,
            m.contact_state_, m.work_, m.hardest_.kind, m.hardest_.value);
    m.substrate_->transfer(archive);
}

std::string SurfaceModel::write_state() const {
    StateWriter out;
    transfer_solution(out, now(), *now().normal);
    transfer_rest(out, *this);
    audit_.write(out);
    return out.take();
}

void SurfaceModel::read_state(std::string_view bytes) {
    StateReader in(bytes);
    ContactSolution solution;
    NormalSolution normal;
    transfer_solution(in, solution, normal);
    transfer_rest(in, *this);
    audit_.read(in);
    solution.normal = std::make_shared<const NormalSolution>(std::move(normal));
    solver_->resume(std::move(solution), phase_);
}

}  // namespace tricontact::contact
