// An indenter that deforms: as large as a half-space? Its contacts come from models that the caller
// has.
#include <cmath>

#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::indenter_test {
namespace {

using experiments::BodyContact;
using experiments::IndenterContacts;
using experiments::Rig;

/// As soft as its substrate; its numbers are exact unless `error` [%] says otherwise.
Rig soft_rig(bool has_body, double error = 0) {
    Rig rig = rig_file("sphere_parallel");
    rig.E_1 = {rig.E_2.value, .01 * error * rig.E_2.value};
    rig.nu_1 = {rig.nu_2.value};
    for (auto* number : {&rig.R, &rig.F_N, &rig.E_2, &rig.nu_2}) *number = {number->value};
    if (has_body) rig.c.indenter.body = contact::ElasticBody{};
    rig.printed.clear();
    return rig;
}

/// As a half-space everything is `off` more.
experiments::IndenterRun runs(double off) {
    return [off](const Rig&) {
        const BodyContact body{{1e-3, 1e-7}, {5e-3, 1e-6}, {3e5, 30}, {NAN}};
        IndenterContacts contacts{body, body};
        for (auto* one : {&contacts.half_space.indentation, &contacts.half_space.contact_radius,
                          &contacts.half_space.peak_pressure})
            one->value *= 1 + off;
        return std::optional(contacts);
    };
}

bool is_listed(const experiments::RigReport& report) {
    return std::ranges::any_of(report.assumptions,
                               [](const auto& one) { return one.name == "half_space_indenter"; });
}

TEST(RigIndenter, IsNoMatterWhereItIsRigid) {
    EXPECT_FALSE(is_listed(experiments::check_rig(rig_file("sphere_parallel"), {}, {}, runs(.2))));
}

TEST(RigIndenter, IsNotTestableByTheNamesOfMissingKeys) {
    const auto report = experiments::check_rig(soft_rig(false), {}, {}, runs(.2));
    const auto& one = assumption_of(report, "half_space_indenter");
    EXPECT_EQ(one.standing(), experiments::Standing::not_testable);
    EXPECT_EQ(one.missing, (std::vector<std::string>{"indenter.body", "indenter.support"}));
    EXPECT_TRUE(one.consequence.empty()) << one.consequence;
    // Nor without a model.
    const auto none = experiments::check_rig(soft_rig(true));
    EXPECT_EQ(assumption_of(none, "half_space_indenter").standing(),
              experiments::Standing::not_testable);
}

TEST(RigIndenter, HasBothSidesOfItsThreshold) {
    const auto standing = [](double off) {
        const auto report = experiments::check_rig(soft_rig(true), {}, {}, runs(off));
        return assumption_of(report, "half_space_indenter").standing();
    };
    EXPECT_EQ(standing(.04), experiments::Standing::holds);
    EXPECT_EQ(standing(.06), experiments::Standing::violated);
    const auto report = experiments::check_rig(soft_rig(true), {}, {}, runs(.06));
    const auto& one = assumption_of(report, "half_space_indenter");
    EXPECT_NEAR(one.deciding_value(), .06, 1e-12);
    EXPECT_NE(one.consequence.find("the indentation 6.00 % too high"), std::string::npos)
        << one.consequence;
}

// d goes with E*^(-2/3): of equal bodies 12 % of E_1 are 6 % of 1/E* and 4 % of d, 2 % of a.
TEST(RigIndenter, IsHeldAgainstTheErrorsThatTheRigStates) {
    const auto report = experiments::check_rig(soft_rig(true, 12), {}, {}, runs(.03));
    const auto& one = assumption_of(report, "half_space_indenter");
    EXPECT_NEAR(one.criteria[0].threshold, .04, 1e-5);
    EXPECT_NEAR(one.criteria[1].threshold, .02, 1e-5);
    EXPECT_EQ(one.criteria[0].standing(), experiments::Standing::holds);
    EXPECT_EQ(one.criteria[1].standing(), experiments::Standing::violated);
    EXPECT_NE(one.criteria[0].reason.find("standard error"), std::string::npos);
}

}  // namespace
}  // namespace tricontact::indenter_test
