// Fretting rigs drawn at random: a sphere on a half-space, a spring of unknown stiffness in series,
// friction that drifts or not, offsets that drift, noise of force and shift, stated or not. A few
// cycles under two loads at two amplitudes each - closed loops, partial slip, gross slip, and
// cycles of which only some slide - are made by springs that are driven step by step. E, mu, k_rig
// and drift are found together: intervals of 95 % hold in 93 to 97 %, within the scatter of the
// draws, those of energies and of friction over the cycles as well; regimes are named rightly in
// 97 %. usage: random_loops SEED N
#include "tests/random/loops/loop_draws.h"
#include "tests/random/loops/loop_rig.h"
#include "tests/random/seeded_main.h"

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check_loops<tricontact::LoopRig>);
}
