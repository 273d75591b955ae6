#pragma once

#include <cmath>
#include <limits>

namespace tricontact::contact {

/// A sum of many terms with the rounding of one: what each addition rounds off is added up
/// separately (Neumaier 1974). Never compile it so that additions may be rearranged.
class CompensatedSum {
  public:
    void add(double term) {
        const double next = sum_ + term;
        rest_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
        sum_ = next;
    }
    double value() const { return sum_ + rest_; }

  private:
    double sum_ = 0, rest_ = 0;
};

/// Long sums: plain ones over blocks, which the compiler may vectorise, and a compensated one over
/// the blocks. The error is at most that of a plain sum over one block, half an epsilon per term,
/// in proportion to the sum of the terms' magnitudes, however many terms there are.
constexpr int summed_block = 128;
constexpr double sum_rounding = summed_block / 2. * std::numeric_limits<double>::epsilon();

/// Calls `block(begin, end)` for consecutive blocks of [first, last).
template <class Block>
void for_each_block(int first, int last, Block&& block) {
    for (int begin = first; begin < last;) {
        const int end = last - begin <= summed_block ? last : begin + summed_block;
        block(begin, end);
        begin = end;
    }
}

}  // namespace tricontact::contact
