#pragma once

#include <algorithm>
#include <cmath>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tricontact::comparisons {

/// One quantity of one model on finer and finer levels beside what it should be.
struct VerificationRow {
    std::string problem;           ///< "Hertz"
    std::string quantity;          ///< with its symbol, plain text
    std::string model{};           ///< as in case files
    std::string source;            ///< author, year, equation
    double reference = 0;          ///< exact, or as printed by the source
    double tolerance = 0;          ///< of the finest level's relative error
    double least_order = 0;        ///< 0: none is asked for
    std::vector<double> sizes{};   ///< h/a (of creep dt/tau), decreasing; one: the source's
    std::vector<double> values{};  ///< one per size, in the unit of the reference

    /// |value/reference - 1| of a level.
    double error(std::size_t level) const { return std::abs(values[level] / reference - 1); }
    /// Slope of ln error over ln size from the coarsest level to the finest; empty where an error
    /// is at most 1e-9, that is rounding, and for one level.
    std::optional<double> order() const;
    /// The finest level's error is within its tolerance and the order, if it shows, high enough.
    bool passed() const {
        const bool converges = least_order == 0 || order().value_or(least_order) >= least_order;
        return error(values.size() - 1) <= tolerance && converges;
    }
};

/// What the program was held against.
struct Verification {
    std::vector<VerificationRow> rows;

    bool passed() const { return std::ranges::all_of(rows, &VerificationRow::passed); }
};

/// The same in docs/reference/verification.md and verification.json: no times, no machine.
std::string verification_markdown(const Verification& verification);
nlohmann::ordered_json verification_json(const std::string& version,
                                         const Verification& verification);

}  // namespace tricontact::comparisons
