#pragma once

#include <string>
#include <vector>

#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/deck_model.h"
#include "benchmarks/decks/script_text.h"

namespace tricontact::benchmarks {

/// One of the two bodies of a deck, its nodes counted from 0.
struct BodyMesh {
    std::vector<DeckMesh::Point> nodes;      ///< [mm]
    std::vector<std::vector<int>> elements;  ///< quadrilaterals, as DeckMesh has them
    std::vector<int> held, axis;             ///< nodes that do not move; that stay at x = 0
    std::vector<std::vector<int>> contact;   ///< edges that may touch, outwards from the middle
    std::vector<std::vector<int>> loaded;    ///< edges that a pressure loads
};
struct BodyPair {
    BodyMesh lower, upper;
};

/// Of so many elements in a on the coarsest level, the given level of refinement.
BodyPair body_pair(const DeckModel& model, int n, int level, bool is_quadratic);

/// Where pressures stand, linear between: ends of the lower body's edges that may touch, as the
/// length of arc or x from the middle [mm].
std::vector<double> pressure_points(const DeckModel& model, const BodyMesh& lower);

/// Corners as FreeFem++ reads a mesh: each quadrilateral two triangles; labels 1 held, 3 contact,
/// 4 axis, 5 loaded, 9 free.
std::string freefem_mesh(const BodyMesh& body);

/// Nodes, elements, sets, a line each, for a script of Python.
std::string plain_mesh(const BodyMesh& body);

/// What all scripts of two bodies are filled with, and `own`, what one of them is as well.
std::vector<TemplateValue> pair_values(const DeckModel& model, const BodyPair& pair,
                                       const DeckRun& run, const DeckFamily& family,
                                       const std::string& job, std::vector<TemplateValue> own);

/// What all scripts of two bodies refuse: friction, shifts, more than one step.
void check_pair_deck(const DeckModel& model, const char* code);

}  // namespace tricontact::benchmarks
