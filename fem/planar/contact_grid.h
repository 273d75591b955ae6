#pragma once

#include <vector>

#include "fem/planar/body.h"

// Contact pressures live on points of their own. Where the nodes of both bodies meet, the points
// are these nodes, and a pressure's force on a node is it times the node's tributary area. Else
// pressures are piecewise linear between points (a mortar), and a body gets the forces that do the
// same work on its surface:
//
//     f = M p,   M_ik = int phi_i^body psi_k dA,      gap_k = int psi_k gap dA / int psi_k dA
//
// so that a uniform pressure loads both bodies uniformly, whatever their nodes. Linear pressures on
// points no closer than the nodes of the coarser body are stable; forces of one body spread over
// the other's nodes are not (pressures are then off by more than a tenth on any mesh).

namespace tricontact::fem::planar {

struct ContactGrid {
    std::vector<double> along;  ///< coordinate of each point [m]
    std::vector<double> area;   ///< int psi_k dA, of plane strain per length along y [m]
    /// Of M.
    struct Entry {
        int node, point;
        double value;  ///< [m^2], of plane strain per length along y [m]
    };
    std::vector<std::vector<Entry>> transfer;  ///< per body; entries of one place are summed up

    std::size_t size() const { return along.size(); }
};

/// Whether all bodies have the same nodes there, but for 1e-6 of their distance.
bool nodes_meet(const std::vector<CondensedSection>& bodies);

/// Points on the nodes of the first body, where all have some: those on the axis of a body of
/// revolution have no area and are left out. Tributary areas are row sums of the surface mass.
ContactGrid points_on_nodes(const std::vector<CondensedSection>& bodies);

/// A mortar on the nodes of that body whose nodes are the farthest apart, over what all bodies
/// share.
ContactGrid mortar(const std::vector<CondensedSection>& bodies);

/// Points on the elements in plane strain of bodies whose nodes meet: pressures are constant on
/// each of them, and displacements their means. The compliance of bodies that are the same anywhere
/// along their surface then depends on the distance of points alone.
ContactGrid elements_of(const std::vector<CondensedSection>& bodies);

/// Rings about the axis, for a tension over the gap: linear functions between the nodes of a body
/// of revolution, that of the first ring 1 up to the axis. They are all as wide; the weights of
/// nodes alternate from 1 to 2, which holds the front of a tension.
ContactGrid rings_on_nodes(const std::vector<CondensedSection>& bodies);

/// The grid for these bodies: `points_on_nodes` where they meet.
ContactGrid grid_between(const std::vector<CondensedSection>& bodies);

}  // namespace tricontact::fem::planar
