#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "comparisons/half_space/layer.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// What the thickness and the width of the layer mean for this case, in plain sentences.
std::vector<std::string> layer_sentences(const contact::Case& c, const LayerComparison& layer);

/// Exact layer, half-space and models, with differences to the first of these that is there.
report::DocumentTable layer_table(const contact::Case& c, const LayerComparison& layer);

/// Section "layer" of summary.json: SI units; "over" another value: their ratio minus 1.
nlohmann::ordered_json layer_json(const contact::Case& c, const LayerComparison& layer);

}  // namespace tricontact::comparisons
