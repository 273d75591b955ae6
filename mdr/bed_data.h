#pragma once

#include <memory>
#include <optional>
#include <string>

#include "contact/case.h"
#include "contact/load_path.h"
#include "contact/substrates/relaxation.h"
#include "contact/vector2.h"
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

/// Throws contact::InputError if the step loads or shifts across the load (y): a line of springs
/// has one direction. `model`: named in the message.
void check_on_line(const std::string& model, const contact::LoadStep& step);

/// Signed path length [m] of a rolling offset on the line through the origin along the unit vector
/// `direction`. Throws contact::InputError for an offset off that line, by more than rounding on
/// the path length and `spacing` [m].
double line_coordinate(const std::string& model, const contact::Vector2& offset,
                       const contact::Vector2& direction, double spacing);

}  // namespace tricontact::mdr
