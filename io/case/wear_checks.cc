#include "contact/path_cycles.h"
#include "contact/wearing_contact.h"
#include "io/case/case_checks.h"

namespace tricontact::io {

namespace {

using contact::Case;

const std::string omit_wear = "leave out [wear]";

void check_wear_models(const Case& c, const std::string& key, const Document& document) {
    for (const std::string& model : c.models) {
        const contact::ModelKind& kind = contact::model_kind(model);
        const bool wears = (kind.is_on_cells() || kind.is_meshed() || kind.is_independent()) &&
                           !kind.is_section() && !kind.is_read();
        if (!wears)
            refuse(document, key, model + " has no worn profile",
                   "leave out " + model + " or [wear]; bem, bem-layer, fem and mdr wear");
        if (!kind.is_independent()) continue;
        if (!contact::is_hertz_round(c) || !c.friction.is_coulomb() || c.interface.is_elastic())
            refuse(document, key,
                   "mdr wears a paraboloid or sphere under Coulomb's law on a rigid interface",
                   "leave out mdr, take bem");
    }
}

}  // namespace

void check_wear(const Case& c, const Document& document) {
    const contact::Wear* wear = c.kept.find<contact::Wear>();
    if (!wear) return;
    const std::string key = "wear.cycles";
    if (!c.prescribed_path)
        refuse(document, key,
               "only the closed cycles of [path] wear the surfaces; wear by rolling "
               "is not computed",
               "give [path] instead of the load, or " + omit_wear);
    if (contact::closed_cycles(*c.prescribed_path).empty())
        refuse(document, path_key(document),
               "no closed cycle, which [wear] repeats: its drive has to turn back twice, and end "
               "where it turned first",
               "add rows, or " + omit_wear);
    const contact::Vector2 reach = c.prescribed_path->reach();
    if (reach[0] > 0 || reach[1] > 0)
        refuse(document, path_key(document),
               "an indenter that rolls is not worn: [wear] takes points that keep their place",
               "omit offset_x and offset_y, or " + omit_wear);
    if (c.relaxation)
        refuse(document, key, "cycles of a relaxing substrate do not repeat themselves",
               "leave out [substrate.relaxation] or [wear]");
    if (c.friction.weakening || c.friction.yield)
        refuse(document, key, "friction that remembers the way of slip is not worn",
               "leave out its memory, or " + omit_wear);
    if (c.law != Case::Law::linear)
        refuse(document, key, "fem at finite strains has no worn profile",
               "set substrate.material to \"linear\", or " + omit_wear);
    if (c.period || contact::is_nominally_flat(c))
        refuse(document, key, "rough and periodic surfaces are not worn",
               "take a smooth body without bem.period, or " + omit_wear);
    check_wear_models(c, key, document);
}

}  // namespace tricontact::io
