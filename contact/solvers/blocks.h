#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tricontact::contact {

/// Loops over the fields of a large grid, shared by threads. Fields are cut into blocks of a fixed
/// size, which the cache holds, and sums over blocks are added in their order, so that results do
/// not depend on the number of threads.
class Blocks {
  public:
    Blocks(std::size_t n, int n_threads) : n_(n), n_threads_(n_threads) {}

    std::size_t count() const { return (n_ + size - 1) / size; }

    /// body(number of the block, begin, end)
    template <class Body>
    void for_each(Body body) const {
        const auto n_blocks = static_cast<std::ptrdiff_t>(count());
        // One block in turn for each thread: contacts are not everywhere alike.
#pragma omp parallel for num_threads(n_threads_) if (n_threads_ > 1) schedule(static, 1)
        for (std::ptrdiff_t k = 0; k < n_blocks; ++k) {
            const std::size_t begin = static_cast<std::size_t>(k) * size;
            body(static_cast<std::size_t>(k), begin, std::min(n_, begin + size));
        }
    }

    /// The sum (+=) of what that body returns.
    template <class Sum, class Body>
    Sum sum(Body body) const {
        std::vector<Sum> parts(count());
        for_each([&](std::size_t k, std::size_t begin, std::size_t end) {
            parts[k] = body(k, begin, end);
        });
        Sum total{};
        for (const Sum& part : parts) total += part;
        return total;
    }

  private:
    static constexpr std::size_t size = 16384;

    std::size_t n_;
    int n_threads_;
};

}  // namespace tricontact::contact
