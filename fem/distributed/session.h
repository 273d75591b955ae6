#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace tricontact::fem::distributed {

/// MPI (and the libraries that use it) from the constructor to the destructor; once per process.
/// One thread per rank, unless OPENBLAS_NUM_THREADS asks for more.
class Session {
  public:
    Session();
    ~Session();

    int rank() const { return rank_; }
    int n_ranks() const { return n_ranks_; }
    bool is_root() const { return rank_ == 0; }  ///< the one that prints and writes

    /// Runs `work`, which must not communicate, on this rank. Then, once the last has done so (the
    /// others sleep), all ranks go on, or all throw
    /// what the lowest rank that failed threw: contact::InputError, contact::NotConverged,
    /// std::bad_alloc or std::runtime_error. Collective.
    void agree(const std::function<void()>& work) const;
    /// The same for work of the root rank alone.
    void agree_on_first(const std::function<void()>& work) const;

    /// Adds values [of every rank as many] on the first rank, in the order of the ranks.
    /// Collective.
    void add_on_first(std::vector<double>& values) const;

    /// Largest of, or sum over, the ranks. Collective.
    double largest(double value) const;
    double sum(double value) const;
    /// Sum over the ranks on the machine of this one. Collective.
    double sum_on_machine(double value) const;

    /// Runs `work` in which the ranks communicate. An error that they did not agree on ends all of
    /// them at once with exit code 1: the others would wait for ever. Collective.
    void abort_on_local_error(const std::function<void()>& work) const;

    /// The first rank's values on all. Collective.
    void broadcast(void* values, std::size_t size) const;
    template <typename T>
    void broadcast(std::vector<T>& values) const {
        static_assert(std::is_trivially_copyable_v<T>);
        std::size_t n = values.size();
        broadcast(&n, sizeof(n));
        agree([&] { values.resize(n); });
        broadcast(values.data(), n * sizeof(T));
    }

  private:
    void wait_for_all() const;

    struct Libraries;
    std::unique_ptr<Libraries> libraries_;
    int rank_ = 0, n_ranks_ = 1;
    mutable bool agreed_to_fail_ = false;
};

}  // namespace tricontact::fem::distributed
