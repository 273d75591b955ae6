#include "benchmarks/comparison/tributary_areas.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

// Positions that differ by less of their extent are one place: digits of files.
constexpr double one_place = 1e-6;

std::vector<std::size_t> order_of(std::span<const double> positions) {
    std::vector<std::size_t> order(positions.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return positions[i]; });
    return order;
}

/// First of each place's points in `order`, and an end.
std::vector<std::size_t> places_of(std::span<const double> positions,
                                   const std::vector<std::size_t>& order) {
    std::vector<std::size_t> begins;
    if (order.empty()) return {0};
    const double extent = positions[order.back()] - positions[order.front()];
    for (std::size_t k = 0; k < order.size(); ++k)
        if (k == 0 || positions[order[k]] - positions[order[begins.back()]] > one_place * extent)
            begins.push_back(k);
    begins.push_back(order.size());
    return begins;
}

double twice_area(std::span<const double> x, std::span<const double> y, int a, int b, int c) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b),
               k = static_cast<std::size_t>(c);
    return (x[j] - x[i]) * (y[k] - y[i]) - (x[k] - x[i]) * (y[j] - y[i]);
}

/// Area of the polygon of a face's corners [unit of positions, squared].
double face_area(std::span<const double> x, std::span<const double> y, std::span<const int> face) {
    const std::size_t n = face.size();
    if (n <= 3 && n != 3) {
        const auto i = static_cast<std::size_t>(face[0]), j = static_cast<std::size_t>(face[1]);
        return std::hypot(x[j] - x[i], y[j] - y[i]);
    }
    const bool is_triangle = n == 3 || n == 6;
    double area = twice_area(x, y, face[0], face[1], face[2]);
    if (!is_triangle) area += twice_area(x, y, face[0], face[2], face[3]);
    return std::abs(area) / 2;
}

/// Shares of the face's points in its integral: of parallelograms and straight triangles exact.
std::span<const double> shares_of(std::size_t n_points) {
    static constexpr std::array two{.5, .5};
    static constexpr std::array three{1. / 3, 1. / 3, 1. / 3};
    static constexpr std::array four{.25, .25, .25, .25};
    static constexpr std::array six{0., 0., 0., 1. / 3, 1. / 3, 1. / 3};
    static constexpr std::array eight{-1. / 12, -1. / 12, -1. / 12, -1. / 12,
                                      1. / 3,   1. / 3,   1. / 3,   1. / 3};
    static constexpr std::array nine{1. / 36, 1. / 36, 1. / 36, 1. / 36, 1. / 9,
                                     1. / 9,  1. / 9,  1. / 9,  4. / 9};
    switch (n_points) {
        case 2:
            return two;
        case 3:
            return three;
        case 4:
            return four;
        case 6:
            return six;
        case 8:
            return eight;
        case 9:
            return nine;
        default:
            break;
    }
    throw contact::InputError(fmt::format(
        "a face has {} points: faces are triangles of 3 or 6 points, quadrilaterals of 4, 8 or 9; "
        "write linear faces, or a column of areas",
        n_points));
}

template <class Share>
std::vector<double> summed(std::span<const double> x, std::span<const double> y, const Faces& faces,
                           const Share& share) {
    std::vector<double> areas(x.size(), 0);
    for (int f = 0; f < faces.size(); ++f) {
        const auto begin = static_cast<std::size_t>(faces.offsets[static_cast<std::size_t>(f)]);
        const auto end = static_cast<std::size_t>(faces.offsets[static_cast<std::size_t>(f) + 1]);
        const std::span<const int> face(faces.points.data() + begin, end - begin);
        const double area = face_area(x, y, face);
        const auto shares = shares_of(face.size());
        for (std::size_t k = 0; k < face.size(); ++k)
            areas[static_cast<std::size_t>(face[k])] += area * share(shares, k);
    }
    return areas;
}

void add_face(Faces& faces, std::initializer_list<std::size_t> points) {
    for (const std::size_t p : points) faces.points.push_back(static_cast<int>(p));
    faces.offsets.push_back(static_cast<int>(faces.points.size()));
}

/// Number of the place of each point along a line, if there are few places.
std::vector<int> levels_of(std::span<const double> positions, std::size_t& n_levels) {
    const auto order = order_of(positions);
    const auto begins = places_of(positions, order);
    n_levels = begins.size() - 1;
    std::vector<int> level(positions.size());
    for (std::size_t p = 0; p + 1 < begins.size(); ++p)
        for (std::size_t k = begins[p]; k < begins[p + 1]; ++k)
            level[order[k]] = static_cast<int>(p);
    return level;
}

Faces grid_cells(std::span<const double> x, std::span<const double> y) {
    std::size_t n_x = 0, n_y = 0;
    const auto i = levels_of(x, n_x), j = levels_of(y, n_y);
    Faces faces;
    if (n_x < 2 || n_y < 2 || n_x * n_y != x.size()) return faces;
    std::vector<int> point(n_x * n_y, -1);
    for (std::size_t k = 0; k < x.size(); ++k)
        point[static_cast<std::size_t>(i[k]) + n_x * static_cast<std::size_t>(j[k])] =
            static_cast<int>(k);
    if (std::ranges::find(point, -1) != point.end()) return faces;
    for (std::size_t b = 0; b + 1 < n_y; ++b)
        for (std::size_t a = 0; a + 1 < n_x; ++a) {
            const auto at = [&](std::size_t p, std::size_t q) {
                return static_cast<std::size_t>(point[p + n_x * q]);
            };
            add_face(faces, {at(a, b), at(a + 1, b), at(a + 1, b + 1), at(a, b + 1)});
        }
    return faces;
}

}  // namespace

LineCells line_cells(std::span<const double> positions, bool from_axis) {
    LineCells cells{std::vector<double>(positions.size()), std::vector<double>(positions.size())};
    const auto order = order_of(positions);
    const auto begins = places_of(positions, order);
    const std::size_t n = begins.size() - 1;
    const auto at = [&](std::size_t place) { return positions[order[begins[place]]]; };
    for (std::size_t p = 0; p < n; ++p) {
        double low = p == 0 ? at(0) : (at(p - 1) + at(p)) / 2;
        const double high = p + 1 == n ? at(p) : (at(p) + at(p + 1)) / 2;
        if (p == 0 && from_axis && n > 1 && at(0) <= 1.5 * (at(1) - at(0))) low = 0;
        for (std::size_t k = begins[p]; k < begins[p + 1]; ++k) {
            cells.low[order[k]] = low;
            cells.high[order[k]] = high;
        }
    }
    return cells;
}

std::vector<int> sharers(std::span<const double> positions) {
    const auto order = order_of(positions);
    const auto begins = places_of(positions, order);
    std::vector<int> n(positions.size());
    for (std::size_t p = 0; p + 1 < begins.size(); ++p)
        for (std::size_t k = begins[p]; k < begins[p + 1]; ++k)
            n[order[k]] = static_cast<int>(begins[p + 1] - begins[p]);
    return n;
}

std::vector<double> face_areas(std::span<const double> x, std::span<const double> y,
                               const Faces& faces) {
    return summed(x, y, faces,
                  [](std::span<const double> shares, std::size_t k) { return shares[k]; });
}

std::vector<double> lumped_areas(std::span<const double> x, std::span<const double> y,
                                 const Faces& faces) {
    return summed(x, y, faces, [](std::span<const double> shares, std::size_t) {
        return 1. / static_cast<double>(shares.size());
    });
}

Faces triangulated(std::span<const double> x, std::span<const double> y) {
    if (x.size() < 3) return {};
    if (Faces cells = grid_cells(x, y); cells.size() > 0) return cells;
    namespace polygon = boost::polygon;
    // Whole numbers, as the library has it: the extent is 2^30 of them.
    const auto [x_low, x_high] = std::ranges::minmax(x);
    const auto [y_low, y_high] = std::ranges::minmax(y);
    const double extent = std::max(x_high - x_low, y_high - y_low);
    if (!(extent > 0)) return {};
    const double scale = (1 << 30) / extent;
    std::vector<polygon::point_data<std::int32_t>> sites(x.size());
    for (std::size_t k = 0; k < x.size(); ++k)
        sites[k] = {static_cast<std::int32_t>(std::lround((x[k] - x_low) * scale)),
                    static_cast<std::int32_t>(std::lround((y[k] - y_low) * scale))};
    polygon::voronoi_diagram<double> diagram;
    polygon::construct_voronoi(sites.begin(), sites.end(), &diagram);
    Faces faces;
    for (const auto& vertex : diagram.vertices()) {
        std::vector<std::size_t> around;
        const auto* edge = vertex.incident_edge();
        do {
            around.push_back(edge->cell()->source_index());
            edge = edge->rot_next();
        } while (edge != vertex.incident_edge());
        for (std::size_t k = 1; k + 1 < around.size(); ++k)
            add_face(faces, {around[0], around[k], around[k + 1]});
    }
    return faces;
}

}  // namespace tricontact::benchmarks
