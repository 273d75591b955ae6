#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "comparisons/quantities/relaxation_study.h"
#include "comparisons/quantities/results.h"
#include "comparisons/run/reading.h"
#include "comparisons/run/relaxation_report.h"
#include "comparisons/run/report.h"
#include "io/case/case_input.h"
#include "tests/unit/comparisons/document.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::relaxation_test {
namespace {

using contact::Case;
using contact::Relaxation;
using contact::State;

/// Two branches; G = 1/2, W = 0.24, v = 0.3: f = 0.3125 Hz.
Case relaxing_case() {
    Case c = synthetic::unit_case();
    c.relaxation = Relaxation{{{0.3, 0.7}, {0.2, 11}}};
    c.rolling->speed = 0.3;
    c.load.hold = 60;
    return c;
}

/// Of a wave of period 4 W/v through Maxwell elements beside a spring, by their differential
/// equation: s' = g e' - s/tau, driven until periodic, then projected onto sine and cosine.
std::complex<double> modulus_by_integration(const Relaxation& relaxation, double omega) {
    constexpr int n = 4000;  // steps of a period: the trapezoidal rule is off by 1e-7
    const double period = 2 * std::numbers::pi / omega, dt = period / n;
    std::complex<double> modulus = 1;
    for (const auto& branch : relaxation.branches) {
        const int settled = static_cast<int>(std::ceil(20 * branch.time / period));
        double s = 0;
        std::complex<double> projected = 0;
        for (int k = 0; k < (settled + 1) * n; ++k) {
            const double now = omega * k * dt, next = omega * (k + 1) * dt;
            const double growth = branch.ratio * (std::sin(next) - std::sin(now));
            s = (s * (1 - dt / (2 * branch.time)) + growth) / (1 + dt / (2 * branch.time));
            if (k >= settled * n)
                projected += s * std::complex(std::sin(next), std::cos(next)) * (2. / n);
        }
        modulus += projected;
    }
    return modulus;
}

TEST(RelaxationStudy, DriveIsASineOncePerPathOfFourAmplitudes) {
    const Case c = relaxing_case();
    const DriveValues drive = drive_values(c, 0.24).value();
    EXPECT_DOUBLE_EQ(drive.frequency, 0.3 / 0.96);
    const double omega = 2 * std::numbers::pi * drive.frequency;
    const auto expected = 0.5 * modulus_by_integration(*c.relaxation, omega);
    // What the integration is good for.
    EXPECT_NEAR(drive.storage, expected.real(), 1e-6);
    EXPECT_NEAR(drive.loss, expected.imag(), 1e-6);
    EXPECT_DOUBLE_EQ(drive.loss_tangent(), drive.loss / drive.storage);
    ASSERT_EQ(drive.deborah.size(), 2u);
    EXPECT_DOUBLE_EQ(drive.deborah[0], omega * 0.7);
    EXPECT_DOUBLE_EQ(drive.deborah[1], omega * 11);
}

TEST(RelaxationStudy, NoDriveWithoutMotionOrRelaxation) {
    Case c = relaxing_case();
    EXPECT_FALSE(drive_values(c, 0));
    c.rolling->speed = 0;
    EXPECT_FALSE(drive_values(c, 0.24));
    c = relaxing_case();
    c.relaxation.reset();
    EXPECT_FALSE(drive_values(c, 0.24));
    c = relaxing_case();
    c.rolling.reset();
    EXPECT_FALSE(drive_values(c, 0.24));
}

TEST(RelaxationStudy, TwinIsElasticAndKnowsNoTimes) {
    Case c = relaxing_case();
    c.load.press_time = 2;
    const Case twin = elastic_twin(c);
    EXPECT_FALSE(twin.relaxation);
    EXPECT_FALSE(twin.load.press_time);
    EXPECT_EQ(twin.load.hold, 0);
    EXPECT_EQ(twin.rolling->speed, 0);
    EXPECT_EQ(twin.substrate.young, c.substrate.young);  // relaxed
    EXPECT_EQ(twin.rolling->amplitude_ratio, c.rolling->amplitude_ratio);
}

RunValues shifts(State state, double static_shift, double final_shift, double increment) {
    return {static_shift, state, final_shift, increment, 0.6};
}

TEST(RelaxationStudy, ComparesOnlyWhatIsAlike) {
    TwinComparison twin;
    twin.run = shifts(State::shakedown, 0.4, 0.8, 0.001);
    EXPECT_FALSE(twin.static_error());
    EXPECT_FALSE(twin.final_error());
    twin.other = shifts(State::shakedown, 0.5, 0.6, 0.002);
    EXPECT_DOUBLE_EQ(*twin.static_error(), 0.25);
    EXPECT_DOUBLE_EQ(*twin.final_error(), 0.6 / 0.8 - 1);
    EXPECT_DOUBLE_EQ(*twin.settled_error(), 0.6 / 0.8 - 1);
    EXPECT_FALSE(twin.increment_error());
    EXPECT_FALSE(judged_by_increment(*twin.other));

    twin.run.state = State::undecided;
    EXPECT_TRUE(twin.final_error());
    EXPECT_FALSE(twin.settled_error());

    twin.run.state = twin.other->state = State::ratcheting;
    EXPECT_FALSE(twin.settled_error());
    EXPECT_DOUBLE_EQ(*twin.increment_error(), 1);
    EXPECT_TRUE(judged_by_increment(*twin.other));
    EXPECT_DOUBLE_EQ(*twin_error(*twin.other, twin.run), 1);

    twin.run.increment = 0;  // nothing to be relative to
    EXPECT_FALSE(twin.increment_error());
}

TEST(RelaxationStudy, RunValuesOfAHistory) {
    const contact::History rolled = synthetic::ratcheting_history("mdr", {.periods = 5}, 0.25);
    const RunValues values = run_values(rolled);
    EXPECT_EQ(values.static_shift, rolled.static_shift);
    EXPECT_DOUBLE_EQ(*values.final_shift, rolled.static_shift + 5 * 0.25);
    EXPECT_DOUBLE_EQ(*values.increment, 0.25);
    EXPECT_EQ(*values.state, State::ratcheting);
    EXPECT_EQ(*values.limit, rolled.limit_tangential_ratio);
    const RunValues still = run_values(synthetic::loaded_history("mdr"));
    EXPECT_FALSE(still.final_shift || still.increment || still.state);
}

const Relaxation one_branch{{{0.3, 0.7}}};

/// Error of a solid whose loss is what errs: g De/(1 + De^2), passes 1 % where De solves a
/// quadratic equation.
double debye_peak(double speed, double time, double amplitude) {
    const double deborah = std::numbers::pi * speed * time / (2 * amplitude);
    return 0.3 * deborah / (1 + deborah * deborah);
}

TEST(RelaxationSpeedLimit, FindsTheSlowestSpeedOfAKnownError) {
    // 0.3 De = 0.01 (1 + De^2), the smaller root.
    const double deborah = (30 - std::sqrt(30 * 30 - 4)) / 2;
    const double amplitude = 0.24, exact = deborah * 2 * amplitude / (std::numbers::pi * 0.7);
    const SpeedLimit limit = find_speed_limit(
        one_branch, amplitude, [&](double v) { return debye_peak(v, 0.7, amplitude); });
    ASSERT_TRUE(limit.speed) << limit.why_none;
    EXPECT_NEAR(*limit.speed / exact, 1, SpeedLimit::resolution);
    EXPECT_DOUBLE_EQ(*limit.frequency, *limit.speed / (4 * amplitude));
    EXPECT_LE(limit.slowest, *limit.speed);
    EXPECT_GE(limit.fastest, *limit.speed);
    // Two ends and a nearly straight line between them.
    EXPECT_LE(limit.runs, 6);
}

TEST(RelaxationSpeedLimit, DependsOnSpeedTimesTimeOverAmplitudeOnly) {
    const auto found = [](double time, double amplitude) {
        return *find_speed_limit({{{0.3, time}}}, amplitude, [&](double v) {
                    return debye_peak(v, time, amplitude);
                }).speed;
    };
    // The same runs, but for rounding.
    EXPECT_NEAR(found(0.07, 0.24) / found(0.7, 0.24), 10, 1e-9);
    EXPECT_NEAR(found(0.7, 0.48) / found(0.7, 0.24), 2, 1e-9);
}

TEST(RelaxationSpeedLimit, GoesDownIfTheFirstSpeedIsTooFast) {
    const SpeedLimit limit =
        find_speed_limit(one_branch, 1, [](double v) { return 30 * v; });  // 1 % at 1/3000
    EXPECT_NEAR(*limit.speed * 3000, 1, SpeedLimit::resolution);
}

TEST(RelaxationSpeedLimit, SaysWhenThereIsNone) {
    const SpeedLimit below = find_speed_limit(one_branch, 1, [](double) { return 0.009; });
    EXPECT_FALSE(below.speed || below.frequency);
    EXPECT_NE(below.why_none.find("stays less"), std::string::npos);
    EXPECT_EQ(below.runs, 5);  // De from 0.01 to 100
    const SpeedLimit above = find_speed_limit(one_branch, 1, [](double) { return 0.2; });
    EXPECT_FALSE(above.speed);
    EXPECT_NE(above.why_none.find("still more"), std::string::npos);
    EXPECT_EQ(above.runs, 3);  // De from 0.01 down to 1e-4
    const SpeedLimit zero = find_speed_limit(one_branch, 1, [](double) { return 0.; });
    EXPECT_NE(zero.why_none.find("stays less"), std::string::npos);
}

TEST(RelaxationSpeedLimit, FailingRunsEndTheSearchWithTheirMessage) {
    const SpeedLimit failed = find_speed_limit(one_branch, 1, [](double) -> std::optional<double> {
        throw contact::NotConverged("no convergence");
    });
    EXPECT_FALSE(failed.speed);
    EXPECT_EQ(failed.why_none, "no convergence");
    // A failure of the program is no finding.
    EXPECT_THROW(find_speed_limit(one_branch, 1,
                                  [](double) -> std::optional<double> {
                                      throw std::runtime_error("a file is gone");
                                  }),
                 std::runtime_error);
    const SpeedLimit undefined =
        find_speed_limit(one_branch, 1, [](double) { return std::optional<double>(); });
    EXPECT_NE(undefined.why_none.find("undefined"), std::string::npos);
}

RelaxationStudy study(const Case& c) {
    RelaxationStudy result;
    for (const char* model : {"mdr", "bem"}) {
        TwinComparison twin;
        twin.model = model;
        twin.drive = drive_values(c, 0.24);
        twin.run = shifts(State::shakedown, 0.4, 0.8, 1e-8);
        result.twins.push_back(twin);
    }
    result.twins[0].other = shifts(State::shakedown, 0.4, 0.6, 1e-8);
    result.twins[1].why_none = "no end";
    result.limit = SpeedLimit{"mdr", false, 0.03, 0.03125, 0.001, 0.1, 4, ""};
    return result;
}

std::string joined(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += sentence + "\n";
    return text;
}

TEST(RelaxationReport, SaysWhetherTheSubstrateMayBeTakenAsElastic) {
    const Case c = relaxing_case();
    const std::string text = joined(relaxation_sentences(c, study(c)));
    for (const char* part : {"relaxes from 750.0 mPa to 500.0 mPa, by 2 terms of 700 ms to 11.0 s",
                             "At 300 mm/s the rolling repeats itself with 0.312 Hz",
                             "Up to a drive of 30.0 mm/s", "this case is 10.0 times faster",
                             "the settled shift would be 600.0 mm instead of 800.0 mm "
                             "(−25.0 %); both: shakedown",
                             "BEM: no elastic reference run: no end.", "load.hold = 60 s"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\nin: " << text;
    EXPECT_EQ(text.find("dma"), std::string::npos);

    RelaxationStudy other = study(c);
    other.twins[0].other->state = State::undecided;
    other.limit->speed.reset();
    other.limit->why_none = "it stays less";
    const std::string unsure = joined(relaxation_sentences(c, other));
    EXPECT_NE(unsure.find("this does not resolve: run more periods"), std::string::npos) << unsure;
    EXPECT_NE(unsure.find("No drive speed was found (4 runs by MDR)"), std::string::npos) << unsure;
}

TEST(RelaxationReport, AnotherVerdictIsWhatCounts) {
    const Case c = relaxing_case();
    RelaxationStudy other = study(c);
    other.twins[0].run.state = State::ratcheting;
    other.twins[0].run.limit = 0.55;
    const std::string text = twin_sentence(other.twins[0]);
    EXPECT_EQ(text,
              "MDR: taken as elastic, it would settle, but it ratchets: f_T,lim = 0.6000 instead "
              "of 0.5500.");
}

TEST(RelaxationReport, ElasticLimitDecidesNothing) {
    const Case c = relaxing_case();
    Results undecided(c, synthetic::settling_history("mdr"));
    undecided.set(quantities::state, State::undecided);
    const std::string text = joined(reading(c, {undecided}));
    EXPECT_EQ(text.find("By the exact limit it must"), std::string::npos) << text;
    EXPECT_NE(text.find("expected under a drive so slow"), std::string::npos) << text;
}

TEST(RelaxationReport, TableHasAColumnPerModelAndABranchPerRow) {
    const Case c = relaxing_case();
    const report::DocumentTable table = relaxation_table(c, study(c));
    ASSERT_EQ(table.columns.size(), 4u);
    int n_branches = 0;
    for (const auto& row : table.rows) {
        ASSERT_EQ(row.size(), 4u);
        const auto& name = std::get<std::string>(row[0]);
        n_branches += name.starts_with("drive: Deborah");
        if (name != "error of the elastic substrate: settled shift") continue;
        EXPECT_NEAR(std::get<double>(row[2]), -25, 1e-9);
        EXPECT_TRUE(std::isnan(std::get<double>(row[3])));
    }
    EXPECT_EQ(n_branches, 2);
}

TEST(RelaxationReport, DmaFitIsToldAndDrawn) {
    Case c = relaxing_case();
    const RelaxationStudy without = study(c);
    EXPECT_EQ(modulus_figures(c, without).size(), 1u);
    EXPECT_TRUE(relaxation_json(c, without)["dma_fit"].is_null());

    contact::DmaTable measured{"dma.csv", {}, {}, {}};
    for (double omega = 0.01; omega < 30; omega *= 1.7) {
        const auto modulus = 0.5 * c.relaxation->dynamic_ratio(omega);
        measured.omega.push_back(omega);
        measured.storage.push_back(modulus.real());
        measured.loss.push_back(modulus.imag());
    }
    c.of<io::RelaxationFits>().dma = contact::fit_prony(measured);
    const auto figures = modulus_figures(c, without);
    ASSERT_EQ(figures.size(), 2u);
    EXPECT_EQ(figures[0].curves.back().name, "G″, measured");
    EXPECT_EQ(figures[0].curves.back().x.size(), measured.size());
    EXPECT_EQ(figures[1].id, "modulus_residuals");
    for (const double residual : figures[1].curves.front().y)
        EXPECT_LT(std::abs(residual), 1e-3);  // [%]
    const auto fit = relaxation_json(c, without)["dma_fit"];
    EXPECT_EQ(fit["rows"], measured.size());
    EXPECT_LT(fit["storage_residual_rms"].get<double>(), 1e-6);  // the table is a Prony series
    EXPECT_NE(joined(relaxation_sentences(c, without)).find("fitted to"), std::string::npos);
}

TEST(RelaxationReport, SectionStandsInSummaryAndReportOfRelaxingCasesOnly) {
    const Case c = relaxing_case();
    const auto section = nlohmann::json::parse(summary_json(
        "1", nullptr, {}, {{"relaxation", relaxation_json(c, study(c))}}))["relaxation"];
    EXPECT_DOUBLE_EQ(section["instantaneous_shear_modulus_Pa"], 0.75);
    EXPECT_DOUBLE_EQ(section["models"]["mdr"]["settled_shift_error"], 0.6 / 0.8 - 1);
    EXPECT_TRUE(section["models"]["bem"]["elastic_twin"].is_null());
    EXPECT_EQ(section["models"]["bem"]["why_no_twin"], "no end");
    EXPECT_DOUBLE_EQ(section["elastic_up_to"]["speed_m_per_s"], 0.03);

    ReportExtras extras;
    extras.relaxation = study(c);
    const auto document = run_document(c, "case", "1", synthetic::two_models(), extras);
    EXPECT_TRUE(find_section(document, "relaxation"));
    EXPECT_EQ(find_section(document, "plots")->figures.back().id, "modulus");
    EXPECT_FALSE(find_section(
        run_document(synthetic::unit_case(), "case", "1", synthetic::two_models(), extras),
        "relaxation"));
}

}  // namespace
}  // namespace tricontact::comparisons::relaxation_test
