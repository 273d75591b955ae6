#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fem/condensation.h"
#include "fem/discretisation.h"

namespace tricontact::fem {

/// Displacements of a body that do not couple with its others: all of them or, where a plane
/// x = const mirrors the body, the even ones (u_y and u_z are the same on both sides, u_x changes
/// sign) or the odd ones. They are u = P a, a being displacements of one half, and forces f on the
/// body cause those of K a = share P^T f, K being the stiffness of that half.
struct BodyPart {
    std::vector<int> unknown;       ///< entry of a behind each of the body's unknowns; -1: held
    std::vector<std::int8_t> sign;  ///< with which it stands in u
    double share = 1;               ///< 1/2 where the stiffness is that of a half
    /// share P^T times AssembledStiffness::held_rows of the body [N/m]; empty: zero.
    std::array<std::vector<double>, 3> held_rows;
    Condensation condensation;

    /// What this part adds to the body's displacements [m] under `forces` [N] on its unknowns.
    void add_displacement(std::span<const double> forces, std::vector<double>& to) const;
};

/// Contact unknowns last, for their compliance; or all in whatever order is cheapest, with none of
/// the factors' contact unknowns told apart.
enum class Elimination : std::uint8_t { contact_last, cheapest };

/// The parts that make up all of a body's displacements, analysed but not factorised; the even (0)
/// or the odd part (1) alone, none if there are no such. Throws std::bad_alloc.
std::vector<BodyPart> parts_of(const Discretisation& body, Elimination elimination,
                               std::optional<int> half = {});

}  // namespace tricontact::fem
