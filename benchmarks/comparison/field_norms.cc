#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "benchmarks/comparison/field_sums.h"

namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
constexpr double inside_share = .85, band_low = .9, band_high = 1.15;

const char* const first_order = "1: the pressure ends as a square root at the contact's edge";
const char* const load_order = "4/3 to 3/2: the edge's error acts on its own load only";
const char* const inner_order = "1 to 2: away from the contact's edge";
const char* const edge_order = "1: of the contact's edge alone";

/// Sup over r of the sum of loads nearer than r; points at one distance count together.
double largest_load_within(const UnderstoodMesh& mesh, const std::vector<double>& loads) {
    std::vector<std::size_t> order(loads.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto& points = mesh.result.points;
    std::vector<double> r(points.size());
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = distance(mesh, points[i]);
    std::ranges::sort(order, {}, [&](std::size_t i) { return r[i]; });
    double sum = 0, most = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        sum += loads[order[k]];
        const bool is_last =
            k + 1 == order.size() || r[order[k + 1]] > r[order[k]] * (1 + 1e-9) + 1e-15;
        if (is_last) most = std::max(most, std::abs(sum));
    }
    return most;
}

void add_friction_norms(std::vector<FieldNorm>& norms, const FieldSums& at, double p0) {
    const auto& points = at.mesh.result.points;
    const auto& ref = at.samples.values;
    const bool has_tractions = !points.empty() && std::isfinite(points.front().values.traction_x) &&
                               at.reference.has_friction();
    if (!has_tractions) return;
    const auto squared = [&](std::size_t i) {
        return std::pow(ref[i].traction_x, 2) + std::pow(ref[i].traction_y, 2);
    };
    const auto difference = [&](std::size_t i) {
        const double dy = std::isfinite(points[i].values.traction_y)
                              ? points[i].values.traction_y - ref[i].traction_y
                              : 0;
        return std::hypot(points[i].values.traction_x - ref[i].traction_x, dy);
    };
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    const double scale = at.integral(0, everywhere, squared);
    norms.push_back({"traction_l2", "tangential tractions, L2", first_order,
                     at.root(0, everywhere, scale, difference), 0});
    const double force = at.integral(0, everywhere, [&](std::size_t i) {
        return std::hypot(ref[i].traction_x, ref[i].traction_y);
    });
    std::vector<double> loads(points.size());
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const double d = points[i].values.traction_x - ref[i].traction_x;
        loads[i] = std::isfinite(d) ? points[i].area * d : 0;
    }
    if (force > 0)
        norms.push_back({"traction_load_within", "tangential load inside r, largest", load_order,
                         largest_load_within(at.mesh, loads) / force, 0});
    const double mu = at.reference.c.friction_coefficient();
    if (!(mu > 0)) return;
    double bound = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SurfaceValues& v = points[i].values;
        const double t = std::hypot(v.traction_x, std::isfinite(v.traction_y) ? v.traction_y : 0);
        if (std::isfinite(t)) bound = std::max(bound, t - mu * std::max(0., v.pressure));
    }
    norms.push_back({"bound", "friction bound, largest |t| - mu p", "", bound / (mu * p0), 0});
}

}  // namespace

std::vector<FieldNorm> field_norms(const UnderstoodMesh& mesh, const ReferenceSamples& samples,
                                   const Reference& reference) {
    std::vector<FieldNorm> norms;
    const auto& points = mesh.result.points;
    const auto& ref = samples.values;
    if (points.empty()) return norms;
    const double a = reference.contact_radius, p0 = peak_of(reference);
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    const FieldSums at{mesh, samples, reference};
    const auto difference = [&](std::size_t i) {
        return points[i].values.pressure - ref[i].pressure;
    };
    const auto bar = [&](std::size_t i) { return samples.pressure_bars[i]; };
    const auto squared = [&](std::size_t i) { return ref[i].pressure * ref[i].pressure; };
    const double force = at.integral(0, everywhere, [&](std::size_t i) { return ref[i].pressure; });
    std::vector<double> loads(points.size());
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const double d = difference(i);
        loads[i] = std::isfinite(d) ? points[i].area * d : 0;
    }
    norms.push_back({"load_within", "load inside r, largest over F", load_order,
                     largest_load_within(mesh, loads) / force,
                     at.integral(0, everywhere, bar) / force});
    const double scale = at.integral(0, everywhere, squared);
    norms.push_back({"pressure_l2", "pressure, L2 over the contact", first_order,
                     at.root(0, everywhere, scale, difference),
                     at.root(0, everywhere, scale, bar).value_or(0)});
    const double inner = at.integral(0, inside_share * a, squared);
    norms.push_back({"pressure_l2_inside", "pressure, L2 inside .85 a", inner_order,
                     at.root(0, inside_share * a, inner, difference),
                     at.root(0, inside_share * a, inner, bar).value_or(0)});
    double most = 0, most_bar = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (distance(mesh, points[i]) <= inside_share * a && std::isfinite(difference(i))) {
            most = std::max(most, std::abs(difference(i)));
            most_bar = std::max(most_bar, bar(i));
        }
    norms.push_back({"pressure_max_inside", "pressure, largest inside .85 a over p0", inner_order,
                     most / p0, most_bar / p0});
    const double band =
        at.integral(band_low * a, band_high * a, [](std::size_t) { return 1.; }) * p0 * p0;
    norms.push_back({"edge_band", "pressure, rms .9 a to 1.15 a over p0", edge_order,
                     at.root(band_low * a, band_high * a, band, difference),
                     at.root(band_low * a, band_high * a, band, bar).value_or(0)});
    if (reference.has_singular_edge)
        std::erase_if(norms, [](const FieldNorm& norm) {
            return norm.key == "pressure_l2" || norm.key == "edge_band";
        });
    add_friction_norms(norms, at, p0);
    const ReferenceValue* depth = reference.find(keys::indentation);
    if (depth && std::isfinite(points.front().gap)) {
        double worst = 0;
        for (const SurfacePoint& p : points)
            if (std::isfinite(p.gap)) worst = std::max(worst, std::abs(p.values.pressure * p.gap));
        norms.push_back({"complementarity", "pressure times gap, largest over p0 d", "",
                         worst / (p0 * depth->value), 0});
    }
    if (depth && std::isfinite(points.front().values.displacement_z) &&
        std::isfinite(ref.front().displacement_z)) {
        const double area = at.integral(0, a, [](std::size_t) { return 1.; });
        norms.push_back({"displacement_l2", "displacement u_z, L2 inside a over d", inner_order,
                         at.root(0, a, area * depth->value * depth->value,
                                 [&](std::size_t i) {
                                     return points[i].values.displacement_z - ref[i].displacement_z;
                                 }),
                         0});
    }
    return norms;
}

}  // namespace tricontact::benchmarks
