#include "contact/history.h"

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"

namespace tricontact::contact {

void Audit::record(const std::string& name, double violation, double allowed) {
    if (std::isnan(violation)) violation = infinity;
    auto it = std::ranges::find(checks_, name, &Check::name);
    if (it == checks_.end()) it = checks_.insert(it, Check{name, 0, allowed});
    it->worst = std::max(it->worst, violation);
}

}  // namespace tricontact::contact
