// SPDX-License-Identifier: Apache-2.0
// Exports a document in any format. A grown plant of the document is reused if it has all records that the format
// needs; otherwise the document is grown again. Several files become one archive.
#include "export_job.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "apps/film/film.h"
#include "meristem/base/atomic_file.h"
#include "meristem/base/in_quotes.h"
#include "meristem/components/camera.h"
#include "meristem/export/formats.h"
#include "meristem/export/picture/picture.h"
#include "meristem/output/write/picture_file.h"
#include "protocol/check.h"
#include "refusal.h"
#include "zip_file.h"

namespace meristem::studio {

namespace {

namespace fs = std::filesystem;

bool is_picture(const ExportOptions& options) { return options.format == ".png" || options.format == ".jpg"; }
bool is_document(const ExportOptions& options) { return options.format == ".json"; }
bool is_film(const ExportOptions& options) { return film::is_film(options.format); }

const FileFormat* format_with(const std::string& ending) {
  for (const FileFormat& format : formats()) {
    if (format.ending == ending) return &format;
  }
  return nullptr;
}

GltfInstances instances_of(const ExportOptions& options) {
  if (options.instances == "rows") return GltfInstances::rows;
  if (options.instances == "nodes") return GltfInstances::nodes;
  return GltfInstances::automatic;
}

/// Returns the grown document. Grows it again if there is no grown plant, or if the format needs records that it lacks.
GrownDocument grown_for(const ExportSource& source, const ExportOptions& options, GrownPart part,
                        const TraceRequest& request, Progress& progress) {
  const bool is_there =
      source.grown != nullptr && (source.grown->traces.recorded | request) == source.grown->traces.recorded;
  if (!is_there) {
    GrowthView view = source.grown != nullptr ? source.grown->view : GrowthView();
    view.request = request;
    return grow_document(*source.document, progress, {.time = options.time, .up_to = part, .view = view});
  }
  GrownDocument grown{.plant = source.grown->plant};
  grown.traces = source.grown->traces;
  if (part == GrownPart::plant) return grown;
  grown.meshes = mesh_detail(*source.document, grown.plant, {}, progress);
  grown.up_to = GrownPart::textures;
  return grown;
}

void write_text(const std::string& text, const std::string& path) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

void write_levels(const ExportSource& source, const ExportOptions& options, const FileFormat& format,
                  const std::string& path, Progress& progress) {
  GrownDocument grown = grown_for(source, options, format.needs, format.request, progress);
  EncodedPictures pictures;
  const FormatOptions how{.instances = instances_of(options), .pictures = &pictures};
  format.write(*source.document, grown, path, how, progress);
  if (!format.has_meshes()) return;
  for (int level = 1; level <= options.lod; ++level) {
    grown.meshes = {};
    grown.meshes = mesh_detail(*source.document, grown.plant, {.level = level}, progress);
    format.write(*source.document, grown, detail_path(format, path, level), how, progress);
  }
}

void write_still(const ExportSource& source, const ExportOptions& options, const std::string& path,
                 Progress& progress) {
  const PictureOptions picture{.still = still_of(options, *source.document),
                               .view = view_of(options, *source.document)};
  const GrownDocument grown = grown_for(source, options, GrownPart::textures, {}, progress);
  write_picture(take_picture(grown, source.document->graph.limits, source.document->scene, picture, progress), path,
                {});
}

/// Returns the name of the file for the page: the only file, or an archive of several files.
std::string packed(const fs::path& folder, const std::vector<std::string>& names, const std::string& name,
                   const Progress& progress) {
  if (names.size() == 1) return names[0];
  std::vector<std::string> files;
  for (const std::string& one : names) files.push_back((folder / one).string());
  write_zip(files, (folder / (name + ".zip")).string(), progress);
  for (const std::string& file : files) fs::remove(file);
  return name + ".zip";
}

/// Returns a word for a shell, in single quotes if necessary.
std::string quoted(const std::string& word) {
  const auto is_plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
           std::string_view("-_./=,+:@").find(letter) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain) && word[0] != '-') return word;
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

}  // namespace

std::string file_name_of(const std::string& text) {
  std::string name;
  for (const char letter : text.substr(0, 60)) {
    const bool is_letter = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
    if (is_letter) {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "plant" : name;
}

Value formats_value() {
  Value::List list;
  const auto add = [&list](std::string ending, std::string doc, bool has_levels, bool can_instance) {
    list.push_back(Value::Object{
        {"ending", std::move(ending)}, {"doc", std::move(doc)}, {"levels", has_levels}, {"instances", can_instance}});
  };
  for (const FileFormat& format : formats())
    add(std::string(format.ending), std::string(format.doc), format.has_meshes(), format.can_instance);
  add(".png", "a picture, ray-cast", false, false);
  add(".jpg", "a picture, ray-cast, as a smaller file", false, false);
  if (film::can_make_films()) {
    add(".mp4", "a film over time, ray-cast", false, false);
    add(".webm", "a film over time, as a smaller file", false, false);
  }
  add(".json", "the document", false, false);
  return list;
}

namespace {

[[noreturn]] void refuse_format(const std::string& format) {
  std::vector<std::string> endings;
  const Value known = formats_value();
  for (const Value& one : *known.list()) endings.push_back(*one.find("ending")->text());
  throw Refusal(fmt::format("there is no format {}{}", in_quotes(format), similar(format, endings)));
}

}  // namespace

void check_export(const ExportOptions& options) {
  if (is_film(options) && !film::can_make_films())
    throw Refusal("a film needs the program ffmpeg, which is not installed; pictures of many times need nothing");
  if (options.frames && !is_film(options) && !is_picture(options))
    throw Refusal("films and pictures alone have frames");
  if (!is_picture(options) && !is_document(options) && !is_film(options) && format_with(options.format) == nullptr)
    refuse_format(options.format);
  if (options.transparent && options.format == ".jpg") throw Refusal("a JPEG has no transparency");
  if (options.transparent && is_film(options)) throw Refusal("a film has no transparency");
}

bool has_frames(const ExportOptions& options) { return is_film(options) || options.frames.has_value(); }

StillOptions still_of(const ExportOptions& options, const Document& document) {
  StillOptions still{.width = options.width.value_or(document.output.size[0]),
                     .height = options.height.value_or(document.output.size[1]),
                     .samples = options.samples.value_or(document.output.samples),
                     .transparent = options.transparent};
  check_still_options(still);
  return still;
}

CameraView view_of(const ExportOptions& options, const Document& document) {
  CameraView view = camera_view(document.graph);
  if (!options.camera) return view;
  view.position = options.camera->position;
  view.target = options.camera->target;
  view.field_of_view = radians(options.camera->field_of_view_deg);
  view.roll = 0;  // the page shows a level view
  return view;
}

Value made_file(Downloads& downloads, const Downloads::Draft& draft, const std::string& first, const std::string& name,
                const Progress& progress) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(draft.path()))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end(), [&first](const std::string& a, const std::string& b) {
    return std::pair(a != first, a) < std::pair(b != first, b);
  });
  const std::string made = packed(draft.path(), names, name, progress);
  Value::List holds;
  if (names.size() > 1) holds.assign(names.begin(), names.end());
  std::error_code ignored;
  const auto bytes = static_cast<double>(fs::file_size(fs::path(draft.path()) / made, ignored));
  return Value::Object{{"name", made},
                       {"bytes", bytes},
                       {"address", fmt::format("downloads/{}/{}", downloads.keep(draft), made)},
                       {"holds", std::move(holds)}};
}

Value export_file(const ExportSource& source, const ExportOptions& options, Downloads& downloads, Progress& progress) {
  const std::unique_ptr<Downloads::Draft> draft = downloads.begin();
  const std::string first = source.name + options.format;
  const std::string path = (fs::path(draft->path()) / first).string();
  if (is_document(options)) {
    write_text(source.text, path);
  } else if (is_picture(options)) {
    write_still(source, options, path, progress);
  } else {
    write_levels(source, options, *format_with(options.format), path, progress);
  }
  return made_file(downloads, *draft, first, source.name, progress);
}

std::string export_command(const std::string& program, const std::string& file, const ExportOptions& options,
                           const std::string& name) {
  const std::string target = quoted(name + options.format);
  if (is_document(options)) return fmt::format("cp {} {}", quoted(file), target);
  const bool is_drawn = is_picture(options) || is_film(options);
  std::string command = fmt::format("{} {} {} -o {}", program, is_drawn ? "render" : "grow", quoted(file), target);
  if (options.seed) command += fmt::format(" --seed {}", *options.seed);
  if (options.frames) {
    command +=
        fmt::format(" --time {:.9g}:{:.9g}:{:.9g}", options.frames->from, options.frames->to, options.frames->step);
  } else if (options.time != 0 && !is_film(options)) {
    command += fmt::format(" --time {}", options.time);
  }
  if (is_drawn) {
    if (options.width && options.height) command += fmt::format(" --size {}x{}", *options.width, *options.height);
    if (options.samples) command += fmt::format(" --samples {}", *options.samples);
    if (options.transparent) command += " --transparent";
    if (options.camera) {
      // The option gives the side of the camera. The command chooses a distance at which everything is in the picture.
      const DVec3 away = DVec3(options.camera->position) - DVec3(options.camera->target);
      const double azimuth = degrees(std::atan2(away.x, -away.z));
      const double altitude = degrees(std::atan2(away.y, std::hypot(away.x, away.z)));
      command += fmt::format(" --view {:.4g},{:.4g}", azimuth, std::clamp(altitude, -89.0, 89.0));
    }
    return command;
  }
  if (options.lod > 0) command += fmt::format(" --lod {}", options.lod);
  if (options.instances == "rows") command += " --instanced";
  if (options.instances == "nodes") command += " --nodes";
  return command;
}

}  // namespace meristem::studio
