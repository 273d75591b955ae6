#include <algorithm>

#include "experiments/identification/estimation/identification.h"

namespace tricontact::experiments {

std::size_t IdentificationTask::n_observations() const {
    std::size_t n = 0;
    for (const ObservedTable& table : tables) n += table.observed.size();
    return n;
}

std::size_t IdentificationTask::n_own() const {
    std::size_t n = 0;
    for (const ObservedTable& table : tables) n += table.n_own();
    return n;
}

std::vector<double> origins_of(const IdentificationTask& task, const std::vector<double>& values,
                               const std::vector<double>& errors) {
    std::vector<double> origins;
    std::size_t row = 0;
    for (const ObservedTable& table : task.tables) {
        double weights = 0, sum = 0;
        for (const double observed : table.observed) {
            const double weight = 1 / (errors[row] * errors[row]);
            weights += weight;
            sum += weight * (observed - values[row++]);
        }
        origins.push_back(table.has_free_origin ? sum / weights : 0);
    }
    return origins;
}

std::vector<double> residuals_of(const IdentificationTask& task, std::vector<double> values,
                                 const std::vector<double>& errors) {
    const auto origins = origins_of(task, values, errors);
    std::size_t row = 0;
    for (std::size_t t = 0; t < task.tables.size(); ++t)
        for (const double observed : task.tables[t].observed) {
            values[row] = (observed - origins[t] - values[row]) / errors[row];
            ++row;
        }
    return values;
}

}  // namespace tricontact::experiments
