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
        if (kind.sees_elastic_interface) continue;
        refuse(document, key,
               kind.is_on_line()
                   ? "springs at each point of the surface couple the springs of " + model
                   : model + " knows rigid interfaces alone",
               "leave out " + model + " (mdr-layer knows them), or leave out [interface]");
    }
}

}  // namespace tricontact::io
