#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "benchmarks/reference/reference.h"

namespace tricontact::benchmarks {

/// A unit in which numbers of the catalogue are written and shown.
struct QuantityUnit {
    std::string_view word;  ///< "MPa"
    double size = 1;        ///< what 1 of it is in SI
    std::string_view base;  ///< "Pa"
};

std::span<const QuantityUnit> quantity_units();
/// Null if there is none of this word.
const QuantityUnit* find_unit(std::string_view word);

/// "contact radius a" of "contact_radius"; empty if it is no key of quantity_keys.
std::string_view title_of_quantity(std::string_view key);
/// Whether a quantity of quantity_keys can be in this unit; of line contacts forces are per length.
bool measures(const QuantityUnit& unit, std::string_view key);
/// In which a quantity of quantity_keys is shown. Throws std::out_of_range for another key.
const QuantityUnit& usual_unit(std::string_view key, Geometry geometry);
/// All keys of quantity_keys in the order in which they are shown.
std::vector<std::string_view> shown_quantities();

}  // namespace tricontact::benchmarks
