# SPDX-License-Identifier: Apache-2.0
"""Pictures of a scanned oak for the manual: points as pixels, the nearest in front."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Mapping

import matplotlib
import meristem
import numpy as np
from numpy.typing import NDArray
from PIL import Image

SIZE = (620, 570)  #: width and height, pixels
WIDTH = 9.0  #: width of the picture, metres
GROUND = -0.35  #: height of the picture's lower edge, metres
COLOURS = {"ground": (0.72, 0.70, 0.66), "wood": (0.42, 0.28, 0.16), "organ": (0.30, 0.52, 0.18), "obstacle": (0.5, 0.5, 0.5)}
MOST_ERROR = 0.03  #: metres


def save_in_few_colours(image: Image.Image, path: Path) -> None:
    """Saves a PNG with a palette, which halves the size of pictures with few colours."""
    image.convert("RGB").quantize(48, dither=Image.Dither.NONE).save(path, optimize=True)


def draw_points(path: Path, position: NDArray[Any], colour: NDArray[Any]) -> None:
    """Draws the view from the south without perspective."""
    width, height = SIZE
    image = np.ones((height, width, 3))
    metre = width / WIDTH
    column = np.floor(width / 2 + metre * position[:, 0]).astype(int)
    row = np.floor(height - metre * (position[:, 1] - GROUND)).astype(int)
    nearest_last = np.argsort(position[:, 2], kind="stable")
    for right in (0, 1):
        for down in (0, 1):
            x, y = column[nearest_last] + right, row[nearest_last] + down
            inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
            image[y[inside], x[inside]] = colour[nearest_last][inside]
    save_in_few_colours(Image.fromarray((255 * np.clip(image, 0, 1)).astype(np.uint8)), path)


def mapped(values: NDArray[Any], most: float, name: str) -> NDArray[np.float64]:
    colours: NDArray[np.float64] = matplotlib.colormaps[name](np.clip(values / most, 0, 1))[:, :3]
    return colours


def draw_oak(folder: Path, step: float) -> None:
    oak = meristem.read("oak").grow()
    scan: Mapping[str, NDArray[Any]] = oak.scan(
        instrument={"kind": "terrestrial", "step": step, "farthest": 25}, around=4, ground=True
    )
    position = scan["position"]
    inside = (np.abs(position[:, 0]) < WIDTH / 2 + 0.5) & (np.abs(position[:, 2]) < WIDTH / 2 + 0.5)
    kinds = np.array([COLOURS[kind] for kind in scan["kind"][inside]])
    # Far points are lighter, so that the crown shows depth.
    depth = np.clip((position[inside, 2] + 4) / 8, 0, 1)[:, None]
    draw_points(folder / "oak-kind.png", position[inside], kinds * (0.65 + 0.35 * depth) + 0.12 * (1 - depth))
    wood = scan["kind"] == "wood"
    draw_points(folder / "oak-order.png", position[wood], mapped(scan["order"][wood], 8, "viridis"))
    plant = inside & (scan["kind"] != "ground")
    error = np.abs(scan["range"] - scan["true_range"])[plant]
    draw_points(folder / "oak-error.png", position[plant], mapped(error, MOST_ERROR, "magma_r"))
