#!/usr/bin/env python3
"""Draws a layout: all of it, and beside it a part in which the cells are seen.

    picture.py NAME.gds PICTURE.webp
"""

import io
import pathlib
import sys

import klayout.db as db
import klayout.lay as lay
from PIL import Image

# The layers from the lowest, by their numbers in GDS, each with a colour.
LAYERS = [
    (42, 0x20262E),  # n-well
    (43, 0x2E6B3E),  # active
    (46, 0xB03A3A),  # poly
    (49, 0x3F6FB5),  # metal 1
    (51, 0xC76FB0),  # metal 2
    (62, 0x4FB3BF),  # metal 3
    (31, 0xD9A441),  # metal 4
    (33, 0x8F7BD6),  # metal 5
    (37, 0xE8E3D0),  # metal 6
]
# KLayout's pattern of a filled area.
SOLID = 0
HEIGHT = 900
# The height of the part that is drawn large: a few rows of cells.
PART_UM = 45
QUALITY = (80, 60, 40, 25)
MOST_BYTES = 300_000


def view(path):
    view = lay.LayoutView()
    for key, value in (("background-color", "#0d1014"), ("grid-visible", "false"), ("text-visible", "false")):
        view.set_config(key, value)
    view.load_layout(str(path), True)
    view.max_hier()
    view.clear_layers()
    for number, colour in LAYERS:
        layer = lay.LayerProperties()
        layer.source_layer, layer.source_datatype = number, 0
        layer.fill_color = layer.frame_color = colour
        layer.dither_pattern = SOLID
        layer.width = 0
        view.insert_layer(view.end_layers(), layer)
    return view


def draw(view, box):
    width = round(HEIGHT * box.width() / box.height())
    pixels = view.get_pixels_with_options(width, HEIGHT, 1, 4, 0, box)
    return Image.open(io.BytesIO(pixels.to_png_data())).convert("RGB")


def main():
    gds, picture = (pathlib.Path(argument) for argument in sys.argv[1:3])
    layout = db.Layout()
    layout.read(str(gds))
    whole = layout.top_cell().dbbox()
    centre, half = whole.center(), PART_UM / 2
    part = db.DBox(centre.x - half, centre.y - half, centre.x + half, centre.y + half)
    images = [draw(view(gds), box) for box in (whole.enlarged(2, 2), part)]
    gap = 12
    joined = Image.new("RGB", (sum(image.width for image in images) + gap, HEIGHT), "#ffffff")
    joined.paste(images[0], (0, 0))
    joined.paste(images[1], (images[0].width + gap, 0))
    for quality in QUALITY:
        data = io.BytesIO()
        joined.save(data, "WEBP", quality=quality, method=6)
        if len(data.getvalue()) <= MOST_BYTES:
            part = picture.with_name(picture.name + ".part")
            part.write_bytes(data.getvalue())
            part.rename(picture)
            return
    sys.exit(f"picture.py: {picture} would have {len(data.getvalue())} bytes, expected at most {MOST_BYTES}")


if __name__ == "__main__":
    main()
