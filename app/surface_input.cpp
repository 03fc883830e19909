#include "app/surface_input.h"

#include <cmath>
#include <map>
#include <vector>

#include "app/molecule_input.h"
#include "app/report_lines.h"
#include "app/sha256.h"
#include "geometry/error.h"
#include "geometry/files/text_lines.h"
#include "implicit/expression.h"
#include "implicit/gaussians.h"
#include "implicit/known_surfaces.h"

namespace morskin::app {
namespace {

/// "NAME:first,second,key=value".
struct Words {
  std::string name, first;
  std::vector<std::string> others;             ///< without "="
  std::map<std::string, std::string> options;  ///< by key
};

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw UsageError("--surface " + text + ": " + why);
}

Words words_of(const std::string& text) {
  const std::size_t colon = text.find(':');
  Words words{text.substr(0, colon), {}, {}, {}};
  if (colon == std::string::npos) return words;
  std::string rest = text.substr(colon + 1) + ",";
  for (bool is_first = true; !rest.empty(); is_first = false) {
    const std::string word = rest.substr(0, rest.find(','));
    rest.erase(0, word.size() + 1);
    const std::size_t equals = word.find('=');
    if (is_first) {
      words.first = word;
    } else if (equals == std::string::npos) {
      words.others.push_back(word);
    } else if (!words.options.emplace(word.substr(0, equals), word.substr(equals + 1)).second) {
      refuse(text, word.substr(0, equals) + "= is given twice");
    }
  }
  return words;
}

double number(const std::string& text, const std::string& word) {
  const std::optional<double> value = geometry::parse_double(word);
  if (!value) refuse(text, "\"" + word + "\" is no number");
  return *value;
}

/// The value of an option, which is used up.
std::optional<double> take(Words& words, const std::string& text, const std::string& key) {
  const auto found = words.options.find(key);
  if (found == words.options.end()) return std::nullopt;
  const double value = number(text, found->second);
  words.options.erase(found);
  return value;
}

void require_count(const Words& words, const std::string& text, std::size_t others) {
  if (words.others.size() != others) {
    refuse(text, "it takes " + counted(others + 1, "value", "values") + " and options key=value");
  }
}

SurfaceInput of_formula(const std::string& formula, const std::optional<double>& within,
                        const std::string& text) {
  return {std::make_shared<implicit::Expression>(formula),
          {{implicit::Point::Zero(), within.value_or(1)}, within.has_value()},
          sha256_of(text)};
}

SurfaceInput of_gaussians(Words& words, const std::string& text) {
  implicit::GaussianOptions options;
  options.decay = take(words, text, "decay").value_or(options.decay);
  options.level = take(words, text, "level").value_or(options.level);
  MoleculeArguments molecule;
  molecule.input = words.first;
  const MoleculeInput read = read_input(molecule);
  std::vector<implicit::Ball> balls;
  for (const skin::Atom& atom : read.molecule.atoms) balls.push_back({atom.position, atom.radius});
  const auto gaussians = std::make_shared<implicit::Gaussians>(std::move(balls), options);
  return {gaussians, {gaussians->extent(), false}, read.sha256};
}

}  // namespace

SurfaceInput read_surface(const std::string& text) {
  Words words = words_of(text);
  SurfaceInput input;
  if (words.name == "sphere") {
    require_count(words, text, 0);
    input = of_formula(implicit::sphere_formula(number(text, words.first)), {}, text);
  } else if (words.name == "torus") {
    require_count(words, text, 1);
    input = of_formula(
        implicit::torus_formula(number(text, words.first), number(text, words.others[0])), {},
        text);
  } else if (words.name == "genus2") {
    if (text != words.name) refuse(text, "genus2 takes no values");
    input = of_formula(implicit::genus2_formula(), {}, text);
  } else if (words.name == "formula") {
    require_count(words, text, 0);
    const std::optional<double> within = take(words, text, "within");
    if (within &&
        !(*within > 0 && *within <= 4096 && std::exp2(std::round(std::log2(*within))) == *within)) {
      refuse(text, "within= takes a power of two up to 4096");
    }
    input = of_formula(words.first, within, text);
  } else if (words.name == "gaussian") {
    if (!words.others.empty()) {
      refuse(text, "it takes one molecule, whose name has no comma, and options key=value");
    }
    input = of_gaussians(words, text);
  } else {
    refuse(text,
           "it must be sphere:R, torus:R,r, genus2, formula:EXPRESSION[,within=W] or "
           "gaussian:MOLECULE[,decay=D][,level=L]");
  }
  if (!words.options.empty()) refuse(text, "unknown option " + words.options.begin()->first + "=");
  return input;
}

std::optional<std::filesystem::path> molecule_of_surface(const std::string& text) {
  const Words words = words_of(text);
  const bool has_one = words.name == "gaussian" && words.others.empty();
  return has_one ? std::optional<std::filesystem::path>(words.first) : std::nullopt;
}

implicit::PreparedSurface prepare_surface(const SurfaceInput& input,
                                          const std::optional<implicit::Vector>& height,
                                          const geometry::Run& run) {
  try {
    return implicit::prepare_surface(input.function, input.space, height, run);
  } catch (const implicit::SingularLevel& error) {
    const auto* gaussians = dynamic_cast<const implicit::Gaussians*>(input.function.get());
    if (gaussians == nullptr) throw;
    throw geometry::RefusedInput(std::string(error.what()) + "; the sum of the Gaussians is " +
                                 brief(gaussians->sum_at(error.critical_value), 9) +
                                 " there, the level " + brief(gaussians->sum_at(0), 9));
  }
}

}  // namespace morskin::app
