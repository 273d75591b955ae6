#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/quantities.h"
#include "comparisons/shakedown/limit_bracket.h"
#include "contact/case.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// What the limit of shakedown is looked for in, the other one given.
enum class LimitVariable {
    load,      ///< f_T = F_T/(mu F_N) at the case's amplitude
    amplitude  ///< w = W/a, a as the case's amplitude ratio has it, at the case's load
};

/// A case rolled at one value of what is varied.
struct LimitRun {
    double value = 0;
    contact::State state = contact::State::undecided;
    int periods = 0;
    double final_shift = 0;        ///< after the last period [m]
    double final_shift_ratio = 0;  ///< the same over U_max
    /// Before the period of the smallest increment: while ratcheting just beyond the limit, where
    /// the contact nearly came to rest.
    double slowest_shift_ratio = 0;
};

/// The limit of shakedown of one model.
struct ModelLimit {
    std::string model;
    bool coupled = false;
    LimitBracket bracket;
    std::vector<LimitRun> runs;
    /// Where (1/F_N) ∫ min p dA over the path equals f_T, pressed without friction: the exact limit
    /// of uncoupled contact.
    double by_pressures = 0;
    int periods_at_most = 0;  ///< of a run
    /// Of a height map without a period: the largest share of F_N on cells at its border in any
    /// run; empty for other bodies.
    std::optional<double> border_force_share = {};

    /// That limit of the continuous bodies: Hertz' (1 - 3/2 w + 1/2 w^3) or, of models of the
    /// layer, that of the exact layer. Empty where no theory covers the case.
    std::optional<double> exact;

    /// Final shift over U_max at the limit: low, after the last shakedown; value, where the first
    /// ratcheting was slowest; high, as far above it. Empty if either was not run.
    std::optional<BracketedValue> shift_ratio() const;
};

/// The limits of a case's models.
struct LimitStudy {
    std::string title;
    LimitVariable variable = LimitVariable::load;
    double given = 0;   ///< of w and f_T the one that is not varied; w over the Hertz radius
    double angle = 0;   ///< of rolling to the load [rad]
    bool round = true;  ///< paraboloid or sphere, of which MDR has a closed form
    bool relaxing = false;
    std::vector<ModelLimit> models;
    /// The thesis' limit: 1 - w or its inverse along the load (kappa = 1), with kappa = 1.1 across.
    std::optional<double> thesis;

    const Quantity& varied() const {
        return variable == LimitVariable::load ? quantities::tangential_ratio
                                               : quantities::amplitude_ratio;
    }
    const Quantity& fixed() const {
        return variable == LimitVariable::load ? quantities::amplitude_ratio
                                               : quantities::tangential_ratio;
    }
};

/// The exact limit of uncoupled contact on the body that `model` sees; see ModelLimit::exact.
/// Ratios are meant as the case's own (rolling.amplitude_reference).
std::optional<double> exact_limit(const contact::Case& c, LimitVariable variable,
                                  const std::string& model);
/// Empty where its formulas do not hold: other bodies and directions, loads that oscillate,
/// substrates that relax.
std::optional<double> thesis_limit(const contact::Case& c, LimitVariable variable);

/// limit.json, limit.csv and a table (a row per model), what the terminal shows of it, all runs,
/// and the report's content.
nlohmann::ordered_json limit_json(const std::string& version, const LimitStudy& study);
std::string limit_csv(const LimitStudy& study);
report::DocumentTable limit_table(const LimitStudy& study);
report::DocumentTable limit_run_table(const LimitStudy& study);
std::string limit_text(const LimitStudy& study);
report::Document limit_document(LimitStudy study);

}  // namespace tricontact::comparisons
