#include "io/case/rolling_on.h"

#include "contact/base/error.h"

namespace tricontact::io {

void refuse_rolling_on(const contact::Case& c, const std::string& case_file) {
    if (c.tractive_rolling)
        throw contact::InputError(case_file +
                                  ": [tractive_rolling]: the indenter rolls on and does not come "
                                  "back; tricontact run computes such a case");
}

void require_rolling_on(const contact::Case& c, const std::string& case_file) {
    if (!c.tractive_rolling)
        throw contact::InputError(case_file +
                                  ": there is no [tractive_rolling], so that nothing rolls on; "
                                  "tricontact run computes it, or add that section");
}

}  // namespace tricontact::io
