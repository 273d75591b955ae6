#pragma once

#include <string>
#include <vector>

#include "statistics/error_propagation.h"

namespace tricontact::experiments {

/// A quantity that goes into a formula.
struct Given {
    std::string symbol;  ///< "W"
    statistics::Uncertain value;
    std::string unit;  ///< SI, "1" of pure numbers
};

/// One formula with the numbers put in: what a report shows of the arithmetic.
struct Calculation {
    std::string name;     ///< "pivot_height_error"
    std::string symbol;   ///< "Dh"
    std::string formula;  ///< "DU R/W"
    std::string source;   ///< "(5.1.11)"
    std::string unit;     ///< SI, "1" of pure numbers
    std::vector<Given> given;
    statistics::Quantity function;  ///< of the values of `given`
    statistics::Uncertain result;   ///< first-order error of the given ones
};

/// The values alone.
std::vector<double> values_of(const std::vector<Given>& given);

/// With its result. Throws what `function` throws.
Calculation calculate(std::string name, std::string symbol, std::string formula, std::string source,
                      std::string unit, std::vector<Given> given, statistics::Quantity function);

/// A given quantity of a calculation that has the value `wanted` if only this quantity changes.
struct Substitute {
    std::string symbol;
    double needed = 0;  ///< SI
    double given = 0;
    std::string unit;
};

/// One for each given quantity that can do it between 1e-6 and 1e6 times its value.
std::vector<Substitute> substitutes(const Calculation& calculation, double wanted);

}  // namespace tricontact::experiments
