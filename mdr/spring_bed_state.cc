// The state of a spring bed: what it stores, and its bytes.

#include "contact/base/compensated_sum.h"
#include "contact/base/state_bytes.h"
#include "mdr/spring_bed.h"

namespace tricontact::mdr {

template <class Archive, class Self>
void SpringBed::transfer_all(Archive& archive, Self& bed) {
    transfer(archive, bed);
    NormalBed::transfer(archive, bed.normal_);
    archive(bed.deflections_, bed.deflections_before_, bed.contact_before_, bed.bounds_,
            bed.largest_bound_, bed.largest_bound_before_, bed.total_bound_before_, bed.carried_,
            bed.is_fresh_, bed.depth_before_, bed.normal_force_before_, bed.normal_energy_,
            bed.least_bounds_, bed.least_contact_);
}

double SpringBed::shear_energy() const {
    contact::CompensatedSum squares;
    for (const double u : part(deflections_, normal_.contact())) squares.add(u * u);
    return effective_shear_modulus_ * normal_.spacing() * squares.value() / 2;
}

std::string SpringBed::write_state() const {
    contact::StateWriter out;
    transfer_all(out, *this);
    return out.take();
}

void SpringBed::read_state(std::string_view bytes) {
    contact::StateReader in(bytes);
    transfer_all(in, *this);
}

}  // namespace tricontact::mdr
