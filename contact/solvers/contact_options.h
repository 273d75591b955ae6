#pragma once

namespace tricontact::contact {

/// How the contact is treated by models that can.
struct ContactOptions {
    bool coupling = true;  ///< of normal and tangential contact
};

}  // namespace tricontact::contact
