#include "app/roll_models.h"

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "contact/error.h"
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

void refuse_rolling_on(const contact::Case& c, const std::string& case_file) {
    if (c.tractive_rolling)
        throw contact::InputError(case_file +
                                  ": [tractive_rolling]: the indenter rolls on and does not come "
                                  "back; tricontact roll computes such a case");
}

void require_rolling_on(const contact::Case& c, const std::string& case_file) {
    if (!c.tractive_rolling)
        throw contact::InputError(case_file +
                                  ": there is no [tractive_rolling], so that nothing rolls on; "
                                  "tricontact run computes it, or add that section");
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
