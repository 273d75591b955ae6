#include "contact/substrates/dma_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "contact/base/error.h"

namespace tricontact::contact::dma_fit_test {
namespace {

using Branches = std::vector<Relaxation::Branch>;

// Table of a solid at frequencies that rise by equal factors, with normal relative noise.
DmaTable table_of(double relaxed, const Branches& branches, std::size_t rows, double low,
                  double high, double noise = 0) {
    DmaTable table{.name = "dma.csv", .omega = {}, .storage = {}, .loss = {}};
    const Relaxation relaxation{.branches = branches, .bulk = Relaxation::Bulk::proportional};
    std::mt19937 random(20261121);
    std::normal_distribution<double> normal;
    for (std::size_t k = 0; k < rows; ++k) {
        const double omega = low * std::pow(high / low, double(k) / double(rows - 1));
        const auto modulus = relaxed * relaxation.dynamic_ratio(omega);
        table.omega.push_back(omega);
        table.storage.push_back(modulus.real() * (1 + noise * normal(random)));
        table.loss.push_back(modulus.imag() * (1 + noise * normal(random)));
    }
    return table;
}

void expect_recovered(const DmaFit& fit, double relaxed, const Branches& branches,
                      double tolerance) {
    EXPECT_NEAR(fit.relaxed_modulus / relaxed, 1, tolerance);
    ASSERT_EQ(fit.relaxation.branches.size(), branches.size());
    for (std::size_t i = 0; i < branches.size(); ++i) {
        EXPECT_NEAR(fit.relaxation.branches[i].ratio / branches[i].ratio, 1, tolerance) << i;
        EXPECT_NEAR(fit.relaxation.branches[i].time / branches[i].time, 1, tolerance) << i;
    }
}

// The rows hold the solid to rounding, 1e-16; the condition of the terms, up to 1e4 where they are
// two decades apart in strength, multiplies that. What is found is far better than any measurement.
constexpr double exact = 1e-9;

TEST(DmaFit, RecoversTheStandardSolidExactly) {
    for (const double ratio : {1e-3, 0.6, 30.})
        for (const double time : {0.05, 0.3, 3.}) {
            const Branches solid{{ratio, time}};
            const DmaFit fit = fit_prony(table_of(1.7e6, solid, 12, 0.1, 100));
            expect_recovered(fit, 1.7e6, solid, exact);
            EXPECT_LT(fit.storage_rms, exact);
            EXPECT_LT(fit.loss_rms, exact);
        }
}

TEST(DmaFit, RecoversTwoAndMoreTermsExactly) {
    for (const Branches& solid :
         {Branches{{0.5, 0.05}, {0.3, 2}}, Branches{{0.5, 0.5}, {0.3, 2}},
          Branches{{5, 0.01}, {0.05, 0.3}, {1, 10}},
          Branches{{0.5, .002}, {0.3, 0.01}, {.3, .1}, {.3, 1}, {.2, 10}, {.1, 70}}})
        expect_recovered(fit_prony(table_of(2e6, solid, 61, 0.003, 3000)), 2e6, solid, exact);
}

TEST(DmaFit, FourRowsAreEnoughForOneTerm) {
    const Branches solid{{0.7, 0.3}};
    expect_recovered(fit_prony(table_of(1.7e6, solid, 4, 0.5, 20)), 1.7e6, solid, exact);
}

TEST(DmaFit, DoesNotDependOnTheUnits) {
    const Branches solid{{0.5, 0.05}, {0.3, 2}};
    DmaTable table = table_of(2e6, solid, 41, 0.05, 200, 0.01);
    const DmaFit fit = fit_prony(table);
    for (std::size_t k = 0; k < table.size(); ++k) {
        table.omega[k] *= 1e9;
        table.storage[k] *= 1e-12;
        table.loss[k] *= 1e-12;
    }
    const DmaFit scaled = fit_prony(table);
    EXPECT_NEAR(scaled.relaxed_modulus / fit.relaxed_modulus, 1e-12, 1e-12 * 1e-6);
    ASSERT_EQ(scaled.relaxation.branches.size(), fit.relaxation.branches.size());
    for (std::size_t i = 0; i < fit.relaxation.branches.size(); ++i) {
        // The minimum is flat: steps of the descent end at 1e-7 or so of the parameters.
        EXPECT_NEAR(scaled.relaxation.branches[i].time / fit.relaxation.branches[i].time, 1e-9,
                    1e-9 * 1e-6);
        EXPECT_NEAR(scaled.relaxation.branches[i].ratio / fit.relaxation.branches[i].ratio, 1,
                    1e-6);
    }
}

TEST(DmaFit, FindsTheLevelOfNoiseAndNoTermsInIt) {
    const Branches solid{{0.5, 0.05}, {0.3, 2}};
    const DmaFit fit = fit_prony(table_of(2e6, solid, 201, 0.05, 200, 0.01));
    // Each parameter averages the noise of dozens of rows: 1 % becomes some tenths, with the
    // correlation of neighbouring terms 1 %.
    expect_recovered(fit, 2e6, solid, 0.01);
    // The estimate of a standard deviation from 201 values scatters by 1/sqrt(402) = 5 %: 3 times.
    EXPECT_NEAR(fit.storage_rms, 0.01, 0.0015);
    EXPECT_NEAR(fit.loss_rms, 0.01, 0.0015);
    // Of 402 normal deviates the largest lies between 2.5 and 5 of their deviation but for 1 % and
    // 0.02 % of the draws.
    EXPECT_GT(std::abs(fit.worst.residual), 0.025);
    EXPECT_LT(std::abs(fit.worst.residual), 0.05);
}

TEST(DmaFit, QualityIsThatOfTheSeriesItReturns) {
    DmaTable table = table_of(2e6, {{0.5, 0.05}, {0.3, 2}}, 41, 0.05, 200, 0.01);
    table.loss[17] *= 1.3;
    const DmaFit fit = fit_prony(table);
    double storage = 0, loss = 0;
    for (std::size_t k = 0; k < table.size(); ++k) {
        const auto modulus = fit.relaxed_modulus * fit.relaxation.dynamic_ratio(table.omega[k]);
        storage += std::pow(modulus.real() / table.storage[k] - 1, 2) / 41;
        loss += std::pow(modulus.imag() / table.loss[k] - 1, 2) / 41;
    }
    EXPECT_DOUBLE_EQ(fit.storage_rms, std::sqrt(storage));
    EXPECT_DOUBLE_EQ(fit.loss_rms, std::sqrt(loss));
    EXPECT_TRUE(fit.worst.loss);
    EXPECT_EQ(fit.worst.omega, table.omega[17]);
    EXPECT_NEAR(fit.worst.residual, 1 / 1.3 - 1, 0.05);  // noise of 1 %, and the fit gives way
}

// Sum of the squared relative residuals of G_inf (1 + sum g_i ...), the table's rows all counted.
double squares(const DmaTable& table, double relaxed, const Relaxation& relaxation) {
    double sum = 0;
    for (std::size_t k = 0; k < table.size(); ++k) {
        const auto modulus = relaxed * relaxation.dynamic_ratio(table.omega[k]);
        sum += std::pow(modulus.real() / table.storage[k] - 1, 2) +
               std::pow(modulus.imag() / table.loss[k] - 1, 2);
    }
    return sum;
}

// Newton's step of a function of one variable from its values at -h, 0, h.
double newton_step(double below, double here, double above, double h) {
    return -(above - below) / (above + below - 2 * here) * h / 2;
}

TEST(DmaFit, IsTheMinimumOfTheSquares) {
    const DmaTable table = table_of(2e6, {{0.5, 0.05}, {0.3, 2}}, 41, 0.05, 200, 0.03);
    const DmaFit fit = fit_prony(table);
    const double h = 1e-4, here = squares(table, fit.relaxed_modulus, fit.relaxation);
    // Of the differences h^2 and rounding, 1e-16 N/(h rms^2), are left: below 1e-7. With a wrong
    // derivative the descent ends a good part of the parameters' uncertainty off, 1e-5 to 1e-3.
    const double allowed = 1e-6;
    EXPECT_NEAR(newton_step(squares(table, fit.relaxed_modulus * (1 - h), fit.relaxation), here,
                            squares(table, fit.relaxed_modulus * (1 + h), fit.relaxation), h),
                0, allowed);
    for (std::size_t i = 0; i < fit.relaxation.branches.size(); ++i)
        for (double Relaxation::Branch::*const member :
             {&Relaxation::Branch::ratio, &Relaxation::Branch::time}) {
            const auto moved = [&](double factor) {
                Relaxation other = fit.relaxation;
                other.branches[i].*member *= factor;
                return squares(table, fit.relaxed_modulus, other);
            };
            EXPECT_NEAR(newton_step(moved(1 - h), here, moved(1 + h), h), 0, allowed) << i;
        }
}

// A power law, the spectrum of which has no gaps: G' = S w^m cos(m pi/2), G'' = S w^m sin(m pi/2)
// above a plateau.
TEST(DmaFit, OneTermPerDecadeFollowsAPowerLaw) {
    DmaTable table{.name = "dma.csv", .omega = {}, .storage = {}, .loss = {}};
    const double m = 0.3;
    for (int k = 0; k <= 40; ++k) {
        const double omega = std::pow(10., -2 + 0.1 * k);
        table.omega.push_back(omega);
        table.storage.push_back(1e6 +
                                1e6 * std::pow(omega, m) * std::cos(m * std::numbers::pi / 2));
        table.loss.push_back(1e6 * std::pow(omega, m) * std::sin(m * std::numbers::pi / 2));
    }
    const DmaFit fit = fit_prony(table);
    EXPECT_LE(fit.relaxation.branches.size(), 5U);
    EXPECT_GE(fit.relaxation.branches.size(), 4U);
    // One term per decade leaves a ripple of a few per cent in G'' (Tschoegl 1989, ch. 6).
    EXPECT_LT(fit.loss_rms, 0.04);
    EXPECT_LT(fit.storage_rms, 0.02);
    EXPECT_EQ(remarks(fit, fit.relaxed_modulus).size(), 1U);
}

TEST(DmaFit, ATableOfNoSolidHasLargeResiduals) {
    // G' of a solid with positive moduli cannot fall with the frequency.
    DmaTable table = table_of(2e6, {{0.5, 0.3}}, 21, 0.1, 100);
    std::reverse(table.storage.begin(), table.storage.end());
    const DmaFit fit = fit_prony(table);
    // From 3 to 2 MPa with a constant at best: 13 % for a straight line between them.
    EXPECT_GT(fit.storage_rms, 0.1);
    EXPECT_GT(fit.relaxed_modulus, 0);
    for (const auto& [ratio, time] : fit.relaxation.branches) {
        EXPECT_GT(ratio, 0);
        EXPECT_TRUE(std::isfinite(ratio) && std::isfinite(time));
    }
    const auto lines = remarks(fit, fit.relaxed_modulus);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_NE(lines[1].find("poor fit: residuals above 5 %"), std::string::npos) << lines[1];
}

TEST(DmaFit, RemarksSayWhenTheModulusIsAnother) {
    const DmaFit fit = fit_prony(table_of(2e6, {{0.5, 0.3}}, 21, 0.1, 100));
    const auto lines = remarks(fit, 2e6);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].rfind("dma.csv: Prony series of 1 term fitted to 21 frequencies; ", 0), 0U)
        << lines[0];
    EXPECT_EQ(remarks(fit, 2e6 / 1.09).size(), 1U);
    EXPECT_EQ(remarks(fit, 2e6 / 0.91).size(), 1U);
    for (const double factor : {1.25, 0.8}) {
        const auto more = remarks(fit, 2e6 / factor);
        ASSERT_EQ(more.size(), 2U);
        const std::string expected = factor > 1 ? "by +25.0 % from" : "by -20.0 % from";
        EXPECT_NE(more[1].find(expected), std::string::npos) << more[1];
    }
}

std::string message_of(const DmaTable& table) {
    try {
        fit_prony(table);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(DmaFit, RefusesTablesThatSayTooLittle) {
    const Branches solid{{0.5, 0.3}};
    EXPECT_EQ(message_of(table_of(2e6, solid, 3, 0.1, 100)),
              "dma.csv: the number of rows is 3, but a fit needs at least 4; measure at more "
              "frequencies, or give moduli and times");
    DmaTable table = table_of(2e6, solid, 5, 1, 16);
    table.loss[2] = -1;
    EXPECT_EQ(message_of(table),
              "dma.csv: row 3: G'' = -1: must be positive and finite; correct it");
    table = table_of(2e6, solid, 5, 1, 16);
    table.omega[3] = table.omega[2];
    EXPECT_EQ(message_of(table),
              "dma.csv: row 4: omega = 4: frequencies must increase from row to row; correct it");
}

TEST(DmaFit, RefusesAFluid) {
    DmaTable table = table_of(1, {{1, 0.3}}, 21, 0.1, 100);
    for (double& storage : table.storage) storage -= 1;  // Maxwell's fluid
    EXPECT_EQ(message_of(table).rfind("dma.csv: no relaxed modulus: the best Prony series is that "
                                      "of a fluid, with residuals (root mean square) of ",
                                      0),
              0U)
        << message_of(table);
}

}  // namespace
}  // namespace tricontact::contact::dma_fit_test
