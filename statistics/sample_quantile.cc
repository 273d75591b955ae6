#include "statistics/sample_quantile.h"

#include <algorithm>

namespace tricontact::statistics {

double sample_quantile(std::vector<double> values, double probability) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(
                                            probability * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, place);
    return *place;
}

}  // namespace tricontact::statistics
