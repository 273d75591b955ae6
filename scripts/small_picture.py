"""A small copy of a picture for docs/tutorials/gallery.md: 640 points wide, 96 colours, at most 40 kB.
usage: small_picture.py FROM.png TO.png [HEIGHT]    HEIGHT: of the upper part that is kept, before it is made smaller"""

import os
import sys

from PIL import Image

WIDTH, COLOURS, LARGEST = 640, 96, 40000

source, target = sys.argv[1:3]
picture = Image.open(source).convert("RGB")
if len(sys.argv) > 3:
    picture = picture.crop((0, 0, picture.width, int(sys.argv[3])))
picture = picture.resize((WIDTH, round(picture.height * WIDTH / picture.width)), Image.Resampling.LANCZOS)
# Octrees keep the thin lines' colours apart, which a median cut mixes.
picture.quantize(COLOURS, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(target, optimize=True)
if os.path.getsize(target) > LARGEST:
    sys.exit(f"error: {target}: {os.path.getsize(target)} bytes, allowed are {LARGEST}; keep less of it")
