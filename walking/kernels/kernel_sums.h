#pragma once

#include "walking/kernels/kernel_step.h"

namespace tricontact::walking::kernels {

/// Sums and extremes up to max_rotation.
template <class Pack>
struct MotionSums {
    Pack force = Pack::all(0);
    Pack z_min = Pack::all(__builtin_inf()), z_max = Pack::all(-__builtin_inf());
    Pack p_min = Pack::all(__builtin_inf()), p_max = Pack::all(-__builtin_inf());

    void start(const PackState<Pack>&, PackFields<Pack>) {}
    void add(const PackState<Pack>& s, const PackStep<Pack>& step) {
        force = force + step.spring_force;
        z_min = min(z_min, s.z), z_max = max(z_max, s.z);
        p_min = min(p_min, s.p), p_max = max(p_max, s.p);
    }
    void store(PackFields<Pack> fields) const {
        fields.set(sum_force, force);
        fields.set(min_height, z_min), fields.set(max_height, z_max);
        fields.set(min_rotation, p_min), fields.set(max_rotation, p_max);
    }
};

/// Velocities by central differences are known a step later, hence what stands beside them is that
/// of the step before.
template <class Pack>
struct SpotPackSums {
    Pack sticking = Pack::all(0), slip = Pack::all(0), slip_squared = Pack::all(0);
    Pack bound = Pack::all(0), bound_squared = Pack::all(0), bound_slip = Pack::all(0);
    Pack last_bound, last_slip;

    void add(const PackSpotStep<Pack>& step) {
        const Pack both = last_slip + step.slip;
        sticking = count_zero(sticking, step.slid);
        slip = slip + both;
        slip_squared = multiply_add(both, both, slip_squared);
        bound = bound + last_bound;
        bound_squared = multiply_add(last_bound, last_bound, bound_squared);
        bound_slip = multiply_add(last_bound, both, bound_slip);
        last_bound = step.bound, last_slip = step.slip;
    }
    void store(PackFields<Pack> fields, int spot) const {
        fields.set(sum_sticking_1 + spot, sticking), fields.set(sum_slip_1 + spot, slip);
        fields.set(sum_slip_squared_1 + spot, slip_squared);
        fields.set(sum_bound_1 + spot, bound);
        fields.set(sum_bound_squared_1 + spot, bound_squared);
        fields.set(sum_bound_slip_1 + spot, bound_slip);
    }
};

/// All sums.
template <class Pack>
struct AllSums {
    MotionSums<Pack> motion;
    SpotPackSums<Pack> left, right;
    Pack x_squared = Pack::all(0), z_squared = Pack::all(0), p_squared = Pack::all(0);

    void start(const PackState<Pack>& s, PackFields<Pack> k) {
        left.last_bound = s.left_bound(k), left.last_slip = k[slip_1];
        right.last_bound = s.right_bound(k), right.last_slip = k[slip_2];
    }
    void add(const PackState<Pack>& s, const PackStep<Pack>& step) {
        motion.add(s, step);
        left.add(step.left), right.add(step.right);
        x_squared = multiply_add(step.twice_dx, step.twice_dx, x_squared);
        z_squared = multiply_add(step.twice_dz, step.twice_dz, z_squared);
        p_squared = multiply_add(step.twice_dp, step.twice_dp, p_squared);
    }
    void store(PackFields<Pack> fields) const {
        motion.store(fields);
        left.store(fields, 0), right.store(fields, 1);
        fields.set(sum_x_squared, x_squared);
        fields.set(sum_height_squared, z_squared);
        fields.set(sum_rotation_squared, p_squared);
    }
};

}  // namespace tricontact::walking::kernels
