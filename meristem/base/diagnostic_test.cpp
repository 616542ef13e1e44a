// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/diagnostic.h"

#include <array>

#include <gtest/gtest.h>

namespace meristem::diagnostic_test {

Diagnostic complete() {
  Diagnostic diagnostic;
  diagnostic.message = "'lenght' is not a parameter of a leaf";
  diagnostic.expected = "one of its 12 parameters";
  diagnostic.nearest = "length";
  diagnostic.path = "components.leaf.lenght";
  diagnostic.file = "oak.json";
  diagnostic.line = 12;
  diagnostic.column = 7;
  return diagnostic;
}

TEST(Diagnostic, TextNamesPlaceFaultExpectationAndNearestName) {
  EXPECT_EQ(complete().text(),
            "oak.json:12:7: components.leaf.lenght: 'lenght' is not a parameter of a leaf; expected one of its 12 "
            "parameters; did you mean 'length'?");
}

TEST(Diagnostic, TextLeavesOutWhatIsNotKnown) {
  Diagnostic bare;
  bare.message = "the document is empty";
  EXPECT_EQ(bare.text(), "the document is empty");

  Diagnostic in_file = bare;
  in_file.file = "oak.json";
  EXPECT_EQ(in_file.text(), "oak.json: the document is empty");
  in_file.line = 3;
  EXPECT_EQ(in_file.text(), "oak.json:3: the document is empty");

  Diagnostic at_line = bare;
  at_line.line = 3;
  at_line.column = 4;
  EXPECT_EQ(at_line.text(), "3:4: the document is empty");

  Diagnostic at_path = bare;
  at_path.path = "links[1]";
  EXPECT_EQ(at_path.text(), "links[1]: the document is empty");
}

TEST(InputError, SaysOneLineADiagnostic) {
  Diagnostic other;
  other.message = "no components";
  const InputError error({complete(), other});
  EXPECT_EQ(error.what(), complete().text() + "\nno components");
  ASSERT_EQ(error.diagnostics().size(), 2U);
  EXPECT_EQ(error.diagnostics()[0].nearest, "length");
}

TEST(InputError, CallsWarningsByThatName) {
  const InputError error({{.message = "no components"}, {.severity = Severity::warning, .message = "an old key"}});
  EXPECT_STREQ(error.what(), "no components\nwarning: an old key");
}

TEST(NearestName, FindsEachKindOfEdit) {
  const std::array<std::string, 3> names = {"length", "width", "divergence"};
  EXPECT_EQ(nearest_name("lenght", names), "length");          // neighbours swapped
  EXPECT_EQ(nearest_name("lengt", names), "length");           // a letter left out
  EXPECT_EQ(nearest_name("lengthh", names), "length");         // one too many
  EXPECT_EQ(nearest_name("langth", names), "length");          // another one
  EXPECT_EQ(nearest_name("Width", names), "width");            // a capital
  EXPECT_EQ(nearest_name("divregance", names), "divergence");  // two of them
  EXPECT_EQ(nearest_name("width", names), "width");
}

TEST(NearestName, IsEmptyBeyondAThirdOfTheLength) {
  const std::array<std::string, 2> names = {"leaf", "type"};
  EXPECT_EQ(nearest_name("lead", names), "leaf");
  EXPECT_EQ(nearest_name("laef", names), "leaf");
  EXPECT_EQ(nearest_name("load", names), "");
  EXPECT_EQ(nearest_name("le", names), "");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name("leaf", {}), "");
}

TEST(NearestName, PrefersTheNearerThenTheEarlierCandidate) {
  const std::array<std::string, 2> names = {"radial", "radiu"};
  EXPECT_EQ(nearest_name("radius", names), "radiu");
  const std::array<std::string, 2> equals = {"stem_b", "stem_a"};
  EXPECT_EQ(nearest_name("stem_c", equals), "stem_b");
}

TEST(NearestName, GivesUpOnNamesOverAHundredBytes) {
  const std::array<std::string, 2> names = {std::string(100, 'a'), std::string(101, 'a')};
  EXPECT_EQ(nearest_name(std::string(99, 'a'), names), names[0]);
  EXPECT_EQ(nearest_name(std::string(101, 'a'), names), "");
  EXPECT_EQ(nearest_name(std::string(16'000'000, 'a'), names), "");
}

}  // namespace meristem::diagnostic_test
