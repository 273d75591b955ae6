#include "app/roll_models.h"

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "io/results/case_json.h"
#include "rolling/rolling_document.h"

namespace tricontact::app {

rolling::RollingRun roll(const std::string& model, const contact::Case& c, const RollRuns& runs) {
    return model == "mdr" ? roll_springs(c, runs) : roll_grid(model, c, runs);
}

std::string roll_summary(const rolling::RollingReport& report, const std::string& resolved) {
    nlohmann::ordered_json json{{"version", report.version}, {"case", io::case_json(resolved)}};
    json.update(rolling::rolling_json(report));
    return json.dump(2) + '\n';
}

bool LineSchedule::due(double way) {
    using rolling::line_distances;
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
