#include "io/case/case_checks.h"
#include "io/case/case_keys.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Friction;

void check_law(const Friction& friction, const Document& document) {
    if (friction.pressure_exponent && !friction.coefficient)
        refuse(document, "friction.pressure_exponent",
               "no part of the friction grows with the pressure", "add friction.coefficient");
    if (friction.pressure_exponent && *friction.pressure_exponent == 1)
        refuse(document, "friction.pressure_exponent", "is Coulomb's law, without a pressure",
               "leave it out with friction.reference_pressure");
    if (friction.strength_limit && *friction.strength_limit <= friction.shear_strength.value_or(0))
        refuse(document, "friction.strength_limit",
               "is not above friction.shear_strength = " + rounded(*friction.shear_strength) +
                   " Pa: the pressure would have no say",
               "leave it out with friction.coefficient, or enlarge it");
}

/// What knows where a point lies on the substrate.
void check_map(const Case& c, const Document& document) {
    const std::string key = "friction.map";
    if (c.tractive_rolling)
        refuse(document, key, "rolling on meets no steady state where friction varies",
               "leave it out, or roll to and fro by [rolling]");
    if (c.law != Case::Law::linear)
        refuse(document, key, "at finite strains friction is the same all over",
               "leave it out, or set substrate.material to \"linear\"");
    for (const std::string& model : c.models)
        if (contact::model_kind(model).is_on_line())
            refuse(document, key, "the springs of " + model + " stand for all directions",
                   "leave out " + model + ", or leave out friction.map");
}

/// What falls with the speed of slip is Coulomb's law, in steady rolling of elastic bodies.
void check_rate(const Case& c, const Document& document) {
    const Friction& friction = c.friction;
    const contact::FrictionRate& rate = *friction.rate;
    const std::string key = "friction.rate.law";
    if (!c.tractive_rolling)
        refuse(document, key, "only a contact that rolls on has a speed of slip here",
               "add [tractive_rolling], or omit [friction.rate]");
    if (!friction.coefficient || !friction.is_coulomb_at_rest())
        refuse(document, key, "only Coulomb's law falls with the speed of slip",
               "give friction.coefficient alone beside [friction.rate]");
    if (c.relaxation)
        refuse(document, key, "a relaxing substrate rolls on under Coulomb's law alone",
               "omit [friction.rate] or [substrate.relaxation]");
    if (document.find("tractive_rolling.distance"))
        refuse(document, "tractive_rolling.distance",
               "friction that falls with the speed of slip is computed in the steady state alone, "
               "not on the way to it",
               "omit it");
    if (rate.drops.empty() || rate.drops.size() > 2)
        refuse(document, "friction.rate.drops", "has one part or two", "give one or two numbers");
    if (rate.speeds.size() != rate.drops.size())
        refuse(document, "friction.rate.speeds",
               "states " + std::to_string(rate.speeds.size()) + ", friction.rate.drops " +
                   std::to_string(rate.drops.size()),
               "give one for each of the drops");
    if (!(rate.least(*friction.coefficient) > 0))
        refuse(document, "friction.rate.drops",
               "leave " + rounded(rate.least(*friction.coefficient)) +
                   " of friction.coefficient = " + rounded(*friction.coefficient),
               "give less than that in all");
    if (rate.memory_speed > 0 && rate.memory_length == 0)
        refuse(document, "friction.rate.memory_speed", "has no effect without a memory_length",
               "give friction.rate.memory_length too, or omit this key");
}

/// What points remember of their slip: of a bound that falls with it a contact at rest or along a
/// path, of one that rises also one that rolls back and forth on an elastic body.
void check_memory(const Case& c, const Document& document, const std::string& key, bool falls) {
    const std::string omit = "omit " + key;
    if (c.tractive_rolling)
        refuse(document, key,
               "rolling on is computed for friction that does not change with the way of slip",
               omit + ", or [tractive_rolling]: [path] follows any load");
    if (c.rolling && falls)
        refuse(document, key,
               "what becomes of a contact that rolls is not decided where friction falls with the "
               "slip: Melan's argument needs bounds that do not",
               omit + ", or [rolling]: [path] follows any load");
    if (c.rolling && c.relaxation)
        refuse(document, key,
               "a contact that rolls on a relaxing substrate knows no friction that changes with "
               "the slip",
               omit + " or [substrate.relaxation], or use [path]");
    if (c.law != Case::Law::linear)
        refuse(document, key, "at finite strains friction does not change with the slip",
               omit + R"(, or set substrate.material to "linear")");
    if (c.friction.map)
        refuse(document, key, "friction that changes with the slip is the same all over",
               omit + " or friction.map");
    for (const std::string& model : c.models)
        if (contact::model_kind(model).is_on_line())
            refuse(document, key,
                   "what a spring of " + model +
                       " slips is the slip of no point: a point's is a mean over springs",
                   "leave out " + model + ", or " + omit);
}

void check_weakening(const Case& c, const Document& document) {
    const Friction& friction = c.friction;
    const std::string key = "friction.weakening.law";
    Friction at_rest = friction;
    at_rest.weakening.reset();
    if (!friction.coefficient || !at_rest.is_coulomb())
        refuse(document, key, "only Coulomb's law falls with the way of slip",
               "give friction.coefficient alone beside [friction.weakening]");
    if (friction.weakening->drop >= *friction.coefficient)
        refuse(document, "friction.weakening.drop",
               "leaves nothing of friction.coefficient = " + rounded(*friction.coefficient),
               "give less than that");
    check_memory(c, document, key, true);
}

void check_yield(const Case& c, const Document& document) {
    const Friction& friction = c.friction;
    const std::string key = "interface.yield_stress";
    if (friction.strength_limit)
        refuse(document, key, "is a second friction.strength_limit", "give one of them");
    if (friction.rate)
        refuse(document, key, "only Coulomb's law falls with the speed of slip",
               "omit it or [friction.rate]");
    if (friction.yield->stress <= friction.shear_strength.value_or(0))
        refuse(document, key,
               "is not above friction.shear_strength = " + rounded(*friction.shear_strength) +
                   " Pa: the surfaces would never slip",
               "enlarge it, or omit the shear strength");
    if (friction.remembers())
        check_memory(c, document, "interface.hardening", friction.yield->hardening < 0);
}

}  // namespace

void check_friction(const Case& c, const Document& document) {
    const Friction& friction = c.friction;
    if (!friction.coefficient && !friction.shear_strength)
        refuse_missing(*find_key("friction.coefficient"), document, case_key_list());
    check_law(friction, document);
    if (friction.map) check_map(c, document);
    if (friction.rate) check_rate(c, document);
    if (friction.weakening) check_weakening(c, document);
    if (friction.yield) check_yield(c, document);
    for (const std::string& model : c.models)
        if (friction.rate && contact::model_kind(model).is_on_line())
            refuse(document, "friction.rate.law",
                   "the springs of " + model + " do not know the speed of slip",
                   "leave out " + model + ", or omit [friction.rate]");
}

void check_interface(const contact::Case& c, const Document& document) {
    if (!c.interface.is_elastic()) return;
    const std::string key = c.interface.normal_stiffness ? "interface.normal_stiffness"
                                                         : "interface.tangential_stiffness";
    if (c.law != contact::Case::Law::linear)
        refuse(document, key, "finite strains know rigid interfaces alone",
               "leave out [interface], or set substrate.material to \"linear\"");
    for (const std::string& model : c.models) {
        const contact::ModelKind& kind = contact::model_kind(model);
        if (!kind.sees_elastic_interface)
            refuse(document, key, model + " knows rigid interfaces alone",
                   "leave out " + model + ", or leave out [interface]");
        if (kind.is_on_line() && c.tractive_rolling)
            refuse(document, key,
                   "springs of the interface couple those of " + model +
                       ", which rolls on over independent ones alone",
                   "leave out " + model + " (bem knows them), or leave out [interface]");
    }
}

}  // namespace tricontact::io
