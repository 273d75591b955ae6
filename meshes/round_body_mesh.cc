#include "meshes/round_body_mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "contact/base/special_values.h"
#include "meshes/layer_grid.h"
#include "meshes/round_body_parts.h"

// Blocks of a quarter of the meridian section; the ball has them around its axis:
//
//      pole _______
//          |  patch\__
//          |   top    \      m  layers of `top` and `side` between core and sphere: first `size`,
//          |           \        growing inwards
//          |____________\    k  rows of `core` and `side` between rim and base
//          |  core  |    |   i, j  lateral lines of `top` and `core`: regular in the patch, graded
//          |________|side|      from there to the rim, where they are a square in number and a
//                base           circle in shape
//
// Half a cylinder has the same section, and lines j along its axis instead.
//
// A node has the number (i, j, k, m): m = 0 on the core, k = 0 on the core's upper face and above
// it; with k, m > 0 it lies beside the core, (i, j) on the edge of its square. Nothing is merged by
// position, so that images are images to the last bit.

namespace tricontact::meshes {

namespace {

constexpr double core_half_side = .5, core_height = .32;  // over R
constexpr double evenness = .35;  // of the core's lateral lines: 0 as on the sphere, 1 even
constexpr int n_rows = 3;         // of the core

class HalfRound {
  public:
    explicit HalfRound(const HalfBallMeshSpec& s)
        : s_(s), n_patch_{elements_in(s.patch_x, s.size), elements_in(s.patch_y, s.size)} {
        grade_all();
        n_[1] = n_patch_[1] + n_[0] - n_patch_[0];
    }
    explicit HalfRound(const CylinderMeshSpec& s)
        : s_{s.radius, s.size, s.patch_x, s.size, s.growth, true},
          is_cylinder_(true),
          half_y_(s.half_y),
          n_patch_{elements_in(s.patch_x, s.size), 1} {
        grade_all();
        n_[1] = 1;
    }

    double n_elements() const {
        const double n_y = (s_.half_model ? 1. : 2.) * n_[1];
        return 2. * n_[0] * n_y * (n_layers_ + n_rows) + 2. * (n_[0] + n_y) * n_rows * n_layers_;
    }

    HexMesh mesh() {
        add_nodes();
        const int low = first_j();
        for (int j = low; j < n_[1]; ++j)
            for (int i = -n_[0]; i < n_[0]; ++i) {
                for (int k = n_rows - 1; k >= 0; --k) add_core(i, j, k);
                for (int m = 0; m < n_layers_; ++m) add_top(i, j, m);
            }
        for (int k = n_rows - 1; k >= 0; --k)
            for (int m = 0; m < n_layers_; ++m) {
                for (int j = low; j < n_[1]; ++j) {
                    add_side({n_[0], j}, {n_[0], j + 1}, k, m);
                    add_side({-n_[0], j + 1}, {-n_[0], j}, k, m);
                }
                for (int i = -n_[0]; i < n_[0] && !is_cylinder_; ++i) {
                    add_side({i + 1, n_[1]}, {i, n_[1]}, k, m);
                    if (!s_.half_model) add_side({i, -n_[1]}, {i + 1, -n_[1]}, k, m);
                }
            }
        mesh_.regions.assign(mesh_.hexes.size(), Region::layer);
        return std::move(mesh_);
    }

  private:
    using Lateral = std::array<int, 2>;  // i, j

    void grade_all() {
        // From the middle of a side of the patch to the rim, along the sphere.
        const double patch = is_cylinder_ ? s_.patch_x : std::max(s_.patch_x, s_.patch_y);
        const double angle = std::asin(patch / s_.radius);
        const double corner =
            is_cylinder_ ? angle : std::asin(std::hypot(s_.patch_x, s_.patch_y) / s_.radius);
        rim_angle_ = rim_of_ball(corner);
        side_angle_ = angle;
        const double length = s_.radius * (rim_angle_ - angle);
        const Grading around = grade(length, s_.size / std::cos(angle), s_.growth);
        for (const double distance : around.nodes()) rim_fraction_.push_back(distance / length);
        const double depth = (1 - core_height) * s_.radius;
        const Grading inwards = grade(depth, s_.size, depth_growth(s_.growth));
        for (const double distance : inwards.nodes())
            layer_fraction_.insert(layer_fraction_.begin(), 1 - distance / depth);
        n_[0] = n_patch_[0] + around.n;
        n_layers_ = inwards.n;
    }

    int first_j() const { return s_.half_model ? 0 : -n_[1]; }
    bool is_rim(int i, int j) const {
        if (std::abs(i) == n_[0]) return true;
        return !is_cylinder_ && (j == n_[1] || (j == -n_[1] && !s_.half_model));
    }

    // Lateral coordinate of a line along x (d = 0) or y [m]; R times its angle at the rim.
    double lateral(int d, int index) const {
        const int n = n_patch_[d], a = std::abs(index);
        const double patch = n * s_.size;
        const double beyond = a <= n ? 0 : rim_fraction_[a - n];
        const double inside = std::min(a, n) * s_.size;
        const double value = inside + beyond * (s_.radius * rim_angle_ - patch);
        return index < 0 ? -value : value;
    }

    // In the patch straight below its node in the plane z = 0; from the patch's edge to the rim
    // along meridians.
    Point on_sphere(int i, int j) const {
        const int strip = std::max({std::abs(i) - n_patch_[0], std::abs(j) - n_patch_[1], 0});
        const double x = lateral(0, i), y = lateral(1, j), R = s_.radius;
        const double r = std::hypot(x, y);
        if (strip == 0) return {x, y, -r * r / (R + std::sqrt(R * R - r * r))};
        const double edge = r * std::min(x == 0 ? contact::infinity : s_.patch_x / std::abs(x),
                                         y == 0 ? contact::infinity : s_.patch_y / std::abs(y));
        const double way =
            way_beyond_patch(rim_fraction_[strip], std::asin(edge / R), rim_angle_,
                             rim_angle_ - side_angle_, r / std::max(std::abs(x), std::abs(y)));
        return beside_axis(x, y, way);
    }

    // On the sphere, `angle` from the pole in the direction (x, y).
    Point beside_axis(double x, double y, double angle) const {
        const double r = std::hypot(x, y), R = s_.radius;
        return {R * std::sin(angle) * (x / r), R * std::sin(angle) * (y / r),
                -2 * R * std::pow(std::sin(angle / 2), 2)};
    }

    Point in_core(int i, int j, int k) const {
        const auto place = [&](int d, int index) {
            const double as_above = lateral(d, index) / (s_.radius * rim_angle_);
            const double even = static_cast<double>(index) / n_[d];
            return core_half_side * s_.radius * ((1 - evenness) * as_above + evenness * even);
        };
        const double height = core_height * (n_rows - k) / n_rows;
        return {place(0, i), place(1, j), (height - 1) * s_.radius};
    }

    Point position(int i, int j, int k, int m) const {
        if (!is_cylinder_) return in_section(i, j, k, m);
        Point p = in_section(i, 0, k, m);
        p[1] = half_y_ * j / n_[1];
        return p;
    }

    Point in_section(int i, int j, int k, int m) const {
        const Point core = in_core(i, j, k);
        if (m == 0) return core;
        Point surface = on_sphere(i, j);
        if (k > 0) {
            const double share = static_cast<double>(k) / n_rows;
            surface = beside_axis(surface[0], surface[1],
                                  (1 - share) * rim_angle_ + share * std::numbers::pi / 2);
            if (k == n_rows) surface[2] = -s_.radius;
        }
        if (m == n_layers_) return surface;
        const double f = layer_fraction_[m];
        Point p;
        for (int d = 0; d < 3; ++d) p[d] = core[d] + f * (surface[d] - core[d]);
        return p;
    }

    std::size_t index_of(int i, int j, int k, int m) const {
        const std::size_t width = 2 * n_[0] + 1, at = (j - first_j()) * width + (i + n_[0]);
        return (at * (n_rows + 1) + k) * (n_layers_ + 1) + m;
    }
    int node(int i, int j, int k, int m) const { return number_[index_of(i, j, k, m)]; }

    void add_nodes() {
        number_.assign(index_of(n_[0], n_[1], n_rows, n_layers_) + 1, -1);
        for (int j = first_j(); j <= n_[1]; ++j)
            for (int i = -n_[0]; i <= n_[0]; ++i)
                for (int k = 0; k <= n_rows; ++k)
                    for (int m = 0; m <= n_layers_; ++m) {
                        if (k > 0 && m > 0 && !is_rim(i, j)) continue;
                        number_[index_of(i, j, k, m)] = static_cast<int>(mesh_.nodes.size());
                        mesh_.nodes.push_back(position(i, j, k, m));
                    }
    }

    void add_face(std::array<int, 4> nodes, Boundary boundary) {
        mesh_.faces.push_back({nodes, boundary});
    }

    void add_core(int i, int j, int k) {
        const auto at = [&](int di, int dj, int dk) { return node(i + di, j + dj, k + dk, 0); };
        mesh_.hexes.push_back({at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1), at(0, 0, 0),
                               at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)});
        if (k == n_rows - 1)
            add_face({at(0, 0, 1), at(0, 1, 1), at(1, 1, 1), at(1, 0, 1)}, Boundary::base);
        if (s_.half_model && j == 0)
            add_face({at(0, 0, 1), at(1, 0, 1), at(1, 0, 0), at(0, 0, 0)}, Boundary::symmetry);
        if (is_cylinder_ && j == n_[1] - 1)
            add_face({at(0, 1, 1), at(0, 1, 0), at(1, 1, 0), at(1, 1, 1)}, Boundary::symmetry);
    }

    void add_top(int i, int j, int m) {
        const auto at = [&](int di, int dj, int dm) { return node(i + di, j + dj, 0, m + dm); };
        mesh_.hexes.push_back({at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1),
                               at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
        if (m == n_layers_ - 1) {
            const auto within = [](int index, int n) { return -n <= index && index < n; };
            const bool in_patch =
                within(i, n_patch_[0]) && (is_cylinder_ || within(j, n_patch_[1]));
            add_face({at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)},
                     in_patch ? Boundary::contact : Boundary::sides);
        }
        if (s_.half_model && j == 0)
            add_face({at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)}, Boundary::symmetry);
        if (is_cylinder_ && j == n_[1] - 1)
            add_face({at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)}, Boundary::symmetry);
    }

    // Beside the core, between two points of its edge that follow each other to the left.
    void add_side(const Lateral& a, const Lateral& b, int k, int m) {
        const auto at = [&](const Lateral& l, int dk, int dm) {
            return node(l[0], l[1], k + dk, m + dm);
        };
        mesh_.hexes.push_back({at(a, 1, 0), at(a, 1, 1), at(b, 1, 1), at(b, 1, 0), at(a, 0, 0),
                               at(a, 0, 1), at(b, 0, 1), at(b, 0, 0)});
        if (k == n_rows - 1)
            add_face({at(a, 1, 0), at(b, 1, 0), at(b, 1, 1), at(a, 1, 1)}, Boundary::base);
        if (m == n_layers_ - 1)
            add_face({at(a, 1, 1), at(b, 1, 1), at(b, 0, 1), at(a, 0, 1)}, Boundary::sides);
        const auto on_symmetry = [&](const Lateral& l) {
            return (s_.half_model && l[1] == 0) || (is_cylinder_ && l[1] == n_[1]);
        };
        if (on_symmetry(a) && std::abs(a[0]) == n_[0])
            add_face({at(a, 1, 0), at(a, 1, 1), at(a, 0, 1), at(a, 0, 0)}, Boundary::symmetry);
        if (on_symmetry(b) && std::abs(b[0]) == n_[0])
            add_face({at(b, 1, 1), at(b, 1, 0), at(b, 0, 0), at(b, 0, 1)}, Boundary::symmetry);
    }

    HalfBallMeshSpec s_;
    bool is_cylinder_ = false;
    double half_y_ = 0;
    std::array<int, 2> n_patch_;  // elements of half the patch
    std::array<int, 2> n_{};      // elements from the middle to the rim
    int n_layers_ = 0;
    double rim_angle_ = 0, side_angle_ = 0;  // from the pole; the latter of the patch's sides
    std::vector<double> rim_fraction_;       // of the way from the patch's edge to the rim
    std::vector<double> layer_fraction_;     // of the way from the core to the sphere
    std::vector<int> number_;
    HexMesh mesh_;
};

}  // namespace

HexMesh make_half_ball_mesh(const HalfBallMeshSpec& spec) {
    check_lengths({spec.radius, spec.size, spec.patch_x, spec.patch_y}, spec.growth);
    check_width(std::hypot(spec.patch_x, spec.patch_y), spec.radius);
    HalfRound ball(spec);
    check_count(ball.n_elements(), spec.size);
    return ball.mesh();
}

HexMesh make_cylinder_mesh(const CylinderMeshSpec& spec) {
    check_lengths({spec.radius, spec.size, spec.patch_x, spec.half_y}, spec.growth);
    const bool rolls = spec.rolls && spec.hub_radius > 0;
    (rolls ? check_turn : check_width)(spec.patch_x, spec.radius);
    if (!(spec.hub_radius >= 0) || !(spec.hub_radius < spec.radius))
        fail(round_body, fmt::format("a hub of the radius {:g} m", spec.hub_radius),
             "make it thinner than the cylinder");
    if (spec.hub_radius > 0) {
        return cylinder_on_hub(spec);
    }
    HalfRound cylinder(spec);
    check_count(cylinder.n_elements(), spec.size);
    return cylinder.mesh();
}

}  // namespace tricontact::meshes
