#include "fem/contact_line.h"

#include <algorithm>

namespace tricontact::fem {

namespace {

using contact::ContactPoints;

/// Share of each of the slice's points in the area of the line's point at the same x.
std::vector<double> shares(const ContactPoints& slice, const ContactPoints& line) {
    std::vector<double> share(slice.size());
    for (std::size_t k = 0; k < share.size(); ++k)
        share[k] = slice.area[k] / line.area[k % line.size()];
    return share;
}

ContactPoints line_points(const ContactPoints& slice) {
    const double length = 2 * *std::ranges::max_element(slice.y);
    ContactPoints line =
        ContactPoints::grid(slice.n_x, 1, {slice.first[0], 0}, {slice.spacing[0], length});
    std::ranges::copy_n(slice.x.begin(), slice.n_x, line.x.begin());
    std::ranges::fill(line.area, 0);
    for (std::size_t k = 0; k < slice.size(); ++k) line.area[k % line.size()] += slice.area[k];
    line.mirrored = true;
    return line;
}

}  // namespace

CondensedLayer contact_line(const CondensedLayer& slice) {
    CondensedLayer line;
    line.points = line_points(slice.points);
    const std::size_t n = slice.points.size(), m = line.points.size();
    const std::vector<double> share = shares(slice.points, line.points);
    line.compliance.assign(9 * m * m, 0);
    for (auto& missing : line.missing_reaction) missing.assign(3 * m, 0);
    for (const std::size_t c : {0, 2})
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t column = c * m + k % m;
            for (std::size_t d = 0; d < 3; ++d)
                line.missing_reaction[d][column] += share[k] * slice.missing_reaction[d][c * n + k];
            for (const std::size_t r : {0, 2})
                for (std::size_t l = 0; l < n; ++l)
                    line.compliance[column * 3 * m + r * m + l % m] +=
                        share[k] * share[l] * slice.compliance[(c * n + k) * 3 * n + r * n + l];
        }
    return line;
}

}  // namespace tricontact::fem
