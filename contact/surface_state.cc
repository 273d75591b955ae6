// What a surface model says about its state: scales, surface, bytes.

#include <algorithm>
#include <cmath>

#include "contact/solvers/contact_region.h"
#include "contact/state_bytes.h"
#include "contact/surface.h"
#include "contact/surface_model.h"

namespace tricontact::contact {

namespace {

/// Index in the half of each point of the whole, and the sign of its y.
struct Image {
    std::vector<int> source;
    std::vector<int> sign;
    std::vector<int> image_of;  // point of the whole that mirrors a point of the half
};

/// Rows from -y to y on a regular grid; else the half's points, then the images of those off y = 0.
Image image_of(const Surface& half) {
    Image image;
    const int n = static_cast<int>(half.size());
    image.image_of.resize(n);
    auto add = [&](int source, int sign) {
        if (sign < 0 || half.node_y[source] == 0)
            image.image_of[source] = static_cast<int>(image.source.size());
        image.source.push_back(source);
        image.sign.push_back(sign);
    };
    if (half.n_x > 0) {
        for (int row = half.n_y - 1; row > 0; --row)
            for (int i = 0; i < half.n_x; ++i) add(row * half.n_x + i, -1);
        for (int k = 0; k < n; ++k) add(k, 1);
    } else {
        for (int k = 0; k < n; ++k) add(k, 1);
        for (int k = 0; k < n; ++k)
            if (half.node_y[k] != 0) add(k, -1);
    }
    return image;
}

/// The whole surface from its half with y >= 0: x and normal components even in y, y components
/// odd. Points at y = 0 are not doubled. Nodes layout only.
Surface mirrored(const Surface& half) {
    const Image image = image_of(half);
    const std::size_t n = image.source.size();
    Surface whole = half;
    auto reflect = [&](std::vector<double>& values, bool odd) {
        if (values.empty()) return;
        const std::vector<double> old = values;
        values.resize(n);
        for (std::size_t i = 0; i < n; ++i)
            values[i] = odd && image.sign[i] < 0 ? -old[image.source[i]] : old[image.source[i]];
    };
    for (auto* even :
         {&whole.node_x, &whole.normal_traction, &whole.tangential_traction_x,
          &whole.friction_bound, &whole.displacement_x, &whole.displacement_z, &whole.gap,
          &whole.slip_x, &whole.dissipation, &whole.slip_path, &whole.friction_work,
          &whole.normal_traction_consistent, &whole.tangential_traction_x_consistent})
        reflect(*even, false);
    for (auto* odd : {&whole.node_y, &whole.tangential_traction_y, &whole.displacement_y,
                      &whole.slip_y, &whole.tangential_traction_y_consistent})
        reflect(*odd, true);
    whole.contact_state.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        whole.contact_state[i] = half.contact_state[image.source[i]];

    std::vector<int> original(half.size());
    for (std::size_t i = 0; i < n; ++i)
        if (image.sign[i] > 0) original[image.source[i]] = static_cast<int>(i);
    whole.quads.clear();
    for (const auto& quad : half.quads) {
        std::array<int, 9> kept{}, turned{};
        for (int k = 0; k < 9; ++k) kept[k] = original[quad[k]];
        // Corners backwards keep the orientation; edges 4-7 follow their corners.
        constexpr std::array<int, 9> backwards = {0, 3, 2, 1, 7, 6, 5, 4, 8};
        for (int k = 0; k < 9; ++k) turned[k] = image.image_of[quad[backwards[k]]];
        whole.quads.push_back(kept);
        whole.quads.push_back(turned);
    }
    if (half.n_x > 0) {
        whole.n_y = 2 * half.n_y - 1;
        whole.first[1] = -(half.n_y - 1) * half.spacing[1];
    }
    return whole;
}

}  // namespace

Scales SurfaceModel::scales() const {
    const ContactPoints& points = this->points();
    TangentialField sliding(now().bound.size()), displacement(now().bound.size());
    for (std::size_t i = 0; i < now().bound.size(); ++i)
        sliding.x[i] = friction_coefficient_ * now().normal->pressure[i];
    substrate_->relaxed().tangential(sliding, displacement);
    std::size_t centre = 0;
    auto distance = [&](std::size_t i) {
        return std::hypot(points.x[i] - now().offset[0], points.y[i] - now().offset[1]);
    };
    for (std::size_t i = 1; i < now().bound.size(); ++i)
        if (distance(i) < distance(centre)) centre = i;
    return {.normal_force = now().normal->force,
            .contact_radius = indenter_->presses_like_a_ball()
                                  ? contact_radius(points, now().normal->pressure, now().offset)
                                  : counted_radius(points, now().normal->pressure),
            .indentation = now().normal->indentation,
            .peak_pressure =
                *std::max_element(now().normal->pressure.begin(), now().normal->pressure.end()),
            .unit_shift = displacement.x[centre]};
}

Surface SurfaceModel::surface() const {
    const ContactPoints& points = this->points();
    Surface s;
    s.layout = points.quads.empty() ? Surface::Layout::grid : Surface::Layout::nodes;
    s.n_x = points.n_x;
    s.n_y = points.n_y;
    s.first = points.first;
    s.spacing = points.spacing;
    s.offset = now().offset;
    s.normal_traction = now().normal->pressure;
    s.tangential_traction_x = now().tangential.traction.x;
    s.tangential_traction_y = now().tangential.traction.y;
    s.friction_bound = now().bound;
    s.displacement_x = now().displacement.in_surface.x;
    s.displacement_y = now().displacement.in_surface.y;
    s.displacement_z = now().displacement.down;
    s.gap.resize(now().bound.size());
    for (auto* field : {&s.slip_x, &s.slip_y, &s.dissipation}) field->resize(now().bound.size());
    for (std::size_t i = 0; i < now().bound.size(); ++i) {
        s.gap[i] = solver_->coupling().bare_height()[i] + now().displacement.down[i] -
                   now().normal->indentation;
        const Vector2 told = slip(i);
        s.slip_x[i] = told[0];
        s.slip_y[i] = told[1];
        s.dissipation[i] = friction_work(i);
    }
    s.slip_path = slip_path_;
    s.friction_work = friction_work_;
    s.contact_state = contact_state_;
    if (s.layout != Surface::Layout::nodes) return s;

    s.node_x = points.x;
    s.node_y = points.y;
    s.quads = points.quads;
    s.normal_traction_consistent =
        substrate_->compliance().consistent_traction(s.normal_traction, false);
    s.tangential_traction_x_consistent =
        substrate_->compliance().consistent_traction(s.tangential_traction_x, false);
    s.tangential_traction_y_consistent =
        substrate_->compliance().consistent_traction(s.tangential_traction_y, true);
    return points.mirrored ? mirrored(s) : s;
}

namespace {

/// Writes or reads all that is kept of a solution.
template <class Archive, class Solution, class Normal>
void transfer_solution(Archive& archive, Solution& s, Normal& normal) {
    archive(s.offset, s.shift, s.tangential.shift_increment, normal.pressure, normal.displacement,
            s.bound);
    for (auto* field :
         {&s.tangential.traction, &s.tangential.displacement, &s.displacement.in_surface})
        archive(field->x, field->y);
    archive(s.displacement.down, normal.indentation, normal.length, normal.force, normal.residual,
            s.tangential.residual, s.tangential.force_residual, s.gap_residual, s.shift_factor);
}

}  // namespace

/// The same of all else.
template <class Archive, class Self>
void SurfaceModel::transfer_rest(Archive& archive, Self& m) {
    archive(m.slip_.x, m.slip_.y, m.least_pressure_, m.slip_path_, m.friction_work_, m.phase_,
            m.least_pressure_force_, m.energy_, m.contact_state_);
    m.substrate_->transfer(archive);
}

std::string SurfaceModel::write_state() const {
    StateWriter out;
    transfer_solution(out, now(), *now().normal);
    transfer_rest(out, *this);
    out(audit_.checks().size());
    for (const auto& [name, worst, allowed] : audit_.checks()) out(name, worst, allowed);
    return out.take();
}

void SurfaceModel::read_state(std::string_view bytes) {
    StateReader in(bytes);
    ContactSolution solution;
    NormalSolution normal;
    transfer_solution(in, solution, normal);
    transfer_rest(in, *this);
    std::size_t n_checks = 0;
    in(n_checks);
    audit_ = {};
    for (std::size_t k = 0; k < n_checks; ++k) {
        Audit::Check check;
        in(check.name, check.worst, check.allowed);
        audit_.record(check.name, check.worst, check.allowed);
    }
    solution.normal = std::make_shared<const NormalSolution>(std::move(normal));
    solver_->resume(std::move(solution), phase_);
}

}  // namespace tricontact::contact
