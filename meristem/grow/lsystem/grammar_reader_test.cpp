// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/grammar_reader.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace meristem::grammar_reader_test {

Word axiom_of(const Grammar& grammar) {
  Word word;
  for (const ModuleTemplate& module : grammar.axiom) {
    word.letters.push_back(module.letter);
    for (const Expression& parameter : module.parameters) word.parameters.push_back(parameter.evaluate());
  }
  return word;
}

std::string text_of(const std::vector<ModuleTemplate>& modules, const Alphabet& alphabet) {
  std::string text;
  for (const ModuleTemplate& module : modules) {
    text += alphabet[module.letter].symbol;
    for (std::size_t k = 0; k < module.parameters.size(); ++k) {
      text += (k == 0 ? "(" : ",") + module.parameters[k].text();
    }
    if (!module.parameters.empty()) text += ')';
  }
  return text;
}

std::string text_of(const std::vector<ContextModule>& modules, const Alphabet& alphabet) {
  std::string text;
  for (const ContextModule& module : modules) {
    const Letter& letter = alphabet[module.letter];
    text += letter.symbol;
    if (letter.arity > 0) text += fmt::format("({}+{})", module.first_variable, letter.arity);
  }
  return text;
}

/// Returns the parsed rule as text: "left < A/2 > right : condition : weight -> successor".
std::string rule_text(const Grammar& grammar, const GrammarRule& rule) {
  std::string text;
  if (!rule.left.empty()) text += text_of(rule.left, grammar.alphabet) + " < ";
  const Letter& letter = grammar.alphabet[rule.predecessor];
  text += letter.symbol;
  if (letter.arity > 0) text += fmt::format("/{}", letter.arity);
  if (!rule.right.empty()) text += " > " + text_of(rule.right, grammar.alphabet);
  if (rule.condition) text += " : " + rule.condition->text();
  if (rule.weight) text += " w " + rule.weight->text();
  return text + " -> " + text_of(rule.successor, grammar.alphabet);
}

std::vector<std::string> rule_texts(const Grammar& grammar) {
  std::vector<std::string> texts;
  for (const GrammarRule& rule : grammar.production.rules) texts.push_back(rule_text(grammar, rule));
  return texts;
}

using Texts = std::vector<std::string>;

/// Returns the parsed text of the only rule of a grammar with this line.
std::string read_rule(std::string_view line) {
  const Grammar grammar = read_grammar(fmt::format("#axiom\nA\n#rules\n{}\n", line));
  EXPECT_EQ(grammar.production.rules.size(), 1U) << line;
  return rule_text(grammar, grammar.production.rules.at(0));
}

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

// Whole grammars, as printed in publications.

TEST(GrammarReader, ReadsTheSpruce) {
  const Grammar grammar = read_grammar(R"(#axiom
P
#rules
P -> ^^^^FFFFM
M -> FFF[]AAAAAM
A → +++[&&&&&F[]F[]^F&[]O^^^^^^]
N → ^^&&&[]N
O -> [--F[]N++]++[F[]N]--&[]^&&[]N
)");
  EXPECT_EQ(word_text(axiom_of(grammar), grammar.alphabet), "P");
  EXPECT_EQ(rule_texts(grammar), (Texts{"P -> ^^^^FFFFM", "M -> FFF[]AAAAAM", "A -> +++[&&&&&F[]F[]^F&[]O^^^^^^]",
                                        "N -> ^^&&&[]N", "O -> [--F[]N++]++[F[]N]--&[]^&&[]N"}));
  const LetterIndex m = grammar.alphabet.find("M", 0);
  EXPECT_EQ(grammar.production.of_letter.at(m), std::vector<std::uint32_t>{1});
  EXPECT_EQ(grammar.production.of_letter.size(), grammar.alphabet.size());
  EXPECT_EQ(grammar.production.rules[1].line, 5);
}

TEST(GrammarReader, DropsTheIdentityRulesOfTheDichasium) {
  const char* const text =
      "#axiom\nA\n#rules\nA -> ^^FB\nB -> C+++C---\nC -> [^F&B]\nF -> F\n+ -> +\n- -> -\n"
      "[-> [\n] ->]\n^ -> ^\n& -> &\n";
  EXPECT_EQ(rule_texts(read_grammar(text)), (Texts{"A -> ^^FB", "B -> C+++C---", "C -> [^F&B]"}));
  EXPECT_EQ(warnings_of(text), Texts{});
}

TEST(GrammarReader, ReadsTheMonopodialTreeAsTheBookHasIt) {
  const Grammar grammar = read_grammar(R"(#steps 10
#define r1 0.9 /* contraction ratio for the trunk */
#define r2 0.6
#define a0 45
#define wr 0.707
#define d 137.5
ω : A(1,10)
p1 : A(l,w) : * → !(w)F(l)[&(a0)B(l*r2,w*wr)]/(d)A(l*r1,w*wr)
p2 : B(l,w) : * → !(w)F(l)[-(a0)$C(l*r2,w*wr)]C(l*r1,w*wr)
)");
  EXPECT_EQ(word_text(axiom_of(grammar), grammar.alphabet), "A(1,10)");
  EXPECT_EQ(rule_texts(grammar), (Texts{"A/2 -> !(w)F(l)[&(a0)B(l*r2,w*wr)]/(d)A(l*r1,w*wr)",
                                        "B/2 -> !(w)F(l)[-(a0)$C(l*r2,w*wr)]C(l*r1,w*wr)"}));
  const GrammarRule& rule = grammar.production.rules[0];
  const double values[] = {2, 10};
  EXPECT_EQ(rule.successor[4].parameters[1].evaluate(values), 10 * 0.707);
  EXPECT_EQ(grammar.steps, 10);
}

TEST(GrammarReader, ReadsSignalsInContexts) {
  const Grammar grammar = read_grammar(R"(#ignore: +-F
#axiom F1F1F1
#rules
0 < 0 > 0 -> 0
0 < 0 > 1 -> 1[+F1F1]
1<1>1-->0
+ -> -
- -> +
)");
  EXPECT_EQ(rule_texts(grammar),
            (Texts{"0 < 0 > 0 -> 0", "0 < 0 > 1 -> 1[+F1F1]", "1 < 1 > 1 -> 0", "+ -> -", "- -> +"}));
  for (const char* symbol : {"+", "-", "F"}) EXPECT_EQ(grammar.is_ignored[grammar.alphabet.find(symbol, 0)], 1);
  EXPECT_EQ(grammar.is_ignored[grammar.alphabet.find("1", 0)], 0);
}

TEST(GrammarReader, ReadsTheBushWithItsRunsOfSlashes) {
  const Grammar grammar = read_grammar(
      "#angle 45/2\n#axiom\nA\n#rules\nA -> [&FL!A]/////'[&FL!A]///////'[&FL!A]\nF → S ///// F\n"
      "L -> [''^^{-f+f+f-|-f+f+f}]\nS -> FL // a leaf\n");
  EXPECT_EQ(rule_texts(grammar), (Texts{"A -> [&FL!A]/////'[&FL!A]///////'[&FL!A]", "F -> S/////F",
                                        "L -> [''^^{-f+f+f-|-f+f+f}]", "S -> FL"}));
  EXPECT_EQ(grammar.angle, 22.5);
}

// Single rules.

TEST(GrammarReader, TellsConditionsFromWeights) {
  EXPECT_EQ(read_rule("A : .33 -> AA"), "A w .33 -> AA");
  EXPECT_EQ(read_rule("p1: A : 1/3 -> AA"), "A w 1/3 -> AA");
  EXPECT_EQ(read_rule("A(x) : x/2 -> A(x)"), "A/1 w x/2 -> A(x)");
  EXPECT_EQ(read_rule("A(x) : x > 2 -> A(x)"), "A/1 : x > 2 -> A(x)");
  EXPECT_EQ(read_rule("A(x) : x=0 & x<=3 | x!=1 : 2 -> A(x)"), "A/1 : x==0 && x<=3 || x!=1 w 2 -> A(x)");
  EXPECT_EQ(read_rule("A(x) : * : 0.5 -> B"), "A/1 w 0.5 -> B");
  EXPECT_EQ(read_rule("A(x) : x > 1 ? x : 0 -> B"), "A/1 : x > 1 ? x : 0 -> B");
  EXPECT_EQ(read_rule("A(x) : (x > 1 ? x : 0) : x -> B"), "A/1 : (x > 1 ? x : 0) w x -> B");
}

TEST(GrammarReader, NumbersTheVariablesOfContextsFromLeftToRight) {
  EXPECT_EQ(read_rule("B(u)C(v,w) < A(x) > [D(y)]E(z) : u<z -> A(u+v+w+x+y+z)"),
            "B(0+1)C(1+2) < A/1 > [D(4+1)]E(5+1) : u<z -> A(u+v+w+x+y+z)");
  EXPECT_EQ(read_rule("* < A > * -> B"), "A -> B");
  EXPECT_EQ(read_rule("A < - -> B"), "A < - -> B");
  EXPECT_EQ(read_rule("A < --> B"), "A < - -> B");
  EXPECT_EQ(read_rule("A > --> B"), "A > - -> B");
  EXPECT_EQ(read_rule("--> B"), "- -> B");
  EXPECT_EQ(read_rule("A--> B"), "A -> B");
}

TEST(GrammarReader, DeletesForAnEmptySuccessor) {
  EXPECT_EQ(read_rule("A ->"), "A -> ");
  EXPECT_EQ(read_rule("A -> ε"), "A -> ");
  EXPECT_EQ(read_rule("A -> /* nothing */"), "A -> ");
}

TEST(GrammarReader, TakesAnyPrintableCharacterForASymbol) {
  EXPECT_EQ(read_rule("Ä -> 木1?,;=\"#*é"), "Ä -> 木1?,;=\"#*é");
  EXPECT_EQ(read_rule("# (x) -> # ( x + (1) ) A()"), "#/1 -> #(x + (1))A");
}

TEST(GrammarReader, TakesTheLongestDeclaredName) {
  const Grammar grammar = read_grammar("#axiom LeafLeafyLea\n#rules\nLeaf : * -> L\n#symbols Leaf Leafy\n");
  std::vector<std::string> symbols;
  for (const ModuleTemplate& module : grammar.axiom) symbols.push_back(grammar.alphabet[module.letter].symbol);
  EXPECT_EQ(symbols, (Texts{"Leaf", "Leafy", "L", "e", "a"}));
  EXPECT_EQ(rule_texts(grammar), Texts{"Leaf -> L"});
}

TEST(GrammarReader, KeepsAnIdentityThatGuardsItsLetter) {
  EXPECT_EQ(rule_texts(read_grammar("F\nF -> F\nF -> FF\n")), (Texts{"F -> F", "F -> FF"}));
  EXPECT_EQ(rule_texts(read_grammar("F(1)\nF(x) -> F(x)\n")), Texts{});
  EXPECT_EQ(rule_texts(read_grammar("F(1)\nF(x) -> F(x+0)\n")), Texts{"F/1 -> F(x+0)"});
  EXPECT_EQ(rule_texts(read_grammar("F\nF : 2 -> F\n")), Texts{"F w 2 -> F"});
}

// The text around the rules.

TEST(GrammarReader, ReadsAnyLayoutOfTheSameGrammar) {
  const char* const layouts[] = {
      "F[+F]\nF -> FF\n",
      "#axiom F[+F]\n#rules\nF -> FF",
      "\xEF\xBB\xBF#axiom\r\nF[\r\n+F]\r\n\r\n#rules\r\nF -> \\\r\n FF",
      "; a comment\n// another\n#axiom F /* none */ [+F] // end\n#rules F -> F \\\n  F\n",
      "/* over\nlines */ axiom : F [ + F ]\n p1 : F→FF\n",
  };
  const Grammar first = read_grammar(layouts[0]);
  for (const char* layout : layouts) {
    const Grammar grammar = read_grammar(layout);
    EXPECT_EQ(word_text(axiom_of(grammar), grammar.alphabet), "F[+F]") << layout;
    EXPECT_EQ(rule_texts(grammar), rule_texts(first)) << layout;
  }
}

TEST(GrammarReader, ReadsABackslashAtTheEndAsASymbolUnlessABlankStandsBefore) {
  EXPECT_EQ(read_rule("A -> F\\"), "A -> F\\");
  EXPECT_EQ(read_rule("A -> F \\\n G"), "A -> FG");
}

TEST(GrammarReader, HasRulesOfThreeKinds) {
  const Grammar grammar = read_grammar("A\n#rules\nA -> AB\n#decompose\nB -> CC\n#interpret\nC -> F\nB -> G\n");
  EXPECT_EQ(grammar.production.rules.size(), 1U);
  EXPECT_EQ(grammar.decomposition.rules.size(), 1U);
  EXPECT_EQ(grammar.interpretation.rules.size(), 2U);
  EXPECT_EQ(grammar.interpretation.rules[1].line, 8);
}

TEST(GrammarReader, TakesTheCallersConstantsBeforeDefinitions) {
  GrammarOptions options;
  options.constants = {{"r", 3}, {"age", 7}};
  const Grammar grammar = read_grammar("#define r = 2\n#define q = r*age\nA(q)\n#steps r\n", options);
  EXPECT_EQ(word_text(axiom_of(grammar), grammar.alphabet), "A(21)");
  EXPECT_EQ(grammar.steps, 3);
}

TEST(GrammarReader, LetsADefinitionUseAndHideEarlierOnes) {
  const Grammar grammar = read_grammar("#define r = 2\n#define r = r*5\nA(r)\n");
  EXPECT_EQ(word_text(axiom_of(grammar), grammar.alphabet), "A(10)");
}

TEST(GrammarReader, OverridesTheValuesOfDefinitions) {
  GrammarOptions options;
  options.constants = {{"age", 7}};
  options.overrides = {{"r", 5}, {"n", 1}, {"n", 3}};
  const Grammar grammar = read_grammar("#define r = 2\n#define q = r*age\nA(q)\n#define n 8\n#steps n\n", options);
  EXPECT_EQ(word_text(axiom_of(grammar), grammar.alphabet), "A(35)");
  EXPECT_EQ(grammar.steps, 3) << "the last of two";
}

TEST(GrammarReader, LeavesIncludedGrammarsTheirDefinitions) {
  GrammarOptions options;
  options.file = "outer.txt";
  options.overrides = {{"r", 5}};
  options.read = [](const std::string&) -> std::string { return "#define r = 3\n#steps 0\nF(r)\n"; };
  const Grammar grammar = read_grammar("#define r = 2\nX(r)\n#include fir.txt as X\n", options);
  EXPECT_EQ(word_text(axiom_of(grammar), grammar.alphabet), "X(5)");
  EXPECT_EQ(rule_text(grammar, grammar.interpretation.rules.at(0)), "X -> F(3)");
}

TEST(GrammarReader, DrawsALetterAsAnIncludedGrammar) {
  GrammarOptions options;
  options.file = "outer.txt";
  options.read = [](const std::string& name) -> std::string {
    EXPECT_EQ(name, "a fir.txt");
    return "#steps 1\nF(1)T\nF(x) -> F(x*2)+F(x)\n#interpret\nT -> t\n";
  };
  for (const auto& [spelling, word] : std::vector<std::pair<std::string, std::string>>{
           {"#include \"a fir.txt\" as X for 2 steps", "F(4)+F(2)+F(2)+F(1)t"},
           {"#include \"a fir.txt\" as X", "F(2)+F(1)t"}}) {
    const Grammar grammar = read_grammar("XX\nX -> X+X\n" + spelling, options);
    ASSERT_EQ(grammar.interpretation.rules.size(), 1U);
    EXPECT_EQ(rule_text(grammar, grammar.interpretation.rules[0]), "X -> " + word);
  }
}

TEST(GrammarReader, RefusesInclusionsInACircle) {
  GrammarOptions options;
  options.file = "a.txt";
  options.read = [](const std::string& name) -> std::string {
    return name == "b.txt" ? "X\n#include a.txt as Y for 1 step\n" : "X\n#include b.txt as Y for 1 step\n";
  };
  EXPECT_EQ(errors_of("X\n#include b.txt as Y for 1 step", options),
            Texts{"b.txt:2:1: 'a.txt' includes itself; expected inclusions without a circle"});
  options.read = [](const std::string&) -> std::string { return "X\nX -> [\n"; };
  EXPECT_EQ(errors_of("F\n#include c.txt as Y for 1 step", options),
            Texts{"c.txt:2:6: '[' is not closed; expected ']'"});
  options.read = [](const std::string&) -> std::string { return "X\nX -> XX\n"; };
  EXPECT_EQ(errors_of("F\n#include c.txt as X for 1 step", options),
            Texts{"a.txt:2:1: the word of 'c.txt' has the letter that stands for it; expected another letter"});
  EXPECT_EQ(errors_of("F\n#include c.txt as Y", options),
            Texts{"a.txt:2:1: 'c.txt' has no #steps; expected #include file as X for n steps"});
}

RC_GTEST_PROP(GrammarReader, ReadsTheTextOfAWordBackAsTheWord, (const std::vector<std::pair<int, double>>& modules)) {
  const char* const kSymbols[] = {"A", "b", "0", "+", "é", "Leaf", "Le", "a", "f", "%", "^"};
  Grammar written;
  Word word;
  for (const auto& [choice, number] : modules) {
    const auto kind = static_cast<unsigned>(choice);
    const bool has_parameter = kind % 3 == 0 && kind % 11 != 9;
    word.letters.push_back(written.alphabet.add(kSymbols[kind % 11], has_parameter ? 1 : 0));
    if (has_parameter) word.parameters.push_back(number);
  }
  RC_PRE(!modules.empty());
  const std::string text = word_text(word, written.alphabet);
  // Declare names in the word's own order, because word_text only separates names of its own alphabet.
  std::string names;
  for (const char* name : {"Leaf", "Le"}) {
    for (const int arity : {0, 1}) {
      if (written.alphabet.find(name, static_cast<std::uint16_t>(arity)) != kNoLetter) {
        names = names + "#symbols " + name + "\n";
      }
    }
  }
  const Grammar read = read_grammar(names + "#axiom " + text);
  const Word back = axiom_of(read);
  RC_ASSERT(word_text(back, read.alphabet) == text);
  RC_ASSERT(back.module_count() == word.module_count());
  RC_ASSERT(back.parameters == word.parameters);
}

RC_GTEST_PROP(GrammarReader, FindsFaultsInAnyTextOrReadsIt, ()) {
  static const std::vector<std::string> kPieces = {
      "A",  "B",   "F",    "[",      "]",       "(",        ")",          "<",          ">",        ":",        ",",
      "->", "→",   "\n",   "\n",     " ",       "*",        "/",          "//",         "/*",       "*/",       "\\\n",
      "x",  "1.5", "x>1",  "ran(x)", "(x,y)",   "#axiom",   "\n#rules\n", "\n#ignore ", "#steps ",  "\n#angle", "ε",
      "%",  "\r",  "\xFF", "é",      "#define", "#symbols", "Leaf",       "#include",   "as X for", "= 2",      "?"};
  const auto choices = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, kPieces.size()));
  std::string text;
  for (const std::size_t choice : choices) text += kPieces[choice];
  try {
    const Grammar grammar = read_grammar(text);
    RC_ASSERT(!grammar.axiom.empty());
    RC_ASSERT(grammar.is_ignored.size() == grammar.alphabet.size());
    RC_ASSERT(grammar.production.of_letter.size() == grammar.alphabet.size());
  } catch (const InputError& error) {
    RC_ASSERT(!error.diagnostics().empty());
    for (const Diagnostic& found : error.diagnostics()) {
      RC_ASSERT(found.line >= 1);
      RC_ASSERT(found.column >= 1);
      RC_ASSERT(found.text_offset >= 0);
      RC_ASSERT(static_cast<std::size_t>(found.text_offset) <= text.size());
      RC_ASSERT(!found.message.empty());
    }
  }
}

}  // namespace meristem::grammar_reader_test
