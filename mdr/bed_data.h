#pragma once

#include <memory>
#include <optional>
#include <string>

#include "contact/case.h"
#include "contact/load_path.h"
#include "contact/substrates/relaxation.h"
#include "mdr/plane_profile.h"

namespace tricontact::mdr {

/// What a spring bed is made of.
struct BedData {
    std::unique_ptr<PlaneProfile> profile;
    double effective_modulus = 0;        ///< E* [Pa], of a relaxing bed when relaxed
    double effective_shear_modulus = 0;  ///< G* [Pa], likewise
    double friction_coefficient = 0;     ///< mu [-], > 0
    int n_springs = 0;                   ///< over the whole bed
    double half_length = 0;              ///< of the bed about the starting position [m]
    double rolling_angle = 0;            ///< of the line on which it rolls [rad]
    std::optional<contact::Relaxation> relaxation{};  ///< empty: elastic
};

/// The same data. Throws contact::InputError for values out of range.
const BedData& checked(const BedData& data);

/// Throws contact::InputError unless the control is positive and finite.
void check_positive(const contact::NormalControl& control);

/// Throws contact::InputError if a force-controlled F_T reaches `limit` = mu F_N [N].
void check_carried(const contact::TangentialControl& control, double limit);

}  // namespace tricontact::mdr
