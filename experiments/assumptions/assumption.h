#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "statistics/error_propagation.h"

namespace tricontact::experiments {

using statistics::Estimate;

/// A quantity that goes into a formula.
struct Given {
    std::string symbol;  ///< "W"
    Estimate value;
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
    Estimate result;                ///< first-order error of the given ones
};

/// With its result. Throws what `function` throws.
Calculation calculate(std::string name, std::string symbol, std::string formula, std::string source,
                      std::string unit, std::vector<Given> given, statistics::Quantity function);

/// Of the quantities that go into a formula, in their order.
using Values = std::vector<double>;
Values values_of(const std::vector<Given>& given);

/// A formula of a rig.
struct Formula {
    const char *name, *symbol, *formula, *source, *unit;  ///< as Calculation's
    const char* given;  ///< keys of the rig's quantities, separated by spaces
    double (*function)(const Values&);

    constexpr Formula(const char* its_name, const char* its_symbol, const char* text,
                      const char* its_source, const char* its_unit, const char* keys,
                      double (*of_values)(const Values&))
        : name(its_name),
          symbol(its_symbol),
          formula(text),
          source(its_source),
          unit(its_unit),
          given(keys),
          function(of_values) {}
};

/// A quantity of a rig: data, or what follows from them.
template <class Rig>
struct RigQuantity {
    const char* key;   ///< its symbol, with ' behind where another quantity has the same one
    const char* unit;  ///< SI, "1" of pure numbers
    Estimate (*of)(const Rig&);
};

/// Those of a table that the keys name. Throws std::out_of_range for other keys.
template <class Rig>
std::vector<Given> given_by(const std::vector<RigQuantity<Rig>>& table, std::string_view keys,
                            const Rig& rig) {
    std::vector<Given> given;
    for (std::size_t begin = 0, end = 0; end != std::string_view::npos; begin = end + 1) {
        end = keys.find(' ', begin);
        const std::string_view key = keys.substr(begin, end - begin);
        std::size_t i = 0;
        while (table.at(i).key != key) ++i;
        given.push_back(
            {std::string(key.substr(0, key.find('\''))), table[i].of(rig), table[i].unit});
    }
    return given;
}

/// A formula with the numbers of a rig put in, see given() of each kind.
template <class Rig>
Calculation calculate(const Rig& rig, const Formula& f) {
    return calculate(f.name, f.symbol, f.formula, f.source, f.unit, given(rig, f.given),
                     f.function);
}

/// A given quantity of a calculation that has the value `wanted` if only this quantity changes.
struct Substitute {
    std::string symbol;
    double needed = 0;  ///< SI
    double given = 0;
    std::string unit;
};

/// One for each given quantity that can do it between 1e-6 and 1e6 times its value.
std::vector<Substitute> substitutes(const Calculation& calculation, double wanted);

enum class Standing { holds, fails, cannot_tell };

/// A number that decides, and what it is held against.
struct Criterion {
    enum class Relation { at_most, at_least };

    Calculation calculation;
    Relation relation = Relation::at_most;
    double threshold = 0;  ///< in the calculation's unit
    std::string reason;    ///< for the threshold

    /// Cannot tell where the threshold lies within the standard error of the number.
    Standing standing() const;
};

/// What the evaluation of an experiment takes for granted.
struct Assumption {
    std::string name;   ///< "half_space"
    std::string title;  ///< "Half-space"
    std::string claim;  ///< "The substrate is a half-space"
    std::vector<Criterion> criteria = {};
    std::vector<Calculation> background = {};  ///< further numbers
    std::vector<std::string> missing = {};     ///< keys of the rig file without which it is open
    std::string consequence = {};              ///< in words and percent

    /// Fails if one criterion does; else cannot tell if one cannot, if something is missing, or if
    /// there is no criterion.
    Standing standing() const;
    /// Of the criterion that comes first.
    double deciding_value() const { return criteria.front().calculation.result.value; }
};

}  // namespace tricontact::experiments
