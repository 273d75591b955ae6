#include "statistics/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "tests/unit/walking/sets.h"

namespace tricontact::statistics::spectrum_test {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<double> sine(std::size_t n, double interval, double frequency, double amplitude,
                         double mean) {
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i)
        values[i] =
            mean +
            amplitude * std::sin(2 * pi * frequency * interval * static_cast<double>(i) + 0.3);
    return values;
}

TEST(Spectrum, ShowsAmplitudeAndFrequencyOfASine) {
    // On a line of the spectrum: 25 cycles in 500 values.
    const Spectrum result = spectrum(sine(500, 0.02, 2.5, 3, 7), 0.02);
    EXPECT_DOUBLE_EQ(result.resolution, 0.1);
    EXPECT_NEAR(result.amplitudes[25], 3, 1e-12);
    EXPECT_NEAR(result.amplitudes[0], 0, 1e-12);
    EXPECT_NEAR(peak_frequency(result), 2.5, 1e-12);
}

// Leakage of the sine at negative frequency under a Hann window falls with the cube of the number
// of cycles k in the record: the frequency is off by the order of 1/k^3 lines.
TEST(Spectrum, FindsAFrequencyBetweenItsLines) {
    for (const double cycles : {20.25, 40.37, 80.5}) {
        const Spectrum result = spectrum(sine(1000, 0.05, cycles / 50, 1, 0.2), 0.05);
        EXPECT_NEAR(peak_frequency(result) / result.resolution, cycles,
                    4 / (cycles * cycles * cycles));
    }
}

// Parseval: the energy of the windowed values is that of the lines, inner ones counted twice.
TEST(Spectrum, KeepsTheEnergy) {
    for (const std::size_t n : {400u, 401u}) {
        std::mt19937 generator(3);
        std::normal_distribution<double> noise;
        std::vector<double> values(n);
        double mean = 0;
        for (double& value : values) mean += (value = noise(generator)) / static_cast<double>(n);
        double energy = 0, window_sum = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double window =
                std::pow(std::sin(pi * static_cast<double>(i) / static_cast<double>(n)), 2);
            energy += std::pow(window * (values[i] - mean), 2);
            window_sum += window;
        }
        const Spectrum result = spectrum(values, 1);
        double lines = 0;
        for (std::size_t i = 0; i < result.amplitudes.size(); ++i) {
            const bool inner = i > 0 && 2 * i != n;
            const double modulus = result.amplitudes[i] * window_sum / 2;
            lines += (inner ? 2 : 1) * modulus * modulus / static_cast<double>(n);
        }
        EXPECT_NEAR(lines / energy, 1, 1e-12);
    }
}

TEST(Spectrum, OfPartsIsThatOfEachWhereTheyAgree) {
    const auto values = sine(800, 0.1, 0.5, 2, 1);  // five cycles in 100 values
    const Spectrum whole = mean_spectrum(values, 0.1, 8),
                   part = spectrum(sine(100, 0.1, 0.5, 2, 1), 0.1);
    ASSERT_EQ(whole.amplitudes.size(), part.amplitudes.size());
    for (std::size_t i = 0; i < part.amplitudes.size(); ++i)
        EXPECT_NEAR(whole.amplitudes[i], part.amplitudes[i], 1e-9);
}

TEST(Spectrum, NeedsValuesThatVibrate) {
    EXPECT_THROW(spectrum(std::vector<double>{1, 2, 3}, 1), std::invalid_argument);
    EXPECT_TRUE(std::isnan(peak_frequency(spectrum(std::vector<double>(100, 0.25), 1))));
}

// A phase that wanders: the interval has to contain the frequency in 95 % of the records. Of 200,
// 95 % +- 3.3 % (two standard deviations of a binomial) do; 8 parts make the interval one of
// Student's t.
TEST(CharacteristicFrequency, IntervalCoversTheTruthAsOftenAsItClaims) {
    std::mt19937 generator(11);
    std::normal_distribution<double> noise;
    constexpr int n_records = 200;
    constexpr double frequency = 0.25, interval = 0.25;
    int covered = 0;
    for (int record = 0; record < n_records; ++record) {
        std::vector<double> values;
        double phase = 0;
        for (int i = 0; i < 8 * 400; ++i) {
            phase += 2 * pi * frequency * interval + 0.05 * noise(generator);
            values.push_back(std::sin(phase));
        }
        const auto [found, error] = characteristic_frequency(values, interval, 8);
        if (std::abs(found - frequency) <= error) ++covered;
    }
    EXPECT_GE(covered, 183);
    EXPECT_LE(covered, 197);
}

// Two values have the standard error |a - b|/2, and Student's t of one degree of freedom is 12.7062
// (Abramowitz and Stegun 1964, table 26.10). Both sines lie on lines of the spectrum.
TEST(CharacteristicFrequency, IntervalOfTwoPartsIsStudents) {
    auto values = sine(500, 0.02, 2.5, 3, 7);
    for (const double value : sine(500, 0.02, 2.9, 3, 7)) values.push_back(value);
    const auto [found, error] = characteristic_frequency(values, 0.02, 2);
    EXPECT_NEAR(found, 2.7, 1e-12);
    EXPECT_NEAR(error, 12.7062 * 0.4 / 2, 1e-5);
}

}  // namespace
}  // namespace tricontact::statistics::spectrum_test
