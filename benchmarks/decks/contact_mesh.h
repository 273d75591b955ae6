#pragma once

#include "benchmarks/decks/deck_mesh.h"
#include "benchmarks/decks/deck_model.h"

namespace tricontact::benchmarks {

/// Mesh of the block, its surface at height 0, with node sets NBASE, NSIDE (outer sides), NTOP (the
/// surface), NCONTACT (its part that may touch), NAXIS (x = 0 of axisymmetric and symmetric plane
/// models), NSYM (y = 0 of half models), and the surface SLAYER (faces of NCONTACT).
DeckMesh block_mesh(const DeckModel& model, int n, int level, bool is_quadratic);

/// Adds the indenter, one element thick, its lower surface on the profile: nodes NIND, surface
/// SIND.
void add_indenter(DeckMesh& mesh, const DeckModel& model, int n, int level);

/// Adds model.upper in its place: nodes NIND of its flat face, those on its axis to NAXIS, surface
/// SIND of what may touch.
void add_upper_body(DeckMesh& mesh, const DeckModel& model, int n, int level);

/// Both bodies: the deck's own, or the block with what presses it.
DeckMesh bodies_of(const DeckModel& model, int n, int level, bool is_quadratic);

}  // namespace tricontact::benchmarks
