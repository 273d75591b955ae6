#include "mdr/normal_bed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/base/compensated_sum.h"
#include "contact/base/error.h"

namespace tricontact::mdr {

namespace {

double sum_of(std::span<const double> values) {
    const double* const value = values.data();
    contact::CompensatedSum all;
    contact::for_each_block(0, static_cast<int>(values.size()), [&](int begin, int end) {
        double sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int i = begin; i < end; ++i) sum += value[i];
        all.add(sum);
    });
    return all.value();
}

}  // namespace

Window intersection(const Window& a, const Window& b) {
    const int first = std::max(a.first, b.first);
    return {first, std::max(first, std::min(a.last, b.last))};
}

NormalBed::NormalBed(std::unique_ptr<PlaneProfile> profile, int n_springs, double half_length)
    : profile_(std::move(profile)), n_(n_springs) {
    if (n_springs < 1 || !(half_length > 0))
        throw std::domain_error("NormalBed: needs a spring and a positive length");
    spacing_ = 2 * half_length / n_springs;
    first_ = spacing_ / 2 - half_length;
    heights_.resize(n_springs);
}

// Samples g where contact is expected: the window of the last press, moved along.
void NormalBed::move_to(double position) {
    const double moved = std::round((position - position_) / spacing_);
    const int shift = static_cast<int>(std::clamp<double>(moved, -n_, n_));
    position_ = position;
    const Window all{0, n_};
    contact_ = intersection({contact_.first + shift, contact_.last + shift}, all);
    if (contact_.size() == 0) contact_ = all;
    const double range = profile_->range();  // beyond it g is infinite and no spring can touch
    while (contact_.size() > 1 && spring_position(contact_.first) < position - range)
        ++contact_.first;
    while (contact_.size() > 1 && spring_position(contact_.last - 1) > position + range)
        --contact_.last;
    sampled_ = intersection({contact_.first - 2, contact_.last + 2}, all);
    const std::size_t n_sampled = sampled_.size();
    profile_->sample(spring_position(sampled_.first) - position, spacing_,
                     {heights_.data() + sampled_.first, n_sampled});
}

double NormalBed::height(int i) {
    if (i < sampled_.first || i >= sampled_.last) {
        heights_[i] = profile_->value(spring_position(i) - position_);
        if (i == sampled_.first - 1) --sampled_.first;
        if (i == sampled_.last) ++sampled_.last;
    }
    return heights_[i];
}

// Makes the contact the springs with g < depth (at least one); true if that changed it.
bool NormalBed::adjust_contact() {
    const Window before = contact_;
    Window& c = contact_;
    while (c.size() > 1 && height(c.first) >= depth_) ++c.first;
    while (c.size() > 1 && height(c.last - 1) >= depth_) --c.last;
    while (c.first > 0 && height(c.first - 1) < depth_) --c.first;
    while (c.last < n_ && height(c.last) < depth_) ++c.last;
    return c.first != before.first || c.last != before.last;
}

int NormalBed::press_to_sum(double position, double sum) {
    move_to(position);
    // sum_contact (d - g) = sum. From any window the next depth is not below the root, and from
    // there the windows only shrink.
    for (int iteration = 1; iteration <= n_ + 2; ++iteration) {
        depth_ = (sum + sum_of(heights())) / contact_.size();
        if (!adjust_contact()) return iteration;
    }
    throw contact::NotConverged(
        fmt::format("spring bed: normal force not found after {} Newton steps, {} springs in "
                    "contact",
                    n_ + 2, contact_.size()));
}

}  // namespace tricontact::mdr
