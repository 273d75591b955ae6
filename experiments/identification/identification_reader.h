#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "contact/case.h"
#include "experiments/identification/adhesion/adhesive_rows.h"
#include "experiments/identification/estimation/free_parameter.h"
#include "experiments/identification/loops/measured_loop.h"
#include "io/case/case_keys.h"
#include "statistics/correlations.h"

namespace tricontact::experiments {

/// What a case with [measurement] says: a rig, what was measured on it, and who explains it.
struct IdentificationInput {
    enum class Measurement {
        static_shift,
        force_indentation,
        contact_radius,
        force_relaxation,
        indentation_creep,
        rolling_shift,
        sliding_force,
        friction_loop
    };

    /// A known input whose standard error shall be carried into the result.
    struct RigError {
        const io::CaseKey* key = nullptr;
        double standard_error = 0;  ///< [SI]
    };

    /// Errors of a table whose given values have errors as well, which count by the slope of the
    /// curve, see weigh_rows().
    struct RowErrors {
        /// Stated standard errors of what is observed and of what is given [SI], both or none.
        std::vector<double> observed, given;
        /// Of each row over that of the first one, where none are stated; empty: not known yet.
        std::vector<double> relative;
        /// What both bring to the rows' variances, over all of it, two columns for each series of
        /// rows.
        std::vector<std::vector<double>> parts;
    };

    struct Table {
        Measurement measurement = Measurement::static_shift;
        std::string data_file;                ///< as it is opened
        std::size_t place = 0;                ///< among the tables of its measurement
        std::string label;                    ///< its file as stated, of several; else empty
        std::string reading;                  ///< what of it was taken; empty: all its columns
        double held = 0;                      ///< of a history: indentation [m] or force [N]
        bool has_free_zero = false;           ///< depths count from anywhere, see zero_depth_key
        bool is_adhesive = false;             ///< surfaces attract each other
        std::vector<double> given;            ///< [SI] F_T, d, F_N, t, W, F_N or U of each row
        std::vector<double> observed;         ///< [SI] U, F_N, a, F_N, d, U, F_lim or F_T
        std::vector<double> standard_errors;  ///< [SI] of the observed; empty: not stated
        std::vector<double> normal_forces;    ///< [N] of static_shift; empty: the rig's
        MeasuredLoops loops = {};             ///< of friction_loop
        std::vector<AdhesiveWay> ways = {};   ///< of rows of surfaces that attract each other
        RowErrors row_errors = {};

        /// Over the time.
        bool is_history() const {
            return measurement == Measurement::force_relaxation ||
                   measurement == Measurement::indentation_creep;
        }
        /// Shifts while rolling are counted from any place.
        bool has_free_origin() const { return measurement == Measurement::rolling_shift; }
        /// Numbers that a fit finds for this table alone: the origin, and those of its loops.
        std::size_t n_own() const { return has_free_origin() + n_of_loop * loops.loops.size(); }
    };

    std::string title;
    std::string name;  ///< of the file
    std::vector<Table> tables;
    std::vector<FreeParameter> parameters;
    std::vector<std::string> models;  ///< see io::measurement_models
    std::vector<std::string> laws;    ///< see io::measurement_laws; empty: the rig's
    /// Shifts on a layer by theory_shifts() under Coulomb's law, too, as under other laws or on
    /// springs that are compared with it: what two methods differ by shall favour none.
    bool shifts_by_theory = false;
    double confidence = 0.95;
    /// The rig; free parameters at their guesses. A free E is a guess by Hertz' theory, whatever
    /// the file says. The normal force is that of the file, or the largest of the measurement.
    contact::Case rig;
    /// Keys of loads and rolling, in place of which the tables say what was done.
    std::vector<std::string> unread;
    std::vector<RigError> rig_errors;
    statistics::Correlations correlations;  ///< of what is uncertain, by keys
    /// 1/k_rig [m/N] of the rig in series with the contact of friction_loop, unless it is found.
    double rig_compliance = 0;
    /// Of the rig, which no model of an identification has [J/m^2], and its distance [m].
    std::optional<double> work_of_adhesion;
    double interatomic_distance = 0.3e-9;

    /// The first table; null without one.
    const Table* find(Measurement measurement) const;
    std::vector<const Table*> all(Measurement measurement) const;
    bool is_free(std::string_view key) const;
};

/// Name of the half-space among io::measurement_models.
const char* half_space_model();

/// What a model can find of them: the half-space has no thickness.
std::vector<FreeParameter> parameters_of(const IdentificationInput& input,
                                         const std::string& model);

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

/// Keys of [measurement] that name a table, in the order of Measurement.
struct TableKey {
    IdentificationInput::Measurement measurement;
    std::string_view name;  ///< "static-shift"
    std::string_view key;   ///< "measurement.static_shift"
    std::string_view held;  ///< key of what is held; empty: nothing
};
std::span<const TableKey> table_keys();
std::string_view name_of(IdentificationInput::Measurement measurement);
std::string_view key_of(IdentificationInput::Measurement measurement);
/// "static-shift", of several "static-shift (shift_5N.csv)".
std::string name_of(const IdentificationInput::Table& table);

/// What rolling_shift tells: no key of a case.
inline constexpr std::string_view pivot_key = "rig.pivot_height";
/// What force_indentation tells where its depths count from anywhere: no key of a case.
inline constexpr std::string_view zero_depth_key = "zero_depth";

/// Reads the file and the tables that it names, every value checked. Throws contact::InputError in
/// one line: `file:line:column: key = value: rule; remedy`.
IdentificationInput read_identification(const std::string& path,
                                        const std::vector<std::string>& overrides = {});

/// Reads `table.data_file`: the columns of the measurement and, if it is there, that of the
/// observed values' standard errors, `<observed>_error`. `least_rows`: those that determine what is
/// to be found by this table alone. Throws contact::InputError.
void read_measured_table(IdentificationInput::Table& table, std::size_t least_rows);

/// Depth at which a contact of this table begins, from a straight line through F^(2/3) over the
/// depth where the force is more than a quarter of its largest: Hertz' contact has it. What pulls
/// is added to the force.
double zero_depth_guess(const IdentificationInput::Table& table);

/// Of a table of surfaces that attract each other: what they pull at most by Derjaguin, Muller and
/// Toporov, by the largest tension that was measured [N], 0 without one. With it forces go as
/// Hertz' do, roughly.
double adhesive_pull(const IdentificationInput::Table& table);

/// The parameters that measurement.find names. `rig`: the case, with guesses. Throws
/// contact::InputError without a place.
std::vector<FreeParameter> free_parameters(const IdentificationInput& input,
                                           const std::vector<std::string>& find);

}  // namespace tricontact::experiments
