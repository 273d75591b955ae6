// Every criterion that a rig check knows has a rig that meets it and one that does not. Criteria
// are found in the reports, so that a new one fails here until it has both; their numbers are held
// against closed forms beside this file.
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::threshold_test {
namespace {

using experiments::Rig;
using Data = RigChanges;

Rig rig_with(const std::string& name, const Data& data) {
    return changed(rig_file(name), data);
}

/// All data that a rig may state, harmless.
const Data sphere_data{{&Rig::rho, 1100},    {&Rig::eta, 40},     {&Rig::G_ratio, 10},
                       {&Rig::v, 1e-3},      {&Rig::f_1, 22},     {&Rig::DU, 1e-6},
                       {&Rig::w_pivot, .25}, {&Rig::Dgamma, .05}, {&Rig::h_rms, 1e-6},
                       {&Rig::s_rms, 2},     {&Rig::k_th, .2},    {&Rig::c_T, 3e-3},
                       {&Rig::k_w, 1e-14},   {&Rig::n, 12},       {&Rig::l_x, .08},
                       {&Rig::l_y, .08},     {&Rig::theta, 0}};

Data changed(Data data, const Data& other) {
    data.insert(data.end(), other.begin(), other.end());
    return data;
}

/// Whether criteria are met somewhere, and are not.
struct Sides {
    bool met = false, violated = false;
};

/// `by`: coupling and rolling on the layer change the shift by this share.
void look(const Rig& rig, double by, std::map<std::string, Sides>& sides) {
    const auto shift = [by](const Rig&, bool coupled) { return coupled ? 1 + by : 1.; };
    const auto growth = [by](const Rig&) {
        return std::optional(experiments::Growth{1e-3, .3, {1.2}, {1.2 * (1 + by)}});
    };
    for (const auto& assumption : experiments::check_rig(rig, shift, growth).assumptions)
        for (const auto& criterion : assumption.criteria) {
            Sides& found = sides[assumption.name + ": " + criterion.calculation.name];
            (criterion.is_met_by(criterion.calculation.result.value) ? found.met : found.violated) =
                true;
        }
}

/// `within`: criteria whose formula ends before it reaches the threshold; beyond it the assumption
/// is not testable.
void expect_both(const std::map<std::string, Sides>& sides, std::size_t at_least,
                 const std::set<std::string>& within = {}) {
    EXPECT_GE(sides.size(), at_least);
    for (const auto& [name, found] : sides) {
        EXPECT_TRUE(found.met) << name << " is met by no rig";
        EXPECT_EQ(found.violated, !within.contains(name)) << name;
    }
}

TEST(Thresholds, OfASphereHaveBothSides) {
    std::map<std::string, Sides> sides;
    look(rig_with("sphere_parallel", sphere_data), 0, sides);
    look(rig_with("sphere_parallel", changed(sphere_data, {{&Rig::Dgamma, 50},
                                                           {&Rig::h_rms, 1e-4},
                                                           {&Rig::s_rms, .05},
                                                           {&Rig::v, 2},
                                                           {&Rig::k_w, 1e-9},
                                                           {&Rig::n, 1e5},
                                                           {&Rig::DU, 9e-5},
                                                           {&Rig::eta, 4e4},
                                                           {&Rig::l_x, .018},
                                                           {&Rig::l_y, .018},
                                                           {&Rig::theta, .1}})),
         .2, sides);
    look(rig_with("sphere_parallel", changed(sphere_data, {{&Rig::b, .8}})), 0, sides);
    look(rig_with("sphere_parallel", changed(sphere_data, {{&Rig::F_N, 400}, {&Rig::l_x, .008}})),
         0, sides);
    expect_both(sides, 24,
                {"small_strains: strain_shift_error", "small_strains: strain_indentation_error"});
    // The fit of finite strains ends at a/R = 0.22, where its error of the shift is some 4 %.
    const auto beyond = experiments::check_rig(
        rig_with("sphere_parallel", changed(sphere_data, {{&Rig::F_N, 400}})));
    EXPECT_TRUE(assumption_of(beyond, "small_strains").criteria.empty());
    EXPECT_EQ(assumption_of(beyond, "small_strains").standing(),
              experiments::Standing::not_testable);
}

TEST(Thresholds, OfACylinderHaveBothSides) {
    const Data data = changed(sphere_data, {{&Rig::L, .2}, {&Rig::theta_axis, 0}});
    std::map<std::string, Sides> sides;
    look(rig_with("cylinder_parallel", data), 0, sides);
    look(rig_with("cylinder_parallel", changed(data, {{&Rig::b, .1}})), 0, sides);
    look(rig_with("cylinder_parallel",
                  changed(data, {{&Rig::b, .4}, {&Rig::DU, 1e-7}, {&Rig::l_x, .04}})),
         0, sides);
    look(rig_with("cylinder_parallel", changed(data, {{&Rig::b, 2e-3},
                                                      {&Rig::L, 2e-2},
                                                      {&Rig::h_rms, 2e-4},
                                                      {&Rig::s_rms, .05},
                                                      {&Rig::v, 2},
                                                      {&Rig::DU, 9e-5},
                                                      {&Rig::eta, 4e4},
                                                      {&Rig::l_x, .004},
                                                      {&Rig::theta, .1},
                                                      {&Rig::theta_axis, .01}})),
         .2, sides);
    expect_both(sides, 14);
}

TEST(Thresholds, OfAWalkingRigHaveBothSides) {
    std::map<std::string, Sides> sides;
    for (const char* name : {"micro_walking_set_1", "micro_walking_set_5"})
        look(rig_with(name, {}), 0, sides);
    Rig exact = rig_with("micro_walking_set_5", {});
    for (const auto& one : experiments::rig_quantities(exact.kind))
        (exact.*one.number).standard_error = 0;
    look(exact, 0, sides);
    look(rig_with("micro_walking_set_5", {{&Rig::D_c, .1 * exact.D_c},
                                          {&Rig::D_wear, 10 * exact.D_c},
                                          {&Rig::kappa_8, 100},
                                          {&Rig::l_s, .01 * exact.l_s},
                                          {&Rig::f_samp, .01 * exact.f_samp}}),
         0, sides);
    look(rig_with("micro_walking_set_5", {{&Rig::E_s, 1e-6 * exact.E_s}}), 0, sides);
    expect_both(sides, 9);
}

}  // namespace
}  // namespace tricontact::threshold_test
