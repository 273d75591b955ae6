"""A limit run that settles up to w = .26 and ratchets from .29 on: a lens of 10 mm on silicone of 1.8 MPa under 0.5 N.
usage: limit_record.py FILE"""
import random
import sys

noise = random.Random(3)
radius = (3 * 0.5 * 0.01 / (4 * 2.4e6)) ** (1 / 3)
samples, rest, period = 80, 600, 4.0  # of a period; of the rests; [s]
with open(sys.argv[1], "w", encoding="utf-8") as table:
    table.write("time [s], shift [um], drive [mm]\n")
    row, level = 0, 250.0

    def put(shift, drive):
        global row
        table.write(f"{row * period / samples:.2f}, {shift + noise.gauss(0, 0.05):.3f}, {drive:.5f}\n")
        row += 1

    for _ in range(rest):
        put(level, 0)
    for w in (0.20, 0.23, 0.26, 0.29, 0.32):
        for n in range(8):
            rise = 6 * 0.4**n + (5 if w > 0.27 else 0)
            for k in range(samples):
                phase = k / samples
                drive = 4 * phase if phase < 0.25 else 2 - 4 * phase if phase < 0.75 else 4 * phase - 4
                put(level + rise * phase, 1e3 * w * radius * drive)
            level += rise
    for _ in range(rest):
        put(level, 0)
