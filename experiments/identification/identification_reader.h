#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "contact/case.h"
#include "io/case/case_keys.h"

namespace tricontact::experiments {

/// What a case with [measurement] says: a rig, what was measured on it, and who explains it.
struct IdentificationInput {
    enum class Measurement { static_shift, force_indentation, contact_radius };

    /// A known input whose standard error shall be carried into the result.
    struct RigError {
        const io::CaseKey* key = nullptr;
        double standard_error = 0;  ///< [SI]
    };

    std::string title;
    std::string name;  ///< of the file
    Measurement measurement = Measurement::static_shift;
    std::vector<std::string> models;  ///< "half-space", "layer", "bem-layer", "fem"
    double confidence = 0.95;
    /// The rig; of E and mu, those that are not free are the file's. A free E is a guess by Hertz'
    /// theory, whatever the file says. The normal force is that of the file, or the largest of the
    /// measurement.
    contact::Case rig;
    bool young_is_free = true;
    bool friction_is_free = false;  ///< only a shift tells it
    std::vector<RigError> rig_errors;

    std::string data_file;                ///< as it is opened
    std::vector<double> given;            ///< [SI] F_T, d or F_N of each row
    std::vector<double> observed;         ///< [SI] U, F_N or a
    std::vector<double> standard_errors;  ///< [SI] of the observed; empty: not stated
};

/// A column of a measurement.
struct MeasuredColumn {
    std::string_view name;  ///< "tangential_force"
    std::string_view axis;  ///< its name for axes: "tangential force F_T"
    io::Dimension dimension;
    std::string_view unit = io::si_unit(dimension);
};
struct MeasuredColumns {
    MeasuredColumn given, observed;
    std::string_view example;  ///< a header
};
const MeasuredColumns& columns_of(IdentificationInput::Measurement measurement);
/// "static-shift" ...
std::string_view name_of(IdentificationInput::Measurement measurement);

/// Reads the file and the table that it names, every value checked. Throws contact::InputError in
/// one line: `file:line:column: key = value: rule; remedy`.
IdentificationInput read_identification(const std::string& path,
                                        const std::vector<std::string>& overrides = {});

/// Reads `input.data_file`: the columns of the measurement and, if it is there, that of the
/// observed values' standard errors, `<observed>_error`. Throws contact::InputError.
void read_measured_table(IdentificationInput& input);

}  // namespace tricontact::experiments
