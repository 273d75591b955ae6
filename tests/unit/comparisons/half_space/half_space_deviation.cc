#include "comparisons/half_space/half_space_deviation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "comparisons/half_space/deviation_output.h"
#include "contact/base/error.h"
#include "io/case/case_reader.h"
#include "report/table_text.h"
#include "tests/unit/comparisons/layer_rig.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons::half_space_deviation_test {
namespace {

using contact::State;

using contact::Case;
using synthetic::layer_rig;
using json = nlohmann::ordered_json;

TEST(HalfSpaceDeviation, TakesForceAndAmplitudeFromTheCase) {
    const DeviationContact contact = deviation_contact(layer_rig());
    EXPECT_NEAR(contact.hertz_diameter, 2 * 4.5028e-3, 2e-7);
    EXPECT_NEAR(contact.amplitude_ratio, .24 * 4.5028 / 4.3638, 1e-5);  // over the layer's a
    Case c = layer_rig();
    c.rolling->amplitude_reference = Case::AmplitudeReference::model;
    EXPECT_NEAR(deviation_contact(c).amplitude_ratio, .24, 1e-12);
    c.load.normal_force.reset();
    c.load.indentation = .3229e-3;  // what the force makes on the layer
    EXPECT_NEAR(deviation_contact(c).normal_force, 21.1, .005);
    c.load.tangential_ratio.reset();
    c.load.tangential_force = 6;
    EXPECT_NEAR(deviation_contact(c).tangential_ratio, 6 / (.57 * 21.1), 2e-4);
}

TEST(HalfSpaceDeviation, RefusesWhatItCannotAnswer) {
    const auto refusal = [](auto change) -> std::string {
        Case c = layer_rig();
        change(c);
        try {
            deviation_contact(c);
        } catch (const contact::InputError& error) {
            return error.what();
        }
        return {};
    };
    const auto expect = [](const std::string& text, const char* part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    expect(refusal([](Case& c) { c.layer.thickness.reset(); }), "substrate.thickness is missing");
    expect(refusal([](Case& c) { c.layer.lower.push_back({1e-3, {1e6, .3}}); }), "one layer");
    expect(refusal([](Case& c) { c.indenter.material = contact::Material{5e6, .5}; }), "rigid");
    expect(refusal([](Case& c) { c.load.normal_amplitude_ratio = .1; }), "constant loads");
    expect(refusal([](Case& c) { c.relaxation.emplace(); }), "substrate.relaxation");
    expect(refusal([](Case& c) { c.rolling->amplitude_ratio = 1.2; }), "w = W/a is at least 1");
    expect(refusal([](Case& c) { c.layer.thickness = 1e-6; }), "exceeds 32 thicknesses");
}

TEST(HalfSpaceDeviation, RollsOnBothSidesOfTheLimit) {
    const double limit = theory::amplitude_limit(.56);
    const RolledAmplitudes low = rolled_amplitudes(.24, .56), high = rolled_amplitudes(.5, .56);
    EXPECT_EQ(low.settling, .24);
    EXPECT_GT(low.ratcheting, limit);
    EXPECT_LT(low.ratcheting, 1);
    EXPECT_EQ(high.ratcheting, .5);
    EXPECT_LT(high.settling, limit);
}

TEST(HalfSpaceDeviation, ItsRunsAreCases) {
    const Case c = layer_rig();
    const DeviationContact contact = deviation_contact(c);
    const RolledAmplitudes amplitudes = rolled_amplitudes(.24, .56);
    for (const RolledBody body : {RolledBody{.25, .3, true}, RolledBody{.poisson = .5}})
        for (const RolledRun& run : runs_on(body, amplitudes)) {
            const Case mine = rolled_case(c, contact, amplitudes, run);
            const Case read = io::parse_case(io::write_case(mine), "run");
            // E* stays, so the diameter of Hertz' contact does.
            EXPECT_NEAR(2 * half_space_scales(read).contact_radius / contact.hertz_diameter, 1,
                        1e-12);
            EXPECT_EQ(read.models.front(), body.half_space() ? "bem" : "bem-layer");
        }
    EXPECT_EQ(runs_on({}, amplitudes).size(), 7u);
    EXPECT_EQ(runs_on({}, {}).size(), 3u);  // nothing rolls
}

/// What a run would say, U_max = 0.1 mm.
Results values(double u_stat, double u, double increment, State state) {
    constexpr double unit = 1e-4;
    using namespace quantities;
    Results r;
    const auto set = [&r](const Quantity& length, const Quantity& ratio, double value) {
        r.set(length, unit * value);
        r.set(ratio, value);
    };
    set(static_shift, static_shift_ratio, u_stat);
    set(shift_increment, shift_increment_ratio, increment);
    if (state == State::shakedown || state == State::cyclic_slip) {
        set(settled_shift, settled_shift_ratio, u);
        r.set(kappa, theory::mapping_parameter(.24, .56, u));
    }
    if (state == State::ratcheting) r.set(eta, 3 * increment);
    r.set(periods, 10);
    r.set(quantities::state, state);
    r.set(limit_tangential_ratio, .6);
    return r;
}

/// Runs on the half-space, of known mappings, and on a layer whose values are `factor` of them,
/// with `spread` less on the coarsest level and `step` more by half steps.
std::vector<RolledResult> made_up(const RolledAmplitudes& amplitudes, double factor, double spread,
                                  double step) {
    const double u = *theory::settled_shift_ratio(amplitudes.settling, .56, 1.1);
    std::vector<RolledResult> results;
    for (const bool layer : {true, false}) {
        RolledBody body{.poisson = .5};
        if (layer) body.thickness_ratio = .889;
        for (const RolledRun& run : runs_on(body, amplitudes)) {
            double scale = layer ? factor : 1;
            if (layer && run.level == 0) scale -= spread;
            if (layer && run.kind == RolledRun::Kind::ratcheting_by_half_steps) scale += step;
            results.push_back({run, run.kind == RolledRun::Kind::settling
                                        ? values(.4 * scale, u * scale, 0, State::shakedown)
                                        : values(.4, 9, .2 * scale, State::ratcheting)});
        }
    }
    return results;
}

std::optional<RolledRatio> of(const RolledDeviation& deviation, const Quantity* q) {
    const RolledRatio* ratio = found(deviation.ratios, q);
    return ratio ? std::optional(*ratio) : std::nullopt;
}

TEST(RolledDeviation, IsTheFinestRatioWithTheSpreadOfTheLevels) {
    const auto found = rolled_deviations(made_up(rolled_amplitudes(.24, .56), .9, .01, .004));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found.front().state, State::shakedown);
    const auto settled = of(found.front(), &quantities::settled_shift_ratio);
    EXPECT_NEAR(settled->value, .9, 1e-12);
    EXPECT_NEAR(settled->error, .01, 1e-12);
    const auto increment = of(found.front(), &quantities::shift_increment_ratio);
    EXPECT_NEAR(increment->value, .9, 1e-12);
    EXPECT_NEAR(increment->error, .01 + 2 * .004, 1e-12);
    const double u = *theory::settled_shift_ratio(.24, .56, 1.1);
    EXPECT_NEAR(of(found.front(), &quantities::kappa)->value,
                theory::mapping_parameter(.24, .56, .9 * u) / 1.1, 1e-12);
    EXPECT_NEAR(of(found.front(), &quantities::eta)->value, .9, 1e-12);
}

TEST(RolledDeviation, HasNoSettledShiftOfWhatRatchetsOrFailed) {
    const RolledAmplitudes amplitudes = rolled_amplitudes(.24, .56);
    const auto change = [&](auto what) {
        auto results = made_up(amplitudes, .9, 0, 0);
        for (RolledResult& result : results)
            if (!result.run.body.half_space() && result.run.kind == RolledRun::Kind::settling)
                what(result.values);
        return rolled_deviations(results).front();
    };
    const auto ratchets = change([](auto& v) { v = values(.4, 5, .1, State::ratcheting); });
    EXPECT_FALSE(of(ratchets, &quantities::settled_shift));
    EXPECT_TRUE(of(ratchets, &quantities::static_shift));
    EXPECT_EQ(ratchets.state, State::ratcheting);
    // What slips back and forth for ever without getting on has settled.
    const auto slips = change([](auto& v) { v = values(.4, .6, 1e-8, State::cyclic_slip); });
    EXPECT_TRUE(of(slips, &quantities::settled_shift));
    const auto creeps = change([](auto& v) { v = values(.4, .6, 1e-3, State::undecided); });
    EXPECT_FALSE(of(creeps, &quantities::settled_shift));
    const auto failed = change([](auto& v) { v.reset(); });
    EXPECT_FALSE(of(failed, &quantities::static_shift));
    EXPECT_TRUE(of(failed, &quantities::shift_increment));
}

/// As `exact_deviation` and `add_rolled` would make it, with few points.
HalfSpaceDeviation small_deviation() {
    HalfSpaceDeviation d;
    d.c = layer_rig();
    d.contact = deviation_contact(d.c);
    d.thickness_ratio = 8e-3 / d.contact.hertz_diameter;
    const ExactDeviation exact(d.contact, .5, theory::LayerBase::bonded);
    d.here = exact.ratios(d.thickness_ratio);
    d.apparent = *compare_with_layer(d.c, {})->apparent;
    ExactCurve& curve = d.curves.emplace_back();
    curve.poisson = .5;
    curve.thickness_ratios = {.5, 100};
    for (const double thickness : curve.thickness_ratios)
        curve.ratios.push_back(exact.ratios(thickness));
    curve.needed[&quantities::contact_radius] = NeededThicknesses{NeededThickness{1.41}, {}, {}};
    d.map = {{.5, 100}, {.3, .5}, std::vector<ExactRatios>(4, d.here)};
    d.amplitudes = rolled_amplitudes(.24, .56);
    auto results = made_up(d.amplitudes, .9, .01, 0);
    for (RolledResult& result : results)
        if (!result.run.body.half_space()) result.run.body.thickness_ratio = d.thickness_ratio;
    results.push_back({{{2, .5, true}}, std::nullopt});
    add_rolled(results, d);
    return d;
}

TEST(HalfSpaceDeviation, SaysWhatTheLayerMeans) {
    const HalfSpaceDeviation d = small_deviation();
    std::string text = report::table_text(deviation_table(d));
    for (const report::Verdict& verdict : deviation_verdicts(d)) text += verdict.sentence + '\n';
    for (const char* part :
         {"0.888 widths of Hertz' contact thick", "the indentation is 36.3 % below",
          "U_max 12.5 % below", "22.2 % too high from U_max", "1.41 in a",
          "U_stat 10.0 ± 1.0 % lower", "Failed runs: 1", "contact radius"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(HalfSpaceDeviation, SaysWhatTheHalfSpaceDoesOnlyWhereItDid) {
    const auto text = [](std::optional<State> half_space) {
        HalfSpaceDeviation d = small_deviation();
        for (RolledCurve& curve : d.rolled)
            for (RolledDeviation& point : curve.points) {
                point.state = State::ratcheting;
                point.half_space_state = half_space;
            }
        std::string all;
        for (const report::Verdict& verdict : deviation_verdicts(d)) all += verdict.sentence + '\n';
        return all;
    };
    const std::string other = "it ratchets, the half-space shakes down";
    EXPECT_NE(text(State::shakedown).find(other), std::string::npos) << text(State::shakedown);
    EXPECT_EQ(text(State::undecided).find(other), std::string::npos);
    EXPECT_EQ(text(std::nullopt).find(other), std::string::npos);
    // Nothing needs a thickness: nothing is said of it.
    HalfSpaceDeviation d = small_deviation();
    for (ExactCurve& curve : d.curves) curve.needed = {};
    for (const report::Verdict& verdict : deviation_verdicts(d))
        EXPECT_EQ(verdict.sentence.find("so many contact widths thick: ."), std::string::npos);
}

TEST(HalfSpaceDeviation, SaysHowThickWithItsInterval) {
    EXPECT_EQ(needed_text({.ratio = 37.565}, .1), "37.6");
    EXPECT_EQ(needed_text({.ratio = 12.14, .low = 11.2, .high = 14}, .25), "12.1 (11.2 to 14.0)");
    EXPECT_EQ(needed_text({.ratio = 19.71, .low = 19.7, .high = 19.72}, .25), "19.7");
    EXPECT_EQ(needed_text({.ratio = .5, .high = .7}, .25), "0.500 (below 0.25 to 0.700)");
    EXPECT_EQ(needed_text({.high = .7}, .25), "at most 0.700");
    EXPECT_EQ(needed_text({}, .1), "below 0.10");
}

TEST(HalfSpaceDeviation, WritesTableAndDocument) {
    const HalfSpaceDeviation d = small_deviation();
    const std::string csv = deviation_csv(d);
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "part,base,poisson,coupled,thickness_ratio,quantity,ratio,error");
    const auto rows = std::count(csv.begin(), csv.end(), '\n');
    EXPECT_EQ(rows, 1 + 2 * 9 + 4 * 9 + 9);
    const json numbers = json::parse(deviation_json("0", "case", d));
    EXPECT_NEAR(numbers["layer"]["exact"]["indentation"]["ratio"].get<double>(), .637, .001);
    EXPECT_NEAR(numbers["layer"]["computed"]["static_shift"]["error"].get<double>(), .01, 1e-9);
    EXPECT_EQ(numbers["failed_runs"], 1);
    const std::string page = report::document_html(deviation_document(d));
    for (const char* part : {"Half-space deviation", "map_indentation", "computed_settled_shift"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace tricontact::comparisons::half_space_deviation_test
