#include "meshes/layered_body_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshes/disc_surface.h"
#include "meshes/layer_grid.h"
#include "meshes/round_body_parts.h"

// A surface of quadrilaterals, and the same below it in layers: of a punch along z, of a ball along
// the radius down to its hub. The surface of a ball is the disc about its pole, rows around it, and
// a disc about the other pole, which has the same lines:
//
//        ____ pole ____      disc: patch and rings
//       |     rows     |
//        ___ other ____      disc, even

namespace tricontact::meshes {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double other_disc = pi / 3;  // from the other pole to its circle
constexpr double highest_row = pi / 10;
constexpr double widest_rolled = .42;  // of half a square patch over R: discs fold from .46 on

// From the base to the surface, over the way between them.
std::vector<double> depths(double length, double size, double growth) {
    const Grading inwards = grade(length, size, depth_growth(growth));
    std::vector<double> share;
    for (const double distance : inwards.nodes())
        share.insert(share.begin(), 1 - distance / length);
    share.front() = 0;
    return share;
}

/// The sphere about (0, 0, -R) as quadrilaterals.
struct Sphere {
    std::vector<Point> nodes;
    std::vector<std::array<int, 4>> quads;
    std::vector<bool> in_patch;
};

Point on_sphere(double radius, const std::array<double, 2>& direction, double angle) {
    return {radius * std::sin(angle) * direction[0], radius * std::sin(angle) * direction[1],
            -2 * radius * std::pow(std::sin(angle / 2), 2)};
}

// Below the equator: the rows and the disc about the other pole, whose node is as far from it as
// that of the first disc is from its pole.
void close_sphere(const DiscSurface& disc, double radius, double rim, bool half, Sphere& sphere) {
    const auto& circle = disc.circle();
    const int n_circle = static_cast<int>(circle.size()), n_disc = disc.n_nodes();
    const auto direction = [&](int node) -> std::array<double, 2> {
        const auto& [x, y] = disc.node(node);
        const double r = std::hypot(x, y);
        return r == 0 ? std::array{0., 0.} : std::array{x / r, y / r};
    };
    const double way = pi - other_disc - rim;
    const int n_rows = std::max(2, static_cast<int>(std::ceil(way / highest_row)));
    for (int k = 1; k < n_rows; ++k)
        for (const int node : circle)
            sphere.nodes.push_back(on_sphere(radius, direction(node), rim + way * k / n_rows));
    const int first_of_disc = static_cast<int>(sphere.nodes.size());
    // Angle over that at the circle: between that of the first disc and even lines.
    const double circle_distance = std::hypot(disc.node(circle[0])[0], disc.node(circle[0])[1]);
    for (int node = 0; node < n_disc; ++node) {
        const auto& [x, y] = disc.node(node);
        const double share = std::asin(std::min(1., std::hypot(x, y) / circle_distance)) / (pi / 2);
        sphere.nodes.push_back(
            on_sphere(radius, direction(node), pi - other_disc * std::pow(share, .75)));
    }
    const auto at = [&](int row, int c) {
        const int of_circle = circle[c % n_circle];
        if (row == 0) return of_circle;
        if (row == n_rows) return first_of_disc + of_circle;
        return n_disc + (row - 1) * n_circle + c % n_circle;
    };
    for (int row = 0; row < n_rows; ++row)
        for (int c = 0; c < (half ? n_circle - 1 : n_circle); ++c)
            sphere.quads.push_back(
                {at(row + 1, c), at(row + 1, c + 1), at(row, c + 1), at(row, c)});
    for (const auto& quad : disc.quads()) {
        auto seen_from_below = quad;
        std::ranges::reverse(seen_from_below);
        for (int& node : seen_from_below) node += first_of_disc;
        sphere.quads.push_back(seen_from_below);
    }
    sphere.in_patch.resize(sphere.quads.size(), false);
}

void check_hub(double hub_radius, double radius) {
    if (!(hub_radius > 0) || !(hub_radius < radius))
        fail(round_body, fmt::format("a hub of the radius {:g} m", hub_radius),
             "make it thinner than the ball");
}

/// Nodes of the disc about the pole on the sphere: straight below their places in the plane, or, of
/// a patch that `rolls`, as far along as there; between this patch and the rim from the one to the
/// other.
class OnBall {
  public:
    OnBall(const HubBallMeshSpec& s, double rim) : s_(s), rim_(rim) {}

    Point operator()(double x, double y) const {
        const double R = s_.radius, r = std::hypot(x, y);
        const Point below{x, y, -r * r / (R + std::sqrt(R * R - r * r))};
        if (!s_.rolls) return below;
        const double share = beyond_patch(x, y, r), from_axis = std::sqrt(R * R - y * y);
        const Point along{from_axis * std::sin(x / R), y, from_axis * std::cos(x / R) - R};
        if (share == 0) return along;
        Point between;
        for (int d = 0; d < 3; ++d) between[d] = along[d] + share * (below[d] - along[d]);
        const double from_middle = std::hypot(between[0], between[1], between[2] + R);
        return {R / from_middle * between[0], R / from_middle * between[1],
                R / from_middle * (between[2] + R) - R};
    }

  private:
    /// Share of the way from the patch to the rim, 0 in the patch.
    double beyond_patch(double x, double y, double r) const {
        const double stretch = std::max(std::abs(x) / s_.patch_x, std::abs(y) / s_.patch_y);
        if (stretch <= 1 + 1e-12) return 0;
        const double edge = std::asin(r / stretch / s_.radius);
        return std::min(1., (std::asin(r / s_.radius) - edge) / (rim_ - edge));
    }

    HubBallMeshSpec s_;
    double rim_;
};

}  // namespace

HexMesh make_hub_ball_mesh(const HubBallMeshSpec& spec) {
    HubBallMeshSpec s = spec;
    // Rings around a patch that is longer than wide would fold: it is part of a square one.
    if (s.rolls) s.patch_x = s.patch_y = std::max(s.patch_x, s.patch_y);
    check_lengths({s.radius, s.size, s.patch_x, s.patch_y}, s.growth);
    check_hub(s.hub_radius, s.radius);
    if (s.rolls && s.patch_x > widest_rolled * s.radius)
        fail(round_body,
             fmt::format(
                 "the contact with its way reaches {:.4g} m to a side, too far for a ball of "
                 "the radius {:.4g} m: more than 24 degrees",
                 s.patch_x, s.radius),
             "reduce the rolling amplitude or the load, or enlarge the radius");
    const double corner = std::hypot(s.patch_x, s.patch_y), R = s.radius;
    check_width(corner, R);
    const double rim = rim_of_ball(std::asin(corner / R));
    const DiscSurface disc({.size = s.size,
                            .patch_x = s.patch_x,
                            .patch_y = s.patch_y,
                            .rim = R * rim,
                            .growth = s.growth,
                            .half_model = s.half_model,
                            .way = [R](double r) { return R * std::asin(r / R); },
                            .distance = [R](double way) { return R * std::sin(way / R); }});
    const std::vector<double> depth = depths(R - s.hub_radius, s.size, s.growth);
    const int n_layers = static_cast<int>(depth.size()) - 1;
    check_count(2. * static_cast<double>(disc.quads().size()) * n_layers, s.size);
    Sphere sphere;
    const OnBall on_ball(s, rim);
    for (int node = 0; node < disc.n_nodes(); ++node)
        sphere.nodes.push_back(on_ball(disc.node(node)[0], disc.node(node)[1]));
    sphere.quads = disc.quads();
    for (std::size_t q = 0; q < disc.quads().size(); ++q) {
        const bool within = std::ranges::all_of(disc.quads()[q], [&](int node) {
            const auto& [x, y] = disc.node(node);
            const double rounding = 1e-6 * s.size;
            return std::abs(x) <= spec.patch_x + rounding && std::abs(y) <= spec.patch_y + rounding;
        });
        sphere.in_patch.push_back(disc.in_patch(q) && within);
    }
    close_sphere(disc, R, rim, s.half_model, sphere);
    const double hub = s.hub_radius / R;
    return in_layers(sphere.quads, sphere.in_patch, static_cast<int>(sphere.nodes.size()), n_layers,
                     [&](int node, int m) -> Point {
                         const Point& p = sphere.nodes[node];
                         if (m == n_layers) return p;
                         const double f = hub + depth[m] * (1 - hub);
                         return {f * p[0], f * p[1], f * (p[2] + R) - R};
                     });
}

HexMesh make_punch_mesh(const PunchMeshSpec& s) {
    check_lengths({s.radius, s.height, s.size, s.patch_x, s.patch_y}, s.growth);
    constexpr double widest = .85;  // of the patch's corner, over the radius
    const double corner = std::hypot(s.patch_x, s.patch_y);
    if (!(corner <= widest * s.radius))
        fail(round_body,
             fmt::format(
                 "the contact patch reaches {:.4g} m from the middle, too far for a punch of "
                 "the radius {:.4g} m, its edge included",
                 corner, s.radius),
             "reduce the load or enlarge indenter.flat_radius or indenter.radius");
    if (!(s.profile(s.radius) < .9 * s.height))
        fail(round_body,
             fmt::format("the edge of the punch is {:.4g} m high, its height {:.4g} m",
                         s.profile(s.radius), s.height),
             "enlarge indenter.height");
    const auto same = [](double r) { return r; };
    const DiscSurface disc({.size = s.size,
                            .patch_x = s.patch_x,
                            .patch_y = s.patch_y,
                            .rim = s.radius,
                            .growth = s.growth,
                            .half_model = s.half_model,
                            .way = same,
                            .distance = same});
    const std::vector<double> depth = depths(s.height, s.size, s.growth);
    const int n_layers = static_cast<int>(depth.size()) - 1;
    check_count(static_cast<double>(disc.quads().size()) * n_layers, s.size);
    std::vector<bool> in_patch;
    for (std::size_t q = 0; q < disc.quads().size(); ++q) in_patch.push_back(disc.in_patch(q));
    return in_layers(disc.quads(), in_patch, disc.n_nodes(), n_layers,
                     [&](int node, int m) -> Point {
                         const auto& [x, y] = disc.node(node);
                         const double below = s.profile(std::hypot(x, y));
                         return {x, y, -s.height + depth[m] * (s.height - below)};
                     });
}

}  // namespace tricontact::meshes
