#pragma once

#include <memory>
#include <span>
#include <vector>

#include "mdr/plane_profile.h"

namespace tricontact::mdr {

/// Indices [first, last) of neighbouring springs.
struct Window {
    int first = 0, last = 0;
    int size() const { return last - first; }
};
Window intersection(const Window& a, const Window& b);  ///< size 0 if disjoint

/// Independent springs at equal distances, pressed by a rigid plane profile: which of them touch,
/// and how deep. Pure geometry: lengths in m, stiffness left to the caller.
class NormalBed {
  public:
    /// `n_springs` >= 1 at the midpoints of equal cells of [-half_length, half_length] [m].
    NormalBed(std::unique_ptr<PlaneProfile> profile, int n_springs, double half_length);

    /// Presses the profile at `position` [m] until the penetrations of all springs sum to `sum`
    /// [m] > 0: the root of a convex, piecewise linear function by Newton's method, which is
    /// finite. Returns the iterations. Throws contact::NotConverged.
    int press_to_sum(double position, double sum);
    /// Presses the profile at `position` [m] to the depth [m] > 0 of its lowest point.
    void press_to_depth(double position, double depth) {
        move_to(position);
        depth_ = depth;
        adjust_contact();
    }
    /// Adds `n` springs at each end; the last press must be repeated.
    void grow(int n) {
        n_ += 2 * n;
        first_ -= n * spacing_;
        heights_.assign(n_, 0);
        contact_ = sampled_ = {};
    }

    const PlaneProfile& profile() const { return *profile_; }
    int size() const { return n_; }
    double spacing() const { return spacing_; }
    double spring_position(int i) const { return first_ + i * spacing_; }
    double position() const { return position_; }  ///< of the profile [m]
    double depth() const { return depth_; }        ///< d [m]
    /// Springs in contact: a single window, as g does not decrease with |x|.
    const Window& contact() const { return contact_; }
    /// g(x_i - position) [m] of the springs in contact.
    std::span<const double> heights() const {
        return {heights_.data() + contact_.first, static_cast<std::size_t>(contact_.size())};
    }
    /// What a press leaves, from or to an archive; the profile stays.
    template <class Archive, class Self>
    static void transfer(Archive& archive, Self& bed) {
        archive(bed.n_, bed.first_, bed.position_, bed.depth_, bed.contact_, bed.sampled_,
                bed.heights_);
    }
    bool touches_end() const { return contact_.first == 0 || contact_.last == n_; }

  private:
    void move_to(double position);
    double height(int i);
    bool adjust_contact();

    std::unique_ptr<PlaneProfile> profile_;
    int n_;
    double first_, spacing_;
    double position_ = 0, depth_ = 0;
    Window contact_;
    Window sampled_;               // where heights_ belong to the present position
    std::vector<double> heights_;  // one per spring
};

/// Of forces and energies, whatever the number of springs: some seventy contact::sum_rounding.
inline constexpr double rounding = 1e-12;

/// Zeros for `n` more springs at each end.
inline void pad(std::vector<double>& values, int n) {
    values.insert(values.begin(), n, 0);
    values.insert(values.end(), n, 0);
}

/// The values of the springs of a window.
inline std::span<double> part(std::vector<double>& values, const Window& window) {
    return {values.data() + window.first, static_cast<std::size_t>(window.size())};
}
inline std::span<const double> part(const std::vector<double>& values, const Window& window) {
    return {values.data() + window.first, static_cast<std::size_t>(window.size())};
}

}  // namespace tricontact::mdr
