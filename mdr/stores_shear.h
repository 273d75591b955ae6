#pragma once

namespace tricontact::mdr {

/// A model whose normal and tangential contact do not couple, and neither do their energies.
class StoresShear {
  public:
    virtual ~StoresShear() = default;
    /// Elastic energy of the tangential contact in the present state [J].
    virtual double shear_energy() const = 0;
};

}  // namespace tricontact::mdr
