#include "meshes/layer_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/base/special_values.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

constexpr const char* grid_name = "layer mesh";
// Lengths this near to each other (relative) are equal: decimal input is not exact in binary.
constexpr double equal = 1e-9;
constexpr double most_elements = 1e7;  // about 10 GB in gmsh

void check_lengths(const LayerMeshSpec& spec) {
    auto positive = [](const char* what, double value) {
        if (!contact::is_positive_and_finite(value))
            fail(grid_name, fmt::format("{} is {:g} m", what, value), "make it a positive length");
    };
    positive("size", spec.size);
    positive("patch_x", spec.patch_x);
    positive("patch_y", spec.patch_y);
    positive("half_x", spec.half_x);
    positive("half_y", spec.half_y);
    positive("thickness", spec.thickness);
    if (!(spec.lower_thickness >= 0) || !std::isfinite(spec.lower_thickness))
        fail(grid_name, fmt::format("lower_thickness is {:g} m", spec.lower_thickness),
             "make it a positive length, or 0 for a single layer");
    if (!(spec.growth >= 1) || !std::isfinite(spec.growth))
        fail(grid_name, fmt::format("growth is {:g}", spec.growth), "make it 1 or more");
}

void check_patch(const char* axis, double size, double patch, double half) {
    const double n = patch / size;
    if (!(n > 0.5) || std::abs(n - std::round(n)) > equal * n)
        fail(grid_name,
             fmt::format("patch_{} is {:.9g} m, which is {:.9g} elements of size {:.9g} m", axis,
                         patch, n, size),
             "make it a whole multiple of size");
    if (!(half >= patch * (1 - equal)))
        fail(
            grid_name,
            fmt::format("half_{0} is {1:.9g} m, less than patch_{0}, {2:.9g} m", axis, half, patch),
            "widen the block or shrink the patch");
}

void check_across(const LayerMeshSpec& spec) {
    if ((spec.plane_strain || spec.ends) && !spec.half_model)
        fail(grid_name, "a slice or a graded patch without half_model", "set half_model");
    if (!spec.plane_strain && !spec.ends)
        return check_patch("y", spec.size, spec.patch_y, spec.half_y);
    if (!(spec.half_y >= spec.patch_y * (1 - equal)) ||
        (spec.plane_strain && spec.half_y > spec.patch_y * (1 + equal)))
        fail(grid_name,
             fmt::format("half_y is {:.9g} m, patch_y {:.9g} m", spec.half_y, spec.patch_y),
             "a slice is all patch, a graded patch not wider than the block");
    if (!spec.ends) return;
    const auto& [size, length] = *spec.ends;
    if (!contact::is_positive_and_finite(size) || !(length >= 0) || !(length < spec.patch_y))
        fail(grid_name, fmt::format("ends of the size {:g} m over {:g} m", size, length),
             "give a positive size and a length shorter than patch_y");
}

// A length between two others [m]; 0 if these differ by rounding only.
double between(double inner, double outer) {
    return outer - inner > equal * outer ? outer - inner : 0;
}

// Length of the strip beside a patch [m].
double side_length(double size, double patch, double half) {
    return between(std::round(patch / size) * size, half);
}

// Elements from the middle of a patch to one side of the block.
double half_count(const LayerMeshSpec& s, double patch, double half) {
    return std::round(patch / s.size) +
           graded_count(side_length(s.size, patch, half), s.size, s.growth);
}

double elements_at_ends(const LayerMeshSpec::Ends& ends) {
    return std::ceil(ends.length / ends.size * (1 - equal));
}

// Elements along y.
double count_across(const LayerMeshSpec& s) {
    if (s.plane_strain) return 1;
    if (!s.ends) return (s.half_model ? 1 : 2) * half_count(s, s.patch_y, s.half_y);
    return graded_count(s.patch_y - s.ends->length, s.ends->size, s.growth) +
           elements_at_ends(*s.ends) +
           graded_count(between(s.patch_y, s.half_y), s.ends->size, s.growth);
}

// Before anything is allocated: numbers beyond any int are possible.
void check_count(const LayerMeshSpec& s) {
    double depth = graded_count(s.thickness, s.size, depth_growth(s.growth));
    double n = 2 * half_count(s, s.patch_x, s.half_x) * count_across(s);
    if (n * depth <= most_elements) {
        const Grading layer = grade(s.thickness, s.size, depth_growth(s.growth));
        const std::vector<double> nodes = layer.nodes();
        depth += graded_count(s.lower_thickness, nodes.back() - nodes[layer.n - 1],
                              depth_growth(s.growth));
    }
    if (!(n * depth <= most_elements))
        fail(grid_name,
             fmt::format("size {:g} m makes {:.3g} elements, more than {:g}", s.size, n * depth,
                         most_elements),
             "use a larger size, a smaller patch or a larger growth");
}

// A strip beyond the axis' last plane, to end at `end`; none of no elements.
void add(const Grading& strip, double end, GridAxis& axis) {
    if (strip.n == 0) return;
    const double begin = axis.planes.back();
    for (const double distance : strip.nodes())
        if (distance > 0) axis.nodes.push_back(begin + distance);
    axis.nodes.back() = end;
    axis.planes.push_back(end);
    axis.strips.push_back({strip.n, strip.ratio});
}

// Patch and strip beside it, from 0 outwards; mirrored if `both` sides are wanted.
GridAxis lateral_axis(const LayerMeshSpec& spec, double patch, double half, bool both) {
    GridAxis axis;
    const int n_patch = static_cast<int>(std::lround(patch / spec.size));
    const Grading side = grade(side_length(spec.size, patch, half), spec.size, spec.growth);
    for (int i = both ? -n_patch : 0; i <= n_patch; ++i) axis.nodes.push_back(i * spec.size);
    axis.planes = {axis.nodes.front(), axis.nodes.back()};
    axis.strips = {{axis.n_elements(), 1}};
    add(side, half, axis);
    if (side.n == 0 || !both) return axis;

    const std::vector<double> outer(axis.nodes.end() - side.n, axis.nodes.end());
    for (const double node : outer) axis.nodes.insert(axis.nodes.begin(), -node);
    axis.planes.insert(axis.planes.begin(), -half);
    axis.strips.insert(axis.strips.begin(), {side.n, 1 / side.ratio});
    return axis;
}

// From the middle outwards: the graded part of the patch, its ends, what lies beside it.
GridAxis graded_axis(const LayerMeshSpec& spec) {
    const auto& [size, length] = *spec.ends;
    const double straight = spec.patch_y - length;
    const Grading inner = grade(straight, size, spec.growth);
    GridAxis axis{.planes = {0, straight}, .strips = {{inner.n, 1 / inner.ratio}}, .nodes = {}};
    const std::vector<double> inwards = inner.nodes();
    std::transform(inwards.rbegin(), inwards.rend(), std::back_inserter(axis.nodes),
                   [&](double distance) { return straight - distance; });
    add({static_cast<int>(elements_at_ends(*spec.ends)), 1, length}, spec.patch_y, axis);
    add(grade(between(spec.patch_y, spec.half_y), size, spec.growth), spec.half_y, axis);
    return axis;
}

GridAxis across_axis(const LayerMeshSpec& spec) {
    if (spec.plane_strain)
        return {.planes = {0, spec.half_y}, .strips = {{1, 1}}, .nodes = {0, spec.half_y}};
    if (spec.ends) return graded_axis(spec);
    return lateral_axis(spec, spec.patch_y, spec.half_y, !spec.half_model);
}

GridAxis depth_axis(const LayerMeshSpec& spec) {
    const double growth = depth_growth(spec.growth);
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

double geometric_sum(int n, double r) {
    double sum = 0;
    for (int k = 0; k < n; ++k) sum = sum * r + 1;
    return sum;
}

// The sum grows with r.
double growth_ratio(int n, double total, double growth) {
    double low = 0, high = growth;
    for (;;) {
        const double middle = std::midpoint(low, high);
        if (middle == low || middle == high) return high;
        (geometric_sum(n, middle) < total ? low : high) = middle;
    }
}

double depth_growth(double growth) {
    return std::pow(growth, 0.8);
}

double graded_count(double length, double first, double growth) {
    const double total = length / first * (1 - equal);
    if (!(length > 0)) return 0;
    if (total <= 1 || total <= std::min(growth, 1 + 1 / growth)) return 1;
    const double excess = growth - 1;
    if (excess == 0) return std::ceil(total);
    // least n with (growth^n - 1)/(growth - 1) >= total
    return std::ceil(std::log1p(total * excess) / std::log1p(excess));
}

Grading grade(double length, double first, double growth) {
    Grading strip;
    strip.n = static_cast<int>(graded_count(length, first, growth));
    strip.length = length;
    if (strip.n > 1) strip.ratio = growth_ratio(strip.n, length / first, growth);
    if (strip.ratio < 1 / growth) strip.ratio = 1;
    return strip;
}

std::vector<double> Grading::nodes() const {
    if (n == 0) return {0};
    std::vector<double> distances{0};
    const double edge = length / geometric_sum(n, ratio);
    double sum = 0;
    for (int k = 1; k < n; ++k) {
        sum = sum * ratio + 1;  // geometric_sum(k, ratio)
        distances.push_back(edge * sum);
    }
    distances.push_back(length);
    return distances;
}

LayerGrid layer_grid(const LayerMeshSpec& spec) {
    check_lengths(spec);
    check_patch("x", spec.size, spec.patch_x, spec.half_x);
    check_across(spec);
    check_count(spec);
    LayerGrid grid;
    grid.axes = {lateral_axis(spec, spec.patch_x, spec.half_x, true), across_axis(spec),
                 depth_axis(spec)};
    grid.patch_x = grid.axes[0].n_strips() > 1 ? 1 : 0;
    grid.patch_y = grid.axes[1].n_strips() > 1 && !spec.half_model ? 1 : 0;
    grid.last_patch_y = grid.patch_y + (spec.ends && spec.ends->length > 0 ? 1 : 0);
    grid.symmetric_low = spec.half_model;
    grid.symmetric_high = spec.plane_strain;
    grid.layer = grid.axes[2].n_strips() - 1;
    return grid;
}

}  // namespace tricontact::meshes
