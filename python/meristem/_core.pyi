# SPDX-License-Identifier: Apache-2.0
# The types of the compiled half. What things do stands in their docstrings; tests/test_stubs.py holds both together.
import os
from pathlib import Path
from typing import Any, Callable, Literal, Mapping, Protocol, Sequence, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._change import Change
from ._errors import Diagnostic
from ._variable import Variable

__version__: str

class _ProgressCallback(Protocol):
    def __call__(self, stage: str, fraction: float, /) -> object: ...

_MadeApart = tuple[bytes, list[tuple[str, bytes]]]

class Progress:
    def __init__(self, callback: _ProgressCallback | None = None) -> None: ...
    def cancel(self) -> None: ...
    @property
    def cancelled(self) -> bool: ...
    @property
    def stage(self) -> str: ...
    @property
    def fraction(self) -> float: ...

class Scene:
    def __init__(self, values: Mapping[str, Any] | None = None, *, file: str | os.PathLike[str] = "") -> None: ...
    @property
    def sun(self) -> tuple[NDArray[np.float32], NDArray[np.float64]]: ...
    @property
    def sky(self) -> tuple[NDArray[np.float32], NDArray[np.float64]]: ...
    @property
    def lamps(self) -> tuple[NDArray[np.float32], NDArray[np.float64]]: ...
    @property
    def mean_direction(self) -> NDArray[np.float32]: ...
    @property
    def obstacles(self) -> list[Mesh]: ...
    def light_at(
        self, points: ArrayLike, *, threads: int = 0, progress: Progress | _ProgressCallback | None = None
    ) -> NDArray[np.float64]: ...
    def light_of_points(
        self,
        points: ArrayLike,
        *,
        radius: float = 0.3,
        k: float = 0.1,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> NDArray[np.float64]: ...
    def crown_light(
        self,
        crown: ArrayLike | Mesh,
        *,
        rays: int = 100000,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> tuple[float, NDArray[np.float64]]: ...
    def inside(
        self, points: ArrayLike, *, threads: int = 0, progress: Progress | _ProgressCallback | None = None
    ) -> NDArray[np.bool_]: ...
    def crosses(
        self,
        starts: ArrayLike,
        ends: ArrayLike,
        *,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> NDArray[np.bool_]: ...
    def first_hit(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        within: float | None = None,
        *,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> tuple[NDArray[np.float64], NDArray[np.int64]]: ...
    def blocked(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        within: float | None = None,
        *,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> NDArray[np.bool_]: ...

class Mesh:
    def __init__(self, positions: ArrayLike, triangles: ArrayLike) -> None: ...
    @property
    def positions(self) -> NDArray[np.float32]: ...
    @property
    def normals(self) -> NDArray[np.float32] | None: ...
    @property
    def uvs(self) -> NDArray[np.float32] | None: ...
    @property
    def tangents(self) -> NDArray[np.float32] | None: ...
    @property
    def triangles(self) -> NDArray[np.uint32]: ...
    @property
    def area(self) -> float: ...
    @property
    def volume(self) -> float: ...

class Material:
    @property
    def name(self) -> str: ...
    @property
    def colour(self) -> tuple[float, float, float]: ...
    @property
    def roughness(self) -> float: ...
    @property
    def translucency(self) -> float: ...
    @property
    def two_sided(self) -> bool: ...
    @property
    def picture(self) -> NDArray[np.uint8] | None: ...
    @property
    def normal_picture(self) -> NDArray[np.uint8] | None: ...

class MeshInstances:
    @property
    def component(self) -> str: ...
    @property
    def mesh(self) -> Mesh: ...
    @property
    def material(self) -> int: ...
    @property
    def frames(self) -> NDArray[np.float32]: ...
    @property
    def tints(self) -> NDArray[np.float32] | None: ...
    def __len__(self) -> int: ...

class Skeleton:
    def __init__(
        self,
        parent: ArrayLike,
        position: ArrayLike,
        *,
        radius: ArrayLike | None = None,
        axis: ArrayLike | None = None,
        order: ArrayLike | None = None,
        birth: ArrayLike | None = None,
        extra: Mapping[str, ArrayLike] | None = None,
    ) -> None: ...
    @property
    def parent(self) -> NDArray[np.int32]: ...
    @property
    def position(self) -> NDArray[np.float32]: ...
    @property
    def radius(self) -> NDArray[np.float32]: ...
    @property
    def axis(self) -> NDArray[np.uint32]: ...
    @property
    def order(self) -> NDArray[np.uint16]: ...
    @property
    def birth(self) -> NDArray[np.float32]: ...
    def keys(self) -> list[str]: ...
    def __getitem__(self, name: str) -> NDArray[Any]: ...
    def __contains__(self, name: str) -> bool: ...
    def __len__(self) -> int: ...
    def trees(self) -> list[Skeleton]: ...
    def tip_distance(self) -> NDArray[np.float32]: ...
    def measure(
        self,
        *,
        scene: Scene | None = None,
        each: bool = False,
        fork_diameter: float = 0.02,
        crown_rays: int = 100000,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> dict[str, Any]: ...
    @property
    def bounds(self) -> NDArray[np.float32] | None: ...
    @property
    def hash(self) -> str: ...
    @property
    def labels(self) -> list[str]: ...
    def save_mtg(
        self, path: str | os.PathLike[str], *, threads: int = 0, progress: Progress | _ProgressCallback | None = None
    ) -> None: ...

class Organs:
    @property
    def frame(self) -> NDArray[np.float32]: ...
    @property
    def position(self) -> NDArray[np.float32]: ...
    @property
    def component(self) -> NDArray[np.str_]: ...
    @property
    def instance(self) -> NDArray[np.uint32]: ...
    @property
    def tree(self) -> NDArray[np.int64]: ...
    @property
    def prototype(self) -> NDArray[np.uint32]: ...
    @property
    def tint(self) -> NDArray[np.float32]: ...
    @property
    def birth(self) -> NDArray[np.float32]: ...
    def __len__(self) -> int: ...

class OrganPrototype:
    @property
    def component(self) -> str: ...
    @property
    def material(self) -> int: ...
    @property
    def mesh(self) -> Mesh: ...

class Stem:
    @property
    def skeleton(self) -> Skeleton: ...
    @property
    def component(self) -> str: ...
    @property
    def parts(self) -> list[tuple[str, int]]: ...
    @property
    def part_of_axis(self) -> NDArray[np.uint32]: ...

class Plant:
    @property
    def document(self) -> Document: ...
    @property
    def warnings(self) -> tuple[Diagnostic, ...]: ...
    @property
    def stems(self) -> list[Stem]: ...
    @property
    def organs(self) -> Organs: ...
    @property
    def operations(self) -> dict[str, NDArray[Any]]: ...
    @property
    def prototypes(self) -> list[OrganPrototype]: ...
    @property
    def meshes(self) -> list[MeshInstances]: ...
    @property
    def materials(self) -> list[Material]: ...
    @property
    def node_count(self) -> int: ...
    @property
    def triangle_count(self) -> int: ...
    @property
    def bounds(self) -> NDArray[np.float32] | None: ...
    def skeleton_table(self) -> dict[str, NDArray[Any]]: ...
    def measure(
        self,
        *,
        light: bool = False,
        each: bool = False,
        scene: Scene | None = None,
        fork_diameter: float = 0.02,
        crown_rays: int = 100000,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> dict[str, Any]: ...
    def organ_light(
        self,
        *,
        scene: Scene | None = None,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> dict[str, NDArray[Any]]: ...
    def leaf_layers(
        self, height: float = 1.0, *, threads: int = 0, progress: Progress | _ProgressCallback | None = None
    ) -> dict[str, NDArray[np.float64]]: ...
    def scan(
        self,
        *,
        instrument: str | Mapping[str, Any] = "terrestrial",
        stations: ArrayLike | None = None,
        around: int | None = None,
        target: ArrayLike | None = None,
        ground: bool = False,
        obstacles: bool = True,
        seed: int | None = None,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> dict[str, NDArray[Any]]: ...
    def save_scan(
        self,
        path: str | os.PathLike[str],
        *,
        instrument: str | Mapping[str, Any] = "terrestrial",
        stations: ArrayLike | None = None,
        around: int | None = None,
        target: ArrayLike | None = None,
        ground: bool = False,
        obstacles: bool = True,
        seed: int | None = None,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> int: ...
    def save(
        self,
        path: str | os.PathLike[str],
        *,
        instanced: bool = False,
        nodes: bool = False,
        lod: int = 0,
        cards: int = 0,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> None: ...
    def packet(
        self, *, triangles: int = 0, threads: int = 0, progress: Progress | _ProgressCallback | None = None
    ) -> bytes: ...
    def render(
        self,
        *,
        size: tuple[int, int] | None = None,
        samples: int | None = None,
        view: tuple[float, float] | None = None,
        transparent: bool = False,
        hull: bool = False,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> NDArray[np.uint8]: ...
    def png(
        self,
        *,
        size: tuple[int, int] | None = None,
        samples: int | None = None,
        view: tuple[float, float] | None = None,
        transparent: bool = False,
        hull: bool = False,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> bytes: ...
    def save_picture(
        self,
        path: str | os.PathLike[str],
        *,
        size: tuple[int, int] | None = None,
        samples: int | None = None,
        view: tuple[float, float] | None = None,
        transparent: bool = False,
        hull: bool = False,
        quality: int | None = None,
        max_bytes: int | None = None,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> None: ...
    # Written in _page.py
    def to_html(
        self,
        *,
        triangles: int = 1_000_000,
        view: tuple[float, float] | None = None,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> str: ...
    def save_html(
        self,
        path: str | os.PathLike[str],
        *,
        triangles: int = 1_000_000,
        view: tuple[float, float] | None = None,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> None: ...
    # Written in _show.py
    def show(
        self,
        path: str | os.PathLike[str] | None = None,
        *,
        size: tuple[int, int] | None = None,
        samples: int | None = None,
        view: tuple[float, float] | None = None,
    ) -> Path | None: ...
    def _repr_png_(self) -> bytes: ...

class Document:
    def __init__(
        self,
        content: str | Mapping[str, Any],
        *,
        file: str | os.PathLike[str] = "",
        set: Mapping[str, Any] | None = None,
        seed: int | None = None,
    ) -> None: ...
    def set(self, values: Mapping[str, Any] | None = None, *, seed: int | None = None) -> Document: ...
    def grow(
        self,
        time: float = 0.0,
        *,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> Plant: ...
    def save_animated(
        self,
        path: str | os.PathLike[str],
        *,
        keys: int = 16,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> None: ...
    def bundle(self) -> tuple[str, list[tuple[str, bytes]]]: ...
    def save(self, path: str | os.PathLike[str]) -> None: ...
    def to_dict(self) -> dict[str, Any]: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def text(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def description(self) -> str: ...
    @property
    def author(self) -> str: ...
    @property
    def licence(self) -> str: ...
    @property
    def file(self) -> str: ...
    @property
    def seed(self) -> int: ...
    @property
    def variables(self) -> list[Variable]: ...
    @property
    def components(self) -> dict[str, str]: ...
    @property
    def warnings(self) -> tuple[Diagnostic, ...]: ...
    @property
    def scene(self) -> Scene: ...
    def _repr_markdown_(self) -> str: ...  # written in _show.py

class DatasetPlan:
    def __init__(
        self, content: str | Mapping[str, Any], *, file: str = "<python>", documents: Mapping[str, Document] = {}
    ) -> None: ...
    def __len__(self) -> int: ...
    def plant(self, number: int) -> dict[str, Any]: ...
    def make(
        self, folder: str, begin: int, end: int, *, progress: Progress | _ProgressCallback | None = None
    ) -> tuple[float, _MadeApart | None]: ...
    @property
    def hash(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def columns(self) -> list[str]: ...
    @property
    def warnings(self) -> tuple[Diagnostic, ...]: ...

class DatasetFolder:
    def __init__(
        self,
        plan: DatasetPlan,
        folder: str | os.PathLike[str],
        *,
        opening: str = "resume",
        progress: Progress | _ProgressCallback | None = None,
    ) -> None: ...
    def next(self, seconds: float = 0.5) -> tuple[int, int] | None: ...
    def add(self, begin: int, end: int, seconds: float, apart: _MadeApart | None = None) -> None: ...
    def finish(self, *, progress: Progress | _ProgressCallback | None = None) -> None: ...
    def __len__(self) -> int: ...
    @property
    def path(self) -> str: ...
    @property
    def done(self) -> int: ...
    @property
    def found(self) -> int: ...
    @property
    def faults(self) -> list[str]: ...
    @property
    def seconds_per_plant(self) -> float: ...

def verify_dataset(
    folder: str | os.PathLike[str], *, threads: int = 0, progress: Progress | _ProgressCallback | None = None
) -> dict[str, Any]: ...

class Session:
    def __init__(
        self,
        content: str | Mapping[str, Any] | Document,
        *,
        file: str | os.PathLike[str] = "",
        set: Mapping[str, Any] | None = None,
        seed: int | None = None,
        root: str | os.PathLike[str] = "",
    ) -> None: ...
    @staticmethod
    def open(
        path: str | os.PathLike[str],
        *,
        set: Mapping[str, Any] | None = None,
        seed: int | None = None,
        root: str | os.PathLike[str] = "",
    ) -> Session: ...
    def edit(self, values: Mapping[str, Any]) -> Change: ...
    def set(self, path: str, value: Any) -> Change: ...
    def unset(self, path: str) -> Change: ...
    def insert(self, path: str, value: Any, index: int | None = None) -> Change: ...
    def remove(self, path: str) -> Change: ...
    def rename(self, path: str, name: str) -> Change: ...
    def move(self, path: str, index: int) -> Change: ...
    def note(self, path: str, note: str) -> Change: ...
    def paste(
        self,
        part: str,
        *,
        names: Mapping[str, str] = {},
        index: int | None = None,
        link_index: int | None = None,
    ) -> Change: ...
    def edit_text(self, patch: Sequence[tuple[int, int, str]]) -> Change: ...
    def undo(self) -> Change | None: ...
    def redo(self) -> Change | None: ...
    def preview(self, values: Mapping[str, Any] | None = None) -> None: ...
    def reload(self) -> None: ...
    def part(self, components: Sequence[str]) -> str: ...
    def save(self, path: str | os.PathLike[str]) -> None: ...
    def grow(
        self,
        time: float = 0.0,
        *,
        threads: int = 0,
        progress: Progress | _ProgressCallback | None = None,
    ) -> Plant: ...
    @property
    def text(self) -> str: ...
    @property
    def file(self) -> str: ...
    @property
    def notes(self) -> dict[str, str]: ...
    @property
    def document(self) -> Document | None: ...
    @property
    def faults(self) -> tuple[Diagnostic, ...]: ...
    @property
    def is_good(self) -> bool: ...
    @property
    def undo_count(self) -> int: ...
    @property
    def redo_count(self) -> int: ...
    @property
    def difference(self) -> dict[str, list[str]]: ...

def read(
    path: str | os.PathLike[str], *, set: Mapping[str, Any] | None = None, seed: int | None = None
) -> Document: ...
def models() -> list[str]: ...
def read_mtg(
    path: str | os.PathLike[str],
    *,
    coordinates: Sequence[str] = ["XX", "YY", "ZZ"],
    diameter: str = "",
    unit: float = 1.0,
    diameter_unit: float | None = None,
) -> Skeleton: ...
def read_skeleton(
    path: str | os.PathLike[str],
    *,
    unit: float = 1.0,
    diameter_unit: float | None = None,
    up: str = "file",
    at_origin: bool = True,
) -> Skeleton: ...
def convex_hull(
    points: ArrayLike, *, threads: int = 0, progress: Progress | _ProgressCallback | None = None
) -> Mesh: ...
def tubes(
    skeleton: Skeleton,
    *,
    sides: int = 8,
    error: float = 0.03,
    uv_scale: float = 1.0,
    smooth: float = 3.0,
    collar: float = 0.8,
    flare: float = 0.5,
    cap: Literal["pointed", "round", "flat"] = "pointed",
    threads: int = 0,
    progress: Progress | _ProgressCallback | None = None,
) -> Mesh: ...
def colonize(
    points: ArrayLike,
    roots: ArrayLike = (0, 0, 0),
    *,
    step: float = 0.05,
    influence: float = 0.6,
    kill: float = 0.3,
    iterations: int = 1000,
    bias: ArrayLike = (0, 0, 0),
    tip_radius: float = 0.004,
    pipe_exponent: float = 2.4,
    finish: Mapping[str, Any] | None = None,
    light: Mapping[str, Any] | None = None,
    shed: str | None = None,
    scene: Scene | None = None,
    seed: int = 1,
    threads: int = 0,
    progress: Progress | _ProgressCallback | None = None,
) -> Skeleton: ...

class Word:
    def __len__(self) -> int: ...
    def __str__(self) -> str: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def letters(self) -> NDArray[np.uint16]: ...
    @property
    def parameters(self) -> NDArray[np.float64]: ...
    @property
    def alphabet(self) -> list[tuple[str, int]]: ...
    @property
    def counts(self) -> dict[str, int]: ...

def derive(
    grammar: str | os.PathLike[str],
    steps: int | None = None,
    *,
    time: float | None = None,
    seed: int = 1,
    constants: Mapping[str, float] | None = None,
    drawn: bool = False,
    threads: int = 0,
    progress: Progress | _ProgressCallback | None = None,
) -> Word: ...

# --- the stages of a grass leaf, which meristem.grass offers ---

_Rate = float | Callable[[float, float], float]

class GrassLeaf:
    def __init__(
        self, length: float, width: float, s: ArrayLike, x: ArrayLike, y: ArrayLike, r: ArrayLike
    ) -> None: ...
    @property
    def length(self) -> float: ...
    @property
    def width(self) -> float: ...
    @property
    def s(self) -> NDArray[np.float64]: ...
    @property
    def x(self) -> NDArray[np.float64]: ...
    @property
    def y(self) -> NDArray[np.float64]: ...
    @property
    def r(self) -> NDArray[np.float64]: ...
    @property
    def area(self) -> float: ...
    @property
    def angles(self) -> NDArray[np.float64]: ...
    @property
    def inclination(self) -> float: ...
    def __len__(self) -> int: ...
    def __eq__(self, other: object) -> bool: ...

class MeasuredCurve:
    @property
    def rank(self) -> int | None: ...
    @property
    def lindex(self) -> int | None: ...
    @property
    def age(self) -> float | None: ...
    @property
    def points(self) -> NDArray[np.float64]: ...
    @property
    def lines(self) -> NDArray[np.int32]: ...
    def __len__(self) -> int: ...

class FittedLeaf:
    @property
    def leaf(self) -> GrassLeaf: ...
    @property
    def midrib_length(self) -> float: ...
    @property
    def polyline_length(self) -> float: ...
    @property
    def distance(self) -> float: ...
    @property
    def was_turned(self) -> bool: ...

class MidribFamily:
    @overload
    def __init__(self, midribs: GrassLeaf) -> None: ...
    @overload
    def __init__(self, midribs: Sequence[tuple[float, GrassLeaf]]) -> None: ...
    @property
    def first_age(self) -> float: ...
    @property
    def last_age(self) -> float: ...
    @property
    def piece_count(self) -> int: ...
    def angles(self, age: float) -> NDArray[np.float64]: ...

class ReductionOrder:
    @property
    def points(self) -> NDArray[np.uint32]: ...
    @property
    def errors(self) -> NDArray[np.float64]: ...
    def __len__(self) -> int: ...

def read_midribs(path: str | os.PathLike[str]) -> list[MeasuredCurve]: ...
def read_widths(path: str | os.PathLike[str]) -> list[MeasuredCurve]: ...
def fit_leaf(
    x: ArrayLike,
    y: ArrayLike,
    s: ArrayLike,
    r: ArrayLike,
    *,
    smoothing: float = 0.0025,
    width_smoothing: float = 0.01,
    pieces: int = 48,
) -> FittedLeaf: ...
def resampled(leaf: GrassLeaf, pieces: int) -> GrassLeaf: ...
def widths_by_area(leaf: GrassLeaf) -> NDArray[np.float64]: ...
def visible_share(age: float, *, full_age: float = 1.0) -> float: ...
def aged(leaf: GrassLeaf, family: MidribFamily, age: float, *, full_age: float = 1.0) -> GrassLeaf: ...
def lived(
    leaf: GrassLeaf,
    family: MidribFamily,
    time: float,
    step: float,
    *,
    age: _Rate = 1.0,
    length: _Rate = 1.0,
    width: _Rate = 1.0,
    bend: _Rate = 1.0,
    full_age: float = 1.0,
) -> GrassLeaf: ...
def turned(leaf: GrassLeaf, turns: Sequence[tuple[float, float, float]]) -> GrassLeaf: ...
def inclined(leaf: GrassLeaf, angle: float) -> GrassLeaf: ...
def loaded(
    leaf: GrassLeaf,
    *,
    stiffness: float = 0.3,
    tip_thickness: float = 0.3,
    pull: tuple[float, float] = (0.0, 0.0),
    wind: tuple[float, float] = (0.0, 0.0),
    gravity: tuple[float, float] = (0.0, -1.0),
    measured_gravity: tuple[float, float] = (0.0, -1.0),
) -> GrassLeaf: ...
def load_for_turn(
    leaf: GrassLeaf,
    place: float,
    angle: float,
    *,
    stiffness: float = 0.3,
    tip_thickness: float = 0.3,
    pull: tuple[float, float] = (0.0, 0.0),
    wind: tuple[float, float] = (0.0, 0.0),
    gravity: tuple[float, float] = (0.0, -1.0),
) -> float: ...
def reduction_order(leaf: GrassLeaf, also: Sequence[ArrayLike] = []) -> ReductionOrder: ...
def points_kept(order: ReductionOrder, pieces: int) -> NDArray[np.uint32]: ...
def points_within(order: ReductionOrder, error: float) -> NDArray[np.uint32]: ...
def reduced(
    leaf: GrassLeaf,
    *,
    pieces: int | None = None,
    error: float | None = None,
    points: ArrayLike | None = None,
) -> GrassLeaf: ...
def make_grass_blade(
    leaf: GrassLeaf,
    *,
    twist: float = 0.0,
    twist_along: ArrayLike | None = None,
    fold: float = 0.0,
    roll: float = 0.0,
    waves: Mapping[str, float] = {},
    across: int = 2,
    clasp: float = 0.0,
    clasp_radius: float = 0.0,
    displace: Callable[[float, float], ArrayLike] | None = None,
) -> Mesh: ...
def make_sheath(open: float) -> Mesh: ...
def make_ligule() -> Mesh: ...
def shade(
    plant: Plant,
    *,
    facade: str | int | Mapping[str, Any] | None = None,
    panels: Mapping[str, Any] | None = None,
    ground: Sequence[Any] | Mapping[str, Any] | None = None,
    days: Any,
    hours: Any = "0:23:1",
    spacing: float = 0.25,
    latitude: float | None = None,
    longitude: float | None = None,
    utc_offset: float | None = None,
    threads: int = 0,
    progress: Progress | _ProgressCallback | None = None,
) -> dict[str, Any]: ...

# Numbers give numbers and arrays arrays; mypy warns because a number is an ArrayLike too.
@overload
def sun_position(latitude: float, day: float, hour: float) -> tuple[float, float]: ...  # type: ignore[misc]
@overload
def sun_position(
    latitude: ArrayLike, day: ArrayLike, hour: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
@overload
def daylight(latitude: float, day: float) -> tuple[float, float] | None: ...  # type: ignore[misc]
@overload
def daylight(latitude: ArrayLike, day: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
@overload
def declination(day: float) -> float: ...  # type: ignore[misc]
@overload
def declination(day: ArrayLike) -> NDArray[np.float64]: ...
def unit_vector(azimuth: ArrayLike, altitude: ArrayLike) -> NDArray[np.float32]: ...
def components() -> dict[str, Any]: ...
def parameter_tables() -> dict[str, Any]: ...
def schema() -> dict[str, Any]: ...
def load_plugin(path: str | os.PathLike[str]) -> None: ...
