"""docs/reference/performance.md: counts, and ratios of CPU times within one run of a benchmark."""

from .common import table

ALONE = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


def times(one):
    return one["cpu_time"] * {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}[one["time_unit"]]


@table("docs/reference/performance.md", "| | Value | Benchmark |")
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
                ", ".join(f"{one[key]:.0f}" for key in ("iterations", "iterations_without_start", "iterations_plain")), "benchmark_rough")
            row("its iterations over their convolutions; memory", f"{one['over_its_convolutions']:.2f}; {one['peak_memory_GB']:.2f} GB", "benchmark_rough")

    steady = of("benchmark_steady_rolling", "steady_point|driven_sphere")
    for name, what in (("cylinder/9", "cylinder of 80 cells, v tau = 9 mm"), ("cylinder/2000", "2 m"), ("sphere/9", "sphere, 9 mm")):
        one = steady(f"steady_point/{name}")
        row(f"steady rolling over relaxing rubber, {what}: products; over elastic", f"{one['products']:.0f}; {one['over_elastic']:.1f}",
            "benchmark_steady_rolling")
    for name, what in (("creeps", "steady rolling of a driven sphere on 55 x 55, 143 x 143 and 299 x 299 cells: products at a creepage"),
                       ("spins", "the same with spin")):
        row(what, ", ".join(f"{steady(f'driven_sphere/{name}/{n}')['products']:.0f}" for n in (24, 68, 146)), "benchmark_steady_rolling")

    walking = of("benchmark_walking", "avx2/|plain/|one_machine")
    for body in ("two-spot", "prism"):
        row(f"walking machines in vectors of AVX2, {body}, over no vectors",
            f"{walking('avx2/' + body)['lane_steps'] / walking('plain/' + body)['lane_steps']:.1f}", "benchmark_walking")
    row("two spots without vectors over the integrator of any machine",
        f"{walking('plain/two-spot')['lane_steps'] / walking('one_machine')['lane_steps']:.1f}", "benchmark_walking")

    finite = of("benchmark_layer", "/100/")
    step = finite("layer_rolling")
    row("layer of finite elements, h = 1 mm: staggered iterations, products a step", f"{step['normal_per_step']:.1f}, {step['tangential_per_step']:.0f}",
        "benchmark_layer")
    row("steps that cost as much as its condensation", f"{1e3 * times(finite('condensation')) / step['ms_per_step']:.0f}", "benchmark_layer")
    row("its condensation over taking it from the cache", f"{times(finite('condensation')) / times(finite('from_cache')):.0f}", "benchmark_layer")
    row("section through it over condensation", f"{times(finite('section')) / times(finite('condensation')):.2f}", "benchmark_layer")
    strained = of("benchmark_finite_strain", "strained_rolling/100")("strained_rolling")
    row("a step at finite strains: iterations; over the linear one", f"{strained['iterations']:.0f}; {strained['ms'] / strained['ms_linear']:.0f}",
        "benchmark_finite_strain")
    return rows
