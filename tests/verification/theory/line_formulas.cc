// The lines of cylinders in the table of docs/explanation/atlas-formulas.md.
#include <gtest/gtest.h>

#include <functional>

#include "atlas/map_coordinates.h"
#include "contact/half_space_scales.h"
#include "formula_table.h"
#include "theory/layer/line_layer_forms.h"
#include "theory/oscillating_cylinder.h"
#include "theory/rolling/mapped_ratcheting.h"

namespace tricontact::line_formulas_test {
namespace {

namespace quantities = comparisons::quantities;
using namespace formula_table;
using theory::LayerForm;

/// lambda in the runs of an atlas on the half-space, at Poisson's ratio.
double kept_lambda(const char* name, double poisson) {
    return contact::line_shift_factor(atlas::case_of_runs(atlas::shipped(name), poisson));
}

// w, excess of the limit
double load_beyond(const Point& p, double limit) {
    return limit + p[1] * (1 - limit);
}

TEST(AtlasFormulas, RatchetingCylinder) {
    const char* name = "cylinder_half_space_ratcheting";
    const double lambda = kept_lambda(name, .5);
    const Table table(name, quantities::shift_increment_ratio);
    const auto f = [](const Point& p) {
        return load_beyond(p, theory::line_shakedown_limit(p[0]));
    };
    table.check({"Delta u, cylinder", {8, 2.3}, [=](const Point& p) {
                     return theory::line_shift_increment_ratio(p[0], f(p), lambda);
                 }});
    table.check({"Delta u, cylinder, thesis", {70, 24}, [=](const Point& p) {
                     return theory::thesis_line_increment(p[0], f(p));
                 }});
}

// w, b/D_c, nu
TEST(AtlasFormulas, PressedCylinderOnALayer) {
    const char* name = "cylinder_layer_pressed";
    const auto table = [&](const Quantity& q) { return Table(name, q); };
    const auto of = [](double (*form)(const LayerForm&)) {
        return [=](const Point& p) { return form({p[1], p[2]}); };
    };
    table(quantities::contact_radius)
        .check({"a/a_H, cylinder", {.42, .018}, of(theory::line_layer_width_ratio)});
    table(quantities::peak_pressure)
        .check({"p0/p0_H, cylinder", {.4, .017}, of(theory::line_layer_pressure_ratio)});
    // Of the atlas: over Hertz' values of its own length.
    table(quantities::unit_shift)
        .check({"lambda, cylinder", {1.1, .27}, [&](const Point& p) {
                    return theory::line_layer_shift_factor({p[1], p[2]}) / kept_lambda(name, p[2]);
                }});
    // d over 2 F_N/(pi E* L), which is U_max over mu lambda.
    table(quantities::indentation)
        .check({"d, cylinder", {1.1, .4}, [&](const Point& p) {
                    const contact::Case c = atlas::case_of_runs(atlas::shipped(name), p[2]);
                    const contact::HalfSpaceScales hertz = half_space_scales(c);
                    const double unit =
                        hertz.unit_shift / (c.friction_coefficient() * kept_lambda(name, p[2]));
                    return theory::line_layer_depth_factor({p[1], p[2]}) * unit / hertz.indentation;
                }});
    const Table limit = table(quantities::limit_tangential_ratio);
    limit.check({"f_T,lim, cylinder", {.66, .009}, [](const Point& p) {
                     return theory::line_layer_shakedown_limit({p[1], p[2]}, p[0]);
                 }});
    limit.check({"f_T,lim of Hertz, cylinder", {21, .017}, [](const Point& p) {
                     return theory::line_shakedown_limit(p[0]);
                 }});
}

// f, b/D_c, nu, mu
TEST(AtlasFormulas, StaticCylinderOnALayer) {
    const Table table("cylinder_layer_static", quantities::static_shift_ratio);
    table.check({"u_stat, cylinder on a layer", {21, .7}, [](const Point& p) {
                     return theory::line_static_shift_ratio(
                         p[0], theory::line_layer_shift_factor({p[1], p[2]}));
                 }});
}

// w, phi, b/D_c, nu, mu
TEST(AtlasFormulas, RolledCylinderOnALayer) {
    const Table table("cylinder_layer", quantities::settled_shift_ratio);
    table.check({"u_sd, cylinder on a layer", {12, .82}, [](const Point& p) {
                     const double lambda = theory::line_layer_shift_factor({p[2], p[3]});
                     const double f = p[1] * theory::line_shakedown_limit(p[0]);
                     return theory::line_settled_shift_ratio(
                         p[0], *theory::line_stick_half_width(p[0], f), lambda);
                 }});
}

// w, excess, b/D_c, mu
TEST(AtlasFormulas, RatchetingCylinderOnALayer) {
    const Table table("cylinder_layer_ratcheting", quantities::shift_increment_ratio);
    table.check({"Delta u, cylinder on a layer", {37, 3.5}, [](const Point& p) {
                     const double f = load_beyond(p, theory::line_shakedown_limit(p[0]));
                     return theory::line_shift_increment_ratio(
                         p[0], f, theory::line_layer_shift_factor({p[2], .5}));
                 }});
}

}  // namespace
}  // namespace tricontact::line_formulas_test
