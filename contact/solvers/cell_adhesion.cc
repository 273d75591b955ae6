#include "contact/solvers/cell_adhesion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/solvers/conjugate_gradients.h"
#include "contact/solvers/contact_region.h"

// On a set of cells that touch, u = d - h. Pressures are linear in d there,
//
//   p = d p_1 - p_h,   A p_1 = 1,  A p_h = h on the set,  p = 0 elsewhere,
//
// and so is the force, F = d S - F_h. Where d or F falls, the cell that comes to -sigma_c first is
// known; it lets go there, at the same d or F, with all those that then exceed sigma_c. A cell that
// lets go adds to the tension of all others, so it does not matter which goes first.

namespace tricontact::contact {

namespace {

constexpr int most_products = 2000, most_releases = 100000, most_meetings = 200;
constexpr double of_symmetry = 1e-6;  // tensions of cells that symmetry makes alike
constexpr double of_tolerance = .1;

}  // namespace

CellAdhesion::CellAdhesion(std::string name, const Compliance& compliance,
                           const Attraction& attraction, double tolerance)
    : name_(std::move(name)),
      compliance_(compliance),
      strength_(attraction.strength),
      tolerance_(tolerance) {}

/// Cells that touch, and what they carry.
class CellAdhesion::Set {
  public:
    Set(const CellAdhesion& law, const std::vector<double>& height, const NormalSolution& before)
        : law_(law),
          area_(law.compliance_.points().area),
          height_(height),
          n_(height.size()),
          held_(n_),
          fresh_(n_),
          by_depth_(n_),
          by_height_(n_),
          pressure_(n_),
          displacement_(n_) {
        if (before.attracts())
            for (std::size_t i = 0; i < n_; ++i) held_[i] = before.share[i] > 0;
    }

    bool is_empty() const {
        return std::ranges::none_of(held_, [](auto on) { return on != 0; });
    }

    /// The set at this control: cells that overlap meet, those that have met now part again without
    /// a tension.
    void meet(const NormalControl& control) {
        if (is_empty() && !touch_first(control)) {
            place(control);
            return;
        }
        for (int k = 0; k < most_meetings; ++k) {
            solve();
            place(control);
            bool changes = false;
            for (std::size_t i = 0; i < n_; ++i) {
                if (held_[i] && fresh_[i] && pressure_[i] < 0) {
                    held_[i] = fresh_[i] = 0;
                    changes = true;
                } else if (!held_[i] && gap(i) < -law_.tolerance_ * length_) {
                    held_[i] = fresh_[i] = 1;
                    changes = true;
                }
            }
            if (!changes) return;
        }
        throw NotConverged(law_.name_ + ": cells meet and part again, " +
                           std::to_string(most_meetings) + " times");
    }
    /// Lets go of what exceeds sigma_c; whether any did.
    bool let_go() {
        bool any = false;
        for (std::size_t i = 0; i < n_; ++i)
            if (held_[i] && pressure_[i] < -law_.strength_ * (1 - of_symmetry)) {
                held_[i] = fresh_[i] = 0;
                any = true;
            }
        return any;
    }

    /// The depth at which the first cell lets go, as the depth falls.
    double next_depth() const {
        double next = -infinity;
        for (std::size_t i = 0; i < n_; ++i)
            if (held_[i] && by_depth_[i] > 0)
                next = larger(next, (by_height_[i] - law_.strength_) / by_depth_[i]);
        return next;
    }
    double force_at(double depth) const { return depth * stiffness_ - height_force_; }
    double depth_at(double force) const { return (force + height_force_) / stiffness_; }

    void place(const NormalControl& control) {
        const bool by_force = control.kind == NormalControl::Kind::force;
        if (is_empty()) {
            if (by_force)
                throw InputError(
                    fmt::format("{}: a force of {:.6g} N pulls the surfaces off, they "
                                "do not hold so much; pull less, or prescribe the "
                                "depth",
                                law_.name_, control.value));
            std::ranges::fill(pressure_, 0);
            std::ranges::fill(displacement_, 0);
            depth_ = control.value;
            force_ = elastic_ = 0;
            length_ = std::abs(depth_);
            return;
        }
        depth_ = by_force ? depth_at(control.value) : control.value;
        force_ = elastic_ = 0;
        double magnitude = 0;
        for (std::size_t i = 0; i < n_; ++i) {
            pressure_[i] = held_[i] ? depth_ * by_depth_[i] - by_height_[i] : 0;
            force_ += area_[i] * pressure_[i];
            magnitude += area_[i] * std::abs(pressure_[i]);
        }
        law_.compliance_.normal(pressure_, displacement_);
        double work = 0;
        for (std::size_t i = 0; i < n_; ++i) {
            elastic_ += area_[i] * pressure_[i] * displacement_[i] / 2;
            work += area_[i] * std::abs(pressure_[i] * displacement_[i]);
        }
        // A last cell at its own height has no pressure: what it takes to let go is a length then.
        length_ = larger(larger(std::abs(depth_), magnitude > 0 ? work / magnitude : 0),
                         law_.strength_ / *std::ranges::max_element(by_depth_));
    }

    void solve() {
        products_ += column(by_depth_, [](std::size_t) { return 1.; });
        products_ += column(by_height_, [&](std::size_t i) { return height_[i]; });
        stiffness_ = height_force_ = 0;
        for (std::size_t i = 0; i < n_; ++i) {
            stiffness_ += area_[i] * by_depth_[i];
            height_force_ += area_[i] * by_height_[i];
        }
    }

    double depth() const { return depth_; }
    double force() const { return force_; }
    /// Between two states of the same cells force and depth go along a straight line: the work is
    /// stored. `way` goes on to here.
    void pay_smooth(NormalSolution& way) const {
        const double missing = work_from(way) - (elastic_ - way.energy);
        const double magnitude = elastic_ + way.energy;
        if (magnitude > 0) way.unbalanced += missing / magnitude;
        move(way);
    }
    /// Of cells that have let go, at the same force or depth.
    void pay_jump(NormalSolution& way) const {
        way.released += work_from(way) - (elastic_ - way.energy);
        move(way);
    }

    NormalSolution solution() const {
        NormalSolution s;
        s.pressure = pressure_;
        s.displacement = displacement_;
        s.indentation = depth_;
        s.length = length_;
        s.force = force_;
        s.iterations = products_;
        s.tension.resize(n_);
        s.share.resize(n_);
        s.energy = elastic_;
        for (std::size_t i = 0; i < n_; ++i) {
            s.share[i] = held_[i];
            s.tension[i] = std::max(0., -pressure_[i]);
            s.pull += area_[i] * s.tension[i];
            const double off = held_[i] ? std::abs(gap(i)) : std::max(0., -gap(i));
            if (length_ > 0) s.residual = larger(s.residual, off / length_);
        }
        return s;
    }

  private:
    double work_from(const NormalSolution& way) const {
        return .5 * (force_ + way.force) * (depth_ - way.indentation);
    }
    void move(NormalSolution& way) const {
        way.force = force_;
        way.indentation = depth_;
        way.energy = elastic_;
    }
    double gap(std::size_t i) const { return displacement_[i] + height_[i] - depth_; }

    bool touch_first(const NormalControl& control) {
        const bool by_force = control.kind == NormalControl::Kind::force;
        if (by_force && !(control.value > 0)) return false;
        const std::size_t lowest =
            static_cast<std::size_t>(std::ranges::min_element(height_) - height_.begin());
        if (by_force)
            held_[lowest] = fresh_[lowest] = 1;
        else
            for (std::size_t i = 0; i < n_; ++i) held_[i] = fresh_[i] = height_[i] < control.value;
        return !is_empty();
    }

    /// A x = b on the set, from the x of the last set.
    template <class Right>
    int column(std::vector<double>& x, const Right& right) {
        std::vector<double> r(n_), d(n_), by(n_);
        double scale = 0, norm = 0;
        for (std::size_t i = 0; i < n_; ++i)
            if (!held_[i]) x[i] = 0;
        law_.compliance_.normal(x, by);
        for (std::size_t i = 0; i < n_; ++i) {
            if (!held_[i]) continue;
            r[i] = right(i) - by[i];
            scale = larger(scale, std::abs(right(i)));
        }
        const double exact = of_tolerance * law_.tolerance_ * scale;
        const int n = conjugate_gradients(
            most_products,
            [&] {
                double worst = 0;
                for (const double value : r) worst = larger(worst, std::abs(value));
                return worst <= exact;
            },
            [&] {
                norm = 0;
                for (std::size_t i = 0; i < n_; ++i) norm += area_[i] * r[i] * r[i];
                return norm;
            },
            [&](double beta) {
                for (std::size_t i = 0; i < n_; ++i) d[i] = r[i] + beta * d[i];
            },
            [&] {
                law_.compliance_.normal(d, by);
                double product = 0;
                for (std::size_t i = 0; i < n_; ++i) product += area_[i] * d[i] * by[i];
                return product;
            },
            [&](double step) {
                for (std::size_t i = 0; i < n_; ++i) {
                    x[i] += step * d[i];
                    if (held_[i]) r[i] -= step * by[i];
                }
            });
        if (n == most_products)
            throw NotConverged(law_.name_ + ": pressures on the cells that touch are not found");
        return n;
    }

    const CellAdhesion& law_;
    const std::vector<double>& area_;
    const std::vector<double>& height_;
    std::size_t n_;
    std::vector<std::uint8_t> held_, fresh_;
    std::vector<double> by_depth_, by_height_, pressure_, displacement_;
    double stiffness_ = 0, height_force_ = 0, depth_ = 0, force_ = 0, elastic_ = 0, length_ = 0;
    int products_ = 0;
};

/// Down to this control, cell by cell. `seen` sees each state in which a cell is about to let go.
template <class Seen>
void CellAdhesion::lower(Set& set, const NormalControl& control, NormalSolution& way,
                         const Seen& seen) const {
    const bool by_force = control.kind == NormalControl::Kind::force;
    NormalControl at{control.kind, by_force ? way.force : way.indentation};
    for (int k = 0; k < most_releases; ++k) {
        const double next = set.next_depth();
        const double next_value = by_force ? set.force_at(next) : next;
        const bool is_last = !(next_value > control.value);
        at.value = is_last ? control.value : std::min(at.value, next_value);
        set.place(at);
        set.pay_smooth(way);
        if (is_last) return;
        seen(set);
        while (set.let_go()) {
            set.solve();
            set.place(at);
            set.pay_jump(way);
            if (set.is_empty()) return;
        }
    }
    throw NotConverged(name_ + ": cells let go without an end");
}

NormalSolution CellAdhesion::follow(const std::vector<double>& height, const NormalControl& control,
                                    const NormalSolution& before) const {
    Set set(*this, height, before);
    NormalSolution way = before;
    way.released = way.unbalanced = 0;
    const bool by_force = control.kind == NormalControl::Kind::force;
    if (!set.is_empty()) {
        set.solve();
        if (control.value < (by_force ? before.force : before.indentation))
            lower(set, control, way, [](const Set&) {});
    }
    // Cells meet at no force and gain nothing: what they store is the work of the force.
    set.meet(control);
    while (set.let_go()) set.meet(control);
    NormalSolution after = set.solution();
    after.released = way.released;
    after.unbalanced = way.unbalanced;
    return after;
}

PullOff CellAdhesion::pull(const std::vector<double>& height, const NormalSolution& before) const {
    Set set(*this, height, before);
    const auto radius = [&](const NormalSolution& s) {
        return shared_radius(compliance_.points(), s.share);
    };
    PullOff found{-before.force, radius(before), before.indentation, before.indentation};
    if (set.is_empty()) return found;
    NormalSolution way = before;
    set.solve();
    lower(set, {NormalControl::Kind::indentation, -infinity}, way, [&](const Set& now) {
        found.last_indentation = now.depth();
        if (!(now.force() < -found.force)) return;
        const NormalSolution least = now.solution();
        found.force = -least.force;
        found.radius = radius(least);
        found.indentation = least.indentation;
    });
    return found;
}

}  // namespace tricontact::contact
