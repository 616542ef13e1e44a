# SPDX-License-Identifier: Apache-2.0
"""Opens binary glTF files in Blender and checks that everything was imported.

    blender -b -P docs/blender_check.py -- oak.glb [more.glb ...] [--component leaf] [--leaves N]

Prints the numbers of objects, triangles, parts of the leaves and materials with pictures in Blender. Ends with code 1
if triangles or materials differ from the file. Parts are connected pieces of the meshes of the component, flattened or
not; a leaf with a stalk has two. With --leaves N, the leaf_count of `meristem measure --json`, each of the N leaves
must have an equal whole number of parts.
"""
import argparse
import json
import math
import struct
import sys

import bpy
import numpy

# Debian 12 has Blender 3.4 with a NumPy that lacks the name that the glTF importer uses.
if not hasattr(numpy, "bool"):
    numpy.bool = bool


def read_json(path):
    """Returns the JSON chunk of a binary glTF."""
    with open(path, "rb") as file:
        magic, _, _, length, _ = struct.unpack("<4s4I", file.read(20))
        if magic != b"glTF":
            sys.exit(f"{path} is not a binary glTF")
        return json.loads(file.read(length))


def told_by(path):
    """Returns the numbers in the file: triangles with all instances, and materials with pictures."""
    gltf = read_json(path)
    accessors = gltf.get("accessors", [])

    def triangles(mesh):
        return sum(accessors[primitive["indices"]]["count"] // 3 for primitive in gltf["meshes"][mesh]["primitives"])

    def copies(node):
        rows = node.get("extensions", {}).get("EXT_mesh_gpu_instancing", {}).get("attributes")
        return accessors[rows["TRANSLATION"]]["count"] if rows else 1

    nodes = [node for node in gltf.get("nodes", []) if "mesh" in node]
    pictured = [material for material in gltf.get("materials", [])
                if "baseColorTexture" in material["pbrMetallicRoughness"] or "normalTexture" in material]
    return {"triangles": sum(triangles(node["mesh"]) * copies(node) for node in nodes),
            "materials with pictures": len(pictured)}


def parts_of(mesh):
    """Returns the number of connected parts of a mesh."""
    parent = list(range(len(mesh.vertices)))

    def root(vertex):
        while parent[vertex] != vertex:
            parent[vertex] = parent[parent[vertex]]
            vertex = parent[vertex]
        return vertex

    count = len(parent)
    for edge in mesh.edges:
        a, b = (root(vertex) for vertex in edge.vertices)
        if a != b:
            parent[a] = b
            count -= 1
    return count


def found_in_blender(path, component):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=path)
    meshes = [thing for thing in bpy.context.scene.objects if thing.type == "MESH"]
    parts = {}  # nodes may share a mesh, which is then looked at once
    leaves = 0
    for thing in meshes:
        thing.data.calc_loop_triangles()
        if thing.data.name.split(".")[0] != component:
            continue
        if thing.data.name not in parts:
            parts[thing.data.name] = parts_of(thing.data)
        leaves += parts[thing.data.name]
    # Blender makes two of a material that meshes have with and without vertex colours.
    used = {slot.material.name.split(".")[0]: slot.material
            for thing in meshes for slot in thing.material_slots if slot.material}
    pictured = [material for material in used.values()
                if material.use_nodes and any(node.type == "TEX_IMAGE" and node.image for node in material.node_tree.nodes)]
    heights = [(thing.matrix_world @ vertex.co).z for thing in meshes for vertex in thing.data.vertices]
    return {"objects": len(meshes), "triangles": sum(len(thing.data.loop_triangles) for thing in meshes),
            "parts of leaves": leaves, "materials": len(used), "materials with pictures": len(pictured),
            "height": max(heights, default=math.nan)}


def main():
    parser = argparse.ArgumentParser(prog="blender_check.py")
    parser.add_argument("files", nargs="+")
    parser.add_argument("--component", default="leaf")
    parser.add_argument("--leaves", type=int)
    arguments = parser.parse_args(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
    good = True
    for path in arguments.files:
        told = told_by(path)
        found = found_in_blender(path, arguments.component)
        print(f"{path}, Blender {bpy.app.version_string}")
        for what, count in found.items():
            differs = told.get(what, count) != count
            good = good and not differs
            print(f"  {what:<24} {count:>12.10g}" + (f"  but the file has {told[what]}" if differs else ""))
        if arguments.leaves and (found["parts of leaves"] == 0 or found["parts of leaves"] % arguments.leaves != 0):
            good = False
            print(f"  these are not the parts of {arguments.leaves} leaves")
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
