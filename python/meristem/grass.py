# SPDX-License-Identifier: Apache-2.0
"""A function for each stage of a grass leaf: measured points become a leaf, which ages, bends, and gets a surface.

    from meristem import grass

    x, y = [0, 0.02, 0.10, 0.25], [0, 0.15, 0.30, 0.36]  # a digitised midrib, metres
    s, r = [0, 0.5, 1], [0.9, 1, 0]                      # widths along the blade
    fitted = grass.fit_leaf(x, y, s, r)
    young = grass.aged(fitted.leaf, grass.MidribFamily(fitted.leaf), 0.6)
    mesh = grass.make_grass_blade(grass.reduced(young, pieces=12), twist=40)

Based on: C. Fournier, C. Pradal: A plastic, dynamic and reducible 3D geometric model for simulating gramineous leaves
(PMA 2012).
"""

from ._core import (
    FittedLeaf,
    GrassLeaf,
    MeasuredCurve,
    MidribFamily,
    ReductionOrder,
    aged,
    fit_leaf,
    inclined,
    lived,
    load_for_turn,
    loaded,
    make_grass_blade,
    make_ligule,
    make_sheath,
    points_kept,
    points_within,
    read_midribs,
    read_widths,
    reduced,
    reduction_order,
    resampled,
    turned,
    visible_share,
    widths_by_area,
)

__all__ = [
    "FittedLeaf",
    "GrassLeaf",
    "MeasuredCurve",
    "MidribFamily",
    "ReductionOrder",
    "aged",
    "fit_leaf",
    "inclined",
    "lived",
    "load_for_turn",
    "loaded",
    "make_grass_blade",
    "make_ligule",
    "make_sheath",
    "points_kept",
    "points_within",
    "read_midribs",
    "read_widths",
    "reduced",
    "reduction_order",
    "resampled",
    "turned",
    "visible_share",
    "widths_by_area",
]
