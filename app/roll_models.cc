#include "app/roll_models.h"

#include <cmath>
#include <iterator>

namespace tricontact::app {

bool LineSchedule::due(double way) {
    using comparisons::tractive::line_distances;
    const std::size_t before = next_;
    while (next_ < std::size(line_distances) && way >= line_distances[next_]) ++next_;
    return next_ > before;
}

std::vector<double> curve_creepages(double sliding, int n) {
    constexpr double beyond = 1.25;  // the cubic law ends early for most
    std::vector<double> creepages;
    for (int i = 1; i <= n; ++i)
        creepages.push_back(beyond * sliding * (1 - std::cbrt(1 - i / static_cast<double>(n))));
    return creepages;
}

}  // namespace tricontact::app
