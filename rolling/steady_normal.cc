#include "rolling/steady_normal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "rolling/gmres.h"

namespace tricontact::rolling {

namespace {

using Eigen::VectorXd;

constexpr int max_normal_steps = 100, max_normal_iterations = 400;

class NormalNewton {
  public:
    NormalNewton(const contact::SteadyCompliance& compliance, double local,
                 const std::vector<double>& height, const contact::NormalControl& control,
                 const std::vector<double>& start)
        : compliance_(compliance),
          local_(local),
          cell_(compliance.points().area.front()),
          height_(height),
          control_(control),
          gap_(height.size()) {
        solution_.displacement.resize(height.size());
        solution_.pressure = start;
        if (start.empty()) solution_.pressure.assign(height.size(), first_pressure());
        for (std::size_t i = 0; i < height.size(); ++i)
            if (!std::isfinite(height[i])) solution_.pressure[i] = 0;
    }

    contact::NormalSolution run(double tolerance) {
        for (int step = 0; step < max_normal_steps; ++step) {
            const bool pulls = release();
            update_gap();
            if (solution_.residual <= tolerance) return std::move(solution_);
            classify(!pulls);
            close_gap();
        }
        throw contact::NotConverged(fmt::format(
            "steady rolling: normal contact: residual {:.2e} (tolerance {:.1e}) after {} Newton "
            "steps; {} points in contact",
            solution_.residual, tolerance, max_normal_steps, active_.size()));
    }

  private:
    bool force_controlled() const { return control_.kind == contact::NormalControl::Kind::force; }

    /// On all points: that of the force, or one that displaces a cell as far as is prescribed.
    double first_pressure() const {
        const double n = static_cast<double>(height_.size());
        return force_controlled() ? control_.value / (n * cell_) : control_.value / (n * local_);
    }

    /// Takes points that pull out of contact. Whether there were any.
    bool release() {
        bool pulls = false;
        for (double& p : solution_.pressure) {
            pulls = pulls || p < 0;
            p = std::max(p, 0.);
        }
        return pulls;
    }

    /// The prescribed force, displacements, gap and residual of the pressures.
    void update_gap() {
        auto& p = solution_.pressure;
        double sum = 0;
        for (const double value : p) sum += cell_ * value;
        if (force_controlled()) {
            for (double& value : p) value *= control_.value / sum;
            sum = control_.value;
        }
        solution_.force = sum;
        compliance_.normal(p, solution_.displacement);
        ++solution_.iterations;
        const auto& u = solution_.displacement;
        double mean = 0, work = 0;
        std::size_t n = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (!(p[i] > 0)) continue;
            mean += u[i] + height_[i];
            work += cell_ * p[i] * u[i];
            ++n;
        }
        solution_.indentation = force_controlled() ? mean / static_cast<double>(n) : control_.value;
        solution_.length = contact::larger(solution_.indentation, work / sum);
        double worst = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            gap_[i] = u[i] + height_[i] - solution_.indentation;
            worst = contact::larger(worst, p[i] > 0 ? std::abs(gap_[i]) : -gap_[i]);
        }
        solution_.residual = worst / solution_.length;
    }

    /// Points in contact, and those that penetrate beside them.
    void classify(bool grows) {
        active_.clear();
        for (std::size_t i = 0; i < gap_.size(); ++i)
            if (solution_.pressure[i] > 0 || (grows && gap_[i] < 0)) active_.push_back(i);
    }

    VectorXd gathered(const std::vector<double>& field) const {
        return VectorXd::Map(field.data(), static_cast<Eigen::Index>(field.size()))(active_);
    }
    std::vector<double> scattered(const VectorXd& v) const {
        std::vector<double> field(gap_.size(), 0.);
        VectorXd::Map(field.data(), static_cast<Eigen::Index>(field.size()))(active_) = v;
        return field;
    }
    /// Under a force pressures change without one, and how deep all lies is not asked.
    VectorXd admissible(VectorXd v) const {
        if (force_controlled()) v.array() -= v.mean();
        return v;
    }

    /// Newton's step for the present points.
    void close_gap() {
        std::vector<double> out(gap_.size());
        const auto product = [&](const VectorXd& z) {
            compliance_.normal(scattered(z), out);
            return admissible(gathered(out));
        };
        const auto precondition = [&](const VectorXd& r) {
            compliance_.precondition_normal(scattered(r), out);
            return admissible(gathered(out));
        };
        // Points still come and go while the residual is large: no more exactly than that deserves.
        const double forcing = std::clamp(.01 * solution_.residual, 1e-10, 1e-2);
        const GmresResult found = gmres(product, precondition, admissible(-gathered(gap_)), forcing,
                                        max_normal_iterations);
        solution_.iterations += found.iterations;
        for (std::size_t k = 0; k < active_.size(); ++k)
            solution_.pressure[active_[k]] += found.x[static_cast<Eigen::Index>(k)];
    }

    const contact::SteadyCompliance& compliance_;
    const double local_, cell_;
    const std::vector<double>& height_;
    const contact::NormalControl control_;
    contact::NormalSolution solution_;
    std::vector<double> gap_;
    std::vector<std::size_t> active_;
};

}  // namespace

SteadyNormalSolver::SteadyNormalSolver(const contact::SteadyCompliance& compliance,
                                       double tolerance)
    : compliance_(compliance), tolerance_(tolerance), local_(0) {
    std::vector<double> one(compliance.points().size()), u(one.size());
    one[one.size() / 2] = 1;
    compliance.normal(one, u);
    local_ = u[one.size() / 2];
}

contact::NormalSolution SteadyNormalSolver::solve(const std::vector<double>& height,
                                                  const contact::NormalControl& control,
                                                  const std::vector<double>& start) const {
    return NormalNewton(compliance_, local_, height, control, start).run(tolerance_);
}

}  // namespace tricontact::rolling
