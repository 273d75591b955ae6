#pragma once

#include <optional>
#include <string>

#include "benchmarks/reference/model_levels.h"

namespace tricontact::benchmarks {

/// First-order effects of computed contacts from states beside the end of the path: on coarse
/// cells, with depths, forces or shifts a few percent apart.
class NeighbourEffects {
  public:
    /// Runs the states. `with_normal`: also those of other depths or forces. Throws InputError,
    /// NotConverged.
    NeighbourEffects(const contact::Case& c, const contact::ModelRunner& runner,
                     const std::string& model, bool with_normal);

    /// Effects and stiffnesses, where `reference` has none.
    void add_to(Reference& reference) const;

  private:
    /// The end state between two neighbours.
    struct StatesAround {
        EndState below, above;
        EnvelopeIntegrals i_below, i_above;
    };
    using Number = double (*)(const EndState&);

    StatesAround around(const contact::Case& below, const contact::Case& above) const;
    ReferenceValue slope(const StatesAround& states, Number x, double EnvelopeIntegrals::*f) const;
    ReferenceValue slope(const StatesAround& states, Number x, Number f) const;
    void add_normal(Reference& reference) const;
    void add_tangential(Reference& reference) const;
    void add_one_step(Reference& reference) const;
    bool has_datum() const { return !case_.is_line_contact() || case_.layer.thickness; }

    const contact::ModelRunner& runner_;
    std::string model_;
    contact::Case case_;
    double length_;  // of a line contact [m], else 1
    EndState here_;
    EnvelopeIntegrals i_here_;
    std::optional<StatesAround> normal_, tangential_;
    std::optional<EndState> in_one_step_;
};

}  // namespace tricontact::benchmarks
