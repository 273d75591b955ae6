#pragma once

#include <string>
#include <vector>

#include "comparisons/layer.h"
#include "comparisons/report_tables.h"

namespace tricontact::comparisons {

/// What the thickness and the width of the layer mean for this case, in plain sentences.
std::vector<std::string> layer_sentences(const contact::Case& c, const LayerComparison& layer);

/// How the models treat coupling, displaced surface and pressing, and what other choices would
/// change, in plain sentences. `models`: those of the case.
std::vector<std::string> treatment_sentences(const contact::Case& c,
                                             const std::vector<std::string>& models,
                                             const std::vector<StaticVariant>& variants);

/// Exact layer, half-space and models, with differences to the first of these that is there.
Table layer_table(const LayerComparison& layer);

/// Static shifts with one choice changed.
Table variants_table(const std::vector<StaticVariant>& variants);

}  // namespace tricontact::comparisons
