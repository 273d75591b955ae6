#pragma once

#include "benchmarks/decks/deck.h"

namespace tricontact::benchmarks {

/// Two blocks of 1000 mm x 500 mm, one on the other, with meshes that do not match, compressed by a
/// strain of 0.1; E = 1 MPa, nu = 0: p = 0.1 MPa everywhere. Taylor and Papadopoulos (1991).
std::vector<DeckFile> patch_test_deck(const DeckWishes& wishes);

/// A block that is pushed up a slope: F/G = (tan(alpha) + mu)/(1 - mu tan(alpha)). NAFEMS CGS-4.
std::vector<DeckFile> wedge_deck(const DeckWishes& wishes);

/// A rigid flat punch on a half-space. Boussinesq (1885).
std::vector<DeckFile> complete_punch_deck(const DeckWishes& wishes);

/// A rigid punch with rounded edges on a half-space, plane strain. Ciavarella, Hills and Monno
/// (1998).
std::vector<DeckFile> rounded_punch_plane_deck(const DeckWishes& wishes);

/// An elastic pin in the hole of a plate. Persson (1964).
std::vector<DeckFile> pin_in_hole_deck(const DeckWishes& wishes);

/// A loose strip on a thick block under a line load. Keer, Dundurs and Tsai (1972).
std::vector<DeckFile> receding_layer_deck(const DeckWishes& wishes);

/// A block with sharp edges on a thick block. Dundurs and Lee (1972).
std::vector<DeckFile> complete_punch_two_bodies_deck(const DeckWishes& wishes);

/// NAFEMS' contact benchmarks 1 and 2: a roller on a block, a punch with a rounded edge on a
/// cylinder. Konter (2006).
std::vector<DeckFile> nafems_roller_deck(const DeckWishes& wishes);
std::vector<DeckFile> nafems_punch_deck(const DeckWishes& wishes);

}  // namespace tricontact::benchmarks
