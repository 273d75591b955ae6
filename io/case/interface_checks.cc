#include "contact/models/model_kind.h"
#include "io/case/case_checks.h"

namespace tricontact::io {

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
