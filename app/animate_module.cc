#include "animation/animate.h"

extern "C" void tricontact_animate(const tricontact::animation::Request& request,
                                   std::vector<std::string>& names) {
    names = tricontact::animation::animate(request);
}
