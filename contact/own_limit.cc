#include "contact/own_limit.h"

#include <fmt/format.h>

#include <set>

#include "contact/base/error.h"
#include "contact/load_path.h"

namespace tricontact::contact {

namespace {

Case with_ratio(Case c, double tangential_ratio) {
    c.load.set_tangential_ratio(tangential_ratio);
    return c;
}

}  // namespace

FrictionlessLimit frictionless_limit(const Case& c, Model& model) {
    LoadStep press = press_step(c);
    press.friction = false;
    model.advance(press);
    const Scales scales = model.scales();
    const LoadPath path = make_load_path(with_ratio(c, 0), scales.normal_force,
                                         scales.contact_radius, scales.sliding_force);
    model.start_limit();
    std::set<Vector2> visited{press.offset};
    for (LoadStep step : path.period) {
        // What does not relax presses alike wherever it comes from.
        if (!visited.insert(step.offset).second && !c.relaxation) continue;
        step.friction = false;
        model.advance(step);
    }
    return {scales, model.limit_tangential_ratio()};
}

Case loaded_by_own_limit(const Case& c, Model& model) {
    if (!c.load.is_by_limit()) return c;
    const auto [scales, limit] = frictionless_limit(c, model);
    model.release();
    if (c.load.limit_fraction && !(limit > 0))
        throw InputError(fmt::format(
            "load.limit_fraction: {}: rolling by {:.4g} mm leaves no point in contact all the "
            "time: the limit is 0; lower rolling.amplitude or rolling.amplitude_ratio",
            model.name(), 1e3 * path_amplitude(c, scales.contact_radius)));
    return with_ratio(c, c.load.ratio_by_limit(limit));
}

Case loaded_as(const Case& c, const History& history) {
    if (!c.load.is_by_limit()) return c;
    return with_ratio(c, history.tangential_force / history.friction_limit);
}

}  // namespace tricontact::contact
