#include "runs/case_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/models/make_model.h"
#include "contact/base/error.h"
#include "mdr/settings.h"
#include "runs/further_runs.h"
#include "runs/numerical_error.h"

namespace tricontact::case_run_test {
namespace {

using contact::Case;
using runs::RunOptions;

constexpr double load = .56, friction = .57, normal_force = 21.1;

/// Of nu = 0, for which Cattaneo and Mindlin are exact without coupling.
Case sphere() {
    Case c;
    c.models = {contact::models::mdr};
    c.indenter.radius = .04;
    c.substrate = {5.2e6, 0};
    c.friction.coefficient = friction;
    c.contact.coupling = false;
    c.load.normal_force = normal_force;
    c.load.tangential_ratio = load;
    return c;
}

RunOptions quiet_options(bool studies) {
    RunOptions options;
    options.quiet = true;
    options.makers = &app::model_makers();
    options.studies = studies;
    return options;
}

runs::CaseRun run_of(const Case& c, bool studies) {
    const RunOptions options = quiet_options(studies);
    return runs::run_models(c, options, contact::silent,
                            [&](const std::string& name, comparisons::LoadingStudy* study) {
                                return runs::studied_history(name, c, options, contact::silent, {},
                                                             study);
                            });
}

// Johnson, Contact Mechanics (1985), eqs. 4.22, 4.23 and 7.42b. Errors of springs are of the
// second order: 10000 are exact to 1e-8.
TEST(CaseRun, SummaryHasHertzAndMindlin) {
    const auto summary = nlohmann::json::parse(runs::summary_of(run_of(sphere(), false)));
    const auto& mdr = summary.at("models").at("mdr");
    const double modulus = 5.2e6;  // E* = E under a rigid indenter
    const double radius = std::cbrt(3 * normal_force * .04 / (4 * modulus));
    EXPECT_NEAR(mdr.at("contact_radius_m").get<double>() / radius, 1, 1e-7);
    EXPECT_NEAR(mdr.at("indentation_m").get<double>() / (radius * radius / .04), 1, 1e-7);
    const double ratio = 1 - std::pow(1 - load, 2. / 3);
    EXPECT_NEAR(mdr.at("static_shift_ratio").get<double>() / ratio, 1, 1e-7);
    EXPECT_FALSE(summary.contains("numerical_error"));
}

// Of several models none is run first when another is missing.
TEST(CaseRun, AModelThatIsNotBuiltIsToldBeforeAnythingRuns) {
    Case c = sphere();
    c.models = {contact::models::mdr, contact::models::bem};
    contact::ModelMakers without = app::model_makers();
    without.has = [](std::string_view name) { return name == contact::models::mdr; };
    RunOptions options = quiet_options(false);
    options.makers = &without;
    const auto run_one = [](const std::string&, comparisons::LoadingStudy*) -> contact::History {
        ADD_FAILURE() << "a model ran";
        return {};
    };
    try {
        runs::run_models(c, options, contact::silent, run_one);
        FAIL() << "accepted";
    } catch (const contact::InputError& error) {
        EXPECT_STREQ(error.what(),
                     "models: this program was built without the model bem; name others");
    }
}

// The +- covers what springs are off Hertz' solution.
TEST(CaseRun, ErrorBarsCoverClosedForms) {
    Case c = sphere();
    c.of<mdr::Settings>().springs = 100;
    const auto run = run_of(c, true);
    ASSERT_TRUE(run.extras.numerical.has_value());
    EXPECT_EQ(run.extras.numerical->why_none, "");
    const auto scales = contact::half_space_scales(c);
    const double found = run.histories.front().scales.indentation;
    const auto bar = run.extras.numerical->of(comparisons::quantities::indentation);
    ASSERT_TRUE(bar.has_value());
    EXPECT_GT(*bar, 0);
    EXPECT_LE(std::abs(found - scales.indentation), *bar);
}

// A mesh that cannot be coarser leaves the run without a bar, and says why.
TEST(CaseRun, SaysWhyThereIsNoErrorBar) {
    contact::ModelMakers makers = app::model_makers();
    makers.make_coarser = [](auto&&...) -> contact::CoarserModel {
        throw contact::InputError("there is no coarser mesh");
    };
    RunOptions options = quiet_options(true);
    options.makers = &makers;
    const Case c = sphere();
    const auto history = options.runner().history_of(contact::models::mdr, c);
    const auto error = runs::numerical_error(c, history, options, contact::silent);
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->why_none, "there is no coarser mesh");
    EXPECT_FALSE(runs::numerical_error(c, history, quiet_options(false), contact::silent));
}

// An elastic case has no twin, a linear one no small strains: nothing runs beside it.
TEST(FurtherRuns, AddNothingToWhatHasNone) {
    const Case c = sphere();
    const RunOptions options = quiet_options(true);
    const auto history = options.runner().history_of(contact::models::mdr, c);
    comparisons::RelaxationStudy relaxation;
    runs::study_relaxation(c, history, options, contact::silent, relaxation);
    EXPECT_TRUE(relaxation.twins.empty());
    std::vector<comparisons::SmallStrains> strains;
    runs::study_small_strains(c, history, options, contact::silent, strains);
    EXPECT_TRUE(strains.empty());
    comparisons::LoadingStudy loading;  // mdr couples nothing
    runs::study_loading(c, *options.makers->make(contact::models::mdr, c, 1, contact::silent),
                        history, contact::silent, loading);
    EXPECT_TRUE(loading.variants.empty());
}

TEST(FurtherRuns, SayThatTheyWereSkipped) {
    Case c = sphere();
    c.relaxation = contact::Relaxation{{{1, .3}}, {}};
    const RunOptions options = quiet_options(false);
    const auto history = options.runner().history_of(contact::models::mdr, c);
    comparisons::RelaxationStudy study;
    runs::study_relaxation(c, history, options, contact::silent, study);
    ASSERT_EQ(study.twins.size(), 1U);
    EXPECT_EQ(study.twins.front().why_none, "skipped (--no-studies)");
}

TEST(SoundRun, NamesModelAndCheck) {
    contact::Audit audit;
    audit.record("friction_bound", 1e-9, 1e-6);
    contact::require_sound(audit, "bem");
    audit.record("energy_balance", .2, 1e-3);
    try {
        contact::require_sound(audit, "bem");
        FAIL() << "not refused";
    } catch (const contact::NotConverged& why) {
        EXPECT_STREQ(why.what(), "bem: energy_balance is 2.00e-01, allowed 1.0e-03");
    }
}

}  // namespace
}  // namespace tricontact::case_run_test
