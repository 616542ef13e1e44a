// SPDX-License-Identifier: Apache-2.0
// The messages and positions of all kinds of errors in grammars.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/grow/lsystem/grammar_reader.h"
#include "tests/support/temporary_folder.h"

namespace meristem::grammar_errors_test {

using Texts = std::vector<std::string>;

Texts errors_of(std::string_view text, const GrammarOptions& options = {}) {
  try {
    read_grammar(text, options);
  } catch (const InputError& error) {
    Texts texts;
    for (const Diagnostic& found : error.diagnostics()) texts.push_back(found.text());
    return texts;
  }
  return {};
}

/// Returns the only error of the rule, which is line 2.
std::string error_of(std::string_view rule) {
  const Texts errors = errors_of(fmt::format("A\n{}\n", rule));
  EXPECT_EQ(errors.size(), 1U) << rule;
  return errors.empty() ? "" : errors.front();
}

Texts warnings_of(std::string_view text) {
  std::vector<Diagnostic> warnings;
  GrammarOptions options;
  options.warnings = &warnings;
  read_grammar(text, options);
  Texts texts;
  for (const Diagnostic& warning : warnings) {
    EXPECT_EQ(warning.severity, Severity::warning);
    texts.push_back(warning.text());
  }
  return texts;
}

TEST(GrammarErrors, MatchesBrackets) {
  EXPECT_EQ(error_of("A -> F[+F"), "2:7: '[' is not closed; expected ']'");
  EXPECT_EQ(error_of("A > [B -> C"), "2:5: '[' is not closed; expected ']'");
  EXPECT_EQ(error_of("A > B] -> C"), "2:6: ']' closes no '['; expected '[' before it");
  EXPECT_EQ(error_of("[B] < A -> C"),
            "2:1: a bracket in the left context; expected modules on the way to the root; side branches are skipped");
  EXPECT_EQ(error_of("[ -> F"), "2:1: brackets cannot be rewritten; expected another predecessor");
  EXPECT_EQ(error_of("A -> [(1)]"), "2:6: '[' has 1 parameter; expected no parameters");
}

TEST(GrammarErrors, MatchesParentheses) {
  EXPECT_EQ(error_of("A(x) -> F(x"), "2:10: '(' is not closed; expected ')' after the parameters");
  EXPECT_EQ(error_of("A(x -> F"), "2:2: '(' is not closed; expected ')' after the parameters");
  EXPECT_EQ(error_of("A -> (3)"), "2:6: '(' follows no symbol; expected a symbol before its parameters");
  EXPECT_EQ(error_of("A -> F)"), "2:7: ')' closes no '('; expected a symbol");
}

TEST(GrammarErrors, RefusesWhatIsNoSymbol) {
  EXPECT_EQ(error_of("A -> B -> C"), "2:9: '>' is not a symbol; expected a symbol");
  EXPECT_EQ(error_of("A -> B:C"), "2:7: ':' is not a symbol; expected a symbol");
  EXPECT_EQ(error_of("A -> B\x07"), "2:7: control character 0x07 is not a symbol; expected a printable character");
}

TEST(GrammarErrors, FindsWhatARuleLacks) {
  EXPECT_EQ(error_of("-> B"), "2:1: no predecessor stands before the arrow; expected predecessor -> successor");
  EXPECT_EQ(error_of("A : -> B"), "2:4: nothing follows ':'; expected a condition, or a weight");
  EXPECT_EQ(error_of("A : x>1 : -> B"), "2:9: nothing follows ':'; expected a condition, or a weight");
  EXPECT_EQ(error_of("A < -> B"), "2:1: the rule has no predecessor; expected left < predecessor > right");
  EXPECT_EQ(error_of("< A -> B"), "2:1: nothing stands before '<'; expected left < predecessor > right");
  EXPECT_EQ(error_of("A > -> B"), "2:3: nothing follows '>'; expected left < predecessor > right");
  EXPECT_EQ(error_of("A < > B -> C"), "2:1: the rule has no predecessor; expected left < predecessor > right");
}

TEST(GrammarErrors, FindsWhatARuleHasTooMuchOf) {
  EXPECT_EQ(error_of("AB -> C"),
            "2:1: the predecessor 'AB' has several modules; expected one module; '#symbols' declares longer names");
  EXPECT_EQ(error_of("A : 1 : 2 : 3 -> B"),
            "2:11: one ':' too many; expected predecessor : condition : weight -> successor");
  EXPECT_EQ(error_of("A < B < C -> D"), "2:7: a second '<'; expected left < predecessor > right");
  EXPECT_EQ(error_of("A > B > C -> D"), "2:7: a second '>'; expected left < predecessor > right");
  EXPECT_EQ(error_of("A > B < C -> D"), "2:7: '<' stands behind '>'; expected left < predecessor > right");
}

TEST(GrammarErrors, NamesParameters) {
  EXPECT_EQ(error_of("A(x,x) -> B"), "2:5: 'x' names two parameters; expected another name");
  EXPECT_EQ(error_of("A(x) < B(x) -> C"), "2:10: 'x' names two parameters; expected another name");
  EXPECT_EQ(error_of("A(x+1) -> B"), "2:3: 'x+1' is not a name; expected a name for each parameter, such as x");
  EXPECT_EQ(error_of("A(e) -> B"), "2:3: 'e' is a function or constant of every expression; expected another name");
  EXPECT_EQ(error_of("A(,) -> B"), "2:1: a parameter of 'A(,)' has no name; expected a name for each, such as x");
  EXPECT_EQ(error_of("%(2) -> B"), "2:3: '2' is not a name; expected a name for each parameter, such as x");
}

TEST(GrammarErrors, FindsFaultsInExpressions) {
  EXPECT_EQ(error_of("A(x) -> F(len)"), "2:11: 'len' is not a known name; expected a variable or a constant");
  EXPECT_EQ(error_of("A(lenght) -> F(length)"),
            "2:16: 'length' is not a known name; expected a variable or a constant; did you mean 'lenght'?");
  EXPECT_EQ(error_of("A(x) -> F(sine(x))"), "2:11: 'sine' is not a function; expected a function; did you mean 'sin'?");
  EXPECT_EQ(error_of("A(x) -> F(x,)"), "2:13: the expression is empty; expected a number, a name or '('");
  EXPECT_EQ(error_of("A(x) : y>1 -> B"), "2:8: 'y' is not a known name; expected a variable or a constant");
  EXPECT_EQ(error_of("A(x) : x=1 = 2 -> B"),
            "2:12: comparisons cannot be chained; expected '&&' between two comparisons, or parentheses");
  EXPECT_EQ(error_of("A(x) : x=1 & x≥2 -> B"),
            "2:15: '≥' has no meaning here; expected numbers, names, operators and parentheses; did you mean '>='?");
}

TEST(GrammarErrors, RefusesNumbersThatAreNone) {
  EXPECT_EQ(error_of("A(x) -> F(1/0)"), "2:11: '1/0' has no finite value; expected a number");
  EXPECT_EQ(error_of("A : 1/0 -> B"), "2:5: '1/0' has no finite value; expected a number");
}

TEST(GrammarErrors, RefusesWeightsThatAreNotAboveZero) {
  EXPECT_EQ(error_of("A : 0 -> B"), "2:5: the weight '0' is not above 0; expected a number above 0");
  EXPECT_EQ(error_of("A : -1 -> B"), "2:5: the weight '-1' is not above 0; expected a number above 0");
  EXPECT_EQ(error_of("A : * : 0 -> B"), "2:9: the weight '0' is not above 0; expected a number above 0");
}

TEST(GrammarErrors, FindsFaultsInDirectives) {
  EXPECT_EQ(error_of("#rulse"),
            "2:1: '#rulse' is not a directive; expected a directive such as #rules; did you mean '#rules'?");
  EXPECT_EQ(error_of("#ignore ["), "2:9: contexts cannot ignore brackets; expected other symbols");
  EXPECT_EQ(error_of("#ignore +(1)"),
            "2:9: '+(1)' has parameters; expected a symbol alone; it is ignored with any number of parameters");
  EXPECT_EQ(error_of("#steps"), "2:7: the expression is empty; expected a number, a name or '('");
  EXPECT_EQ(error_of("#steps -1"), "2:8: '-1' is not a number of steps; expected a whole number from 0 to 1000000");
  EXPECT_EQ(error_of("#steps 1.5"), "2:8: '1.5' is not a number of steps; expected a whole number from 0 to 1000000");
  EXPECT_EQ(error_of("#steps five"), "2:8: 'five' is not a known name; expected a variable or a constant");
  EXPECT_EQ(error_of("#angle 1/0"), "2:8: '1/0' has no finite value; expected a number");
  EXPECT_EQ(error_of("#axiom B"), "2:1: a second axiom; the first is in line 1; expected one axiom");
}

TEST(GrammarErrors, FindsFaultsInDeclarations) {
  EXPECT_EQ(error_of("#define"), "2:1: '#define' lacks a name or a value; expected #define name = expression");
  EXPECT_EQ(error_of("#define x ="), "2:1: '#define' lacks a name or a value; expected #define name = expression");
  EXPECT_EQ(error_of("#define 2 = 1"), "2:9: '2' is not a name; expected letters, digits and _, no digit first");
  EXPECT_EQ(error_of("#define e = 1"), "2:9: 'e' is a function or constant of every expression; expected another name");
  EXPECT_EQ(error_of("#define x = y"), "2:13: 'y' is not a known name; expected a variable or a constant");
  EXPECT_EQ(error_of("#define x = ran(1)"), "2:13: 'ran(1)' is drawn at random; expected a constant");
  EXPECT_EQ(error_of("#symbols"), "2:1: '#symbols' declares no symbols; expected names of two characters or more");
  EXPECT_EQ(error_of("#symbols A"),
            "2:10: 'A' cannot be declared; expected a name of 2 to 64 letters, digits and _, no digit first");
  EXPECT_EQ(error_of("#symbols a-b"),
            "2:10: 'a-b' cannot be declared; expected a name of 2 to 64 letters, digits and _, no digit first");
}

TEST(GrammarErrors, FindsFaultsInInclusions) {
  EXPECT_EQ(error_of("#include a as"), "2:1: '#include a as' cannot be read; expected #include file as X for n steps");
  EXPECT_EQ(error_of("#include a as X for 5"),
            "2:1: '#include a as X for 5' cannot be read; expected #include file as X for n steps");
  EXPECT_EQ(error_of("#include a as [ for 3 steps"),
            "2:15: '[' cannot stand for a grammar; expected a symbol without parameters");
  EXPECT_EQ(error_of("#include a as X for -3 steps"),
            "2:1: this grammar cannot include others; expected a grammar that is read from a file");
  EXPECT_EQ(error_of("#include a as X for 3 steps"),
            "2:1: this grammar cannot include others; expected a grammar that is read from a file");
}

TEST(GrammarErrors, PlacesFilesThatAreNotThereAtTheirInclusion) {
  const TemporaryFolder folder;
  std::ofstream(folder / "fir.txt") << "#steps 1\nF\nF -> FF\n";
  std::filesystem::create_directory(folder / "more");
  std::ofstream(folder / "more/elm.txt") << "E(1)\nE(x) -> E(1/(x-1))\n";
  std::vector<std::string> paths;
  GrammarOptions options;
  options.file = folder / "plant.txt";
  options.read = read_beside(options.file, &paths);
  EXPECT_EQ(errors_of("X\n#include fir.txt as X\n", options), Texts{});
  EXPECT_EQ(paths, Texts{folder / "fir.txt"});
  const std::string at = options.file + ":2:1: ";
  EXPECT_EQ(errors_of("X\n#include firr.txt as X\n", options),
            Texts{at + "'firr.txt': there is no such file; did you mean 'fir.txt'?"});
  EXPECT_EQ(errors_of("X\n#include more/elf.txt as X\n", options),
            Texts{at + "'more/elf.txt': there is no such file; did you mean 'more/elm.txt'?"});
  EXPECT_EQ(errors_of("X\n#include more as X\n", options), Texts{at + "'more': this is a folder; expected a file"});
  EXPECT_EQ(errors_of("X\n#include more/elm.txt as X for 1 step\n", options),
            Texts{"more/elm.txt:2: '1/(x-1)' is not a finite number where 'E(x) -> E(1/(x-1))' is applied; expected a "
                  "condition "
                  "that leaves this case out (most likely a division by zero)"});
}

TEST(GrammarErrors, SeeksInclusionsBesideTheGrammarThatHasThem) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "more");
  std::ofstream(folder / "more/elm.txt") << "#steps 0\nE\n#include leaf.txt as E\n";
  std::ofstream(folder / "more/leaf.txt") << "#steps 0\nL\n";
  std::ofstream(folder / "leaf.txt") << "this is [ no grammar\n";
  std::vector<std::string> paths;
  GrammarOptions options;
  options.file = folder / "plant.txt";
  options.read = read_beside(options.file, &paths);
  EXPECT_EQ(errors_of("X\n#include more/elm.txt as X\n", options), Texts{});
  EXPECT_EQ(paths, (Texts{folder / "more/elm.txt", folder / "more/leaf.txt"}));
  std::ofstream(folder / "more/elm.txt") << "#steps 0\nE\n#include ../more/elm.txt as E\n";
  EXPECT_EQ(errors_of("X\n#include more/elm.txt as X\n", options),
            Texts{"more/elm.txt:3:1: 'more/elm.txt' includes itself; expected inclusions without a circle"});
}

TEST(GrammarErrors, FindsOverridesOfWhatIsNotDefined) {
  GrammarOptions options;
  options.file = "plant.txt";
  options.overrides = {{"lenght", 1}};
  EXPECT_EQ(errors_of("A(length)\nB(y)\n#define length 2\n", options),
            (Texts{"plant.txt: the grammar does not define 'lenght'; expected a name that it defines: length; did you "
                   "mean 'length'?",
                   "plant.txt:2:3: 'y' is not a known name; expected a variable or a constant"}));
  EXPECT_EQ(errors_of("A", options),
            Texts{"plant.txt: the grammar does not define 'lenght'; expected a grammar with #define lines"});
  options.overrides = {{"d2", 1}};
  EXPECT_EQ(errors_of("A\n#define d2 = 1/\n", options).size(), 1U) << "the name is known though its value is wrong";
  std::string many = "A\n";
  for (int k = 10; k < 30; ++k) many += fmt::format("#define c{} = {}\n", k, k);
  EXPECT_EQ(
      errors_of(many, options),
      Texts{"plant.txt: the grammar does not define 'd2'; expected a name that it defines: c10, c11, c12, c13, c14, "
            "c15, c16, c17, c18, c19, c20, c21, ..."});
}

TEST(GrammarErrors, MissesTheArrowOfARule) {
  EXPECT_EQ(errors_of("A\nA -> B\nB C\nB => C\n"),
            (Texts{"3:1: 'B C' has no arrow; expected predecessor -> successor",
                   "4:1: 'B => C' has no arrow; expected predecessor -> successor; did you mean '->'?"}));
  EXPECT_EQ(error_of("F: FF"), "2:1: 'F: FF' has no arrow; expected predecessor -> successor; did you mean '->'?");
  EXPECT_EQ(errors_of("F\n#rules\nF(l) = F(l*2)\nF: FF\n"),
            (Texts{"3:1: 'F(l) = F(l*2)' has no arrow; expected predecessor -> successor; did you mean '->'?",
                   "4:1: 'F: FF' has no arrow; expected predecessor -> successor; did you mean '->'?"}));
  EXPECT_EQ(error_of("F(l) : l > 2 F"), "2:1: 'F(l) : l > 2 F' has no arrow; expected predecessor -> successor");
}

TEST(GrammarErrors, MissesTheAxiom) {
  for (const char* text : {"", "A -> B", "; A", "#steps 5"}) {
    EXPECT_EQ(errors_of(text), Texts{"1:1: the grammar has no axiom; expected '#axiom' and a word"});
  }
  EXPECT_EQ(errors_of("\n #axiom\n#rules\n"), Texts{"2:2: the grammar has no axiom; expected '#axiom' and a word"});
}

TEST(GrammarErrors, WantsAConstantAxiom) {
  EXPECT_EQ(errors_of("A(x)"), Texts{"1:3: 'x' is not a known name; expected a variable or a constant"});
  EXPECT_EQ(errors_of("A(ran(1))"), Texts{"1:1: 'ran(1)' in the axiom is drawn at random; expected a constant"});
  EXPECT_EQ(errors_of("A[\nB\n"), Texts{"1:2: '[' is not closed; expected ']'"});
}

TEST(GrammarErrors, WantsTextInUtf8) {
  EXPECT_EQ(errors_of("A\xFF"), Texts{"1:2: byte 0xff is not UTF-8 text; expected text in UTF-8"});
  EXPECT_EQ(errors_of("\u00E9\n  \u00E9\xED\xA0\x80"),
            Texts{"2:4: byte 0xed is not UTF-8 text; expected text in UTF-8"});
  for (const char* text : {"A\xC3", "A\xC0\x80", "A\xE0\x80\x80", "A\xF0\x80\x80\x80", "A\xF4\x90\x80\x80", "A\x80"}) {
    EXPECT_EQ(errors_of(text).size(), 1U);
  }
}

TEST(GrammarErrors, WantsCommentsClosed) {
  EXPECT_EQ(errors_of("A\n /* B"), Texts{"2:2: the comment '/*' is not closed; expected '*/'"});
}

TEST(GrammarErrors, AreAllReportedInTheOrderOfTheText) {
  GrammarOptions options;
  options.file = "plant.txt";
  EXPECT_EQ(errors_of("A\n\nA(x) -> F(y)G(z)\n#define q = r\nA -> ]\n", options),
            (Texts{"plant.txt:3:11: 'y' is not a known name; expected a variable or a constant",
                   "plant.txt:3:15: 'z' is not a known name; expected a variable or a constant",
                   "plant.txt:4:13: 'r' is not a known name; expected a variable or a constant",
                   "plant.txt:5:6: ']' closes no '['; expected '[' before it"}));
}

TEST(GrammarErrors, CountCharactersAndNotBytes) {
  EXPECT_EQ(errors_of("\xEF\xBB\xBF\u00E9\u6728)"), Texts{"1:3: ')' closes no '('; expected a symbol"});
}

TEST(GrammarErrors, StopAtTheLimit) {
  std::string text = "A\n";
  for (int k = 0; k < 500; ++k) text += "A(x) -> A(y)A(z)\n";
  EXPECT_EQ(errors_of(text).size(), 100U);
  GrammarOptions options;
  options.limits.diagnostics = 3;
  EXPECT_EQ(errors_of(text, options).size(), 3U);
  options.limits.document_bytes = 10;
  EXPECT_EQ(errors_of(text, options),
            Texts{"1:1: the grammar has 8502 bytes; expected at most 10 (limit document_bytes)"});
}

TEST(GrammarErrors, BoundParametersAndLetters) {
  std::string many = "x0";
  for (int k = 1; k < 65; ++k) many += fmt::format(",x{}", k);
  EXPECT_EQ(error_of("A(" + many + ") -> A"), "2:249: the rule has more than 64 parameters; expected fewer");
  std::string zeros = "0";
  for (int k = 1; k < 65; ++k) zeros += ",0";
  EXPECT_EQ(error_of("A -> B(" + zeros + ")"), "2:6: 'B' has 65 parameters; expected at most 64");
  std::string letters;
  for (unsigned k = 0x10000; k < 0x10000 + 65'532; ++k) {
    for (const unsigned byte : {0xF0 | k >> 18, 0x80 | (k >> 12 & 63), 0x80 | (k >> 6 & 63), 0x80 | (k & 63)}) {
      letters += static_cast<char>(byte);
    }
  }
  const Texts errors = errors_of(letters);
  ASSERT_FALSE(errors.empty());
  EXPECT_EQ(errors.front(), "1:65532: the grammar has more than 65534 letters; expected fewer");
}

TEST(GrammarWarnings, NameRulesThatCanNeverMatch) {
  EXPECT_EQ(
      warnings_of("A\nB -> A\n#interpret\nA -> C\nC -> D\nE -> F\n"),
      (Texts{"2:1: this rule can never match: no word has 'B'", "6:1: this rule can never match: no word has 'E'"}));
  EXPECT_EQ(warnings_of("A(1)\nA -> B\n"), Texts{"2:1: this rule can never match: words have 'A' with another number "
                                                 "of parameters than 0; expected as many as 1"});
  EXPECT_EQ(warnings_of("A\nA -> B\nA -> C\nB : .5 -> A\nB : .5 -> B\n"),
            Texts{"3:1: this rule can never match: the one of line 2 is always taken first"});
  EXPECT_EQ(warnings_of("A\nQ < A > R -> B\n"),
            Texts{"2:1: this rule can never match: no word has 'Q' with 0 parameters"});
  EXPECT_EQ(warnings_of("#ignore F\nFA\nF < A -> G\n"),
            Texts{"3:1: this rule can never match: contexts do not see 'F', which is ignored"});
  EXPECT_EQ(warnings_of("A\nA : 1 > 2 -> B\n"), Texts{"2:5: the condition '1 > 2' is never true"});
}

}  // namespace meristem::grammar_errors_test
