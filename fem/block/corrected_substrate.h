#pragma once

#include <memory>

#include "contact/substrates/substrate.h"
#include "fem/block/block_compliance.h"
#include "fem/block/lattice_compliance.h"

namespace tricontact::fem {

/// A block by deferred correction: steps see the lattice L plus what the block displaced otherwise
/// under the last tractions that were looked at, u = L t + correction.
struct BlockElasticity {
    std::shared_ptr<BlockCompliance> block;
    std::shared_ptr<const LatticeCompliance> lattice;
};

class CorrectedSubstrate final : public contact::Substrate {
  public:
    /// What a model and its substrate share.
    struct Correction {
        contact::SurfaceField offset;                  ///< minus the correction [m]
        contact::SurfaceField traction, displacement;  ///< of the last step [Pa], [m]
        double stored = 0;                             ///< at the end of the last step [J]
        double mismatch = 0;  ///< of the work in it and what was stored, over all turned over [-]
    };

    CorrectedSubstrate(BlockElasticity elasticity, std::shared_ptr<Correction> correction);

    std::unique_ptr<Substrate> fresh(bool) const override {
        return std::make_unique<CorrectedSubstrate>(elasticity_, correction_);
    }
    void forget() override;
    bool begin(double duration, const contact::SurfaceField& t,
               const contact::SurfaceField& u) override {
        elastic_.begin(duration, t, u);
        return false;
    }
    const contact::Compliance& compliance() const override { return *elasticity_.lattice; }
    double stiffness() const override { return 1; }
    const contact::SurfaceField& offset() const override { return correction_->offset; }
    const contact::Compliance& relaxed() const override { return *elasticity_.block; }
    /// Work is what is stored more than before, as of any elastic body; that of the tractions
    /// differs from it by the accuracy of the block's solutions: `mismatch`.
    Energies end(const contact::SurfaceField& t, const contact::SurfaceField& u) override;
    std::unique_ptr<const contact::Interior> interior(
        const contact::SurfaceField& t) const override {
        return elasticity_.block->interior(t.down, t.in_surface);
    }

  private:
    BlockElasticity elasticity_;
    std::shared_ptr<Correction> correction_;
    contact::ElasticSubstrate elastic_;  // its energies
};

}  // namespace tricontact::fem
