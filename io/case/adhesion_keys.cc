// Keys of surfaces that attract each other.

#include "io/case/case_keys.h"

namespace tricontact::io {

namespace {

using contact::Adhesion;
using contact::Case;

}  // namespace

std::vector<CaseKey> adhesion_keys() {
    return {
        {quantity_key("adhesion.work", Dimension::energy_per_area, above_zero(1e6), R"("50 mJ/m2")",
                      "w, the work per area that separates the surfaces, which attract each "
                      "other",
                      {.required = true}),
         at<&Case::adhesion, &Adhesion::work>},
        {quantity_key("adhesion.range", Dimension::length, from_zero(1e6), R"("0.2 um")",
                      "distance over which they do; 0: none, by Johnson, Kendall and Roberts",
                      {.default_value = R"("0 m")", .alternative = adhesion_range}),
         at<&Case::adhesion, &Adhesion::range>},
        {quantity_key("adhesion.peak_stress", Dimension::pressure, above_zero(1e15),
                      R"("0.25 MPa")",
                      "the largest tension sigma_0, instead: the range is w/sigma_0",
                      {.alternative = adhesion_range, .stands_for = "adhesion.range"}),
         at<&Case::adhesion, &Adhesion::peak_stress>},
        {choice_key("adhesion.law",
                    {choice("dugdale", Adhesion::Law::dugdale),
                     choice("exponential", Adhesion::Law::exponential)},
                    R"("exponential")",
                    "tension over the gap g of a range above 0: \"dugdale\": sigma_0 up to the "
                    "range, \"exponential\": sigma_0 exp(-g/range)",
                    {.default_value = R"("dugdale")", .needs = "adhesion.range"}),
         [](Case& c) {
             return c.adhesion && !c.adhesion->is_short_ranged() ? Field(&c.adhesion->law)
                                                                 : Field();
         }}};
}

}  // namespace tricontact::io
