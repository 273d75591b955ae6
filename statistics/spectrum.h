#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tricontact::statistics {

/// One-sided amplitudes of evenly sampled values: a sine of amplitude A shows as A at its
/// frequency, twice the modulus of Wetter (2016), eq. 5.2.31.
struct Spectrum {
    double resolution = 0;           ///< frequency of amplitudes[i] is i times this, in cycles
    std::vector<double> amplitudes;  ///< of the values about their mean, up to half the sampling
};

/// Amplitudes by a Fourier transform under a Hann window. `interval` > 0: between two values. At
/// least four of them; throws std::invalid_argument for fewer.
Spectrum spectrum(std::span<const double> values, double interval);

/// Root mean square of the spectra of equally long parts of the values: Bartlett (1948), Nature
/// 161. `n_parts` >= 1.
Spectrum mean_spectrum(std::span<const double> values, double interval, int n_parts);

/// Frequency of the largest amplitude in cycles, between the lines of the spectrum: exact for a
/// sine under a Hann window, far from both ends of the spectrum. Grandke (1983), IEEE Trans.
/// Instrum. Meas. 32. NaN where nothing vibrates.
double peak_frequency(const Spectrum& spectrum);

/// Frequency at which values vibrate most.
struct CharacteristicFrequency {
    double frequency = 0;  ///< cycles per unit time, mean over parts; NaN where nothing vibrates
    double error = 0;      ///< half width of the 95 % interval from their scatter
};

/// From the peaks of `n_parts` >= 2 equally long parts, as Wetter (2016), eq. 5.2.36, has it from
/// ten records.
CharacteristicFrequency characteristic_frequency(std::span<const double> values, double interval,
                                                 int n_parts);

/// Variance of the values in windows of `length` >= 1 of them, one for each place of the window.
/// Wetter (2016), eqs. 4.3.1 and 4.3.2, with the deviations squared: as printed they are not, and
/// their sum would be zero. Empty where the window is longer than the values.
std::vector<double> running_variance(std::span<const double> values, std::size_t length);

/// Share of the windows whose variance exceeds the threshold: Wetter's time of instability, t_is/T.
/// NaN for none.
double share_above(std::span<const double> variances, double threshold);

}  // namespace tricontact::statistics
