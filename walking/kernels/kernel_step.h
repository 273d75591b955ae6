#pragma once

#include <limits>
#include <utility>

#include "walking/kernels/kernel.h"

// The step of a batch, once for all instruction sets. A unit that is compiled for one of them
// brings its type Pack of that many numbers in a namespace without name, so that the linker cannot
// mistake code for one processor for that of another; for the same reason nothing here calls the
// library.

namespace tricontact::walking::kernels {

/// Fields of one pack of lanes.
template <class Pack>
struct PackFields {
    double* first;
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
    static PackSpotStep<Pack> advance(PackSpot<Pack>& spot, Pack increment, Pack bound,
                                      Pack /*approach*/, PackFields<Pack>) {
        const Pack trial = spot.u + increment;
        spot.u = clamp(trial, bound);
        const Pack slip = trial - spot.u;
        return {bound, slip, slip, bound, spot.u};
    }
};

/// Two springs under one bound: radial return. Eqs. B.4.7 to B.4.9.
template <class Pack>
struct PrismContact {
    static PackSpotStep<Pack> advance(PackSpot<Pack>& spot, Pack increment, Pack bound,
                                      Pack approach, PackFields<Pack> k) {
        const Pack x = spot.u + increment,
                   along = multiply_add(k[flank_reach], approach, spot.flank);
        const Pack length = square_root(multiply_add(x, x, along * along));
        // Where length and bound vanish, any factor below 1 will do.
        const Pack factor =
            bound / max(max(length, bound), Pack::all(std::numeric_limits<double>::min()));
        spot = {factor * x, factor * along};
        const Pack sqrt2 = Pack::all(1.4142135623730951);
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
    const Pack increment = multiply_add(k[rotation_reach], s.dp, s.dx);
    const Pack turned = k[lever] * s.dp;
    step.left = Contact::advance(s.left, increment, s.left_bound(k), s.dz + turned, k);
    step.right = Contact::advance(s.right, increment, s.right_bound(k), s.dz - turned, k);

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

/// Sums and extremes over the steps of a call.
template <class Pack>
struct PackSums {
    Pack force = Pack::all(0);
    Pack z_min = Pack::all(__builtin_inf()), z_max = Pack::all(-__builtin_inf());
    Pack p_min = Pack::all(__builtin_inf()), p_max = Pack::all(-__builtin_inf());
    Pack x_squared = Pack::all(0), z_squared = Pack::all(0), p_squared = Pack::all(0);
    SpotPackSums<Pack> left, right;

    void start(const PackState<Pack>& s, PackFields<Pack> k) {
        left.last_bound = s.left_bound(k), left.last_slip = k[slip_1];
        right.last_bound = s.right_bound(k), right.last_slip = k[slip_2];
    }
    void add(const PackState<Pack>& s, const PackStep<Pack>& step) {
        force = force + step.spring_force;
        z_min = min(z_min, s.z), z_max = max(z_max, s.z);
        p_min = min(p_min, s.p), p_max = max(p_max, s.p);
        left.add(step.left), right.add(step.right);
        x_squared = multiply_add(step.twice_dx, step.twice_dx, x_squared);
        z_squared = multiply_add(step.twice_dz, step.twice_dz, z_squared);
        p_squared = multiply_add(step.twice_dp, step.twice_dp, p_squared);
    }
    void store(PackFields<Pack> fields) const {
        fields.set(sum_force, force);
        fields.set(min_height, z_min), fields.set(max_height, z_max);
        fields.set(min_rotation, p_min), fields.set(max_rotation, p_max);
        fields.set(sum_x_squared, x_squared);
        fields.set(sum_height_squared, z_squared);
        fields.set(sum_rotation_squared, p_squared);
        left.store(fields, 0), right.store(fields, 1);
    }
};

/// Several packs of lanes step by step side by side: one waits for its results while others
/// compute.
template <class Contact, class Pack, int... i>
void advance_packs(double* fields, std::int64_t n_steps, std::integer_sequence<int, i...>) {
    constexpr int n = sizeof...(i);
    PackState<Pack> states[n];
    PackStep<Pack> last[n];
    PackSums<Pack> sums[n];
    const auto of = [&](int pack) -> PackFields<Pack> {
        return {fields + pack * Pack::size, n * Pack::size};
    };
    (states[i].load(of(i)), ...);
    (sums[i].start(states[i], of(i)), ...);
    for (std::int64_t step = 1; step < n_steps; ++step)
        (sums[i].add(states[i], advance<Contact>(states[i], of(i))), ...);
    ((last[i] = advance<Contact>(states[i], of(i))), ...);
    (sums[i].add(states[i], last[i]), ...);
    (states[i].store(of(i)), ...);
    (of(i).set(slip_1, last[i].left.slip), ...);
    (of(i).set(slip_2, last[i].right.slip), ...);
    (sums[i].store(of(i)), ...);
}

constexpr int n_packs = 3;

template <class Contact, class Pack>
__attribute__((flatten)) void advance_lanes(double* fields, std::int64_t n_steps) {
    advance_packs<Contact, Pack>(fields, n_steps, std::make_integer_sequence<int, n_packs>());
}

template <class Pack>
LaneFunctions lane_functions() {
    return {n_packs * Pack::size,
            {advance_lanes<FlatContact<Pack>, Pack>, advance_lanes<PrismContact<Pack>, Pack>}};
}

/// As many numbers as a register of the processor holds. `Instructions` are those of a unit, in a
/// namespace without name (kernel_step.h): functions of registers.
template <class Instructions>
struct Pack {
    using Register = typename Instructions::Register;
    static constexpr int size = sizeof(Register) / sizeof(double);

    Register v;

    static Pack load(const double* from) { return {*reinterpret_cast<const Register*>(from)}; }
    static Pack all(double value) { return {value + Register{}}; }
    void store(double* to) const { *reinterpret_cast<Register*>(to) = v; }

    Pack operator+(Pack b) const { return {v + b.v}; }
    Pack operator-(Pack b) const { return {v - b.v}; }
    Pack operator*(Pack b) const { return {v * b.v}; }
    Pack operator/(Pack b) const { return {v / b.v}; }
    friend Pack multiply_add(Pack a, Pack b, Pack c) {
        return {Instructions::fmadd(a.v, b.v, c.v)};
    }
    friend Pack multiply_subtract(Pack a, Pack b, Pack c) {
        return {Instructions::fmsub(a.v, b.v, c.v)};
    }
    friend Pack negative_multiply_add(Pack a, Pack b, Pack c) {
        return {Instructions::fnmadd(a.v, b.v, c.v)};
    }
    friend Pack min(Pack a, Pack b) { return {Instructions::min(a.v, b.v)}; }
    friend Pack max(Pack a, Pack b) { return {Instructions::max(a.v, b.v)}; }
    friend Pack square_root(Pack a) { return {Instructions::sqrt(a.v)}; }
    /// Between -bound and bound: the smaller magnitude, with the sign of a.
    friend Pack clamp(Pack a, Pack bound) {
        if constexpr (requires { Instructions::clamp(a.v, bound.v); })
            return {Instructions::clamp(a.v, bound.v)};
        else
            return min(max(a, Pack{-bound.v}), bound);
    }
    friend Pack count_zero(Pack count, Pack a) { return {Instructions::count_zero(count.v, a.v)}; }
};

}  // namespace tricontact::walking::kernels
