// The same as random_loops of rigid balls on bonded layers, half a contact diameter to five thick,
// whose loops mdr-layer makes: E, mu, k_rig and drift by models = ["layer"]. By hand, not in CI.
// usage: random_layer_loops SEED N
#include "tests/random/loops/layer_loop_rig.h"
#include "tests/random/loops/loop_draws.h"
#include "tests/random/seeded_main.h"

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check_loops<tricontact::LayerLoopRig>);
}
