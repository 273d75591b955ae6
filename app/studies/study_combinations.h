#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/case/study_reader.h"

namespace tricontact::app {

/// What a study says of one of its points.
struct Combination {
    std::vector<std::string> values;  ///< one per axis, as in the table
    std::vector<io::Entry> entries;   ///< for the case: keys that are set, then keys that vary
};

/// Most points of a study, models and levels included: each one's case is checked ahead and kept,
/// a few kB.
inline constexpr std::size_t most_points = 100'000;

/// Calls for all combinations of the study's lists, ranges and sample, the last axis fastest.
/// `n_each`: points that the caller makes of each. Throws contact::InputError if they are more than
/// most_points.
void for_each_combination(const io::Study& study, std::size_t n_each,
                          const std::function<void(const Combination&)>& call);

/// "rolling.amplitude_m = 0.001, load.tangential_ratio = 0.3", for messages.
std::string text_of(const io::Study& study, const Combination& combination);

}  // namespace tricontact::app
