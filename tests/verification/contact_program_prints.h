// What the program CONTACT prints for its own examples, where several tests compute them.

#pragma once

#include <array>

namespace tricontact::test {

/// catt_to_cart, cases 59 to 73: shift of each rolled step [mm].
inline constexpr std::array catt_to_cart_shifts{4.548e-4, 4.705e-4, 4.886e-4, 5.125e-4, 5.349e-4,
                                                5.552e-4, 5.835e-4, 6.069e-4, 6.377e-4, 6.690e-4,
                                                7.003e-4, 7.419e-4, 7.960e-4, 8.508e-4, 8.505e-4};

}  // namespace tricontact::test
