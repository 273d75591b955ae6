#include "meshes/round_body_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "contact/base/special_values.h"
#include "meshes/layer_grid.h"

namespace tricontact::meshes {

namespace {

constexpr double widest_patch = .76;  // of its corner from the axis, over R: 49 degrees
constexpr double widest_turn = 2.7;   // of a patch that rolls: 155 degrees
constexpr double widest_element = std::numbers::pi / 10;  // around a hub: chords of arcs
constexpr double most = 1e7;                              // elements

// Distances of nodes over `length` whose edges grow from about `first` to `longest`.
std::vector<double> bounded(double length, double first, double growth, double longest) {
    std::vector<double> nodes{0};
    for (double edge = first; nodes.back() < length; edge = std::min(edge * growth, longest))
        nodes.push_back(nodes.back() + edge);
    const double scale = length / nodes.back();
    for (double& node : nodes) node *= scale;
    return nodes;
}

// All of a cylinder around its hub: lines m around the axis, from the hub to the surface, and
// rays.
class CylinderOnHub {
  public:
    explicit CylinderOnHub(const CylinderMeshSpec& s)
        : s_(s), n_patch_(elements_in(s.patch_x, s.size)) {
        const double angle = s.rolls ? s.patch_x / s.radius : std::asin(s.patch_x / s.radius);
        const double length = s.radius * (std::numbers::pi - angle);
        for (int i = 0; i <= n_patch_; ++i) {
            const double x = static_cast<double>(i) * s.size / s.radius;
            if (s.rolls)
                ray_.push_back({std::sin(x), std::cos(x)});
            else
                ray_.push_back({x, std::sqrt(1 - x * x)});
        }
        const double next = s.rolls ? s.size : s.size / std::cos(angle);
        const std::vector<double> around =
            bounded(length, next, s.growth, widest_element * s.radius);
        for (std::size_t i = 1; i < around.size(); ++i) {
            const double at = angle + around[i] / s.radius;
            const bool is_last = i + 1 == around.size();  // opposite of the contact
            ray_.push_back({is_last ? 0 : std::sin(at), is_last ? -1 : std::cos(at)});
        }
        const Grading inwards = grade(s.radius - s.hub_radius, s.size, depth_growth(s.growth));
        for (const double distance : inwards.nodes())
            radius_.insert(radius_.begin(), s.radius - distance);
        radius_.front() = s.hub_radius;
    }

    double n_elements() const { return 2. * (ray_.size() - 1) * (radius_.size() - 1); }

    HexMesh mesh() const {
        const int n = static_cast<int>(ray_.size()) - 1, n_m = static_cast<int>(radius_.size());
        HexMesh mesh;
        for (int i = -n + 1; i <= n; ++i)
            for (const double radius : radius_)
                for (const double y : {0., s_.half_y}) {
                    const auto& [across, down] = ray_[std::abs(i)];
                    const double x = std::abs(i) <= n_patch_ && radius == s_.radius && !s_.rolls
                                         ? std::abs(i) * s_.size
                                         : radius * across;
                    mesh.nodes.push_back({i < 0 ? -x : x, y, radius * down - s_.radius});
                }
        const auto node = [&](int i, int m, int j) {
            const int ray = i == -n ? 2 * n - 1 : i + n - 1;  // both ends are one
            return (ray * n_m + m) * 2 + j;
        };
        for (int i = -n; i < n; ++i)
            for (int m = 0; m + 1 < n_m; ++m) {
                const auto at = [&](int di, int dj, int dm) { return node(i + di, m + dm, dj); };
                mesh.hexes.push_back({at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0),
                                      at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
                mesh.faces.push_back(
                    {{at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)}, Boundary::symmetry});
                mesh.faces.push_back(
                    {{at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)}, Boundary::symmetry});
                if (m == 0)
                    mesh.faces.push_back(
                        {{at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)}, Boundary::base});
                if (m + 2 == n_m)
                    mesh.faces.push_back(
                        {{at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)},
                         -n_patch_ <= i && i < n_patch_ ? Boundary::contact : Boundary::sides});
            }
        mesh.regions.assign(mesh.hexes.size(), Region::layer);
        return mesh;
    }

  private:
    CylinderMeshSpec s_;
    int n_patch_;
    std::vector<std::array<double, 2>> ray_;  // from the contact to one side: across, down
    std::vector<double> radius_;              // of the lines around the axis
};

}  // namespace

void check_lengths(std::initializer_list<double> lengths, double growth) {
    for (const double length : lengths)
        if (!contact::is_positive_and_finite(length))
            fail(round_body, fmt::format("a length is {:g} m", length), "make it positive");
    if (!(growth >= 1) || !std::isfinite(growth))
        fail(round_body, fmt::format("growth is {:g}", growth), "make it 1 or more");
}

int elements_in(double patch, double size) {
    const double n = patch / size;
    if (!(n > .5) || std::abs(n - std::round(n)) > 1e-9 * n)
        fail(round_body, fmt::format("half a patch of {:.9g} elements", n),
             "make it a whole multiple of size");
    return static_cast<int>(std::lround(n));
}

void check_width(double farthest, double radius) {
    if (!(farthest <= widest_patch * radius))
        fail(round_body,
             fmt::format("the contact patch reaches {:.4g} m from the middle, too far for the "
                         "radius {:.4g} m: more than 49 degrees",
                         farthest, radius),
             "reduce the load or enlarge the radius");
}

void check_turn(double farthest, double radius) {
    if (!(farthest <= widest_turn * radius))
        fail(round_body,
             fmt::format("the contact patch reaches {:.4g} m along the surface, too far for the "
                         "radius {:.4g} m: more than 155 degrees",
                         farthest, radius),
             "reduce the rolling amplitude or enlarge the radius");
}

double rim_of_ball(double corner) {
    constexpr double least = std::numbers::pi / 3, beyond_patch = std::numbers::pi / 9;
    return std::max(least, corner + beyond_patch);
}

double way_beyond_patch(double share, double from, double rim, double way_at_side,
                        double obliqueness) {
    constexpr double steepest = 1.5;  // first over mean edge from the patch's corner: < 2
    const double way = rim - from, first = std::min(way_at_side * obliqueness, steepest * way);
    return from + share * (first + share * (way - first));
}

void check_count(double n_elements, double size) {
    if (!(n_elements <= most))
        fail(round_body, fmt::format("size {:g} m makes {:.3g} elements", size, n_elements),
             "use a larger size");
}

HexMesh cylinder_on_hub(const CylinderMeshSpec& spec) {
    const CylinderOnHub cylinder(spec);
    check_count(cylinder.n_elements(), spec.size);
    return cylinder.mesh();
}

}  // namespace tricontact::meshes
