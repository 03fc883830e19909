#pragma once

/// The boundary between the library's face (morskin.h) and what is behind it: values of either side
/// in terms of the other, and errors.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "certify/certificate.h"
#include "geometry/error.h"
#include "geometry/indexed_mesh.h"
#include "geometry/point.h"
#include "geometry/run.h"
#include "morse/choose_function.h"
#include "morskin/method.h"
#include "morskin/morskin.h"
#include "morskin/prepared_skin.h"
#include "skin/model.h"
#include "skin/molecule.h"
#include "skin/singular_skin.h"

namespace morskin {

struct Skin::Prepared {
  PreparedSkin skin;
  std::size_t rounded_coordinates;
  SkinOptions options;
};

inline std::vector<std::uint32_t> outside(const std::vector<geometry::AtomId>& ids) {
  std::vector<std::uint32_t> numbers;
  for (const geometry::AtomId id : ids) numbers.push_back(id.value);
  return numbers;
}

/// Does a piece of work; what the library throws comes out as an Error.
template <class Work>
auto with_errors(Work work) {
  using Kind = Error::Kind;
  try {
    return work();
  } catch (const skin::SingularSkin& error) {
    throw Error(Kind::Singular, error.what(), outside(error.atoms));
  } catch (const UnresolvedNeck& error) {
    throw Error(Kind::Refused, error.what(), outside(error.atoms));
  } catch (const ScalesTooFarApart& error) {
    const bool is_one = error.small == error.largest;
    throw Error(Kind::Refused, error.what(),
                is_one ? outside({error.small}) : outside({error.small, error.largest}));
  } catch (const morse::DegenerateFunction& error) {
    throw Error(Kind::Degenerate, error.what());
  } catch (const geometry::RefusedInput& error) {
    throw Error(Kind::Refused, error.what());
  } catch (const geometry::UnreadableInput& error) {
    throw Error(Kind::Unreadable, error.what());
  } catch (const geometry::UnwritableOutput& error) {
    throw Error(Kind::Unwritable, error.what());
  } catch (const geometry::LimitReached& error) {
    throw Error(Kind::Limit, error.what());
  } catch (const geometry::Stopped& error) {
    throw Error(Kind::Stopped, error.what());
  }
}

inline geometry::Point inside(const Point& p) { return {p[0], p[1], p[2]}; }
inline Point outside(const geometry::Point& p) { return {p.x(), p.y(), p.z()}; }

inline Run inside(const RunOptions& run) { return Run(run.threads, run.progress, run.stop); }

/// @throws geometry::RefusedInput  for a number that is none of them
skin::Model inside(Model model);
/// @throws geometry::RefusedInput  for a corner that does not exist
geometry::IndexedMesh inside(const TriangleMesh& mesh);
/// @throws geometry::RefusedInput  for more than one limit of the sizes of triangles
MeshingOptions inside(const MeshOptions& options);
Certificate outside(const certify::Certificate& certificate);

/// The molecule in a file. @throws geometry::RefusedInput  also where it gives weights, not radii
skin::Molecule read_with_radii(const std::filesystem::path& file, const ReadOptions& options);
std::vector<Atom> atoms_of(const skin::Molecule& molecule);
/// By reason, in the report's words.
std::vector<std::pair<std::string, std::size_t>> left_out(const skin::ReadingCounts& counts);

}  // namespace morskin
