#include "contact/base/fftw.h"

namespace tricontact::contact {

void let_threads_plan() {
    [[maybe_unused]] static const bool done = (fftw_make_planner_thread_safe(), true);
}

}  // namespace tricontact::contact
