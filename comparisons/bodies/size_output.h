#pragma once

#include <string>
#include <vector>

#include "comparisons/bodies/body_sizes.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// "0.062 (0.0618 to 0.0622)", "beyond 0.35"; a dash where unknown.
std::string limit_text(const std::optional<StrainThreshold>& limit, double largest);

/// Every ratio in one long table: body, support, hub radius over R, Poisson's ratio, quantity,
/// what is equal, a/R of Hertz, ratio of body over half-space, its error.
std::string size_csv(const SizeDeviation& deviation);

/// The case's own load, limits of every body and all ratios; fixed keys in fixed order, undefined
/// numbers null. `case_text` is that of the resolved case.
std::string size_json(const std::string& version, const std::string& case_text,
                      const SizeDeviation& deviation);

/// Up to which size the case's body is a half-space, in sentences with numbers.
std::vector<report::Verdict> size_verdicts(const SizeDeviation& deviation);

/// The case's body by quantity: the ratio at its own load, a/R for 1, 2, 5 %.
report::DocumentTable size_table(const SizeDeviation& deviation);

/// Deviations over a/R: of the case's body by quantity, then one figure per quantity with all
/// bodies.
std::vector<report::Figure> size_figures(const SizeDeviation& deviation);

/// Verdicts, the case's body, other bodies, how it was computed.
report::Document size_document(const SizeDeviation& deviation);

}  // namespace tricontact::comparisons
