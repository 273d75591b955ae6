#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/unit/theory/layer/layer_cases.h"

namespace tricontact::layer_series_test {
namespace {

/// A published series for a rigid paraboloid pressed without friction on an incompressible
/// (nu = 1/2) layer bonded to a rigid base: F over Hertz' force at the same indentation d,
///   1 + c1 chi + c2 chi^2 + c3 chi^3 + c4 chi^4,  chi = sqrt(R d)/b.
/// For comparison only: the exact curve is that of solve_layer_contact (elastic_layer.h), with
/// c1 = 1.12695, c2 = 7/6 c1^2 = 1.4817, c3 = 1.470.
struct LayerForceSeries {
    const char* source;
    std::array<double, 4> coefficients;  ///< c1 to c4

    /// F/F_Hertz at chi >= 0.
    double force_ratio(double chi) const {
        const auto& [c1, c2, c3, c4] = coefficients;
        return 1 + chi * (c1 + chi * (c2 + chi * (c3 + chi * c4)));
    }
};

/// Dimitriadis, Horkay, Maresca, Kachar and Chadwick (2002), Biophys. J. 82. Too soft: c2 is c1^2
/// there, as if the layer did not change the contact radius.
constexpr LayerForceSeries dimitriadis_series{"Dimitriadis et al. (2002)",
                                              {1.133, 1.283, 0.769, 0.0975}};
/// Garcia and Garcia (2018), Biophys. J. 114: right to third order.
constexpr LayerForceSeries garcia_series{"Garcia and Garcia (2018)", {1.133, 1.497, 1.469, 0.755}};

double error_percent(const LayerForceSeries& series, double chi) {
    const double exact = layer_test::force_ratio(chi, .5, theory::LayerBase::bonded).force;
    return 100 * (series.force_ratio(chi) / exact - 1);
}

// Prints the table of docs/explanation/models/mdr-layer.md.
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
    for (const auto& series : {dimitriadis_series, garcia_series}) {
        fmt::print("| {} |", series.source);
        for (const double chi : {.1, .2, .5, 1., 2.})
            fmt::print(" {:.{}f} % |", error_percent(series, chi), chi < 1 ? 2 : 1);
        fmt::print("\n");
    }
}

TEST(TheoryLayerSeries, TendToHertz) {
    EXPECT_EQ(dimitriadis_series.force_ratio(0), 1);
    EXPECT_EQ(garcia_series.force_ratio(0), 1);
    // First order: 1.133 instead of 1.12695.
    EXPECT_NEAR(error_percent(garcia_series, 1e-3) / .1, 1.133 - 1.12695, 1e-4);
}

}  // namespace
}  // namespace tricontact::layer_series_test
