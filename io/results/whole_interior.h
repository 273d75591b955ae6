#pragma once

#include "contact/compliances/interior.h"

namespace tricontact::io {

/// Whether elements fill one side of the plane y = 0 and touch it: of a body that this plane
/// mirrors, half is computed.
bool is_half(const contact::Interior& interior);

/// Such a half and its mirror image as one: points of the plane once, with the mean of both sides,
/// which has no shear across it. Numbers of the whole body stay.
contact::Interior with_mirror_image(const contact::Interior& half);

}  // namespace tricontact::io
