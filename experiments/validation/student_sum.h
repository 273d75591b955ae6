#pragma once

#include <vector>

namespace tricontact::experiments {

/// A standard error that is estimated by few values.
struct EstimatedError {
    double standard_error = 0;
    double degrees_of_freedom = 1;
};

/// Half width of the interval that holds a sum of independent errors in 95 % of the cases: one
/// known, normal, by its variance, and estimated ones, each Student's t times its standard error.
/// What is drawn in JCGM 101:2008 (GUM, supplement 1; 6.4.9) is integrated here; of two estimated
/// errors it is the distribution of Behrens and Fisher. Other than the effective degrees of freedom
/// of Welch and Satterthwaite it stays wide where one of few values is small by chance. Of more
/// than two estimated errors the two largest stay as they are, the others are put together by Welch
/// and Satterthwaite with the smaller of these.
double half_width_of_sum(double known_variance, std::vector<EstimatedError> estimated);

}  // namespace tricontact::experiments
