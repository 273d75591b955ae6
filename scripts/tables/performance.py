"""docs/performance.md: counts, and ratios of CPU times within one run of a benchmark."""

from .common import table

ALONE = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


def times(one):
    return one["cpu_time"] * {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}[one["time_unit"]]


@table("docs/performance.md", "| | Value | Benchmark |")
def performance(program):
    rows = []

    def of(binary, names):
        found = program.benchmarks(binary, names, **ALONE)
        return lambda name: next(one for key, one in found.items() if key.startswith(name))

    def row(what, value, command):
        rows.append([what, value, f"`{command}`"])

    rolling = of("benchmark_rolling", "bem_rolling|contact_product|preconditioner")
    row("products among the points in contact, a rolling step of `bem`", f"{rolling('bem_rolling/half:1')['convolutions_per_step']:.1f}",
        "benchmark_rolling")
    for name, what in (("bem_rolling", "step"), ("contact_product", "product"), ("preconditioner", "preconditioner")):
        row(f"its {what} with the whole grid, over the half that y = 0 mirrors",
            f"{times(rolling(name + '/half:0')) / times(rolling(name + '/half:1')):.1f}", "benchmark_rolling")
    row("a preconditioner over a product", f"{times(rolling('preconditioner/half:1')) / times(rolling('contact_product/half:1')):.1f}",
        "benchmark_rolling")

    layer = of("benchmark_bem_layer", ".")
    point = layer("coupled_shakedown_point")
    row("coupled layer point: steps; iterations of normal, of tangential contact",
        ", ".join(f"{point[key]:.0f}" for key in ("steps", "normal", "tangential")), "benchmark_bem_layer")
    row("its influence coefficients over all of it", f"{times(layer('layer_coefficients')) / times(point):.2f}", "benchmark_bem_layer")
    elastic = times(layer("rolling_with_branches/0/"))
    for name, what in (("rolling_with_branches", "all relaxes"), ("rolling_where_a_part_relaxes", "a part relaxes")):
        row(f"{what}, one and three branches, over elastic",
            ", ".join(f"{times(layer(f'{name}/{n}/')) / elastic:.1f}" for n in (1, 3)), "benchmark_bem_layer")

    rough = of("benchmark_rough", "rough_contact/cells:(512|1024)")
    for free, what in ((0, "periodic"), (1, "free")):
        for cells in (512, 1024):
            one = rough(f"rough_contact/cells:{cells}/per_wave:{cells // 64}/free:{free}/")
            row(f"rough contact, {what}, {cells} cells a side: iterations; without coarser grids; before their method",
                ", ".join(f"{one[key]:.0f}" for key in ("iterations_needed", "iterations_without_start", "iterations_plain")), "benchmark_rough")
            row("its iterations over their convolutions; memory", f"{one['over_its_convolutions']:.2f}; {one['peak_GB']:.2f} GB", "benchmark_rough")

    steady = of("benchmark_steady_rolling", "steady_point")
    for name, what in (("cylinder/9", "cylinder of 80 cells, v tau = 9 mm"), ("cylinder/2000", "2 m"), ("sphere/9", "sphere, 9 mm")):
        one = steady(f"steady_point/{name}")
        row(f"steady rolling over relaxing rubber, {what}: products; over elastic", f"{one['products']:.0f}; {one['over_elastic']:.1f}",
            "benchmark_steady_rolling")
    return rows
