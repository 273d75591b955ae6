#include "benchmarks/comparison/mesh_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "benchmarks/comparison/surface_layout.h"
#include "statistics/estimate.h"

namespace tricontact::benchmarks {

namespace {

// Numbers of points come in whole rows: a few per cent of the power that a family has.
constexpr double power_tolerance = .35;
// The edge counts as alike on all meshes within so much of a spacing.
constexpr double edge_tolerance = .12;

/// Distances of neighbouring places along a profile, or the root of the median area; 0 of none.
double spacing(const MeshResult& mesh, double within) {
    if (mesh.geometry == Geometry::spatial) {
        std::vector<double> areas;
        for (const SurfacePoint& p : mesh.points)
            if (p.area > 0 && std::hypot(p.x, p.y) < within) areas.push_back(p.area);
        return areas.empty() ? 0 : std::sqrt(statistics::median(std::move(areas)));
    }
    std::vector<double> x, steps;
    for (const SurfacePoint& p : mesh.points)
        if (std::abs(p.x) < within) x.push_back(p.x);
    std::ranges::sort(x);
    for (std::size_t i = 1; i < x.size(); ++i)
        if (x[i] - x[i - 1] > 1e-6 * within) steps.push_back(x[i] - x[i - 1]);
    return steps.empty() ? 0 : statistics::median(std::move(steps));
}

int touched_points(const MeshResult& mesh, double radius) {
    int n = 0;
    for (const SurfacePoint& p : mesh.points)
        n += (mesh.geometry == Geometry::spatial ? std::hypot(p.x, p.y) : std::abs(p.x)) <= radius;
    return n;
}

}  // namespace

double mesh_size(const MeshField& field, const MeshResult& mesh, double unit) {
    const auto stated = field.totals.find("size");
    if (stated != field.totals.end())
        return stated->second.value * (stated->second.unit ? 1 : unit);
    double reach = 0, most = 0;
    for (const SurfacePoint& p : mesh.points) most = std::max(most, p.values.pressure);
    for (const SurfacePoint& p : mesh.points)
        if (p.values.pressure > touched_share * most) reach = std::max(reach, std::hypot(p.x, p.y));
    return spacing(mesh, reach);
}

MeshFamily mesh_family(const Submission& submission, const std::vector<MeshResult>& meshes,
                       const Reference& reference) {
    MeshFamily family;
    if (meshes.size() < 3) {
        family.why_not = fmt::format("{} mesh{}: an order needs three", meshes.size(),
                                     meshes.size() == 1 ? "" : "es");
        return family;
    }
    const double a = reference.contact_radius;
    family.is_family = true;
    for (std::size_t k = 0; k + 1 < meshes.size(); ++k) {
        const MeshResult &coarse = meshes[k], &fine = meshes[k + 1];
        const double finer = coarse.size / fine.size;
        if (!(finer > 1.02)) {
            family.is_family = false;
            family.why_not = fmt::format("{} and {} are of one size, {:.4g} mm", coarse.file,
                                         fine.file, fine.size * 1e3);
            return family;
        }
        const auto compare = [&](double n_coarse, double n_fine, int dimension, const char* what) {
            if (!(n_coarse > 0) || !(n_fine > 0) || !family.is_family) return;
            const double power = std::log(n_fine / n_coarse) / std::log(finer);
            if (std::abs(power - dimension) <= power_tolerance * dimension) return;
            family.is_family = false;
            family.why_not = fmt::format(
                "from {} to {} the size falls by {:.3g} and the number of {} grows by {:.3g}, "
                "where a "
                "family has {:.3g}",
                coarse.file, fine.file, finer, what, n_fine / n_coarse, std::pow(finer, dimension));
        };
        const int dimension = fine.geometry == Geometry::spatial ? 2 : 1;
        const int n_coarse = touched_points(coarse, a), n_fine = touched_points(fine, a);
        if (n_coarse >= 4 * dimension)
            compare(n_coarse, n_fine, dimension, "points in the contact");
        const auto elements_of = [&](const std::string& file) -> double {
            for (const MeshField& field : submission.meshes)
                if (field.file == file) return field.n_elements;
            return 0;
        };
        compare(elements_of(coarse.file), elements_of(fine.file), dimension + 1, "elements");
    }
    for (const MeshResult& mesh : meshes) {
        if (mesh.points.empty() || mesh.geometry == Geometry::spatial) continue;
        const double h = spacing(mesh, 1.5 * a);
        double inside = 0;
        for (const SurfacePoint& p : mesh.points)
            if (std::abs(p.x) <= a * (1 + 1e-4)) inside = std::max(inside, std::abs(p.x));
        double place = h > 0 ? (a - inside) / h : 0;
        if (place > 1 - edge_tolerance / 4) place -= 1;
        family.edge_places.push_back(place);
    }
    if (!family.edge_places.empty()) {
        const auto [low, high] = std::ranges::minmax(family.edge_places);
        family.edges_alike = high - low < edge_tolerance;
    }
    return family;
}

}  // namespace tricontact::benchmarks
