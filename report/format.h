#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tricontact::report {

/// A number for people: `digits` significant digits with trailing zeros kept, a true minus sign,
/// powers of ten beyond 1e5 and below 1e-3 ("1.20·10⁻⁷"); an en dash where undefined.
std::string significant(std::optional<double> value, int digits = 4);

/// Value and half width of its interval as the Particle Data Group rounds them: the error to two
/// digits where its leading three lie in 100 ... 354, else to one, the value to the same decimal
/// ("0.83 ± 0.12", "(1.234 ± 0.005)·10⁻⁷"). Beside an error below 1e-7 of it, or an undefined
/// one, the value has `digits` significant digits.
std::string with_error(double value, double error, int digits = 4);

/// A given number for people: at most six significant digits, no trailing zeros.
std::string as_given(double value);

/// HTML of a plain sentence: escaped, symbols of one letter with an index ("f_T"), Greek letters by
/// name ("mu"), powers ("a^2", "x^(1/3)"), ">=", "<=" and minus signs between spaces typeset, no
/// line break around "=" or before a unit.
std::string typeset(const std::string& sentence);

/// A ratio minus one in percent with its sign ("+16.5 %"); an en dash where undefined.
std::string percent(std::optional<double> ratio);

/// An SI unit with the prefix that keeps a magnitude between 1 and 1000.
struct Unit {
    double factor = 1;  ///< SI value / number
    std::string symbol;
};
Unit fitting_unit(double magnitude, const std::string& base);

/// Number and unit: "4.52 mm".
std::string quantity(double value, const std::string& base, int digits = 4);

/// The same for a given number, without trailing zeros: "8 mm".
std::string given_quantity(double value, const std::string& base);

/// "mdr" -> "MDR", "bem-layer" -> "BEM layer".
std::string display_name(const std::string& model);
/// What stands for a model in the id of a figure or table: "bem_layer".
std::string id_of_model(std::string model);

/// Display names of models as a list in a sentence: "MDR, BEM and FEM"; empty for none.
std::string display_names(const std::vector<std::string>& models);

}  // namespace tricontact::report
