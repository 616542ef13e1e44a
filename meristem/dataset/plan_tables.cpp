// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/plan_tables.h"

#include "meristem/base/seed.h"
#include "meristem/graph/table/table.h"

namespace meristem {

const ParameterTable& plan_document_table() {
  static const ParameterTable table =
      Table<PlanDocument>("a document of a plan", "A document whose plants belong to the data set.")
          .text("file", &PlanDocument::file,
                "Path of the document from the folder of the plan, or the name of a shipped model.")
          .required()
          .text("name", &PlanDocument::name,
                "Name of the document in the manifest; by default, the name of its file without the ending.")
          .elsewhere({"set"})
          .shorthand("file");
  return table;
}

const ParameterTable& picture_plan_table() {
  static const ParameterTable table =
      Table<PicturePlan>("the pictures of a plan", "Pictures of each plant, and the truth behind each pixel.")
          .integers("size", &PicturePlan::size, 2, {.min = 1, .max = 16384, .usual = {128, 2048}},
                    "Width and height of the pictures in pixels.")
          .integer("samples", &PicturePlan::samples, {.min = 1, .max = 65536, .usual = {1, 256}},
                   "Largest number of light paths per pixel. Raised, less noise and slower pictures.")
          .boolean("transparent", &PicturePlan::transparent,
                   "Whether sky, ground and obstacles are left out and the picture has an alpha channel.")
          .choice("colour", &PicturePlan::colour, {"png", "jpg", "none"}, "Format of the picture in colours.")
          .choice("depth", &PicturePlan::depth, {"none", "png", "pfm"},
                  "Format of the distances from the camera: millimetres in 16 bits (png), or metres as floats (pfm).")
          .choice("normals", &PicturePlan::normals, {"none", "png", "pfm"},
                  "Format of the directions in which surfaces face: 8 bits per axis (png), or floats (pfm).")
          .boolean("organs", &PicturePlan::organs,
                   "Whether a mask numbers each leaf, flower and fruit, and the wood of each shoot.")
          .boolean("shoots", &PicturePlan::shoots, "Whether a mask numbers each shoot with the organs on it.")
          .boolean("plants", &PicturePlan::plants, "Whether a mask numbers each plant.")
          .boolean("coco", &PicturePlan::coco,
                   "Whether a file in the format of COCO data sets has outline, box, area and kind of each thing seen.")
          .elsewhere({"views", "azimuth", "altitude"});
  return table;
}

const ParameterTable& plan_table() {
  static const ParameterTable table =
      Table<PlanHead>("a plan of a data set", "Which plants grow, and what is kept of each.")
          .integer("meristem_dataset", &PlanHead::format, {.min = 1, .max = kDatasetPlanFormat},
                   "Version of the format of plans.")
          .required()
          .text("name", &PlanHead::name, "Name of the data set.")
          .text("description", &PlanHead::description, "Description of the data set in one or two sentences.")
          .text("author", &PlanHead::author, "Author of the data set, who is named in its data card.")
          .text("licence", &PlanHead::licence, "Licence of the data set, which is named in its data card.")
          .integer("seed", &PlanHead::seed, {.min = 0, .max = kLargestSeed, .usual = {0, 100}},
                   "Seed of all values that are drawn from distributions; the plants have seeds of their own.")
          .integer("rows", &PlanHead::rows, {.min = 1, .max = 1e6, .usual = {100, 10000}},
                   "Number of plants in each table of the manifest.")
          .number("time", &PlanHead::time, {.unit = Unit::second, .min = -1e6, .max = 1e6, .usual = {0, 60}},
                  "Time at which the plants stand, the t of the expressions of documents.")
          .list("documents", &PlanHead::documents, plan_document_table,
                "Documents whose plants belong to the data set.")
          .object("pictures", &PlanHead::pictures, picture_plan_table,
                  "Pictures of each plant, and the truth behind each pixel.")
          .elsewhere({"seeds", "set", "grid", "samples", "vary", "files", "measures"});
  return table;
}

}  // namespace meristem
