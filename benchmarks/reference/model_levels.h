#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/reference/reference.h"
#include "benchmarks/reference/tabled_fields.h"
#include "contact/history.h"
#include "contact/model_makers.h"

namespace tricontact::benchmarks {

/// Where the path of a case has come to in one model on one grid.
struct EndState {
    double size = 0;  ///< of cells [m]
    contact::History history;
    contact::Scales scales;  ///< of the end
    contact::Surface surface;

    const contact::StepRecord& record() const { return history.steps.back(); }
    double dissipation() const;  ///< by friction since the first touch [J]
};

/// Runs the case in the model of this name. Throws InputError, NotConverged.
EndState end_state(const contact::ModelRunner& runner, const std::string& model,
                   const contact::Case& c);

/// The case on cells (of mdr on springs) of so many times the size; where it has fewer cells per
/// contact radius than references take, on those first.
contact::Case on_coarser_cells(contact::Case c, const std::string& model, double factor);

/// The case on three grids, each half as coarse as the one before.
std::vector<EndState> end_states(const contact::ModelRunner& runner, const std::string& model,
                                 const contact::Case& c);

/// What a state comes to by key of quantity, SI units; of line contacts per length.
std::map<std::string, double> scalars_of(const contact::Case& c, const EndState& end);

/// Extrapolated from three levels, with the bar of the grid.
std::map<std::string, ReferenceValue> values_of_levels(const contact::Case& c,
                                                       const std::vector<EndState>& levels,
                                                       const std::string& source);

/// Fields of the finest level, and as bars what the finest two differ by.
std::shared_ptr<const GridFields> fields_of_levels(const std::vector<EndState>& levels);

/// Integrals whose differences between neighbouring states make first-order effects; over the
/// contact's area [SI], of line contacts over x.
struct EnvelopeIntegrals {
    double pressure_squared = 0;  ///< ∫ p^2 dA
    double traction_squared = 0;  ///< ∫ |t|^2 dA
    double work_of_slope = 0;     ///< ∫ p h' . (u - U) dA, U the shift of the indenter
};
EnvelopeIntegrals envelope_integrals(const contact::Case& c, const EndState& end);

}  // namespace tricontact::benchmarks
