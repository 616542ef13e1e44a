// SPDX-License-Identifier: Apache-2.0
// Grammars (L-systems) and their derived words.
#include "meristem/grow/lsystem/word.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "call.h"
#include "document.h"
#include "meristem/base/read_file.h"
#include "meristem/grow/lsystem/derive.h"
#include "meristem/grow/lsystem/grammar_reader.h"
#include "values.h"

namespace meristem::python {

namespace {

/// A word and its alphabet.
struct WordInPython {
  Word word;
  Alphabet alphabet;
};
using WordPointer = std::shared_ptr<WordInPython>;

/// A grammar's text, or the path of its file.
struct GrammarSource {
  std::optional<std::string> text;
  std::string file = kFromPython;
};

GrammarSource source_of(const py::object& grammar) {
  if (py::isinstance<py::str>(grammar)) return {.text = grammar.cast<std::string>()};
  if (!py::hasattr(grammar, "__fspath__")) throw py::type_error("grammar must be a text (str) or a path (os.PathLike)");
  return {.file = path_of(grammar)};
}

std::vector<ExpressionNames::Constant> constants_of(const py::object& constants) {
  std::vector<ExpressionNames::Constant> values;
  if (constants.is_none()) return values;
  const Value mapping = to_value(constants);
  if (mapping.object() == nullptr) throw py::type_error("constants must be a dict such as {'angle': 22.5}");
  for (const auto& [name, value] : *mapping.object()) {
    if (value.number() == nullptr) throw py::type_error(fmt::format("constants['{}'] must be a number", name));
    values.push_back({name, *value.number()});
  }
  return values;
}

Grammar read(const GrammarSource& source, GrammarOptions options) {
  options.file = source.file;
  if (source.text) return read_grammar(*source.text, options);
  options.read = read_beside(source.file);
  return read_grammar(read_file(source.file, options.limits.document_bytes), options);
}

/// The number of steps, or the time of a grammar whose rules have lives.
double steps_of(std::optional<int> steps, std::optional<double> time, const Grammar& grammar, const std::string& file) {
  const auto fail = [&](std::string message, std::string expected) {
    throw InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected), .file = file});
  };
  if (grammar.is_timed) {
    if (steps) fail("the rules of the grammar have lives, so it counts no steps", "the argument time");
    if (!time && !grammar.time) fail("the grammar does not give its time", "'#time T' in it, or the argument time");
    return time ? *time : *grammar.time;
  }
  if (time) fail("no rule of the grammar has a life, so it knows no time", "the argument steps");
  if (steps) return *steps;
  if (grammar.steps) return *grammar.steps;
  fail("the grammar does not give the number of steps", "'#steps N' in it, or the argument steps");
  return 0;
}

WordPointer derive_word(const py::object& grammar, std::optional<int> steps, std::optional<double> time,
                        const py::object& seed, const py::object& constants, bool drawn, int threads,
                        const py::object& progress) {
  if (time && !(*time >= 0 && *time <= 1e6)) throw py::value_error("time must be from 0 to 1000000");
  if (steps && (*steps < 0 || *steps > kMaxSteps)) {
    throw py::value_error(fmt::format("steps must be from 0 to {}", kMaxSteps));
  }
  const GrammarSource source = source_of(grammar);
  const RandomKey key(seed_of(seed));
  GrammarOptions options;
  options.overrides = constants_of(constants);
  std::vector<Diagnostic> warnings;
  options.warnings = &warnings;
  WordPointer result = run_call(progress, threads, [&](Progress& inner) {
    const Grammar read_one = read(source, options);
    const double count = steps_of(steps, time, read_one, source.file);
    Word word = drawn ? derive_drawn(read_one, count, key, options.limits, inner)
                      : derive(read_one, count, key, options.limits, inner);
    return std::make_shared<WordInPython>(WordInPython{std::move(word), read_one.alphabet});
  });
  for (const Diagnostic& warning : warnings) {
    if (PyErr_WarnEx(PyExc_UserWarning, warning.text().c_str(), 1) != 0) throw py::error_already_set();
  }
  return result;
}

template <class T>
py::array_t<T> column_of(const WordPointer& word, const WordColumn<T>& column) {
  return view(word, column.data(), {static_cast<py::ssize_t>(column.size())}, {sizeof(T)});
}

std::string text_of_word(const WordPointer& word) {
  const py::gil_scoped_release release;
  return word_text(word->word, word->alphabet);
}

py::list alphabet_of(const WordPointer& word) {
  py::list letters;
  for (std::size_t k = 0; k < word->alphabet.size(); ++k) {
    const Letter& letter = word->alphabet[static_cast<LetterIndex>(k)];
    letters.append(py::make_tuple(letter.symbol, letter.arity));
  }
  return letters;
}

py::dict counts_of(const WordPointer& word) {
  std::vector<SymbolCount> counts;
  {
    const py::gil_scoped_release release;
    counts = symbol_counts(word->word, word->alphabet);
  }
  py::dict dict;
  for (const auto& [symbol, count] : counts) dict[py::str(symbol)] = count;
  return dict;
}

bool are_equal(const WordPointer& word, const py::object& other) {
  if (!py::isinstance<WordInPython>(other)) return false;
  const auto second = other.cast<WordPointer>();
  const py::gil_scoped_release release;
  const auto& ours = word->word.letters;
  const auto& theirs = second->word.letters;
  // Alphabets of different grammars may have the same letters in another order.
  std::vector<LetterIndex> as_theirs;
  for (std::size_t k = 0; k < word->alphabet.size(); ++k) {
    const Letter& letter = word->alphabet[static_cast<LetterIndex>(k)];
    as_theirs.push_back(second->alphabet.find(letter.symbol, letter.arity));
  }
  const auto is_same = [&](LetterIndex a, LetterIndex b) { return as_theirs[a] == b; };
  return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(), is_same) &&
         word->word.parameters == second->word.parameters;
}

}  // namespace

void bind_word(py::module_& module) {
  py::class_<WordInPython, WordPointer>(module, "Word",
                                        R"(The derived word of a grammar: modules, each a letter and its parameters.

str(word) is its text. Two words are equal if they have equal symbols and parameters, even from different grammars.

    word = meristem.derive("#axiom A\n#rules\nA -> F[+A]A", 2)
    assert str(word) == "F[+F[+A]A]F[+A]A")")
      .def("__len__", [](const WordPointer& w) { return w->word.module_count(); })
      .def("__str__", &text_of_word,
           "Its text, such as 'A(1,0.5)[+B]'. Numbers have the fewest digits that identify them.")
      .def("__repr__",
           [](const WordPointer& w) { return fmt::format("<meristem.Word of {} modules>", w->word.module_count()); })
      .def("__eq__", &are_equal, py::arg("other"), "True if both words have equal symbols and parameters.")
      .def_property_readonly(
          "letters", [](const WordPointer& w) { return column_of(w, w->word.letters); },
          "(n,): each module's letter, an index into `alphabet`.")
      .def_property_readonly(
          "parameters", [](const WordPointer& w) { return column_of(w, w->word.parameters); },
          "(m,): the parameters of all modules one after another. Each module has the number of parameters of its "
          "letter.")
      .def_property_readonly(
          "alphabet", &alphabet_of,
          "The grammar's letters: a list of (symbol, number of parameters). F and F(1) are two letters.")
      .def_property_readonly("counts", &counts_of,
                             "Returns the number of modules of each symbol, with any number of parameters. Only "
                             "symbols that occur are included.");
  refuse_new<WordInPython>("derive() makes words");

  module.def("derive", &derive_word, py::arg("grammar"), py::arg("steps") = py::none(), py::kw_only(),
             py::arg("time") = py::none(), py::arg("seed") = 1, py::arg("constants") = py::none(),
             py::arg("drawn") = false, py::arg("threads") = 0, py::arg("progress") = py::none(),
             R"(Derives the word of a grammar, an L-system. Returns a Word, which is equal on any number of threads.

`grammar` is its text (str), or the path of a file (os.PathLike). Included files are searched beside this file. `steps`
(0 to 1,000,000) is by default the grammar's own #steps. A grammar whose rules have lives has a `time` instead. `seed`
(0 to 2^53) determines the random choices. `constants` gives names of its #define lines other values: {"angle": 22.5}.
`drawn` also applies the rules of #interpret, as drawing does.

Rules that can never match cause a UserWarning. Raises InputError with all faults, each with line and column, also if
numbers are not finite or the word exceeds 200 million modules. Raises MachineError if the file cannot be read, and
Cancelled.)");
}

}  // namespace meristem::python
