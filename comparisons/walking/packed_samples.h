#pragma once

#include <span>
#include <string>

namespace tricontact::comparisons::walking {

/// Samples for a page that holds thousands of curves: value = offset + scale i, whole numbers i of
/// 16 bits in base64, little-endian. Off by at most scale/2: half of 1/65534 of what they span.
struct PackedSamples {
    double offset = 0, scale = 0;
    std::string base64;
};

/// Throws std::invalid_argument for a sample that is not finite.
PackedSamples packed(std::span<const float> samples);

}  // namespace tricontact::comparisons::walking
