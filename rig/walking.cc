#include "rig/walking.h"

#include "rig/walking_parts.h"

namespace tricontact::rig {

RigReport check_rig(const contact::WalkingRig& rig) {
    RigReport report{.title = rig.title,
                     .assumptions = {contact_diameter(rig), known_stiffness(rig),
                                     similar_stiffness(rig), rigid_sensor(rig), rod_as_spring(rig),
                                     no_tilting(rig), sampled_often(rig)}};
    report.printed = check_printed(rig.printed, report.assumptions);
    return report;
}

}  // namespace tricontact::rig
