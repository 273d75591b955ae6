#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bem/model.h"
#include "contact/base/root.h"
#include "contact/bodies/indenter.h"
#include "io/case/case_reader.h"
#include "mdr/layer_model.h"
#include "theory/layer/elastic_layer.h"
#include "theory/worn_paraboloid.h"
#include "wear/wear_run.h"

namespace tricontact::wear::wear_layer_test {

namespace {

/// A ball of 40 mm, half a millimetre deep in rubber, until nothing is left to wear.
contact::Case ball(const std::string& thickness, std::vector<std::string> more = {}) {
    return io::parse_case(R"x(
models = ["bem-layer", "mdr-layer"]
indenter.radius = "40 mm"
substrate = {young = "5.2 MPa", poisson = 0.3, thickness = ")x" +
                              thickness + R"x("}
friction.coefficient = 0.6
contact.coupling = false
path.steps = 1
path.table = """
indentation [mm], shift_x [mm]
0.5, 0
0.5, 0.25
0.5, -0.25
0.5, 0.25
"""
wear = {coefficient = "1 mm3/(N m)", cycles = 10000000, tolerance = 0.03}
bem.cells_per_radius = 8
)x",
                          "layer.toml", more);
}

/// The last state, and its worn depth over x >= 0.
struct Worn {
    WornState last;
    std::vector<double> x, depth;

    double at(double r) const {
        const auto k = static_cast<std::size_t>(std::ranges::upper_bound(x, r) - x.begin());
        if (k == 0) return depth.front();
        if (k == x.size()) return 0;
        return std::lerp(depth[k - 1], depth[k], (r - x[k - 1]) / (x[k] - x[k - 1]));
    }
};
Worn worn_by(const contact::Case& c, contact::Model& model, const WearOptions& how = {}) {
    Worn worn;
    WearOptions options = how;
    options.at_end = [&](const contact::WearingContact& contact, const WearHistory& history) {
        for (const std::size_t i : contact.line()) {
            if (contact.x(i) < 0) continue;
            worn.x.push_back(contact.x(i));
            worn.depth.push_back(history.states.back().worn[i]);
        }
    };
    worn.last = run_wear(c, model, options).states.back();
    return worn;
}

/// F_N of the paraboloid of 40 mm whose disc of the radius c alone is left, under the depth: what
/// it has as a contact of its own, and a flat punch for the rest of the depth; by the layer's
/// integral equation.
double force_of_disc(const contact::Case& c, double stick, double depth) {
    const theory::ElasticLayer layer{c.substrate, *c.layer.thickness};
    const auto at = [&](double d) {
        return theory::solve_layer_contact(layer, contact::Paraboloid(40e-3),
                                           {contact::NormalControl::Kind::indentation, d});
    };
    const double own =
        contact::bracketed_root([&](double d) { return at(d).contact_radius - stick; }, 1e-5, 2e-3);
    return at(own).normal_force + at(own).normal_stiffness * (depth - own);
}

}  // namespace

// Along x: slip across it, which springs leave out, and edges that square cells cut, 1.3 % of the
// depth at 8 cells in Hertz' radius, 0.5 % at 16. Of the layer's integral equation, which knows
// neither, springs are off by the edge of the stick zone, half an element.
TEST(WearLayer, SpringsAndCellsWearToTheSameProfile) {
    constexpr double depth = 5e-4;
    const auto c = ball("8 mm");
    const Worn springs = worn_by(c, *mdr::make_layer_model(c, 100));
    const Worn cells = worn_by(c, *bem::make_model(c, 1, bem::Body::layer));
    EXPECT_EQ(springs.last.regime(), WearRegime::partial_slip);
    const double exact = force_of_disc(c, springs.last.stick_radius(), depth);
    EXPECT_NEAR(springs.last.cycle.normal_force, exact, 1e-4 * exact);
    EXPECT_NEAR(cells.last.stick_radius(), springs.last.stick_radius(), 1e-4);
    EXPECT_NEAR(cells.last.volume, springs.last.volume, .08 * springs.last.volume);
    double mean = 0;
    for (std::size_t i = 0; i < cells.x.size(); ++i)
        mean += std::abs(cells.depth[i] - springs.at(cells.x[i]));
    EXPECT_LT(mean / static_cast<double>(cells.x.size()), .02 * depth);
}

// A layer a thousand contact radii thick is the half-space, whose limit is Popov's: to the order of
// the elements.
TEST(WearLayer, OfAThickLayerTheLimitIsThatOfTheHalfSpace) {
    constexpr double depth = 5e-4;
    const auto c = ball("4.5 m");
    const auto bodies = c.materials();
    const auto limit = theory::WornParaboloid::of_cycle(
        40e-3, depth, 2.5e-4, .6 * bodies.effective_modulus() / bodies.effective_shear_modulus());
    for (const int elements : {25, 100}) {
        const Worn worn = worn_by(c, *mdr::make_layer_model(c, elements));
        double mean = 0;
        for (std::size_t i = 0; i < worn.x.size(); ++i)
            mean += std::abs(worn.depth[i] - limit.worn(worn.x[i]));
        EXPECT_LT(mean / static_cast<double>(worn.x.size()), .2 / elements * depth);
        EXPECT_NEAR(worn.last.stick_radius(), limit.stick_radius, limit.stick_radius / elements);
    }
}

// Volumes of the two are sums, and k_w/mu times their work.
TEST(WearLayerSlow, JumpsKeepTheirBound) {
    for (const std::string table :
         {"indentation [mm], shift_x [mm]\n0.5, 0\n0.5, 0.2\n0.5, -0.2\n0.5, 0.2\n",
          "normal_force [N], tangential_force_x [N]\n30, 0\n30, 10\n30, -10\n30, 10\n"}) {
        const auto c = ball("8 mm", {"path.table=" + table, "wear.cycles=1000",
                                     "wear.coefficient=1e-3 mm3/(N m)", "wear.tolerance=.01"});
        const WearHistory jumps = run_wear(c, *mdr::make_layer_model(c, 30));
        const WearHistory each =
            run_wear(c, *mdr::make_layer_model(c, 30), {.cycle_by_cycle = true});
        const WornState &a = jumps.states.back(), &b = each.states.back();
        EXPECT_LT(jumps.cycles_computed, 300);
        EXPECT_LE(std::abs(a.volume - b.volume), a.volume_error);
        EXPECT_LT(a.volume_error, .05 * a.volume);
        EXPECT_NEAR(b.volume, 1e-12 / .6 * b.work, 1e-9 * b.volume);
    }
}

// Gross slip wears all of it off a depth that stays, and nothing beyond.
TEST(WearLayer, EndsWhereNothingTouches) {
    const auto c =
        ball("8 mm", {"path.table=indentation [mm], shift_x [mm]\n.5, 0\n.5, 1\n.5, -1\n.5, 1\n"});
    const Worn worn = worn_by(c, *mdr::make_layer_model(c, 50));
    EXPECT_EQ(worn.last.regime(), WearRegime::gross_slip);
    // Of the cap of the paraboloid of the depth d: pi R d^2.
    const double cap = std::numbers::pi * 40e-3 * 25e-8;
    EXPECT_NEAR(worn.last.volume, cap, 1e-3 * cap);
}

}  // namespace tricontact::wear::wear_layer_test
