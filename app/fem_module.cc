#include "app/fem_entries.h"
#include "fem/model.h"

extern "C" const tricontact::app::FemEntries* tricontact_fem_entries() {
    using namespace tricontact;
    static const app::FemEntries entries = {
        [](const contact::Case& c, const app::Say& say) { return fem::make_model(c, say); },
        [](const contact::Case& c, const app::Say& say) { return fem::mesh_spec(c, say); },
        app::mesh_command,
        app::condense_command,
        app::cache_command,
        app::another_process_speaks,
    };
    return &entries;
}
