#pragma once

#include <optional>

#include "contact/base/vector2.h"

namespace tricontact::contact {

struct StepRecord;

/// Of machine and holder, in series with the contact: prescribed shifts and depths are those of the
/// drive, the contact feels what is left, U = U_drive - F_T/k_t and d = d_drive - F_N/k_n. Empty:
/// rigid. Kept with a case (contact::Case::of()).
struct RigStiffness {
    std::optional<double> tangential;  ///< k_t, along x and along y [N/m]
    std::optional<double> normal;      ///< k_n [N/m]

    bool yields() const { return tangential || normal; }
    double tangential_compliance() const { return tangential ? 1 / *tangential : 0; }  ///< [m/N]
    double normal_compliance() const { return normal ? 1 / *normal : 0; }              ///< [m/N]

    /// Of the drive that holds a contact in this state [m].
    Vector2 drive_shift(const StepRecord& step) const;
    double drive_depth(const StepRecord& step) const;
};

}  // namespace tricontact::contact
