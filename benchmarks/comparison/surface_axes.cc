#include "benchmarks/comparison/surface_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "benchmarks/comparison/contact_reach.h"
#include "benchmarks/comparison/tributary_areas.h"

namespace tricontact::benchmarks {

namespace {

// A centre of pressure that lies nearer is that of the reference: what coarse meshes leave.
constexpr double least_shift = .01;  // of a
// Correlations of fields that are one field are near 1; half of that decides.
constexpr double least_correlation = .3;

struct Moments {
    double x = 0, y = 0;
};

Moments centre(const MeshResult& mesh, const Reference& reference, const Moments& at,
               bool of_reference) {
    double load = 0, x = 0, y = 0;
    for (const SurfacePoint& p : mesh.points) {
        const double f =
            p.area * (of_reference ? reference.fields->at(p.x - at.x, p.y - at.y).pressure
                                   : p.values.pressure);
        load += f;
        x += f * (p.x - (of_reference ? at.x : 0));
        y += f * (p.y - (of_reference ? at.y : 0));
    }
    return load != 0 ? Moments{x / load, y / load} : Moments{};
}

void move_to_centre(Understanding& all, const Reference& reference, const ContactReach& reach) {
    const MeshResult& finest = all.meshes.back().result;
    if (finest.geometry == Geometry::axisymmetric) return;
    const bool moves_x = reach.parts_x == 1,
               moves_y = reach.parts_y == 1 && finest.geometry == Geometry::spatial;
    const Moments code = centre(finest, reference, {}, false);
    Moments shift{moves_x ? code.x : 0, moves_y ? code.y : 0};
    const Moments own = centre(finest, reference, shift, true);
    if (moves_x) shift.x -= own.x;
    if (moves_y) shift.y -= own.y;
    const double a = reference.contact_radius;
    if (std::hypot(shift.x, shift.y) < least_shift * a) return;
    for (UnderstoodMesh& mesh : all.meshes) {
        for (SurfacePoint& p : mesh.result.points) {
            p.x -= shift.x;
            p.y -= shift.y;
        }
        for (double& v : mesh.low) v -= shift.x;
        for (double& v : mesh.high) v -= shift.x;
    }
    all.conventions.push_back(
        {"origin",
         fmt::format("the contact's centre is at ({:.4g}, {:.4g}) mm in the file", shift.x * 1e3,
                     shift.y * 1e3),
         "centre of pressure, beside that of the reference"});
}

/// Correlation of two fields over a mesh [-1, 1].
template <class One, class Other>
double correlation(const MeshResult& mesh, const One& one, const Other& other) {
    double ab = 0, aa = 0, bb = 0;
    for (const SurfacePoint& p : mesh.points) {
        const double a = one(p), b = other(p);
        if (!std::isfinite(a) || !std::isfinite(b)) continue;
        ab += p.area * a * b;
        aa += p.area * a * a;
        bb += p.area * b * b;
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

void turn_tractions(Understanding& all, const Reference& reference) {
    const MeshResult& finest = all.meshes.back().result;
    if (!reference.has_friction()) return;
    const auto code_x = [](const SurfacePoint& p) { return p.values.traction_x; };
    const auto code_y = [](const SurfacePoint& p) { return p.values.traction_y; };
    const auto reference_x = [&](const SurfacePoint& p) {
        return reference.fields->at(p.x, p.y).traction_x;
    };
    const double along = correlation(finest, code_x, reference_x);
    const double across = correlation(finest, code_y, reference_x);
    const bool is_swapped =
        std::abs(across) > std::abs(along) && std::abs(across) > least_correlation;
    const double decides = is_swapped ? across : along;
    const double sign = decides < -least_correlation ? -1 : 1;
    if (!is_swapped && sign > 0) return;
    for (UnderstoodMesh& mesh : all.meshes)
        for (SurfacePoint& p : mesh.result.points) {
            if (is_swapped) std::swap(p.values.traction_x, p.values.traction_y);
            p.values.traction_x *= sign;
            p.values.traction_y *= sign;
        }
    all.conventions.push_back(
        {"axes",
         fmt::format("tangential tractions {}{}", is_swapped ? "have their axes exchanged" : "",
                     sign < 0 ? std::string(is_swapped ? ", and " : "") +
                                    "are those on the other body, or against our axes"
                              : ""),
         fmt::format("correlation with the reference's {:.3f}", decides)});
}

/// Displacements along an axis have the sign and the axes of the reference.
void turn_displacements(Understanding& all, const Reference& reference) {
    const MeshResult& finest = all.meshes.back().result;
    const double normal = correlation(
        finest, [](const SurfacePoint& p) { return p.values.displacement_z; },
        [&](const SurfacePoint& p) { return reference.fields->at(p.x, p.y).displacement_z; });
    if (normal >= -least_correlation) return;
    for (UnderstoodMesh& mesh : all.meshes)
        for (SurfacePoint& p : mesh.result.points)
            p.values.displacement_z = -p.values.displacement_z;
    all.conventions.push_back({"displacements", "normal displacements count out of the body",
                               fmt::format("correlation with the reference's {:.3f}", normal)});
}

/// Share of the indenter's height that the points' heights follow in the contact: 1 of deformed
/// positions, 0 of undeformed ones.
double followed_share(const UnderstoodMesh& mesh, const contact::Indenter& body) {
    double most = 0, n = 0, mean_h = 0, mean_z = 0;
    for (const SurfacePoint& p : mesh.result.points) most = std::max(most, p.values.pressure);
    const auto touched = [&](const SurfacePoint& p) { return p.values.pressure > .05 * most; };
    const auto& points = mesh.result.points;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (touched(points[i])) {
            ++n;
            mean_h += body.height(points[i].x, points[i].y);
            mean_z += mesh.height[i];
        }
    if (n < 3) return 0;
    double hz = 0, hh = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (touched(points[i])) {
            const double h = body.height(points[i].x, points[i].y) - mean_h / n;
            hz += h * (mesh.height[i] - mean_z / n);
            hh += h * h;
        }
    return hh > 0 ? std::abs(hz) / hh : 0;
}

/// Stretches and areas of points that were moved.
void measure_again(UnderstoodMesh& mesh, double parts) {
    std::vector<double> x, y;
    for (const SurfacePoint& p : mesh.result.points) {
        x.push_back(p.x);
        y.push_back(p.y);
    }
    std::vector<double> areas(x.size());
    if (mesh.result.geometry == Geometry::spatial) {
        if (mesh.result.faces.size() == 0) return;  // areas are the file's
        areas = lumped_areas(x, y, mesh.result.faces);
    } else {
        const bool is_ring = mesh.result.geometry == Geometry::axisymmetric;
        const LineCells cells = line_cells(x, is_ring);
        const std::vector<int> n = sharers(x);
        mesh.low = cells.low;
        mesh.high = cells.high;
        for (std::size_t i = 0; i < x.size(); ++i)
            areas[i] = stretch_weight(cells.low[i], cells.high[i], is_ring) / n[i];
    }
    for (std::size_t i = 0; i < x.size(); ++i) mesh.result.points[i].area = parts * areas[i];
}

/// Points that stand where the body has moved them go back by their displacement along the surface,
/// the code's own or, where it has none, the reference's.
void undo_deformation(Understanding& all, const Reference& reference, const ContactReach& reach) {
    const UnderstoodMesh& finest = all.meshes.back();
    if (finest.height.size() != finest.result.points.size() || finest.height.empty()) return;
    const double share = followed_share(finest, *reference.c.make_indenter());
    if (share < .5) return;
    for (UnderstoodMesh& mesh : all.meshes) {
        for (SurfacePoint& p : mesh.result.points) {
            const double x = p.x, y = p.y;
            for (int k = 0; k < 3; ++k) {  // displacements are those of the undeformed place
                const SurfaceValues known = reference.fields->at(p.x, p.y);
                const double u = std::isfinite(p.values.displacement_x) ? p.values.displacement_x
                                                                        : known.displacement_x;
                const double v = std::isfinite(p.values.displacement_y) ? p.values.displacement_y
                                                                        : known.displacement_y;
                if (std::isfinite(u)) p.x = x - u;
                if (std::isfinite(v)) p.y = y - v;
            }
        }
        measure_again(mesh, reach.parts());
    }
    all.conventions.push_back(
        {"deformed", "positions are those of the deformed surface; they were set back",
         fmt::format("heights of the points follow {:.2f} of the indenter's", share)});
}

}  // namespace

void turn_to_reference(Understanding& all, const Reference& reference, const ContactReach& reach) {
    if (!reference.fields) return;
    undo_deformation(all, reference, reach);
    move_to_centre(all, reference, reach);
    turn_tractions(all, reference);
    turn_displacements(all, reference);
}

}  // namespace tricontact::benchmarks
