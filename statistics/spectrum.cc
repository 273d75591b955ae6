#include "statistics/spectrum.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "contact/base/fftw.h"
#include "contact/base/special_values.h"

namespace tricontact::statistics {

namespace {

using std::numbers::pi;

/// Transform of real values, which are overwritten.
std::vector<std::complex<double>> transform(std::vector<double>& values) {
    std::vector<std::complex<double>> result(values.size() / 2 + 1);
    contact::let_threads_plan();
    const contact::FftwPlan plan(
        fftw_plan_dft_r2c_1d(static_cast<int>(values.size()), values.data(),
                             reinterpret_cast<fftw_complex*>(result.data()), FFTW_ESTIMATE));
    fftw_execute(plan.get());
    return result;
}

std::span<const double> part_of(std::span<const double> values, int part, int n_parts) {
    const std::size_t length = values.size() / n_parts;
    return values.subspan(part * length, length);
}

}  // namespace

Spectrum spectrum(std::span<const double> values, double interval) {
    const std::size_t n = values.size();
    if (n < 4) throw std::invalid_argument("a spectrum needs at least four values");
    const double mean = std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(n);
    std::vector<double> windowed(n);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double hann =
            0.5 - 0.5 * std::cos(2 * pi * static_cast<double>(i) / static_cast<double>(n));
        windowed[i] = hann * (values[i] - mean);
        sum += hann;
    }
    Spectrum result{1 / (static_cast<double>(n) * interval), {}};
    for (const std::complex<double>& value : transform(windowed))
        result.amplitudes.push_back(2 * std::abs(value) / sum);
    return result;
}

Spectrum mean_spectrum(std::span<const double> values, double interval, int n_parts) {
    Spectrum result;
    for (int part = 0; part < n_parts; ++part) {
        const Spectrum one = spectrum(part_of(values, part, n_parts), interval);
        result.resolution = one.resolution;
        result.amplitudes.resize(one.amplitudes.size());
        for (std::size_t i = 0; i < one.amplitudes.size(); ++i)
            result.amplitudes[i] += one.amplitudes[i] * one.amplitudes[i] / n_parts;
    }
    for (double& amplitude : result.amplitudes) amplitude = std::sqrt(amplitude);
    return result;
}

double peak_frequency(const Spectrum& spectrum) {
    const std::vector<double>& a = spectrum.amplitudes;
    const auto peak = std::max_element(a.begin(), a.end());
    if (*peak == 0 || std::isnan(*peak)) return contact::undefined;
    // A sine between two lines shows in both; the greater neighbour tells where.
    const auto i = std::clamp<std::ptrdiff_t>(peak - a.begin(), 1, std::ssize(a) - 2);
    const double side = a[i + 1] > a[i - 1] ? 1 : -1;
    const double ratio = std::max(a[i + 1], a[i - 1]) / a[i];
    const double between = side * (2 * ratio - 1) / (ratio + 1);
    return (static_cast<double>(i) + between) * spectrum.resolution;
}

CharacteristicFrequency characteristic_frequency(std::span<const double> values, double interval,
                                                 int n_parts) {
    std::vector<double> peaks;
    for (int part = 0; part < n_parts; ++part)
        peaks.push_back(peak_frequency(spectrum(part_of(values, part, n_parts), interval)));
    const double mean = std::accumulate(peaks.begin(), peaks.end(), 0.) / n_parts;
    double squares = 0;
    for (const double peak : peaks) squares += (peak - mean) * (peak - mean);
    const boost::math::students_t distribution(n_parts - 1);
    const double factor = boost::math::quantile(distribution, 0.975);
    return {mean, factor * std::sqrt(squares / (n_parts - 1) / n_parts)};
}

std::vector<double> running_variance(std::span<const double> values, std::size_t length) {
    std::vector<double> result;
    if (length == 0 || values.size() < length) return result;
    const double n = static_cast<double>(length);
    // Welford's update for a window that gains one value and loses another: no difference of great
    // sums, which would swallow a small variance.
    double mean = 0, squares = 0;
    for (std::size_t i = 0; i < length; ++i) {
        const double before = mean;
        mean += (values[i] - mean) / static_cast<double>(i + 1);
        squares += (values[i] - before) * (values[i] - mean);
    }
    result.push_back(squares / n);
    for (std::size_t i = length; i < values.size(); ++i) {
        const double gained = values[i], lost = values[i - length], before = mean;
        mean += (gained - lost) / n;
        squares += (gained - lost) * (gained - mean + lost - before);
        result.push_back(std::max(0., squares) / n);
    }
    return result;
}

double share_above(std::span<const double> variances, double threshold) {
    if (variances.empty()) return contact::undefined;
    const auto above = std::count_if(variances.begin(), variances.end(),
                                     [threshold](double variance) { return variance > threshold; });
    return static_cast<double>(above) / static_cast<double>(variances.size());
}

}  // namespace tricontact::statistics
