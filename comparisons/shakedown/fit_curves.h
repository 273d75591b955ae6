#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/shakedown/rolling_points.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// A closed form given by x and y over a parameter, dashed.
report::Curve closed_form(const std::string& name, double from, double to,
                          const std::function<double(double)>& x,
                          const std::function<double(double)>& y, int colour);

/// Where a point lies in a figure, and its bar; empty: nowhere.
using Place = std::function<std::optional<std::pair<double, Computed>>(const RollingPoint&)>;

/// A curve of points for each model, coloured by its place in `models`.
void add_model_points(report::Figure& figure, const std::vector<std::string>& models,
                      const std::vector<const RollingPoint*>& points, const Place& place);

/// A limit of a model, the same at all points of an amplitude, is drawn once.
Place once_per_amplitude(const Place& place);

// Places in the figures that round bodies and line contacts have alike.

/// u_sd over f_T.
Place over_load(const Quantity& q);
/// The same from loads of `share` of the model's limit on.
Place settled_near_limit(double share);
/// w over the model's f_T,lim, once per amplitude.
Place amplitude_over_limit();
/// Du over f_T.

/// Those in which a model has points, without empty curves.
std::vector<report::Figure> with_model_points(const std::vector<report::Figure>& figures);

}  // namespace tricontact::comparisons
