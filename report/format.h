#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/base/number_text.h"

namespace tricontact::report {

using contact::quantity;
using contact::significant;
using contact::with_error;

/// A given number for people: at most six significant digits, no trailing zeros.
std::string as_given(double value);

/// HTML of a plain sentence: escaped, symbols of one letter with an index ("f_T"), Greek letters by
/// name ("mu"), powers ("a^2", "x^(1/3)"), ">=", "<=" and minus signs between spaces typeset, no
/// line break around "=" or before a unit.
std::string typeset(const std::string& sentence);

/// The same with a capital as its first letter, where that is a letter of ASCII.
std::string capitalised(std::string text);

/// A ratio minus one in percent with its sign ("+16.5 %"); an en dash where undefined.
std::string percent(std::optional<double> ratio);

/// A part of a whole, or the size of a relative error, in percent: "2.3 %"; "below 0.001 %" where
/// its digits would be hard to count; an en dash where undefined.
std::string share(double part, int digits = 2);
/// A relative difference in percent with its sign: "+1.45 %".
std::string signed_share(double part, int digits = 3);

/// The probability of chance for sentences: "p = 0.23", "p < 0.001" below that.
std::string p_value(double p);
/// The same in a column headed "p": "0.23", "< 0.001"; an en dash where undefined.
std::string p_number(double p);

/// By how much a ratio is off 1: "3.19 % larger".
std::string apart(double ratio, const std::string& more, const std::string& less);

/// An SI unit with the prefix that keeps a magnitude between 1 and 1000.
struct Unit {
    double factor = 1;  ///< SI value / number
    std::string symbol;
};
Unit fitting_unit(double magnitude, const std::string& base);

/// A given number and its unit, without trailing zeros: "8 mm".
std::string given_quantity(double value, const std::string& base);

/// "mdr" -> "MDR", "bem-layer" -> "BEM layer".
std::string display_name(const std::string& model);
/// The number of a model's colour, the same in every figure: of "bem-layer" or "BEM layer". Empty
/// for what is no model.
std::optional<int> model_style(const std::string& model);
/// What stands for a model in the id of a figure or table: "bem_layer".
std::string id_of_model(std::string model);

/// Display names of models as a list in a sentence: "MDR, BEM and FEM"; empty for none.
std::string display_names(const std::vector<std::string>& models);

}  // namespace tricontact::report
