#pragma once

#include <utility>

#include "dynamics/kernel_fields.h"

// The step of a batch, once for all instruction sets. A unit that is compiled for one of them
// brings its type Pack of that many numbers in a namespace without name, so that the linker cannot
// mistake code for one processor for that of another; for the same reason nothing here calls the
// library.

#define TRICONTACT_INLINE __attribute__((always_inline)) inline

namespace tricontact::dynamics::kernels {

/// Fields of one pack of lanes.
template <class Pack>
struct PackFields {
    double* first;
    int stride;

    TRICONTACT_INLINE Pack operator[](Field field) const {
        return Pack::load(first + field * stride);
    }
    TRICONTACT_INLINE void set(Field field, Pack value) const {
        value.store(first + field * stride);
    }
};

/// State of one pack of lanes, in registers as far as they last.
template <class Pack>
struct PackState {
    Pack p, dp, z, dz, y, dx, u1, u2;
    Pack flank1, flank2;  // of the prism

    TRICONTACT_INLINE void load(PackFields<Pack> fields) {
        p = fields[rotation], dp = fields[rotation_increment];
        z = fields[height], dz = fields[height_increment];
        y = fields[extension], dx = fields[x_increment];
        u1 = fields[deflection_1], u2 = fields[deflection_2];
        flank1 = fields[flank_1], flank2 = fields[flank_2];
    }
    TRICONTACT_INLINE void store(PackFields<Pack> fields) const {
        fields.set(rotation, p), fields.set(rotation_increment, dp);
        fields.set(height, z), fields.set(height_increment, dz);
        fields.set(extension, y), fields.set(x_increment, dx);
        fields.set(deflection_1, u1), fields.set(deflection_2, u2);
        fields.set(flank_1, flank1), fields.set(flank_2, flank2);
    }
};

/// What the contact and the spring did in a step. Normal forces times mu.
template <class Pack>
struct PackStep {
    Pack bound1, bound2;
    Pack slip1, slip2;
    Pack normal1, normal2, tangential1, tangential2;
    Pack spring_force;
};

/// Two springs at the base: clamped between -bound and bound. Wetter (2016), eqs. B.4.1 to B.4.4.
template <class Pack>
TRICONTACT_INLINE void contact(PackState<Pack>& s, PackFields<Pack> k, PackStep<Pack>& step,
                               std::false_type /*prism*/) {
    const Pack increment = multiply_add(k[rotation_reach], s.dp, s.dx);
    const Pack trial1 = s.u1 + increment, trial2 = s.u2 + increment;
    s.u1 = clamp(trial1, step.bound1), s.u2 = clamp(trial2, step.bound2);
    step.slip1 = trial1 - s.u1, step.slip2 = trial2 - s.u2;
    step.normal1 = step.bound1, step.normal2 = step.bound2;
    step.tangential1 = s.u1, step.tangential2 = s.u2;
}

/// Radial return; the slip along the motion is what counts as slip. Eqs. B.4.5 to B.4.9.
template <class Pack>
TRICONTACT_INLINE void contact(PackState<Pack>& s, PackFields<Pack> k, PackStep<Pack>& step,
                               std::true_type /*prism*/) {
    const Pack increment = multiply_add(k[rotation_reach], s.dp, s.dx);
    const Pack turned = k[lever] * s.dp;
    const auto side = [&](Pack& u, Pack& flank, Pack approach, Pack bound, Pack& slip, Pack& normal,
                          Pack& tangential) {
        const Pack x = u + increment, along = multiply_add(k[flank_reach], approach, flank);
        const Pack length = square_root(multiply_add(x, x, along * along));
        // Where both vanish, any factor will do.
        const Pack factor = bound / max(max(length, bound), Pack::all(1e-300));
        u = factor * x, flank = factor * along;
        slip = x - u;
        normal = multiply_add(k[flank_force], flank, Pack::all(1.4142135623730951) * bound);
        tangential = u + u;
    };
    side(s.u1, s.flank1, s.dz + turned, step.bound1, step.slip1, step.normal1, step.tangential1);
    side(s.u2, s.flank2, s.dz - turned, step.bound2, step.slip2, step.normal2, step.tangential2);
}

/// Velocity Verlet on increments: positions, contact, forces, increments of the next step. Wetter
/// (2016), eqs. 4.1.17 to 4.1.19, sums and differences of the spots' forces taken once.
template <class Prism, class Pack>
TRICONTACT_INLINE PackStep<Pack> advance(PackState<Pack>& s, PackFields<Pack> k) {
    PackStep<Pack> step;
    s.p = s.p + s.dp;
    s.z = s.z + s.dz;
    s.y = negative_multiply_add(k[spring], s.dx, s.y + k[base_increment]);
    step.bound1 = max(multiply_add(k[lever], s.p, s.z), Pack::all(0));
    step.bound2 = max(negative_multiply_add(k[lever], s.p, s.z), Pack::all(0));
    contact(s, k, step, Prism{});

    const Pack force = multiply_add(k[spring_lever], s.p, s.y);
    const Pack normal = step.normal1 + step.normal2;
    const Pack friction = step.tangential1 + step.tangential2;
    s.dx = multiply_add(k[pull], force - friction, s.dx);
    s.dz = negative_multiply_add(k[lift], normal, s.dz + k[weight]);
    const Pack upright = multiply_subtract(k[normal_moment], step.normal2 - step.normal1,
                                           multiply_add(k[spring_height], force, friction));
    const Pack tilted =
        multiply_subtract(k[tilted_moment], normal, (step.tangential1 - step.tangential2) + force);
    s.dp = multiply_add(k[turn], multiply_add(s.p, tilted, upright), s.dp);
    step.spring_force = force;
    return step;
}

template <class Pack>
struct PackMotionSums {
    Pack force = Pack::all(0);
    Pack z_min = Pack::all(__builtin_inf()), z_max = Pack::all(-__builtin_inf());
    Pack p_min = Pack::all(__builtin_inf()), p_max = Pack::all(-__builtin_inf());

    TRICONTACT_INLINE void add(const PackState<Pack>& s, const PackStep<Pack>& step) {
        force = force + step.spring_force;
        z_min = min(z_min, s.z), z_max = max(z_max, s.z);
        p_min = min(p_min, s.p), p_max = max(p_max, s.p);
    }
    TRICONTACT_INLINE void store(PackFields<Pack> fields) const {
        fields.set(sum_force, force);
        fields.set(min_height, z_min), fields.set(max_height, z_max);
        fields.set(min_rotation, p_min), fields.set(max_rotation, p_max);
    }
};

template <class Pack>
struct PackSpotSums {
    Pack sticking = Pack::all(0), slip = Pack::all(0), slip_squared = Pack::all(0);
    Pack bound = Pack::all(0), bound_squared = Pack::all(0), bound_slip = Pack::all(0);
    Pack last_bound = Pack::all(0), last_slip = Pack::all(0);

    TRICONTACT_INLINE void add(Pack new_bound, Pack new_slip) {
        // Central difference about the state before the step, and the deflection there.
        const Pack both = last_slip + new_slip;
        sticking = count_zero(sticking, new_slip);
        slip = slip + both;
        slip_squared = multiply_add(both, both, slip_squared);
        bound = bound + last_bound;
        bound_squared = multiply_add(last_bound, last_bound, bound_squared);
        bound_slip = multiply_add(last_bound, both, bound_slip);
        last_bound = new_bound, last_slip = new_slip;
    }
    TRICONTACT_INLINE void store(PackFields<Pack> fields, int spot) const {
        const auto set = [&](Field of_first, Pack value) {
            fields.set(static_cast<Field>(of_first + spot), value);
        };
        set(sum_sticking_1, sticking), set(sum_slip_1, slip);
        set(sum_slip_squared_1, slip_squared), set(sum_bound_1, bound);
        set(sum_bound_squared_1, bound_squared), set(sum_bound_slip_1, bound_slip);
    }
};

template <class Pack>
struct PackSums {
    PackMotionSums<Pack> motion;
    PackSpotSums<Pack> spot1, spot2;
    Pack x_squared = Pack::all(0), z_squared = Pack::all(0), p_squared = Pack::all(0);

    TRICONTACT_INLINE void add(const PackState<Pack>& s, const PackStep<Pack>& step) {
        motion.add(s, step);
        spot1.add(step.bound1, step.slip1), spot2.add(step.bound2, step.slip2);
        x_squared = multiply_add(s.dx, s.dx, x_squared);
        z_squared = multiply_add(s.dz, s.dz, z_squared);
        p_squared = multiply_add(s.dp, s.dp, p_squared);
    }
    TRICONTACT_INLINE void store(PackFields<Pack> fields) const {
        motion.store(fields);
        spot1.store(fields, 0), spot2.store(fields, 1);
        fields.set(sum_x_squared, x_squared);
        fields.set(sum_height_squared, z_squared);
        fields.set(sum_rotation_squared, p_squared);
    }
};

/// Lanes of several packs step by step side by side: one waits for its results while others
/// compute.
template <class Pack, int n_packs, class Prism>
struct Lanes {
    static constexpr int n_lanes = n_packs * Pack::size;

    TRICONTACT_INLINE static PackFields<Pack> of(double* fields, int pack) {
        return {fields + pack * Pack::size, n_lanes};
    }

    template <int... i>
    TRICONTACT_INLINE static void motion_of(double* fields, std::int64_t n_steps,
                                            std::integer_sequence<int, i...>) {
        PackState<Pack> states[n_packs];
        PackMotionSums<Pack> sums[n_packs];
        (states[i].load(of(fields, i)), ...);
        for (std::int64_t step = 1; step < n_steps; ++step)
            (sums[i].add(states[i], advance<Prism>(states[i], of(fields, i))), ...);
        PackStep<Pack> last[n_packs];
        ((last[i] = advance<Prism>(states[i], of(fields, i))), ...);
        (sums[i].add(states[i], last[i]), ...);
        (states[i].store(of(fields, i)), ...);
        (of(fields, i).set(slip_1, last[i].slip1), ...);
        (of(fields, i).set(slip_2, last[i].slip2), ...);
        (sums[i].store(of(fields, i)), ...);
    }
    template <int... i>
    TRICONTACT_INLINE static void everything_of(double* fields, std::int64_t n_steps,
                                                std::integer_sequence<int, i...>) {
        PackState<Pack> states[n_packs];
        PackSums<Pack> sums[n_packs];
        (states[i].load(of(fields, i)), ...);
        (start(sums[i], states[i], of(fields, i)), ...);
        for (std::int64_t step = 0; step < n_steps; ++step)
            (sums[i].add(states[i], advance<Prism>(states[i], of(fields, i))), ...);
        (states[i].store(of(fields, i)), ...);
        (of(fields, i).set(slip_1, sums[i].spot1.last_slip), ...);
        (of(fields, i).set(slip_2, sums[i].spot2.last_slip), ...);
        (sums[i].store(of(fields, i)), ...);
    }
    TRICONTACT_INLINE static void start(PackSums<Pack>& sums, const PackState<Pack>& s,
                                        PackFields<Pack> k) {
        sums.spot1.last_bound = max(multiply_add(k[lever], s.p, s.z), Pack::all(0));
        sums.spot2.last_bound = max(negative_multiply_add(k[lever], s.p, s.z), Pack::all(0));
        sums.spot1.last_slip = k[slip_1], sums.spot2.last_slip = k[slip_2];
    }

    static void motion(double* fields, std::int64_t n_steps) {
        motion_of(fields, n_steps, std::make_integer_sequence<int, n_packs>());
    }
    static void everything(double* fields, std::int64_t n_steps) {
        everything_of(fields, n_steps, std::make_integer_sequence<int, n_packs>());
    }
};

template <class Pack, int n_packs>
LaneFunctions lane_functions() {
    using Flat = Lanes<Pack, n_packs, std::false_type>;
    using Prism = Lanes<Pack, n_packs, std::true_type>;
    return {Flat::n_lanes, Flat::motion, Flat::everything, Prism::motion, Prism::everything};
}

}  // namespace tricontact::dynamics::kernels

#undef TRICONTACT_INLINE
