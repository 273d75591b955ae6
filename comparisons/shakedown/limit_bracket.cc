#include "comparisons/shakedown/limit_bracket.h"

#include <algorithm>
#include <numeric>

#include "contact/verdict.h"

namespace tricontact::comparisons {

using contact::State;

namespace {

class Bisection {
  public:
    Bisection(const std::function<State(double)>& verdict, double low, double high,
              double tolerance)
        : verdict_(verdict), tolerance_(tolerance) {
        bracket_.last_shakedown = low;
        bracket_.first_ratcheting = high;
    }

    LimitBracket bisect() {
        while (const auto middle = next()) probe(*middle);
        return std::move(bracket_);
    }

  private:
    void probe(double value) {
        const State state = verdict_(value);
        bracket_.probes.push_back({value, state});
        if (contact::settles(state))
            bracket_.last_shakedown = value;
        else if (state == State::ratcheting)
            bracket_.first_ratcheting = value;
        else if (!bracket_.undecided)
            bracket_.undecided = {value, value};
        else
            bracket_.undecided = {std::min(bracket_.undecided->first, value),
                                  std::max(bracket_.undecided->second, value)};
        trim();
    }

    /// An undecided value beyond an end that has moved since is none any more.
    void trim() {
        auto& band = bracket_.undecided;
        if (!band) return;
        if (band->second <= bracket_.last_shakedown || band->first >= bracket_.first_ratcheting) {
            band.reset();
            return;
        }
        band->first = std::max(band->first, bracket_.last_shakedown);
        band->second = std::min(band->second, bracket_.first_ratcheting);
    }

    std::optional<double> next() const {
        const double low = bracket_.last_shakedown, high = bracket_.first_ratcheting;
        if (high - low <= tolerance_) return {};
        if (!bracket_.undecided) return inside(low, high);
        const auto [first, last] = *bracket_.undecided;
        if (first - low > tolerance_) return inside(low, first);
        if (high - last > tolerance_) return inside(last, high);
        return {};
    }

    /// The middle; none where rounding leaves nothing in between.
    static std::optional<double> inside(double low, double high) {
        const double middle = std::midpoint(low, high);
        return middle > low && middle < high ? std::optional(middle) : std::nullopt;
    }

    const std::function<State(double)>& verdict_;
    double tolerance_;
    LimitBracket bracket_;
};

}  // namespace

LimitBracket find_limit(const std::function<State(double)>& verdict, double low, double high,
                        double tolerance) {
    return Bisection(verdict, low, high, tolerance).bisect();
}

}  // namespace tricontact::comparisons
