#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "contact/surface.h"

namespace tricontact::contact {

/// What points did in all steps of a period.
class LastingStates {
  public:
    void begin() { contact_.clear(); }
    void add(const std::vector<ContactState>& states) {
        if (contact_.size() != states.size()) {
            contact_.assign(states.size(), true);
            stick_ = contact_;
        }
        for (std::size_t i = 0; i < states.size(); ++i) {
            contact_[i] = contact_[i] && states[i] != ContactState::open;
            stick_[i] = stick_[i] && states[i] == ContactState::stick;
        }
    }
    /// A point was in contact and stuck.
    bool something_sticks() const {
        return !contact_.empty() && std::find(stick_.begin(), stick_.end(), true) != stick_.end();
    }
    /// Of what points dissipated, each per area, the share of those that were in contact; 1 for
    /// what is not known by points.
    double share_in_contact(const std::vector<double>& work) const {
        double all = 0, lasting = 0;
        for (std::size_t i = 0; i < work.size(); ++i) all += work[i];
        if (work.size() != contact_.size() || !(all > 0)) return 1;
        for (std::size_t i = 0; i < work.size(); ++i)
            if (contact_[i]) lasting += work[i];
        return lasting / all;
    }

  private:
    std::vector<bool> contact_, stick_;
};

}  // namespace tricontact::contact
