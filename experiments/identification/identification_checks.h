#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/identification/identification_reader.h"
#include "io/keys/input_file.h"

namespace tricontact::experiments {

/// Shifts were measured, under load.normal_force and with friction.
bool is_sheared(const IdentificationInput& input);

/// The substrate is a rubber whose strains are finite: fem is no linear model.
bool is_finite_strain(const io::Document& document);

/// A length or the like of the file [SI]; throws contact::InputError where it is missing.
double quantity_of(const io::Document& document, std::string_view path);

// What the reader refuses: contact::InputError with the place in the file.
void check_models(const IdentificationInput& input, const io::Document& document);
/// Lengths of a contact are small against the indenter's radius, unless their unit is wrong.
void check_lengths(const IdentificationInput::Table& table, double radius,
                   const io::Document& document);
/// Whether the indenter is a cylinder, whose length is in indenter.length.
bool is_cylinder(const io::Document& document);
/// Hertz' theory is one of the models, and the others are laid over its radius. Loops may be those
/// of a cylinder.
void check_round(const IdentificationInput& input, const io::Document& document);
/// What the tables and models can tell. `find`: of the file.
void check_find(const IdentificationInput& input, const std::vector<std::string>& find,
                const io::Document& document);
/// Laws of friction that are compared, and what else is said of friction.
void check_laws(const IdentificationInput& input, const std::vector<std::string>& find,
                const io::Document& document);
/// Loads that rows state, and what else is said of loads. `input`: with its tables.
void check_loads(const IdentificationInput& input, const io::Document& document);
/// Whether the rows suffice for the laws' numbers beside the parameters, which `input` has.
void check_rows_of_laws(const IdentificationInput& input, const io::Document& document);
/// Whether a table of the kind follows from E alone, beside mu.
bool tells_young(IdentificationInput::Measurement measurement);
/// Springs of the interface, known or to be found: who knows them, and what determines them.
void check_interface(const IdentificationInput& input, const std::vector<std::string>& find,
                     const io::Document& document);
/// What laws and springs presume of a layer.
void check_layer_theory(const IdentificationInput& input, const io::Document& document);
/// Sliding contacts have no static shift.
void check_friction(const IdentificationInput& input, const io::Document& document);

/// What of the case does not enter, a line each: "bem-layer leaves out substrate.width: ...".
std::vector<std::string> left_out_lines(const IdentificationInput& input);

}  // namespace tricontact::experiments
