#include "contact/history.h"

#include <algorithm>
#include <cmath>

#include "contact/special_values.h"

namespace tricontact::contact {

void Audit::record(const std::string& name, double violation, double allowed) {
    if (std::isnan(violation)) violation = infinity;
    auto it = std::find_if(checks_.begin(), checks_.end(),
                           [&](const Check& check) { return check.name == name; });
    if (it == checks_.end()) it = checks_.insert(it, Check{name, 0, allowed});
    it->worst = std::max(it->worst, violation);
}

bool Audit::passed() const {
    return std::all_of(checks_.begin(), checks_.end(),
                       [](const Check& check) { return check.passed(); });
}

}  // namespace tricontact::contact
