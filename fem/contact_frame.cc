#include "fem/contact_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fem/dense_compliance.h"

namespace tricontact::fem {

namespace {

/// Mean displacement into the substrate of a node under unit traction on its own area [m/Pa].
double local_normal(const contact::ContactPoints& points, const std::vector<double>& compliance) {
    const std::size_t n = points.size();
    double sum = 0;
    for (std::size_t i = 2 * n; i < 3 * n; ++i)
        sum += compliance[i * 3 * n + i] * points.area[i - 2 * n];
    return sum / static_cast<double>(n);
}

/// Of what tractions along the surface displace into it, and pressures along it, the mean over the
/// elements about each node. Nodes' parts of an element are Simpson's weights: that mean is
/// self-adjoint by their areas, and the matrix stays symmetric.
void take_element_means(const contact::ContactPoints& points, std::vector<double>& matrix) {
    constexpr std::array<double, 9> part{1, 1, 1, 1, 4, 4, 4, 4, 16};  // of 36; corners, edges
    const std::size_t n = points.size();
    std::vector<double> sum(n), parts(n, 0);
    std::vector<double> size;
    for (const auto& quad : points.quads) {
        const auto side = [&](int from, int to) {
            return std::hypot(points.x[quad[to]] - points.x[quad[from]],
                              points.y[quad[to]] - points.y[quad[from]]);
        };
        size.push_back(side(0, 1) * side(1, 2));
        for (std::size_t k = 0; k < 9; ++k) parts[quad[k]] += size.back() * part[k];
    }
    for (std::size_t column = 0; column < 2 * n; ++column) {
        double* const down = &matrix[column * 3 * n + 2 * n];
        std::ranges::fill(sum, 0);
        for (std::size_t e = 0; e < points.quads.size(); ++e) {
            const auto& quad = points.quads[e];
            double mean = 0;
            for (std::size_t k = 0; k < 9; ++k) mean += part[k] / 36 * down[quad[k]];
            for (std::size_t k = 0; k < 9; ++k) sum[quad[k]] += size[e] * part[k] * mean;
        }
        for (std::size_t i = 0; i < n; ++i)
            if (parts[i] > 0) matrix[(2 * n + i) * 3 * n + column] = down[i] = sum[i] / parts[i];
    }
}

}  // namespace

std::vector<double> in_contact_frame(CondensedLayer& layer, Side side) {
    const double part = modelled_part(layer.points);
    const double across = side == Side::substrate ? -part : part;
    const std::size_t n = layer.missing_reaction[0].size();
    for (std::size_t c = 0; c < n; ++c)
        for (std::size_t r = 0; r < n; ++r)
            layer.compliance[c * n + r] *= (c < n / 3 * 2) == (r < n / 3 * 2) ? part : across;
    return std::move(layer.compliance);
}

void turn_to_round_frame(CondensedLayer& body, double radius) {
    const std::size_t n = body.points.size(), z = 2 * n;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = body.points.x[i] / radius, c = std::cos(angle), s = std::sin(angle);
        const auto turn = [&](double& along, double& out) {
            const double x = along, up = out;
            along = c * x - s * up;
            out = s * x + c * up;
        };
        for (std::size_t k = 0; k < 3 * n; ++k)
            turn(body.compliance[k * 3 * n + i], body.compliance[k * 3 * n + z + i]);
        for (std::size_t k = 0; k < 3 * n; ++k)
            turn(body.compliance[i * 3 * n + k], body.compliance[(z + i) * 3 * n + k]);
        for (auto& missing : body.missing_reaction) turn(missing[i], missing[z + i]);
    }
}

ContactSide joined(contact::ContactPoints points, std::vector<double> compliance,
                   double line_length, double elastic_ratio, const contact::Interface& interface,
                   bool by_element_means) {
    if (by_element_means) take_element_means(points, compliance);
    points.line_length = line_length;
    points.local_ratio = elastic_ratio;
    points.on_springs = interface.is_elastic();
    if (points.on_springs) {
        const double down = local_normal(points, compliance);
        points.local_ratio = (points.local_ratio * down + interface.tangential_compliance()) /
                             (down + interface.normal_compliance());
        const std::size_t n = 3 * points.size();
        for (std::size_t i = 0; i < n; ++i) {
            double& own = compliance[i * n + i];
            const double springs =
                i < n / 3 * 2 ? interface.tangential_compliance() : interface.normal_compliance();
            if (own > 0) own += springs / points.area[i % (n / 3)];
        }
    }
    return {std::move(points), std::move(compliance)};
}

}  // namespace tricontact::fem
