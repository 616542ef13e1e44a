# SPDX-License-Identifier: Apache-2.0
"""Grows plants from documents.

    import meristem

    plant = meristem.read("oak", set={"age": 40}, seed=3).grow()
    plant.save("oak.glb")
    print(plant.measure()["height"])

Lengths are metres and angles degrees; y points up, x east, z south. Arrays over the memory of plants are read-only, and
stay valid as long as they are kept.
"""

from . import grass
from ._batch import BatchResult, batch
from ._change import Change
from ._collect import collect
from ._core import (
    DatasetFolder,
    DatasetPlan,
    Document,
    Material,
    Mesh,
    MeshInstances,
    OrganPrototype,
    Organs,
    Plant,
    Progress,
    Scene,
    Session,
    Skeleton,
    Stem,
    Trace,
    Word,
    __commit__,
    __version__,
    colonize,
    components,
    convex_hull,
    daylight,
    declination,
    derive,
    load_plugin,
    models,
    parameter_tables,
    read,
    read_mtg,
    read_skeleton,
    schema,
    shade,
    sun_position,
    tubes,
    unit_vector,
    verify_dataset,
)
from ._dataset import Dataset, dataset, open_dataset
from ._errors import Cancelled, Diagnostic, Error, InputError, MachineError
from ._fit import FitPoint, FitProgress, FitResult, fit
from ._page import save_html, to_html
from ._show import describe, make_preview, show
from ._target import Target
from ._variable import Variable

# Methods of compiled classes that are written here
setattr(Plant, "show", show)
setattr(Plant, "to_html", to_html)
setattr(Plant, "save_html", save_html)
setattr(Plant, "_repr_png_", make_preview)
setattr(Document, "_repr_markdown_", describe)

__all__ = [
    "BatchResult",
    "Cancelled",
    "Change",
    "Dataset",
    "DatasetFolder",
    "DatasetPlan",
    "Diagnostic",
    "Document",
    "Error",
    "FitPoint",
    "FitProgress",
    "FitResult",
    "InputError",
    "MachineError",
    "Material",
    "Mesh",
    "MeshInstances",
    "OrganPrototype",
    "Organs",
    "Plant",
    "Progress",
    "Scene",
    "Session",
    "Skeleton",
    "Stem",
    "Target",
    "Trace",
    "Variable",
    "Word",
    "__commit__",
    "__version__",
    "batch",
    "collect",
    "colonize",
    "components",
    "convex_hull",
    "dataset",
    "daylight",
    "declination",
    "derive",
    "fit",
    "grass",
    "load_plugin",
    "models",
    "open_dataset",
    "parameter_tables",
    "read",
    "read_mtg",
    "read_skeleton",
    "schema",
    "shade",
    "sun_position",
    "tubes",
    "unit_vector",
    "verify_dataset",
]
