// SPDX-License-Identifier: Apache-2.0
// Messages that open, change and read a document.
#include "protocol/common_records.h"
#include "protocol/protocol.h"
#include "protocol/record_table.h"

namespace meristem::studio {

namespace {

constexpr const char* kBaseDoc = "Hash of the text before the change.";
constexpr const char* kHashDoc = "Hash of the new text.";
constexpr Span kIndex{.min = 0, .max = kMaxWhole};

Form patch() {
  return forms::list(
      forms::tuple({{"offset", forms::whole()}, {"length", forms::whole()}, {"replacement", forms::text()}}));
}

const Record& open_members() {
  static const Record record =
      RecordTable<OpenRequest>(
          "OpenRequest",
          "Opens a document. The previous plant is dropped: no packet of another document follows this answer.")
          .text("path", &OpenRequest::path, "Path below the root. With `text`: the file beside which the text stands.")
          .text("model", &OpenRequest::model, "Name of a shipped model. With `text`: the model that was changed.")
          .text("text", &OpenRequest::text, "Text of the document, instead of the text of the file or the model.")
          .rule([](const OpenRequest& request, const Value&) -> std::string {
            const bool is_one = request.model ? !request.path : request.path || request.text;
            return is_one ? "" : "opens a document by its 'path', by the name of a 'model', or from a 'text'";
          });
  return record;
}

const Record& open_answer() {
  static const Record record =
      WrittenRecord("OpenAnswer", "An opened document.")
          .member("path", forms::or_null(forms::text()), "Path below the root. Null: a model or a new text.")
          .member("model", forms::or_null(forms::text()), "Name of the shipped model. Null: a file or a new text.")
          .member("name", forms::text(), "Name for a title: the name of the file or the model.")
          .member("text", forms::text(), "Text of the document.")
          .member("hash", forms::text(), "Hash of the text.")
          .member("saved", forms::or_null(forms::text()), "Hash of the file on the disk. Null: no file.")
          .with(reading_record);
  return record;
}

const Record& splice_members() {
  static const Record record = RecordTable<SpliceRequest>("SpliceRequest", "Replaces pieces of the text.")
                                   .text("base", &SpliceRequest::base, kBaseDoc)
                                   .read(
                                       "patch", patch(),
                                       [](SpliceRequest& request, const Value& value, const DocumentPath&) {
                                         for (const Value& piece : *value.list()) {
                                           UnitSplice& splice = request.patch.emplace_back();
                                           store_value(splice.offset, (*piece.list())[0]);
                                           store_value(splice.length, (*piece.list())[1]);
                                           store_value(splice.replacement, (*piece.list())[2]);
                                         }
                                       },
                                       "The pieces, in rising order and without overlap.");
  return record;
}

const Record& text_members() {
  static const Record record = RecordTable<TextRequest>("TextRequest", "Replaces the whole text.")
                                   .text("text", &TextRequest::text, "The new text.");
  return record;
}

const Record& text_answer() {
  static const Record record =
      WrittenRecord("TextAnswer", "A changed text.").member("hash", forms::text(), kHashDoc).with(reading_record);
  return record;
}

const Record& set_edit() {
  static const Record record = RecordTable<SetValue>("SetEdit", "Sets a value.")
                                   .text("set", &SetValue::path, "Path of the value.")
                                   .any("value", &SetValue::value, "The new value.");
  return record;
}

const Record& unset_edit() {
  static const Record record = RecordTable<UnsetValue>("UnsetEdit", "Removes a member, so that its default holds.")
                                   .text("unset", &UnsetValue::path, "Path of the member.");
  return record;
}

const Record& insert_edit() {
  static const Record record =
      RecordTable<InsertValue>("InsertEdit", "Inserts an element or a member.")
          .text("insert", &InsertValue::path, "Path of the new value. `links[]` is behind the last link.")
          .any("value", &InsertValue::value, "The new value.")
          .whole("index", &InsertValue::index, kIndex, "Index among the members. Missing: last.");
  return record;
}

const Record& remove_edit() {
  static const Record record = RecordTable<RemoveValue>("RemoveEdit", "Removes a member or an element.")
                                   .text("remove", &RemoveValue::path, "Path of the member or element.");
  return record;
}

const Record& rename_edit() {
  static const Record record = RecordTable<RenameValue>("RenameEdit", "Renames a member and its uses.")
                                   .text("rename", &RenameValue::path, "Path of the member.")
                                   .text("name", &RenameValue::name, "The new name.");
  return record;
}

const Record& move_edit() {
  static const Record record =
      RecordTable<MoveValue>("MoveEdit", "Moves a member or an element within its object or list.")
          .text("move", &MoveValue::path, "Path of the member or element.")
          .whole("index", &MoveValue::index, kIndex, "Index after the move, from 0.");
  return record;
}

const Record& note_edit() {
  static const Record record = RecordTable<SetNote>("NoteEdit", "Sets the comment on a member.")
                                   .text("note", &SetNote::path, "Path of the member.")
                                   .text("text", &SetNote::note, "The comment. An empty text removes it.");
  return record;
}

const Record& paste_edit() {
  static const Record record =
      RecordTable<InsertPart>("PasteEdit", "Inserts a part of a document.")
          .text("paste", &InsertPart::text, "The part, as `part` answers it.")
          .several("names", forms::map(forms::text()), &InsertPart::names,
                   "New names of components, by their names in the part.")
          .optional()
          .whole("index", &InsertPart::index, kIndex, "Index of its first component. Missing: behind the last.")
          .whole("link_index", &InsertPart::link_index, kIndex, "Index of its first link. Missing: behind the last.");
  return record;
}

Form edit_form() {
  return forms::kinds({set_edit, unset_edit, insert_edit, remove_edit, rename_edit, move_edit, note_edit, paste_edit});
}

const Record& edit_members() {
  static const Record record =
      RecordTable<EditRequest>("EditRequest",
                               "Changes values of the document in one step. Ends a drag and removes its values.")
          .text("base", &EditRequest::base, kBaseDoc)
          .read(
              "edits", forms::list(edit_form()),
              [](EditRequest& request, const Value& value, const DocumentPath& path) {
                static const Form form = edit_form();
                for (std::size_t k = 0; k < value.list()->size(); ++k)
                  store_kind(request.edits.emplace_back(), form, (*value.list())[k], DocumentPath(path, k));
              },
              "The edits, in their order.")
          .flag("only_if_good", &EditRequest::only_if_good,
                "True: refused with `faults`, without a change, if a text without errors would get errors.")
          .or_default();
  return record;
}

const Record& edit_answer() {
  static const Record record = WrittenRecord("EditAnswer", "An edited text.")
                                   .member("patch", patch(), "The change of the text.")
                                   .member("inverse", patch(), "The patch that undoes the change.")
                                   .member("hash", forms::text(), kHashDoc)
                                   .with(reading_record);
  return record;
}

const Record& drag_members() {
  static const Record record =
      RecordTable<DragRequest>(
          "DragRequest",
          "Sets values for a while, as a slider does. The text does not change, and the latest drag counts.")
          .read(
              "values", forms::map(forms::any()),
              [](DragRequest& request, const Value& value, const DocumentPath&) {
                request.values = overrides_of(*value.object());
              },
              "Values by their paths: `{\"leaf.length\": 0.2}`. Empty: ends the drag.");
  return record;
}

const Record& drag_answer() {
  static const Record record =
      WrittenRecord("DragAnswer", "The faults of dragged values.")
          .member("faults", errors(), "Faults of these values.")
          .optional("superseded", forms::flag(), "True: a newer message made the reading useless.");
  return record;
}

}  // namespace

ProtocolGroup document_messages() {
  using enum AnswerTime;
  return {.name = "document",
          .doc = "Messages that open, change and read a document.",
          .requests = {request_type<OpenRequest>("open", at_once, open_members, open_answer),
                       request_type<SpliceRequest>("splice", at_once, splice_members, text_answer),
                       request_type<TextRequest>("text", at_once, text_members, text_answer),
                       request_type<EditRequest>("edit", at_once, edit_members, edit_answer),
                       request_type<DragRequest>("drag", at_once, drag_members, drag_answer)},
          .others = {refused_record}};
}

}  // namespace meristem::studio
