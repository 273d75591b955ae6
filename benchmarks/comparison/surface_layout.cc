#include "benchmarks/comparison/surface_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

using contact::InputError;

// The height of a body over the contact's radius is a/(2 R): shallow contacts stay below it.
constexpr double height_share = .2;
// Of a pin in a hole it is tan(angle/2): up to 38 degrees.
constexpr double height_share_of_lines = .35;

struct Axis {
    Meaning meaning = Meaning::x;
    const char* name = "x";
    const FieldColumn* column = nullptr;
    double spread = 0;
};

const FieldColumn* first_of(const MeshField& field, std::initializer_list<Meaning> meanings) {
    for (const Meaning m : meanings)
        if (const FieldColumn* column = field.find(m)) return column;
    return nullptr;
}

/// Points whose normal load counts; all where no column says it without an axis.
std::vector<std::size_t> touched_points(const MeshField& field) {
    std::vector<std::size_t> points;
    const FieldColumn* column = first_of(field, {Meaning::pressure, Meaning::force_normal});
    double most = 0;
    if (column)
        for (const double v : column->values) most = std::max(most, std::abs(v));
    for (std::size_t i = 0; i < field.size(); ++i)
        if (!column || std::abs(column->values[i]) > touched_share * most) points.push_back(i);
    return points;
}

std::vector<Axis> axes_of(const MeshField& field) {
    std::vector<Axis> axes{{Meaning::x, "x", nullptr, 0},
                           {Meaning::y, "y", nullptr, 0},
                           {Meaning::z, "z", nullptr, 0}};
    const auto points = touched_points(field);
    for (Axis& axis : axes) {
        axis.column = field.find(axis.meaning);
        if (!axis.column || points.empty()) continue;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const std::size_t i : points) {
            low = std::min(low, axis.column->values[i]);
            high = std::max(high, axis.column->values[i]);
        }
        axis.spread = high - low;
    }
    std::erase_if(axes, [](const Axis& a) { return !a.column; });
    return axes;
}

Meaning component(Meaning first, Meaning axis) {
    const int k = static_cast<int>(axis) - static_cast<int>(Meaning::x);
    return static_cast<Meaning>(static_cast<int>(first) + k);
}

/// The axis that is neither the layout's x nor its y.
Meaning height_axis(const SurfaceLayout& layout) {
    if (layout.geometry == Geometry::spatial) {
        for (const Meaning m : {Meaning::x, Meaning::y, Meaning::z})
            if (m != layout.x_axis && m != layout.y_axis) return m;
    }
    return layout.y_axis;
}

}  // namespace

SurfaceLayout surface_layout(const MeshField& field, Geometry problem) {
    SurfaceLayout layout;
    if (const FieldColumn* r = field.find(Meaning::r)) {
        if (problem != Geometry::axisymmetric)
            throw InputError(
                fmt::format("{}: column {}: the problem has no axis; give positions as x{}",
                            field.file, r->heading, problem == Geometry::spatial ? " and y" : ""));
        layout.geometry = Geometry::axisymmetric;
        layout.x = r->values;
        layout.unit = r->unit;
        layout.text = "profile over r";
        layout.x_axis = Meaning::r;
        const FieldColumn* z = first_of(field, {Meaning::z, Meaning::y});
        layout.y_axis = z ? z->meaning : Meaning::z;
        if (z) layout.height = z->values;
        return layout;
    }
    std::vector<Axis> axes = axes_of(field);
    if (axes.empty())
        throw InputError(field.file +
                         ": no positions: a column of them is missing; name it r, x or y");
    // Stable: equal spreads keep the order x, y, z.
    std::ranges::stable_sort(axes, std::greater<>(), &Axis::spread);
    const double flat = problem == Geometry::plane ? height_share_of_lines : height_share;
    const bool is_profile = axes.size() == 1 || axes[1].spread < flat * axes[0].spread;
    if (is_profile && problem == Geometry::spatial)
        throw InputError(
            fmt::format("{}: the points lie along {}: the problem's fields vary over a surface; "
                        "give points with "
                        "two coordinates",
                        field.file, axes[0].name));
    if (!is_profile && axes[1].meaning < axes[0].meaning) std::swap(axes[0], axes[1]);
    layout.geometry = is_profile ? problem : Geometry::spatial;
    layout.x = axes[0].column->values;
    layout.unit = axes[0].column->unit;
    layout.x_axis = axes[0].meaning;
    const std::size_t at_height = is_profile ? 1 : 2;
    if (is_profile) {
        layout.y_axis = axes.size() > 1 ? axes[1].meaning : Meaning::z;
        layout.text = fmt::format("profile along {}", axes[0].name);
    } else {
        layout.y = axes[1].column->values;
        layout.y_axis = axes[1].meaning;
        layout.text = fmt::format("surface over {} and {}", axes[0].name, axes[1].name);
    }
    if (axes.size() > at_height) layout.height = axes[at_height].column->values;
    return layout;
}

std::optional<bool> says_force(const FieldColumn& column) {
    using enum Meaning;
    constexpr std::array forces{force_normal, force_x, force_y, force_z};
    constexpr std::array stresses{stress_zz, stress_xz, stress_yz};
    if (std::ranges::find(forces, column.meaning) != forces.end()) return true;
    if (std::ranges::find(stresses, column.meaning) != stresses.end()) return false;
    if (column.unit) return false;  // the reader has checked its dimension
    return {};
}

const FieldColumn& normal_column(const MeshField& field, const SurfaceLayout& layout) {
    const Meaning height = height_axis(layout);
    const FieldColumn* found = first_of(
        field, {Meaning::pressure, Meaning::force_normal, component(Meaning::traction_x, height),
                component(Meaning::force_x, height), Meaning::stress_zz});
    if (!found)
        throw InputError(field.file +
                         ": no normal load: a column of contact pressures or of nodal forces is "
                         "missing; name it p, CPRESS or fn");
    return *found;
}

TangentialColumns tangential_columns(const MeshField& field, const SurfaceLayout& layout) {
    TangentialColumns found;
    const bool is_spatial = layout.geometry == Geometry::spatial;
    const Meaning along = layout.x_axis == Meaning::r ? Meaning::x : layout.x_axis;
    found.x = first_of(field, {component(Meaning::traction_x, along),
                               component(Meaning::force_x, along), Meaning::stress_xz});
    if (is_spatial)
        found.y = first_of(field, {component(Meaning::traction_x, layout.y_axis),
                                   component(Meaning::force_x, layout.y_axis), Meaning::stress_yz});
    return found;
}

}  // namespace tricontact::benchmarks
