#pragma once

#include <vector>

#include "benchmarks/decks/deck_mesh.h"
#include "benchmarks/decks/deck_model.h"

namespace tricontact::benchmarks {

/// Faces of a row of elements between nodes `along`, as far as `reach` from the middle.
void add_face_row(DeckMesh& mesh, const char* name, const std::vector<double>& along, int first,
                  int face, double reach);

/// Adds a cylinder of that radius whose lowest point begins `overlap` below 0 [mm]: `arcs` along
/// its surface from the lowest point, whole or to one side, `depths` from there to the hub. Nodes
/// NIND of the hub, NDEPTH its lowest one, those of x = 0 to NAXIS.
void add_ring(DeckMesh& mesh, double radius, double overlap, const std::vector<double>& arcs,
              const std::vector<double>& depths);

/// The model's block, and a cylinder of model.upper around its hub, which moves without turning:
/// whole where a load acts along the surface.
void set_cylinder_on_block(DeckModel& model, double hub_radius);

}  // namespace tricontact::benchmarks
