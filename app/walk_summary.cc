#include "app/walk_summary.h"

#include <nlohmann/json.hpp>

#include "app/case_json.h"
#include "comparisons/walking/walk_json.h"

namespace tricontact::app {

std::string walk_summary(const dynamics::WalkCase& walk_case, const std::string& resolved,
                         const dynamics::Walk& walk) {
    nlohmann::ordered_json json{{"version", TRICONTACT_VERSION}, {"case", case_json(resolved)}};
    json.update(comparisons::walking::walk_json(walk_case, walk));
    return json.dump(2) + '\n';
}

}  // namespace tricontact::app
