#pragma once

#include <string>

#include "benchmarks/decks/deck_mesh.h"

namespace tricontact::benchmarks {

/// Appends nodes, elements (EBODY, EIND), node sets and surfaces as keywords of Abaqus.
void write_inp_mesh(std::string& text, const DeckMesh& mesh, const std::string& element);

}  // namespace tricontact::benchmarks
