#pragma once

#include <vector>

#include "contact/bodies/height_map.h"
#include "contact/case.h"

namespace tricontact::contact {

/// Power spectral density of a surface, mean over all directions: C with ∫ C d^2q = mean square of
/// the heights over their mean. Of rings as wide as the longest wave is short, the zeroth left out.
struct HeightSpectrum {
    std::vector<double> wave_number;  ///< q [1/m], mean over the waves of a ring, increasing
    std::vector<double> density;      ///< C [m^4]
};

/// What is beyond the edges of a map: itself again, or nothing that is known.
enum class MapEdges { repeat, open };

/// From the map's Fourier coefficients up to the wave number of two nodes per wave. A map with open
/// edges loses its mean plane and is tapered by Hann's window of mean square 1 in both directions
/// (Jacobs, Junge and Pastewka 2017, Surf. Topogr. 5, 013001): its longest waves are blurred.
HeightSpectrum height_spectrum(const HeightMap& map, MapEdges edges);

/// Of a rough case: of its height map, or of its synthetic roughness as the cells sample it.
HeightSpectrum surface_spectrum(const Case& c);

}  // namespace tricontact::contact
