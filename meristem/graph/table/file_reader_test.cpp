// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/file_reader.h"

#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/read_file.h"
#include "tests/support/temporary_folder.h"

namespace meristem::file_reader_test {

const DocumentPath kTop;
const DocumentPath kFile(kTop, "file");

Parameter row() {
  Parameter made;
  made.name = "file";
  made.kind = ParameterKind::file;
  return made;
}

/// A folder with files, and a reader of a document in this folder.
struct Reading {
  explicit Reading(ReadStore* kept = nullptr) : store(kept) {}

  TemporaryFolder folder;
  ReadStore* store;
  ReadErrors errors{SizeLimits()};
  FileReader reader{{.folder = folder.path(), .root = folder.path(), .store = store}, errors};

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
  std::string error() const { return errors.diagnostics().empty() ? "none" : errors.diagnostics()[0].text(); }
};

std::string loaded(Reading& reading, const Value& value) {
  std::string text;
  reading.reader.read(row(), value, kFile, [&](const std::string& path) { text = read_file(path, 1000); });
  return text;
}

TEST(FileReader, FindsFilesInTheFolderOfTheDocument) {
  Reading reading;
  reading.write("a.txt", "oak");
  EXPECT_EQ(loaded(reading, "a.txt"), "oak");
  ASSERT_EQ(reading.reader.named().size(), 1U);
  EXPECT_TRUE(reading.reader.named()[0].is_beside);
  EXPECT_EQ(reading.error(), "none");
}

TEST(FileReader, AFileThatIsMissingOrNoTextIsAnErrorAtItsPath) {
  Reading missing;
  loaded(missing, "a.txt");
  ASSERT_EQ(missing.errors.error_count(), 1U);
  EXPECT_EQ(missing.errors.diagnostics()[0].path, "file");
  Reading number;
  loaded(number, 3);
  EXPECT_EQ(number.errors.diagnostics().at(0).message, "'file' cannot be the number 3");
}

TEST(FileReader, FilesOutsideOfTheRootAreRefused) {
  Reading reading;
  EXPECT_EQ(loaded(reading, "/etc/hostname"), "");
  EXPECT_EQ(reading.errors.error_count(), 1U);
}

TEST(FileReader, AnErrorInAFileHasItsPlaceThere) {
  Reading reading;
  reading.write("a.txt", "oak");
  reading.reader.read(row(), "a.txt", kFile, [](const std::string& path) {
    throw InputError(Diagnostic{.message = "no beech", .file = path, .line = 3, .column = 7});
  });
  EXPECT_EQ(reading.errors.diagnostics().at(0).message, "'a.txt:3:7': no beech");
}

TEST(FileReader, AnErrorInATextIsMovedToItsPlaceInTheDocument) {
  const auto error_in = [](const Value& value) {
    Reading reading;
    std::string whole;
    reading.reader.read_lines(row(), value, kFile, [&](const std::string& text, const std::string&, auto&) {
      whole = text;
      throw InputError(Diagnostic{.message = "wrong", .line = 2, .column = 3});
    });
    EXPECT_EQ(whole.find("first\nsecond"), 0U);
    return reading.errors.diagnostics().at(0);
  };
  EXPECT_EQ(error_in("first\nsecond").text_offset, 8);
  const Diagnostic in_list = error_in(Value::List{"first", "second"});
  EXPECT_EQ(in_list.path, "file[1]");
  EXPECT_EQ(in_list.text_offset, 2);
}

TEST(FileReader, WarningsOfATextFileAreReported) {
  Reading reading;
  reading.write("a.txt", "oak");
  reading.reader.read_text_file(
      row(), "a.txt", kFile, [](const std::string& text, const std::string&, std::vector<Diagnostic>& warnings) {
        warnings.push_back({.severity = Severity::warning, .message = "odd " + text, .line = 1});
      });
  EXPECT_EQ(reading.errors.error_count(), 0U);
  EXPECT_EQ(reading.errors.diagnostics().at(0).message, "'a.txt:1': odd oak");
}

TEST(FileReader, AnIncludedFileIsNamedToo) {
  Reading reading;
  reading.write("b.txt", "beech");
  EXPECT_EQ(reading.reader.included_text((reading.folder / "a.txt").string(), "b.txt", 100), "beech");
  EXPECT_EQ(reading.reader.named().size(), 1U);
  EXPECT_THROW(reading.reader.included_text((reading.folder / "a.txt").string(), "../b.txt", 100), InputError);
}

TEST(FileReader, OtherDocumentsNeedADocumentThatIsRead) {
  Reading reading;
  EXPECT_EQ(reading.reader.plant_source("oak.json", kFile), nullptr);
  EXPECT_EQ(reading.errors.diagnostics().at(0).message, "no other documents can be read here");
}

int loads = 0;
std::string load(const std::string& path, const SizeLimits& limits) {
  ++loads;
  return read_file(path, limits.file_bytes);
}

TEST(FileReader, AFileIsLoadedOnceWhileItsContentStays) {
  ReadStore store;
  Reading reading(&store);
  reading.write("a.txt", "oak");
  loads = 0;
  for (int k = 0; k < 2; ++k) {
    store.begin_read();
    EXPECT_EQ(*reading.reader.kept_file<std::string>((reading.folder / "a.txt").string(), load), "oak");
    store.end_read();
  }
  EXPECT_EQ(loads, 1);
}

TEST(FileReader, WarningsOfAKeptTextAreReportedAgain) {
  ReadStore store;
  Reading reading(&store);
  int made = 0;
  for (int k = 0; k < 2; ++k) {
    std::vector<Diagnostic> warnings;
    const auto text = reading.reader.kept_text<std::string>(Fingerprint().add(7), warnings, [&] {
      ++made;
      warnings.push_back({.severity = Severity::warning, .message = "odd"});
      return std::string("oak");
    });
    EXPECT_EQ(*text, "oak");
    EXPECT_EQ(warnings.size(), 1U);
  }
  EXPECT_EQ(made, 1);
}

}  // namespace meristem::file_reader_test
