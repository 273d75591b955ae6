#include "comparisons/quantities/roller_ends.h"

#include <algorithm>
#include <cmath>

#include "comparisons/quantities/surface_fields.h"

namespace tricontact::comparisons {

namespace {

using contact::ContactState;
using contact::Surface;

constexpr double same_width = 0.01;  // counts as that of the middle
constexpr double same_row = 1e-9;    // of the length: rounding of nodes' positions

double x_of(const Surface& s, int i) {
    return s.layout == Surface::Layout::nodes && s.n_x == 0 ? s.node_x[i] : s.x(i % s.n_x);
}

double y_of(const Surface& s, int i) {
    return s.layout == Surface::Layout::nodes && s.n_x == 0 ? s.node_y[i] : s.y(i / s.n_x);
}

/// Points of one row, x increasing.
using Cells = std::vector<int>;

/// Rows with y >= 0 up to the end, y decreasing.
std::vector<Cells> rows_from_end(const Surface& s, double length) {
    const double tolerance = same_row * length;
    std::vector<int> points;
    for (int i = 0; i < static_cast<int>(s.size()); ++i)
        if (y_of(s, i) >= -tolerance && y_of(s, i) <= length / 2 + tolerance) points.push_back(i);
    std::ranges::stable_sort(points, [&](int i, int j) { return y_of(s, i) > y_of(s, j); });
    std::vector<Cells> rows;
    for (const int i : points) {
        if (rows.empty() || y_of(s, rows.back().front()) - y_of(s, i) > tolerance)
            rows.push_back({});
        rows.back().push_back(i);
    }
    for (Cells& row : rows)
        std::ranges::sort(row, [&](int i, int j) { return x_of(s, i) < x_of(s, j); });
    return rows;
}

/// Where the contact of a row ends on one side [m]; `last` and `next` walk outwards from its last
/// point. Next to an edge the gap grows with the power 3/2 of the distance (Johnson 1985, 5.1).
double edge(const Surface& s, const Cells& row, int last, int side) {
    const auto at = [&](int k) { return x_of(s, row[k]); };
    const int first = last + side, second = first + side;
    if (first < 0 || first >= static_cast<int>(row.size())) return at(last);
    const double middle = (at(last) + at(first)) / 2;
    if (second < 0 || second >= static_cast<int>(row.size())) return middle;
    const double near = std::cbrt(std::pow(s.gap[row[first]], 2)),
                 far = std::cbrt(std::pow(s.gap[row[second]], 2));
    if (!(far > near)) return middle;
    const double position = at(first) - (at(second) - at(first)) * near / (far - near);
    return std::clamp(position, std::min(at(last), at(first)), std::max(at(last), at(first)));
}

std::optional<RollerSection> section(const Surface& s, const Cells& row, double length) {
    const auto touches = [&](int i) { return s.contact_state[i] != ContactState::open; };
    const auto first = std::ranges::find_if(row, touches);
    if (first == row.end()) return {};
    const auto last = std::find_if(row.rbegin(), row.rend(), touches);
    const auto nearest = std::ranges::min_element(
        row, {}, [&](int i) { return std::abs(x_of(s, i) - s.offset[0]); });
    const double left = edge(s, row, static_cast<int>(first - row.begin()), -1),
                 right = edge(s, row, static_cast<int>(row.rend() - last) - 1, 1);
    return RollerSection{std::max(0., length / 2 - std::abs(y_of(s, row.front()))),
                         (right - left) / 2, s.normal_traction[*nearest]};
}

/// Where the straight line through two sections' widths passes `width`.
double crossing(const RollerSection& outer, const RollerSection& inner, double width) {
    const double share = (width - inner.half_width) / (outer.half_width - inner.half_width);
    return inner.distance + share * (outer.distance - inner.distance);
}

/// How far from the end the half width differs from that in the middle; zero where it nowhere does.
double distance_of_difference(const std::vector<RollerSection>& sections, bool wider_only) {
    const double middle = sections.back().half_width;
    for (std::size_t k = sections.size(); k-- > 0;) {
        const double excess = sections[k].half_width / middle - 1;
        if (excess > same_width || (!wider_only && excess < -same_width))
            return crossing(sections[k], sections[k + 1],
                            middle * (1 + std::copysign(same_width, excess)));
    }
    return 0;
}

}  // namespace

std::vector<RollerSection> roller_sections(const Surface& surface, double length) {
    std::vector<RollerSection> sections;
    for (const Cells& row : rows_from_end(surface, length))
        if (const auto found = section(surface, row, length)) sections.push_back(*found);
    return sections;
}

std::optional<RollerEnds> roller_ends(const contact::Case& c, const contact::History& history) {
    const contact::Snapshot* last = last_upright(history);
    if (c.indenter.shape != contact::Case::Shape::roller || !last) return {};
    const auto sections = roller_sections(last->surface, c.indenter.length);
    if (sections.empty()) return {};
    const double middle = sections.back().half_width;
    const auto most = std::ranges::max_element(sections, {}, &RollerSection::half_width);
    return RollerEnds{middle, most->half_width / middle, distance_of_difference(sections, true),
                      distance_of_difference(sections, false)};
}

}  // namespace tricontact::comparisons
