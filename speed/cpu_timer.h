#pragma once

#include <ctime>

namespace tricontact::speed {

/// Processor time of this process from here on: what others do meanwhile does not count.
class CpuTimer {
  public:
    double seconds() const { return static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC; }

  private:
    std::clock_t begin_ = std::clock();
};

}  // namespace tricontact::speed
