#include "contact/base/gauss_legendre.h"

#include <boost/math/special_functions/legendre.hpp>
#include <map>
#include <mutex>

namespace tricontact::contact {

namespace {

QuadratureRule new_rule(int n) {
    QuadratureRule rule;
    auto add = [&](double zero, double slope) {
        rule.points.push_back((1 + zero) / 2);
        rule.weights.push_back(1 / ((1 - zero) * (1 + zero) * slope * slope));
    };
    const std::vector<double> zeros = boost::math::legendre_p_zeros<double>(n);  // those >= 0
    for (auto zero = zeros.rbegin(); zero != zeros.rend(); ++zero)
        if (*zero > 0) add(-*zero, boost::math::legendre_p_prime(n, *zero));
    for (const double zero : zeros) add(zero, boost::math::legendre_p_prime(n, zero));
    return rule;
}

}  // namespace

const QuadratureRule& gauss_legendre(int n) {
    static std::mutex mutex;
    static std::map<int, QuadratureRule> rules;
    const std::scoped_lock lock(mutex);
    auto known = rules.find(n);
    if (known == rules.end()) known = rules.emplace(n, new_rule(n)).first;
    return known->second;
}

}  // namespace tricontact::contact
