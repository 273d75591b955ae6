#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/compliances/blocks.h"
#include "contact/compliances/compliance.h"

namespace tricontact::contact {

/// Products of fields of some points by those of all, zero elsewhere. One caller at a time.
class ScatteredPoints {
  public:
    /// `positions`: of the points among `n_all`.
    ScatteredPoints(std::vector<std::size_t> positions, std::size_t n_all, int n_threads)
        : positions_(std::move(positions)),
          points_(positions_.size(), n_threads),
          in_(n_all, n_threads),
          out_(n_all, n_threads) {}

    /// product(field of all, what becomes of it)
    template <class Product>
    void apply(const TangentialField& f, TangentialField& to, Product product) const {
        points_.for_points([&](std::size_t k) { in_.set(positions_[k], f.at(k)); });
        product(std::as_const(in_), out_);
        points_.for_points([&](std::size_t k) { to.set(k, out_.at(positions_[k])); });
    }
    template <class Product>
    void apply(std::span<const double> f, std::span<double> to, Product product) const {
        points_.for_points([&](std::size_t k) { in_.x[positions_[k]] = f[k]; });
        product(std::span<const double>(in_.x), std::span(out_.x));
        points_.for_points([&](std::size_t k) { to[k] = out_.x[positions_[k]]; });
    }

  private:
    std::vector<std::size_t> positions_;
    Blocks points_;
    mutable TangentialField in_, out_;
};

}  // namespace tricontact::contact
