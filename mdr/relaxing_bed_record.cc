// What a relaxing bed says about its state: audit, scales, surface.

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "contact/base/state_bytes.h"
#include "mdr/line_surface.h"
#include "mdr/relaxing_bed.h"

namespace tricontact::mdr {

using contact::ContactState;
using contact::LoadStep;

namespace {

/// What the springs' work misses to be stored or dissipated in them, over the magnitudes of all
/// that is added up: each of the sums is right to contact::sum_rounding of its own.
double imbalance(const SpringMemory::Sums& sums, double stored_before) {
    const double used = sums.stored - stored_before + sums.dissipated;
    const double turned_over = sums.turnover + sums.stored + stored_before + sums.dissipated;
    return turned_over == 0 ? 0 : std::abs(sums.work - used) / turned_over;
}

}  // namespace

void RelaxingBed::audit_step(const LoadStep& step, const SlipSums& sums) {
    audit_.record("spring_law",
                  std::max(pressing_.law_error / depth_, shearing_.law_error / largest_bound_),
                  rounding);
    audit_forces(step, sums, largest_bound_, friction_ && n_contact_ > 0);
    // The work on the springs is stored or dissipated in them; slip is the rest of the shift, and
    // friction takes the rest of its work.
    audit_.record("energy_balance",
                  contact::larger(imbalance(pressing_, stored_in_pressing_),
                                  imbalance(shearing_, stored_in_shearing_)),
                  rounding);
    stored_in_pressing_ = pressing_.stored;
    stored_in_shearing_ = shearing_.stored;
}

template <class Archive, class Self>
void RelaxingBed::transfer_all(Archive& archive, Self& bed) {
    transfer(archive, bed);
    SpringMemory::transfer(archive, bed.normal_);
    SpringMemory::transfer(archive, bed.tangential_);
    archive(bed.row_, bed.touched_, bed.position_, bed.depth_, bed.heights_, bed.contact_,
            bed.n_contact_, bed.pressed_, bed.offsets_, bed.bounds_, bed.sheared_, bed.line_bounds_,
            bed.largest_bound_, bed.carried_, bed.force_, bed.shear_before_, bed.pressing_,
            bed.shearing_, bed.stored_in_pressing_, bed.stored_in_shearing_, bed.friction_,
            bed.least_load_);
}

std::string RelaxingBed::write_state() const {
    contact::StateWriter out;
    transfer_all(out, *this);
    return out.take();
}

void RelaxingBed::read_state(std::string_view bytes) {
    contact::StateReader in(bytes);
    transfer_all(in, *this);
}

contact::Scales RelaxingBed::scales() const {
    std::vector<double> load(size());
    for (int i = 0; i < size(); ++i)
        load[i] = effective_modulus_ * normal_.stiffness() * pressed_[i];
    const EvenLoad even = even_load(row_, load, position_, size());
    const double at_centre = row_.interpolate(load, position_);
    const double ratio = load_bound_ ? row_.interpolate(line_bounds_, position_) / at_centre *
                                           effective_modulus_ / effective_shear_modulus_
                                     : bound_ratio_;
    return {.normal_force = normal_force_,
            .contact_radius = even.half_width(),
            .indentation = depth_,
            .peak_pressure = even.centre_pressure(),
            .unit_shift = ratio * depth_,
            .sliding_force = friction_limit()};
}

contact::Surface RelaxingBed::surface() const {
    const double stiffness = normal_.stiffness();
    std::vector<double> normal, tangential;
    for (int i = 0; i < size(); ++i) {
        normal.push_back(effective_modulus_ * stiffness * pressed_[i]);
        tangential.push_back(effective_shear_modulus_ * stiffness * sheared_[i]);
    }
    return make_line_surface(
        row_, size(), position_, *law_, even_loads(row_, normal, tangential, position_),
        [&](int i, int k, contact::Surface& s) {
            const double x = std::abs(row_.position(i) - position_);
            const double u_z = normal_.deflection()[i];
            const double gap = profile_->value(std::min(x, profile_->range())) + u_z - depth_;
            const ContactState state = s.contact_state[k] = contact_state(i);
            s.displacement_x[k] = tangential_.deflection()[i];
            s.displacement_z[k] = u_z;
            s.gap[k] = state == ContactState::open ? std::max(gap, 0.) : 0.;
            s.slip_x[k] = state == ContactState::slip ? slip(i) : 0.;
            s.normal_line_load[k] = normal[i];
            s.tangential_line_load[k] = tangential[i];
        });
}

}  // namespace tricontact::mdr
