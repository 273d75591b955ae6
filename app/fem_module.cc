#include "app/fem_entries.h"
#include "fem/distributed/layer.h"
#include "fem/model.h"

extern "C" const tricontact::app::FemEntries* tricontact_fem_entries() {
    using namespace tricontact;
    static const app::FemEntries entries = {
        [](const contact::Case& c, const app::Say& say) { return fem::make_model(c, say); },
        [](const contact::Case& c, const app::Say& say) { return fem::mesh_spec(c, say); },
        app::write_mesh_of,
        app::condense_layer,
        app::list_or_clear_cache,
        fem::distributed::is_further_rank,
    };
    return &entries;
}
