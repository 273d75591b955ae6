// Half widths of fields and of the stiffness beside Hertz, whose pressure is known at every point.
#include "runs/field_bars.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "app/models/make_model.h"
#include "comparisons/differences/surface_difference.h"
#include "comparisons/half_space/layer.h"
#include "contact/cells.h"
#include "mdr/settings.h"
#include "runs/normal_stiffness.h"
#include "runs/numerical_error.h"

namespace tricontact::field_bars_test {
namespace {

using contact::Case;
constexpr double young = 5.2e6, tip_radius = .04;

Case pressed(const char* model, double force, double cells, double poisson) {
    Case c;
    c.models = {model};
    c.indenter.radius = tip_radius;
    c.substrate = {young, poisson};
    c.friction.coefficient = .57;
    c.contact.coupling = poisson > 0;
    c.load.press = Case::Press::frictionless;
    c.load.normal_force = force;
    c.load.tangential_force = 0;
    c.of<contact::Cells>().per_radius = cells;
    c.of<mdr::Settings>().springs = static_cast<int>(8 * cells);
    return c;
}

struct BarredRun {
    contact::History history;
    comparisons::NumericalError error;
};
BarredRun run_of(const Case& c) {
    runs::RunOptions options;
    options.makers = &app::model_makers();
    BarredRun run{.history = options.runner().history_of(c.models.front(), c), .error = {}};
    run.error = *runs::numerical_error(c, run.history, options, contact::silent);
    return run;
}

const comparisons::FieldBar& bar(const BarredRun& run, const std::string& field) {
    for (const auto& one : run.error.fields)
        if (one.field == field) return one;
    throw std::runtime_error("no bar of " + field + run.error.why_none);
}

struct Miss {
    double largest = 0, l2 = 0;
};
/// Of the pressures at a surface's points from Hertz' (Johnson 1985, eqs. 4.22 to 4.24).
Miss miss_of_hertz(const contact::Surface& s, double force) {
    const double a = std::cbrt(3 * force * tip_radius / (4 * young));
    const double p0 = 3 * force / (2 * std::numbers::pi * a * a);
    Miss miss;
    double apart2 = 0, own2 = 0;
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i) {
            const double r = std::hypot(s.x(i), s.n_y > 1 ? s.y(j) : 0);
            const double exact = r < a ? p0 * std::sqrt(1 - r * r / (a * a)) : 0;
            const double apart = s.normal_traction[static_cast<std::size_t>(j) * s.n_x + i] - exact;
            miss.largest = std::max(miss.largest, std::abs(apart));
            apart2 += apart * apart;
            own2 += exact * exact;
        }
    miss.l2 = std::sqrt(apart2 / own2);
    return miss;
}

// At random forces and cells; below, a bar that is far too wide would cover, too.
TEST(FieldBars, CoverThePressureOfHertz) {
    std::mt19937 random(44);
    std::uniform_real_distribution<> logarithm(-1, 1), cells(7, 20);
    for (int k = 0; k < 12; ++k) {
        const double force = 20 * std::exp(logarithm(random)), per_radius = cells(random);
        SCOPED_TRACE(testing::Message() << force << " N, " << per_radius << " cells");
        const BarredRun run = run_of(pressed(contact::models::bem, force, per_radius, 0));
        const Miss miss = miss_of_hertz(run.history.snapshots.back().surface, force);
        const auto& of_pressure = bar(run, "normal_traction");
        EXPECT_LE(miss.largest, of_pressure.largest);
        EXPECT_LE(miss.l2, of_pressure.l2);
        EXPECT_GT(miss.largest, .03 * of_pressure.largest);
        EXPECT_LT(of_pressure.l2, .3);
    }
}

// dF/dd = 2 E* a, whether normal and tangential contact are coupled.
TEST(FieldBars, CoverTheStiffnessOfHertz) {
    std::mt19937 random(45);
    std::uniform_real_distribution<> logarithm(-1, 1), cells(8, 20), poisson(.1, .4);
    for (int k = 0; k < 12; ++k) {
        const double force = 20 * std::exp(logarithm(random)), nu = k % 3 ? poisson(random) : 0;
        const char* name = k % 3 == 1 ? contact::models::mdr : contact::models::bem;
        Case c = pressed(name, force, cells(random), nu);
        c.contact.coupling = k % 3 == 2;
        const BarredRun run = run_of(c);
        SCOPED_TRACE(testing::Message()
                     << name << ' ' << force << " N: " << run.error.why_no_stiffness);
        ASSERT_TRUE(run.error.normal_stiffness);
        const auto model = app::model_makers().make(name, c, 1, contact::silent);
        const double modulus = young / (1 - nu * nu);
        const double exact = 2 * modulus * std::cbrt(3 * force * tip_radius / (4 * modulus));
        const double found = runs::frictionless_stiffness(c, *model).value;
        EXPECT_LE(std::abs(found - exact), *run.error.normal_stiffness);
        EXPECT_LT(*run.error.normal_stiffness, .2 * exact);
        // A path has that of its hardest load, and what a model was used for before is no matter.
        Case path = c;
        path.prescribed_path.emplace();
        for (const double share : {.5, 1., .7}) {
            contact::PrescribedPath::Row row;
            row.normal = {contact::NormalControl::Kind::force, share * force};
            path.prescribed_path->rows.push_back(row);
        }
        EXPECT_NEAR(runs::frictionless_stiffness(path, *model).value / found, 1, 1e-5);
    }
}

// On a layer ln F over ln d is no line. Exact: theory/layer/elastic_layer.h.
TEST(FieldBars, CoverTheStiffnessOfTheLayer) {
    for (const char* name : {contact::models::mdr_layer, contact::models::bem_layer})
        for (const double thickness : {2e-3, 4e-3, 8e-3}) {
            Case c = pressed(name, 20, 24, .3);
            c.contact.coupling = false;
            c.layer.thickness = thickness;
            c.of<mdr::Settings>().elements_per_radius = 100;
            const BarredRun run = run_of(c);
            SCOPED_TRACE(testing::Message() << name << ' ' << run.error.why_no_stiffness);
            ASSERT_TRUE(run.error.normal_stiffness);
            const double exact = comparisons::exact_layer_contact(c)->normal_stiffness;
            const auto model = app::model_makers().make(name, c, 1, contact::silent);
            const double found = runs::frictionless_stiffness(c, *model).value;
            EXPECT_LE(std::abs(found - exact), *run.error.normal_stiffness) << exact;
            // Four times the cells of 24 in a are hardly a layer of half a.
            const double most = name == contact::models::mdr_layer ? .03 : .12;
            EXPECT_LT(*run.error.normal_stiffness, most * exact);
        }
}

// Two meshes alone say nothing of it: said by name, the other half widths stand.
TEST(FieldBars, SayWhyThereIsNoStiffness) {
    contact::ModelMakers makers = app::model_makers();
    makers.make_coarser = [](const std::string& name, const Case& c, double factor, int n_threads,
                             const contact::Say& say) {
        if (factor > 2) throw contact::InputError("there is no such mesh");
        return app::model_makers().make_coarser(name, c, factor, n_threads, say);
    };
    runs::RunOptions options;
    options.makers = &makers;
    const Case c = pressed(contact::models::mdr, 20, 10, 0);
    const auto history = options.runner().history_of(contact::models::mdr, c);
    const auto error = *runs::numerical_error(c, history, options, contact::silent);
    EXPECT_FALSE(error.normal_stiffness);
    EXPECT_NE(comparisons::numerical_error_json(error)["why_no_normal_stiffness"].dump().find(
                  "four times the size"),
              std::string::npos);
    EXPECT_TRUE(error.of(comparisons::quantities::indentation));
}

// A layer pressed with friction, beside cells a quarter as large.
TEST(FieldBars, CoverTheLayersFieldsOnFinerCells) {
    std::mt19937 random(46);
    std::uniform_real_distribution<> cells(6, 9);
    const auto of_layer = [](double per_radius) {
        Case c = pressed(contact::models::bem_layer, 20, per_radius, .3);
        c.layer.thickness = 8e-3;
        c.load.press = Case::Press::friction;
        c.load.press_steps = 4;
        return c;
    };
    runs::RunOptions options;
    options.makers = &app::model_makers();
    const auto fine = options.runner().history_of(contact::models::bem_layer, of_layer(32));
    for (int k = 0; k < 3; ++k) {
        Case c = of_layer(cells(random));
        const BarredRun run = run_of(c);
        // Steps are those of the run: what the mesh leaves is covered with what the steps leave.
        const auto d = comparisons::difference_of(run.history.snapshots.back().surface,
                                                  fine.snapshots.back().surface);
        EXPECT_LE(std::abs(d.pressure.value), bar(run, "normal_traction").largest);
        EXPECT_LE(d.pressure.l2, bar(run, "normal_traction").l2);
        EXPECT_LE(std::abs(d.traction.value), bar(run, "tangential_traction").largest);
        EXPECT_LE(d.traction.l2, bar(run, "tangential_traction").l2);
    }
}

TEST(FieldBars, StandInTheSummary) {
    const BarredRun run = run_of(pressed(contact::models::bem, 20, 10, .3));
    const auto json = comparisons::numerical_error_json(run.error);
    EXPECT_EQ(json["fields"]["normal_traction"]["largest_Pa"], bar(run, "normal_traction").largest);
    EXPECT_EQ(json["fields"]["displacement"]["l2"], bar(run, "displacement").l2);
    EXPECT_TRUE(json["half_widths"].contains("normal_stiffness_N_per_m")) << json["half_widths"];
    EXPECT_TRUE(runs::field_bars({}).empty());
}

}  // namespace
}  // namespace tricontact::field_bars_test
