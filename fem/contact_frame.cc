#include "fem/contact_frame.h"

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

ContactSide joined(contact::ContactPoints points, std::vector<double> compliance,
                   double line_length, double elastic_ratio, const contact::Interface& interface) {
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
