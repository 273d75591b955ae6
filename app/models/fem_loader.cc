#include "app/models/fem_entries.h"
#include "app/models/module_loader.h"

namespace tricontact::app {

const FemEntries& fem_entries() {
    static auto* const entries = reinterpret_cast<FemEntriesFunction*>(
        module_symbol("finite elements", FEM_MODULE, fem_entries_symbol));
    return *entries();
}

}  // namespace tricontact::app
