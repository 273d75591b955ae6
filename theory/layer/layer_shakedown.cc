#include "theory/layer/layer_shakedown.h"

#include <stdexcept>
#include <string>

#include "theory/arguments.h"
#include "theory/bracketed_root.h"

namespace tricontact::theory {

namespace {}  // namespace

double shakedown_limit(const LayerContact& contact, double w) {
    check_unit_interval("shakedown on a layer", "w = W/a", w);
    const double a = contact.contact_radius;
    return 1 - contact.line_load.integral(w * a) / contact.line_load.integral(a);
}

double amplitude_limit(const LayerContact& contact, double f) {
    check_unit_interval("shakedown on a layer", "f = F_T/(mu F_N)", f);
    if (f == 0 || f == 1) return 1 - f;
    const auto excess = [&](double w) { return shakedown_limit(contact, w) - f; };
    return bracketed_root(excess, 0., 1., 1 - f, -f, 50);
}

}  // namespace tricontact::theory
