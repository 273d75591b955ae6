#pragma once

#include <string>
#include <vector>

#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/deck_mesh.h"

namespace tricontact::benchmarks {

/// Part of the boundary of a block, as meshes for other codes name it.
struct NamedFaces {
    std::string name;  ///< "base", "side", "contact", "axis", "symmetry", "loaded"
    std::vector<ElementFace> faces;
};
/// Of a block's mesh, from its node sets.
std::vector<NamedFaces> named_faces(const DeckMesh& mesh);

/// Gmsh's format 4.1 (ASCII), its parts as physical groups, "body" the block itself.
std::string msh_text(const DeckMesh& mesh);

/// VTK's unstructured grid (ASCII), point data of 0 and 1 for each part of the boundary.
std::string vtu_text(const DeckMesh& mesh);

/// Meshes for any code: of the block alone or, where two bodies deform, of each of them; elements
/// "linear" or "quadratic".
DeckFamily mesh_family(const DeckModel& model, const DeckWishes& wishes);

}  // namespace tricontact::benchmarks
