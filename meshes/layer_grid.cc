#include "meshes/layer_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "meshes/grading.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

constexpr const char* name = "layer mesh";
// Lengths this near to each other (relative) are equal: decimal input is not exact in binary.
constexpr double equal = 1e-9;
constexpr double most_elements = 1e7;  // about 10 GB in gmsh

// Slower than sideways: strains vary most with the depth.
double depth_growth(const LayerMeshSpec& spec) {
    return std::pow(spec.growth, 0.8);
}

void check_lengths(const LayerMeshSpec& spec) {
    auto positive = [](const char* what, double value) {
        if (!(value > 0) || !std::isfinite(value))
            fail(name, fmt::format("{} is {:g} m", what, value), "make it a positive length");
    };
    positive("size", spec.size);
    positive("patch_x", spec.patch_x);
    positive("patch_y", spec.patch_y);
    positive("half_x", spec.half_x);
    positive("half_y", spec.half_y);
    positive("thickness", spec.thickness);
    if (!(spec.lower_thickness >= 0) || !std::isfinite(spec.lower_thickness))
        fail(name, fmt::format("lower_thickness is {:g} m", spec.lower_thickness),
             "make it a positive length, or 0 for a single layer");
    if (!(spec.growth >= 1) || !std::isfinite(spec.growth))
        fail(name, fmt::format("growth is {:g}", spec.growth), "make it 1 or more");
}

void check_patch(const char* axis, double size, double patch, double half) {
    const double n = patch / size;
    if (!(n > 0.5) || std::abs(n - std::round(n)) > equal * n)
        fail(name,
             fmt::format("patch_{} is {:.9g} m, which is {:.9g} elements of size {:.9g} m", axis,
                         patch, n, size),
             "make it a whole multiple of size");
    if (!(half >= patch * (1 - equal)))
        fail(
            name,
            fmt::format("half_{0} is {1:.9g} m, less than patch_{0}, {2:.9g} m", axis, half, patch),
            "widen the block or shrink the patch");
}

// Length of the strip beside a patch [m]; 0 if they differ by rounding only.
double side_length(double size, double patch, double half) {
    const double length = half - std::round(patch / size) * size;
    return length > equal * half ? length : 0;
}

// Before anything is allocated: numbers beyond any int are possible.
void check_count(const LayerMeshSpec& s) {
    auto sideways = [&](double patch, double half, double halves) {
        return halves * (std::round(patch / s.size) +
                         graded_count(side_length(s.size, patch, half), s.size, s.growth));
    };
    double depth = graded_count(s.thickness, s.size, depth_growth(s));
    double n =
        sideways(s.patch_x, s.half_x, 2) * sideways(s.patch_y, s.half_y, s.half_model ? 1 : 2);
    if (n * depth <= most_elements) {
        const Grading layer = grade(s.thickness, s.size, depth_growth(s));
        const std::vector<double> nodes = layer.nodes();
        depth +=
            graded_count(s.lower_thickness, nodes.back() - nodes[layer.n - 1], depth_growth(s));
    }
    if (!(n * depth <= most_elements))
        fail(name,
             fmt::format("size {:g} m makes {:.3g} elements, more than {:g}", s.size, n * depth,
                         most_elements),
             "use a larger size, a smaller patch or a larger growth");
}

// Patch and strip beside it, from 0 outwards; mirrored if `both` sides are wanted.
GridAxis lateral_axis(const LayerMeshSpec& spec, double patch, double half, bool both) {
    GridAxis axis;
    const int n_patch = static_cast<int>(std::lround(patch / spec.size));
    const Grading side = grade(side_length(spec.size, patch, half), spec.size, spec.growth);
    for (int i = both ? -n_patch : 0; i <= n_patch; ++i) axis.nodes.push_back(i * spec.size);
    axis.planes = {axis.nodes.front(), axis.nodes.back()};
    axis.strips = {{axis.n_elements(), 1}};
    if (side.n == 0) return axis;

    const double edge = n_patch * spec.size;
    std::vector<double> outer;
    for (const double distance : side.nodes()) outer.push_back(edge + distance);
    outer.back() = half;
    axis.nodes.insert(axis.nodes.end(), outer.begin() + 1, outer.end());
    axis.planes.push_back(half);
    axis.strips.push_back({side.n, side.ratio});
    if (!both) return axis;

    std::vector<double> mirrored;
    for (std::size_t i = outer.size() - 1; i > 0; --i) mirrored.push_back(-outer[i]);
    axis.nodes.insert(axis.nodes.begin(), mirrored.begin(), mirrored.end());
    axis.planes.insert(axis.planes.begin(), -half);
    axis.strips.insert(axis.strips.begin(), {side.n, 1 / side.ratio});
    return axis;
}

GridAxis depth_axis(const LayerMeshSpec& spec) {
    const double growth = depth_growth(spec);
    std::vector<double> depths{0}, planes{0};
    GridAxis axis;
    double first = spec.size;
    for (const double thickness : {spec.thickness, spec.lower_thickness}) {
        const Grading strip = grade(thickness, first, growth);
        if (strip.n == 0) continue;
        for (const double distance : strip.nodes())
            if (distance > 0) depths.push_back(planes.back() + distance);
        planes.push_back(depths.back());
        axis.strips.push_back({strip.n, 1 / strip.ratio});
        first = depths.back() - depths[depths.size() - 2];
    }
    auto ascending = [](const std::vector<double>& downwards) {
        std::vector<double> upwards;
        // 0 - d, not -d: the surface is +0.
        std::transform(downwards.rbegin(), downwards.rend(), std::back_inserter(upwards),
                       [](double depth) { return 0 - depth; });
        return upwards;
    };
    std::reverse(axis.strips.begin(), axis.strips.end());
    axis.planes = ascending(planes);
    axis.nodes = ascending(depths);
    return axis;
}

}  // namespace

LayerGrid layer_grid(const LayerMeshSpec& spec) {
    check_lengths(spec);
    check_patch("x", spec.size, spec.patch_x, spec.half_x);
    check_patch("y", spec.size, spec.patch_y, spec.half_y);
    check_count(spec);
    LayerGrid grid;
    grid.axes = {lateral_axis(spec, spec.patch_x, spec.half_x, true),
                 lateral_axis(spec, spec.patch_y, spec.half_y, !spec.half_model), depth_axis(spec)};
    grid.patch_x = grid.axes[0].n_strips() > 1 ? 1 : 0;
    grid.patch_y = grid.axes[1].n_strips() > 1 && !spec.half_model ? 1 : 0;
    grid.layer = grid.axes[2].n_strips() - 1;
    return grid;
}

}  // namespace tricontact::meshes
