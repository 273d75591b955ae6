#include "comparisons/tractive/free_rolling.h"

#include "comparisons/model_assumptions.h"
#include "theory/free_rolling.h"

namespace tricontact::comparisons::tractive {

namespace {

bool rolls_freely(const contact::Case& c) {
    return c.load.tangential_force.value_or(0) == 0 && c.load.tangential_ratio.value_or(0) == 0 &&
           !c.tractive_rolling->longitudinal_creepage;
}

}  // namespace

std::vector<FreeCreepage> free_creepages(const contact::Case& c) {
    const double beta = c.materials().dundurs_beta();
    if (!c.is_line_contact() || !rolls_freely(c) || !couples(c, "bem") || c.relaxation) return {};
    const double slope = contact::half_space_scales(c).contact_radius / c.indenter.radius;
    return {{"Bentall and Johnson, all sticks", "bentall_johnson_rough",
             slope * theory::rough_free_creepage(beta)},
            {"Bentall and Johnson, all slips", "bentall_johnson_smooth",
             slope * theory::smooth_free_creepage(beta)}};
}

}  // namespace tricontact::comparisons::tractive
