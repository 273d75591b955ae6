#pragma once

#include <string>
#include <vector>

namespace tricontact::contact {

/// Worst violations over all solutions of a run, each dimensionless and with its allowed value.
class Audit {
  public:
    struct Check {
        std::string name;
        double worst = 0;    ///< largest violation seen
        double allowed = 0;  ///< largest violation accepted
        bool passed() const { return worst <= allowed; }
    };

    /// Notes one violation (>= 0; NaN counts as infinite) of the named check.
    void record(const std::string& name, double violation, double allowed);
    const std::vector<Check>& checks() const { return checks_; }
    bool passed() const;

  private:
    std::vector<Check> checks_;  // in order of first appearance
};

}  // namespace tricontact::contact
