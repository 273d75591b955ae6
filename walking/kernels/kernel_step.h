#pragma once

#include <limits>

#include "walking/kernels/kernel_fields.h"

// The step of a batch, once for all instruction sets. A unit that is compiled for one of them
// brings its type Pack of that many numbers in a namespace without name, so that the linker cannot
// mistake code for one processor for that of another; for the same reason nothing here calls the
// library.

namespace tricontact::walking::kernels {

/// Fields of one pack of lanes.
template <class Pack>
struct PackFields {
    using Number = typename Pack::Number;
    Number* first;
    int stride;

    Pack operator[](int field) const { return Pack::load(first + field * stride); }
    void set(int field, Pack value) const { value.store(first + field * stride); }
};

/// Tangential springs of a spot.
template <class Pack>
struct PackSpot {
    Pack u, flank;
};

/// State of one pack of lanes, in registers as far as they last.
template <class Pack>
struct PackState {
    Pack p, dp, z, dz, y, dx;
    PackSpot<Pack> left, right;

    void load(PackFields<Pack> fields) {
        p = fields[rotation], dp = fields[rotation_increment];
        z = fields[height], dz = fields[height_increment];
        y = fields[extension], dx = fields[x_increment];
        left = {fields[deflection_1], fields[flank_1]};
        right = {fields[deflection_2], fields[flank_2]};
    }
    void store(PackFields<Pack> fields) const {
        fields.set(rotation, p), fields.set(rotation_increment, dp);
        fields.set(height, z), fields.set(height_increment, dz);
        fields.set(extension, y), fields.set(x_increment, dx);
        fields.set(deflection_1, left.u), fields.set(flank_1, left.flank);
        fields.set(deflection_2, right.u), fields.set(flank_2, right.flank);
    }
    Pack left_bound(PackFields<Pack> k) const {
        return max(multiply_add(k[lever], p, z), Pack::all(0));
    }
    Pack right_bound(PackFields<Pack> k) const {
        return max(negative_multiply_add(k[lever], p, z), Pack::all(0));
    }
};

/// What a spot did in a step.
template <class Pack>
struct PackSpotStep {
    Pack bound;
    Pack slip;                // along the motion
    Pack slid;                // 0 where it sticks
    Pack normal, tangential;  // forces; the normal one times mu
};

/// Spring between -bound and bound. Wetter (2016), eqs. B.4.3 and B.4.4.
template <class Pack>
struct FlatContact {
    Pack increment;

    FlatContact(const PackState<Pack>& s, PackFields<Pack> k)
        : increment(multiply_add(k[rotation_reach], s.dp, s.dx)) {}

    PackSpotStep<Pack> advance(PackSpot<Pack>& spot, Pack bound, Pack /*approach*/,
                               PackFields<Pack>) const {
        const Pack trial = spot.u + increment;
        spot.u = clamp(trial, bound);
        const Pack slip = trial - spot.u;
        return {bound, slip, slip, bound, spot.u};
    }
};

/// Two springs under one bound: radial return. Eqs. B.4.7 to B.4.9.
template <class Pack>
struct PrismContact {
    Pack increment;

    PrismContact(const PackState<Pack>& s, PackFields<Pack> k)
        : increment(multiply_add(k[rotation_reach], s.dp, s.dx)) {}

    PackSpotStep<Pack> advance(PackSpot<Pack>& spot, Pack bound, Pack approach,
                               PackFields<Pack> k) const {
        const Pack x = spot.u + increment,
                   along = multiply_add(k[flank_reach], approach, spot.flank);
        const Pack length = square_root(multiply_add(x, x, along * along));
        // Where length and bound vanish, any factor below 1 will do.
        const Pack factor =
            bound /
            max(max(length, bound), Pack::all(std::numeric_limits<typename Pack::Number>::min()));
        spot = {factor * x, factor * along};
        const Pack sqrt2 = Pack::all(static_cast<typename Pack::Number>(1.4142135623730951));
        return {bound, x - spot.u, Pack::all(1) - factor,
                multiply_add(k[flank_force], spot.flank, sqrt2 * bound), spot.u + spot.u};
    }
};

/// What a pack of lanes did in a step.
template <class Pack>
struct PackStep {
    PackSpotStep<Pack> left, right;
    Pack spring_force;
    Pack twice_dx, twice_dz, twice_dp;  // increments before and after: 2 dt times the velocities
};

/// Velocity Verlet on increments: positions, contact, forces, increments of the next step. Wetter
/// (2016), eqs. 4.1.17 to 4.1.19, sums and differences of the spots' forces taken once.
template <class Contact, class Pack>
PackStep<Pack> advance(PackState<Pack>& s, PackFields<Pack> k) {
    PackStep<Pack> step;
    s.p = s.p + s.dp;
    s.z = s.z + s.dz;
    s.y = negative_multiply_add(k[spring], s.dx, s.y + k[base_increment]);
    const Contact contact(s, k);
    const Pack turned = k[lever] * s.dp;
    step.left = contact.advance(s.left, s.left_bound(k), s.dz + turned, k);
    step.right = contact.advance(s.right, s.right_bound(k), s.dz - turned, k);

    const Pack force = multiply_add(k[spring_lever], s.p, s.y);
    const Pack normal = step.left.normal + step.right.normal;
    const Pack friction = step.left.tangential + step.right.tangential;
    const Pack dx = multiply_add(k[pull], force - friction, s.dx);
    const Pack dz = negative_multiply_add(k[lift], normal, s.dz + k[weight]);
    const Pack upright = multiply_subtract(k[normal_moment], step.right.normal - step.left.normal,
                                           multiply_add(k[spring_height], force, friction));
    const Pack tilted = multiply_subtract(k[tilted_moment], normal,
                                          (step.left.tangential - step.right.tangential) + force);
    const Pack dp = multiply_add(k[turn], multiply_add(s.p, tilted, upright), s.dp);
    step.spring_force = force;
    step.twice_dx = s.dx + dx, step.twice_dz = s.dz + dz, step.twice_dp = s.dp + dp;
    s.dx = dx, s.dz = dz, s.dp = dp;
    return step;
}

}  // namespace tricontact::walking::kernels
