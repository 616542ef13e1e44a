// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/diagnostic.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

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
  EXPECT_EQ(nearest_name("lengthh", names), "length");         // one letter too many
  EXPECT_EQ(nearest_name("langth", names), "length");          // one letter replaced
  EXPECT_EQ(nearest_name("Width", names), "width");            // a capital
  EXPECT_EQ(nearest_name("divregance", names), "divergence");  // two edits
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

/// Returns the optimal string alignment from the full table. Capital and small letters are equal.
std::size_t plain_distance(const std::string& a, const std::string& b) {
  const auto equal = [](char x, char y) { return std::tolower(x) == std::tolower(y); };
  std::vector<std::vector<std::size_t>> rows(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& cell = rows[i][j];
      if (i == 0 || j == 0) {
        cell = i + j;
        continue;
      }
      const std::size_t replaced = rows[i - 1][j - 1] + (equal(a[i - 1], b[j - 1]) ? 0 : 1);
      cell = std::min({rows[i - 1][j] + 1, rows[i][j - 1] + 1, replaced});
      const bool is_swap = i > 1 && j > 1 && equal(a[i - 1], b[j - 2]) && equal(a[i - 2], b[j - 1]);
      if (is_swap) cell = std::min(cell, rows[i - 2][j - 2] + 1);
    }
  }
  return rows[a.size()][b.size()];
}

TEST(NearestName, AgreesWithTheWholeTableOfEdits) {
  const auto drawn = [](RandomKey key) {
    std::string name;
    const auto size = static_cast<std::size_t>(1 + 14 * key.uniform(0));
    for (std::size_t k = 0; k < size; ++k) name += "abcA"[static_cast<std::size_t>(4 * key.uniform(k + 1))];
    return name;
  };
  for (std::uint64_t round = 0; round < 500; ++round) {
    const RandomKey key = RandomKey().child(round);
    const std::string name = drawn(key.child("name"));
    std::vector<std::string> candidates;
    for (std::uint64_t k = 0; k < 20; ++k) candidates.push_back(drawn(key.child(k)));
    std::string nearest;
    std::size_t min = name.size() / 3 + 1;
    for (const std::string& candidate : candidates) {
      if (plain_distance(name, candidate) >= min) continue;
      min = plain_distance(name, candidate);
      nearest = candidate;
    }
    EXPECT_EQ(nearest_name(name, candidates), nearest) << name;
  }
}

}  // namespace meristem::diagnostic_test
