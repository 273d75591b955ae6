#include <algorithm>

#include "comparisons/quantities/quantities.h"

namespace tricontact::comparisons::quantities {

namespace {

/// Largest of all steps.
template <double contact::StepRecord::*member>
QuantityValue largest(const Subject& s) {
    double value = 0;
    for (const contact::StepRecord& step : s.history.steps) value = std::max(value, step.*member);
    return value > 0 ? finite(value) : QuantityValue();
}

constexpr const char* computed = "of models at finite strains";

}  // namespace

constinit const Quantity largest_stretch{
    .key = "largest_stretch",
    .name = "largest stretch",
    .meaning =
        "Largest principal stretch at any Gauss point in any step: length over length at "
        "rest.",
    .defined = computed,
    .source = "Ogden (1984), 2.2.5",
    .of = largest<&contact::StepRecord::largest_stretch>,
    .part = Part::inside};

constinit const Quantity largest_shear{
    .key = "largest_shear",
    .name = "largest shear",
    .meaning =
        "Largest difference of the principal stretches at a point, in any step: of simple "
        "shear its amount.",
    .defined = computed,
    .source = "Ogden (1984), 2.2.6",
    .of = largest<&contact::StepRecord::largest_shear>,
    .part = Part::inside};

List of_strain() {
    return {&largest_stretch, &largest_shear};
}

}  // namespace tricontact::comparisons::quantities
