#pragma once

#include <memory>
#include <string>

#include "contact/model.h"
#include "contact/model_makers.h"
#include "contact/models/model_kind.h"
#include "fem/cell_response.h"
#include "meshes/layer_mesh.h"
#include "runs/options.h"

namespace tricontact::app {

using contact::Case;
using contact::Say;
using runs::CommandOptions;

struct CondenseOptions : CommandOptions {
    bool distributed = false;  ///< by MPI, also when mpirun did not start this process
};

struct CacheOptions : CommandOptions {
    std::string folder;  ///< as fem.cache; empty: that of the user
    bool clear = false;
};

struct MeshEntries;
using LoadMeshEntries = const MeshEntries&();

/// What the finite element module offers to the program, which loads it when it is first needed.
struct FemEntries {
    std::unique_ptr<contact::Model> (*make_model)(const Case& c, int n_threads, const Say& say);
    /// Of the section of a case, as the kind of the model says; and the size of its elements [m].
    std::unique_ptr<contact::Model> (*make_section_model)(const contact::ModelKind& kind,
                                                          const Case& c, const Say& say);
    double (*section_size)(const contact::ModelKind& kind, const Case& c);
    /// What a cell of the surface of the case's bodies displaces, for a contact that rolls on:
    /// within this half width [m], at least of the contact. Throws InputError, NotConverged.
    fem::CellResponse (*cell_response)(const contact::ModelKind& kind, const Case& c,
                                       double half_width, const Say& say);
    meshes::LayerMeshSpec (*mesh_spec)(const Case& c, const Say& say);
    /// Writes the mesh of the case's finite element layer (.msh, .vtu, and .geo if it is ours) and
    /// gives its quality. Throws InputError, NotConverged.
    runs::Answer (*write_mesh)(CommandOptions options);
    /// Condenses the case's finite element layer into the cache, from which other commands take it;
    /// by all processes that mpirun started, together. Throws InputError, NotConverged.
    void (*condense)(const CondenseOptions& options);
    /// The condensed layers that are kept and the room that they take; or removes them. Throws
    /// InputError.
    runs::Answer (*list_or_clear_cache)(const CacheOptions& options);
    /// Whether this is a further process of those that condense together: the first one prints
    /// errors.
    bool (*is_further_process)();
    /// Of mesh_entries.h, called when a mesh first needs them.
    void (*load_mesh_entries_by)(LoadMeshEntries* load);
};

/// The only symbols of both modules.
inline constexpr const char* fem_entries_symbol = "tricontact_fem_entries";
using FemEntriesFunction = const FemEntries*();
inline constexpr const char* mesh_entries_symbol = "tricontact_mesh_entries";
using MeshEntriesFunction = const MeshEntries*();

/// Loads the module if need be. Throws std::runtime_error when it is not beside the program.
const FemEntries& fem_entries();

}  // namespace tricontact::app
