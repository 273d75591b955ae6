#include "theory/layer/layer_series.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/error.h"
#include "tests/unit/theory/layer/layer_cases.h"

namespace tricontact::layer_series_test {
namespace {

using theory::dimitriadis_series;
using theory::garcia_series;

double error_percent(const theory::LayerForceSeries& series, double chi) {
    const double exact = layer_test::force_ratio(chi, .5, theory::LayerBase::bonded).force;
    return 100 * (series.force_ratio(chi) / exact - 1);
}

// The table of the header.
TEST(TheoryLayerSeries, ErrorsAgainstTheExactSolution) {
    struct Row {
        double chi, dimitriadis, garcia, digit;
    };
    for (const Row& row :
         {Row{.1, -.19, .06, .01}, Row{.2, -1.06, .12, .01}, Row{.5, -7.73, .71, .01},
          Row{1, -16.3, 14.4, .1}, Row{2, -12.3, 80.1, .1}}) {
        // Half a unit of the last digit given.
        EXPECT_NEAR(error_percent(dimitriadis_series, row.chi), row.dimitriadis, .51 * row.digit);
        EXPECT_NEAR(error_percent(garcia_series, row.chi), row.garcia, .51 * row.digit);
    }
}

TEST(TheoryLayerSeries, TendToHertz) {
    EXPECT_EQ(dimitriadis_series.force_ratio(0), 1);
    EXPECT_EQ(garcia_series.force_ratio(0), 1);
    // First order: 1.133 instead of 1.12695.
    EXPECT_NEAR(error_percent(garcia_series, 1e-3) / .1, 1.133 - 1.12695, 1e-4);
}

TEST(TheoryLayerSeries, RefuseBadInput) {
    EXPECT_THROW(garcia_series.force_ratio(-.1), contact::InputError);
    EXPECT_THROW(garcia_series.force_ratio(NAN), contact::InputError);
}

}  // namespace
}  // namespace tricontact::layer_series_test
