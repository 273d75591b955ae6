#pragma once

#include <gsl/gsl_errno.h>

namespace tricontact::contact {

/// From here on an error of GSL is a return value, not the end of the program. The handler belongs
/// to the whole process, so that it is not put back: another thread may be fitting.
inline void return_gsl_errors() {
    [[maybe_unused]] static gsl_error_handler_t* const before = gsl_set_error_handler_off();
}

}  // namespace tricontact::contact
