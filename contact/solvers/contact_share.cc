#include "contact/solvers/contact_share.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "contact/compliances/radial_points.h"

namespace tricontact::contact {

namespace {

// Of the gaps that a point looks at: how far away, in distances of neighbours, and how many.
constexpr double reach = 4.6;
constexpr std::size_t fewest = 6;
// Mean deviation from the fit, in what the gaps of neighbours differ by.
constexpr double roughest = .6;
// Beside a point that touches, the gap is that of a traction which ends with that point's surface.
// It counts where there is little else.
constexpr double weight_beside = .03;
constexpr double no_pressure = 1e-300;

/// Solves m x = r by elimination with pivots; false if m is singular to rounding.
template <std::size_t n>
bool solve(std::array<std::array<double, n>, n> m, std::array<double, n> r, std::size_t size,
           std::array<double, n>& x) {
    constexpr double negligible = 1e-9;
    for (std::size_t k = 0; k < size; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < size; ++i)
            if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
        if (!(std::abs(m[pivot][k]) > negligible)) return false;
        std::swap(m[k], m[pivot]);
        std::swap(r[k], r[pivot]);
        for (std::size_t i = k + 1; i < size; ++i) {
            const double factor = m[i][k] / m[k][k];
            for (std::size_t j = k; j < size; ++j) m[i][j] -= factor * m[k][j];
            r[i] -= factor * r[k];
        }
    }
    for (std::size_t k = size; k-- > 0;) {
        x[k] = r[k];
        for (std::size_t j = k + 1; j < size; ++j) x[k] -= m[k][j] * x[j];
        x[k] /= m[k][k];
    }
    return true;
}

using Terms = std::array<double, 4>;

/// Weighted least squares by the first `size` terms of each row (Gauss' normal equations).
struct LeastSquares {
    std::array<Terms, 4> m{};
    Terms r{};

    void add(const Terms& row, double value, double weight, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i) {
            r[i] += weight * row[i] * value;
            for (std::size_t j = 0; j <= i; ++j) m[i][j] += weight * row[i] * row[j];
        }
    }
    bool solve_for(std::size_t size, Terms& factor) {
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t j = 0; j < i; ++j) m[j][i] = m[i][j];
        return solve(m, r, size, factor);
    }
};

double cross(const Vector2& a, const Vector2& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// Part of a parallelogram in which a linear function is positive: at its centre `middle`, growing
/// by `u` and `v` along its half sides.
double positive_part(double middle, double u, double v) {
    const std::array<Vector2, 4> corner{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    std::array<double, 4> value{};
    for (std::size_t k = 0; k < 4; ++k) value[k] = middle + corner[k][0] * u + corner[k][1] * v;
    const auto [least, most] = std::ranges::minmax(value);
    if (least >= 0) return 1;
    if (most <= 0) return 0;
    double area = 0;
    Vector2 first{}, last{};
    bool any = false;
    const auto add = [&](const Vector2& p) {
        if (any)
            area += cross(last, p);
        else
            first = p;
        last = p;
        any = true;
    };
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        if (value[k] > 0) add(corner[k]);
        if ((value[k] > 0) != (value[next] > 0)) {
            const double part = value[k] / (value[k] - value[next]);
            add(corner[k] + part * (corner[next] - corner[k]));
        }
    }
    return std::clamp((area + cross(last, first)) / 8, 0., 1.);
}

}  // namespace

bool ContactShare::is_known(const ContactPoints& points) {
    return (points.n_x > 0 || !points.quads.empty()) && !points.periodic && !points.on_springs;
}

ContactShare::ContactShare(const ContactPoints& points) {
    if (!points.quads.empty() || points.n_y == 1) {
        points_ = points;
        if (!points.quads.empty()) add_faces();
        return;
    }
    points_.n_x = points.n_x;
    points_.n_y = points.n_y;
    points_.mirrored = points.mirrored;
}

void ContactShare::add_faces() {
    const std::size_t n = points_.size();
    pieces_.resize(n);
    unit_.assign(n, 0);
    std::vector<std::vector<int>> faces(n);
    // Of corners, edges, centre in the order of VTK.
    constexpr std::array<std::array<int, 2>, 9> places{
        {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}}};
    for (std::size_t f = 0; f < points_.quads.size(); ++f) {
        const auto& quad = points_.quads[f];
        const auto at = [&](int k) { return Vector2{points_.x[quad[k]], points_.y[quad[k]]}; };
        const Vector2 across = .25 * (at(1) + at(2) - at(0) - at(3));
        const Vector2 up = .25 * (at(2) + at(3) - at(0) - at(1));
        const Vector2 centre = .25 * (at(0) + at(1) + at(2) + at(3));
        const double area = std::abs(cross(across, up));
        for (std::size_t k = 0; k < 9; ++k) {
            const auto [i, j] = places[k];
            const double half_u = i == 0 ? 2. / 3 : 1. / 6, half_v = j == 0 ? 2. / 3 : 1. / 6;
            const Vector2 from = centre + (5. / 6 * i) * across + (5. / 6 * j) * up - at(k);
            pieces_[quad[k]].push_back({.x = from[0],
                                        .y = from[1],
                                        .part = area * half_u * half_v,
                                        .u = half_u * across,
                                        .v = half_v * up});
            unit_[quad[k]] = std::max(unit_[quad[k]], std::sqrt(area));
            faces[quad[k]].push_back(static_cast<int>(f));
        }
    }
    for (auto& pieces : pieces_) {
        double all = 0;
        for (const Piece& piece : pieces) all += piece.part;
        for (Piece& piece : pieces) piece.part /= all;
    }
    if (points_.n_x > 0) return;
    const auto on_faces = [&](const std::vector<int>& nodes) {
        std::vector<int> all;
        for (const int node : nodes)
            for (const int face : faces[node])
                all.insert(all.end(), points_.quads[face].begin(), points_.quads[face].end());
        std::ranges::sort(all);
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    };
    for (std::size_t i = 0; i < n; ++i) beside_.push_back(on_faces({static_cast<int>(i)}));
    for (const auto& nodes : beside_) neighbours_.push_back(on_faces(nodes));
}

void ContactShare::find_neighbours(int point, std::vector<Neighbour>& found) const {
    found.clear();
    const auto add = [&](int other, double x, double y) {
        if (x * x + y * y <= reach * reach) found.push_back({other, x, y});
    };
    if (points_.n_x > 0) {
        constexpr int most = static_cast<int>(reach);
        const int i = point % points_.n_x, j = point / points_.n_x;
        for (int down = -most; down <= most; ++down)
            for (int along = -most; along <= most; ++along) {
                // Rows beyond the plane of symmetry are images of those on this side.
                const int row = points_.mirrored ? std::abs(j + down) : j + down;
                const int column = i + along;
                if (row < 0 || row >= points_.n_y || column < 0 || column >= points_.n_x) continue;
                add(row * points_.n_x + column, along, down);
            }
        return;
    }
    const double unit = unit_[point];
    for (const int other : neighbours_[point]) {
        const double x = (points_.x[other] - points_.x[point]) / unit;
        add(other, x, (points_.y[other] - points_.y[point]) / unit);
        if (points_.mirrored && points_.y[other] > 0)
            add(other, x, (-points_.y[other] - points_.y[point]) / unit);
    }
}

bool ContactShare::is_at_edge(std::span<const double> pressure, int point) const {
    const bool touches = pressure[point] > 0;
    const auto differs = [&](int other) { return (pressure[other] > 0) != touches; };
    if (points_.n_x == 0) return std::ranges::any_of(beside_[point], differs);
    const int i = point % points_.n_x, j = point / points_.n_x;
    const int first = std::max(i - 1, 0), last = std::min(i + 1, points_.n_x - 1);
    for (int row = std::max(j - 1, 0); row <= std::min(j + 1, points_.n_y - 1); ++row)
        for (int column = first; column <= last; ++column)
            if (differs(row * points_.n_x + column)) return true;
    return false;
}

/// A plane through the gaps, then one that is curved along the edge.
bool ContactShare::fit(const std::vector<Beside>& beside, bool is_line, Edge& edge) {
    if (beside.size() < (is_line ? 2 : fewest)) return false;
    double largest = 0;
    for (const Beside& one : beside) largest = std::max(largest, -one.value);
    if (!(largest > 0)) return false;
    const std::size_t n_plane = is_line ? 2 : 3;
    LeastSquares straight;
    for (const Beside& one : beside)
        straight.add({1, one.x, one.y, 0}, one.value / largest, one.weight, n_plane);
    Terms plane{};
    if (!straight.solve_for(n_plane, plane)) return false;
    edge = {plane[0], plane[1], plane[2]};
    const double slope = std::hypot(plane[1], plane[2]);
    if (!(slope > 0)) return false;
    if (is_line) return true;
    const auto row = [&](const Beside& one) {
        const double along = (one.y * plane[1] - one.x * plane[2]) / slope;
        return Terms{1, one.x, one.y, along * along};
    };
    LeastSquares curve;
    for (const Beside& one : beside) curve.add(row(one), one.value / largest, one.weight, 4);
    Terms curved{};
    if (!curve.solve_for(4, curved)) return false;
    double deviation = 0, all = 0;
    for (const Beside& one : beside) {
        const Terms terms = row(one);
        double off = -one.value / largest;
        for (std::size_t i = 0; i < 4; ++i) off += curved[i] * terms[i];
        deviation += one.weight * off * off;
        all += one.weight;
    }
    edge = {curved[0], curved[1], curved[2]};
    return std::sqrt(deviation / all) <= roughest * std::hypot(curved[1], curved[2]);
}

double ContactShare::part_inside(int point, const Edge& edge) const {
    if (!pieces_.empty()) {
        const Vector2 unit =
            points_.n_x > 0 ? points_.spacing : Vector2{unit_[point], unit_[point]};
        double part = 0;
        const Vector2 slope{edge.along_x / unit[0], edge.along_y / unit[1]};
        for (const Piece& piece : pieces_[point])
            part +=
                piece.part * positive_part(edge.inside + slope[0] * piece.x + slope[1] * piece.y,
                                           dot(slope, piece.u), dot(slope, piece.v));
        return part;
    }
    // The nodes of a line have Simpson's weights, cells of a grid are alike.
    double half = .5;
    if (are_radii(points_)) {
        half *= ring_width(points_, point);
    } else if (points_.n_y == 1) {
        double all = 0;
        for (const double area : points_.area) all += area;
        half *= points_.area[point] * static_cast<double>(points_.size()) / all;
    }
    return positive_part(edge.inside, half * edge.along_x, .5 * edge.along_y);
}

std::vector<double> ContactShare::of(std::span<const double> pressure,
                                     std::span<const double> gap) const {
    const std::size_t n = pressure.size();
    std::vector<double> share(n);
    std::vector<std::uint8_t> at_edge(n);
    for (std::size_t i = 0; i < n; ++i) {
        share[i] = pressure[i] > 0 ? 1 : 0;
        at_edge[i] = is_at_edge(pressure, static_cast<int>(i));
    }
    std::vector<double> straight(n, 1);  // -gap^(2/3), where it has been asked for
    std::vector<Neighbour> around;
    std::vector<Beside> beside;
    Edge edge{};
    for (std::size_t i = 0; i < n; ++i) {
        if (!at_edge[i]) continue;
        const int point = static_cast<int>(i);
        find_neighbours(point, around);
        beside.clear();
        for (const auto& [other, x, y] : around) {
            if (pressure[other] > 0 || !std::isfinite(gap[other])) continue;
            double& value = straight[other];
            if (value > 0) value = gap[other] > 0 ? -std::cbrt(gap[other] * gap[other]) : 0;
            beside.push_back(
                {x, y, value, (at_edge[other] ? weight_beside : 1) / (1 + x * x + y * y)});
        }
        if (fit(beside, points_.n_y == 1, edge)) share[i] = part_inside(point, edge);
    }
    return share;
}

void bounds_on_shares(const FrictionLaw& law, const FrictionLaw::Points& points,
                      std::span<const double> share, std::span<double> bound) {
    law.bounds(points, bound);
    for (std::size_t i = 0; i < share.size(); ++i) {
        const bool touches = points.pressure[i] > 0;
        if (share[i] == (touches ? 1 : 0)) continue;
        double jump = 0;
        const auto one = [i](std::span<const double> all) {
            return all.empty() ? all : all.subspan(i, 1);
        };
        law.bounds({{&no_pressure, 1}, one(points.x), one(points.y)}, {&jump, 1});
        bound[i] = std::max(bound[i] - (touches ? jump : 0), 0.) + share[i] * jump;
    }
}

}  // namespace tricontact::contact
