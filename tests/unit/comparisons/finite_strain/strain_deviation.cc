#include "comparisons/finite_strain/strain_deviation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "comparisons/finite_strain/strain_output.h"
#include "contact/base/error.h"
#include "fem/settings.h"
#include "io/case/case_reader.h"
#include "tests/unit/comparisons/layer_rig.h"

namespace tricontact::comparisons::strain_deviation_test {
namespace {

using contact::Case;
using synthetic::layer_rig;

/// Runs whose static shift the linear law puts 1 % too high (sign -1: too low) from F_N = `force`
/// on, and by the cube root of F_N f_T more above.
StrainDeviation synthetic(double force, double sign = 1, double finer = 1) {
    const StrainContact contact = strain_contact(layer_rig(), 5);
    std::vector<std::optional<Results>> results;
    for (const StrainPoint& point : strain_points(contact))
        for (const bool finite : {false, true}) {
            Results values;
            const double off =
                sign * .01 * std::cbrt(point.normal_force * point.tangential_ratio / .56 / force);
            values.set(quantities::static_shift,
                       finite ? 1e-4 : 1e-4 * (1 + off * (point.level > 0 ? finer : 1)));
            results.emplace_back(values);
        }
    return strain_deviation(contact, results);
}

std::string sentences(const StrainDeviation& deviation) {
    std::string text;
    for (const auto& verdict : strain_verdicts(deviation)) text += verdict.sentence + '\n';
    return text;
}

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

TEST(StrainDeviation, ItsRunsAreCases) {
    const StrainContact contact = strain_contact(layer_rig(), 5);
    const auto points = strain_points(contact);
    EXPECT_EQ(points.size(), 7 * 4 + 6 + 1 + 5 + 1);
    EXPECT_EQ(std::ranges::count(points, own_point(contact, false)), 1);
    EXPECT_EQ(std::ranges::count(points, true, &StrainPoint::rolled), 6);
    for (const StrainPoint& point : points) {
        const Case linear =
            io::parse_case(io::write_case(strain_case(contact, point, false)), "linear");
        const Case finite =
            io::parse_case(io::write_case(strain_case(contact, point, true)), "finite");
        EXPECT_EQ(linear.law, Case::Law::linear);
        EXPECT_EQ(finite.law, Case::Law::neo_hookean);
        EXPECT_EQ(linear.of<fem::Settings>().size, finite.of<fem::Settings>().size);
        EXPECT_LE(*linear.of<fem::Settings>().size, *linear.layer.thickness / 3 * (1 + 1e-12));
        EXPECT_EQ(linear.rolling.has_value(), point.rolled);
    }
    Case mooney = layer_rig();
    mooney.law = Case::Law::mooney_rivlin;
    mooney.c01_ratio = .2;
    const StrainContact own = strain_contact(mooney, 5);
    EXPECT_EQ(strain_case(own, own_point(own, true), true).c01_ratio, .2);
    EXPECT_FALSE(strain_case(own, own_point(own, true), false).c01_ratio);
}

TEST(StrainDeviation, RefusesWhatFiniteStrainsAreNotOfferedFor) {
    const auto refusal = [](auto change) -> std::string {
        Case c = layer_rig();
        change(c);
        try {
            strain_contact(c, 5);
        } catch (const contact::InputError& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_TRUE(contains(refusal([](Case& c) { c.indenter.shape = Case::Shape::cone; }),
                         "smooth paraboloids and spheres"));
    EXPECT_TRUE(contains(refusal([](Case& c) { c.contact.coupling = false; }), "always coupled"));
    EXPECT_TRUE(
        contains(refusal([](Case& c) { c.layer.thickness.reset(); }), "substrate.thickness"));
    EXPECT_TRUE(contains(refusal([](Case& c) {
                             c.layer.lower.push_back({1e-3, {1e6, .3}});
                         }),
                         "one layer"));
    EXPECT_EQ(refusal([](Case&) {}), "");
}

TEST(StrainDeviation, SaysFromWhichLoadOn) {
    const StrainDeviation deviation = synthetic(1, 1, 1.05);
    const auto rows = strain_rows(deviation);
    ASSERT_EQ(rows.size(), 1);
    EXPECT_NEAR(rows[0].deviation, .01 * std::cbrt(21.1), 1e-12);
    EXPECT_NEAR(rows[0].error.value(), .0005 * std::cbrt(21.1), 1e-12);
    EXPECT_NEAR(rows[0].forces[0]->at.value(), 1, 1e-8);
    EXPECT_NEAR(rows[0].forces[1]->at.value(), 8, 1e-8);
    EXPECT_NEAR(rows[0].forces[2]->at.value(), 125, 1e-7);
    const std::string text = sentences(deviation);
    EXPECT_TRUE(contains(text,
                         "Linear elasticity puts U_stat 2.8 ± 0.14 % too high here; it is off by 1 "
                         "% from F_N = 1.00 N on, by 2 % from F_N = 8.00 N on, by 5 % from F_N = "
                         "125 N on, at this thickness."))
        << text;
    EXPECT_TRUE(contains(text, "off by 1 % from the least f_T = 0.150 on already, by 2 % from f_T"))
        << text;
    EXPECT_FALSE(contains(text, "U_sd")) << text;
    EXPECT_FALSE(contains(text, "Failed runs")) << text;
}

TEST(StrainDeviation, DoesNotNameALoadThatIsNotReached) {
    const std::string some = sentences(synthetic(100, -1));
    EXPECT_TRUE(contains(some, "U_stat 0.60 ± 0 % too low here")) << some;
    EXPECT_TRUE(contains(some, "off by 1 % from F_N = 100 N on, not by 2 % up to F_N = 169 N"))
        << some;
    EXPECT_FALSE(contains(some, "by 5 %")) << some;
    EXPECT_FALSE(contains(some, "by 2 % from")) << some;
    const std::string none = sentences(synthetic(1000));
    EXPECT_TRUE(contains(none, "it is not off by 1 % up to F_N = 169 N")) << none;
    EXPECT_FALSE(contains(none, " on,")) << none;
    // Below its numerical error.
    const std::string equal = sentences(synthetic(1000, 1, 3));
    EXPECT_TRUE(contains(equal, "gives U_stat as finite strains do, to 0.83 %")) << equal;
    EXPECT_FALSE(contains(equal, "too high here")) << equal;
}

TEST(StrainDeviation, FailedRunsAreCountedAndLeaveGaps) {
    const StrainContact contact = strain_contact(layer_rig(), 5);
    std::vector<std::optional<Results>> results(2 * strain_points(contact).size());
    const StrainDeviation deviation = strain_deviation(contact, results);
    EXPECT_TRUE(strain_rows(deviation).empty());
    EXPECT_TRUE(contains(sentences(deviation), "Failed runs: 82"));
    const auto document = nlohmann::json::parse(strain_json("1", "", deviation));
    EXPECT_EQ(document["failed_runs"], 82);
    report::check_document(strain_document(deviation));
}

TEST(StrainDeviation, WritesTablesAndMaps) {
    const StrainDeviation deviation = synthetic(1);
    const std::string csv = strain_csv(deviation);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 41);
    const auto document = strain_document(deviation);
    report::check_document(document);
    const auto maps = strain_maps(deviation);
    ASSERT_EQ(maps.size(), 1);
    EXPECT_EQ(maps[0].map->values.size(), 28);
    EXPECT_NEAR(maps[0].map->values.front(), std::cbrt(21.1 / 8), 1e-9);
    const auto json = nlohmann::json::parse(strain_json("1", "", deviation));
    EXPECT_NEAR(json["here"]["static_shift_m"]["force"][0]["from"].get<double>(), 1, 1e-8);
}

}  // namespace
}  // namespace tricontact::comparisons::strain_deviation_test
