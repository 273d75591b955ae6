#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "comparisons/tractive/creep_theory.h"
#include "comparisons/tractive/readings.h"
#include "comparisons/tractive/rolling_csv.h"
#include "comparisons/tractive/rolling_document.h"
#include "comparisons/tractive/rolling_json.h"
#include "comparisons/tractive/rolling_sections.h"

namespace tricontact::comparisons::tractive {
namespace {

using contact::Case;
using rolling::RollingState;

constexpr double force = .56;

Case rubber(double nu) {
    Case c;
    c.models = {"mdr", "bem"};
    c.indenter.radius = 40e-3;
    c.substrate = {5.2e6, nu};
    c.friction_coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = force;
    c.tractive_rolling.emplace().distance = 4;
    return c;
}

CreepTheory theory_of(const Case& c, const std::string& key) {
    for (const CreepTheory& theory : creep_theories(c))
        if (theory.key == key) return theory;
    throw std::logic_error("no theory " + key);
}

/// Of a model that obeys a theory, dissipation as the energy balance has it.
RollingState state_of(const Case& c, const CreepTheory& theory, double f) {
    const contact::HalfSpaceScales scales = contact::half_space_scales(c);
    const double friction = c.friction_coefficient * scales.normal_force;
    const double xi = theory.creepage(f), area = 3 * scales.contact_radius * scales.contact_radius;
    return {.creepage = {.longitudinal = xi},
            .normal_force = scales.normal_force,
            .indentation = scales.indentation,
            .force = {f * friction, 0},
            .half_length = scales.contact_radius,
            .half_width = scales.contact_radius,
            .peak_pressure = scales.peak_pressure,
            .contact_area = area,
            .stick_area = area / 4,
            .slip_area = 3 * area / 4,
            .dissipation = xi * f * friction};
}

/// A cell in the contact that slips along x, one that sticks, one outside.
contact::Surface three_cells() {
    contact::Surface s;
    s.n_x = 3;
    s.n_y = 2;
    s.first = {-1e-3, 0};
    s.spacing = {1e-3, 1e-3};
    s.normal_traction = {2e5, 4e5, 0, 1e5, 2e5, 0};
    s.tangential_traction_x = {1e5, 5e4, 0, 5e4, 2e4, 0};
    s.slip_x = {.01, 0, 0, .01, 0, 0};
    s.slip_y.assign(6, 0);
    using enum contact::ContactState;
    s.contact_state = {slip, stick, open, slip, stick, open};
    return s;
}

RollingRun run_by(const Case& c, const std::string& model, const std::string& key) {
    const CreepTheory theory = theory_of(c, key);
    RollingRun run{.model = model};
    const double a = contact::half_space_scales(c).contact_radius;
    run.history.steady = state_of(c, theory, force);
    run.history.steady.distance = std::numeric_limits<double>::infinity();
    run.history.surface = three_cells();
    for (const double way : {0., 1., 2., 4.}) {
        RollingState state = run.history.steady;
        state.distance = way * a;
        state.creepage.longitudinal *= 1 + std::exp(-3 * way);
        run.history.transient.push_back(state);
    }
    for (double f = .05; f < .99; f += .06) run.creep_curve.push_back(state_of(c, theory, f));
    run.lines = {
        centre_line(run.history.surface, c.friction_coefficient, 0),
        centre_line(run.history.surface, c.friction_coefficient, run.history.steady.distance)};
    return run;
}

RollingReport report_of(double nu) {
    const Case c = rubber(nu);
    return {.c = c,
            .runs = {run_by(c, "mdr", "mdr_closed_form"), run_by(c, "bem", "vermeulen_johnson")}};
}

double number_in(const Cell& cell) {
    return std::get<double>(cell);
}

// What obeys the closed forms shows the thesis' ratio at every force, between points of curves too.
TEST(TractiveReport, FindsTheRatioOfTheThesisInItsClosedForms) {
    for (const double nu : {0., .3, .5}) {
        const DocumentSection section = creep_section(report_of(nu));
        ASSERT_EQ(section.tables.size(), 1U);
        ASSERT_EQ(section.tables[0].rows.size(), 9U);
        for (const auto& row : section.tables[0].rows)
            EXPECT_NEAR(number_in(row[1]), 4 * (2 - nu) / (4 - 3 * nu), 1e-12) << nu;
    }
}

TEST(TractiveReport, ReadsTheTransient) {
    const RollingReport report = report_of(.5);
    // 1 + exp(-3 way) is within 1 % from way 2 on.
    EXPECT_NEAR(steady_after(report, report.runs[0]).value(), 2, 1e-12);
    EXPECT_NEAR(energy_error(report.runs[0].history.steady, .57).value(), 0, 1e-15);
    RollingState still = report.runs[0].history.steady;
    still.creepage = {};
    EXPECT_FALSE(energy_error(still, .57));
    EXPECT_FALSE(creepage_at(report.runs[0], .57, .999));
}

TEST(TractiveReport, CentreLineIsTheRowThroughTheCentre) {
    const CentreLine line = centre_line(three_cells(), .5, 0);
    EXPECT_EQ(line.x, (std::vector<double>{-1e-3, 0, 1e-3}));
    EXPECT_EQ(line.traction, (std::vector<double>{1e5, 5e4, 0}));
    EXPECT_EQ(line.bound, (std::vector<double>{1e5, 2e5, 0}));
}

TEST(TractiveReport, HasAllSectionsAndIsADocument) {
    RollingReport report = report_of(.5);
    report.command = "tricontact roll case.toml";
    const Document document = rolling_document(report);
    std::vector<std::string> ids;
    for (const DocumentSection& section : document.sections) ids.push_back(section.id);
    EXPECT_EQ(ids,
              (std::vector<std::string>{"steady_section", "transient", "creep_section", "zones"}));
    ASSERT_EQ(document.verdicts.size(), 4U);
    EXPECT_NE(document.verdicts[2].sentence.find("MDR creeps 2.40 times as much"),
              std::string::npos)
        << document.verdicts[2].sentence;
    EXPECT_NE(document.verdicts[3].sentence.find("differs"), std::string::npos);
    EXPECT_NE(document_html(document).find("creep"), std::string::npos);
}

TEST(TractiveReport, NumbersAsJsonAndCsv) {
    const RollingReport report = report_of(.5);
    const auto json = rolling_json(report);
    EXPECT_EQ(json.at("models").size(), 2U);
    EXPECT_NEAR(json["models"][0]["steady"]["force_ratio"].get<double>(), force, 1e-12);
    EXPECT_NEAR(json.at("thesis_creep_ratio").get<double>(), 2.4, 1e-12);
    EXPECT_EQ(json.at("theories").size(), 4U);
    const std::string history = history_csv(report.runs[0]);
    EXPECT_EQ(std::count(history.begin(), history.end(), '\n'), 1 + 4 + 1);
    const std::string curves = creep_csv(report);
    const auto rows = std::count(curves.begin(), curves.end(), '\n');
    EXPECT_EQ(rows, 1 + (2 + 4) * static_cast<int>(report.runs[0].creep_curve.size()));
}

// A lateral creepage or a spin is none of what closed forms assume.
TEST(TractiveReport, ClosedFormsDoNotStandBesideSpin) {
    RollingReport report = report_of(.5);
    report.c.tractive_rolling->spin = 3;
    EXPECT_TRUE(rolling_json(report).at("theories").empty());
    EXPECT_EQ(steady_section(report).tables.size(), 1U);
    for (const Curve& curve : creep_section(report).figures[0].curves) EXPECT_FALSE(curve.theory);
}

TEST(CreepTheories, OfACylinderAreCarters) {
    Case c = rubber(.5);
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.length = .1;
    const auto theories = creep_theories(c);
    ASSERT_EQ(theories.size(), 1U);
    EXPECT_NEAR(theories[0].creepage(.75) / creepage_unit(c), .5, 1e-14);
    EXPECT_NEAR(theories[0].force_ratio(theories[0].creepage(.3)), .3, 1e-14);
}

}  // namespace
}  // namespace tricontact::comparisons::tractive
