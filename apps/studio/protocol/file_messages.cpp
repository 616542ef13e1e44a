// SPDX-License-Identifier: Apache-2.0
// Messages about files below the root, shipped models and parts of documents.
#include "protocol/common_records.h"
#include "protocol/protocol.h"
#include "protocol/record_table.h"

namespace meristem::studio {

namespace {

const Record& files_members() {
  static const Record record = RecordTable<FilesRequest>("FilesRequest", "Lists a folder.")
                                   .text("folder", &FilesRequest::folder, "Path below the root. Empty: the root.");
  return record;
}

const Record& listed_file() {
  static const Record record = WrittenRecord("ListedFile", "A file or folder in a list.")
                                   .member("name", forms::text(), "Name without its folder.")
                                   .member("folder", forms::flag(), "True: a folder.")
                                   .member("bytes", forms::whole(), "Size of a file.");
  return record;
}

const Record& files_answer() {
  static const Record record =
      WrittenRecord("FilesAnswer", "The content of a folder.")
          .member("folder", forms::text(), "Path below the root.")
          .member("files", forms::list(forms::record(listed_file), kMaxNumbers), "By name. Hidden files are left out.");
  return record;
}

const Record& save_members() {
  static const Record record =
      RecordTable<SaveRequest>(
          "SaveRequest",
          "Saves the document. Refused with `changed` if the file on the disk is not as expected, and with `stale` if "
          "the server has another text. A refused `save` leaves the file as it was.")
          .text("path", &SaveRequest::path, "Path below the root.")
          .text("hash", &SaveRequest::hash, "Hash of the text of the page. The server saves no other text.")
          .text("saved", &SaveRequest::saved, "Hash that the page expects on the disk. Null: a new file.")
          .flag("over", &SaveRequest::over, "True: replaces the file even if its hash is not `saved`.")
          .or_default();
  return record;
}

const Record& omitted_file() {
  static const Record record = WrittenRecord("OmittedFile", "A file that was not copied.")
                                   .member("file", forms::text(), "Path of the file in the document.")
                                   .member("reason", forms::text(), "Why it was not copied.");
  return record;
}

const Record& copied_files() {
  static const Record record =
      WrittenRecord("CopiedFiles", "The files that the document names by relative paths.")
          .member("copied", forms::list(forms::text()),
                  "Files that were missing beside the new path, and were copied to there.")
          .member("omitted", forms::list(forms::record(omitted_file)),
                  "Files that were not copied. A file with another content is never replaced.");
  return record;
}

const Record& save_answer() {
  static const Record record = WrittenRecord("SaveAnswer",
                                             "A saved document. If the path has changed, the files that the document "
                                             "names are searched beside it, and the text is read again.")
                                   .member("path", forms::text(), "Path below the root.")
                                   .member("name", forms::text(), "Name for a title.")
                                   .member("saved", forms::text(), "Hash of the file on the disk.")
                                   .or_without(copied_files)
                                   .or_without(reading_record);
  return record;
}

const Record& models_members() {
  static const Record record = RecordTable<ModelsRequest>("ModelsRequest", "Lists the shipped models.");
  return record;
}

const Record& shipped_model() {
  static const Record record = WrittenRecord("ShippedModel", "A shipped model.")
                                   .member("name", forms::text(), "Name in requests.")
                                   .member("title", forms::text(), "Name for users.")
                                   .member("description", forms::text(), "Description.")
                                   .member("picture", forms::flag(), "True: `pictures/NAME.jpg` exists.");
  return record;
}

const Record& models_answer() {
  static const Record record = WrittenRecord("ModelsAnswer", "The shipped models.")
                                   .member("models", forms::list(forms::record(shipped_model)), "By name.");
  return record;
}

const Record& parts_members() {
  static const Record record = RecordTable<PartsRequest>("PartsRequest", "Lists the components of a shipped model.")
                                   .text("model", &PartsRequest::model, "Name of the model.");
  return record;
}

const Record& parts_answer() {
  static const Record record =
      WrittenRecord("PartsAnswer", "The components of a model.")
          .member("tree", forms::any(), "The document as plain JSON.")
          .member("implied", forms::list(forms::record(implied_record)), "Links that are not in it.");
  return record;
}

const Record& part_members() {
  static const Record record =
      RecordTable<PartRequest>("PartRequest", "Cuts a part out of a model, of a text, or of the document.")
          .text("model", &PartRequest::model, "Name of a shipped model.")
          .text("text", &PartRequest::text, "Text of a document.")
          .several("components", forms::list(forms::text()), &PartRequest::components,
                   "Ids of components. Missing: all but cameras.")
          .optional()
          .rule([](const PartRequest& request, const Value&) -> std::string {
            return request.model && request.text ? "has both a 'model' and a 'text'" : "";
          });
  return record;
}

const Record& part_answer() {
  static const Record record =
      WrittenRecord("PartAnswer", "A part of a document.")
          .member("text", forms::text(),
                  "A document with these components, the links among them and the variables that they name, as they "
                  "are written.")
          .member("components", forms::list(forms::text()), "Ids of its components.")
          .member("roots", forms::list(forms::text()), "Components to which no other component of the part links.");
  return record;
}

const Record& picture_members() {
  static const Record record =
      RecordTable<PictureRequest>("PictureRequest", "Makes a small version of a picture.")
          .text("file", &PictureRequest::file, "Path of the picture as the document writes it.")
          .whole("size", &PictureRequest::size, {16, 512}, "Pixels along the longer side.")
          .or_default();
  return record;
}

const Record& picture_answer() {
  static const Record thumbnail = WrittenRecord("Thumbnail", "A small picture.")
                                      .member("picture", forms::text(), "A PNG in base 64.")
                                      .member("width", forms::whole(), "Width of the whole picture, pixels.")
                                      .member("height", forms::whole(), "Height of the whole picture, pixels.");
  static const Record record =
      WrittenRecord("PictureAnswer", "A small version of a picture.")
          .member("thumbnail", forms::record([]() -> const Record& { return thumbnail; }), "The small picture.");
  return record;
}

const Record& elsewhere_record() {
  static const Record record =
      WrittenRecord("Elsewhere", "The number of other pages that have the file open. It comes when the number changes.")
          .member("path", forms::text(), "Path of the file.")
          .member("count", forms::whole(), "Number of other pages, also of other programs of the same user.");
  return record;
}

}  // namespace

ProtocolGroup file_messages() {
  using enum AnswerTime;
  return {.name = "files",
          .doc = "Messages about files below the root, shipped models and parts of documents.",
          .requests = {request_type<FilesRequest>("files", at_once, files_members, files_answer),
                       request_type<SaveRequest>("save", at_once, save_members, save_answer),
                       request_type<ModelsRequest>("models", at_once, models_members, models_answer),
                       request_type<PartsRequest>("parts", at_once, parts_members, parts_answer),
                       request_type<PartRequest>("part", at_once, part_members, part_answer),
                       request_type<PictureRequest>("picture", later, picture_members, picture_answer)},
          .messages = {{"elsewhere", elsewhere_record}}};
}

}  // namespace meristem::studio
