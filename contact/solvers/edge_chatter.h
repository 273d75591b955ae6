#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tricontact::contact {

/// Points at the edge of the contact that a law of friction with a strength of its own leaves no
/// rest: pressed, they carry tau_0, which lifts them off; off, they carry nothing, and are pressed
/// again. The law holds where p > 0; at p = 0 any traction up to tau_0 is one, and the least, none,
/// is taken. What that leaves out is the traction of one point at the edge.
class EdgeChatter {
  public:
    /// Forgets all; n = 0: the law has no jump at p = 0, nothing is watched.
    void begin(std::size_t n) {
        turns_.assign(n, 0);
        touched_.assign(n, unknown);
    }
    bool is_watched() const { return !turns_.empty(); }
    /// Notes whether a point is pressed in this iteration; whether it carries nothing from now on.
    bool lets_go(std::size_t i, bool touches) {
        const std::uint8_t now = touches ? 1 : 0;
        if (touched_[i] != unknown && touched_[i] != now && turns_[i] < enough) ++turns_[i];
        touched_[i] = now;
        return turns_[i] >= enough;
    }

  private:
    static constexpr std::uint8_t unknown = 2, enough = 3;  // on, off and on again

    std::vector<std::uint8_t> turns_, touched_;
};

}  // namespace tricontact::contact
