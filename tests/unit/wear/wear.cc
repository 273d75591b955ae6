#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/base/root.h"
#include "contact/bodies/indenter.h"
#include "io/case/case_reader.h"
#include "mdr/model.h"
#include "theory/layer/elastic_layer.h"
#include "theory/worn_paraboloid.h"
#include "wear/wear_report.h"

namespace tricontact::wear::wear_test {

namespace {

/// A steel ball of 10 mm, 5 um deep, moved by `shift` [um] to either side.
std::string steel_ball(double shift, const std::string& wear, const std::string& more = "") {
    const std::string u = std::to_string(shift);
    return R"(
models = ["bem"]
[indenter]
radius = "10 mm"
young = "210 GPa"
poisson = 0.3
[substrate]
young = "210 GPa"
poisson = 0.3
[friction]
coefficient = 0.6
[path]
steps = 1
table = """
indentation [um], shift_x [um]
5, 0
5, )" + u + "\n5, -" +
           u + "\n5, " + u + "\n\"\"\"\n[wear]\n" + wear + '\n' + more;
}

contact::Case ball(double shift, const std::string& wear, const std::string& more = "") {
    return io::parse_case(steel_ball(shift, wear, more), "ball.toml", {});
}

// Until nothing is left to wear; where that ends does not depend on how it is reached.
const std::string worn_out =
    "coefficient = \"1e-5 mm3/(N m)\"\ncycles = 10000000\ntolerance = 0.03";

constexpr double shift = 2, depth = 5e-6, radius = 10e-3;

theory::WornParaboloid limit_of(const contact::Case& c) {
    const auto bodies = c.materials();
    return theory::WornParaboloid::of_cycle(
        radius, depth, shift * 1e-6,
        .6 * bodies.effective_modulus() / bodies.effective_shear_modulus());
}

/// Of the worn depth, from the exact limit: the largest, and the mean over the area within twice
/// the contact radius, over d.
struct OffLimit {
    double largest = 0, mean = 0;
};
OffLimit off_limit(const contact::Case& c, contact::Model& model) {
    OffLimit off;
    const theory::WornParaboloid exact = limit_of(c);
    const auto compare = [&](const contact::WearingContact& contact, const WearHistory& history) {
        for (const std::size_t i : contact.line()) {
            const double r = std::abs(contact.x(i));
            const double error =
                std::abs(history.states.back().worn[i] - exact.worn(r)) / exact.depth;
            off.largest = std::max(off.largest, error);
            off.mean += error / static_cast<double>(contact.line().size());
        }
    };
    run_wear(c, model, {.at_end = compare});
    return off;
}

struct KeptInMemory final : KeptStates {
    std::vector<std::string> states;
    std::vector<std::string> found() const override { return states; }
    void append(std::string_view bytes) override { states.emplace_back(bytes); }
    void clear() override { states.clear(); }
};

}  // namespace

// At the nodes the limit of a paraboloid is exact; what is left is what has not worn yet.
TEST(Wear, MdrReachesTheExactLimitProfile) {
    const auto c = ball(shift, worn_out, "[mdr]\nsprings = 3000");
    EXPECT_LT(off_limit(c, *mdr::make_model(c)).largest, 1e-9);
}

// The edges of stick zone and worn ring are cut by square cells: O(h). With nu = 0 all slip is
// along x, as the limit takes it.
TEST(WearSlow, BemReachesItToTheOrderOfItsGrid) {
    for (const int cells : {8, 16}) {
        const auto c = io::parse_case(
            steel_ball(shift, worn_out, "[bem]\ncells_per_radius = " + std::to_string(cells)),
            "ball.toml", {"indenter.poisson=0.0", "substrate.poisson=0.0"});
        EXPECT_LT(off_limit(c, *bem::make_model(c, 1, bem::Body::half_space)).mean, .05 / cells);
    }
}

// On a layer, too, what is left is the contact of the disc c under the depth d: that of the
// paraboloid that has the radius c by itself, and a flat punch of that radius for the rest of d.
// c by counted cells: 3 % of the force.
TEST(Wear, OnALayerTheLimitIsTheContactOfWhatSticks) {
    const auto c = io::parse_case(R"x(
models = ["bem-layer"]
indenter.radius = "40 mm"
substrate = {young = "5.2 MPa", poisson = 0.5, thickness = "8 mm"}
friction.coefficient = 0.6
contact.coupling = false
path.steps = 1
path.table = """
indentation [mm], shift_x [mm]
0.5, 0
0.5, 0.4
0.5, -0.4
0.5, 0.4
"""
wear = {coefficient = "1 mm3/(N m)", cycles = 10000000, tolerance = 0.03}
bem.cells_per_radius = 8
)x",
                                  "layer.toml", {});
    const auto model = bem::make_model(c, 1, bem::Body::layer);
    const WornState last = run_wear(c, *model).states.back();
    ASSERT_EQ(last.regime(), WearRegime::partial_slip);
    const theory::ElasticLayer layer{c.substrate, 8e-3};
    const auto at = [&](double depth) {
        return theory::solve_layer_contact(layer, contact::Paraboloid(40e-3),
                                           {contact::NormalControl::Kind::indentation, depth});
    };
    const double own = contact::bracketed_root(
        [&](double depth) { return at(depth).contact_radius - last.stick_radius(); }, 1e-5, 1e-3);
    const double force =
        at(own).normal_force + at(own).normal_stiffness * (last.cycle.indentation - own);
    EXPECT_NEAR(last.cycle.normal_force, force, .04 * force);
}

// A fifth of the depth in one cycle: profiles would oscillate until the contact has no end.
TEST(Wear, ACycleThatWearsMuchOfTheDepthIsRefused) {
    const auto c =
        ball(shift, "coefficient = \"1 mm3/(N m)\"\ncycles = 10", "[mdr]\nsprings = 1000");
    EXPECT_THROW(run_wear(c, *mdr::make_model(c)), contact::InputError);
}

// Archard: where all slips, dV = k_w/mu dW, whatever slips how far.
TEST(Wear, VolumeIsWorkOverFrictionInGrossSlip) {
    const auto c =
        ball(20, "coefficient = \"1e-8 mm3/(N m)\"\ncycles = 1000", "[bem]\ncells_per_radius = 10");
    const auto model = bem::make_model(c, 1, bem::Body::half_space);
    const WearHistory history = run_wear(c, *model);
    for (const WornState& s : history.states) {
        EXPECT_EQ(s.regime(), WearRegime::gross_slip);
        EXPECT_NEAR(s.cycle.volume, 1e-17 / .6 * s.cycle.work, 1e-10 * s.cycle.volume);
    }
    const WornState& last = history.states.back();
    EXPECT_NEAR(last.volume, 1e-17 / .6 * last.work, last.volume_error + 1e-6 * last.volume);
}

// By the work instead: the same wear, k_E = k_w/mu.
TEST(Wear, EnergyLawIsArchardsUnderCoulombFriction) {
    const std::string grid = "[bem]\ncells_per_radius = 8";
    const auto archard = ball(shift, "coefficient = \"6e-8 mm3/(N m)\"\ncycles = 100", grid);
    const auto energy = ball(shift, "energy_coefficient = \"1e-7 mm3/J\"\ncycles = 100", grid);
    const auto volume = [](const contact::Case& c) {
        return run_wear(c, *bem::make_model(c, 1, bem::Body::half_space)).states.back().volume;
    };
    const double by_pressure = volume(archard);
    EXPECT_NEAR(volume(energy), by_pressure, 1e-8 * by_pressure);
}

// A thousand cycles that wear off most of what wears.
TEST(Wear, JumpsKeepTheirBoundOverAThousandCycles) {
    const auto c = ball(shift, "coefficient = \"1e-3 mm3/(N m)\"\ncycles = 1000\ntolerance = 0.01",
                        "[bem]\ncells_per_radius = 6\n[mdr]\nsprings = 2000");
    const std::function<std::unique_ptr<contact::Model>()> models[] = {
        [&] { return bem::make_model(c, 1, bem::Body::half_space); },
        [&] { return mdr::make_model(c); }};
    for (const auto& make : models) {
        const WearHistory jumps = run_wear(c, *make());
        const WearHistory each = run_wear(c, *make(), {.cycle_by_cycle = true});
        EXPECT_LT(jumps.cycles_computed, 300);
        EXPECT_EQ(each.states.size(), 1001u);
        const WornState &a = jumps.states.back(), &b = each.states.back();
        EXPECT_LE(std::abs(a.volume - b.volume), a.volume_error);
        EXPECT_LT(a.volume_error, .05 * a.volume);
        double worst = 0;
        for (std::size_t i = 0; i < a.worn.size(); ++i)
            worst = std::max(worst, std::abs(a.worn[i] - b.worn[i]));
        EXPECT_LE(worst, a.depth_error);
    }
}

TEST(Wear, GoesOnWhereItEndedToTheSameBytes) {
    const auto c = ball(shift, "coefficient = \"1e-7 mm3/(N m)\"\ncycles = 3000",
                        "[bem]\ncells_per_radius = 7");
    const auto make = [&] { return bem::make_model(c, 1, bem::Body::half_space); };
    const std::string whole = wear_csv(run_wear(c, *make()));
    KeptInMemory kept;
    int left = 4;
    const auto stop = [&](const WornState&) {
        if (--left == 0) throw std::runtime_error("killed");
    };
    EXPECT_THROW(run_wear(c, *make(), {.kept = &kept, .show = stop}), std::runtime_error);
    EXPECT_EQ(kept.states.size(), 4u);
    EXPECT_EQ(wear_csv(run_wear(c, *make(), {.kept = &kept})), whole);
}

}  // namespace tricontact::wear::wear_test
