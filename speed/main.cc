#include <benchmark/benchmark.h>

#include "contact/base/freed_memory.h"

int main(int argc, char** argv) {
    tricontact::contact::keep_freed_memory();  // as the program does
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
