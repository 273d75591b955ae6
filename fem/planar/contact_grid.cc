#include "fem/planar/contact_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/base/error.h"

namespace tricontact::fem::planar {

namespace {

using Entries = std::vector<ContactGrid::Entry>;

/// Gauss points of [0, 1]: exact to degree 7, which products of a quadratic and a linear function
/// with the circumference, and with a curved coordinate, need.
constexpr std::array<double, 4> gauss_at{.069431844202973712, .33000947820757187,
                                         .66999052179242813, .93056815579702629};
constexpr std::array<double, 4> gauss_weight{.17392742256872693, .32607257743127307,
                                             .32607257743127307, .17392742256872693};

std::array<double, 3> quadratic(double s) {
    return {(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)};
}

double interpolated(const std::array<double, 3>& shape, const std::vector<double>& at_node,
                    const std::array<int, 3>& edge) {
    return shape[0] * at_node[edge[0]] + shape[1] * at_node[edge[1]] + shape[2] * at_node[edge[2]];
}

/// Where on an edge, from 0 to 1, the coordinate is `along`: Newton from the straight line.
double place_on(const CondensedSection& body, const std::array<int, 3>& edge, double along) {
    const double first = body.along[edge[0]], last = body.along[edge[2]];
    double s = (along - first) / (last - first);
    const double bulge = 4 * body.along[edge[1]] - 2 * (first + last);
    for (int k = 0; k < 8; ++k)
        s -= (first + s * (last - first) + s * (1 - s) * bulge - along) /
             (last - first + (1 - 2 * s) * bulge);
    return s;
}

/// Row sums of the surface mass: tributary area of each node.
std::vector<double> node_areas(const CondensedSection& body) {
    std::vector<double> area(body.size(), 0);
    for (const auto& edge : body.edges) {
        const double first = body.along[edge[0]], last = body.along[edge[2]];
        const double bulge = 4 * body.along[edge[1]] - 2 * (first + last);
        for (std::size_t q = 0; q < gauss_at.size(); ++q) {
            const double s = gauss_at[q], slope = last - first + (1 - 2 * s) * bulge;
            const auto shape = quadratic(s);
            const double weight =
                gauss_weight[q] * slope * extent(body.solid, interpolated(shape, body.x, edge));
            for (int i = 0; i < 3; ++i) area[edge[i]] += weight * shape[i];
        }
    }
    return area;
}

/// Mean distance of the nodes of a body [m].
double node_distance(const CondensedSection& body) {
    return (body.along.back() - body.along.front()) / static_cast<double>(body.size() - 1);
}

/// The contact points of a mortar and the linear functions between them.
struct LinearFunctions {
    const std::vector<double>& along;

    /// Values of the two functions that are not zero between the points i and i + 1.
    std::array<double, 2> at(std::size_t i, double s) const {
        const double t = (s - along[i]) / (along[i + 1] - along[i]);
        return {1 - t, t};
    }
};

/// M of one body: integrals over the pieces between all nodes and points.
Entries transfer_to(const CondensedSection& body, const std::vector<double>& points) {
    Entries entries;
    const LinearFunctions linear{points};
    for (const auto& edge : body.edges)
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const double low = std::max(points[i], body.along[edge[0]]);
            const double high = std::min(points[i + 1], body.along[edge[2]]);
            if (!(high > low)) continue;
            for (std::size_t q = 0; q < gauss_at.size(); ++q) {
                const double s = low + gauss_at[q] * (high - low);
                const auto shape = quadratic(place_on(body, edge, s));
                const auto psi = linear.at(i, s);
                const double weight = gauss_weight[q] * (high - low) *
                                      extent(body.solid, interpolated(shape, body.x, edge));
                for (int a = 0; a < 3; ++a)
                    for (int b = 0; b < 2; ++b)
                        entries.push_back(
                            {edge[a], static_cast<int>(i) + b, weight * shape[a] * psi[b]});
            }
        }
    return entries;
}

std::vector<double> column_sums(const Entries& matrix, std::size_t n_points) {
    std::vector<double> sums(n_points, 0);
    for (const ContactGrid::Entry& entry : matrix) sums[entry.point] += entry.value;
    return sums;
}

void refuse_nothing_shared(const std::vector<double>& points) {
    if (points.size() < 2)
        throw contact::InputError(
            "mesh: the contact surfaces of both bodies do not face each other");
}

}  // namespace

bool nodes_meet(const std::vector<CondensedSection>& bodies) {
    const CondensedSection& first = bodies.front();
    return std::ranges::all_of(bodies, [&](const CondensedSection& body) {
        if (body.size() != first.size() || body.edges != first.edges) return false;
        for (std::size_t i = 0; i < body.size(); ++i)
            if (std::abs(body.along[i] - first.along[i]) > 1e-6 * node_distance(first))
                return false;
        return true;
    });
}

ContactGrid points_on_nodes(const std::vector<CondensedSection>& bodies) {
    const CondensedSection& body = bodies.front();
    const std::vector<double> area = node_areas(body);
    ContactGrid grid;
    Entries entries;
    for (std::size_t i = 0; i < area.size(); ++i) {
        if (body.solid == Solid::of_revolution && body.along[i] == 0) continue;
        entries.push_back({static_cast<int>(i), static_cast<int>(grid.size()), area[i]});
        grid.along.push_back(body.along[i]);
        grid.area.push_back(area[i]);
    }
    grid.transfer.assign(bodies.size(), entries);
    return grid;
}

ContactGrid mortar(const std::vector<CondensedSection>& bodies) {
    double low = -INFINITY, high = INFINITY;
    for (const CondensedSection& body : bodies) {
        low = std::max(low, body.along.front());
        high = std::min(high, body.along.back());
    }
    const CondensedSection& coarse = *std::ranges::max_element(bodies, {}, node_distance);
    const double least = node_distance(coarse) / 2;
    ContactGrid grid;
    for (const double s : coarse.along)
        if (s >= low - 1e-9 * least && s <= high + 1e-9 * least) grid.along.push_back(s);
    refuse_nothing_shared(grid.along);
    // Ends that the coarser body's nodes leave out belong to their neighbours.
    if (grid.along.front() - low > least) grid.along.insert(grid.along.begin(), low);
    if (high - grid.along.back() > least) grid.along.push_back(high);
    for (const CondensedSection& body : bodies)
        grid.transfer.push_back(transfer_to(body, grid.along));
    grid.area = column_sums(grid.transfer.front(), grid.size());
    return grid;
}

ContactGrid elements_of(const std::vector<CondensedSection>& bodies) {
    const CondensedSection& body = bodies.front();
    ContactGrid grid;
    Entries entries;
    for (const auto& edge : body.edges) {
        const double length = body.along[edge[2]] - body.along[edge[0]];
        constexpr std::array<double, 3> part{1. / 6, 4. / 6, 1. / 6};  // Simpson's, of a traction
        for (std::size_t i = 0; i < 3; ++i)
            entries.push_back({edge[i], static_cast<int>(grid.size()), part[i] * length});
        grid.along.push_back(body.along[edge[1]]);
        grid.area.push_back(length);
    }
    grid.transfer.assign(bodies.size(), entries);
    return grid;
}

ContactGrid rings_on_nodes(const std::vector<CondensedSection>& bodies) {
    const CondensedSection& body = bodies.front();
    ContactGrid grid;
    grid.along.assign(body.along.begin() + 1, body.along.end());
    Entries entries = transfer_to(body, body.along);
    for (ContactGrid::Entry& entry : entries) entry.point = std::max(entry.point - 1, 0);
    grid.transfer.assign(bodies.size(), entries);
    grid.area = column_sums(grid.transfer.front(), grid.size());
    return grid;
}

ContactGrid grid_between(const std::vector<CondensedSection>& bodies) {
    return nodes_meet(bodies) ? points_on_nodes(bodies) : mortar(bodies);
}

}  // namespace tricontact::fem::planar
