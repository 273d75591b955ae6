#include "fem/case/cell_load.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "fem/mortar/surface_faces.h"
#include "fem/whole_body.h"

namespace tricontact::fem {

namespace {

using contact::Vector2;
using meshes::Boundary;

using Point3 = std::array<double, 3>;

/// Beyond this angle from its pole a ball is not asked for.
constexpr double farthest_angle = 1.6;

/// A surface that is laid out in a plane along great circles from the pole, or is one.
class LaidOut {
  public:
    explicit LaidOut(double radius) : radius_(radius) {}

    bool is_plane() const { return radius_ == 0; }
    double angle(const Point3& x) const {
        if (radius_ == 0) return 0;
        return std::atan2(std::hypot(x[0], x[1]), x[2] + radius_);
    }
    Vector2 place(const Point3& x) const {
        const double r = std::hypot(x[0], x[1]);
        if (radius_ == 0 || r == 0) return {x[0], x[1]};
        const double way = radius_ * angle(x);
        return {way * x[0] / r, way * x[1] / r};
    }
    /// Components of `u` in the frame that was carried to this place.
    Point3 carried(const Point3& u, const Vector2& place) const {
        const double way = std::hypot(place[0], place[1]);
        if (radius_ == 0 || way == 0) return u;
        const double c = std::cos(way / radius_), s = std::sin(way / radius_);
        const double x = place[0] / way, y = place[1] / way;
        const double outwards = x * u[0] + y * u[1], across = -y * u[0] + x * u[1];
        const double along = c * outwards - s * u[2], out = s * outwards + c * u[2];
        return {x * along - y * across, y * along + x * across, out};
    }

  private:
    double radius_;
};

/// Faces of the body's surface around the pole, with numbers of the mesh's nodes.
std::vector<SeenFace> faces_around(const Q2Space& space, const LaidOut& laid_out) {
    contact::ContactPoints surface;
    std::vector<int> nodes;
    std::map<int, int> number;
    for (const auto& face : space.faces) {
        if (face.boundary != Boundary::contact && face.boundary != Boundary::free_top &&
            face.boundary != Boundary::sides)
            continue;
        const bool beyond = std::ranges::any_of(face.nodes, [&](int node) {
            return laid_out.angle(space.nodes[node]) > farthest_angle;
        });
        const bool below = face.boundary == Boundary::sides && laid_out.is_plane();
        if (beyond || below) continue;
        auto& quad = surface.quads.emplace_back();
        for (std::size_t k = 0; k < 9; ++k) {
            const auto [at, is_new] = number.try_emplace(face.nodes[k], nodes.size());
            quad[k] = at->second;
            if (!is_new) continue;
            nodes.push_back(face.nodes[k]);
            const Vector2 place = laid_out.place(space.nodes[face.nodes[k]]);
            surface.x.push_back(place[0]);
            surface.y.push_back(place[1]);
        }
    }
    std::vector<SeenFace> faces = seen_faces(surface);
    for (SeenFace& face : faces)
        for (int& node : face.nodes) node = nodes[node];
    return faces;
}

/// Shares of a uniform traction of a face in its nodes: Simpson's weights.
constexpr std::array<double, 9> node_share{1. / 36, 1. / 36, 1. / 36, 1. / 36, 4. / 36,
                                           4. / 36, 4. / 36, 4. / 36, 16. / 36};

/// Forces of a unit traction on the cell about the origin, along d.
std::vector<double> cell_forces(const Unknowns& unknowns, const std::vector<SeenFace>& faces,
                                double size, std::size_t d) {
    std::vector<double> forces(unknowns.n, 0.);
    for (const SeenFace& face : faces) {
        const Vector2 low = face.low(), high = face.high();
        const double x = (low[0] + high[0]) / 2, y = (low[1] + high[1]) / 2;
        if (std::max(std::abs(x), std::abs(y)) > size / 2) continue;
        const double area = (high[0] - low[0]) * (high[1] - low[1]);
        for (std::size_t k = 0; k < 9; ++k)
            if (const int u = unknowns.of_node[face.nodes[k]][d]; u >= 0)
                forces[u] += node_share[k] * area;
    }
    return forces;
}

/// Where a position is: the face, and the values of its nine functions there.
struct Seen {
    const SeenFace* face;
    std::array<double, 9> share;
};

Seen seen_at(const std::vector<SeenFace>& faces, const Vector2& x) {
    constexpr double rounding = 1e-6;
    for (const SeenFace& face : faces) {
        const Vector2 low = face.low(), high = face.high();
        const double beside = rounding * face.longest_edge();
        if (x[0] < low[0] - beside || x[0] > high[0] + beside || x[1] < low[1] - beside ||
            x[1] > high[1] + beside)
            continue;
        const auto place = face.place_of(x);
        if (!place ||
            std::ranges::any_of(*place, [](double s) { return s < -rounding || s > 1 + rounding; }))
            continue;
        return {&face, biquadratic((*place)[0], (*place)[1])};
    }
    throw std::logic_error("cell_fields: a position beyond the mesh");
}

}  // namespace

SurfaceFields cell_fields(const LayerProblem& problem, const CellGrid& cells) {
    WholeBody body(problem);
    const Q2Space& space = body.discretisation.space;
    const Unknowns& unknowns = body.discretisation.unknowns;
    const LaidOut laid_out(cells.radius);
    const std::vector<SeenFace> faces = faces_around(space, laid_out);
    std::vector<Seen> seen;
    std::vector<Vector2> places;
    for (int j = 0; j < cells.n; ++j)
        for (int i = 0; i < cells.n; ++i) {
            places.push_back({i * cells.size, j * cells.size});
            seen.push_back(seen_at(faces, places.back()));
        }
    const auto under = [&](std::size_t direction) {
        const auto moved =
            body.state(cell_forces(unknowns, faces, cells.size, direction)).displacement;
        std::vector<Point3> field;
        for (std::size_t k = 0; k < seen.size(); ++k) {
            Point3 u{};
            for (std::size_t a = 0; a < 9; ++a)
                for (std::size_t d = 0; d < 3; ++d)
                    if (const int at = unknowns.of_node[seen[k].face->nodes[a]][d]; at >= 0)
                        u[d] += seen[k].share[a] * moved[at];
            field.push_back(laid_out.carried(u, places[k]));
        }
        return field;
    };
    return {cells.n, under(0), under(2)};
}

double largest_difference(const SurfaceFields& a, const SurfaceFields& b) {
    double largest = 0;
    const int n = std::min(a.n, b.n);
    const auto compare = [&](const auto& one, const auto& other) {
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                for (std::size_t d = 0; d < 3; ++d)
                    largest =
                        std::max(largest, std::abs(one[j * a.n + i][d] - other[j * b.n + i][d]));
    };
    compare(a.by_x, b.by_x);
    compare(a.by_z, b.by_z);
    return largest;
}

}  // namespace tricontact::fem
