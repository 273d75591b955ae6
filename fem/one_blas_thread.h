#pragma once

extern "C" int openblas_get_num_threads(void);
extern "C" void openblas_set_num_threads(int n);

namespace tricontact::fem {

/// While it lives products are those of one thread: last bits of a factor depend on the number of
/// threads, so on the machine, and threads that wait take as much processor time as those at work.
class OneBlasThread {
  public:
    OneBlasThread() { openblas_set_num_threads(1); }
    ~OneBlasThread() { openblas_set_num_threads(before_); }
    OneBlasThread(const OneBlasThread&) = delete;
    OneBlasThread& operator=(const OneBlasThread&) = delete;

  private:
    int before_ = openblas_get_num_threads();
};

}  // namespace tricontact::fem
