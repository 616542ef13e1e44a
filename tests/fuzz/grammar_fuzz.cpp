// SPDX-License-Identifier: Apache-2.0
// Fuzzes grammars: either errors inside the text, or a consistent grammar. Its words after some steps must be drawn in
// both readings or be rejected with an error.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/grow/lsystem/derive.h"
#include "meristem/grow/lsystem/grammar_reader.h"
#include "meristem/grow/lsystem/turtle.h"
#include "tests/fuzz/require.h"

namespace {

using namespace meristem;

void require_letters_of(const Grammar& grammar, const std::vector<ModuleTemplate>& modules) {
  for (const ModuleTemplate& module : modules) {
    require(module.letter < grammar.alphabet.size());
    require(module.parameters.size() == grammar.alphabet[module.letter].arity);
  }
}

void require_sound_rules(const Grammar& grammar, const RuleSet& set) {
  require(set.of_letter.size() == grammar.alphabet.size());
  for (const GrammarRule& rule : set.rules) {
    require(rule.line > 0 && rule.predecessor < grammar.alphabet.size());
    require(rule.variable_count <= kMaxVariables);
    for (const auto* context : {&rule.left, &rule.right}) {
      for (const ContextModule& module : *context) {
        require(module.letter < grammar.alphabet.size());
        require(module.first_variable + grammar.alphabet[module.letter].arity <= rule.variable_count);
      }
    }
    require_letters_of(grammar, rule.successor);
  }
}

Word axiom_of(const Grammar& grammar) {
  Word word;
  for (const ModuleTemplate& module : grammar.axiom) {
    word.letters.push_back(module.letter);
    for (const Expression& parameter : module.parameters) word.parameters.push_back(parameter.evaluate());
  }
  return word;
}

/// Derives and draws words. The caller must check that all exceptions are InputErrors.
void derive_and_draw(const Grammar& grammar) {
  SizeLimits limits;
  limits.modules = 20'000;
  limits.nodes = 10'000;
  Progress progress;
  const Word word = derive(grammar, 3, RandomKey(1), limits, progress);
  const Word seen = interpreted(grammar, word, RandomKey(1), limits, progress);
  require(seen.module_count() <= limits.modules);
  for (const auto reading : {TurtleParameters::Reading::frame, TurtleParameters::Reading::polar}) {
    const TurtleParameters parameters{.reading = reading, .elasticity = 0.1};
    const WordDrawing drawing = draw(seen, grammar.alphabet, parameters, {}, limits, "components.plant", progress);
    const Skeleton& skeleton = drawing.skeleton;
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      require(skeleton.parent[node] == kNoNode || skeleton.parent[node] < node);
    }
    for (const TurtlePolygon& polygon : drawing.polygons) {
      require(polygon.first + polygon.count <= drawing.corners.size());
    }
    for (const TurtleSite& place : drawing.places) require(place.letter < grammar.alphabet.size());
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer requires this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::vector<Diagnostic> warnings;
  GrammarOptions options;
  options.file = "fuzz";
  options.constants = {{"age", 12}};
  options.warnings = &warnings;
  options.read = [](const std::string&) -> std::string { return "#steps 2\nA(1)\nA(x) -> A(x+1)B\n"; };
  try {
    const Grammar grammar = read_grammar(text, options);
    require(!grammar.axiom.empty() && grammar.is_ignored.size() == grammar.alphabet.size());
    require_letters_of(grammar, grammar.axiom);
    for (const auto* set : {&grammar.production, &grammar.decomposition, &grammar.interpretation}) {
      require_sound_rules(grammar, *set);
    }
    word_text(axiom_of(grammar), grammar.alphabet);
  } catch (const InputError& error) {
    require_errors_of(error, "fuzz");
    for (const Diagnostic& found : error.diagnostics()) {
      require(found.line > 0 && found.column > 0 && static_cast<std::size_t>(found.text_offset) <= size);
    }
    return 0;
  }
  try {
    derive_and_draw(read_grammar(text, options));
  } catch (const InputError& error) {
    require(!error.diagnostics().empty());
  }
  return 0;
}
