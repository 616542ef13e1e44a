// SPDX-License-Identifier: Apache-2.0
// Grammars in continuous time: modules with ages, compared with closed forms of The Algorithmic Beauty of Plants,
// chapter 6, and errors of the reader.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/grow/lsystem/derive.h"
#include "meristem/grow/lsystem/grammar_reader.h"

namespace meristem::timed_grammar_test {

const double kGoldenRatio = (1 + std::sqrt(5.0)) / 2;

std::string derived(const std::string& text, double time) {
  const Grammar grammar = read_grammar(text);
  Progress progress;
  return word_text(derive(grammar, time, RandomKey(1), SizeLimits(), progress), grammar.alphabet);
}

Word drawn(const std::string& text, double time) {
  Progress progress;
  return derive_drawn(read_grammar(text), time, RandomKey(1), SizeLimits(), progress);
}

double sum_of_parameters(const Word& word) {
  double sum = 0;
  for (const double parameter : word.parameters) sum += parameter;
  return sum;
}

std::vector<std::string> errors_of(const std::string& text) {
  try {
    read_grammar(text);
  } catch (const InputError& error) {
    std::vector<std::string> texts;
    for (const Diagnostic& found : error.diagnostics()) texts.push_back(found.text());
    return texts;
  }
  return {};
}

std::string error_of(const std::string& rules) {
  const std::vector<std::string> errors = errors_of("A\n" + rules + "\n");
  EXPECT_EQ(errors.size(), 1U) << rules;
  return errors.empty() ? "" : errors.front();
}

/// Anabaena catenula, section 6.1. Lengths grow as e^(a t), without a jump at cell divisions: e^a is the golden ratio.
const std::string kAnabaena = R"(
#symbols ar al br bl
#define a = log((1 + sqrt(5))/2)
ar
#rules
ar @ 1 -> al br
al @ 1 -> bl ar
br @ 1 -> ar
bl @ 1 -> al
#interpret
ar -> F(exp(a*age))
al -> F(exp(a*age))
br -> F(exp(a*(age - 1)))
bl -> F(exp(a*(age - 1)))
)";

TEST(TimedGrammar, AnabaenaDividesAsItsCellsComeOfAge) {
  EXPECT_EQ(derived(kAnabaena, 0), "ar");
  EXPECT_EQ(derived(kAnabaena, 0.999), "ar");
  EXPECT_EQ(derived(kAnabaena, 1), "al br");
  EXPECT_EQ(derived(kAnabaena, 2.5), "bl ar ar");
  EXPECT_EQ(derived(kAnabaena, 3), "al al br al br");
}

TEST(TimedGrammar, AnabaenasFilamentGrowsExponentially) {
  for (double time = 0; time < 9; time += 0.173) {
    const double length = sum_of_parameters(drawn(kAnabaena, time));
    EXPECT_NEAR(length / std::pow(kGoldenRatio, time), 1, 1e-12) << "at " << time;
  }
}

/// A compound leaf, section 6.3: an apex produces a segment with two lateral apices, which start after a delay.
std::string compound_leaf(const std::string& delay) {
  return "#define rate = 0.4\na\n#rules\na @ 1 -> s[b][b]a\nb @ " + delay +
         " -> a\n#interpret\na -> F(age)\ns -> F(exp(rate*age))\n";
}

TEST(TimedGrammar, ACompoundLeafHasApicesByItsRecurrence) {
  const Grammar grammar = read_grammar(compound_leaf("1"));
  Progress progress;
  for (int n = 0; n < 12; ++n) {
    const Word word = derive(grammar, n + 0.5, RandomKey(1), SizeLimits(), progress);
    std::uint64_t apices = 0;
    for (const auto& [symbol, count] : symbol_counts(word, grammar.alphabet)) apices += symbol == "a" ? count : 0;
    // a(n + 1) = a(n) + 2 a(n - 1).
    EXPECT_EQ(apices, ((1U << (n + 1)) + (n % 2 == 0 ? 1U : -1U)) / 3) << "after " << n;
  }
}

TEST(TimedGrammar, ACompoundLeafsAxisGrowsAsItsSegmentsDo) {
  // The stem alone, because its lateral apices never start.
  for (double time = 0.05; time < 6; time += 0.21) {
    double expected = time - std::floor(time);
    for (double birth = 1; birth <= time; ++birth) expected += std::exp(0.4 * (time - birth));
    EXPECT_NEAR(sum_of_parameters(drawn(compound_leaf("1e6"), time)), expected, 1e-12) << "at " << time;
  }
}

TEST(TimedGrammar, NothingJumpsWhereAModuleIsReplaced) {
  double before = sum_of_parameters(drawn(compound_leaf("0.7"), 0));
  constexpr double kStep = 0.004;
  for (double time = kStep; time < 4; time += kStep) {
    const double length = sum_of_parameters(drawn(compound_leaf("0.7"), time));
    // Each apex grows by 1 per unit of time, each segment by its rate: together less than three lengths plus the
    // apices.
    EXPECT_LT(std::abs(length - before), kStep * (3 * length + 200)) << "at " << time;
    EXPECT_GE(length, before - 1e-9);
    before = length;
  }
}

TEST(TimedGrammar, LivesOfOneAreSteps) {
  const std::string timed = "A\n#rules\nA @ 1 -> AB\nB @ 1 -> A\n";
  const std::string plain = "A\n#rules\nA -> AB\nB -> A\n";
  for (int n = 0; n <= 10; ++n) EXPECT_EQ(derived(timed, n), derived(plain, n));
}

TEST(TimedGrammar, LivesMayDependOnParameters) {
  const std::string text = "A(1)\n#rules\nA(x) @ 0.5*x : x > 0.1 -> F(x)A(x/2)\nA(x) @ 7 -> L\n";
  EXPECT_EQ(derived(text, 0.49), "A(1)");
  EXPECT_EQ(derived(text, 0.5), "F(1)A(0.5)");
  EXPECT_EQ(derived(text, 0.75), "F(1)F(0.5)A(0.25)");
}

TEST(TimedGrammar, CutsAsStepsDo) {
  EXPECT_EQ(derived("[A]B\n#rules\nA @ 1 -> F%C\n", 0.5), "[A]B");
  EXPECT_EQ(derived("[A]B\n#rules\nA @ 1 -> F%C\n", 1), "[F]B");
}

TEST(TimedGrammar, AgesAreKnownToGrammarsThatCountSteps) {
  // The age of a segment is the number of steps since its birth. F of the axis is drawn by the age.
  const Word word = drawn("A\n#rules\nA -> SA\n#interpret\nS -> F(age)\n", 4);
  EXPECT_EQ(std::vector<double>(word.parameters.begin(), word.parameters.end()), (std::vector<double>{3, 2, 1, 0}));
}

TEST(TimedGrammar, AParameterOrConstantNamedAgeHidesTheAge) {
  EXPECT_EQ(sum_of_parameters(drawn("S(7)\n#rules\nA -> A\n#interpret\nS(age) -> F(age)\n", 3)), 7);
  EXPECT_EQ(sum_of_parameters(drawn("#define age = 5\nS\n#rules\nS -> T\n#interpret\nT -> F(age)\n", 3)), 5);
}

TEST(TimedGrammar, TheSameOnAnyThreads) {
  const std::string text = compound_leaf("0.3");
  const ThreadLimit one(1);
  const Word alone = drawn(text, 7.3);
  const ThreadLimit three(3);
  EXPECT_EQ(drawn(text, 7.3), alone);
  EXPECT_GT(alone.module_count(), 2000U);
}

TEST(TimedGrammar, WordsBeyondTheLimitAreRefused) {
  SizeLimits limits;
  limits.modules = 1000;
  Progress progress;
  EXPECT_THROW(derive(read_grammar(compound_leaf("0.3")), 30, RandomKey(1), limits, progress), InputError);
}

/// Returns the error of a derivation until `time` that is cancelled from the start. Forecast errors come before the
/// first word.
std::string outcome(const std::string& text, double time) {
  Progress progress;
  progress.cancel();
  try {
    derive(read_grammar(text), time, RandomKey(1), SizeLimits(), progress);
  } catch (const Cancelled&) {
    return "cancelled";
  } catch (const InputError& error) {
    return error.what();
  }
  return "derived";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(TimedGrammar, WordsThatWillBeTooLongAreRefusedBeforeTheFirst) {
  const std::string doubling = "F(1)\n#rules\nF(x) @ 0.5 -> F(x)F(x)\n";
  const std::string error = outcome(doubling, 14);  // 2^28
  EXPECT_TRUE(has(error, "268435456 modules of a word are too many")) << error;
  EXPECT_TRUE(has(error, "'F(x) @ 0.5 -> F(x)F(x)' adds most")) << error;
  EXPECT_TRUE(has(error, "limits.modules")) << error;
  EXPECT_EQ(outcome(doubling, 13.9), "cancelled");
  // Modules with different lives: the word grows by the golden ratio per unit of time.
  EXPECT_TRUE(has(outcome("A\n#rules\nA @ 0.1 -> AB\nB @ 0.2 -> A\n", 100), "modules of a word are too many"));
}

TEST(TimedGrammar, WordsThatMayStayShortAreNotRefusedUnderived) {
  EXPECT_EQ(outcome("A(1)\n#rules\nA(x) @ 1 : x > 2 -> A(x)A(x)\n", 60), "cancelled") << "a condition";
  EXPECT_EQ(outcome("A(1)\n#rules\nA(x) @ x -> A(9*x)A(9*x)\n", 60), "cancelled") << "lives grow longer";
  EXPECT_EQ(outcome("A\n#rules\nA @ 1 -> AA%\n", 60), "cancelled") << "branches are cut";
  EXPECT_EQ(outcome("A\n#rules\nA @ 1 -> BB\nB @ 1 ->\n", 60), "cancelled") << "modules vanish";
  EXPECT_EQ(derived("A\n#rules\nA @ 1 -> BB\nB @ 1 ->\n", 60), "");
}

TEST(TimedGrammar, FaultsAreLocated) {
  EXPECT_EQ(error_of("A @ -> B"),
            "2:3: nothing follows '@'; expected the life of the module: predecessor @ life -> successor");
  EXPECT_EQ(error_of("A @ 0 -> B"), "2:5: the life '0' is not above 0; expected a number above 0");
  EXPECT_EQ(error_of("B < A @ 1 -> B"),
            "2:1: a rule with a life sees its neighbours; expected a rule without contexts: "
            "modules come to their ends at different times");
  EXPECT_EQ(error_of("A @ 1 : 2 -> B"), "2:9: a rule with a life is drawn by chance; expected a rule without a weight");
  EXPECT_EQ(error_of("A @ 1 -> B(rand())"),
            "2:1: a rule with a life draws random numbers; expected expressions without chance");
  EXPECT_EQ(error_of("A @ 1 -> B\nB -> A"),
            "3:1: the rule has no life, and others have one; expected predecessor @ life -> successor");
  EXPECT_EQ(error_of("A @ 1 -> B\n#interpret\nB @ 1 -> F"),
            "4:5: a life in a rule that takes no time; expected lives in the rules behind #rules alone");
  EXPECT_EQ(
      error_of("A @ 1 -> B\n#decompose\nB -> F"),
      "4:1: a decomposition in a grammar with lives; expected rules behind #rules, with lives, or behind #interpret");
  EXPECT_EQ(error_of("#steps 3\nA @ 1 -> B"), "2:1: '#steps' in a grammar with lives; expected #time");
  EXPECT_EQ(error_of("#time 3\nA -> B"),
            "2:1: '#time' in a grammar without lives; expected #steps, or rules with lives");
  EXPECT_EQ(error_of("#time -1\nA @ 1 -> B"), "2:7: '-1' is not a time; expected a number of at least 0");
}

TEST(TimedGrammar, ALifeThatIsNoneIsToldAtItsRule) {
  try {
    derived("A(1)\n#rules\nA(x) @ x -> A(x - 1)\n", 5);
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("the life 'x' in 'A(x) @ x -> A(x - 1)' is 0"), std::string::npos) << text;
  }
}

TEST(TimedGrammar, ASignAsASymbolStaysOne) { EXPECT_EQ(derived("@A\n#rules\n@ -> F@\n", 2), "FF@A"); }

}  // namespace meristem::timed_grammar_test
