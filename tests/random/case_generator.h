#pragma once

#include <cstdint>
#include <string>

namespace tricontact::random_cases {

/// A case file, drawn over the whole range of what a case may say: friction from 1e-6 to 10,
/// rolling amplitudes from 0.001 to 1.2 contact radii, tangential forces up to 1 - 1e-9 of the
/// limit, Poisson's ratio from -0.9 to 0.5, radii from nm to km, moduli from Pa to TPa, layers from
/// 0.001 to 10000 contact radii; one model each, on coarse grids and over few periods. The same
/// seed and index give the same text everywhere.
std::string random_case(std::uint64_t seed, std::uint64_t index);

}  // namespace tricontact::random_cases
