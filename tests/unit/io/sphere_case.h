#pragma once

#include <string>

namespace tricontact::io {

/// The text of a case that lacks a tangential load: further lines belong to [load].
inline const std::string pressed_sphere = R"(models = ["bem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
[friction]
coefficient = 0.57
[load]
normal_force = "21.1 N"
)";

/// A whole case: the sphere pressed and loaded, without rolling.
inline const std::string loaded_sphere = pressed_sphere + "tangential_ratio = 0.56\n";

}  // namespace tricontact::io
