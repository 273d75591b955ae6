#pragma once

#include <array>

namespace tricontact::comparisons {

// Rigid shifts under load and rolling that two boundary element programs of different origin found
// alike, to 5 digits on the half-space and 0.1 % on the layer: the rig of the thesis' table 5.1.1
// (E = 5.2 MPa, nu = 1/2, R = 40 mm, F_N = 21.1 N, mu = 0.57) on 0.2 mm cells. Amplitudes w over
// the contact radius and shifts u over U_max, both of the substrate in question; f = F_T/(mu F_N).

/// Static and settled shift, rolling along the load and across it.
struct PeerShifts {
    double w, f, static_ratio, parallel, perpendicular;
};

/// On the half-space, without coupling.
inline constexpr std::array half_space_peer_shifts = {
    PeerShifts{.24, .24, .1671, .20149, .20930}, PeerShifts{.24, .56, .4208, .55940, .58237},
    PeerShifts{.51, .09, .0609, .09656, .10576}, PeerShifts{.51, .24, .1671, .30097, .32984}};

/// Settled shift on the layer of 8 mm, bonded to a rigid base, with coupling, pressed in one step
/// with friction.
struct LayerPeerShifts {
    double w, f, parallel, perpendicular;
};
inline constexpr std::array layer_peer_shifts = {LayerPeerShifts{.24, .24, .1990, .2085},
                                                 LayerPeerShifts{.24, .56, .5648, .5921},
                                                 LayerPeerShifts{.51, .24, .3162, .3507}};
inline constexpr double layer_peer_radius = 4.3638e-3;      ///< a [m] of that layer, exact
inline constexpr double layer_peer_unit_shift = .37912e-3;  ///< U_max [m] of that layer, exact

/// Static shift on that layer at f = 0.56 [m], pressed with friction in n steps.
struct LayerPeerPressing {
    int steps;
    double static_shift;
};
inline constexpr std::array layer_peer_pressings = {
    LayerPeerPressing{1, .15308e-3}, LayerPeerPressing{2, .15235e-3},
    LayerPeerPressing{5, .15174e-3}, LayerPeerPressing{20, .15155e-3},
    LayerPeerPressing{80, .15150e-3}};
inline constexpr double layer_peer_frictionless = .15061e-3;  ///< pressed without friction [m]
inline constexpr double layer_peer_uncoupled = .15108e-3;     ///< without coupling [m]

}  // namespace tricontact::comparisons
