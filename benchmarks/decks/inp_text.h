#pragma once

#include <string>

#include "benchmarks/decks/deck_mesh.h"

namespace tricontact::benchmarks {

/// Appends nodes, elements (EBODY, EIND), node sets and surfaces as keywords of Abaqus.
void write_inp_mesh(std::string& text, const DeckMesh& mesh, const std::string& element);

/// How bodies touch, in the words of both dialects.
struct InpInteraction {
    double stiffness = 0;     ///< K [MPa/mm]
    double mu = 0;            ///< 0: frictionless
    double stick_slope = 0;   ///< K_T [MPa/mm], CalculiX
    double elastic_slip = 0;  ///< largest one [mm], Abaqus
};
/// The friction of an interaction.
void write_inp_friction(std::string& text, const InpInteraction& interaction, bool is_abaqus);
/// Interaction and the contact pair SLAYER, SIND, from face to face.
void write_inp_contact(std::string& text, const InpInteraction& interaction, bool is_abaqus);

/// What is written at the end of a step: forces on these sets, fields; displacements of `moved`, if
/// it is no empty name.
void write_inp_output(std::string& text, const std::vector<std::string>& force_sets,
                      const std::string& moved, bool is_abaqus);

}  // namespace tricontact::benchmarks
