#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/decks/deck.h"
#include "benchmarks/decks/deck_mesh.h"
#include "contact/bodies/indenter.h"

namespace tricontact::benchmarks {

/// A leg of the load path of a deck: from the state before, in equal increments.
struct DeckStep {
    bool is_force = false;             ///< `normal` is F_N, else d
    double normal = 0;                 ///< F_N [N], per mm of a plane deck [N/mm]; d [mm]
    bool is_tangential_force = false;  ///< `shift` is F_T
    double shift = 0;                  ///< U along x [mm]; F_T [N], [N/mm]
    int increments = 1;
};

/// Radius and thickness of the blocks of half-spaces, in a. A bonded base there raises the force at
/// a depth by 0.08 % (measured: Hertz' contact).
inline constexpr double half_space_block = 1000;

/// K is this over the depth times the peak pressure: p0/K = 0.46 % of the depth.
inline constexpr double stiffness_factor = 216;

/// What all decks of a case have in common, in mm, N and MPa.
struct DeckModel {
    enum class Shape { axisymmetric, plane, half };  ///< half: y >= 0 of a spatial contact
    Shape shape = Shape::axisymmetric;
    std::string name;   ///< of files and of the problem
    std::string title;  ///< of the case
    double a = 0;       ///< contact radius or half width [mm]
    double young = 0;   ///< [MPa]
    double poisson = 0;
    double mu = 0;                                      ///< 0: frictionless
    bool presses_frictionless = false;                  ///< friction acts from the second step on
    std::shared_ptr<const contact::Indenter> indenter;  ///< in m
    std::string gap;  ///< formula of the profile over r (x of plane decks), both in mm
    bool is_half_space = false;
    /// R of half a ball or cylinder in place of the block, its pole up [mm]; 0: a block. The
    /// indenter is then a plane, and `gap` that of both undeformed surfaces.
    double round_radius = 0;
    /// The base moves along itself, as a plane of symmetry does.
    bool has_sliding_base = false;
    /// An indenter that deforms on the block: half a ball, its flat face held by a rigid holder.
    struct Upper {
        double radius = 0, young = 0, poisson = 0;  ///< [mm], [MPa], [-]
    };
    std::optional<Upper> upper;
    /// Both bodies, in place of block and indenter, with their sets and surfaces: of so many
    /// elements in a on the coarsest level, the given level of refinement.
    std::function<DeckMesh(int n, int level, bool is_quadratic)> own_mesh;
    /// Of a pin in a hole: the hole's radius, about the origin [mm], along whose radii each point
    /// is pressed; `gap` is then a formula of the length of arc. 0: along the load.
    double conforming_radius = 0;
    bool has_depth = true;   ///< false: where the load acts has no depth that means anything
    std::string own_words;   ///< what those bodies are, for the README
    double loaded_area = 0;  ///< of the face SLOAD, which a force presses evenly [mm^2]; 0: none
    bool has_sharp_edge = false;  ///< infinite pressure at the edge of the contact
    double width = 0;             ///< radius or half width of the block [mm]
    double thickness = 0;         ///< of the block [mm]
    double contact_reach = 0;     ///< of the set of faces that may touch [mm]
    double indenter_reach = 0;    ///< of the meshed indenter [mm]
    double stiffness = 0;         ///< K of penalties [MPa/mm]
    double stick_slope = 0;       ///< K_T [MPa/mm]; 0 where frictionless
    double depth_scale = 0;       ///< d of the reference [mm], where the search of a depth begins
    double overlap = 0;  ///< by which a meshed indenter begins in the block under a force [mm]
    std::vector<DeckStep> steps;
    std::vector<std::string> remarks;  ///< what the deck does that the case does not

    /// Whether a leg prescribes a force, so that the depth has to be found.
    bool has_force() const;
    bool has_tangential_force() const;
    /// Whether the sides are not alike: the whole width is meshed.
    bool is_shifted() const;
    /// Height of the undeformed indenter over its lowest point [mm].
    double height(double x, double y) const;
    /// Share of the whole contact's forces that a deck's model carries.
    double share() const {
        return shape == Shape::half || (shape == Shape::plane && !is_shifted()) ? .5 : 1;
    }
    /// x of the contact's edge in the lattice of the mesh [mm].
    double lattice_edge() const;
    /// x of the last nodes there that may touch, and a little more [mm].
    double lattice_reach() const { return contact_reach / a * lattice_edge() * (1 + 1e-9); }
    const DeckStep& last() const { return steps.back(); }
};

/// Throws contact::InputError where no deck can have what the case has.
DeckModel make_deck_model(const Reference& reference, const DeckWishes& wishes);

/// The face of a flat rigid body.
std::shared_ptr<const contact::Indenter> flat_face();

/// Lines of the coarsest block: x from 0 (to both sides where the model has no plane of symmetry
/// there), y of half models, depth from 0 down.
struct DeckLines {
    std::vector<double> x, y, depth;
};
/// `n` elements in a on the coarsest level, the given level of refinement.
DeckLines deck_lines(const DeckModel& model, int n, int level);
/// Of half a ball or cylinder x is the length of arc from its pole, and a place x, z of the lattice
/// lies where this says: columns run from the arc to the flat face.
std::array<double, 2> placed_round(double radius, double x, double z);
/// Heights of those lines, z out of the body, from the base up.
std::vector<double> heights_of(const DeckLines& lines);

}  // namespace tricontact::benchmarks
