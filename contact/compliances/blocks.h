#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "contact/compliances/point_sums.h"

namespace tricontact::contact {

/// Loops over the fields of a large grid, shared by threads. Fields are cut into blocks of a fixed
/// size, which the cache holds, and sums over blocks are added in their order, so that results do
/// not depend on the number of threads. A single block is a plain loop.
class Blocks {
  public:
    Blocks(std::size_t n, int n_threads) : n_(n), n_threads_(n_threads) {}

    std::size_t count() const { return (n_ + size - 1) / size; }

    /// body(number of the block, begin, end)
    template <class Body>
    void for_each(Body body) const {
        const auto n_blocks = static_cast<std::ptrdiff_t>(count());
        const auto one = [&](std::ptrdiff_t k) {
            const std::size_t begin = static_cast<std::size_t>(k) * size;
            body(static_cast<std::size_t>(k), begin, std::min(n_, begin + size));
        };
        if (n_threads_ == 1 || n_blocks < 2) {
            for (std::ptrdiff_t k = 0; k < n_blocks; ++k) one(k);
            return;
        }
        // One block in turn for each thread: contacts are not everywhere alike.
#ifdef _OPENMP  // else one thread does them all
#pragma omp parallel for num_threads(n_threads_) schedule(static, 1)
#endif
        for (std::ptrdiff_t k = 0; k < n_blocks; ++k) one(k);
    }

    /// body(number of the point): no point depends on another.
    template <class Body>
    void for_points(Body body) const {
        for_each([&](std::size_t, std::size_t begin, std::size_t end) {
#pragma GCC ivdep
            for (std::size_t i = begin; i < end; ++i) body(i);
        });
    }

    /// The sum (+=) of what that body returns.
    template <class Sum, class Body>
    Sum sum(Body body) const {
        if (count() == 1) return body(std::size_t{0}, std::size_t{0}, n_);
        std::vector<Sum> parts(count());
        for_each([&](std::size_t k, std::size_t begin, std::size_t end) {
            parts[k] = body(k, begin, end);
        });
        Sum total{};
        for (const Sum& part : parts) total += part;
        return total;
    }

    /// The sum (+=) of what body(sum of its block, number of the point) adds.
    template <class Sum, class Body>
    Sum sum_points(Body body) const {
        return sum<Sum>([&](std::size_t, std::size_t begin, std::size_t end) {
            Sum part{};
            for (std::size_t i = begin; i < end; ++i) body(part, i);
            return part;
        });
    }

    /// Of term(number of the point), see lane_sums().
    template <class Term>
    double sum_terms(Term term) const {
        return sum<double>([&](std::size_t, std::size_t begin, std::size_t end) {
            return lane_sums<1>(begin, end,
                                [&](Sums<1>& part, std::size_t i) { part[0] += term(i); })[0];
        });
    }

    /// The numbers of the points of which `is_one(i)`, in order.
    template <class IsOne>
    std::vector<std::size_t> points_where(IsOne is_one) const {
        std::vector<std::size_t> first(count() + 1);
        for_each([&](std::size_t k, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) first[k + 1] += is_one(i) ? 1 : 0;
        });
        for (std::size_t k = 0; k < count(); ++k) first[k + 1] += first[k];
        std::vector<std::size_t> points(first.back());
        for_each([&](std::size_t k, std::size_t begin, std::size_t end) {
            std::size_t next = first[k];
            for (std::size_t i = begin; i < end; ++i)
                if (is_one(i)) points[next++] = i;
        });
        return points;
    }

  private:
    static constexpr std::size_t size = 4096;

    std::size_t n_;
    int n_threads_;
};

}  // namespace tricontact::contact
