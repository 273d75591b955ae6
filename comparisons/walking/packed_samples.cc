#include "comparisons/walking/packed_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "comparisons/base64.h"

namespace tricontact::comparisons::walking {

PackedSamples packed(std::span<const float> samples) {
    if (samples.empty()) return {};
    if (!std::all_of(samples.begin(), samples.end(), [](float x) { return std::isfinite(x); }))
        throw std::invalid_argument("a sample that is not finite cannot be packed");
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
    constexpr double most = 32767;
    PackedSamples result;
    result.offset = (static_cast<double>(*low) + *high) / 2;
    result.scale = (static_cast<double>(*high) - *low) / (2 * most);
    std::string bytes;
    for (const double sample : samples) {
        const double whole =
            result.scale > 0 ? std::round((sample - result.offset) / result.scale) : 0;
        const auto bits =
            static_cast<std::uint16_t>(static_cast<std::int16_t>(std::clamp(whole, -most, most)));
        bytes += static_cast<char>(bits & 0xff);
        bytes += static_cast<char>(bits >> 8);
    }
    result.base64 = base64(bytes);
    return result;
}

}  // namespace tricontact::comparisons::walking
