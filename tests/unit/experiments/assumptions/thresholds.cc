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
using Data = std::map<std::string, double>;

Rig rig_with(const std::string& name, const Data& data) {
    Rig rig = rig_file(name);
    for (const auto& [symbol, value] : data) rig.data[symbol] = {value};
    return rig;
}

/// All data that a rig may state, harmless.
const Data sphere_data{{"rho", 1100}, {"eta", 40},   {"G_2/G_1", 10}, {"v", 1e-3},     {"f_1", 22},
                       {"DU", 1e-6},  {"w'", .25},   {"Dgamma", .05}, {"h_rms", 1e-6}, {"s_rms", 2},
                       {"k_th", .2},  {"c_T", 3e-3}, {"k_w", 1e-14},  {"n", 12},       {"l_x", .08},
                       {"l_y", .08},  {"theta", 0}};

Data changed(Data data, const Data& other) {
    for (const auto& [symbol, value] : other) data[symbol] = value;
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
    look(rig_with("sphere_parallel", changed(sphere_data, {{"Dgamma", 50},
                                                           {"h_rms", 1e-4},
                                                           {"s_rms", .05},
                                                           {"v", 2},
                                                           {"k_w", 1e-9},
                                                           {"n", 1e5},
                                                           {"DU", 9e-5},
                                                           {"eta", 4e4},
                                                           {"l_x", .018},
                                                           {"l_y", .018},
                                                           {"theta", .1}})),
         .2, sides);
    look(rig_with("sphere_parallel", changed(sphere_data, {{"b", .8}})), 0, sides);
    look(rig_with("sphere_parallel", changed(sphere_data, {{"F_N", 400}, {"l_x", .008}})), 0,
         sides);
    expect_both(sides, 24,
                {"small_strains: strain_shift_error", "small_strains: strain_indentation_error"});
    // The fit of finite strains ends at a/R = 0.22, where its error of the shift is some 4 %.
    const auto beyond =
        experiments::check_rig(rig_with("sphere_parallel", changed(sphere_data, {{"F_N", 400}})));
    EXPECT_TRUE(assumption_of(beyond, "small_strains").criteria.empty());
    EXPECT_EQ(assumption_of(beyond, "small_strains").standing(),
              experiments::Standing::not_testable);
}

TEST(Thresholds, OfACylinderHaveBothSides) {
    const Data data = changed(sphere_data, {{"L", .2}, {"theta'", 0}});
    std::map<std::string, Sides> sides;
    look(rig_with("cylinder_parallel", data), 0, sides);
    look(rig_with("cylinder_parallel", changed(data, {{"b", .1}})), 0, sides);
    look(rig_with("cylinder_parallel", changed(data, {{"b", .4}, {"DU", 1e-7}, {"l_x", .04}})), 0,
         sides);
    look(rig_with("cylinder_parallel", changed(data, {{"b", 2e-3},
                                                      {"L", 2e-2},
                                                      {"h_rms", 2e-4},
                                                      {"s_rms", .05},
                                                      {"v", 2},
                                                      {"DU", 9e-5},
                                                      {"eta", 4e4},
                                                      {"l_x", .004},
                                                      {"theta", .1},
                                                      {"theta'", .01}})),
         .2, sides);
    expect_both(sides, 14);
}

TEST(Thresholds, OfAWalkingRigHaveBothSides) {
    std::map<std::string, Sides> sides;
    for (const char* name : {"micro_walking_set_1", "micro_walking_set_5"})
        look(rig_with(name, {}), 0, sides);
    Rig exact = rig_with("micro_walking_set_5", {});
    for (auto& [symbol, number] : exact.data) number.standard_error = 0;
    look(exact, 0, sides);
    const Data& five = [&] {
        Data all;
        for (const auto& [symbol, number] : exact.data) all[symbol] = number.value;
        return all;
    }();
    look(rig_with("micro_walking_set_5", {{"D_c", .1 * five.at("D_c")},
                                          {"D_wear", 10 * five.at("D_c")},
                                          {"kappa_8", 100},
                                          {"l_s", .01 * five.at("l_s")},
                                          {"f_samp", .01 * five.at("f_samp")}}),
         0, sides);
    look(rig_with("micro_walking_set_5", {{"E_s", 1e-6 * five.at("E_s")}}), 0, sides);
    expect_both(sides, 9);
}

}  // namespace
}  // namespace tricontact::threshold_test
