#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/submissions/submission.h"
#include "io/keys/units.h"

namespace tricontact::benchmarks {

/// A number that a code may state beside its field.
struct TotalKey {
    std::string_view key;                   ///< of quantity_keys, or "size", "cpu_time"
    std::vector<io::Dimension> dimensions;  ///< in space, and of a plane contact per length
    std::string_view example;               ///< "16.7 N"
    std::string_view text;                  ///< one line
    std::vector<std::string_view> also;     ///< other words for it: "F_N"
};

/// All that a table's comment block and a mesh of a submission file may state.
std::span<const TotalKey> total_keys();

/// By the name or another word for it; null if there is none.
const TotalKey* find_total_key(std::string_view name);

/// "16.7 N", or "16.7" without a unit. Throws contact::InputError `place: key = text: ...`.
Total read_total(const TotalKey& key, std::string_view text, const std::string& place);

/// Factor to SI of a unit that has one of the dimensions. Throws io::QuantityError.
double unit_factor(std::string_view unit, std::span<const io::Dimension> dimensions);

/// value * factor as the double nearest to the decimal value: 1.1 mm is 1.1 / 1000.
double in_si(double value, double factor);

}  // namespace tricontact::benchmarks
