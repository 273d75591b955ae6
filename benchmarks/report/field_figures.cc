// Fields of a code over those of the reference.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "benchmarks/report/comparison_figures.h"
#include "benchmarks/report/comparison_words.h"
#include "report/format.h"

namespace tricontact::benchmarks {

namespace {

using report::Curve;

constexpr double drawn_reach = 1.3;       // over a
constexpr int reference_points = 400;     // of a curve
constexpr std::size_t most_points = 500;  // of a mesh: more are not told apart
constexpr const char* reference_name = "reference";

/// A field along the radius, or along x.
struct Profile {
    const char *id, *name, *symbol;
    double SurfaceValues::*of;
};
constexpr Profile pressure_profile{"pressure", "Pressure", "p", &SurfaceValues::pressure};
constexpr Profile traction_profile{"traction", "Tangential traction along x", "t_x",
                                   &SurfaceValues::traction_x};

bool is_along_radius(const Comparison& comparison) {
    return comparison.reference.geometry == Geometry::axisymmetric;
}

/// Points of a mesh by where they stand along the axis that is drawn. In three dimensions under a
/// contact that is no body of revolution those within a row of elements of y = 0.
std::vector<std::pair<double, const SurfacePoint*>> placed(const Comparison& comparison,
                                                           const MeshResult& mesh) {
    std::vector<std::pair<double, const SurfacePoint*>> points;
    const bool radius = is_along_radius(comparison);
    const bool in_space = mesh.geometry == Geometry::spatial;
    for (const SurfacePoint& point : mesh.points) {
        if (!radius && in_space && std::abs(point.y) > .75 * mesh.size) continue;
        const double at = !radius    ? point.x
                          : in_space ? std::hypot(point.x, point.y)
                                     : std::abs(point.x);
        if (std::abs(at) <= drawn_reach * comparison.reference.contact_radius)
            points.emplace_back(at, &point);
    }
    std::ranges::sort(points, {}, &decltype(points)::value_type::first);
    return points;
}

/// The reference along the axis with its band; `largest` of its magnitude.
void add_reference(const Comparison& comparison, const Profile& profile, double length, double unit,
                   report::Figure& figure) {
    const ReferenceFields& fields = *comparison.reference.fields;
    const double reach = drawn_reach * comparison.reference.contact_radius;
    const double low = is_along_radius(comparison) ? 0 : -reach;
    Curve curve{.name = reference_name, .colour = report::measured_style};
    report::Band band{.name = reference_name};
    for (int i = 0; i <= reference_points; ++i) {
        const double at = low + (reach - low) * i / reference_points;
        const double value = fields.at(at, 0).*profile.of / unit;
        const double bar = fields.bar_at(at, 0).*profile.of / unit;
        curve.add(at / length, value);
        band.x.push_back(at / length);
        band.low.push_back(value - bar);
        band.high.push_back(value + bar);
    }
    figure.curves.push_back(std::move(curve));
    figure.bands.push_back(std::move(band));
}

/// The largest magnitude of a field of the reference in the contact.
double largest_of(const Comparison& comparison, const Profile& profile) {
    const double reach = comparison.reference.contact_radius;
    double largest = 0;
    for (int i = 0; i <= reference_points; ++i) {
        const double at = reach * (2. * i / reference_points - 1);
        const double value = comparison.reference.fields->at(at, 0).*profile.of;
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
    return largest;
}

Curve mesh_curve(const Comparison& comparison, std::size_t k) {
    const bool in_space = comparison.meshes[k].geometry == Geometry::spatial;
    return {.name = mesh_name(comparison, k),
            .kind = in_space ? Curve::Kind::points : Curve::Kind::line_and_points};
}

report::Figure profile_figure(const Comparison& comparison, const Profile& profile,
                              double largest) {
    const report::Unit length = report::fitting_unit(comparison.reference.contact_radius, "m");
    const report::Unit unit = report::fitting_unit(largest, "Pa");
    const char* axis = is_along_radius(comparison) ? "r" : "x";
    report::Figure figure{
        .id = profile.id,
        .title = fmt::format("{} over {}", profile.name, axis),
        .caption =
            "Line with its band: the reference and its bar. Points: the code's own values "
            "on each mesh, where it has them.",
        .x = {fmt::format("{} [{}]", axis, length.symbol)},
        .y = {fmt::format("{} [{}]", profile.symbol, unit.symbol)}};
    add_reference(comparison, profile, length.factor, unit.factor, figure);
    for (std::size_t k = 0; k < comparison.meshes.size(); ++k) {
        Curve curve = mesh_curve(comparison, k);
        const auto points = placed(comparison, comparison.meshes[k]);
        for (const std::size_t i : report::thinned(points.size(), most_points)) {
            const double value = points[i].second->values.*profile.of;
            if (std::isfinite(value))
                curve.add(points[i].first / length.factor, value / unit.factor);
        }
        if (!curve.x.empty()) figure.curves.push_back(std::move(curve));
    }
    return figure;
}

/// Load inside distances from the centre [N].
struct LoadWithin {
    std::vector<double> at, load;

    LoadWithin(const MeshResult& mesh, double reach) {
        mesh.geometry == Geometry::spatial ? add_squares(mesh, reach) : add_rings(mesh);
        const bool is_told = std::ranges::any_of(load, [](double sum) { return sum > 0; });
        if (!is_told) at.clear(), load.clear();
    }

  private:
    static double share_of(const SurfacePoint& point) {
        const double share = point.area * point.values.pressure;
        return std::isfinite(share) ? share : 0;
    }
    /// At each point, whose own load counts by half.
    void add_rings(const MeshResult& mesh) {
        std::vector<std::pair<double, double>> shares;
        for (const SurfacePoint& point : mesh.points)
            shares.emplace_back(std::abs(point.x), share_of(point));
        std::ranges::sort(shares);
        double sum = 0;
        for (const auto& [r, share] : shares) {
            at.push_back(r);
            load.push_back(sum + share / 2);
            sum += share;
        }
    }
    /// The load of a point is spread along the radius over the side of a square of its area: many
    /// points have one distance.
    void add_squares(const MeshResult& mesh, double reach) {
        constexpr int n = 80;
        for (int i = 1; i <= n; ++i) at.push_back(reach * i / n);
        load.assign(n, 0);
        for (const SurfacePoint& point : mesh.points) {
            const double share = share_of(point), side = std::sqrt(point.area);
            if (share == 0 || !(side > 0)) continue;
            const double begin = std::hypot(point.x, point.y) - side / 2;
            for (std::size_t i = 0; i < n; ++i)
                load[i] += share * std::clamp((at[i] - begin) / side, 0., 1.);
        }
    }
};

double force_of(const Comparison& comparison) {
    const Reference& reference = comparison.reference;
    const ReferenceValue* force = reference.find(quantity_keys::normal_force);
    return force ? force->value : reference.fields->load_within(2 * reference.contact_radius);
}

}  // namespace

std::vector<report::Figure> profile_figures(const Comparison& comparison) {
    std::vector<report::Figure> figures;
    if (!comparison.reference.fields) return figures;
    const double p0 = largest_of(comparison, pressure_profile);
    if (p0 > 0) figures.push_back(profile_figure(comparison, pressure_profile, p0));
    // Less is what is left of none.
    constexpr double least_traction = 1e-6;
    const double t0 = largest_of(comparison, traction_profile);
    if (t0 > least_traction * p0)
        figures.push_back(profile_figure(comparison, traction_profile, t0));
    return figures;
}

std::vector<report::Figure> load_figures(const Comparison& comparison) {
    if (!comparison.reference.fields) return {};
    const Reference& reference = comparison.reference;
    const double reach = drawn_reach * reference.contact_radius, force = force_of(comparison);
    const report::Unit length = report::fitting_unit(reference.contact_radius, "m");
    const bool plane = reference.geometry == Geometry::plane;
    const std::string axis =
        fmt::format("{} [{}]", plane ? "half width |x|" : "radius r", length.symbol);
    report::Figure load{
        .id = "load_within",
        .title = "Load inside a distance",
        .caption = "The integral of the pressure inside, over F_N of the reference.",
        .x = {axis},
        .y = {"load inside over F_N [-]"}};
    report::Figure difference{
        .id = "load_difference",
        .title = "Load inside a distance, difference",
        .caption =
            "Code minus reference; its largest magnitude is the norm that depends least on "
            "how nodal values are made.",
        .x = {axis},
        .y = {"difference over F_N [%]"}};
    Curve& exact =
        load.curves.emplace_back(Curve{.name = reference_name, .colour = report::measured_style});
    exact.sample(0, reach / length.factor, reference_points, [&](double at) {
        return reference.fields->load_within(at * length.factor) / force;
    });
    for (std::size_t k = 0; k < comparison.meshes.size(); ++k) {
        const LoadWithin within(comparison.meshes[k], reach);
        Curve curve = mesh_curve(comparison, k);
        curve.kind = Curve::Kind::line_and_points;
        Curve apart = curve;
        for (const std::size_t i : report::thinned(within.at.size(), most_points)) {
            const double r = within.at[i];
            if (r > reach) continue;
            curve.add(r / length.factor, within.load[i] / force);
            apart.add(r / length.factor,
                      100 * (within.load[i] - reference.fields->load_within(r)) / force);
        }
        if (curve.x.empty()) continue;
        load.curves.push_back(std::move(curve));
        difference.curves.push_back(std::move(apart));
    }
    if (difference.curves.empty()) return {};
    return {load, difference};
}

}  // namespace tricontact::benchmarks
