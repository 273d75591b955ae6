// The study of line contacts beside its closed forms, and what sticks between the cells.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "comparisons/quantities/surface_fields.h"
#include "comparisons/shakedown/study_fit.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::comparisons::line_fit_test {
namespace {

const auto coulomb_law = contact::Friction{.coefficient = 1}.law();
const contact::FrictionLaw& coulomb = *coulomb_law;

constexpr double lambda = 5.85;  // of the thesis' rig

/// Points on the exact solution, those beyond the limit with a shift per period.
StudyFit exact_study() {
    StudyFit fit;
    for (const double w : {.26, .52})
        for (const double f : {.1, .3, .8}) {
            RollingPoint p{.model = "bem", .group = "parallel", .point = {}};
            p.amplitude_ratio = w;
            p.tangential_ratio = f;
            p.values[&quantities::limit_tangential_ratio] = {theory::line_shakedown_limit(w), 0};
            if (const auto c = theory::line_stick_half_width(w, f)) {
                p.state = contact::State::shakedown;
                p.values[&quantities::settled_shift_ratio] = {
                    theory::line_settled_shift_ratio(w, *c, lambda), 0};
                p.values[&quantities::stick_ratio] = {*c, 0};
            } else {
                p.state = contact::State::ratcheting;
                p.values[&quantities::shift_increment_ratio] = {.1, .01};
            }
            fit.points.push_back(p);
        }
    return fit;
}

const report::Figure& figure(const report::Document& document, const std::string& id) {
    const auto& figures = document.sections.at(0).figures;
    return *std::find_if(figures.begin(), figures.end(),
                         [&](const report::Figure& f) { return f.id == id; });
}

/// y of a closed form at x, linear between its samples; x may fall.
double at(const report::Curve& curve, double x) {
    for (std::size_t i = 1; i < curve.x.size(); ++i)
        if ((curve.x[i - 1] - x) * (curve.x[i] - x) <= 0)
            return std::lerp(curve.y[i - 1], curve.y[i],
                             (x - curve.x[i - 1]) / (curve.x[i] - curve.x[i - 1]));
    return std::nan("");
}

TEST(LineFit, PointsOfTheExactSolutionLieOnItsCurves) {
    const report::Document document = line_fit_document(exact_study(), lambda);
    std::vector<std::string> ids;
    for (const report::Figure& f : document.sections.at(0).figures) ids.push_back(f.id);
    EXPECT_EQ(ids, (std::vector<std::string>{"figure_3_40", "figure_3_43", "figure_3_44",
                                             "figure_3_46"}));  // none near the limit: no 3.45
    for (const char* id : {"figure_3_40", "figure_3_43"}) {
        const report::Figure& f = figure(document, id);
        const report::Curve& points = f.curves.back();
        ASSERT_EQ(points.x.size(), 4u) << id;
        for (std::size_t i = 0; i < points.x.size(); ++i) {
            double nearest = 1;
            for (const report::Curve& curve : f.curves)
                if (curve.name == "exact, half-space")
                    nearest = std::min(nearest, std::abs(at(curve, points.x[i]) - points.y[i]));
            EXPECT_LT(nearest, 1e-4) << id << ' ' << points.x[i];  // chords of 100 samples
        }
    }
}

TEST(LineFit, TablesHoldTheExactValuesBesideThePoints) {
    const report::Document document = line_fit_document(exact_study(), lambda);
    const auto& tables = document.sections.at(0).tables;
    ASSERT_EQ(tables.size(), 3u);
    for (const auto& row : tables[0].rows)  // u_sd: difference of the exact value
        EXPECT_NEAR(std::get<double>(row[7]), 0, 1e-9);
    for (const auto& row : tables[1].rows)
        EXPECT_NEAR(std::get<double>(row[5]), std::get<report::WithError>(row[4]).value, 1e-9);
    EXPECT_EQ(tables[2].rows.size(), 2u);
}

/// The exact tractions after shakedown on cells of h a, in the three positions of a period.
contact::History shaken_down(double h, double w, double c) {
    contact::History history;
    for (const auto& [phase, offset] : {std::pair(.25, w), {.75, -w}, {1., 0.}}) {
        contact::Surface s;
        const int beside = static_cast<int>(2 / h);
        s.n_x = 2 * beside + 1;
        s.n_y = 1;
        s.first = {-beside * h, 0};
        s.spacing = {h, 1};
        s.offset = {offset, 0};
        for (int i = 0; i < s.n_x; ++i) {
            const double x = s.x(i) - offset, p = std::sqrt(std::max(0., 1 - x * x));
            s.normal_traction.push_back(p);
            s.friction_bound.push_back(p);
            s.tangential_traction_x.push_back(theory::line_shakedown_traction(s.x(i), w, c));
            s.contact_state.push_back(p > 0 ? contact::ContactState::stick
                                            : contact::ContactState::open);
        }
        s.tangential_traction_y.resize(s.n_x);
        history.snapshots.push_back({phase, s});
    }
    return history;
}

// What tau lacks to its bound is a root at the edge, and linear in it only there: a fifth of a
// cell.
TEST(LineFit, StickWidthLiesBetweenTheCells) {
    for (const double h : {.04, .02})
        for (const double c : {.213, .3, .42, .555})
            EXPECT_NEAR(stick_half_width(shaken_down(h, .26, c), coulomb).value(), c, .2 * h)
                << h << ' ' << c;
    EXPECT_EQ(stick_half_width(shaken_down(.02, .26, 1e-9), coulomb).value(), 0);
    EXPECT_FALSE(stick_half_width({}, coulomb));
}

}  // namespace
}  // namespace tricontact::comparisons::line_fit_test
