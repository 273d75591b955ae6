#include "comparisons/run/figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "report/document.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::figures_test {
namespace {

using synthetic::Options;

struct FigureCase {
    std::string name;
    Options options;
    std::string only = "";           ///< one model, or both
    std::set<std::string> expected;  ///< ids
};

std::ostream& operator<<(std::ostream& out, const FigureCase& c) {
    return out << c.name;
}

const std::set<std::string> all{
    "shift",      "shift_ratio", "dissipation",          "traction_x",
    "traction_y", "zones_bem",   "traction_surface_bem", "displacement_surface_bem"};
const std::set<std::string> lines{"shift", "shift_ratio", "dissipation", "traction_x",
                                  "traction_y"};

std::set<std::string> without(std::set<std::string> names, const std::string& name) {
    names.erase(name);
    return names;
}

class FiguresOfCases : public testing::TestWithParam<FigureCase> {
  protected:
    Histories histories() const {
        Histories result = synthetic::two_models(GetParam().options);
        std::erase_if(result, [](const contact::History& history) {
            return !GetParam().only.empty() && history.model != GetParam().only;
        });
        return result;
    }
};

/// Numbers that a page or a picture holds.
std::size_t size_of(const report::Figure& figure) {
    std::size_t n = figure.map ? figure.map->values.size() : 0;
    for (const report::Curve& curve : figure.curves) n += curve.x.size();
    for (const report::Panel& panel : figure.panels) n += panel.kinds.size();
    return n;
}

TEST_P(FiguresOfCases, HaveNamesAndData) {
    report::Document document{.sections = {{.id = "all", .heading = "All"}}};
    auto& figures = document.sections.front().figures;
    figures = make_figures(synthetic::unit_case(GetParam().options), histories());
    EXPECT_NO_THROW(report::check_document(document));
    std::set<std::string> names;
    for (const report::Figure& figure : figures) {
        names.insert(figure.id);
        EXPECT_FALSE(figure.title.empty());
        EXPECT_FALSE(figure.caption.empty());
        EXPECT_FALSE(figure.x.label.empty());
        EXPECT_FALSE(figure.y.label.empty());
        EXPECT_GT(size_of(figure), 1u) << figure.id;
        // A picture of 640 pixels needs no more; 100 k points would take megabytes.
        EXPECT_LT(size_of(figure), 70000u) << figure.id;
        for (const report::Curve& curve : figure.curves)
            EXPECT_TRUE(std::ranges::none_of(curve.y, [](double y) { return std::isnan(y); }))
                << figure.id << ": " << curve.name;
    }
    EXPECT_EQ(names, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, FiguresOfCases,
    testing::Values(FigureCase{"shakedown", {}, "", all},
                    FigureCase{"ratcheting", {.f = 0.8, .w = 0.5}, "", all},
                    FigureCase{"mdr_only", {}, "mdr", lines},
                    FigureCase{"bem_only", {}, "bem", all},
                    FigureCase{
                        "static",
                        {.rolling = false},
                        "",
                        without(without(without(all, "shift"), "shift_ratio"), "dissipation")},
                    FigureCase{"one_period", {.periods = 1}, "", all},
                    // W0 vanishes with f_T: there is no ratio to draw.
                    FigureCase{"no_tangential_force", {.f = 0}, "", without(all, "dissipation")},
                    FigureCase{"no_amplitude", {.w = 0}, "", all},
                    FigureCase{"largest_amplitude", {.f = 0.3, .w = 1}, "", all},
                    FigureCase{"oblique", {.angle = std::numbers::pi / 4}, "", all},
                    FigureCase{"perpendicular", {.angle = std::numbers::pi / 2}, "", all},
                    FigureCase{"many_periods", {.periods = 500}, "", all},
                    FigureCase{"even_grid", {.n_x = 40, .n_y = 30}, "", all},
                    FigureCase{"many_points", {.n_x = 320, .n_y = 320, .springs = 20001}, "", all}),
    [](const auto& tested) { return tested.param.name; });

TEST(FigureData, TheoryIsDrawnOnlyWhereItHolds) {
    const auto has_theory = [](const contact::Case& c, const Options& options) {
        const auto figure = shift_figures(c, synthetic::two_models(options)).back();
        return std::ranges::any_of(figure.curves, [](const report::Curve& curve) {
            return curve.name.ends_with("_sd, MDR closed form");
        });
    };
    const Options settles{.f = 0.3, .w = 0.2}, ratchets{.f = 0.8, .w = 0.5};
    contact::Case c = synthetic::unit_case(settles);
    EXPECT_TRUE(has_theory(c, settles));
    c.load.tangential_amplitude_ratio = 0.1;
    EXPECT_FALSE(has_theory(c, settles));
    EXPECT_FALSE(has_theory(synthetic::unit_case(ratchets), ratchets));
}

/// Captions of a case's figures, one after another.
std::string captions(const Options& options, const std::optional<NumericalError>& error,
                     const Histories& histories) {
    std::string text;
    for (const report::Figure& figure :
         make_figures(synthetic::unit_case(options), histories, error))
        text += figure.id + ": " + figure.caption + '\n';
    return text;
}

// Half widths of fields stand with the figures of these fields, of their model and state alone.
TEST(FigureData, CaptionsTellHalfWidthsOfFields) {
    const Options options;
    Histories histories = synthetic::two_models(options);
    NumericalError error{.model = "bem", .run = {}, .coarser = {}, .coarsest = {}};
    error.fields = {{"tangential_traction", "Pa", 1e4, .031}, {"displacement", "m", 1e-6, .002}};
    const std::string told = captions(options, error, histories);
    const std::string mark = "What mesh and steps leave in BEM: ± ";
    const auto n_marks = [&](const std::string& text) {
        std::size_t n = 0;
        for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; ++at) ++n;
        return n;
    };
    EXPECT_EQ(n_marks(told), 4U) << told;  // traction_x, traction_y, two maps
    EXPECT_NE(told.find(mark + "3.1 %"), std::string::npos) << told;
    EXPECT_NE(told.find(mark + "0.20 % of the field's root mean square, ± "), std::string::npos)
        << told;
    EXPECT_EQ(n_marks(captions(options, {}, histories)), 0U);
    NumericalError other = error;
    other.model = "fem";
    EXPECT_EQ(captions(options, other, histories).find("What mesh and steps"), std::string::npos);
    other = error;
    other.fields.clear();
    EXPECT_EQ(n_marks(captions(options, other, histories)), 0U);
    // A last state that is not the upright one that is drawn.
    for (contact::History& history : histories) {
        history.snapshots.push_back(history.snapshots.back());
        history.snapshots.back().phase += .25;
    }
    EXPECT_EQ(n_marks(captions(options, error, histories)), 0U);
}

// A force to the left shifts to the left: what is drawn has to be within the axes.
TEST(FigureData, NegativeShiftsAreNotCutOff) {
    auto histories = synthetic::two_models();
    for (contact::History& history : histories) {
        for (contact::StepRecord& step : history.steps) step.shift[0] *= -1;
        for (double& shift : history.shift_per_period) shift *= -1;
        history.static_shift *= -1;
    }
    for (const report::Figure& figure : shift_figures(synthetic::unit_case(), histories)) {
        double least = 0;
        for (const report::Curve& curve : figure.curves)
            for (const double y : curve.y) least = std::min(least, y);
        EXPECT_LT(least, 0) << figure.id;
        EXPECT_LT(*figure.y.low, least) << figure.id;
        EXPECT_GT(*figure.y.high, 0) << figure.id;
    }
    // Without negative ones the axis begins at zero, as ever.
    EXPECT_EQ(*shift_figures(synthetic::unit_case(), synthetic::two_models())[0].y.low, 0);
}

TEST(FigureData, LengthsHaveCapitalsRatiosSmallLetters) {
    const Options settles{.f = 0.3, .w = 0.2};
    const auto figures =
        shift_figures(synthetic::unit_case(settles), synthetic::two_models(settles));
    const auto has = [&](const report::Figure& figure, const char* name) {
        return std::ranges::count(figure.curves, name, &report::Curve::name) > 0;
    };
    EXPECT_TRUE(has(figures[0], "U_sd, MDR closed form"));
    EXPECT_TRUE(has(figures[1], "u_sd, MDR closed form"));
}

TEST(FigureData, ShiftsOfStepsAndPeriods) {
    const auto histories = synthetic::two_models();
    const auto figure = shift_figures(synthetic::unit_case(), histories).back();
    const contact::History& mdr = histories.front();
    const report::Curve &steps = figure.curves[0], &periods = figure.curves[1];
    EXPECT_EQ(steps.name, "MDR");
    EXPECT_EQ(periods.name, "MDR");
    EXPECT_EQ(periods.kind, report::Curve::Kind::points);
    EXPECT_EQ(steps.y.back(), mdr.steps.back().shift[0] / mdr.scales.unit_shift);
    EXPECT_EQ(periods.y.front(), mdr.static_shift / mdr.scales.unit_shift);
    EXPECT_EQ(periods.y.back(), mdr.shift_per_period.back() / mdr.scales.unit_shift);
    EXPECT_EQ(periods.x.back(), static_cast<double>(mdr.shift_per_period.size()));
}

TEST(FigureData, ChosenInstantsOfTheMaps) {
    const Options options{.periods = 12};
    const auto figure =
        zone_figures(synthetic::unit_case(options), synthetic::two_models(options)).front();
    // The synthetic run keeps the first and the last period only: 2.75 is replaced by 11.75.
    std::vector<std::string> titles;
    for (const report::Panel& panel : figure.panels) titles.push_back(panel.title);
    EXPECT_EQ(titles, (std::vector<std::string>{"n = 0", "n = 0.25", "n = 11.75", "n = 12"}));
}

TEST(FigureData, ZonesOfTheMaps) {
    const Options options{.rolling = false, .n_x = 320, .n_y = 320};
    const auto histories = synthetic::two_models(options);
    const auto figure = zone_figures(synthetic::unit_case(options), histories).front();
    const report::Panel& panel = figure.panels.front();
    const contact::Surface& s = histories[1].snapshots.front().surface;
    EXPECT_LE(panel.x.size(), 128u);
    const auto share = [](const auto& values, auto wanted) {
        return static_cast<double>(std::ranges::count(values, wanted));
    };
    // Blocks of 3 x 3 cells stand for nine: edges are a cell off.
    for (const auto& [state, kind] :
         {std::pair(contact::ContactState::stick, 0), {contact::ContactState::slip, 1}})
        EXPECT_NEAR(9 * share(panel.kinds, kind) / share(s.contact_state, state), 1, 0.04);
    EXPECT_EQ(figure.kinds[0].name, "stick");
    EXPECT_EQ(figure.kinds[1].name, "slip");
}

TEST(FigureData, TractionsAgainstTheLoadStayInThePicture) {
    const Options options{.rolling = false};
    auto histories = synthetic::two_models(options);
    for (auto& snapshot : histories[1].snapshots)
        for (double& t : snapshot.surface.tangential_traction_x) t -= 0.2 * 2 / std::numbers::pi;
    const contact::Case c = synthetic::unit_case(options);
    // mu p0 = 2/pi: -0.2 at the edge.
    const auto map = surface_figures(c, histories)[0].map.value();
    EXPECT_NEAR(std::ranges::min(map.values), -0.2, 1e-12);
    const auto figure = traction_figures(c, histories)[0];
    EXPECT_FALSE(figure.y.low);
    EXPECT_NEAR(std::ranges::min(figure.curves[1].y), -0.2, 1e-12);
    ASSERT_EQ(figure.strips.size(), 2u);
    EXPECT_EQ(figure.strips[1].name, "BEM");
}

}  // namespace
}  // namespace tricontact::comparisons::figures_test
