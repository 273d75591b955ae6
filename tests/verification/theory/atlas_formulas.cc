// The table of docs/explanation/atlas-formulas.md: closed forms against the shipped atlases.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "atlas/contact_maps.h"
#include "formula_table.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/layer/layer_forms.h"
#include "theory/rolling/mapped_ratcheting.h"
#include "theory/rolling/mapped_shakedown.h"
#include "theory/rolling/mapped_strength.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::atlas_formulas_test {
namespace {

namespace quantities = comparisons::quantities;
using namespace formula_table;

// w, phi, angle, nu
theory::MappedRolling rolling_of(const Point& p) {
    return {p[0], p[1] * theory::shakedown_limit(p[0]), p[2], p[3]};
}

double thesis_mapping(const Point& p) {
    const double across = std::pow(std::sin(p[2]), 2);
    return theory::thesis_mapping_parallel * (1 - across) +
           theory::thesis_mapping_perpendicular * across;
}

std::function<double(const Point&)> settled_by(double (*mapping)(const Point&)) {
    return [=](const Point& p) {
        const auto point = rolling_of(p);
        return *theory::settled_shift_ratio(point.amplitude_ratio, point.tangential_ratio,
                                            mapping(p));
    };
}

constexpr auto mapped = [](const Point& p) { return theory::half_space_mapping(rolling_of(p)); };
constexpr auto simple = [](const Point& p) {
    return theory::simple_half_space_mapping(rolling_of(p));
};
constexpr auto mdr = [](const Point&) { return theory::mdr_mapping; };

TEST(AtlasFormulas, SettledShift) {
    const Table table("sphere_half_space", quantities::settled_shift_ratio);
    table.check({"u_sd, kappa of four coefficients", {1.3, .17}, settled_by(mapped)});
    table.check({"u_sd, kappa of two coefficients", {6.2, .17}, settled_by(simple)});
    table.check({"u_sd, thesis, kappa = 1 to 1.1", {51, 4.5}, settled_by(thesis_mapping)});
    table.check({"u_sd, MDR, kappa = 3/2", {140, 26}, settled_by(mdr)});
}

TEST(AtlasFormulas, SettledShiftUpToNineTenthsOfTheLimit) {
    const Table table("sphere_half_space", quantities::settled_shift_ratio,
                      [](const Point& p) { return p[1] <= .9; });
    table.check({"u_sd, phi <= 0.9, kappa of four coefficients", {1.3, .17}, settled_by(mapped)});
    table.check({"u_sd, phi <= 0.9, kappa of two coefficients", {1.9, .17}, settled_by(simple)});
    table.check({"u_sd, phi <= 0.9, thesis", {44, 3.8}, settled_by(thesis_mapping)});
    table.check({"u_sd, phi <= 0.9, MDR", {130, 25}, settled_by(mdr)});
}

TEST(AtlasFormulas, Kappa) {
    const Table table("sphere_half_space", quantities::kappa);
    table.check({"kappa of four coefficients", {7.1, .3}, mapped});
    table.check({"kappa of two coefficients", {6.8, .36}, simple});
    table.check({"kappa of the thesis, 1 to 1.1", {27, 8.6}, thesis_mapping});
    table.check({"kappa of MDR, 3/2", {71, 31}, mdr});
}

// w, phi, angle, nu
theory::MappedRolling strength_of(const Point& p) {
    return {p[0], p[1] * theory::strength_rolling.exact_limit(p[0]), p[2], p[3]};
}

TEST(AtlasFormulas, ShearStrength) {
    const Table settled("sphere_half_space_strength", quantities::settled_shift_ratio);
    settled.check({"u_sd, shear strength", {1.6, .12}, [](const Point& p) {
                       return *theory::strength_settled_shift_ratio(strength_of(p));
                   }});
    settled.check({"u_sd, shear strength, MDR", {120, 29}, [](const Point& p) {
                       const auto at = strength_of(p);
                       const auto& law = theory::strength_rolling;
                       return *law.settled_shift_ratio(at.amplitude_ratio, at.tangential_ratio,
                                                       law.mdr_mapping);
                   }});
    const Table mapping("sphere_half_space_strength", quantities::kappa);
    mapping.check({"kappa, shear strength", {2.5, .2}, [](const Point& p) {
                       return theory::strength_mapping(strength_of(p));
                   }});
    mapping.check({"kappa, shear strength, MDR", {72, 35}, [](const Point&) {
                       return theory::strength_rolling.mdr_mapping;
                   }});
    const Table still("sphere_half_space_strength_static", quantities::static_shift_ratio);
    still.check({"u_stat, shear strength", {.33, .028}, [](const Point& p) {
                     return theory::strength_rolling.static_shift(p[0]);
                 }});
}

// w, b/D_c, nu
std::function<double(const Point&)> of_layer(double (*form)(const theory::LayerForm&)) {
    return [=](const Point& p) { return form({p[1], p[2]}); };
}

TEST(AtlasFormulas, PressedLayer) {
    const auto table = [](const Quantity& q) { return Table("sphere_layer_pressed", q); };
    const auto half_space = [](const Point&) { return 1.; };
    table(quantities::contact_radius)
        .check({"a/a_H", {.5, .001}, of_layer(theory::layer_radius_ratio)});
    table(quantities::indentation)
        .check({"d/d_H", {2.4, .03}, of_layer(theory::layer_indentation_ratio)});
    table(quantities::peak_pressure)
        .check({"p0/p0_H", {.8, .004}, of_layer(theory::layer_pressure_ratio)});
    table(quantities::unit_shift)
        .check({"U_max/U_max,H", {1, .006}, of_layer(theory::layer_unit_shift_ratio)});
    const Table limit = table(quantities::limit_tangential_ratio);
    limit.check({"f_T,lim", {1.4, .006}, [](const Point& p) {
                     return theory::layer_shakedown_limit({p[1], p[2]}, p[0]);
                 }});
    limit.check({"f_T,lim of Hertz", {17, .008}, [](const Point& p) {
                     return theory::shakedown_limit(p[0]);
                 }});
    table(quantities::contact_radius).check({"a of Hertz", {27, .066}, half_space});
    table(quantities::indentation).check({"d of Hertz", {230, 10}, half_space});
    table(quantities::unit_shift).check({"U_max of Hertz", {49, 5.1}, half_space});
}

// w, phi, angle, b/D_c, nu, mu
struct Rolled {
    theory::LayerForm layer;
    theory::MappedRolling point;
    double friction;
};

Rolled rolled_of(const Point& p) {
    const theory::LayerForm layer{p[3], p[4]};
    const double limit = theory::layer_shakedown_limit(layer, p[0]);
    return {layer, {p[0], p[1] * limit, p[2], p[4]}, p[5]};
}

double settled_on_layer(const Point& p) {
    const auto [layer, point, friction] = rolled_of(p);
    return *theory::layer_settled_shift_ratio(layer, point, friction);
}

double half_space_on_layer(const Point& p) {
    return *theory::half_space_settled_shift_ratio(rolled_of(p).point);
}

double thesis_on_layer(const Point& p) {
    const auto point = rolled_of(p).point;
    return *theory::settled_shift_ratio(point.amplitude_ratio, point.tangential_ratio,
                                        thesis_mapping(p));
}

// f, nu
TEST(AtlasFormulas, StaticShift) {
    const Table table("sphere_half_space_static", quantities::static_shift_ratio);
    table.check({"u_stat, Cattaneo and Mindlin", {.33, .028}, [](const Point& p) {
                     return theory::static_shift_ratio(p[0]);
                 }});
}

// w, excess of the limit, angle, nu
theory::MappedRolling ratcheting_of(const Point& p) {
    const double limit = theory::shakedown_limit(p[0]);
    return {p[0], limit + p[1] * (1 - limit), p[2], p[3]};
}

double thesis_increment(const Point& p) {
    const auto point = ratcheting_of(p);
    const double along =
        theory::thesis_increment_parallel(point.amplitude_ratio, point.tangential_ratio);
    const double across =
        theory::thesis_increment_perpendicular(point.amplitude_ratio, point.tangential_ratio);
    const double share = std::pow(std::sin(p[2]), 2);
    return along * (1 - share) + across * share;
}

TEST(AtlasFormulas, Ratcheting) {
    const Table table("sphere_half_space_ratcheting", quantities::shift_increment_ratio);
    table.check({"Delta u, half-space", {9.5, 1.6}, [](const Point& p) {
                     return theory::half_space_shift_increment_ratio(ratcheting_of(p));
                 }});
    table.check({"Delta u, thesis", {101, 50}, thesis_increment});
    table.check({"Delta u, MDR", {210, 110}, [](const Point& p) {
                     const auto point = ratcheting_of(p);
                     return atlas::mdr_shift_increment_ratio(point.amplitude_ratio,
                                                             point.tangential_ratio)
                         .value;
                 }});
}

// f, b/D_c, nu, mu
TEST(AtlasFormulas, StaticLayer) {
    const Table table("sphere_layer_static", quantities::static_shift_ratio);
    table.check({"u_stat, layer", {14, .7}, [](const Point& p) {
                     return theory::layer_static_shift_ratio({p[1], p[2]}, p[0]);
                 }});
    table.check({"u_stat, layer, by the half-space's form", {26, 1.8}, [](const Point& p) {
                     return theory::static_shift_ratio(p[0]);
                 }});
}

TEST(AtlasFormulas, RolledLayer) {
    const Table settled("sphere_layer", quantities::settled_shift_ratio);
    settled.check({"u_sd, layer", {12.5, .55}, settled_on_layer});
    settled.check({"u_sd, layer, by the half-space's form", {22, 1.9}, half_space_on_layer});
    settled.check({"u_sd, layer, thesis", {33, 3.1}, thesis_on_layer});
    const Table weak("sphere_layer", quantities::settled_shift_ratio, [](const Point& p) {
        return p[3] > .5 && std::abs(theory::layer_coupling({p[3], p[4]}, p[5])) < .3;
    });
    weak.check({"u_sd, layer, b > D_c/2, abs(K) < 0.3", {6.9, .41}, settled_on_layer});
}

// w, excess of the limit, angle, b/D_c, mu
TEST(AtlasFormulas, RatchetingOnALayer) {
    const Table table("sphere_layer_ratcheting", quantities::shift_increment_ratio);
    table.check(
        {"Delta u, layer, by the half-space's form", {60, 5.2}, [](const Point& p) {
             return theory::half_space_shift_increment_ratio(ratcheting_of({p[0], p[1], p[2], .5}));
         }});
}

}  // namespace
}  // namespace tricontact::atlas_formulas_test
