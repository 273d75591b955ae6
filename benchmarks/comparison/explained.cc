#include "benchmarks/comparison/explained.h"

#include <algorithm>
#include <cmath>

#include "benchmarks/comparison/explained_pressing.h"

namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
// What contact on the displaced surface leaves behind the first order, over (a/R)^2: .31, .21 and
// .35 were measured at a/R = .108, .040 and .114.
constexpr double displaced_second_order = .4;
constexpr double negligible = 1e-5;  // relative: a hundredth of the least tolerance that is usual

/// Under a prescribed depth effects act on the force, else on the depth.
bool acts_on(const std::string& key, const Reference& reference, const char* force,
             const char* path) {
    return key == (reference.is_prescribed(force) ? path : force);
}

Explained relative(const char* id, const char* title, const ReferenceValue& effect, double factor,
                   double value) {
    return {id, title, effect.value * factor / value, std::abs(effect.bar() * factor / value)};
}

}  // namespace

double edge_slope(const Reference& reference) {
    const contact::Case& c = reference.c;
    const double a = reference.contact_radius;
    // Just inside: a rim or a kink may end the contact.
    return std::abs(c.make_indenter()->slope(.999 * a, 0)[0]);
}

std::optional<Explained> displaced_surface(const std::string& key, const Reference& reference) {
    const ReferenceValue* value = reference.find(key);
    if (!value || value->value == 0 || !reference.effects.displaced_surface) return {};
    if (!acts_on(key, reference, keys::normal_force, keys::indentation)) return {};
    Explained e = relative("displaced_surface", "contact on the displaced surface",
                           *reference.effects.displaced_surface, 1, value->value);
    const double slope = edge_slope(reference);
    e.bar = std::max(e.bar, displaced_second_order * slope * slope);
    return e;
}

double added_compliance(const std::optional<double>& stiffness,
                        const std::optional<double>& of_interface) {
    constexpr double rounding = 1e-9;  // of units
    if (!stiffness) return 0;
    const double own = 1 / *stiffness, given = of_interface ? 1 / *of_interface : 0;
    return std::abs(own - given) <= rounding * own ? 0 : own - given;
}

std::vector<Explained> explained(const std::string& key, const Submission& submission,
                                 const Reference& reference, double strain_of_area) {
    const ReferenceValue* value = reference.find(key);
    if (!value || value->value == 0) return {};
    std::vector<Explained> all = explained_pressing(key, submission, reference, strain_of_area);
    const ContactMethod& contact = submission.contact;
    const FirstOrderEffects& effects = reference.effects;
    const auto add_compliance = [&](const char* id, const char* title,
                                    const std::optional<ReferenceValue>& effect,
                                    double compliance) {
        if (!effect || compliance == 0) return;
        Explained e = relative(id, title, *effect, compliance, value->value);
        e.bar = std::hypot(e.bar, e.change * e.change);
        all.push_back(e);
    };
    const contact::Interface& interface = reference.c.interface;
    if (acts_on(key, reference, keys::normal_force, keys::indentation))
        add_compliance("penalty", "normal penalty", effects.normal_compliance,
                       added_compliance(contact.stiffness, interface.normal_stiffness));
    if (acts_on(key, reference, keys::tangential_force, keys::shift))
        add_compliance("stick_slope", "elastic slip of the penalty", effects.tangential_compliance,
                       added_compliance(contact.stick_slope, interface.tangential_stiffness));
    if (contact.kinematics == ContactMethod::Kinematics::displaced ||
        contact.kinematics == ContactMethod::Kinematics::finite)
        if (auto e = displaced_surface(key, reference)) all.push_back(*e);
    const auto add_of = [&](const char* id, const char* title,
                            const std::map<std::string, ReferenceValue>& changes) {
        const auto found = changes.find(key);
        if (found != changes.end() && found->second.value != 0)
            all.push_back(relative(id, title, found->second, 1, value->value));
    };
    if (contact.press_steps == 1 && reference.c.load.press_steps > 1)
        add_of("one_step", "pressed in one step", effects.one_step);
    if (submission.block_width)
        add_of("block", "finite block", finite_block_effect(reference, *submission.block_width));
    std::erase_if(all, [](const Explained& e) { return std::abs(e.change) + e.bar < negligible; });
    return all;
}

}  // namespace tricontact::benchmarks
