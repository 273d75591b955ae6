// Differences over the contact plane.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "benchmarks/report/comparison_figures.h"
#include "benchmarks/report/comparison_words.h"
#include "report/format.h"

namespace tricontact::benchmarks {

namespace {

constexpr int n_drawn = 61;            // points of the map along each axis
constexpr double map_reach = 1.25;     // over a
constexpr double nearest_share = .75;  // of a mesh's size: farther off a map has no value

/// Points of a mesh in square bins of the map's own reach.
class Bins {
  public:
    Bins(const std::vector<SurfacePoint>& points, double reach, double size)
        : points_(points),
          reach_(reach),
          n_(std::clamp(static_cast<int>(2 * reach / size), 1, 400)) {
        bins_.resize(static_cast<std::size_t>(n_) * n_);
        for (std::size_t i = 0; i < points.size(); ++i)
            if (std::abs(points[i].x) <= reach && std::abs(points[i].y) <= reach)
                bins_[place(column(points[i].x), column(points[i].y))].push_back(i);
    }
    /// The nearest point of the neighbouring bins within a distance; null if there is none.
    const SurfacePoint* nearest(double x, double y, double within) const {
        const SurfacePoint* found = nullptr;
        double least = within;
        for (int j = std::max(0, column(y) - 1); j <= std::min(n_ - 1, column(y) + 1); ++j)
            for (int i = std::max(0, column(x) - 1); i <= std::min(n_ - 1, column(x) + 1); ++i)
                for (const std::size_t k : bins_[place(i, j)]) {
                    const double distance = std::hypot(points_[k].x - x, points_[k].y - y);
                    if (distance <= least) least = distance, found = &points_[k];
                }
        return found;
    }

  private:
    int column(double x) const {
        return std::clamp(static_cast<int>((x + reach_) / (2 * reach_) * n_), 0, n_ - 1);
    }
    std::size_t place(int i, int j) const { return static_cast<std::size_t>(j) * n_ + i; }

    const std::vector<SurfacePoint>& points_;
    double reach_;
    int n_;
    std::vector<std::vector<std::size_t>> bins_;
};

struct MappedField {
    const char *id, *name, *symbol;
    double SurfaceValues::*of;
};

double largest_value(const Comparison& comparison, double SurfaceValues::*of) {
    double largest = 0;
    for (const SurfacePoint& point : comparison.meshes.back().points) {
        const double value = comparison.reference.fields->at(point.x, point.y).*of;
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
    return largest;
}

report::Figure map_of_difference(const Comparison& comparison, const MappedField& field,
                                 double unit) {
    const MeshResult& mesh = comparison.meshes.back();
    const double a = comparison.reference.contact_radius, reach = map_reach * a;
    const Bins bins(mesh.points, reach * (1 + 1. / n_drawn), mesh.size);
    report::ContourMap map{
        .label = fmt::format("{0} difference over largest {0} [%]", field.symbol),
        .x = {},
        .y = {},
        .values = {}};
    for (int i = 0; i < n_drawn; ++i)
        map.x.push_back(map_reach * (2. * i / (n_drawn - 1) - 1)), map.y.push_back(map.x.back());
    for (const double y : map.y)
        for (const double x : map.x) {
            const SurfacePoint* point = bins.nearest(x * a, y * a, nearest_share * mesh.size);
            const double apart =
                point ? point->values.*field.of -
                            comparison.reference.fields->at(point->x, point->y).*field.of
                      : std::numeric_limits<double>::quiet_NaN();
            map.values.push_back(100 * apart / unit);
        }
    return {.id = fmt::format("difference_{}", field.id),
            .title = fmt::format("Difference of the {} over the contact", field.name),
            .caption =
                "Code minus reference on the finest mesh, at the code's own points; over "
                "the largest value of the reference. Empty: no point of the code near.",
            .x = {"x/a", false, -map_reach, map_reach},
            .y = {"y/a", false, -map_reach, map_reach},
            .map = std::move(map),
            .equal_scales = true};
}

}  // namespace

std::vector<report::Figure> difference_maps(const Comparison& comparison) {
    std::vector<report::Figure> figures;
    const bool is_drawn = comparison.reference.fields && !comparison.meshes.empty() &&
                          comparison.meshes.back().geometry == Geometry::spatial &&
                          comparison.meshes.back().size > 0;
    if (!is_drawn) return figures;
    const auto is_told = [&](double SurfaceValues::*of) {
        return std::ranges::any_of(comparison.meshes.back().points, [of](const SurfacePoint& one) {
            return std::isfinite(one.values.*of);
        });
    };
    constexpr double least = 1e-6;  // of p0: less is what is left of no traction
    const double p0 = largest_value(comparison, &SurfaceValues::pressure);
    for (const MappedField& field :
         {MappedField{"pressure", "pressure", "p", &SurfaceValues::pressure},
          MappedField{"traction_x", "traction along x", "t_x", &SurfaceValues::traction_x},
          MappedField{"traction_y", "traction along y", "t_y", &SurfaceValues::traction_y}}) {
        const double unit = largest_value(comparison, field.of);
        if (unit > least * p0 && is_told(field.of))
            figures.push_back(map_of_difference(comparison, field, unit));
    }
    return figures;
}

}  // namespace tricontact::benchmarks
