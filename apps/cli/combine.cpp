// SPDX-License-Identifier: Apache-2.0
// The command `combine`: set operations between closed meshes in files, for printing and modelling.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands.h"
#include "documents.h"
#include "meristem/base/parallel.h"
#include "meristem/export/output_files.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/mesh/obj.h"
#include "meristem/output/mesh/ply.h"
#include "meristem/scene/file/read_mesh.h"
#include "meristem/shape/implicit/mesh_field.h"
#include "meristem/shape/mesh/simplify.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

struct CombineCommand {
  std::string operation;
  std::vector<std::string> inputs;
  std::string output;
  int resolution = 100;
  std::optional<int> triangles;
  int threads = 0;
  bool quiet = false;
};

MeshOperation operation_of(const std::string& name) {
  const std::vector<std::string> names = {"union", "intersection", "difference"};
  for (const auto& [known, operation] :
       {std::pair(names[0], MeshOperation::unite), std::pair(names[1], MeshOperation::intersect),
        std::pair(names[2], MeshOperation::subtract)}) {
    if (name == known) return operation;
  }
  throw InputError(Diagnostic{.message = fmt::format("'{}' is not a set operation", name),
                              .expected = "union, intersection or difference",
                              .nearest = nearest_name(name, names)});
}

/// Writes the mesh in the format of the path's ending.
using WriteMesh = void (*)(const MeshScene& scene, const std::string& path, Progress& progress);

WriteMesh writer_of(const std::string& path) {
  const auto ends = [&path](std::string_view ending) { return path.size() > ending.size() && path.ends_with(ending); };
  if (ends(".obj")) return [](const MeshScene& s, const std::string& p, Progress& t) { write_obj(s, p, {}, t); };
  if (ends(".ply")) return [](const MeshScene& s, const std::string& p, Progress& t) { write_mesh_ply(s, p, {}, t); };
  if (ends(".glb")) return [](const MeshScene& s, const std::string& p, Progress& t) { write_glb(s, p, {}, t); };
  throw InputError(Diagnostic{.message = fmt::format("'{}' has no ending of a mesh that can be written", path),
                              .expected = "a name that ends in .obj, .ply or .glb"});
}

void combine(const CombineCommand& command) {
  const MeshOperation operation = operation_of(command.operation);
  const WriteMesh write = writer_of(command.output);
  check_output(command.output, command.inputs);
  const ThreadLimit threads = limited_threads(command.threads, command.quiet);
  const SizeLimits limits;
  std::string summary;
  {
    TerminalProgress terminal(command.quiet);
    Progress& progress = terminal.progress();
    TriangleMesh result = read_closed_mesh(command.inputs[0], limits).mesh();
    Mesh mesh;
    for (std::size_t k = 1; k < command.inputs.size(); ++k) {
      const TriangleMesh other = read_closed_mesh(command.inputs[k], limits).mesh();
      mesh = combine_meshes(operation, result, other, {.resolution = command.resolution, .path = "--resolution"},
                            limits, progress);
      result = {.positions = {mesh.positions.begin(), mesh.positions.end()}, .triangles = mesh.triangles};
    }
    if (mesh.triangle_count() == 0) {
      throw InputError(Diagnostic{.message = fmt::format("the {} encloses nothing", command.operation),
                                  .expected = "meshes that overlap by more than a cell, or a larger --resolution"});
    }
    if (command.triangles && static_cast<std::size_t>(*command.triangles) < mesh.triangle_count()) {
      mesh = simplify(mesh, {.triangles = static_cast<std::size_t>(*command.triangles)}, progress);
    }
    MeshScene scene;
    scene.materials.emplace_back().name = command.operation;
    summary = fmt::format("{}: {} triangles", command.output, mesh.triangle_count());
    scene.meshes.push_back({command.operation, std::make_shared<const Mesh>(std::move(mesh)), 0, {Frame()}});
    write(scene, command.output, progress);
  }
  if (!command.quiet) print_status(summary);
}

}  // namespace

void add_combine(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("combine", "Unite, intersect or subtract closed meshes in files");
  auto options = std::make_shared<CombineCommand>();
  command->add_option("operation", options->operation, "union, intersection, or difference: the first without others")
      ->required()
      ->type_name("OPERATION");
  command->add_option("meshes", options->inputs, "Closed meshes: two or more OBJ, PLY or GLB files")
      ->required()
      ->expected(2, 100)
      ->type_name("FILE");
  command->add_option("-o,--output", options->output, "File to write; ends in .obj, .ply or .glb")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--resolution", options->resolution,
                   "Number of cells along the longest side of the result, from 10 to 512; by default, 100. Raised, "
                   "sharper edges and more triangles")
      ->type_name("N")
      ->check(CLI::Range(10, 512));
  command
      ->add_option("--triangles", options->triangles,
                   "Number of triangles to which the result is simplified; by default, it is not simplified")
      ->type_name("N")
      ->check(CLI::Range(4, 50'000'000));
  add_run_options(*command, options->threads, options->quiet);
  command->footer("Example: meristem combine union trunk.obj crown.obj -o tree.ply --resolution 200");
  command->callback([options, &run] { run = [options] { combine(*options); }; });
}

}  // namespace meristem::cli
